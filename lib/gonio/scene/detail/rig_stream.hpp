// The JSON of a rig as a stream of values: each light when it is complete, and each other member of the rig.
#pragma once

#include <gonio/base/codes/rig.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace gonio::detail {

using RigJson = OrderedJson;

struct RigSink {
    std::function<Result<void>(std::size_t index, const RigJson& light)> light;
    std::function<Result<void>(const std::string& key, const RigJson& value)> member;
};

// "rig.json: lights[3].shape: message" as an error (malformed); `path` may be empty.
Unexpected rig_error(RigCode code, const std::string& source, std::string_view path, std::string message,
                     std::string hint = {});

// The same of a value, whose path and file are put in front by placed().
Unexpected rig_value_error(RigCode code, std::string message, std::string hint = {});

// The reason of an error with the place in the rig in front; a profile's own place stays in the sentence. What is a
// misuse on a command line is malformed in a file, and has the rig's code for it; other codes are kept.
Unexpected placed(const Error& error, const std::string& source, std::string_view path);

// Hands the values over in the order of the text; stops at the first failure, the sink's own included. Values at hand
// are dropped when the sink returns: memory does not grow with the text. A rig is flat: what is beyond the limits
// rig-depth, rig-values and rig-lights was not written for one. A key that is given twice is malformed.
// `lights` is required; the sink's member() is not called for it.
Result<void> stream_rig(std::string_view text, const std::string& source, const RigSink& sink);

} // namespace gonio::detail
