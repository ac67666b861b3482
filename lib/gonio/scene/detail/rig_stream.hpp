// The JSON of a rig as a stream of values: each light as soon as it is complete, and each other member of the rig.
#pragma once

#include <gonio/base/codes/rig.hpp>
#include <gonio/base/json.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace gonio::detail {

struct RigSink {
    std::function<Result<void>(std::size_t index, const Json& light)> light;
    std::function<Result<void>(const std::string& key, const Json& value)> member;
    // If given, reads the array "lights" from its opening bracket on, and returns the offset of the closing one:
    // light() is not called then.
    std::function<Result<std::size_t>(std::size_t bracket)> lights = {};
};

// "rig.json: lights[3].shape: message" as an error (malformed); `path` may be empty.
Unexpected rig_error(RigCode code, const std::string& source, std::string_view path, std::string message,
                     std::string hint = {});

// The same for a value; placed() adds its path and file in front.
Unexpected rig_value_error(RigCode code, std::string message, std::string hint = {});

// The reason of an error with the place in the rig in front; a profile's own place stays in the sentence. Misuse on a
// command line counts as malformed in a file and gets the rig's code for it; other codes are kept.
Unexpected placed(const Error& error, const std::string& source, std::string_view path);

// Passes the values on in the order of the text; stops at the first failure, including the sink's own, which gets the
// line and column of the value that its path names. Values are dropped when the sink returns: memory does not grow with
// the text. A rig is flat: text beyond the limits rig-depth,
// rig-values and rig-lights was not written as a rig. A key that is given twice is malformed. `lights` is required; the
// sink's member() is not called for it.
Result<void> stream_rig(std::string_view text, const std::string& source, const RigSink& sink);

} // namespace gonio::detail
