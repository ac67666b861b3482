// The invertible tone curve of Unreal Engine 3 (as fitted to its filmic curve), and its inverse.
//
// y = 1.0275 x / (x + 0.22) maps exposed linear light, 1 = the display's white of a picture without tone mapping, to a
// display-encoded value: it combines exposure curve and encoding, so no sRGB curve follows. 0 stays 0, x = 8 is white
// and the curve ends at 1.0275. The inverse x = 0.22 y / (1.0275 − y) gives the light that the curve shows as y; a
// picture made with it appears through that engine's post-process as the plain picture does without it.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>

#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// The constants of the curve above.
inline constexpr double ue3_ceiling = 1.0275;
inline constexpr double ue3_shoulder = 0.22;

// x ≥ 0.
constexpr double ue3_encoded(double linear) {
    return ue3_ceiling * linear / (linear + ue3_shoulder);
}
// 0 ≤ y < 1.0275.
constexpr double ue3_linear(double encoded) {
    return ue3_shoulder * encoded / (ue3_ceiling - encoded);
}

// How luminance becomes a displayed value.
enum class ToneMap { none, ue3, ue3_inverse };

// A tone map by its name in text.
struct ToneMapName {
    ToneMap map;
    std::string_view name;
    std::string_view summary;
};

// All of them.
std::span<const ToneMapName> tone_maps();

// Fails (usage) on an unknown name and suggests the nearest.
Result<ToneMap> parse_tone_map(std::string_view name);
std::string_view to_text(ToneMap map);

// Applies the curve to every value of an exposed linear picture: display-encoded, for a file of integers.
void apply_ue3(Image& exposed);

// Applies the inverse to an exposed linear picture that is clamped to [0, 1] and sRGB-encoded, as in the plain view:
// linear light up to 8, for a file of floats.
void apply_ue3_inverse(Image& exposed);

} // namespace gonio
#pragma GCC visibility pop
