// Flux of a web of type A or B within cones about the nadir and about the zenith. Its table has no closed form for
// these; the flux is a line integral around the cone.
//
// With the azimuth α and the polar angle θ of the goniometer's axis, which is horizontal, the cone of half angle γ
// spans |α| ≤ γ and, at α, the polar angles with sinθ ≥ cosγ / cosα. By Green's theorem its flux is ∫ [G(α, π − θ) −
// G(α, θ)] dα with Meridians' G. Along α = γ cosψ the integrand is smooth between the grid lines, and the points where
// the cone meets these have closed forms, so Gauss–Legendre is used between them. Relative error below 1e-9 of the flux
// for tables of random values, which are the worst case.
#pragma once

#include <gonio/web/meridians.hpp>

namespace gonio {

class ConeFlux {
public:
    explicit ConeFlux(const Web& web); // of type A or B

    // [lm]: `front` where C is within 90° of C0, `back` for the rest.
    struct Halves {
        double front = 0.0;
        double back = 0.0;

        [[nodiscard]] double both() const { return front + back; }
        Halves operator+(const Halves& other) const { return {front + other.front, back + other.back}; }
        Halves operator-(const Halves& other) const { return {front - other.front, back - other.back}; }
    };

    // Between two γ in [0°, 180°], low ≤ high. Exactly 0 if the table is dark there.
    [[nodiscard]] Halves zone(double gamma_low_deg, double gamma_high_deg) const;

private:
    // Within half_angle ≤ 90° of the nadir or of the zenith.
    [[nodiscard]] Halves cone(double half_angle_rad, bool about_zenith) const;

    Meridians meridians_;
    bool axis_sideways_; // the axis is along Y (type A), else along X
};

} // namespace gonio
