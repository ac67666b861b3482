// The flux of a web through the texels of a chart, and their solid angles, by line integrals around them.
//
// By Green's theorem a texel's flux is ∮ G dα around it (gonio/web/meridians.hpp), and its solid angle ∮ (1 − cosθ) dα.
// Neighbours share their edges, so what one texel gains, the next one loses: the sum over a texture is exact at every
// size. A short edge is cut where it crosses a break of the web; the pieces are integrated by 3 to 6 Gauss–Legendre
// nodes, with α and θ expanded around the piece's middle. Edges that are long or folded or turn at a break, and texels
// at the pole θ = π, where G does not vanish, use the general method (gonio/bake/cell_flux.hpp). Errors are below 1e-11
// of the peak times a texel's solid angle, and never more than the rounding of G, 1e-15 of peak times steradian. Cost:
// two edges a texel, each some 100 to 400 ns.
#pragma once

#include <gonio/bake/cell_flux.hpp>
#include <gonio/bake/layout.hpp>
#include <gonio/web/meridians.hpp>

#include <cstddef>
#include <span>

namespace gonio {

class TexelFlux {
public:
    // Both arguments must outlive this.
    TexelFlux(const Meridians& meridians, const Chart& chart, int width, int height)
        : meridians_(meridians), chart_(chart), width_(width), height_(height) {}

    // Rows j to j + rows − 1: lumens (negative intensities included) and steradians of each texel that is `wanted` (one
    // char each; empty: all), 0 for other texels. `skip_dark`: texels in a completely dark part of the web get 0 sr too
    // (in charts of at least 16 texels a side). All spans hold rows × width values. Rows are independent of each other,
    // so threads may share them out; the edges between the rows of one call are computed only once.
    void rows(int j, int rows, std::span<const char> wanted, bool skip_dark, std::span<double> lumens,
              std::span<double> steradians) const;

    // A single texel: the same numbers to the last bit.
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
