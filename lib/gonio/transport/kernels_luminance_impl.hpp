// The bodies of kernels_luminance.hpp, for one scalar. Included only by kernels_luminance_<set>.cpp; the rule of
// shading/kernels_impl.hpp applies here too.
#pragma once

#include <gonio/scene/spread.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>
#include <gonio/simd/packet.hpp>
#include <gonio/transport/kernels_luminance.hpp>

#include <cstddef>

namespace gonio::transport::detail {

using gonio::detail::spread;
using shading::vec3;

inline constexpr std::size_t most_columns = 24;

// Nodes in (−1, 1) and weights of the Gauss–Legendre rules with 2 to 24 columns; a rule is symmetric, so
// only its positive half is listed.
struct ColumnRule {
    std::size_t columns;
    float node[most_columns / 2];
    float weight[most_columns / 2];
};

static constexpr ColumnRule column_rules[] = {
    {2, {0.577350269F}, {1.0F}},
    {4, {0.339981044F, 0.861136312F}, {0.652145155F, 0.347854845F}},
    {6, {0.238619186F, 0.661209386F, 0.932469514F}, {0.467913935F, 0.360761573F, 0.171324492F}},
    {8,
     {0.183434642F, 0.52553241F, 0.796666477F, 0.960289856F},
     {0.362683783F, 0.313706646F, 0.222381034F, 0.101228536F}},
    {12,
     {0.125233409F, 0.367831499F, 0.587317954F, 0.769902674F, 0.904117256F, 0.981560634F},
     {0.249147046F, 0.233492537F, 0.203167427F, 0.160078329F, 0.106939326F, 0.0471753364F}},
    {16,
     {0.0950125098F, 0.281603551F, 0.458016778F, 0.617876244F, 0.755404408F, 0.865631202F, 0.944575023F, 0.989400935F},
     {0.18945061F, 0.182603415F, 0.169156519F, 0.149595989F, 0.124628971F, 0.0951585117F, 0.0622535239F,
      0.0271524594F}},
    {24,
     {0.0640568929F, 0.191118867F, 0.31504268F, 0.433793508F, 0.545421471F, 0.648093652F, 0.740124192F, 0.820001986F,
      0.886415527F, 0.938274552F, 0.974728556F, 0.99518722F},
     {0.127938195F, 0.125837456F, 0.121670473F, 0.115505668F, 0.10744427F, 0.0976186521F, 0.0861901615F, 0.0733464814F,
      0.0592985849F, 0.0442774388F, 0.0285313886F, 0.0123412298F}},
};

// The smallest rule with at least that many columns, or the largest.
GONIO_FORCE_INLINE const ColumnRule& column_rule(float columns) {
    for (const ColumnRule& rule : column_rules)
        if (static_cast<float>(rule.columns) >= columns) return rule;
    return column_rules[sizeof(column_rules) / sizeof(column_rules[0]) - 1];
}

// ∫ T cosψ dψ and ∫ T sinψ dψ over an interval.
template<class S>
struct ColumnIntegrals {
    S cosine, sine;
};

// A place on an axis of the table.
struct TablePlace {
    std::size_t index; // of the lower end
    float along;       // [0, 1]
};

template<class S> // determines the instruction set
GONIO_FORCE_INLINE TablePlace place_at(float steps) {
    const auto index = static_cast<std::size_t>(static_cast<int>(steps));
    return {index, steps - static_cast<float>(static_cast<int>(steps))};
}
// From the start of an axis of the table, in steps of it; before its last node.
template<class S>
GONIO_FORCE_INLINE S steps_to(S angle, const ColumnTable& table, float per_step) {
    return simd::min(simd::max((angle + S(1.57079633F)) * S(per_step), S(0)),
                     S(static_cast<float>(table.count - 1) * 0.9999999F));
}

// The four numbers of a node of the table, computed with together; two of them count.
using ColumnNode [[gnu::vector_size(4 * sizeof(float))]] = float;

template<class S>
GONIO_FORCE_INLINE ColumnNode node_at(const float* row, std::size_t index) {
    ColumnNode node;
    __builtin_memcpy(&node, row + 4 * index, sizeof node);
    return node;
}

// The running integrals at a place of a row, as the numbers 0 and 2: exact for values that are linear between the
// nodes.
template<class S>
GONIO_FORCE_INLINE ColumnNode running(const float* row, const TablePlace& at, float step) {
    const ColumnNode low = node_at<S>(row, at.index);
    const ColumnNode high = node_at<S>(row, at.index + 1);
    const ColumnNode more = step * at.along * (low + 0.5F * at.along * (high - low));
    return low + __builtin_shufflevector(more, more, 1, 1, 3, 3);
}

// The values there, as the numbers 1 and 3.
template<class S>
GONIO_FORCE_INLINE ColumnNode value(const float* row, const TablePlace& at) {
    const ColumnNode low = node_at<S>(row, at.index);
    return low + at.along * (node_at<S>(row, at.index + 1) - low);
}

// Over [low, low + width], lane by lane.
template<class S>
GONIO_FORCE_INLINE ColumnIntegrals<S> integrals(const ColumnTable& table, S phi, S low, S width) {
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    const float per_step = 1.0F / table.step_rad;
    float row_steps[lanes];
    float begin_steps[lanes];
    float middle_steps[lanes];
    float end_steps[lanes];
    float widths[lanes];
    simd::store(steps_to(phi, table, per_step), &row_steps[0]);
    simd::store(steps_to(low, table, per_step), &begin_steps[0]);
    simd::store(steps_to(low + S(0.5F) * width, table, per_step), &middle_steps[0]);
    simd::store(steps_to(low + width, table, per_step), &end_steps[0]);
    simd::store(width, &widths[0]);
    float cosines[lanes];
    float sines[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const TablePlace row = place_at<S>(row_steps[lane]);
        const float* const row_low = table.nodes + 4 * table.count * row.index;
        const float* const row_high = row_low + 4 * table.count;
        const float share_low = 1.0F - row.along;
        // The difference of two running integrals would lose its digits.
        if (widths[lane] < 0.5F * table.step_rad) {
            const TablePlace middle = place_at<S>(middle_steps[lane]);
            const ColumnNode mean = share_low * value<S>(row_low, middle) + row.along * value<S>(row_high, middle);
            cosines[lane] = widths[lane] * mean[1];
            sines[lane] = widths[lane] * mean[3];
        } else {
            const TablePlace begin = place_at<S>(begin_steps[lane]);
            const TablePlace end = place_at<S>(end_steps[lane]);
            const auto between = [&](const float* nodes) __attribute__((always_inline)) {
                return running<S>(nodes, end, table.step_rad) - running<S>(nodes, begin, table.step_rad);
            };
            const ColumnNode sum = share_low * between(row_low) + row.along * between(row_high);
            cosines[lane] = sum[0];
            sines[lane] = sum[2];
        }
    }
    ColumnIntegrals<S> result;
    simd::load(&cosines[0], result.cosine);
    simd::load(&sines[0], result.sine);
    return result;
}

// What receivers see of the light's plane.
template<class S>
struct ColumnView {
    vec3<S> center, normal; // in the frame of the light; z of the normal away from it
    S depth;
    S middle, half_turn; // of φ [rad]
    simd::mask_of<S> lit;

    ColumnView() = default;
    GONIO_FORCE_INLINE ColumnView(const Receivers& receivers, const ColumnLight& light, const simd::Packet<S>& packet) {
        const auto load = [&](const float* const(&from)[3]) {
            return vec3<S>{packet.load(from[0]), packet.load(from[1]), packet.load(from[2])};
        };
        const vec3<S> x = spread<S>(light.x);
        const vec3<S> y = spread<S>(light.y);
        const vec3<S> z = spread<S>(light.z);
        const vec3<S> to_center = spread<S>(light.origin) - load(receivers.position);
        const vec3<S> world_normal = load(receivers.normal);
        center = {dot(to_center, x), dot(to_center, y), dot(to_center, z)};
        normal = {dot(world_normal, x), dot(world_normal, y), -dot(world_normal, z)};
        const auto in_front = center.z > S(0);
        depth = simd::select(in_front, center.z, S(1));
        // The part of the light that any column can have above the horizon: n_x x + n_y y > n_z depth.
        S left = center.x - S(light.half_x);
        S right = center.x + S(light.half_x);
        const S best = simd::mul_add(simd::abs(normal.y), S(light.half_y), normal.y * center.y);
        const S needed = simd::mul_add(normal.z, depth, -best);
        const S slope = simd::select(simd::abs(normal.x) > S(1e-12F), normal.x, S(1e-12F));
        const S horizon = needed / slope;
        left = simd::select(normal.x > S(1e-12F), simd::max(left, horizon), left);
        right = simd::select(normal.x < S(-1e-12F), simd::min(right, horizon), right);
        lit = simd::both(in_front, right > left);
        right = simd::select(lit, right, left);
        const S first = simd::atan2_above(depth, left); // from +x, so that both ends are precise
        const S turn = simd::atan2_above((right - left) * depth, simd::mul_add(left, right, depth * depth));
        half_turn = S(0.5F) * turn;
        middle = S(1.57079633F) - first + half_turn;
    }
};

template<class S>
struct ColumnSums {
    S seen = S(0);    // with the light's luminance
    S uniform = S(0); // with a luminance of 1
};

// One column at the angle φ.
template<class S>
GONIO_FORCE_INLINE void add_column(const ColumnLight& light, const ColumnView<S>& view, S phi, S weight,
                                   ColumnSums<S>& sums) {
    const vec3<S>& center = view.center;
    const vec3<S>& normal = view.normal;
    const S depth = view.depth;
    const S sine = simd::sin(phi);
    const S cosine = simd::max(simd::cos(phi), S(1e-6F));
    const S scale = cosine / depth; // of y to tanψ
    S half = S(light.half_y);
    if (light.is_round) {
        const S x = (depth * sine / cosine - center.x) * S(1.0F / light.half_x);
        half = half * simd::sqrt(simd::max(S(1) - x * x, S(0)));
    }
    S low = (center.y - half) * scale;
    S high = (center.y + half) * scale;
    // n·l = cosψ (a + b tanψ), for the plane of the light at −depth.
    const S a = simd::mul_add(normal.x, sine, -(normal.z * cosine));
    const S b = normal.y;
    const S cut = -a / simd::select(simd::abs(b) > S(1e-12F), b, S(1e-12F));
    low = simd::select(b > S(1e-12F), simd::max(low, cut), low);
    high = simd::select(b < S(-1e-12F), simd::min(high, cut), high);
    const auto lit = simd::both(high > low, simd::either(simd::abs(b) > S(1e-12F), a > S(0)));
    if (!simd::any(lit)) return;
    high = simd::select(lit, high, low);
    const S begin = simd::atan(low);
    // The difference of the angles without cancellation.
    const S width = simd::atan2_above(high - low, simd::mul_add(low, high, S(1)));
    const ColumnIntegrals<S> of_light = integrals(light.table, phi, begin, width);
    // ∫ cos²ψ = (Δψ + sinΔψ cos(2ψ_m))/2, ∫ sinψ cosψ = sinΔψ sin(2ψ_m)/2, with ψ_m in the middle.
    const S middle = simd::mul_add(width, S(0.5F), begin);
    const S chord = simd::sin(width);
    const S uniform_cosine = S(0.5F) * simd::mul_add(chord, simd::cos(middle + middle), width);
    const S uniform_sine = S(0.5F) * chord * simd::sin(middle + middle);
    const S by_light = simd::mul_add(a, of_light.cosine, b * of_light.sine) / cosine;
    const S by_uniform = simd::mul_add(a, uniform_cosine, b * uniform_sine);
    sums.seen = simd::select(lit, simd::mul_add(weight, simd::max(by_light, S(0)), sums.seen), sums.seen);
    sums.uniform = simd::select(lit, simd::mul_add(weight, simd::max(by_uniform, S(0)), sums.uniform), sums.uniform);
}

template<class S>
GONIO_FORCE_INLINE float greatest(S value) {
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    float values[lanes];
    simd::store(value, &values[0]);
    float most = 0.0F;
    for (std::size_t lane = 0; lane < lanes; ++lane)
        most = simd::max(most, values[lane]);
    return most;
}

// One rule for so many receivers, whatever the number of lanes: pictures are alike on all instruction sets.
inline constexpr std::size_t receivers_of_rule = 16;

template<class S>
void mean_luminance(const Receivers& receivers, const ColumnLight& light, float* share) {
    for (std::size_t block = 0; block < receivers.count; block += receivers_of_rule) {
        const std::size_t end =
            block + receivers_of_rule < receivers.count ? block + receivers_of_rule : receivers.count;
        const auto for_each = [&](const auto& work) {
            constexpr std::size_t lanes = simd::Traits<S>::lanes;
            for (std::size_t first = block; first < end; first += lanes)
                work(simd::Packet<S>{first, end - first < lanes ? end - first : lanes});
        };
        ColumnView<S> views[receivers_of_rule];
        std::size_t count = 0;
        float turn = 0.0F;
        for_each([&](const simd::Packet<S>& packet) {
            const ColumnView<S>& view = views[count++] = ColumnView<S>(receivers, light, packet);
            turn = simd::max(turn, 2.0F * greatest(simd::select(view.lit, view.half_turn, S(0))));
        });
        if (!(turn > 0.0F)) continue;
        const ColumnRule& rule = column_rule(turn * (light.is_round ? 1.3F : 1.0F) / light.column_rad);
        count = 0;
        for_each([&](const simd::Packet<S>& packet) {
            const ColumnView<S>& view = views[count++];
            if (!simd::any(view.lit)) return;
            ColumnSums<S> sums;
            for (std::size_t i = 0; i < rule.columns / 2; ++i) {
                // The chords of a round light are √(1 − t²) long: the Gauss–Chebyshev rule of the second kind.
                S at = S(rule.node[i]);
                S weight = view.half_turn * S(rule.weight[i]);
                if (light.is_round) {
                    const S theta = S(3.14159265F * static_cast<float>(i + 1) / static_cast<float>(rule.columns + 1));
                    at = simd::cos(theta);
                    weight = view.half_turn * simd::sin(theta);
                }
                add_column(light, view, simd::mul_add(view.half_turn, at, view.middle), weight, sums);
                add_column(light, view, simd::mul_add(view.half_turn, -at, view.middle), weight, sums);
            }
            const S ratio = sums.seen / simd::max(sums.uniform, S(1e-30F));
            const auto valid = simd::both(view.lit, sums.uniform > S(1e-30F));
            packet.store(packet.load(share) + simd::select(valid, simd::min(ratio, S(1e30F)), S(0)), share);
        });
    }
}

template<class S>
void mean_of_nodes(const Receivers& receivers, const NodeLight& light, const LightNodes& nodes, float* share) {
    const vec3<S> x = spread<S>(light.x);
    const vec3<S> y = spread<S>(light.y);
    const vec3<S> z = spread<S>(light.z);
    simd::for_each_packet<simd::Packet<S>>(receivers.count, [&](const simd::Packet<S>& packet) {
        const auto load = [&](const float* const(&from)[3]) {
            return vec3<S>{packet.load(from[0]), packet.load(from[1]), packet.load(from[2])};
        };
        const vec3<S> to_center = spread<S>(light.origin) - load(receivers.position);
        const vec3<S> normal = load(receivers.normal);
        const vec3<S> center{dot(to_center, x), dot(to_center, y), dot(to_center, z)};
        const vec3<S> n{dot(normal, x), dot(normal, y), dot(normal, z)};
        const S height = simd::abs(center.z);
        const auto emits = light.two_sided ? height > S(0) : center.z > S(0);
        const S across = n.z * center.z;
        const S square_height = center.z * center.z;
        S seen(0);
        S all(0);
        for (std::size_t i = 0; i < nodes.count; ++i) {
            const S to_x = center.x + S(nodes.x[i]);
            const S to_y = center.y + S(nodes.y[i]);
            const S cosine = simd::max(simd::mul_add(n.x, to_x, simd::mul_add(n.y, to_y, across)), S(0));
            const S square = simd::mul_add(to_x, to_x, simd::mul_add(to_y, to_y, square_height));
            const S inverse = S(1) / simd::max(square, S(1e-18F));
            const S weight = cosine * inverse * inverse; // times the height, which the ratio doesn't need
            seen = simd::mul_add(weight, S(nodes.luminance[i]), seen);
            all = simd::mul_add(weight, S(nodes.area[i]), all);
        }
        const auto valid = simd::both(emits, all > S(1e-30F));
        const S mean = simd::min(simd::max(seen / simd::max(all, S(1e-30F)), S(0)), S(1));
        packet.store(simd::select(valid, mean, S(0)), share);
    });
}

// Where the mirrored view meets the plane of a flat light, moved onto the light; one that runs along the plane or away
// from it meets it far outside.
template<class S>
GONIO_FORCE_INLINE vec3<S> met_by_mirrored(const LobeLight& light, const vec3<S>& to_center, const vec3<S>& mirrored) {
    const vec3<S> x = spread<S>(light.x);
    const vec3<S> y = spread<S>(light.y);
    const vec3<S> z = spread<S>(light.z);
    const S above = -dot(to_center, z);
    const S slope = simd::max(-simd::copysign(S(1), above) * dot(mirrored, z), S(1e-3F));
    const S way = simd::abs(above) / slope;
    const S at_x = simd::mul_add(way, dot(mirrored, x), -dot(to_center, x));
    const S at_y = simd::mul_add(way, dot(mirrored, y), -dot(to_center, y));
    const S half_x(light.half_x);
    const S half_y(light.half_y);
    if (!light.is_round)
        return mul_add(x, simd::min(simd::max(at_x, -half_x), half_x), y * simd::min(simd::max(at_y, -half_y), half_y));
    const S part_x = at_x / half_x;
    const S part_y = at_y / half_y;
    const S onto = S(1) / simd::max(simd::sqrt(simd::mul_add(part_x, part_x, part_y * part_y)), S(1));
    return mul_add(x, at_x * onto, y * (at_y * onto));
}

template<class S>
void views_of_lobes(const LobePoints& points, const LobeLight& light, const LobeViews& views) {
    const S lobe2(light.lobe_rad * light.lobe_rad);
    simd::for_each_packet<simd::Packet<S>>(points.count, [&](const simd::Packet<S>& packet) {
        const auto load = [&](const float* const(&from)[3]) {
            return vec3<S>{packet.load(from[0]), packet.load(from[1]), packet.load(from[2])};
        };
        const vec3<S> to_center = spread<S>(light.origin) - load(points.position);
        const S size = S(light.radius) / simd::sqrt(dot(to_center, to_center));
        const S size2 = size * size;
        packet.store(size2 / simd::max(size2 + lobe2, S(1e-30F)), views.narrow);
        vec3<S> to_light = to_center;
        if (light.is_flat) {
            const vec3<S> normal = load(points.normal);
            const vec3<S> view = load(points.view);
            const vec3<S> mirrored = normal * (S(2) * dot(normal, view)) - view;
            to_light = to_light + met_by_mirrored(light, to_center, mirrored);
        }
        packet.store(-to_light.x, views.towards[0]);
        packet.store(-to_light.y, views.towards[1]);
        packet.store(-to_light.z, views.towards[2]);
    });
}

extern const LuminanceKernels kernels_luminance_scalar;
extern const LuminanceKernels kernels_luminance_sse2;
extern const LuminanceKernels kernels_luminance_avx2;
extern const LuminanceKernels kernels_luminance_avx512;
extern const LuminanceKernels kernels_luminance_neon;
extern const LuminanceKernels kernels_luminance_wasm128;

} // namespace gonio::transport::detail
