// Irradiance from a uniform one-sided disk of any orientation, exact with horizon clipping.
//
// E/L [sr] in [0, π]. With w = −axis, the centre C = z w + x û and p(t) = C + r(û cos t + v̂ sin t), the contour
// integral over the visible arc has an elementary antiderivative. It is taken here with the denominator
// |p|² = q + e cos t expanded about β = e/(q + S), which leaves no angle that jumps and no 0/0 on the axis, near the
// rim or in the plane; the usual arctangent of a scaled half-angle tangent loses up to 9 % there in double. README.md.
#pragma once

#include <gonio/shading/outline.hpp>

namespace gonio::shading {

namespace detail {

// What both forms of the disk are made of, in its own axes w, û, v̂.
template<class S>
struct DiskParts {
    S z, x, r;       // scaled to moderate size; z > 0 in front
    S n_w, n_u, n_v; // the receiver's normal
    S k, m;          // height of the rim over the horizon: k + m cos(t − t_c)
    S q, rim;        // z² + x² + r², and the product of the distances to the nearest and farthest point of the rim
    S nearest2;      // z² + (x − r)²
};

template<class S>
GONIO_FORCE_INLINE DiskParts<S> disk_parts(vec3<S> center, vec3<S> axis, S radius, vec3<S> normal) {
    const S size = simd::abs(radius);
    const S scale = S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(center), size));
    const vec3<S> c = center * scale;
    const S r = size * scale;
    const S z = -dot(axis, c);
    const vec3<S> across = perpendicular(c, axis);
    const S x = length(across);
    const S n_w = -dot(axis, normal);
    const vec3<S> n_across = perpendicular(normal, axis);
    const S inverse = reciprocal_or_zero(x);
    const auto on_axis = x == S(0); // û is then free: along the normal
    const S n_u = simd::select(on_axis, length(n_across), dot(n_across, across) * inverse);
    const S n_v = simd::select(on_axis, S(0), -dot(n_across, cross(axis, across)) * inverse);
    const S gap = x - r;
    const S nearest2 = z * z + gap * gap;
    const S rim = simd::sqrt(nearest2) * simd::sqrt(z * z + (x + r) * (x + r));
    return {z, x, r, n_w, n_u, n_v, z * n_w + x * n_u, r * length(n_across), x * x + z * z + r * r, rim, nearest2};
}

// The whole disk above the horizon.
template<class S>
GONIO_FORCE_INLINE S disk_above(const DiskParts<S>& d) {
    const S z2 = d.z * d.z;
    const S r2 = d.r * d.r;
    const S x2 = d.x * d.x;
    const auto outside = x2 > z2 + r2;
    const S sum = d.rim + simd::abs(x2 - z2 - r2);
    const S y = simd::select(outside, S(4) * x2 * z2 * reciprocal_or_zero(sum), sum);
    const S numerator = S(3.14159265358979323846) * r2 * (d.n_w * y + S(2) * d.x * d.z * d.n_u);
    return clamp_irradiance(numerator * reciprocal_or_zero(d.rim * (d.rim + d.q)));
}

GONIO_FORCE_INLINE double atan_ratio(double y) {
    return y == 0.0 ? 1.0 : simd::atan(y) / y;
}

GONIO_FORCE_INLINE double log1p_ratio(double y) {
    return y == 0.0 ? 1.0 : __builtin_log1p(y) / y;
}

// The horizon cuts the disk: |k| < m.
GONIO_FORCE_INLINE double disk_straddling(const DiskParts<double>& d) {
    if (d.rim == 0.0) return 0.0;
    const double e = 2.0 * d.x * d.r;
    const double beta = e / (d.q + d.rim);
    const double middle = simd::atan2(d.n_v, d.n_u);
    const double half = simd::atan2(simd::sqrt((d.m - d.k) * (d.m + d.k)), -d.k);
    const double t0 = middle - half;
    const double t1 = middle + half;
    const auto j = [&](double t) __attribute__((always_inline)) {
        const double slope = simd::sin(t) / (1.0 + beta * simd::cos(t));
        return slope * atan_ratio(beta * slope);
    };
    const double a = d.r * d.r * d.n_w;
    const double b = d.r * (d.x * d.n_w - d.z * d.n_u);
    const double k = -d.r * d.z * d.n_v;
    const double along = j(t1) - j(t0);
    const double cos_half_t0 = simd::cos(0.5 * t0);
    const double c = -2.0 * simd::sin(middle) * simd::sin(half) / (d.nearest2 + 2.0 * e * cos_half_t0 * cos_half_t0);
    const double sum = a * (2.0 * half - 2.0 * beta * along) / d.rim +
                       b * (2.0 * d.q * along / (d.rim * (d.q + d.rim)) - 2.0 * half * e / (d.rim * (d.rim + d.q))) -
                       k * c * log1p_ratio(e * c);
    // The horizon arc from p(t1) to p(t0), in w, û, v̂.
    const vec3<double> from{d.z, d.x + d.r * simd::cos(t1), d.r * simd::sin(t1)};
    const double turn = 2.0 * simd::sin(half);
    const vec3<double> step{0.0, d.r * simd::sin(middle) * turn, -d.r * simd::cos(middle) * turn};
    return clamp_irradiance(0.5 * sum + horizon_arc(from, step));
}

struct ExactDisk {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[10]) {
        const DiskParts<double> d =
            disk_parts<double>({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6], {v[7], v[8], v[9]});
        if (d.z == 0.0 && d.x < d.r) return clamp_irradiance(1.57079632679489661923 * (1.0 + d.n_w));
        if (!(d.z > 0.0) || d.k <= -d.m) return 0.0;
        return d.k >= d.m ? disk_above(d) : disk_straddling(d);
    }
};

} // namespace detail

// E/L [sr] of a disk about `center` [m, from the receiver] that emits towards +`axis` only; `axis` and the receiver's
// `normal` are unit. Behind its plane 0; in the plane, inside the rim, the limit π(1 + n·w)/2 from the front,
// w = −axis, and outside 0. Any finite input; a negative radius counts as positive; 0 gives 0. In float and packs,
// disks that the horizon cuts and receivers close to the rim are evaluated in double, lane by lane.
template<class S>
GONIO_FORCE_INLINE S irradiance_disk(vec3<S> center, vec3<S> axis, S radius, vec3<S> normal) {
    if constexpr (__is_same(S, double)) {
        return detail::ExactDisk::evaluate(
            {center.x, center.y, center.z, axis.x, axis.y, axis.z, radius, normal.x, normal.y, normal.z});
    } else {
        const detail::DiskParts<S> d = detail::disk_parts(center, axis, radius, normal);
        // Rounding of the sides of the comparisons, generously; what it leaves open is decided in double.
        const S slack = S(4e-6) * (d.z + d.x + d.r);
        const auto maybe_lit = simd::both(d.z > -slack, d.k > -d.m - slack);
        const auto easy = simd::both(simd::both(d.z > slack, d.k > d.m + slack), d.rim > S(0.1) * d.q);
        const auto hard = simd::both(maybe_lit, !easy);
        const S above = simd::select(easy, detail::disk_above(d), S(0));
        if (!simd::any(hard)) return above;
        return detail::in_double<detail::ExactDisk>(
            hard, above, {center.x, center.y, center.z, axis.x, axis.y, axis.z, radius, normal.x, normal.y, normal.z});
    }
}

} // namespace gonio::shading
