// Irradiance from a uniform one-sided disk of any orientation, exact with horizon clipping.
//
// E/L [sr] in [0, π]. With w = −axis, the centre C = z w + x û and the rim p(t) = C + r(û cos t + v̂ sin t), the
// visible arc t0 … t1 and the horizon arc that closes it give (README.md)
//
//     E/L = F ψ + (n_w − n_u z/x) ω/2 + z n_v ln(|p1|²/|p0|²)/(4x) + ½ ∠(p1, p0),   F = E/(π L) of the whole disk
//
// where ψ and ω are the angles that the arc subtends at the two limiting points of the rim's pencil of circles.
// Everything is computed from the cosine and sine of t0/2 and t1/2, which follow from the heights over the horizon by
// square roots: the angles t themselves are not needed, there are no jumps, and there is no 0/0 on the axis, near the
// rim or in the plane. Distances that cancel near the rim are computed in double and rounded once.
#pragma once

#include <gonio/shading/outline.hpp>

namespace gonio::shading {

namespace detail {

// The disk in its own axes w, û, v̂, mirrored so that n_v ≥ 0; of moderate size.
template<class S>
struct DiskPose {
    S z, x, r;       // z > 0 in front; x ≥ 0
    S inverse_x;     // where x is 0, the inverse of a tiny number
    S gap;           // x − r
    S beyond2;       // x² − r²
    S n_w, n_u, n_v; // the receiver's normal
    S n_across;      // √(n_u² + n_v²)
};

template<class S>
GONIO_FORCE_INLINE DiskPose<S> disk_pose(vec3<S> center, vec3<S> axis, S radius, vec3<S> normal, bool two_sided) {
    const S size = simd::abs(radius);
    const S scale = S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(center), size));
    const vec3<simd::wider<S>> c = widen(center * scale);
    const vec3<simd::wider<S>> a = widen(axis);
    const auto depth = dot(a, c);
    vec3<simd::wider<S>> across = c - a * depth;
    DiskPose<S> d;
    vec3<S> u;
    simd::narrow(across.x, u.x);
    simd::narrow(across.y, u.y);
    simd::narrow(across.z, u.z);
    simd::narrow(-depth, d.z);
    if constexpr (__is_same(S, double)) { // the axis is of unit length within rounding only
        across = across - a * dot(a, across);
        u = across;
    }
    const auto across2 = dot(across, across);
    d.r = size * scale;
    simd::narrow(across2 - simd::widen(d.r) * simd::widen(d.r), d.beyond2);
    S x2;
    simd::narrow(across2, x2);

    d.n_w = -dot(axis, normal);
    constexpr double least = 1e-15;
    [[maybe_unused]] const auto on_axis = x2 < S(least * least);
    d.x = simd::sqrt(simd::max(x2, S(least * least)));
    d.inverse_x = S(1) / d.x;
    d.n_u = dot(mul_add(axis, d.n_w, normal), u) * d.inverse_x; // u may be mostly rounding error along the axis
    d.n_v = simd::abs(dot(normal, fused_cross(axis, u))) * d.inverse_x;
    if constexpr (__is_same(S, double)) {
        if (on_axis) { // û is then arbitrary: along the normal
            d.n_u = length(perpendicular(normal, axis));
            d.n_v = 0.0;
        }
    }
    d.n_across = simd::sqrt(simd::mul_add(d.n_u, d.n_u, d.n_v * d.n_v));
    if (two_sided) {
        d.n_w = simd::select(d.z < S(0), -d.n_w, d.n_w);
        d.z = simd::abs(d.z);
    }
    d.gap = d.beyond2 / (d.x + d.r);
    return d;
}

// The horizon cuts the disk: |k| < m, where k is the height of the centre over the horizon and m = r n_across. `whole`
// is F.
template<class S>
GONIO_FORCE_INLINE S disk_straddling(const DiskPose<S>& d, S k, S m, S near2, S far2, S rim, S whole) {
    // Half angles: t0/2 = (t_c − h)/2 and t1/2 = (t_c + h)/2, where t_c is the direction of n in the disk's plane and
    // cos h = −k/m.
    constexpr double least = 1e-37;
    const S inverse_m = S(0.5) / simd::max(m, S(least));
    const S cos_h = simd::sqrt(simd::min(simd::max((m - k) * inverse_m, S(0)), S(1)));
    const S sin_h = simd::sqrt(simd::min(simd::max((m + k) * inverse_m, S(0)), S(1)));
    const S longer = d.n_across + simd::abs(d.n_u);
    const S larger = simd::sqrt(simd::min(longer * d.r * inverse_m, S(1)));
    const S smaller = d.n_v * larger / simd::max(longer, S(least));
    const auto towards = d.n_u >= S(0);
    const S cos_c = simd::select(towards, larger, smaller);
    const S sin_c = simd::select(towards, smaller, larger);
    const S cos0 = simd::mul_add(cos_c, cos_h, sin_c * sin_h);
    const S cos1 = simd::mul_add(cos_c, cos_h, -(sin_c * sin_h));
    const S sin0 = simd::mul_add(sin_c, cos_h, -(cos_c * sin_h));
    const S sin1 = simd::mul_add(sin_c, cos_h, cos_c * sin_h);

    // |p|² = near² + 2e cos²(t/2).
    const S e = S(2) * d.x * d.r;
    const S square0 = simd::mul_add(S(2) * e, cos0 * cos0, near2);
    const S square1 = simd::mul_add(S(2) * e, cos1 * cos1, near2);

    const S psi = simd::atan2_above(rim * simd::max(simd::mul_add(sin1, cos0, -(cos1 * sin0)), S(0)),
                                    simd::mul_add(far2 * cos0, cos1, near2 * sin0 * sin1));
    // 1 + β exp(it) times (1 + β)(q + rim)/2 is (a, b) with β = e/(q + rim).
    const S q = simd::mul_add(d.x, d.x, simd::mul_add(d.z, d.z, d.r * d.r));
    const S grow = simd::mul_add(e, e / (q + rim), e);
    const S a0 = simd::mul_add(grow, cos0 * cos0, rim);
    const S a1 = simd::mul_add(grow, cos1 * cos1, rim);
    const S b0 = grow * cos0 * sin0;
    const S b1 = grow * cos1 * sin1;
    const S omega = simd::atan2(simd::mul_add(b1, a0, -(b0 * a1)), simd::mul_add(a0, a1, b0 * b1));

    const S turn_u = (cos1 - cos0) * (cos1 + cos0); // half of cos t1 − cos t0
    const S squares = square0 + square1;
    const S g = S(-2) * e * turn_u / squares; // ≥ 0; atanh g = ½ ln(|p0|²/|p1|²)
    const auto steep = g > S(0.5);
    S ratio = simd::atanh_ratio(simd::min(g * g, S(0.25)));
    if (simd::any(steep)) {
        constexpr double half_ln_2 = 0.34657359027997265471;
        const S logarithm = S(half_ln_2) * simd::log2(square0 / simd::max(square1, S(least)));
        ratio = simd::select(steep, logarithm / simd::max(g, S(0.5)), ratio);
    }
    const S slope = S(2) * d.r * d.z * d.n_v * turn_u * ratio / squares;

    const S turn_v = simd::mul_add(cos1, sin1, -(cos0 * sin0));
    const S two_r = d.r + d.r;
    // From p1, the nearer point: as a sum from p0 its position would be lost to rounding.
    const vec3<S> from{d.z, simd::mul_add(two_r, cos1 * cos1, d.gap), two_r * cos1 * sin1};
    const vec3<S> step{S(0), -(two_r * turn_u), -(two_r * turn_v)};
    const S across = S(0.5) * omega * (d.n_w - d.n_u * d.z * d.inverse_x);
    return (simd::mul_add(whole, psi, across) + slope) + horizon_arc(from, step, {d.n_w, d.n_u, d.n_v});
}

// The smallest height over the light that counts as different from 0, relative to the size of the scene: its square is
// a normal number.
template<class S>
inline constexpr double least_disk_height = 0x1p-60;
template<>
inline constexpr double least_disk_height<double> = 0x1p-500;

struct DiskInDouble;

// E/L of a disk entirely above the horizon, in front of it and apart from the rim; the other lanes are marked hard.
// Float is enough: without separate n_u and n_v nothing is divided by x, and a difference is small only if the light
// itself subtends a small angle.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_disk_above(vec3<S> center, vec3<S> axis, S radius, vec3<S> normal, bool two_sided) {
    constexpr double pi = 3.14159265358979323846;
    const S size = simd::abs(radius);
    const S scale = S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(center), size));
    const vec3<S> c = center * scale;
    const S r = size * scale;
    const S depth = dot(axis, c);
    const S facing = dot(axis, normal);
    const vec3<S> across = mul_add(axis, -depth, c);
    const vec3<S> tilt = mul_add(axis, -facing, normal);
    const S x_n_u = dot(tilt, across);
    const S height = simd::mul_add(depth, facing, x_n_u);
    const S r2 = r * r;
    const S x2 = dot(across, across);
    const S z2 = depth * depth;
    const S q = x2 + (r2 + z2);
    const S rim2 = simd::mul_add(q, q, S(-4) * x2 * r2); // product of the rim's squared nearest and farthest distances
    const auto above = simd::both(height > S(0), height * height >= r2 * dot(tilt, tilt));
    const auto apart = simd::both(rim2 > S(0.04) * q * q, r2 > S(0));
    auto easy = simd::both(above, apart);
    S z = -depth;
    S n_w = -facing;
    if (two_sided) {
        n_w = simd::select(z < S(0), facing, n_w);
        z = simd::abs(z);
    }
    easy = simd::both(easy, simd::both(z > S(0), z2 > S(1e-11) * q)); // certainly in front
    if (!simd::any(easy)) return {S(0), !easy};
    const S rim = simd::sqrt(simd::max(rim2, S(1e-30)));
    // Y as in survey_disk; its denominator is left to the single division.
    const S behind = (x2 - r2) - z2;
    const S sum = rim + simd::abs(behind);
    const auto is_behind = behind > S(0);
    const S y = simd::select(is_behind, S(4) * x2 * z2, sum);
    const S divisor = simd::select(is_behind, sum, S(1));
    const S numerator = simd::mul_add(n_w, y, S(2) * z * x_n_u * divisor);
    return {clamp_irradiance(S(pi) * r2 * numerator / (divisor * rim * (rim + q))), !easy};
}

// As irradiance_disk, except in the hard lanes.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_disk(vec3<S> center, vec3<S> axis, S radius, vec3<S> normal, bool two_sided) {
    DiskPose<S> d = disk_pose(center, axis, radius, normal, two_sided);
    const S k = simd::mul_add(d.z, d.n_w, d.x * d.n_u);
    const S m = d.r * d.n_across;
    // Points that rounding leaves undecided count as lit: beside the rim they may see half of the light.
    const S slack = S(__is_same(S, double) ? 1e-15 : 1e-6) * (d.x + d.r + simd::abs(d.z));
    const auto in_front = simd::both(d.z > S(0), d.r > S(0));
    const auto lit = simd::both(in_front, k > -m - slack);
    // Near the axis, which is of unit length within rounding only, û needs a second step; without it m is wrong too.
    const auto axial = simd::both(in_front, d.x * d.x < S(1e-8) * d.z * d.z);
    S easy = S(0);
    if (simd::any(d.z == S(0))) {
        const auto touching = simd::both(d.z == S(0), d.beyond2 < S(0));
        easy = simd::select(touching, clamp_irradiance(S(1.57079632679489661923) * (S(1) + d.n_w)), S(0));
    }
    if (!simd::any(lit)) return {easy, axial};
    d.z = simd::max(d.z, S(least_disk_height<S>));
    const S z2 = d.z * d.z;
    const S near2 = simd::mul_add(d.gap, d.gap, z2);
    const S far = d.x + d.r;
    const S far2 = simd::mul_add(far, far, z2);
    const S rim = simd::sqrt(near2) * simd::sqrt(far2); // the distances of the rim's nearest and farthest point
    const S r2 = d.r * d.r;
    const S q = simd::mul_add(d.x, d.x, r2 + z2);
    // Y = rim + z² + r² − x², without cancellation.
    const S behind = d.beyond2 - z2;
    const S sum = rim + simd::abs(behind);
    const S y = simd::select(behind > S(0), S(4) * d.x * d.x * z2 / sum, sum);
    const S whole = r2 * simd::mul_add(d.n_w, y, S(2) * d.x * d.z * d.n_u) / (rim * (rim + q));
    // Where the arcs turn by the rounding error of the distance to the rim.
    const auto close = simd::either(near2 < S(9e-7) * r2, simd::both(z2 < S(1e-7) * r2, near2 < S(4e-3) * r2));
    constexpr double pi = 3.14159265358979323846;
    const auto straddling = simd::both(lit, k < m);
    S e = S(pi) * whole;
    if (simd::any(straddling)) e = simd::select(straddling, disk_straddling(d, k, m, near2, far2, rim, whole), e);
    return {simd::select(lit, clamp_irradiance(e), easy), simd::either(simd::both(lit, close), axial)};
}

} // namespace detail

// E/L [sr] of a disk about `center` [m, from the receiver] that emits towards +`axis` only; `axis` and the receiver's
// `normal` are unit. 0 behind its plane. In the plane: inside the rim the limit π(1 + n·w)/2 from the front, w = −axis;
// outside the rim 0. Any finite input; a negative radius counts as positive; 0 gives 0. In float and packs, receivers
// within 1e-3 of the radius from the rim, or lower than 3e-4 and within 0.06, or 1e-4 of the distance from the axis,
// are evaluated in double, lane by lane. `two_sided`: it emits to both sides, and the receiver sees the side it is on.
template<class S>
GONIO_FORCE_INLINE S irradiance_disk(vec3<S> center, vec3<S> axis, S radius, vec3<S> normal, bool two_sided = false) {
    if constexpr (!__is_same(S, double)) {
        const auto above = detail::survey_disk_above(center, axis, radius, normal, two_sided);
        if (!simd::any(above.hard)) return above.irradiance;
    }
    const auto disk = detail::survey_disk(center, axis, radius, normal, two_sided);
    const S e = disk.irradiance;
    if constexpr (!__is_same(S, double)) {
        if (simd::any(disk.hard))
            return detail::in_double<detail::DiskInDouble>(disk.hard, e,
                                                           {center.x, center.y, center.z, axis.x, axis.y, axis.z,
                                                            radius, normal.x, normal.y, normal.z,
                                                            S(two_sided ? 1 : 0)});
    }
    return e;
}

namespace detail {

struct DiskInDouble {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[11]) {
        return irradiance_disk<double>({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6], {v[7], v[8], v[9]}, v[10] != 0.0);
    }
};

} // namespace detail

} // namespace gonio::shading
