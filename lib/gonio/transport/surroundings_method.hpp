// How the light of a sky and of the lit stage reaches surfaces: exactly, or as engines do it.
#pragma once

#include <gonio/base/result.hpp>

#include <cstdint>
#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// How the light that comes from around a surface is computed.
enum class SurroundingsMethod : std::uint8_t {
    exact,               // past all that stands on the stage; glossy surfaces see stage and sky along their lobes
    spherical_harmonics, // the illuminance of the open sky by bands l ≤ 2
    split_sum,           // B. Karis, 2013: the open sky, prefiltered about the mirrored direction, and Unreal's table
    dominant_direction,  // S. Lagarde and C. de Rousiers, 2014: about a direction that leans to the normal
    prefiltered,         // as split_sum, with the exact albedo of the material
    parallax_box,        // glossy surfaces see a picture taken at one point of the stage, on a box (Lagarde and
                         // Zanuttini, 2012)
    parallax_sphere      // the same on a sphere
};

// A method by its name in text.
struct SurroundingsMethodInfo {
    std::string_view name; // "split-sum"
    SurroundingsMethod method;
    std::string_view summary;
};

// All except `exact`, which is a method for everything.
std::span<const SurroundingsMethodInfo> surroundings_methods();
std::string_view to_text(SurroundingsMethod method);

// Whether it looks up what a sky alone would give an open surface.
bool is_of_open_sky(SurroundingsMethod method);
// Whether it needs a LocalProbe.
bool has_local_probe(SurroundingsMethod method);

} // namespace gonio
#pragma GCC visibility pop
