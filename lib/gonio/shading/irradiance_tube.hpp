// Irradiance from a uniform capsule (a tube with hemispherical ends), exact with horizon clipping.
//
// E/L [sr] in [0, π]. Seen from outside, its outline is two great arcs (the tangent planes through the receiver) and
// two arcs of the end spheres' circles. In the frame a (axis), f (from the receiver to the axis line, distance D), g =
// a × f, with s = r/D and κ = √(1 − s²), the tangent planes have the unit normals −m±, m± = ±κ g − s f, and both great
// arcs span the same angle θ. Summing all four arcs where nothing is cut leaves a form without cancellation
// (`tube_above`). Where the horizon cuts, the arcs are walked in order. README.md derives both.
#pragma once

#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/outline.hpp>

namespace gonio::shading {

namespace detail {

template<class S>
struct TubeParts {
    S r, l;             // scaled to moderate size
    S z0, z1;           // of the end centres along the axis
    S d;                // D
    S gap2;             // D² − r²
    S n_a, n_f, n_g;    // the receiver's normal
    vec3<S> end0, end1; // end centres
};

template<class S>
GONIO_FORCE_INLINE TubeParts<S> tube_parts(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const S size = simd::abs(radius);
    const S span = simd::abs(length_m);
    const S scale =
        S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(center), simd::max(size, span)));
    const vec3<S> c = center * scale;
    const S r = size * scale;
    const S l = span * scale;
    const S z = dot(axis, c);
    const vec3<S> across = perpendicular(c, axis);
    const S d = length(across);
    const vec3<S> f = across * reciprocal_or_zero(d);
    const vec3<S> half = axis * (S(0.5) * l);
    return {r,
            l,
            z - S(0.5) * l,
            z + S(0.5) * l,
            d,
            simd::difference_of_squares(across.x, across.y, across.z, r),
            dot(normal, axis),
            dot(normal, f),
            dot(normal, cross(axis, f)),
            c - half,
            c + half};
}

// The whole capsule above the horizon, D > r. The arcs' sum: ends' circles by their azimuths h, great arcs θ s n·f, and
// what is left of the circles' and arcs' slopes, joined over one denominator.
template<class S>
GONIO_FORCE_INLINE S tube_above(const TubeParts<S>& t) {
    const S d2 = t.d * t.d;
    const S square0 = d2 + t.z0 * t.z0;
    const S square1 = d2 + t.z1 * t.z1;
    const S gap = simd::sqrt(simd::max(t.gap2, S(0)));
    const S inverse_d = reciprocal_or_zero(t.d);
    const S s = simd::min(t.r * inverse_d, S(1));
    const S kappa = gap * inverse_d;
    const S theta = simd::atan2(gap * t.l, simd::mul_add(t.z0, t.z1, t.gap2));
    const S inverse0 = reciprocal_or_zero(square0);
    const S inverse1 = reciprocal_or_zero(square1);
    const S h0 = simd::atan2(simd::sqrt(square0) * kappa, -s * t.z0);
    const S h1 = simd::atan2(simd::sqrt(square1) * kappa, s * t.z1);
    // n·P / |P|³ of the ends, each times r² h.
    const S cap0 = h0 * (t.d * t.n_f + t.z0 * t.n_a) * inverse0 * simd::sqrt(inverse0);
    const S cap1 = h1 * (t.d * t.n_f + t.z1 * t.n_a) * inverse1 * simd::sqrt(inverse1);
    const S slope = t.d * t.n_a * (t.z0 + t.z1) + t.n_f * (d2 - t.z0 * t.z1);
    return clamp_irradiance(theta * s * t.n_f + t.r * t.r * (cap0 + cap1) +
                            t.r * kappa * t.l * slope * inverse0 * inverse1);
}

// A point where the horizon cuts the outline, in (f, a, g): from the receiver, and from the light's centre.
struct Crossing {
    vec3<double> direct, offset;
};

// The visible part of an outline, arc by arc in its order.
struct OutlineWalk {
    vec3<double> center;
    bool far = false; // the offsets then know the angle between two crossings better than the points themselves
    double sum = 0.0;
    bool below = false;      // sunk, and not risen since
    bool rose_first = false; // began below the horizon
    Crossing sank_at{};
    Crossing first_rise{};

    GONIO_FORCE_INLINE void close(const Crossing& at) {
        sum += far ? horizon_arc(center + sank_at.offset, at.offset - sank_at.offset)
                   : 0.5 * simd::atan2(length(cross(sank_at.direct, at.direct)), dot(sank_at.direct, at.direct));
    }
    GONIO_FORCE_INLINE void sink(const Crossing& at) {
        sank_at = at;
        below = true;
    }
    GONIO_FORCE_INLINE void rise(const Crossing& at) {
        if (below) {
            close(at);
        } else {
            first_rise = at;
            rose_first = true;
        }
        below = false;
    }
    GONIO_FORCE_INLINE void finish() {
        if (below && rose_first) close(first_rise);
    }
};

GONIO_FORCE_INLINE double wrapped(double angle) {
    constexpr double turn = 6.28318530717958647693;
    return angle - turn * __builtin_floor(angle / turn + 0.5);
}

// One of the great arcs: the points (base, z, side) for z from `from` to `to`; n·m = −`slope`. Their height over the
// horizon is z n_a + lift.
GONIO_FORCE_INLINE void walk_great_arc(OutlineWalk& walk, const TubeParts<double>& t, double from, double to,
                                       double base, double side, double slope) {
    const double lift = base * t.n_f + side * t.n_g;
    const bool from_above = from * t.n_a + lift >= 0.0;
    const bool to_above = to * t.n_a + lift >= 0.0;
    if (!from_above && !to_above) return;
    double crossing = from;
    if (from_above != to_above)
        crossing = simd::max(simd::min(-lift / t.n_a, simd::max(from, to)), simd::min(from, to));
    const double first = from_above ? from : crossing;
    const double last = to_above ? to : crossing;
    const double angle = simd::atan2(simd::sqrt(t.gap2) * simd::abs(last - first), t.gap2 + first * last);
    walk.sum += 0.5 * angle * slope;
    const Crossing at{{base, crossing, side}, {-t.r * (t.r / t.d), crossing - walk.center.y, side}};
    if (!from_above) walk.rise(at);
    if (!to_above) walk.sink(at);
}

// An end's circle, from azimuth −h to h; `u` and `v` in (f, a, g).
struct EndCircle {
    vec3<double> offset; // of the sphere's centre from the light's
    vec3<double> axis, u, v;
    double radius, sine, cosine, half;
    double n_axis, n_u, n_v;
};

GONIO_FORCE_INLINE void walk_end(OutlineWalk& walk, const EndCircle& end, bool from_above, bool to_above) {
    constexpr double pi = 3.14159265358979323846;
    const double m = end.sine * simd::sqrt(end.n_u * end.n_u + end.n_v * end.n_v);
    const double k = end.cosine * end.n_axis;
    const double middle = simd::atan2(end.n_v, end.n_u); // of what is above the horizon
    const double reach = simd::atan2(simd::sqrt(simd::max((m - k) * (m + k), 0.0)), -k);
    const double hidden = pi - reach;
    const double h = end.half;
    const auto arc = [&](double from, double to) __attribute__((always_inline)) {
        walk.sum += cap_arc(end.sine, end.cosine, end.n_axis, end.n_u, end.n_v, from, to);
    };
    const auto at = [&](double phi) __attribute__((always_inline)) {
        const vec3<double> round = end.u * simd::cos(phi) + end.v * simd::sin(phi);
        return Crossing{end.axis * end.cosine + round * end.sine,
                        end.offset + (round * end.cosine - end.axis * end.sine) * end.radius};
    };
    // Of the visible and the hidden part the smaller is put beside the end that is in it: no ambiguous turn.
    if (from_above && to_above) {
        const double dip = wrapped(middle + pi);
        if (hidden > 0.0 && simd::abs(dip) < h) {
            const double sinks = simd::max(dip - hidden, -h);
            const double rises = simd::min(dip + hidden, h);
            arc(-h, sinks);
            walk.sink(at(sinks));
            walk.rise(at(rises));
            arc(rises, h);
        } else {
            arc(-h, h);
        }
    } else if (from_above) {
        const double sinks = hidden > reach ? -h + wrapped(middle + h) + reach : h + wrapped(middle + pi - h) - hidden;
        const double phi = simd::max(simd::min(sinks, h), -h);
        arc(-h, phi);
        walk.sink(at(phi));
    } else if (to_above) {
        const double rises = hidden > reach ? h + wrapped(middle - h) - reach : -h + wrapped(middle + pi + h) + hidden;
        const double phi = simd::max(simd::min(rises, h), -h);
        walk.rise(at(phi));
        arc(phi, h);
    } else {
        const double bump = wrapped(middle);
        if (reach > 0.0 && simd::abs(bump) < h) {
            const double rises = simd::max(bump - reach, -h);
            const double sinks = simd::min(bump + reach, h);
            walk.rise(at(rises));
            arc(rises, sinks);
            walk.sink(at(sinks));
        }
    }
}

GONIO_FORCE_INLINE double tube_straddling(const TubeParts<double>& t) {
    const double gap = simd::sqrt(t.gap2);
    const double s = simd::min(t.r / t.d, 1.0);
    const double kappa = gap / t.d;
    const double d0 = simd::sqrt(t.d * t.d + t.z0 * t.z0);
    const double d1 = simd::sqrt(t.d * t.d + t.z1 * t.z1);
    const double up0 = t.d * t.n_f + t.z0 * t.n_a;
    const double up1 = t.d * t.n_f + t.z1 * t.n_a;
    const double plus = kappa * t.n_g - s * t.n_f; // n·m±
    const double minus = -kappa * t.n_g - s * t.n_f;

    // The tangent points are (base, z_i, ±side): D − r s = D κ².
    const double base = gap * kappa;
    const double side = t.r * kappa;
    OutlineWalk walk{{t.d, 0.5 * (t.z0 + t.z1), 0.0}, t.d * t.d + t.z0 * t.z1 > t.r * t.r + t.l * t.l};
    const double cos0 = simd::sqrt(t.gap2 + t.z0 * t.z0) / d0;
    const double cos1 = simd::sqrt(t.gap2 + t.z1 * t.z1) / d1;
    const auto above = [&](double z, double g) __attribute__((always_inline)) {
        return z * t.n_a + (base * t.n_f + g * t.n_g) >= 0.0;
    };

    walk_great_arc(walk, t, t.z0, t.z1, base, side, -plus);
    walk_end(walk,
             {{0.0, t.z1 - walk.center.y, 0.0},
              {t.d / d1, t.z1 / d1, 0.0},
              {-t.z1 / d1, t.d / d1, 0.0},
              {0.0, 0.0, -1.0},
              t.r,
              t.r / d1,
              cos1,
              simd::atan2(d1 * kappa, s * t.z1),
              up1 / d1,
              (t.d * t.n_a - t.z1 * t.n_f) / d1,
              -t.n_g},
             above(t.z1, side), above(t.z1, -side));
    walk_great_arc(walk, t, t.z1, t.z0, base, -side, -minus);
    walk_end(walk,
             {{0.0, t.z0 - walk.center.y, 0.0},
              {t.d / d0, t.z0 / d0, 0.0},
              {t.z0 / d0, -t.d / d0, 0.0},
              {0.0, 0.0, 1.0},
              t.r,
              t.r / d0,
              cos0,
              simd::atan2(d0 * kappa, -s * t.z0),
              up0 / d0,
              (t.z0 * t.n_f - t.d * t.n_a) / d0,
              t.n_g},
             above(t.z0, -side), above(t.z0, side));
    walk.finish();
    return clamp_irradiance(walk.sum);
}

struct ExactTube {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[11]) {
        const vec3<double> normal{v[8], v[9], v[10]};
        const TubeParts<double> t = tube_parts<double>({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6], v[7], normal);
        if (!(t.r > 0.0)) return 0.0;
        const double beyond = simd::max(simd::max(t.z0, -t.z1), 0.0);
        if (t.gap2 + beyond * beyond < 0.0) return 3.14159265358979323846;
        // Beyond an end and within the prolonged tube, the nearer sphere hides the rest.
        if (t.gap2 <= 0.0 && beyond > 0.0) return irradiance_sphere(t.z0 > 0.0 ? t.end0 : t.end1, t.r, normal);
        TubeParts<double> on = t;
        // On the surface the tangent points fall together; a trace apart, they keep their order.
        on.gap2 = simd::max(t.gap2, 1e-24 * t.d * t.d);
        const double up0 = dot(normal, t.end0);
        const double up1 = dot(normal, t.end1);
        if (up0 <= -t.r && up1 <= -t.r) return 0.0;
        return up0 >= t.r && up1 >= t.r ? tube_above(on) : tube_straddling(on);
    }
};

} // namespace detail

// E/L [sr] of a capsule about `center` [m, from the receiver] along `axis`: a cylinder of `length_m` without its ends,
// which are half spheres of the same radius. `axis` and the receiver's `normal` are unit. Inside π; on the surface the
// limit π(1 + n·l)/2 from outside. Any finite input; negative sizes count as positive; radius 0 gives 0, length 0 the
// sphere. In float and packs, capsules that the horizon cuts and receivers near the surface or the prolonged tube are
// evaluated in double, lane by lane.
template<class S>
GONIO_FORCE_INLINE S irradiance_tube(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    if constexpr (__is_same(S, double)) {
        return detail::ExactTube::evaluate(
            {center.x, center.y, center.z, axis.x, axis.y, axis.z, radius, length_m, normal.x, normal.y, normal.z});
    } else {
        const detail::TubeParts<S> t = detail::tube_parts(center, axis, radius, length_m, normal);
        const S up0 = dot(normal, t.end0);
        const S up1 = dot(normal, t.end1);
        const S lower = simd::min(up0, up1);
        const S slack = S(4e-6) * (t.d + simd::abs(t.z0) + simd::abs(t.z1) + t.r);
        const auto maybe_lit = simd::both(t.r > S(0), simd::max(up0, up1) > -t.r - slack);
        const auto clear = t.gap2 > S(0.25) * t.r * t.r + S(1e-4) * t.z0 * t.z1;
        const auto easy = simd::both(clear, simd::both(lower > t.r + slack, t.r > S(0)));
        const auto hard = simd::both(maybe_lit, !easy);
        const S above = simd::select(easy, detail::tube_above(t), S(0));
        if (!simd::any(hard)) return above;
        return detail::in_double<detail::ExactTube>(
            hard, above,
            {center.x, center.y, center.z, axis.x, axis.y, axis.z, radius, length_m, normal.x, normal.y, normal.z});
    }
}

} // namespace gonio::shading
