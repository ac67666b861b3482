// The latitude-longitude layout: column i is C = (i+½)/W·360°, row j is γ = (j+½)/H·180°, first row at the nadir.
//
// A texel holds the exact mean of the web over the texel's solid angle. The interpolant is a sum of products of a
// piecewise linear function of C and one of γ, so the mean is a product of two weights that have closed forms, and the
// texels' integral is the web's flux at every size, to rounding. Cost: O(planes × H + W × H).
// A web of type A or B is not such a sum in (C, γ): its texels are integrated by quadrature cut at the native grid
// (gonio/web/rings.hpp), and their integral is the web's flux to 1e-6. Cost: about 0.5 s for 512×256, over threads.
#pragma once

#include <gonio/bake/texture.hpp>
#include <gonio/web/web.hpp>

namespace gonio {

// Greatest width and height of a texture.
inline constexpr int max_texture_size = 32768;

struct BakeOptions {
    int width = 512;
    int height = 256;
    Normalization normalization = Normalization::none;
    unsigned threads = 0; // 0 = as many as there are; does not change a bit of the result
};

// Negative means are stored as 0. Fails (usage) on a size outside [1, max_texture_size] or of more than 2²⁸ texels, and
// on a normalization by something that is not greater than 0.
Result<Texture> bake_latlong(const Web& web, const BakeOptions& options);

} // namespace gonio
