#include <gonio/base/named.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/preview/tone_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace gonio {

namespace {

constexpr std::array known{
    ToneMapName{ToneMap::none, "none", "only the view of the display transform"},
    ToneMapName{ToneMap::ue3, "ue3", "Unreal Engine 3: y = 1.0275 x/(x+0.22), display-encoded, instead of the view"},
    ToneMapName{ToneMap::ue3_inverse, "ue3-inverse",
                "linear light that the UE3 curve turns into the plain sRGB picture"},
};
static_assert(in_enum_order(known, &ToneMapName::map, ToneMap::ue3_inverse));

} // namespace

std::span<const ToneMapName> tone_maps() {
    return known;
}

Result<ToneMap> parse_tone_map(std::string_view name) {
    return find_named("tone map", name, known).map([](const ToneMapName* map) { return map->map; });
}

std::string_view to_text(ToneMap map) {
    return known[static_cast<std::size_t>(map)].name;
}

void apply_ue3(Image& exposed) {
    for (float& value : exposed.pixels)
        value = static_cast<float>(ue3_encoded(std::max(static_cast<double>(value), 0.0)));
}

void apply_ue3_inverse(Image& exposed) {
    for (float& value : exposed.pixels)
        value = static_cast<float>(ue3_linear(encode_srgb(std::clamp(static_cast<double>(value), 0.0, 1.0))));
}

} // namespace gonio
