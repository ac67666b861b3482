// The integral of a lobe over the directions in which a receiver sees a light, along rows of points that the lobe
// places.
//
// A linearly transformed cosine (ltc_lobe.hpp) takes the lobe almost to a cosine, and the light's cone of directions to
// another convex cone. That cone is cut into half planes through an axis A that is perpendicular to the cosine's axis
// z' and parallel to the boundary nearest to it, or along the light: B cos ψ + A sin ψ, where B is at the angle ω
// about A. The rows, over ω, are placed as if the lobe were the cosine. Along a row, 1 + (tan θ_h/α)² of the half
// vector (the denominator of GGX, whose square is in the lobe) is nearly a quadratic polynomial of τ = tan ψ, so the
// points are placed as if it were: at equal steps of the angle whose tangent is (τ − τ_min)/width. At each point the
// lobe itself is evaluated, so nothing of the fit is left but the places. A row ends exactly at the light's outline and
// at the receiver's horizon.
//
// Directions here are in the receiver's frame (ltc_frame), and primed ones in the transformed space. Nothing fails:
// finite input gives finite sums.
#pragma once

#include <gonio/shading/light_points.hpp>
#include <gonio/shading/lobe_region.hpp>
#include <gonio/shading/lobe_rule.hpp>
#include <gonio/shading/ltc_share.hpp>
#include <gonio/shading/vec2.hpp>

#include <cstddef>
#include <utility>

namespace gonio::shading::detail {

// Collects the first and last direction about an axis, by components along two unit vectors, the second of which is
// never negative within a region; made positive, so that 0 and half a turn remain apart.
template<class S>
struct Extremes {
    vec3<S> ahead, inward;
    vec2<S>& first;
    vec2<S>& last;

    GONIO_FORCE_INLINE void operator()(vec3<S> p, simd::mask_of<S> valid) const {
        const S x = dot(ahead, p);
        const vec2<S> at{x, simd::max(dot(inward, p), S(1e-7) * simd::abs(x))};
        first = select(simd::both(valid, cross(first, at) < S(0)), at, first);
        last = select(simd::both(valid, cross(last, at) > S(0)), at, last);
    }
    GONIO_FORCE_INLINE void all(simd::mask_of<S> whole) const {
        first = select(whole, vec2<S>{S(1), S(0)}, first);
        last = select(whole, vec2<S>{S(-1), S(0)}, last);
    }
};

// Over ω: at least six rows for a lobe whose ridge may bend.
template<class S, class Region, class Lobe>
constexpr const auto& rule_of_rows() {
    if constexpr (!Lobe::is_even && Region::rows.size() < 6)
        return LobeRule<S>::six;
    else
        return Region::rows;
}

// A region's points and the solid angles that they stand for, as the points of a light (light_points.hpp). `v` is the
// view in the receiver's frame, v.z > 0.
template<class S, class Region, class Lobe, class Cosine>
class RowPoints {
public:
    static constexpr const auto& rule = rule_of_rows<S, Region, Lobe>();
    static constexpr std::size_t rows = rule.size();
    // Not of other lobes: their rows cross the ridge.
    static constexpr bool has_axis = Region::has_axis && Lobe::is_even;
    static constexpr std::size_t points_of_row = Region::along_row.size();
    static constexpr std::size_t size = rows * points_of_row;

    GONIO_FORCE_INLINE RowPoints(const Region& region, const Cosine& cosine, const Lobe& lobe, vec3<S> v)
        : region_(region), v_(v), inwards_(region.nearest), slopes_(lobe.slopes()) {
        const S slant = simd::sqrt(simd::mul_add(inwards_.x, inwards_.x, inwards_.y * inwards_.y));
        const auto tilted = slant > S(1e-12);
        const S inverse_slant = S(1) / simd::select(tilted, slant, S(1));
        const vec2<S> slanted{inwards_.x * inverse_slant, inwards_.y * inverse_slant};
        vec2<S> beside = select(tilted, slanted, vec2<S>{S(1), S(0)}); // level, across A
        auto from_horizon = S(0) > S(1);
        if constexpr (!Lobe::is_even) {
            // The ridge of a thin lobe bends, which the transform does not undo. Where the light covers its peak, the
            // rows cross the ridge, whatever the light's boundary does.
            from_horizon = simd::both(lobe.is_thin(), inwards_.z > S(0.7));
            const vec2<S> across = lobe.across_ridge();
            beside = select(from_horizon, vec2<S>{across.y, -across.x}, beside);
            inwards_ = select(from_horizon, vec3<S>{S(0), S(0), S(1)}, inwards_);
        }
        const vec3<S>& e = inwards_;
        const S level = simd::select(from_horizon, S(0), slant);
        axis_ = {-beside.y, beside.x, S(0)};
        ahead_ = {-(e.z * beside.x), -(e.z * beside.y), level};

        if constexpr (has_axis) {
            inwards_ = select(region.along_light, region.own_nearest, inwards_);
            axis_ = select(region.along_light, region.own_axis, axis_);
            ahead_ = select(region.along_light, cross(e, region.own_axis), ahead_);
        }

        first_ = {S(-1), S(1e-20)};
        last_ = {S(1), S(-1e-20)};
        region.for_each_extreme(axis_, Extremes<S>{ahead_, e, first_, last_});
        first_ = normalized(first_);
        last_ = normalized(last_);
        // The cosine ends where z' is 0. Beyond, as far as the light began before (from α² to 2α, as tangents), little
        // is left of the lobe; all of a light that begins there is taken.
        const vec2<S> horizon{-e.z, level};
        const S before = cross(first_, horizon);
        const S cosine_before = dot(first_, horizon);
        const S ahead_by = simd::select(cosine_before > S(0), before / simd::max(cosine_before, S(1e-12)), S(1e12));
        const S alpha = lobe.width(beside);
        const S further = simd::min(simd::max(ahead_by, alpha * alpha), S(2) * alpha);
        const vec2<S> limit = normalized(horizon + vec2<S>{-horizon.y, horizon.x} * further);
        auto within = simd::both(before > S(0), limit.y > S(0)); // less than half a turn from the first
        if constexpr (has_axis) within = simd::both(within, !region.along_light);
        last_ = select(simd::both(within, cross(limit, last_) > S(0)), limit, last_);
        const auto empty = simd::both(cross(first_, last_) <= S(0), dot(first_, last_) > S(-0.5));

        const S determinant = simd::mul_add(cosine.m00, cosine.m22, -(cosine.m02 * cosine.m20));
        const S inverse = S(1) / simd::max(determinant, S(1e-30));
        back_ = {cosine.m00 * inverse, cosine.m02 * inverse, cosine.m20 * inverse,
                 cosine.m22 * inverse, S(1) / cosine.m11,    cosine.shear};
        toward_axis_ = back_(axis_);
        strength_ = simd::select(empty, S(0), inverse * back_.inverse_m11);
    }

    // work(p, strength) for each point; the receiver sees it under the solid angle strength/|p|³.
    template<class Work>
    GONIO_FORCE_INLINE void for_each(const Work& work) const {
        const Fan<S> around(first_, last_);
        if constexpr (simd::is_recorded<S>) {
            around.for_each(in_order<rule>(), takes_few_rows(),
                            [&](vec2<S> turned, S turn) { for_each_of_row(turned, turn, work); });
        } else {
            // One loop over each, so that its body is compiled once.
            vec2<S> turned[rows];
            S turn[rows];
            around.divide(rule, takes_few_rows(), &turned[0], &turn[0]);
            for (std::size_t k = 0; k < rows; ++k)
                if (simd::any(turn[k] > S(0))) for_each_of_row(turned[k], turn[k], work);
        }
    }

private:
    // The inverse of a cosine's transform.
    struct Back {
        S m00, m02, m20, m22; // over the determinant of the four
        S inverse_m11;
        [[no_unique_address]] decltype(Cosine::shear) shear;

        GONIO_FORCE_INLINE vec3<S> operator()(vec3<S> q) const {
            return {simd::mul_add(m22, q.x, -(m02 * q.z)), shear.undone(q.x, q.y) * inverse_m11,
                    simd::mul_add(m00, q.z, -(m20 * q.x))};
        }
    };

    // Of the rows along a light.
    GONIO_FORCE_INLINE simd::mask_of<S> takes_few_rows() const {
        if constexpr (has_axis && requires { region_.takes_few_rows; })
            return region_.takes_few_rows;
        else
            return S(1) < S(0);
    }

    template<class Work>
    GONIO_FORCE_INLINE void for_each_of_row(vec2<S> turned, S turn, const Work& work) const {
        const vec3<S> base = ahead_ * turned.x + inwards_ * turned.y;
        const RowPart<S> part = region_.row(base, axis_);

        // The half vector's slopes over α at a point of the part, and their change with τ: where the square of the
        // slopes is least, and how fast it grows. Elsewhere on the row the light could be below the horizon.
        const S last = simd::max(part.to, part.from);
        const vec3<S> toward_base = back_(base);
        S least = S(0); // towards z'
        if constexpr (has_axis) {
            constexpr double level = 1e-12;
            least = simd::select(base.z > S(level), axis_.z / simd::max(base.z, S(level)),
                                 simd::select(axis_.z > S(0), S(RowPart<S>::far), S(-RowPart<S>::far)));
        }
        S dr2 = S(1);
        S spread = S(1);
        S width = S(1); // spread/dr2
        for (int step = 0; step < (Lobe::is_even ? 1 : 2); ++step) {
            const S nearest = simd::min(simd::max(part.from, least), last);
            const vec3<S> toward_nearest = mul_add(toward_axis_, nearest, toward_base);
            const S inverse_base = S(1) / simd::sqrt(simd::max(dot(toward_nearest, toward_nearest), S(1e-36)));
            const vec3<S> l = toward_nearest * inverse_base;
            const vec3<S> change = (toward_axis_ - l * dot(l, toward_axis_)) * inverse_base;
            const vec3<S> h = l + v_;
            const S inverse_z = S(1) / simd::max(h.z, S(1e-6));
            const vec2<S> r = slopes_({h.x * inverse_z, h.y * inverse_z});
            const vec2<S> dr = slopes_({simd::mul_add(-(h.x * inverse_z), change.z, change.x) * inverse_z,
                                        simd::mul_add(-(h.y * inverse_z), change.z, change.y) * inverse_z});
            dr2 = simd::max(dot(dr, dr), S(1e-30));
            const S inverse_dr2 = S(1) / dr2;
            least = simd::mul_add(-dot(r, dr), inverse_dr2, nearest);
            const S aside = cross(r, dr);
            spread = simd::sqrt(simd::mul_add(aside, aside, dr2));
            width = spread * inverse_dr2;
        }

        if constexpr (!Lobe::is_even) {
            // Far from the part, where a row almost meets the axis, a second step may end so far away that the
            // difference to the part is lost. From here already the points are at nearly equal steps of τ.
            const S reach = S(1e3) * (last - part.from);
            least = simd::min(simd::max(least, part.from - reach), last + reach);
        }
        // In units of the width.
        const S inverse_width = dr2 / simd::max(spread, S(1e-30));
        const auto clamped = [&](S tau) __attribute__((always_inline)) {
            return simd::min(simd::max((tau - least) * inverse_width, S(-1e4)), S(1e4));
        };
        const S from = clamped(part.from);
        const S to = clamped(part.to);
        const Fan<S> along(from, to);
        const S strength = simd::select(from < to, strength_ * turn * width, S(0));
        // The direction at τ = least + width·y/x, times x.
        const vec3<S> by_x = mul_add(toward_axis_, least, toward_base);
        const vec3<S> by_y = toward_axis_ * width;
        const auto place = [&](vec2<S> at, S angle) __attribute__((always_inline)) {
            work(mul_add(by_x, at.x, by_y * at.y), angle * at.x * strength);
        };
        if constexpr (simd::is_recorded<S>) {
            along.for_each(in_order<Region::along_row>(), S(1) < S(0), place);
        } else {
            vec2<S> at[points_of_row];
            S angle[points_of_row];
            along.divide(Region::along_row, S(1) < S(0), &at[0], &angle[0]);
            for (std::size_t k = 0; k < points_of_row; ++k)
                place(at[k], angle[k]);
        }
    }

    const Region& region_;
    vec3<S> v_;
    vec3<S> axis_, ahead_, inwards_; // A; B at ω = 0 and at a quarter of a turn
    vec3<S> toward_axis_;
    vec2<S> first_, last_; // ω
    Back back_;
    decltype(std::declval<Lobe>().slopes()) slopes_;
    S strength_;
};

} // namespace gonio::shading::detail
