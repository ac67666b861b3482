// An ellipse as a light: for every receiver it is exactly equivalent to a disk. E/L [sr] in [0, π], exact with horizon
// clipping.
//
// A receiver sees a uniform flat light only as a cone of directions, and every elliptic cone has circular sections
// (Apollonius, "Conics", I.5): a disk with the same cone gives the same irradiance, the horizon included, the same
// highlights, and the same directions to sample. So an ellipse does not need a separate integral.
//
// The cone of the ellipse p(t) = A + U cos t + V sin t is transformed to its axes as in ltc_cone.hpp, by boosts and
// rotations of A, U, V that keep the null cone of (1, cos t, sin t). A, U, V are given in the ellipse's own axes, where
// rotating columns keeps the digits of each row, so that the depth of a grazing view is not lost. The cone is then
// x²/α² + y²/β² = z² with α = |U|/|A| ≥ β = |V|/|A|. The plane y √(α² − β²) + z β √(1 + α²) = β (1 + β²), which
// contains the long axis, cuts it in the circle with
//
//     centre  (0, −β s, C),   radius  α √(1 + β²),   s = √(α² − β²),   C = √(1 + α²)
//
// where the only difference is α − β, and both numbers are accurate to their last digits.
#pragma once

#include <gonio/shading/irradiance_disk.hpp>
#include <gonio/shading/lights.hpp>
#include <gonio/shading/ltc_cone.hpp>
#include <gonio/shading/seen_from.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

namespace detail {

// A cone of directions in its own axes: x²/α² + y²/β² = z², z > 0.
template<class S>
struct EllipticCone {
    vec3<S> x, y, z; // unit
    S alpha, beta;   // α ≥ β ≥ 0
};

// Boosts a and u by any amount until they are perpendicular. The boost multiplies p = a + u and m = a − u by e^η and
// e^−η, and both get the same length: tanh η = −4 a·u/(|p| + |m|)². Small boosts are computed from a and u, which hold
// the digits of a narrow cone, large ones from p and m, which hold those of a cone that is open to one side. Returns
// tanh² η.
template<class S>
GONIO_FORCE_INLINE S boost_fully(vec3<S>& a, vec3<S>& u) {
    constexpr double least = __is_same(S, double) ? 1e-150 : 1e-18;
    const vec3<S> p = a + u;
    const vec3<S> m = a - u;
    const S p_length = simd::max(length(p), S(least));
    const S m_length = simd::max(length(m), S(least));
    const S sum = p_length + m_length;
    const S t = S(-4) * dot(a, u) / (sum * sum);
    const S root = simd::sqrt(p_length) * simd::sqrt(m_length);
    const S cosine = S(0.5) * sum / root;
    const auto large = t * t > S(0.5);
    const S of_p = S(0.5) * root / p_length;
    const S of_m = S(0.5) * root / m_length;
    const vec3<S> to_a = select(large, p * of_p + m * of_m, (a + u * t) * cosine);
    u = select(large, p * of_p - m * of_m, (u + a * t) * cosine);
    a = to_a;
    return t * t;
}

// The cone of a + u cos t + v sin t; u and v are perpendicular, lengths are of moderate size.
template<class S>
GONIO_FORCE_INLINE EllipticCone<S> elliptic_cone(vec3<S> a, vec3<S> u, vec3<S> v) {
    constexpr int most_sweeps = 12; // poses within 1e-6 of the rim take 7, others 3 or 4
    for (int i = 0; i < most_sweeps; ++i) {
        const S by_u = boost_fully(a, u);
        const S by_v = boost_fully(a, v);
        make_perpendicular(u, v);
        // The remaining error is the square of this one.
        if (!simd::any(simd::max(by_u, by_v) > S(__is_same(S, double) ? 1e-18 : 1e-9))) break;
    }
    const S inverse = reciprocal_or_zero(length(a));
    EllipticCone<S> cone;
    cone.z = a * inverse;
    cone.alpha = length(u) * inverse;
    cone.beta = simd::min(length(v) * inverse, cone.alpha);
    cone.x = normalized(u);
    cone.y = cross(cone.z, cone.x);
    return cone;
}

} // namespace detail

// An ellipse with the half axes a along `width_direction` and b across it, both > 0.
template<class S>
struct EllipseLight {
    vec3<S> center;            // [m]
    vec3<S> luminance;         // [nt], three channels, of each side that emits
    vec3<S> axis;              // unit, the direction of emission
    vec3<S> width_direction;   // unit, perpendicular to the axis
    S half_width, half_height; // [m]
    S inverse_range;           // [1/m] of window_squared, by the distance of the centre; 0 = no window
    bool two_sided;

    // The disk with the same cone, of radius 1, one-sided and without a window. In the ellipse's plane, a receiver
    // inside the rim lies on the disk, and one outside sees nothing.
    GONIO_FORCE_INLINE Seen<DiskLight<S>, S> seen_from(vec3<S> to_center) const;

    // The disk of the same area, which the approximations of other renderers use instead.
    GONIO_FORCE_INLINE DiskLight<S> approximated() const {
        return {center, luminance, axis, simd::sqrt(half_width * half_height), inverse_range, two_sided};
    }
};

namespace detail {

template<class S>
GONIO_FORCE_INLINE S largest_size(const EllipseLight<S>& light) {
    return simd::max(simd::abs(light.half_width), simd::abs(light.half_height));
}

// How far the ellipse reaches from its centre along the receiver's normal, up and down: up to 8 % more than √(x² + y²),
// because its squares would exceed the range of floats.
template<class S>
GONIO_FORCE_INLINE S reach(const EllipseLight<S>& light, vec3<S> normal) {
    constexpr double root_2 = 1.41421356237309504880;
    const S along_x = simd::abs(dot(normal, light.width_direction) * light.half_width);
    const S along_y = simd::abs(dot(normal, cross(light.axis, light.width_direction)) * light.half_height);
    return simd::mul_add(simd::min(along_x, along_y), S(root_2 - 1.0), simd::max(along_x, along_y));
}

// An ellipse as a receiver sees it.
template<class S>
struct SeenEllipse {
    EllipticCone<S> cone; // in the ellipse's own axes: along its width, across it, against `axis`; not where in_plane
    vec3<S> across;       // the second of these axes in the world
    simd::mask_of<S> in_plane, dark;

    GONIO_FORCE_INLINE SeenEllipse(const EllipseLight<S>& light, vec3<S> to_center)
        : across(cross(light.axis, light.width_direction)) {
        const S half_width = simd::abs(light.half_width);
        const S half_height = simd::abs(light.half_height);
        const S size = simd::max(largest_component(to_center), simd::max(half_width, half_height));
        const S scale = S(0.125) * simd::reciprocal_power_of_two(size);
        const auto c = widen(to_center * scale);
        S x, y, depth;
        simd::narrow(dot(c, widen(light.width_direction)), x);
        simd::narrow(dot(c, widen(across)), y);
        simd::narrow(-dot(c, widen(light.axis)), depth);
        const S a = half_width * scale;
        const S b = half_height * scale;
        in_plane = depth == S(0);
        cone = elliptic_cone(vec3<S>{x, y, simd::select(in_plane, S(1), depth)}, vec3<S>{a, S(0), S(0)},
                             vec3<S>{S(0), b, S(0)});
        const S to_x = x / simd::max(a, S(1e-36));
        const S to_y = y / simd::max(b, S(1e-36));
        dark = simd::both(in_plane, !(simd::mul_add(to_x, to_x, to_y * to_y) < S(1)));
        if (!light.two_sided) dark = simd::either(dark, depth < S(0));
        dark = simd::either(dark, !(a * b > S(0)));
    }

    // Transforms to the world.
    GONIO_FORCE_INLINE vec3<S> world(const EllipseLight<S>& light, vec3<S> p) const {
        return light.width_direction * p.x + across * p.y - light.axis * p.z;
    }
};

// The disk with the same cone, in units of its radius.
template<class S>
struct EquivalentDisk {
    vec3<S> across, along; // unit, in its plane
    vec3<S> away;          // unit, from the receiver: the disk emits the other way
    S offset;              // from its centre to the foot of the receiver, along `along`
    S height;              // height of the receiver over its plane; −1 where nothing is seen
    S opening;             // α

    GONIO_FORCE_INLINE EquivalentDisk(const EllipseLight<S>& light, vec3<S> to_center) {
        const SeenEllipse<S> seen(light, to_center);
        const EllipticCone<S>& cone = seen.cone;
        const S s = simd::sqrt(simd::max((cone.alpha - cone.beta) * (cone.alpha + cone.beta), S(0)));
        const S big = simd::sqrt(simd::mul_add(cone.alpha, cone.alpha, S(1)));
        const S inverse_alpha = reciprocal_or_zero(cone.alpha);
        const S inverse_root = inverse_alpha / simd::sqrt(simd::mul_add(cone.beta, cone.beta, S(1)));
        const S cosine = cone.beta * big * inverse_root;
        const S sine = s * inverse_root;
        const auto in_plane = seen.in_plane;
        across = seen.world(light, select(in_plane, vec3<S>{S(1), S(0), S(0)}, cone.x));
        along = seen.world(light, select(in_plane, vec3<S>{S(0), S(1), S(0)}, cone.y * cosine - cone.z * sine));
        away = seen.world(light, select(in_plane, vec3<S>{S(0), S(0), S(1)}, cone.y * sine + cone.z * cosine));
        offset = simd::select(in_plane, S(0), s * big * inverse_alpha * inverse_alpha);
        height =
            simd::select(seen.dark, S(-1), simd::select(in_plane, S(0), cone.beta * inverse_alpha * inverse_alpha));
        opening = simd::select(in_plane, S(0), cone.alpha);
    }
};

// For wider cones the rim is so close that float cannot resolve its position.
inline constexpr double widest_float_cone = 1.0;

// As irradiance_ellipse, except in the hard lanes.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey(const EllipseLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    const EquivalentDisk<S> disk(light, to_center);
    // In the disk's own axes: those vectors are exact.
    const vec3<S> n{dot(normal, disk.across), dot(normal, disk.along), dot(normal, disk.away)};
    const Survey<S> seen =
        survey_disk(vec3<S>{S(0), -disk.offset, disk.height}, vec3<S>{S(0), S(0), S(-1)}, S(1), n, false);
    if constexpr (__is_same(S, double))
        return seen;
    else
        return {seen.irradiance, simd::either(seen.hard, disk.opening > S(widest_float_cone))};
}

// The same where all of it is above the horizon: π n·z αβ/√((1 + α²)(1 + β²)), in which nothing cancels.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_above(const EllipseLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    constexpr double pi = 3.14159265358979323846;
    const SeenEllipse<S> seen(light, to_center);
    const EllipticCone<S>& cone = seen.cone;
    const S open = simd::mul_add(cone.alpha, cone.alpha, S(1)) * simd::mul_add(cone.beta, cone.beta, S(1));
    const S whole = S(pi) * dot(normal, seen.world(light, cone.z)) * (cone.alpha * cone.beta / simd::sqrt(open));
    return {simd::select(seen.dark, S(0), clamp_irradiance(whole)),
            simd::either(seen.in_plane, cone.alpha > S(widest_float_cone))};
}

struct EllipseInDouble;

} // namespace detail

template<class S>
GONIO_FORCE_INLINE Seen<DiskLight<S>, S> EllipseLight<S>::seen_from(vec3<S> to_center) const {
    const detail::EquivalentDisk<S> disk(*this, to_center);
    const vec3<S> to_disk = disk.away * disk.height - disk.along * disk.offset;
    return {{to_disk, luminance, disk.away * S(-1), S(1), S(0), false}, to_disk};
}

// E/L [sr] of an ellipse about `to_center` [m, from the receiver]; the receiver's `normal` is unit. 0 behind a
// one-sided ellipse. In its plane: inside the rim the limit from the front, outside the rim 0. Any finite input; an
// axis of 0 gives 0. In float and packs, receivers that see the ellipse under a half angle of more than 45°, and those
// listed at irradiance_disk, are evaluated in double, lane by lane.
template<class S>
GONIO_FORCE_INLINE S irradiance_ellipse(const EllipseLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    const auto seen = detail::survey(light, to_center, normal);
    if constexpr (!__is_same(S, double)) {
        const vec3<S>& c = to_center;
        const vec3<S>& w = light.axis;
        const vec3<S>& u = light.width_direction;
        if (simd::any(seen.hard))
            return detail::in_double<detail::EllipseInDouble>(seen.hard, seen.irradiance,
                                                              {c.x, c.y, c.z, w.x, w.y, w.z, u.x, u.y, u.z,
                                                               light.half_width, light.half_height, normal.x, normal.y,
                                                               normal.z, S(light.two_sided ? 1 : 0)});
    }
    return seen.irradiance;
}

namespace detail {

struct EllipseInDouble {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[15]) {
        const vec3<double> c{v[0], v[1], v[2]};
        const EllipseLight<double> light{c,   {1.0, 1.0, 1.0}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, v[9], v[10],
                                         0.0, v[14] != 0.0};
        return irradiance_ellipse<double>(light, c, {v[11], v[12], v[13]});
    }
};

} // namespace detail

} // namespace gonio::shading
