// The quality of light in words and tables, and as JSON: `gonio cct --quality`, `gonio info --figures`.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/color/light_quality.hpp>

#include "../json_text.hpp"

#include <optional>
#include <string>

namespace gonio::cli {

// With so many decimals, and no minus sign on a zero.
std::string fixed(double value, int decimals);

// With a newline at the end of each line. Equivalent daylight illuminances are those of `illuminance`, or of 100 lx.
std::string quality_text(const LightQuality& quality, std::optional<Lux> illuminance = std::nullopt);

// `illuminance_lx` and the equivalent daylight illuminances are there if an illuminance is given.
Json quality_json(const LightQuality& quality, std::optional<Lux> illuminance = std::nullopt);

} // namespace gonio::cli
