// Irradiance from the side of a uniform cylinder: no caps, seen from outside. Exact with horizon clipping.
//
// E/L [sr] in [0, π]. In the frame f (from the receiver to the axis line, distance D), a (axis), g = a × f, the half
// plane at the azimuth α about a parallel to the axis through the receiver meets the near side along one line, at the
// distance ρ(α), for |sin α| ≤ r/D. In it the light spans the elevations β0 to β1, tan β = z/ρ, or from the horizon to
// β1, and with N = n_f cos α + n_g sin α
//
//     dE/dα = L ∫ (N cos β + n_a sin β) cos β dβ
//           = ½ [ N (Δβ − sin Δβ) + tan(Δβ/2) m_ρ (N m_ρ + n_a m_z) ],   m = e(β0) + e(β1)
//
// where e(β) = (cos β, sin β): a sum of terms in which nothing cancels, because the middle of the visible part is above
// the horizon. What is left is an integral over one variable. With the azimuth φ on the cylinder, sin(φ/2) = κ sinh u
// and κ = (D − r)/(2√(Dr)), the distance is ρ = (D − r) cosh u: the peak of a receiver beside the surface gets a width
// of 1 at any distance, and no singularity is nearer to the real u than π/2. Rules of Gauss converge like powers then;
// README.md has the errors. Beyond an end and within the prolonged cylinder (D ≤ r), nothing is seen.
#pragma once

#include <gonio/shading/lights.hpp>
#include <gonio/shading/outline.hpp>
#include <gonio/shading/seen_from.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <cstddef>

namespace gonio::shading {

// The side of a cylinder without its caps, luminous outside.
template<class S>
struct CylinderLight {
    vec3<S> center;    // [m]
    vec3<S> luminance; // [nt], three channels
    vec3<S> axis;      // unit
    S radius, length;  // [m]
    S inverse_range;   // [1/m]; 0 = no window

    // For highlights: the rectangle between the lines where the tangent planes touch. From the side it is the outline;
    // its ends are moved so that it has the solid angle, up to the second order of the light's width.
    static constexpr bool is_seen_approximately = true;
    GONIO_FORCE_INLINE Seen<RectangleLight<S>, S> seen_from(vec3<S> to_center) const;
};

namespace detail {

template<class S>
GONIO_FORCE_INLINE S largest_size(const CylinderLight<S>& light) {
    return simd::max(simd::abs(light.radius), simd::abs(light.length));
}

// How far the cylinder reaches from its centre along the receiver's normal, up and down.
template<class S>
GONIO_FORCE_INLINE S reach(const CylinderLight<S>& light, vec3<S> normal) {
    const S along = dot(normal, light.axis);
    const S across = simd::sqrt(simd::max(S(1) - along * along, S(0)));
    return simd::mul_add(simd::abs(along), S(0.5) * simd::abs(light.length), across * simd::abs(light.radius));
}

// In (f, a, g); mirrored, of moderate size.
template<class S>
struct CylinderPose {
    S r, d;          // radius; D, the distance of the axis line
    S gap;           // D − r
    S z0, z1;        // the ends along the axis
    S length;        // z1 − z0 to its last digit
    S n_f, n_a, n_g; // the receiver's normal; n_a, n_g ≥ 0
    S up;            // height of the centre over the receiver's plane
};

template<class S>
GONIO_FORCE_INLINE CylinderPose<S> cylinder_pose(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const S size = simd::abs(radius);
    const S span = simd::abs(length_m);
    const S scale =
        S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(center), simd::max(size, span)));
    const vec3<simd::wider<S>> c = widen(center * scale);
    const vec3<simd::wider<S>> a = widen(axis);
    const auto depth = dot(a, c);
    vec3<simd::wider<S>> across = c - a * depth;
    if constexpr (__is_same(S, double)) across = across - a * dot(a, across); // the axis is unit within rounding only
    CylinderPose<S> p;
    p.r = size * scale;
    p.length = span * scale;
    vec3<S> f;
    S z;
    S z_rest; // its rounding error
    S gap2;
    simd::narrow(across.x, f.x);
    simd::narrow(across.y, f.y);
    simd::narrow(across.z, f.z);
    simd::narrow(depth, z);
    simd::narrow(depth - simd::widen(z), z_rest);
    simd::narrow(dot(across, across) - simd::widen(p.r) * simd::widen(p.r), gap2);
    const S n_a = dot(normal, axis);
    const S side = simd::copysign(S(1), n_a); // mirrored along the axis where n_a < 0
    z = z * side;
    p.n_a = simd::abs(n_a);
    p.z0 = (z - S(0.5) * p.length) + z_rest * side; // where this cancels, the difference is exact
    p.z1 = (z + S(0.5) * p.length) + z_rest * side;
    constexpr double least = 1e-15;
    p.d = simd::sqrt(simd::max(dot(f, f), S(least * least)));
    const S inverse_d = S(1) / p.d;
    p.gap = gap2 / (p.d + p.r);
    p.n_f = dot(mul_add(axis, -n_a, normal), f) * inverse_d;
    p.n_g = simd::abs(dot(normal, fused_cross(axis, f))) * inverse_d;
    p.up = simd::mul_add(p.d, p.n_f, z * p.n_a);
    return p;
}

// x − sin x, without cancellation; x in [0, π].
template<class S>
GONIO_FORCE_INLINE S minus_sine(S x, S sine) {
    const S t = x * x;
    if constexpr (__is_same(S, double)) {
        if (x > 1.0) return x - sine;
        double sum = 1.0;
        for (int k = 18; k > 3; k -= 2)
            sum = 1.0 - t / (k * (k + 1)) * sum;
        return x * t / 6.0 * sum;
    } else {
        const S series = simd::mul_add(t, simd::mul_add(t, S(1.0 / 5040.0), S(-1.0 / 120.0)), S(1.0 / 6.0));
        return simd::select(x < S(0.5), x * t * series, x - sine);
    }
}

// dE/dα of a half plane: `n_across` is N, ρ the distance of the line that it meets. With `clipped`, above the horizon
// alone.
template<bool clipped, class S>
GONIO_FORCE_INLINE S cylinder_slice(const CylinderPose<S>& p, S n_across, S rho) {
    const S rho2 = rho * rho;
    const S inverse0 = S(1) / simd::sqrt(simd::mul_add(p.z0, p.z0, rho2));
    const S inverse1 = S(1) / simd::sqrt(simd::mul_add(p.z1, p.z1, rho2));
    S low_rho = rho * inverse0;
    S low_z = p.z0 * inverse0;
    const S high_rho = rho * inverse1;
    const S high_z = p.z1 * inverse1;
    S sine = rho * p.length * inverse0 * inverse1;
    S cosine = simd::mul_add(p.z0, p.z1, rho2) * inverse0 * inverse1;
    if constexpr (clipped) {
        const S up1 = simd::mul_add(n_across, high_rho, p.n_a * high_z);
        if (!(up1 > S(0))) return S(0);
        if (simd::mul_add(n_across, low_rho, p.n_a * low_z) < S(0)) {
            const S inverse = S(1) / simd::sqrt(simd::mul_add(n_across, n_across, p.n_a * p.n_a));
            low_rho = p.n_a * inverse;
            low_z = -n_across * inverse;
            sine = up1 * inverse;
            cosine = simd::mul_add(low_rho, high_rho, low_z * high_z);
        }
    }
    const S angle = simd::atan2_above(sine, cosine);
    const S to_half = simd::select(cosine < S(0), (S(1) - cosine) / simd::max(sine, S(1e-37)),
                                   sine / (S(1) + simd::max(cosine, S(0))));
    const S middle_rho = low_rho + high_rho;
    const S middle_up = simd::mul_add(n_across, middle_rho, p.n_a * (low_z + high_z));
    return S(0.5) * simd::mul_add(n_across, minus_sine(angle, sine), to_half * middle_rho * middle_up);
}

// asinh for x ≥ 0.
template<class S>
GONIO_FORCE_INLINE S asinh_above(S x) {
    constexpr double ln_2 = 0.69314718055994530942;
    const S root = simd::sqrt(simd::mul_add(x, x, S(1)));
    const S tangent = x / root;
    const S small = tangent * simd::atanh_ratio(simd::min(tangent * tangent, S(0.25)));
    return simd::select(tangent < S(0.5), small, S(ln_2) * simd::log2(x + root));
}

// sinh for x ≥ 0.
template<class S>
GONIO_FORCE_INLINE S sinh_above(S x) {
    constexpr double log2_e = 1.44269504088896340736;
    const S t = x * x;
    const S series = simd::mul_add(
        t, simd::mul_add(t, simd::mul_add(t, S(1.0 / 362880.0), S(1.0 / 5040.0)), S(1.0 / 120.0)), S(1.0 / 6.0));
    const S power = simd::exp2(x * S(log2_e));
    return simd::select(x < S(1), simd::mul_add(x * t, series, x), S(0.5) * (power - S(1) / power));
}

// As narrow as this, D − r over r, the eight nodes below are still good for float.
inline constexpr double least_cylinder_gap = 0.02;

// E/L of a cylinder above the horizon and apart from the receiver; the other lanes are marked hard. What is odd in α
// cancels between both halves.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_cylinder_above(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const CylinderPose<S> p = cylinder_pose(center, axis, radius, length_m, normal);
    const S across = simd::sqrt(simd::mul_add(p.n_f, p.n_f, p.n_g * p.n_g));
    const S lowest = p.up - simd::mul_add(S(0.5) * p.length, p.n_a, p.r * across);
    const auto exists = simd::both(p.r > S(1e-12) * p.d, p.length > S(1e-12) * p.d);
    // The axis' rounding turns the light by as much as this far along it.
    const auto aside = p.d > S(2e-3) * simd::max(simd::abs(p.z0), simd::abs(p.z1));
    const auto apart = simd::both(p.gap > S(least_cylinder_gap) * p.r, aside);
    const auto easy = simd::both(simd::both(exists, apart), lowest >= S(0));
    if (!simd::any(easy)) return {S(0), !easy};
    const S gap = simd::max(p.gap, S(1e-20));
    const S most_sinh2 = S(2) * p.r / gap;
    const S most = asinh_above(simd::sqrt(most_sinh2));
    const S inverse_most2 = S(1) / simd::max(most_sinh2, S(1e-37));
    const S kappa2 = gap * gap / simd::max(S(4) * p.d * p.r, S(1e-37)); // κ²
    constexpr double nodes[8][2] = {
        {0.019855071751231884, 0.050614268145188130}, {0.10166676129318663, 0.11119051722668724},
        {0.23723379504183550, 0.15685332293894364},   {0.40828267875217510, 0.18134189168918099},
        {0.59171732124782490, 0.18134189168918099},   {0.76276620495816450, 0.15685332293894364},
        {0.89833323870681337, 0.11119051722668724},   {0.98014492824876812, 0.050614268145188130}};
    S sum = S(0);
    for (const double(&node)[2] : nodes) {
        const S sinh = sinh_above(most * S(node[0]));
        const S sinh2 = sinh * sinh;
        const S cosh = simd::sqrt(S(1) + sinh2);
        const S sine2 = simd::min(kappa2 * sinh2, S(0.5)); // of φ/2
        const S rho = gap * cosh;
        const S cos_alpha = simd::mul_add(S(2) * p.r, sine2, gap) / rho;
        const S weight = (S(1) - sinh2 * inverse_most2) / (cosh * simd::sqrt(S(1) - sine2));
        sum = simd::mul_add(S(node[1]) * weight, cylinder_slice<false>(p, p.n_f * cos_alpha, rho), sum);
    }
    return {clamp_irradiance(S(2) * most * simd::sqrt(p.r / p.d) * sum), !easy};
}

struct CylinderInDouble;

} // namespace detail

// E/L [sr] of the side of a cylinder about `center` [m, from the receiver] along `axis`; `axis` and the receiver's
// `normal` are unit. 0 within the prolonged cylinder; on its side the limit π(1 + n·l)/2 from outside. Any finite
// input; negative sizes count as positive, and a size of 0 gives 0. Within 1e-10 of E/L in double. In float and packs,
// receivers whose horizon cuts the light are evaluated in double, lane by lane, and so are those within a fiftieth of
// the radius from the prolonged cylinder, or almost on its axis.
double irradiance_cylinder(vec3<double> center, vec3<double> axis, double radius, double length_m, vec3<double> normal);

template<class S>
GONIO_FORCE_INLINE S irradiance_cylinder(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const auto above = detail::survey_cylinder_above(center, axis, radius, length_m, normal);
    if (!simd::any(above.hard)) return above.irradiance;
    return detail::in_double<detail::CylinderInDouble>(
        above.hard, above.irradiance,
        {center.x, center.y, center.z, axis.x, axis.y, axis.z, radius, length_m, normal.x, normal.y, normal.z});
}

// Intensity 2 r l sinγ, γ measured from the axis, by the inverse square, as if at the centre.
template<class S>
GONIO_FORCE_INLINE S irradiance_cylinder_point(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const Direction<S> d = direction(center, normal);
    const S inverse = d.scale * d.inverse_distance;
    const S side = length(cross(axis, d.scaled)) * d.inverse_distance;
    const S area = S(2) * (radius * inverse) * (length_m * inverse) * side;
    return simd::max(area * simd::max(d.n_dot_l, S(0)), S(0));
}

namespace detail {

struct CylinderInDouble {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[11]) {
        return irradiance_cylinder(vec3<double>{v[0], v[1], v[2]}, vec3<double>{v[3], v[4], v[5]}, v[6], v[7],
                                   vec3<double>{v[8], v[9], v[10]});
    }
};

} // namespace detail

template<class S>
GONIO_FORCE_INLINE Seen<RectangleLight<S>, S> CylinderLight<S>::seen_from(vec3<S> to_center) const {
    constexpr double quarter_pi = 0.78539816339744830962;
    const S depth = dot(axis, to_center);
    const vec3<S> across = to_center - axis * depth;
    const S d = shading::length(across);
    const auto outside = d > simd::abs(radius);
    const vec3<S> f = across * reciprocal_or_zero(d);
    const S s = simd::select(outside, simd::abs(radius) * reciprocal_or_zero(d), S(0));
    const S kappa2 = (S(1) - s) * (S(1) + s);
    const S stretch = simd::mul_add(s, S(quarter_pi), S(1));
    const vec3<S> at = f * (d * kappa2) + axis * (depth * stretch);
    const S width = simd::select(outside, simd::abs(length) * stretch, S(0)); // nothing is seen from within
    const S height = S(2) * simd::abs(radius) * simd::sqrt(kappa2);
    return {{at, luminance, f * S(-1), axis, width, height, S(0), false}, at};
}

} // namespace gonio::shading
