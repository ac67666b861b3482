#include <gonio/light/closed_forms.hpp>
#include <gonio/light/lobe.hpp>

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

// With inner = outer the edge is hard, whatever the falloff.
Falloff effective(const SpotShape& spot) {
    return spot.inner.value < spot.outer.value ? spot.falloff : Falloff::hard;
}

double smoothstep(double x) {
    return x * x * (3.0 - 2.0 * x);
}

// (cosθ − cos b)/(cos a − cos b), as products of sines.
double linear_in_cos(double theta, double inner, double outer) {
    return std::sin(0.5 * (outer + theta)) * std::sin(0.5 * (outer - theta)) /
           (std::sin(0.5 * (outer + inner)) * std::sin(0.5 * (outer - inner)));
}

} // namespace

double lobe(const SpotShape& spot, Radians theta) {
    const double a = spot.inner.value;
    const double b = spot.outer.value;
    const double t = theta.value;
    if (t <= a) return 1.0;
    const Falloff falloff = effective(spot);
    if (falloff == Falloff::hard) return t <= b ? 1.0 : 0.0;
    // Written so that a NaN gives 0.
    if (!(t < b)) return 0.0;
    const bool by_angle = falloff == Falloff::linear_angle || falloff == Falloff::smoothstep_angle;
    const double x = std::clamp(by_angle ? (b - t) / (b - a) : linear_in_cos(t, a, b), 0.0, 1.0);
    switch (falloff) {
    case Falloff::frostbite:
        return x * x;
    case Falloff::smoothstep_cos:
    case Falloff::smoothstep_angle:
        return smoothstep(x);
    default:
        return x;
    }
}

double lobe(const FrustumShape& frustum, const glm::dvec3& direction) {
    const auto inside = [&](double across, Radians apex) {
        const double half = 0.5 * apex.value;
        return std::abs(across) * std::cos(half) <= -direction.z * std::sin(half);
    };
    return inside(direction.x, frustum.horizontal) && inside(direction.y, frustum.vertical) ? 1.0 : 0.0;
}

Steradians lobe_solid_angle(const SpotShape& spot) {
    return Steradians(closed_form::spot_solid_angle(effective(spot), spot.inner.value, spot.outer.value));
}

Steradians lobe_solid_angle(const FrustumShape& frustum) {
    return Steradians(closed_form::frustum_solid_angle(frustum.horizontal.value, frustum.vertical.value));
}

const char* flux_formula(const SpotShape& spot) {
    switch (effective(spot)) {
    case Falloff::hard:
        return "Φ = 4π sin²(b/2) I";
    case Falloff::frostbite:
        return "Φ = 2π (2 sin²(a/2) + ⅔ sin m sin h) I, m = (a+b)/2, h = (b−a)/2";
    case Falloff::linear_cos:
    case Falloff::smoothstep_cos:
        return "Φ = 2π (2 sin²(a/2) + sin m sin h) I, m = (a+b)/2, h = (b−a)/2";
    case Falloff::linear_angle:
        return "Φ = 2π (2 sin²(m/2) + cos m (1 − sin h/h)) I, m = (a+b)/2, h = (b−a)/2";
    case Falloff::smoothstep_angle:
        return "Φ = 2π (2 sin²(m/2) + cos m (1 − 3(sin h − h cos h)/h³)) I, m = (a+b)/2, h = (b−a)/2";
    }
    return "";
}

} // namespace gonio
