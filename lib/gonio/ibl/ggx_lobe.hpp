// The lobe of a prefiltered environment: GGX with the eye, the normal and the mirrored direction in one (B. Karis,
// "Real Shading in Unreal Engine 4", 2013).
//
// The mirrored direction R then is the normal, the half vector lies at half the angle between R and l, and the density
// of GGX samples is D/4. Weighted by n·l as Unreal Engine, Frostbite and Filament do, the radiance is
//
//     L(R) = ∫ L(l) w(R·l) dω / ∫ w(R·l) dω,   w(c) = c D(√((1 + c)/2)) for c > 0, else 0
//
// with D(n·h) = α²/(π((α² − 1)(n·h)² + 1)²) and α = r². Then w = 4α²c/(π x²), x = (1 − c) + α²(1 + c): rational in c.
// r = 1 is Lambert's cosine: the irradiance over π. Angles are given as u = 1 − R·l = |R − l|²/2, which does not
// cancel.
#pragma once

#pragma GCC visibility push(default)
namespace gonio {

// The weight of each direction in a prefiltered environment.
class GgxLobe {
public:
    // Linear roughness r in (0, 1]; smaller than `least_roughness`, it is that.
    explicit GgxLobe(double roughness);

    // Where α is `shading::minimum_alpha`, 1e-4: the lobe is 0.02° wide.
    static constexpr double least_roughness = 0.01;

    [[nodiscard]] double alpha() const { return alpha_; }

    // w and its derivatives by c [1/sr], for u in [0, 1]; 0 beyond.
    [[nodiscard]] double weight(double u) const {
        if (u >= 1.0) return 0.0;
        const double inverse = 1.0 / (offset_ + falloff_ * u);
        return peak_ * (1.0 - u) * inverse * inverse;
    }
    [[nodiscard]] double slope(double u) const {
        if (u >= 1.0) return 0.0;
        const double inverse = 1.0 / (offset_ + falloff_ * u);
        return peak_ * inverse * inverse * (1.0 + 2.0 * falloff_ * (1.0 - u) * inverse);
    }
    [[nodiscard]] double curvature(double u) const {
        if (u >= 1.0) return 0.0;
        const double inverse = 1.0 / (offset_ + falloff_ * u);
        return peak_ * falloff_ * inverse * inverse * inverse * (4.0 + 6.0 * falloff_ * (1.0 - u) * inverse);
    }

    // ∫ w dω.
    [[nodiscard]] double whole() const { return whole_; }

    // ∫ w dc from 1 − u to 1, for u in [0, 1]; whole()/2π from there on.
    [[nodiscard]] double integral(double u) const;

private:
    // x = offset + falloff·u, w = peak·(1 − u)/x²
    double alpha_;
    double peak_;
    double offset_;
    double falloff_;
    double whole_ = 0.0;
};

} // namespace gonio
#pragma GCC visibility pop
