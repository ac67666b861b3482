// Baking: a web as a texture. Each texel stores the exact mean of the web's interpolant over the texel's solid angle,
// so the flux is exact at every size.
#pragma once

#include <gonio/bake/layout.hpp>
#include <gonio/bake/texture.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/web/web.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// Greatest width and height of a texture.
inline constexpr int max_texture_size = static_cast<int>(limit("texture-side").value);

// What texture to bake.
struct BakeOptions {
    Layout layout = Layout::latlong;
    int width = 512;
    int height = 256;
    LayoutOptions chart;
    Normalization normalization = Normalization::none;
    TexelType texel_type = TexelType::float32;
    Sampling sampling = Sampling::mean;
    Transfer transfer = Transfer::linear; // srgb with normalization peak only
    unsigned threads = 0;                 // 0 = as many as there are; the result is the same to the last bit
    bool skip = true; // copy mirror images and skip dark regions of the web; the texels are the same
};

// The default size of a layout.
TextureSize usual_size(Layout layout);

// The smallest texture of the options' layout with a max_error within the limit: sizes are doubled until one fits, then
// bisected. `width` and `height` are ignored. Fails (usage) when no size up to 4096 texels a side (a cube's face, the
// height of latlong and panorama) is good enough; the message states the error of the largest size.
Result<Texture> bake_smallest(const Web& web, const BakeOptions& options, Candelas max_error);

// Negative means are stored as 0. latlong and v180 of one row are closed forms (gonio/bake/latlong.hpp) if the web is
// of type C, the chart is not rotated and the texels are means; all else is by line integrals around each texel
// (gonio/bake/texel_flux.hpp), 1 to 2 µs each. Fails (usage) on a size outside [1, max_texture_size], with more texels
// than the limit picture-pixels, or that the layout cannot have, and on normalization by a value that is not greater
// than 0; (unsupported) if a value does not fit the pixels.
Result<Texture> bake_texture(const Web& web, const BakeOptions& options);

} // namespace gonio
#pragma GCC visibility pop
