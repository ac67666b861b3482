// The bodies of kernels_intensity.hpp, for one scalar. Included by kernels_intensity_<set>.cpp and by nothing else; the
// rule of shading/kernels_impl.hpp holds here too.
#pragma once

#include <gonio/preview/kernels_intensity.hpp>
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>
#include <gonio/simd/packet.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::preview::detail {

using shading::vec3;

// From the light to the points, in its frame.
template<class S>
struct LocalDirections {
    vec3<S> origin, x, y, z;

    GONIO_FORCE_INLINE explicit LocalDirections(const LightFrame& frame)
        : origin(spread(frame.origin)), x(spread(frame.x)), y(spread(frame.y)), z(spread(frame.z)) {}

    GONIO_FORCE_INLINE vec3<S> operator()(const simd::Packet<S>& packet, const Points& points) const {
        const vec3<S> at{packet.load(points.position[0]), packet.load(points.position[1]),
                         packet.load(points.position[2])};
        const vec3<S> way = at - origin;
        return {dot(way, x), dot(way, y), dot(way, z)};
    }

private:
    GONIO_FORCE_INLINE static vec3<S> spread(const float (&v)[3]) { return {S(v[0]), S(v[1]), S(v[2])}; }
};

template<class S, LobeConstants::Kind kind>
GONIO_FORCE_INLINE S lobe_factor(vec3<S> local, S inner, S outer) {
    using Kind = LobeConstants::Kind;
    if constexpr (kind == Kind::frustum) {
        return shading::inside_frustum(vec3<S>{local.x, local.y, -local.z}, inner, outer);
    } else {
        const S theta = simd::atan2(simd::sqrt(simd::mul_add(local.x, local.x, local.y * local.y)), -local.z);
        if constexpr (kind == Kind::frostbite) return shading::lobe_frostbite(theta, inner, outer);
        if constexpr (kind == Kind::linear_cos) return shading::lobe_linear_cos(theta, inner, outer);
        if constexpr (kind == Kind::smoothstep_cos) return shading::lobe_smoothstep_cos(theta, inner, outer);
        if constexpr (kind == Kind::linear_angle) return shading::lobe_linear_angle(theta, inner, outer);
        if constexpr (kind == Kind::smoothstep_angle) return shading::lobe_smoothstep_angle(theta, inner, outer);
        return shading::lobe_hard(theta, inner, outer);
    }
}

template<class S, LobeConstants::Kind kind>
void multiply_lobe(const Points& points, const LightFrame& frame, const LobeConstants& lobe, float* cd) {
    const LocalDirections<S> directions(frame);
    const S inner(lobe.inner);
    const S outer(lobe.outer);
    simd::for_each_packet<simd::Packet<S>>(points.count, [&](const simd::Packet<S>& packet) {
        packet.store(packet.load(cd) * lobe_factor<S, kind>(directions(packet, points), inner, outer), cd);
    });
}

template<class S>
void multiply_any_lobe(const Points& points, const LightFrame& frame, const LobeConstants& lobe, float* cd) {
    using Kind = LobeConstants::Kind;
    switch (lobe.kind) {
    case Kind::none:
        return;
    case Kind::frostbite:
        return multiply_lobe<S, Kind::frostbite>(points, frame, lobe, cd);
    case Kind::hard:
        return multiply_lobe<S, Kind::hard>(points, frame, lobe, cd);
    case Kind::linear_cos:
        return multiply_lobe<S, Kind::linear_cos>(points, frame, lobe, cd);
    case Kind::smoothstep_cos:
        return multiply_lobe<S, Kind::smoothstep_cos>(points, frame, lobe, cd);
    case Kind::linear_angle:
        return multiply_lobe<S, Kind::linear_angle>(points, frame, lobe, cd);
    case Kind::smoothstep_angle:
        return multiply_lobe<S, Kind::smoothstep_angle>(points, frame, lobe, cd);
    case Kind::frustum:
        return multiply_lobe<S, Kind::frustum>(points, frame, lobe, cd);
    }
}

// C in [0°, 360°), folded where the web is mirrored into what is stored.
template<class S, WebConstants::Fold fold>
GONIO_FORCE_INLINE S plane_deg(S x, S y, S first) {
    using Fold = WebConstants::Fold;
    constexpr double deg = 57.295779513082320877;
    if constexpr (fold == Fold::quadrant) return simd::atan2_above(simd::abs(y), simd::abs(x)) * S(deg);
    if constexpr (fold == Fold::bilateral_0_180) return simd::atan2_above(simd::abs(y), x) * S(deg);
    if constexpr (fold == Fold::bilateral_90_270) {
        // Mirrored to x ≤ 0, counted from 180° on.
        return S(180) - simd::atan2(y, simd::abs(x)) * S(deg);
    }
    const S c = simd::atan2(y, x) * S(deg);
    const S turned = simd::select(c < first, c + S(360), c);
    return simd::select(turned < first, turned + S(360),
                        simd::select(turned < first + S(360), turned, turned - S(360)));
}

struct Cell {
    std::size_t index;
    float weight; // of its upper end
};

// The ends hold for angles beyond them by rounding; false further out.
template<class S> // of which set this is
GONIO_FORCE_INLINE bool locate(const TableAxis& axis, float angle_deg, Cell& cell) {
    constexpr float room = 6e-5F; // [deg]
    const float first = axis.angles_deg[0];
    const float last = axis.angles_deg[axis.count - 1];
    if (!(angle_deg >= first - room && angle_deg <= last + room)) return false;
    cell.index = 0;
    cell.weight = 0.0F;
    if (axis.count == 1) return true;
    const float steps = simd::max((angle_deg - first) * axis.steps_per_deg, 0.0F);
    auto step = static_cast<std::size_t>(steps);
    if (step >= axis.steps) step = axis.steps - 1;
    std::size_t index = axis.first_cell[step];
    while (index + 2 < axis.count && angle_deg >= axis.angles_deg[index + 1])
        ++index;
    cell.index = index;
    const float along = (angle_deg - axis.angles_deg[index]) * axis.inverse_width[index];
    cell.weight = simd::min(simd::max(along, 0.0F), 1.0F);
    return true;
}

template<class S>
GONIO_FORCE_INLINE float along_plane(const WebConstants& web, std::size_t plane, const Cell& row) {
    const float* const values = web.candela + plane * web.gammas.count + row.index;
    return web.gammas.count == 1 ? values[0] : values[0] + row.weight * (values[1] - values[0]);
}

template<class S, WebConstants::Fold fold>
GONIO_FORCE_INLINE float look_up(const WebConstants& web, float c_deg, float gamma_deg) {
    Cell row;
    if (!locate<S>(web.gammas, gamma_deg, row)) return 0.0F;
    if constexpr (fold == WebConstants::Fold::axial) {
        return along_plane<S>(web, 0, row);
    } else {
        Cell plane;
        if (!locate<S>(web.planes, c_deg, plane)) return 0.0F;
        const float low = along_plane<S>(web, plane.index, row);
        if (plane.weight == 0.0F) return low;
        return low + plane.weight * (along_plane<S>(web, plane.index + 1, row) - low);
    }
}

// Angles by packets, cells and candela lane by lane: no set has gathers that are faster.
template<class S, WebConstants::Fold fold>
void multiply_web(const Points& points, const LightFrame& frame, const WebConstants& web, float* cd) {
    constexpr double deg = 57.295779513082320877;
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    const LocalDirections<S> directions(frame);
    const S first(web.planes.angles_deg[0]);
    simd::for_each_packet<simd::Packet<S>>(points.count, [&](const simd::Packet<S>& packet) {
        const vec3<S> local = directions(packet, points);
        const S across = simd::sqrt(simd::mul_add(local.x, local.x, local.y * local.y));
        float gamma[lanes];
        float c[lanes];
        simd::store(simd::atan2_above(across, -local.z) * S(deg), &gamma[0]);
        if constexpr (fold != WebConstants::Fold::axial)
            simd::store(plane_deg<S, fold>(local.x, local.y, first), &c[0]);
        float found[lanes];
        for (std::size_t lane = 0; lane < lanes; ++lane)
            found[lane] = look_up<S, fold>(web, fold == WebConstants::Fold::axial ? 0.0F : c[lane], gamma[lane]);
        S value;
        simd::load(&found[0], value);
        packet.store(packet.load(cd) * (value * S(web.scale)), cd);
    });
}

template<class S>
void multiply_any_web(const Points& points, const LightFrame& frame, const WebConstants& web, float* cd) {
    using Fold = WebConstants::Fold;
    switch (web.fold) {
    case Fold::axial:
        return multiply_web<S, Fold::axial>(points, frame, web, cd);
    case Fold::quadrant:
        return multiply_web<S, Fold::quadrant>(points, frame, web, cd);
    case Fold::bilateral_0_180:
        return multiply_web<S, Fold::bilateral_0_180>(points, frame, web, cd);
    case Fold::bilateral_90_270:
        return multiply_web<S, Fold::bilateral_90_270>(points, frame, web, cd);
    case Fold::none:
        return multiply_web<S, Fold::none>(points, frame, web, cd);
    }
}

extern const IntensityKernels kernels_intensity_scalar;
extern const IntensityKernels kernels_intensity_sse2;
extern const IntensityKernels kernels_intensity_avx2;
extern const IntensityKernels kernels_intensity_avx512;
extern const IntensityKernels kernels_intensity_neon;

} // namespace gonio::preview::detail
