// Integrals of a web of type A or B over regions of (C, γ) with a weight, for which there is no closed form: masks.
//
// The lines of the native grid are planes of directions: x = q, y = q, x = −t z or y = −t z. A ring of constant γ meets
// each of them at azimuths with a closed form, so the integral over C is cut there, and each piece is the integral of a
// smooth function: Gauss–Legendre. Over γ the pieces end where a ring touches a line or passes a corner of the table,
// where the ring integral behaves like a square root; the substitution (3t − t³)/2 for γ makes it smooth, and
// Gauss–Legendre is used again. Relative error of a flux below 1e-6 for grids of random values, which are the worst
// case, and near 1e-10 for measured tables; works for type C too, but slower than its closed forms. Deterministic,
// starts no threads. Cost: 8 rings per grid line or 2.5°, each about 100 ns × 4 × (grid lines + edges).
#pragma once

#include <gonio/web/web.hpp>

#include <functional>
#include <span>
#include <vector>

namespace gonio {

class Rings {
public:
    explicit Rings(const Web& web); // `web` must outlive it

    // Adds lines at which a weight bends or ends: the cone γ, the planes x = ±tan(half)·(−z) and y = ±tan(half)·(−z).
    void cut_at_gamma(double gamma_deg);
    void cut_at_pyramid(double half_x_deg, double half_y_deg);

    // Adds ∫ I w dω over each [c_edges[i], c_edges[i+1]] × [low, high] to lumens[i]; `c_edges_deg` ascend within [0°,
    // 360°] and `lumens` has one value fewer. Without a weight, w is 1.
    using Weight = std::function<double(const glm::dvec3& direction)>;
    void add(double gamma_low_deg, double gamma_high_deg, std::span<const double> c_edges_deg, std::span<double> lumens,
             const Weight& weight = {}) const;

    // ∫ I w dω over the whole zone [low, high] of γ.
    double zone(double gamma_low_deg, double gamma_high_deg, const Weight& weight = {}) const;

private:
    void add_ring(double gamma_rad, double factor, std::span<const double> c_edges_deg, std::span<double> lumens,
                  const Weight& weight) const;

    const Web& web_;
    std::vector<double> x_at_;       // lines x = q of the unit direction
    std::vector<double> y_at_;       // lines y = q
    std::vector<double> x_slope_;    // lines x = t·(−z)
    std::vector<double> y_slope_;    // lines y = t·(−z)
    std::vector<double> breaks_deg_; // ascending γ at which the ring integral is not smooth
};

} // namespace gonio
