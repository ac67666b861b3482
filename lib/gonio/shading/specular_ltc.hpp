// The specular part of a material under an area light: its lobe itself, summed over points of the light or over rows of
// points that a linearly transformed cosine places (ltc_lobe.hpp, lobe_rows.hpp).
//
// One call gives both terms of the reflectance (specular_method.hpp). Positions are relative to the receiver.
#pragma once

#include <gonio/shading/gloss.hpp>
#include <gonio/shading/light_points.hpp>
#include <gonio/shading/lights.hpp>
#include <gonio/shading/lobe_rows.hpp>
#include <gonio/shading/ltc_tube.hpp>
#include <gonio/shading/seen_from.hpp>
#include <gonio/shading/specular_method.hpp>
#include <gonio/simd/loop.hpp>

#include <type_traits>

namespace gonio::shading {

namespace detail {

// The exact share of a light; in lanes outside the mask `read` it may be inexact.
template<class S, class Read = AllLanes>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const SphereLight<S>& light,
                               vec3<S> to_center, const Read& read = {}) {
    return ltc_sphere(lobe, frame(to_center), light.radius, read);
}
template<class S, class Read = AllLanes>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const DiskLight<S>& light,
                               vec3<S> to_center, const Read& read = {}) {
    return ltc_disk(lobe, frame(to_center), frame(light.axis), light.radius, light.two_sided, read);
}
template<class S, class Read = AllLanes>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const RectangleLight<S>& light,
                               vec3<S> to_center, const Read& read = {}) {
    return ltc_rectangle(lobe, frame(to_center), frame(light.axis), frame(light.width_direction), light.width,
                         light.height, light.two_sided, read);
}
template<class S, class Read = AllLanes>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const TubeLight<S>& light,
                               vec3<S> to_center, const Read& read = {}) {
    return ltc_tube(lobe, frame(to_center), frame(light.axis), light.radius, light.length, read);
}
template<class S, class Read = AllLanes>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const SunLight<S>& light,
                               vec3<S> toward, const Read& = {}) {
    return ltc_cap(lobe, frame(toward), light.sine, light.cosine);
}

// Sums over those points of a light, or of rows, that are above the horizon, in ltc_frame's frame.
template<class S>
struct PointSums {
    S value;     // ∫ f n·l dω, of the lobe itself with F = 1
    S grazing;   // the same with F = (1 − l·h)⁵
    S by_cosine; // ∫ of the transformed cosine that approximates the lobe, where it is positive, up to a factor
};

// `points` are those of a light (light_points.hpp) or RowPoints. Without `with_cosine`, by_cosine is 0.
template<bool with_cosine = false, class S, class Points, class Lobe, bool sheared>
GONIO_FORCE_INLINE PointSums<S> point_sums(const Points& points, const Lobe& lobe, const LtcLobe<S, sheared>& cosine,
                                           vec3<S> v) {
    PointSums<S> sums{S(0), S(0), S(0)};
    for_each_direction<S>(
        points, [&](vec3<S> l, S solid_angle) __attribute__((always_inline)) {
            const S n_dot_l = simd::max(l.z, S(0)); // 0 leaves any lobe finite
            const HalfVector<S> h = half_vector(l, v);
            const S value = lobe.value({l.x, l.y, n_dot_l}, v, h) * n_dot_l * solid_angle;
            simd::accumulate(sums.value, value);
            simd::accumulate_product(sums.grazing, value, schlick_weight(h.l_dot_h));
            if constexpr (with_cosine) {
                const vec3<S> q = cosine(l);
                const S inverse_q = S(1) / simd::max(dot(q, q), S(1e-36));
                const S above = simd::select(l.z > S(0), simd::max(q.z, S(0)), S(0));
                simd::accumulate_product(sums.by_cosine, above * inverse_q * inverse_q, solid_angle);
            }
        });
    return sums;
}

// The same for points of any light: not inlined, where kernels are to be small.
template<bool with_cosine, class S, class Lobe, bool sheared>
[[gnu::noinline]] void sum_gathered(const GatheredPoints<S>& points, const Lobe& lobe,
                                    const LtcLobe<S, sheared>& cosine, const vec3<S>& v, PointSums<S>& sums) {
    sums = point_sums<with_cosine>(points, lobe, cosine, v);
}
template<bool with_cosine = false, class S, class Points, class Lobe, bool sheared>
GONIO_FORCE_INLINE PointSums<S> sums_over(const Points& points, const Lobe& lobe, const LtcLobe<S, sheared>& cosine,
                                          vec3<S> v) {
#ifdef GONIO_SMALL_KERNELS
    if constexpr (!simd::is_recorded<S>) {
        GatheredPoints<S> gathered;
        gathered.gather(points);
        PointSums<S> sums;
        sum_gathered<with_cosine>(gathered, lobe, cosine, v, sums);
        return sums;
    } else
#endif
        return point_sums<with_cosine>(points, lobe, cosine, v);
}

// What a receiver sees of a light, in the frame of its lobe.
template<class S, class Points, class Cosine>
struct LobePose {
    S n_dot_v;
    simd::mask_of<S> seen; // n·v > 0
    LtcFrame<S> frame;
    Cosine cosine;
    vec3<S> v; // along the normal where it is not seen
    Points points;
    S size2, distance2; // after the transform

    // Nothing of the light is above the horizon, or the eye is below it.
    GONIO_FORCE_INLINE simd::mask_of<S> is_below() const {
        return simd::either(points.patch.center.z < -points.rise(), !seen);
    }
};
template<class S, class Light, class CosineOf>
GONIO_FORCE_INLINE auto lobe_pose(const Light& light, vec3<S> to_center, vec3<S> normal, vec3<S> view,
                                  const CosineOf& cosine_of) {
    const S n_dot_v = dot(normal, view);
    const auto seen = above_surface(n_dot_v);
    const LtcFrame<S> frame = ltc_frame(normal, view);
    const auto cosine = cosine_of(n_dot_v, frame.sine);
    const auto points = points_of(light, frame, to_center);
    const vec3<S> c1 = cosine(points.patch.center);
    using Points = decltype(points_of(light, frame, to_center));
    return LobePose<S, Points, std::remove_cv_t<decltype(cosine)>>{
        n_dot_v,
        seen,
        frame,
        cosine,
        {-frame.sine, S(0), simd::select(seen, n_dot_v, S(1))},
        points,
        points.transformed_size2(cosine),
        simd::max(dot(c1, c1), S(1e-36))};
}

// Below these sizes (a length over its distance, after the transform) the light's own points are used; the second holds
// where the horizon cuts the light.
inline constexpr double rows_from = 0.15;
inline constexpr double rows_from_if_cut = 1e-3;

// Whether the receiver is in the light, which then fills its hemisphere.
template<class S, class Light>
GONIO_FORCE_INLINE simd::mask_of<S> surrounded(const Light& /*light*/, vec3<S> /*to_center*/) {
    return S(0) > S(1);
}
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> surrounded(const SphereLight<S>& light, vec3<S> to_center) {
    const S scale = points_scale(light, to_center);
    const vec3<S> c = to_center * scale;
    return simd::difference_of_squares(c.x, c.y, c.z, light.radius * scale) < S(0);
}
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> surrounded(const TubeLight<S>& light, vec3<S> to_center) {
    const S scale = points_scale(light, to_center);
    const vec3<S> c = to_center * scale;
    const S half = S(0.5) * (simd::abs(light.length) * scale);
    const S along = dot(light.axis, c);
    const S within = simd::min(simd::max(along, -half), half);
    const vec3<S> nearest = perpendicular(c, light.axis) + light.axis * (along - within);
    return simd::difference_of_squares(nearest.x, nearest.y, nearest.z, light.radius * scale) < S(0);
}

// Whether the receiver is behind a flat light that emits to one side, or in its plane.
template<class S, class Light, class Points>
GONIO_FORCE_INLINE simd::mask_of<S> unlit_side(const Light& /*light*/, const Points& /*points*/) {
    return S(0) > S(1);
}
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> unlit_side(const DiskLight<S>& /*light*/, const DiskPoints<S>& points) {
    return !(points.patch.strength > S(0));
}
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> unlit_side(const RectangleLight<S>& /*light*/, const RectanglePoints<S>& points) {
    return !(points.patch.strength > S(0));
}

// Whether a receiver beside a round flat light is so near to its plane that rounding decides on the light's cone.
template<class S, class Light, class Points>
GONIO_FORCE_INLINE simd::mask_of<S> edge_on(const Light& /*light*/, const Points& /*points*/) {
    return S(0) > S(1);
}
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> edge_on(const DiskLight<S>& /*light*/, const DiskPoints<S>& points) {
    constexpr double pi = 3.14159265358979323846;
    constexpr double nearest = 4e-6; // of the radius
    const S radius2 = dot(points.patch.u, points.patch.u);
    const vec3<S>& center = points.patch.center;
    return simd::both(
        points.patch.strength<S(pi * nearest) * radius2 * simd::sqrt(radius2), dot(center, center)> S(1.001) * radius2);
}

// The height of a light's centre above the horizon.
template<class S, class Points, class Light, class Frame>
GONIO_FORCE_INLINE S center_height(const Points& points, const Light& /*light*/, const Frame& /*frame*/,
                                   vec3<S> /*to_center*/) {
    return points.patch.center.z;
}
template<class S, class Frame>
GONIO_FORCE_INLINE S center_height(const TubePoints<S>& /*points*/, const TubeLight<S>& light, const Frame& frame,
                                   vec3<S> to_center) {
    return TubeSeen<S>(light, frame, to_center).center().z;
}

// Where the light's own points are enough, and where nothing is reflected.
template<class S>
struct LobeCases {
    simd::mask_of<S> small, dark;
};
template<class S, class Points, class Cosine, class Light>
GONIO_FORCE_INLINE LobeCases<S> lobe_cases(const LobePose<S, Points, Cosine>& pose, const Light& light,
                                           vec3<S> to_center) {
    const S height = center_height(pose.points, light, pose.frame, to_center);
    const S rise = pose.points.rise();
    constexpr double from2 = rows_from * rows_from;
    constexpr double from2_if_cut = rows_from_if_cut * rows_from_if_cut;
    return {pose.size2 < simd::select(simd::abs(height) < rise, S(from2_if_cut), S(from2)) * pose.distance2,
            simd::either(simd::either(height < -rise, unlit_side<S>(light, pose.points)), !pose.seen)};
}

// Sums as a result: both are shares.
template<class S>
GONIO_FORCE_INLINE SpecularLuminance<S> as_luminance(S value, S grazing) {
    return {simd::min(simd::max(value, S(0)), S(1)), simd::min(simd::max(grazing, S(0)), S(1))};
}
template<class S>
GONIO_FORCE_INLINE S grazing_share(const PointSums<S>& sums) {
    return sums.grazing / simd::max(sums.value, S(1e-36));
}

} // namespace detail

// A lobe (gloss.hpp). `normal` and `view` are unit; `to_center` leads from the receiver to the light's centre. 0 where
// n·v is not positive. Light is any light with a size, or a SunLight; its window is not applied.
//
// The lobe is summed over the light's own points if the light is small compared with the lobe, otherwise over rows of
// points. In a light it is the lobe's albedo. Where rounding loses all rows, it is the transformed cosine's share.
//
// `cosine_of(n·v, ‖n×v‖)` gives the transformed cosine of the lobe's α.
template<class S, class Light, template<class> class Lobe, class CosineOf>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_ltc(const Light& light, vec3<S> to_center, vec3<S> normal,
                                                     vec3<S> view, const Lobe<S>& lobe, const CosineOf& cosine_of) {
    const auto pose = detail::lobe_pose(light, to_center, normal, view, cosine_of);
    const auto& [n_dot_v, seen, frame, cosine, v, points, size2, distance2] = pose;
    const auto [small, dark] = detail::lobe_cases(pose, light, to_center);
    S value = S(0);
    S grazing = S(0);
    if (simd::any(simd::both(small, !dark))) {
        const detail::PointSums<S> sums = detail::sums_over(points, lobe, cosine, v);
        value = sums.value;
        grazing = detail::grazing_share(sums);
    }
    if (!simd::all(simd::either(small, dark))) {
        const auto region = detail::region_of(cosine, points, light, frame, to_center);
        const detail::RowPoints<S, decltype(region), Lobe<S>, std::remove_cvref_t<decltype(cosine)>> rows(
            region, cosine, lobe, v);
        const detail::PointSums<S> sums = detail::sums_over(rows, lobe, cosine, v);
        S share = cosine.albedo * lobe.albedo_share(v.z);
        auto by_share = detail::surrounded(light, to_center);
        if constexpr (Lobe<S>::is_even && !simd::is_recorded<S>) {
            // Floats may lose all rows of a cone that is nearly flat, or whose side almost meets the receiver, or place
            // them elsewhere.
            const auto lost = simd::both(!simd::either(small, dark),
                                         simd::either(!(sums.value > S(0)), detail::edge_on<S>(light, points)));
            if (simd::any(lost)) {
                const S k = detail::ltc_share(cosine, frame, light, to_center, lost) * share;
                share = simd::select(lost, k, share);
                by_share = simd::either(by_share, lost);
            }
        }
        value = simd::select(small, value, simd::select(by_share, share, sums.value));
        grazing = simd::select(small, grazing,
                               simd::select(by_share, cosine.grazing / cosine.albedo, detail::grazing_share(sums)));
    }
    const SpecularLuminance<S> lit = detail::as_luminance(value, grazing);
    return {simd::select(dark, S(0), lit.scale), lit.grazing};
}

template<class S, class Light, template<class> class Lobe, class CosineOf>
requires SeenAsAnother<Light, S> GONIO_FORCE_INLINE SpecularLuminance<S> specular_ltc(const Light& light,
                                                                                      vec3<S> to_center, vec3<S> normal,
                                                                                      vec3<S> view, const Lobe<S>& lobe,
                                                                                      const CosineOf& cosine_of) {
    const auto seen = light.seen_from(to_center);
    return specular_ltc(seen.light, seen.to_center, normal, view, lobe, cosine_of);
}

// The same, with the transformed cosine from the table of all α.
template<class S, class Light, template<class> class Lobe>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_ltc(const Light& light, vec3<S> to_center, vec3<S> normal,
                                                     vec3<S> view, const Lobe<S>& lobe) {
    return specular_ltc(
        light, to_center, normal, view,
        lobe, [&](S n_dot_v, S sine) __attribute__((always_inline)) { return ltc_ggx(lobe.alpha, n_dot_v, sine); });
}
// The same for a lobe that depends on a direction of the surface.
template<class S, class Light, template<class> class Lobe>
requires requires(const Lobe<S>& lobe, const LtcFrame<S>& frame) {
    lobe.in(frame);
}
GONIO_FORCE_INLINE SpecularLuminance<S> specular_ltc(const Light& light, vec3<S> to_center, vec3<S> normal,
                                                     vec3<S> view, const Lobe<S>& lobe) {
    const auto local = lobe.in(ltc_frame(normal, view));
    return specular_ltc(
        light, to_center, normal, view,
        local, [&](S n_dot_v, S sine) __attribute__((always_inline)) { return local.cosine(n_dot_v, sine); });
}

// The renormalised Disney diffuse of albedo 1, in the same way: luminance per luminance of the light.
template<class S, class Light>
GONIO_FORCE_INLINE S diffuse_ltc(const Light& light, vec3<S> to_center, vec3<S> normal, vec3<S> view,
                                 S linear_roughness) {
    const S n_dot_v = dot(normal, view);
    const LtcLobe<S> lobe = ltc_diffuse(linear_roughness, n_dot_v);
    const auto seen = seen_from(light, to_center);
    const S share = detail::ltc_share(lobe, ltc_frame(normal, view), seen.light, seen.to_center);
    return simd::select(n_dot_v > S(0), share * lobe.albedo, S(0));
}

} // namespace gonio::shading
