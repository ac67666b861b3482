// The flux and the solid angle of one cell of a chart by line integrals around it, for any size and position: the slow
// and general method that gonio/bake/texel_flux.hpp falls back on.
//
// An edge is cut where the map folds, where the edge crosses a break of the web, and where θ turns; each piece is
// smooth and is integrated by Gauss–Legendre. Some µs per edge.
#pragma once

#include <gonio/bake/layout.hpp>
#include <gonio/web/meridians.hpp>

namespace gonio {

// ∮ G dα and ∮ (1 − cosθ) dα along an edge: around a cell, these are its flux and its solid angle up to a common sign.
// Counted from the pole θ = 0, and from θ = π.
struct EdgeSums {
    double flux = 0.0;
    double solid_angle = 0.0;
    double far_flux = 0.0;
    double far_solid_angle = 0.0;

    EdgeSums& operator+=(const EdgeSums& other);
    EdgeSums& operator-=(const EdgeSums& other);
};

// Along s (at t = fixed) or t (at s = fixed), from → to.
EdgeSums edge_sums(const Meridians& meridians, const Chart& chart, bool along_s, double fixed, double from, double to);

// A texel, or a part of one.
struct ChartCell {
    double s0 = 0.0;
    double s1 = 0.0;
    double t0 = 0.0;
    double t1 = 0.0;
};

struct CellFlux {
    double lumens = 0.0; // negative intensities included
    double steradians = 0.0;
};

// Flux and solid angle from the sums around a cell, counted from one pole or the other.
CellFlux inside(const EdgeSums& around, bool from_far_pole);

// Flux of a cell; a cell that may contain both poles is divided until no part does.
CellFlux cell_flux(const Meridians& meridians, const Chart& chart, const ChartCell& cell, int depth = 0);

// Whether a cell contains or touches the pole θ = π, so that its flux has to be counted around that pole.
// Overestimates.
bool may_hold_far_pole(const Meridians& meridians, const Chart& chart, const ChartCell& cell);

} // namespace gonio
