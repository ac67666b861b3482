// The flux of a web through the texels of a chart, and their solid angles, by line integrals around them.
//
// By Green's theorem a texel's flux is ∮ G dα around it (gonio/web/meridians.hpp), and its solid angle ∮ (1 − cosθ) dα.
// Neighbours share their edges, so that what one texel gains the next one loses: the sum over a texture is exact at
// every size. A short edge is cut where it passes a break of the web, and what lies between is integrated by 3 to 6
// Gauss–Legendre nodes around whose middle α and θ are expanded; edges that are long or folded or turn at a break, and
// texels at the pole θ = π, where G does not vanish, go the general way (gonio/bake/cell_flux.hpp). Errors are below
// 1e-11 of the peak times a texel's solid angle, and never more than the rounding of G, 1e-15 of peak times steradian.
// Cost: two edges a texel, each some 100 to 400 ns.
#pragma once

#include <gonio/bake/cell_flux.hpp>
#include <gonio/bake/layout.hpp>
#include <gonio/web/meridians.hpp>

#include <cstddef>
#include <span>

namespace gonio {

class TexelFlux {
public:
    // Both must outlive it.
    TexelFlux(const Meridians& meridians, const Chart& chart, int width, int height)
        : meridians_(meridians), chart_(chart), width_(width), height_(height) {}

    // Rows j to j + rows − 1: lumens (negative intensities included) and steradians of each texel that is `wanted` (one
    // char each; empty: all), 0 for the others. `skip_dark`: texels that lie where the web is dark all over get 0 sr
    // too (in charts of 16 texels a side and more). All spans hold rows × width values. Rows are independent of each
    // other, so threads may share them out; a band of several computes the edges between them once.
    void rows(int j, int rows, std::span<const char> wanted, bool skip_dark, std::span<double> lumens,
              std::span<double> steradians) const;

    // One texel by itself: the same numbers to the last bit.
    [[nodiscard]] CellFlux texel(int i, int j) const;

private:
    struct Corner;
    [[nodiscard]] Corner corner(int i, int j) const;
    [[nodiscard]] ChartCell cell_of(int i, int j) const;
    [[nodiscard]] bool is_dark(const Corner* upper, const Corner* lower) const;
    [[nodiscard]] bool is_far(const Corner* upper, const Corner* lower) const;
    [[nodiscard]] bool is_at_far_pole(const Corner* upper, const Corner* lower, const ChartCell& cell) const;
    [[nodiscard]] EdgeSums edge(const Corner& begin, const Corner& end, bool along_s, double fixed, double from,
                                double to) const;
    [[nodiscard]] EdgeSums piece(bool along_s, double fixed, double from, double to, int halvings) const;

    const Meridians& meridians_;
    const Chart& chart_;
    int width_;
    int height_;
};

} // namespace gonio
