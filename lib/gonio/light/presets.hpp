// Everyday sources as values and shapes, to start from and to compare with.
#pragma once

#include <gonio/base/result.hpp>

#include <span>
#include <string_view>

namespace gonio {

struct LightPreset {
    std::string_view name;   // "incandescent-60"
    std::string_view value;  // "800lm", as parse_photometric_value() takes it
    std::string_view shape;  // "sphere:r=3cm", as parse_shape() takes it
    std::string_view says;   // what it is
    std::string_view source; // where the figure is from
};

std::span<const LightPreset> light_presets();

// Fails (usage) on an unknown name and suggests the nearest.
Result<const LightPreset*> find_preset(std::string_view name);

} // namespace gonio
