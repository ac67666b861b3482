// Display modes: the same rendering as a photograph, as false colours, or as lines of equal light.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>
#include <gonio/plot/palette.hpp>
#include <gonio/plot/value_scale.hpp>
#include <gonio/preview/render.hpp>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace gonio {

enum class Look {
    beauty,      // as a camera would show it
    false_color, // a colour for each number
    isolux,      // lines of equal light over the dimmed beauty picture
    luminance    // the luminance as a grey picture
};

struct LookName {
    Look look;
    std::string_view name;
    std::string_view summary;
};

std::span<const LookName> looks();

// "falsecolor" counts as "falsecolour". Fails (usage) on an unknown name and suggests the nearest.
Result<Look> parse_look(std::string_view name);
std::string_view to_text(Look look);

enum class PictureQuantity { illuminance, luminance };

std::string_view to_text(PictureQuantity quantity); // "illuminance"

// One channel: the illuminance of the surfaces in lux (the rendering must have been made with it), or the luminance in
// cd/m² (Y of the colour) that the camera sees.
Image quantity_image(const Rendering& rendering, PictureQuantity quantity);

// Three display-encoded channels: the palette's colour at each value's share of the scale. Values beyond the scale get
// the colours of its ends.
Image false_color(const Image& values, const ValueScale& scale, const Palette& palette);

// Which surface or light is visible at each pixel's centre; negative numbers mean nothing or an outline, that is, a
// pixel with a neighbour of another kind. Lines of equal light end there instead of following the jump.
std::vector<std::int32_t> seen_surfaces(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                                        int width, int height, unsigned threads);

} // namespace gonio
