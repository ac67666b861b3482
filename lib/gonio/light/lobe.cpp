#include <gonio/light/lobe.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

using std::numbers::pi;

// Inner = outer leaves no room to fall in, whatever the falloff.
Falloff effective(const SpotShape& spot) {
    return spot.inner.value < spot.outer.value ? spot.falloff : Falloff::hard;
}

double squared_sin_of_half(double angle) {
    const double s = std::sin(0.5 * angle);
    return s * s;
}

double smoothstep(double x) {
    return x * x * (3.0 - 2.0 * x);
}

// (cosθ − cos b)/(cos a − cos b), as products of sines.
double linear_in_cos(double theta, double inner, double outer) {
    return std::sin(0.5 * (outer + theta)) * std::sin(0.5 * (outer - theta)) /
           (std::sin(0.5 * (outer + inner)) * std::sin(0.5 * (outer - inner)));
}

// 1 − sin h/h; the series below ½, where the difference cancels, is exact to 1e-17 of it.
double one_minus_sinc(double h) {
    if (h >= 0.5) return 1.0 - std::sin(h) / h;
    const double x = h * h;
    return x / 6.0 * (1.0 - x / 20.0 * (1.0 - x / 42.0 * (1.0 - x / 72.0 * (1.0 - x / 110.0 * (1.0 - x / 156.0)))));
}

// 1 − 3(sin h − h cos h)/h³, likewise.
double one_minus_smooth(double h) {
    if (h >= 0.5) return 1.0 - 3.0 * (std::sin(h) - h * std::cos(h)) / (h * h * h);
    const double x = h * h;
    return x / 10.0 * (1.0 - x / 28.0 * (1.0 - x / 54.0 * (1.0 - x / 88.0 * (1.0 - x / 130.0 * (1.0 - x / 180.0)))));
}

} // namespace

double lobe(const SpotShape& spot, Radians theta) {
    const double a = spot.inner.value;
    const double b = spot.outer.value;
    const double t = theta.value;
    if (t <= a) return 1.0;
    const Falloff falloff = effective(spot);
    if (falloff == Falloff::hard) return t <= b ? 1.0 : 0.0;
    // Written so that NaN gives 0.
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
    const double a = spot.inner.value;
    const double b = spot.outer.value;
    const double m = 0.5 * (a + b);
    const double h = 0.5 * (b - a);
    switch (effective(spot)) {
    case Falloff::hard:
        return Steradians(2.0 * pi * (2.0 * squared_sin_of_half(b)));
    case Falloff::frostbite:
        return Steradians(2.0 * pi * (2.0 * squared_sin_of_half(a) + 2.0 / 3.0 * std::sin(m) * std::sin(h)));
    case Falloff::linear_cos:
    case Falloff::smoothstep_cos:
        return Steradians(2.0 * pi * (2.0 * squared_sin_of_half(a) + std::sin(m) * std::sin(h)));
    case Falloff::linear_angle:
        return Steradians(2.0 * pi * (2.0 * squared_sin_of_half(m) + std::cos(m) * one_minus_sinc(h)));
    case Falloff::smoothstep_angle:
        return Steradians(2.0 * pi * (2.0 * squared_sin_of_half(m) + std::cos(m) * one_minus_smooth(h)));
    }
    return Steradians(0.0);
}

Steradians lobe_solid_angle(const FrustumShape& frustum) {
    const double sin_h = std::sin(0.5 * frustum.horizontal.value);
    const double sin_v = std::sin(0.5 * frustum.vertical.value);
    const double cos_h = std::cos(0.5 * frustum.horizontal.value);
    const double cos_v = std::cos(0.5 * frustum.vertical.value);
    // 1 − sin²sin² = cos²(h/2) + sin²(h/2) cos²(v/2)
    return Steradians(4.0 * std::atan2(sin_h * sin_v, std::hypot(cos_h, sin_h * cos_v)));
}

std::string flux_formula(const SpotShape& spot) {
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
    return {};
}

} // namespace gonio
