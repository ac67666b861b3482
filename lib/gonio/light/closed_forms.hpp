// The constants of photometric conversion: closed forms of the measures of a shape, written once for float and double.
//
// S is float or double; lengths may be in any one unit, angles are in radians. No formula here suffers cancellation:
// results are within 4 ulp of the exact value in double and within 8 ulp in float, from contact to astronomical
// distances, for cones of 1e-8 rad and for inner and outer angles that differ only in their last digits, as long as no
// product leaves the range of S (tests/unit/light/reference.csv checks them against 50 digits).
#pragma once

#include <gonio/light/shape.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::closed_form {

template<class S>
inline constexpr S pi = std::numbers::pi_v<S>;

// 1 − sin h/h for 0 ≤ h ≤ π/4, by its series.
template<class S>
S one_minus_sinc(S h) {
    const S x = h * h;
    S tail = S(1);
    for (const S divisor : {S(272), S(210), S(156), S(110), S(72), S(42), S(20)}) // 2k(2k+1)
        tail = S(1) - x / divisor * tail;
    return x / S(6) * tail;
}

// 1 − 3(sin h − h cos h)/h³, by its series too.
template<class S>
S one_minus_smooth(S h) {
    const S x = h * h;
    S tail = S(1);
    for (const S divisor : {S(304), S(238), S(180), S(130), S(88), S(54), S(28)}) // 2k(2k+3)
        tail = S(1) - x / divisor * tail;
    return x / S(10) * tail;
}

// Φ/I of a spot, 2π ∫ f(θ) sinθ dθ, for 0 ≤ inner ≤ outer ≤ π/2; 0 for an outer angle of 0.
template<class S>
S spot_solid_angle(Falloff falloff, S inner, S outer) {
    const S m = S(0.5) * (inner + outer);
    const S h = S(0.5) * (outer - inner);
    const auto cap = [](S angle) { // 1 − cos
        const S s = std::sin(S(0.5) * angle);
        return S(2) * s * s;
    };
    switch (falloff) {
    case Falloff::hard:
        return S(2) * pi<S> * cap(outer);
    case Falloff::frostbite:
        return S(2) * pi<S> * (cap(inner) + S(2) * std::sin(m) * std::sin(h) / S(3));
    case Falloff::linear_cos:
    case Falloff::smoothstep_cos:
        return S(2) * pi<S> * (cap(inner) + std::sin(m) * std::sin(h));
    case Falloff::linear_angle:
        return S(2) * pi<S> * (cap(m) + std::cos(m) * one_minus_sinc(h));
    case Falloff::smoothstep_angle:
        return S(2) * pi<S> * (cap(m) + std::cos(m) * one_minus_smooth(h));
    }
    return S(0);
}

// Solid angle of a right pyramid of full apex angles 0 ≤ h, v ≤ π: 4 asin(sin(h/2) sin(v/2)), as an arctangent that
// holds up to π because 1 − sin²sin² = cos²(h/2) + sin²(h/2) cos²(v/2).
template<class S>
S frustum_solid_angle(S h, S v) {
    const S sin_h = std::sin(S(0.5) * h);
    return S(4) *
           std::atan2(sin_h * std::sin(S(0.5) * v), std::hypot(std::cos(S(0.5) * h), sin_h * std::cos(S(0.5) * v)));
}

// I/L: the projected area of a shape along its direction; for a tube of radius r and length l, from the side.
template<class S>
S disk_area(S r) { // also a sphere's
    return pi<S> * (r * r);
}
template<class S>
S tube_area(S r, S l) {
    return r * (S(2) * l + pi<S> * r);
}

// Φ/I of a tube: π (2π r l + 4π r²)/(2 r l + π r²).
template<class S>
S tube_solid_angle(S r, S l) {
    return S(2) * pi<S> * pi<S> * ((l + S(2) * r) / (S(2) * l + pi<S> * r));
}

// E/L of a uniform disk of angular diameter δ at infinity, on a plane perpendicular to its direction: π sin²(δ/2).
template<class S>
S sun_projected_solid_angle(S diameter) {
    const S s = std::sin(S(0.5) * diameter);
    return pi<S> * (s * s);
}

// E/L of a receiver that faces the shape's centre at distance d, along the shape's direction.

// π r²/d², for d ≥ r: the inverse square is exact for a sphere.
template<class S>
S facing_sphere(S r, S d) {
    const S s = r / d;
    return pi<S> * (s * s);
}

// π r²/(d² + r²), for d ≥ 0.
template<class S>
S facing_disk(S r, S d) {
    const S s = r / std::hypot(d, r);
    return pi<S> * (s * s);
}

// 2 [A/√(1+A²) atan(B/√(1+A²)) + B/√(1+B²) atan(A/√(1+B²))] with A = w/2d, B = h/2d, for d > 0: four times the corner
// of the parallel plane (J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3).
template<class S>
S facing_rectangle(S w, S h, S d) {
    const S a = S(0.5) * w;
    const S b = S(0.5) * h;
    const S to_a = std::hypot(d, a);
    const S to_b = std::hypot(d, b);
    return S(2) * (a / to_a * std::atan(b / to_a) + b / to_b * std::atan(a / to_b));
}

// The outline of a capsule, two great arcs and two caps, for d ≥ r. With k² = d² − r², z = l/2, D² = d² + z²:
// 2 [(r/d) atan(z/k) + r²d/D³ atan2(Dk, rz) + r z k/(d D²)].
template<class S>
S facing_tube(S r, S l, S d) {
    // k from the difference d − r, which is exact where that matters: near contact.
    const S k = std::sqrt(std::max(d - r, S(0)) / d) * std::sqrt((d + r) / d); // over d, as are all values below
    const S z = S(0.5) * l / d;
    const S s = r / d;
    const S end = std::hypot(S(1), z);
    const S sin_end = s / end;
    return S(2) * (s * std::atan2(z, k) + sin_end * (sin_end / end * std::atan2(end * k, s * z) + z / end * k));
}

} // namespace gonio::closed_form
