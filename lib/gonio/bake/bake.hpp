// Baking: a web as a texture whose texels hold the exact mean of its interpolant over their solid angle, so that the
// flux is exact at every size.
#pragma once

#include <gonio/bake/layout.hpp>
#include <gonio/bake/texture.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/web/web.hpp>

namespace gonio {

// Greatest width and height of a texture.
inline constexpr int max_texture_size = static_cast<int>(limit("texture-side").value);

struct BakeOptions {
    Layout layout = Layout::latlong;
    int width = 512;
    int height = 256;
    LayoutOptions chart;
    Normalization normalization = Normalization::none;
    TexelType texel_type = TexelType::float32;
    Sampling sampling = Sampling::mean;
    Transfer transfer = Transfer::linear; // srgb with normalization peak only
    unsigned threads = 0;                 // 0 = as many as there are; does not change a bit of the result
    bool skip = true; // copy mirror images and skip dark regions of the web; the texels are the same
};

// The default size of a layout.
TextureSize usual_size(Layout layout);

// The smallest texture of the options' layout whose max_error is within the limit: sizes are doubled until one is, and
// halved in between. `width` and `height` are not read. Fails (usage) when no size up to 4096 texels a side (a cube's
// face, the height of latlong and panorama) is good enough, which says how near it came.
Result<Texture> bake_smallest(const Web& web, const BakeOptions& options, Candelas max_error);

// Negative means are stored as 0. latlong and v180 of a type C web are closed forms (gonio/bake/latlong.hpp); the
// others are line integrals around each texel (gonio/bake/texel_flux.hpp), 1 to 2 µs each. Fails (usage) on a size
// outside [1, max_texture_size] or of more texels than the limit picture-pixels or that the layout cannot have, and on
// a normalization by something that is not greater than 0.
Result<Texture> bake_texture(const Web& web, const BakeOptions& options);

} // namespace gonio
