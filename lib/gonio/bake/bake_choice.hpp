// What to bake, as the modules for Python and JavaScript are asked for it: by names. Internal.
#pragma once

#include <gonio/bake/bake.hpp>
#include <gonio/base/result.hpp>

#include <optional>
#include <string>

namespace gonio {

struct BakeChoice {
    std::optional<std::string> layout; // latlong, unless there is an engine
    std::optional<std::string> engine; // which sets the layout and the rest
    std::optional<int> width;          // the usual size of the layout, or the engine's
    std::optional<int> height;
    std::optional<std::string> normalization;
    std::optional<std::string> texel_type; // "float32", "half", "uint16", "uint8"
    std::optional<double> cone_deg;
    std::optional<int> border;
};

// Fails (usage) on unknown names and on choices that exclude each other.
Result<BakeOptions> bake_options(const BakeChoice& choice);

} // namespace gonio
