// Which level of a prefiltered environment holds which roughness. Levels count from 0, the sharpest, to `last`.
//
// Roughness is linear: α = r². The engines' formulas, with last = the number of levels − 1:
//
//   linear     level = r·last
//   filament   level = r(2 − r)·last (Filament's shaders)
//   frostbite  level = √r·last (S. Lagarde and C. de Rousiers, 2014, listing 63)
//   ue4        level = last − 1 − (1 − 1.2 log2 r): Unreal Engine's reflection captures. Roughness 1 is in the level of
//              4×4 texels of a whole chain; level 0 is not a mirror but 2^((1 − (last − 1))/1.2)
#pragma once

#include <gonio/base/result.hpp>

#include <cstdint>
#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// Which level of a prefiltered environment has which roughness.
enum class RoughnessMapping : std::uint8_t { linear, filament, frostbite, ue4 };

// A mapping by its name in text.
struct RoughnessMappingInfo {
    std::string_view name; // "linear"
    RoughnessMapping mapping;
    std::string_view formula; // "level = roughness * last"
};

// All of them, and the one of a mapping.
std::span<const RoughnessMappingInfo> roughness_mappings();
const RoughnessMappingInfo& info_of(RoughnessMapping mapping);

// Fails (usage) on an unknown name.
Result<RoughnessMapping> parse_roughness_mapping(std::string_view text);

// Within [0, last], for roughness in [0, 1]; last ≥ 0.
double level_of(RoughnessMapping mapping, double roughness, int last);

// Within [0, 1]: levels that the formula gives a greater roughness hold 1.
double roughness_of(RoughnessMapping mapping, double level, int last);

} // namespace gonio
#pragma GCC visibility pop
