// Integrals of a type C web over rectangles of (C, γ), exactly: the interpolant is a sum of products of a hat function
// of C and one of γ, so an integral over a rectangle is Σ Aᵢ Bⱼ Iᵢⱼ with one weight per plane and one per γ.
//
// Cost: a few multiplications for each grid line within the interval. For types A and B see gonio/web/rings.hpp.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/web/web.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace gonio {

// The weight of one stored plane or γ.
struct Term {
    std::size_t index;
    double weight;
};
using Terms = std::vector<Term>;

// Aᵢ = ∫ hᵢ dC [rad] over [low, high] within [0°, 360°], mirrors included; `bends_deg` is plane_bends_deg(web).
Terms plane_terms(const Web& web, std::span<const double> bends_deg, double low_deg, double high_deg);

// Bⱼ = ∫ gⱼ sinγ dγ over [low, high] within [0°, 180°].
Terms gamma_terms(const Web& web, double low_deg, double high_deg);

// Σ Aᵢ Bⱼ Iᵢⱼ: the flux into the rectangle of the two intervals.
Lumens sum_of(const Web& web, const Terms& planes, const Terms& gammas);

} // namespace gonio
