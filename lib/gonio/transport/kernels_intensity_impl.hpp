// The bodies of kernels_intensity.hpp, for one scalar. Included only by kernels_intensity_<set>.cpp; the rule of
// shading/kernels_impl.hpp applies here too.
#pragma once

#include <gonio/shading/falloff.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>
#include <gonio/simd/packet.hpp>
#include <gonio/transport/kernels_intensity.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::transport::detail {

using shading::vec3;

// Directions from the light to the points, in the light's frame.
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

template<class S>
struct TableAngles {
    S horizontal_deg, vertical_deg;
};

// C in [0°, 360°), folded into the stored range where the web is mirrored; full: in the turn that begins at `first`.
template<class S, WebConstants::Angles kind>
GONIO_FORCE_INLINE S plane_deg(S x, S y, S first) {
    using Angles = WebConstants::Angles;
    constexpr double deg = 57.295779513082320877;
    if constexpr (kind == Angles::quadrant) return simd::atan2_above(simd::abs(y), simd::abs(x)) * S(deg);
    if constexpr (kind == Angles::bilateral_0_180) return simd::atan2_above(simd::abs(y), x) * S(deg);
    // Mirrored to x ≤ 0, counted from 180° on.
    if constexpr (kind == Angles::bilateral_90_270) return S(180) - simd::atan2(y, simd::abs(x)) * S(deg);
    const S c = simd::atan2(y, x) * S(deg);
    const S turned = simd::select(c < first, c + S(360), c);
    return simd::select(turned < first, turned + S(360),
                        simd::select(turned < first + S(360), turned, turned - S(360)));
}

// web/goniometer.hpp defines the angles.
template<class S, WebConstants::Angles kind>
GONIO_FORCE_INLINE TableAngles<S> table_angles(vec3<S> d, const WebConstants& web, S first) {
    using Angles = WebConstants::Angles;
    constexpr double deg = 57.295779513082320877;
    const auto length_of = [](S a, S b) { return simd::sqrt(simd::mul_add(a, a, b * b)); };
    if constexpr (kind == Angles::type_a || kind == Angles::type_b) {
        const S x = web.mirrors_x ? simd::abs(d.x) : d.x;
        const S y = web.mirrors_y ? simd::abs(d.y) : d.y;
        if constexpr (kind == Angles::type_a)
            return {simd::atan2(x, -d.z) * S(deg), simd::atan2(y, length_of(x, d.z)) * S(deg)};
        return {simd::atan2(x, length_of(y, d.z)) * S(deg), simd::atan2(y, -d.z) * S(deg)};
    } else {
        const S gamma = simd::atan2_above(length_of(d.x, d.y), -d.z) * S(deg);
        if constexpr (kind == Angles::axial) return {S(0), gamma};
        return {plane_deg<S, kind>(d.x, d.y, first), gamma};
    }
}

// Cells of an axis that angles lie in, and the weights of their upper ends.
template<class S>
struct Cells {
    static constexpr std::size_t lanes = simd::Traits<S>::lanes;

    std::size_t index[lanes];
    S weight;
};

// Angles beyond the ends get the nearest place.
template<class S>
GONIO_FORCE_INLINE Cells<S> cells_of(const TableAxis& axis, S angle_deg) {
    constexpr std::size_t lanes = Cells<S>::lanes;
    Cells<S> cells;
    if (axis.count == 1) {
        for (std::size_t lane = 0; lane < lanes; ++lane)
            cells.index[lane] = 0;
        cells.weight = S(0);
        return cells;
    }
    const S steps = (angle_deg - S(axis.angles_deg[0])) * S(axis.steps_per_deg);
    float step[lanes];
    float low[lanes];
    simd::store(simd::min(simd::max(steps, S(0)), S(static_cast<float>(axis.steps - 1))), &step[0]);
    S from;
    S per_deg(axis.steps_per_deg);
    if (axis.is_uniform) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            cells.index[lane] = static_cast<std::size_t>(static_cast<int>(step[lane]));
            low[lane] = axis.angles_deg[cells.index[lane]];
        }
    } else {
        float angles[lanes];
        float inverse[lanes];
        simd::store(angle_deg, &angles[0]);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            std::size_t index = axis.first_cell[static_cast<std::size_t>(static_cast<int>(step[lane]))];
            while (index + 2 < axis.count && angles[lane] >= axis.angles_deg[index + 1])
                ++index;
            cells.index[lane] = index;
            low[lane] = axis.angles_deg[index];
            inverse[lane] = axis.inverse_width[index];
        }
        simd::load(&inverse[0], per_deg);
    }
    simd::load(&low[0], from);
    cells.weight = simd::min(simd::max((angle_deg - from) * per_deg, S(0)), S(1));
    return cells;
}

// Angles that are beyond the ends by rounding count as the ends.
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> is_within(const TableAxis& axis, S angle_deg) {
    constexpr float room = 6e-5F; // [deg]
    return simd::both(angle_deg >= S(axis.angles_deg[0] - room),
                      angle_deg <= S(axis.angles_deg[axis.count - 1] + room));
}

// Angles, places and sums by packets, the numbers of the table lane by lane.
template<class S, WebConstants::Angles kind>
GONIO_FORCE_INLINE S look_up(const WebConstants& web, const TableAngles<S>& angles) {
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    const auto between = [](const float* low, const float* high, S weight) __attribute__((always_inline)) {
        S from;
        S to;
        simd::load(low, from);
        simd::load(high, to);
        return from + weight * (to - from);
    };
    const Cells<S> rows = cells_of(web.vertical, angles.vertical_deg);
    const std::size_t next_row = web.vertical.count == 1 ? 0 : 1;
    float low[2][lanes];  // of the first plane, at both ends of the row's cell
    float high[2][lanes]; // of the second
    const auto inside = is_within(web.vertical, angles.vertical_deg);
    if constexpr (kind == WebConstants::Angles::axial) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const float* const at = web.candela + rows.index[lane];
            low[0][lane] = at[0];
            low[1][lane] = at[next_row];
        }
        return simd::select(inside, between(&low[0][0], &low[1][0], rows.weight), S(0));
    } else {
        const Cells<S> planes = cells_of(web.horizontal, angles.horizontal_deg);
        const std::size_t next_plane = web.horizontal.count == 1 ? 0 : web.vertical.count;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const float* const at = web.candela + planes.index[lane] * web.vertical.count + rows.index[lane];
            low[0][lane] = at[0];
            low[1][lane] = at[next_row];
            high[0][lane] = at[next_plane];
            high[1][lane] = at[next_plane + next_row];
        }
        const S first = between(&low[0][0], &low[1][0], rows.weight);
        const S second = between(&high[0][0], &high[1][0], rows.weight);
        return simd::select(simd::both(inside, is_within(web.horizontal, angles.horizontal_deg)),
                            first + planes.weight * (second - first), S(0));
    }
}

template<class S, WebConstants::Angles kind>
void multiply_web(const Points& points, const LightFrame& frame, const WebConstants& web, float* cd) {
    const LocalDirections<S> directions(frame);
    const S first(web.horizontal.angles_deg[0]);
    simd::for_each_packet<simd::Packet<S>>(points.count, [&](const simd::Packet<S>& packet) {
        const S value = look_up<S, kind>(web, table_angles<S, kind>(directions(packet, points), web, first));
        // Files may contain negative candela, which no light emits.
        packet.store(packet.load(cd) * simd::max(value * S(web.scale), S(0)), cd);
    });
}

template<class S>
void multiply_any_web(const Points& points, const LightFrame& frame, const WebConstants& web, float* cd) {
    using Angles = WebConstants::Angles;
    switch (web.angles) {
    case Angles::axial:
        return multiply_web<S, Angles::axial>(points, frame, web, cd);
    case Angles::quadrant:
        return multiply_web<S, Angles::quadrant>(points, frame, web, cd);
    case Angles::bilateral_0_180:
        return multiply_web<S, Angles::bilateral_0_180>(points, frame, web, cd);
    case Angles::bilateral_90_270:
        return multiply_web<S, Angles::bilateral_90_270>(points, frame, web, cd);
    case Angles::full:
        return multiply_web<S, Angles::full>(points, frame, web, cd);
    case Angles::type_a:
        return multiply_web<S, Angles::type_a>(points, frame, web, cd);
    case Angles::type_b:
        return multiply_web<S, Angles::type_b>(points, frame, web, cd);
    }
}

template<class S>
GONIO_FORCE_INLINE float look_up(const ImageConstants& image, float column, float row) {
    const auto x = static_cast<std::size_t>(column);
    const auto y = static_cast<std::size_t>(row);
    const std::size_t right = x + 1 < image.width ? 1 : 0;
    const std::size_t below = y + 1 < image.height ? image.width : 0;
    const float* const pixel = image.pixels + y * image.width + x;
    const float along = column - static_cast<float>(x);
    const float upper = pixel[0] + along * (pixel[right] - pixel[0]);
    const float lower = pixel[below] + along * (pixel[below + right] - pixel[below]);
    return upper + (row - static_cast<float>(y)) * (lower - upper);
}

template<class S>
void multiply_image(const Points& points, const LightFrame& frame, const ImageConstants& image, float* cd) {
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    const LocalDirections<S> directions(frame);
    const S across(0.5F * static_cast<float>(image.width) / image.slope_x);
    const S down(0.5F * static_cast<float>(image.height) / image.slope_y);
    const S middle_x(0.5F * static_cast<float>(image.width) - 0.5F);
    const S middle_y(0.5F * static_cast<float>(image.height) - 0.5F);
    const S last_x(static_cast<float>(image.width - 1));
    const S last_y(static_cast<float>(image.height - 1));
    simd::for_each_packet<simd::Packet<S>>(points.count, [&](const simd::Packet<S>& packet) {
        const vec3<S> d = directions(packet, points);
        const auto ahead = d.z < S(0);
        const S inverse = S(1) / simd::select(ahead, -d.z, S(1));
        const S x = simd::mul_add(d.x * inverse, across, middle_x);
        const S y = simd::mul_add(d.y * inverse, -down, middle_y);
        // Half a pixel beyond the outermost centres the image ends; a little more for directions on its outline.
        constexpr float room = 1e-3F;
        const S half(0.5F + room);
        const auto inside =
            simd::both(simd::both(x >= -half, x <= last_x + half), simd::both(y >= -half, y <= last_y + half));
        const auto lit = simd::both(ahead, inside);
        float columns[lanes];
        float rows[lanes];
        float found[lanes];
        simd::store(simd::select(lit, simd::min(simd::max(x, S(0)), last_x), S(0)), &columns[0]);
        simd::store(simd::select(lit, simd::min(simd::max(y, S(0)), last_y), S(0)), &rows[0]);
        for (std::size_t lane = 0; lane < lanes; ++lane)
            found[lane] = look_up<S>(image, columns[lane], rows[lane]);
        S value;
        simd::load(&found[0], value);
        packet.store(packet.load(cd) * simd::select(lit, value, S(0)), cd);
    });
}

template<class S>
void divide_by_projected_area(const Points& directions, float side, const BodyFaces& faces, float* cd) {
    simd::for_each_packet<simd::Packet<S>>(directions.count, [&](const simd::Packet<S>& packet) {
        const vec3<S> d = vec3<S>{packet.load(directions.position[0]), packet.load(directions.position[1]),
                                  packet.load(directions.position[2])} *
                          S(side);
        const S length = simd::sqrt(dot(d, d));
        S projected = S(faces.round_m2) * length;
        for (std::size_t i = 0; i < faces.count; ++i) {
            const vec3<S> normal{S(faces.normal[0][i]), S(faces.normal[1][i]), S(faces.normal[2][i])};
            projected = projected + simd::max(dot(normal, d), S(0));
        }
        const auto is_lit = projected > S(0);
        packet.store(simd::select(is_lit, packet.load(cd) * length / simd::select(is_lit, projected, S(1)), S(0)), cd);
    });
}

extern const IntensityKernels kernels_intensity_scalar;
extern const IntensityKernels kernels_intensity_sse2;
extern const IntensityKernels kernels_intensity_avx2;
extern const IntensityKernels kernels_intensity_avx512;
extern const IntensityKernels kernels_intensity_neon;
extern const IntensityKernels kernels_intensity_wasm128;

} // namespace gonio::transport::detail
