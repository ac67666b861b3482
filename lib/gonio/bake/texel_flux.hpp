// The flux of a web through the texels of a chart, and their solid angles, by line integrals around them.
//
// By Green's theorem a texel's flux is ∮ G dα around it (gonio/web/meridians.hpp), and its solid angle ∮ (1 − cosθ) dα.
// An edge is cut where the map folds, where it passes a break of the web, and where θ turns; each piece is smooth and
// is integrated by Gauss–Legendre. Neighbours share their edges, so that what one texel gains the next one loses: the
// sum over a texture is exact at every size. Around a texel that holds the pole θ = π, where G does not vanish, the
// integral counts from that pole instead. Errors are below 1e-11 of the peak times a texel's solid angle, and never
// more than the rounding of G, 1e-15 of peak times steradian. Cost: 3 edges a texel, each 4 to 12 evaluations of some
// 100 ns.
#pragma once

#include <gonio/bake/layout.hpp>
#include <gonio/web/meridians.hpp>

#include <span>

namespace gonio {

class TexelFlux {
public:
    // Both must outlive it.
    TexelFlux(const Meridians& meridians, const Chart& chart, int width, int height)
        : meridians_(meridians), chart_(chart), width_(width), height_(height) {}

    // Of row j: lumens (negative intensities included) and steradians of each of the `width` texels. Rows are
    // independent of each other, so threads may share them out.
    void row(int j, std::span<double> lumens, std::span<double> steradians) const;

private:
    const Meridians& meridians_;
    const Chart& chart_;
    int width_;
    int height_;
};

} // namespace gonio
