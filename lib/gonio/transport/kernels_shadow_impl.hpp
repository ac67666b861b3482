// The bodies of kernels_shadow.hpp, for one scalar: float, a pack of floats, or double. Included only by
// kernels_shadow_<set>.cpp; the rule of shading/kernels_impl.hpp applies here too.
#pragma once

#include <gonio/scene/hidden_cap.hpp>
#include <gonio/scene/light_lines.hpp>
#include <gonio/scene/shadow_edge.hpp>
#include <gonio/scene/shadow_line.hpp>
#include <gonio/scene/shadow_section.hpp>
#include <gonio/scene/unfused.hpp>
#include <gonio/simd/packet.hpp>
#include <gonio/transport/kernels_shadow.hpp>

#include <cstddef>
#include <type_traits>

namespace gonio::transport::detail {

using gonio::detail::HiddenPiece;
using gonio::detail::HiddenSlopes;
using gonio::detail::LightFrame;
using gonio::detail::LightLine;
using gonio::detail::LightLines;
using gonio::detail::LightLineSeen;
using gonio::detail::LinedLight;
using gonio::detail::ShadowBody;
using gonio::detail::ShadowEdge;
using gonio::detail::spread;
using shading::vec3;
namespace unfused = gonio::detail::unfused;

static_assert(ShadowShares::lines == gonio::detail::light_line_count);

// Numbers of one packet's lanes, in memory of the caller.
template<class S>
class LaneArray {
public:
    using value = simd::value_of<S>;

    explicit LaneArray(value* memory) : memory_(memory) {}

    GONIO_FORCE_INLINE S operator[](std::size_t i) const {
        S number;
        simd::load(memory_ + i * lanes, number);
        return number;
    }
    GONIO_FORCE_INLINE void set(std::size_t i, S number) const { simd::store(number, memory_ + i * lanes); }

    static constexpr std::size_t lanes = simd::Traits<S>::lanes;

private:
    value* memory_;
};

// The hidden pieces of one line, disjoint in each lane; empty ones where low > high. Pieces that were taken into
// another stay as empty ones, so the order of sums, and with it their bits, does not depend on the other lanes.
template<class S>
class HiddenPieces {
public:
    HiddenPieces() : bounds_(nullptr) {}
    explicit HiddenPieces(simd::value_of<S>* memory) : bounds_(memory) {}

    // Takes those that touch it into the new piece.
    GONIO_FORCE_INLINE void add(simd::mask_of<S> where, const HiddenSlopes<S>& piece) {
        S new_low = simd::select(where, piece.low, HiddenSlopes<S>().low);
        S new_high = simd::select(where, piece.high, HiddenSlopes<S>().high);
        for (std::size_t i = 0; i < count_; ++i) {
            const S low_i = low(i);
            const S high_i = high(i);
            const auto touches = simd::both(new_low <= high_i, low_i <= new_high);
            if (!simd::any(touches)) continue;
            new_low = simd::select(touches, simd::min(new_low, low_i), new_low);
            new_high = simd::select(touches, simd::max(new_high, high_i), new_high);
            set(i, simd::select(touches, HiddenSlopes<S>().low, low_i),
                simd::select(touches, HiddenSlopes<S>().high, high_i));
        }
        set(count_++, new_low, new_high);
    }
    // From slopes to sines above the lower end, which grow with them.
    GONIO_FORCE_INLINE void measure(const LightLine<S>& line) {
        const auto sine_of = [&](S slope) {
            const S within = simd::max(simd::min(line.sine_above_low(slope), line.width), S(0));
            return simd::select(slope >= line.high, line.width, within);
        };
        std::size_t left = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const auto is_there = low(i) < high(i);
            if (!simd::any(is_there)) continue;
            const S from = sine_of(low(i));
            const S to = sine_of(high(i));
            set(left++, simd::select(is_there, from, HiddenSlopes<S>().low),
                simd::select(is_there, to, HiddenSlopes<S>().high));
        }
        count_ = left;
    }
    GONIO_FORCE_INLINE S within(S from, S to) const {
        S sum(0);
        for (std::size_t i = 0; i < count_; ++i)
            sum = sum + simd::max(simd::min(high(i), to) - simd::max(low(i), from), S(0));
        return sum;
    }

private:
    GONIO_FORCE_INLINE S low(std::size_t i) const { return bounds_[2 * i]; }
    GONIO_FORCE_INLINE S high(std::size_t i) const { return bounds_[2 * i + 1]; }
    GONIO_FORCE_INLINE void set(std::size_t i, S low, S high) const {
        bounds_.set(2 * i, low);
        bounds_.set(2 * i + 1, high);
    }

    LaneArray<S> bounds_;
    std::size_t count_ = 0;
};

template<class D>
GONIO_FORCE_INLINE vec3<D> load_vector(const simd::Packet<D>& packet, const double* const (&from)[3]) {
    return {packet.load(from[0]), packet.load(from[1]), packet.load(from[2])};
}

// Where a body is before the light and near the ways from it.
template<class D>
GONIO_FORCE_INLINE simd::mask_of<D> may_hide_from(const vec3<D>& point, const gonio::detail::WaysFromSphere<D>& ways,
                                                  const ShadowBody& body) {
    auto may_hide = D(0) <= D(0);
    if (body.is_apart) may_hide = gonio::detail::is_before_light(body, point);
    return simd::any(may_hide) ? simd::both(may_hide, ways.may_meet(body)) : may_hide;
}

// The receivers of one packet. Where they are, and how light and bodies lie to them, is found in D, for the halves of
// the packet; the numbers that come of it are rounded to S. They are kept in rows, one number for each lane.
template<class S>
class ShadowedReceivers {
public:
    using D = simd::in_double<S>;
    using mask = simd::mask_of<S>;
    using Packet = simd::Packet<S>;

    ShadowedReceivers(const LinedLight& light, const ShadowBody* bodies, std::size_t body_count, std::byte* scratch)
        : light_(light), bodies_(bodies), body_count_(body_count), body_rows_(reinterpret_cast<double*>(scratch)) {
        auto* const pieces = reinterpret_cast<simd::value_of<S>*>(body_rows_ + body_count * rows_of_body * lanes);
        for (std::size_t i = 0; i < ShadowShares::lines; ++i)
            hidden_[i] = HiddenPieces<S>(pieces + i * 2 * body_count * lanes);
    }

    void find(const Packet& packet, const ShadowReceivers& receivers, const ShadowShares& to) {
        store(packet, S(1), to.visible);
        store(packet, S(ShadowShares::several), to.hiding);
        for (std::size_t half = 0; half < half_count; ++half)
            halves_[half].point = load_vector(half_of(packet, half), receivers.position);
        if (!find_near()) return;
        find_hint();
        if (!find_lines() || !find_hidden()) return;
        store(packet, integrate(packet, receivers, to), to.visible);
        store(packet, simd::select(hiders_ == S(1), hider_, S(ShadowShares::several)), to.hiding);
    }

private:
    static constexpr std::size_t lanes = simd::Traits<S>::lanes;
    static constexpr std::size_t half_lanes = simd::Traits<D>::lanes;
    static constexpr std::size_t half_count = lanes / half_lanes;
    static constexpr std::size_t rows_of_body = 1 + ShadowShares::numbers_of_body; // a mark: 1 or 0

    struct Half {
        vec3<D> point; // in the coordinates of the stage
        LightFrame<D> frame;
    };

    // A half of the packet; lanes that it does not have repeat the last one that there is.
    static simd::Packet<D> half_of(const Packet& packet, std::size_t half) {
        const std::size_t before = half * half_lanes;
        if (before + half_lanes <= packet.count) return {packet.first + before, half_lanes};
        if (before < packet.count) return {packet.first + before, packet.count - before};
        return {packet.first + packet.count - 1, 1};
    }
    GONIO_FORCE_INLINE static void store(const Packet& packet, S value, double* to) {
        if (packet.count == lanes) return simd::store_widened(value, to + packet.first);
        double wide[lanes];
        simd::store_widened(value, wide);
        for (std::size_t i = 0; i < packet.count; ++i)
            to[packet.first + i] = wide[i];
    }
    GONIO_FORCE_INLINE static void store(const Packet& packet, S value, float* to) {
        if constexpr (std::is_same_v<simd::value_of<S>, float>)
            packet.store(value, to);
        else
            to[packet.first] = static_cast<float>(value);
    }
    // A number of all lanes from those of the halves: get(half).
    template<class Get>
    GONIO_FORCE_INLINE S rounded(const Get& get) const {
        double row[lanes];
        for (std::size_t half = 0; half < half_count; ++half)
            simd::store(get(halves_[half]), row + half * half_lanes);
        return at(row);
    }
    GONIO_FORCE_INLINE static S at(const double* row) {
        S number;
        simd::load_rounded(row, number);
        return number;
    }
    GONIO_FORCE_INLINE static D half_at(const double* row, std::size_t half) {
        D number;
        simd::load(row + half * half_lanes, number);
        return number;
    }
    GONIO_FORCE_INLINE static void put_half(D number, double* row, std::size_t half) {
        simd::store(number, row + half * half_lanes);
    }
    template<class Get>
    GONIO_FORCE_INLINE vec3<S> rounded_vector(const Get& get) const {
        return {rounded([&](const Half& half) { return get(half).x; }),
                rounded([&](const Half& half) { return get(half).y; }),
                rounded([&](const Half& half) { return get(half).z; })};
    }
    GONIO_FORCE_INLINE double* mark_of(std::size_t body) const { return body_rows_ + body * rows_of_body * lanes; }
    GONIO_FORCE_INLINE double* row_of(std::size_t body, std::size_t number) const {
        return mark_of(body) + (1 + number) * lanes;
    }
    GONIO_FORCE_INLINE mask is_near(std::size_t body) const { return at(mark_of(body)) == S(1); }

    // Marks the bodies that may hide something.
    bool find_near() {
        bool is_any = false;
        for (std::size_t half = 0; half < half_count; ++half) {
            const vec3<D>& point = halves_[half].point;
            const gonio::detail::WaysFromSphere<D> ways(point, light_.around, light_.around_radius);
            bool is_any_here = false;
            bool is_any_beside = false;
            for (std::size_t i = 0; i < body_count_; ++i) {
                const auto may_hide = may_hide_from(point, ways, bodies_[i]);
                const bool is_any_body = simd::any(may_hide);
                is_any_here = is_any_here || is_any_body;
                is_any_beside =
                    is_any_beside || (is_any_body && gonio::detail::SidesOfWays<D>::may_be_beside(light_, bodies_[i]));
                put_half(simd::select(may_hide, D(1), D(0)), mark_of(i), half);
            }
            if (is_any_beside) is_any_here = find_beside(half);
            is_any = is_any || is_any_here;
        }
        return is_any;
    }

    // Unmarks those that are beside all ways; returns whether one is left.
    bool find_beside(std::size_t half) {
        const gonio::detail::SidesOfWays<D> sides(light_, halves_[half].point);
        bool is_any = false;
        for (std::size_t i = 0; i < body_count_; ++i) {
            const auto is_marked = half_at(mark_of(i), half) == D(1);
            if (!simd::any(is_marked)) continue;
            const auto may_hide = simd::both(is_marked, sides.may_meet(bodies_[i]));
            is_any = is_any || simd::any(may_hide);
            put_half(simd::select(may_hide, D(1), D(0)), mark_of(i), half);
        }
        return is_any;
    }

    // A direction across the edge that is seen nearest to the middle of the light.
    void find_hint() {
        const vec3<S> to_light =
            rounded_vector([&](const Half& half) { return spread<D>(light_.around) - half.point; });
        const vec3<S> towards = to_light * shading::reciprocal_or_zero(unfused::length(to_light));
        const gonio::detail::NearestEdge<S> nearest_edge(towards);
        ShadowEdge<S> nearest;
        for (std::size_t i = 0; i < body_count_; ++i) {
            const mask near = is_near(i);
            if (!simd::any(near)) continue;
            const ShadowEdge<S> edge = nearest_edge(bodies_[i], rounded_vector([&](const Half& half) {
                                                        return spread<D>(bodies_[i].middle) - half.point;
                                                    }));
            nearest.take(simd::both(near, edge.away < nearest.away), edge);
        }
        // Rotated a little: other edges are often perpendicular to this one, and lines parallel to an edge are either
        // wholly hidden or not at all.
        constexpr double turn = 0.6; // tangent of the angle
        const vec3<S> straight = nearest.across - towards * unfused::dot(nearest.across, towards);
        const vec3<S> hint = straight + unfused::cross(towards, straight) * S(turn);
        simd::store_widened(hint.x, hint_[0]);
        simd::store_widened(hint.y, hint_[1]);
        simd::store_widened(hint.z, hint_[2]);
    }

    bool find_lines() {
        bool is_any = false;
        double rows[LightFrame<D>::numbers + 1][lanes];
        for (std::size_t half = 0; half < half_count; ++half) {
            LightFrame<D>& frame = halves_[half].frame;
            frame = gonio::detail::light_frame(
                light_, halves_[half].point,
                vec3<D>{half_at(hint_[0], half), half_at(hint_[1], half), half_at(hint_[2], half)});
            is_any = is_any || simd::any(frame.is_seen);
            D numbers[LightFrame<D>::numbers];
            frame.put(numbers);
            for (std::size_t i = 0; i < LightFrame<D>::numbers; ++i)
                put_half(numbers[i], rows[i], half);
            put_half(simd::select(frame.is_seen, D(1), D(0)), rows[LightFrame<D>::numbers], half);
        }
        if (!is_any) return false;
        S numbers[LightFrame<S>::numbers];
        for (std::size_t i = 0; i < LightFrame<S>::numbers; ++i)
            numbers[i] = at(rows[i]);
        seen_.frame = LightFrame<S>::of(numbers, at(rows[LightFrame<S>::numbers]) == S(1));
        gonio::detail::find_light_lines(light_, seen_);
        return true;
    }

    // Which pieces of the lines are hidden.
    bool find_hidden() {
        const gonio::detail::LightSides<S> sides(seen_);
        hiders_ = S(0);
        hider_ = S(0);
        for (std::size_t i = 0; i < body_count_; ++i) {
            const mask near = simd::both(is_near(i), seen_.frame.is_seen);
            if (!simd::any(near)) continue;
            const mask hides = bodies_[i].is_apart ? add_section(i, sides) : add_slopes(i);
            hiders_ = hiders_ + simd::select(hides, S(1), S(0));
            hider_ = simd::select(hides, S(static_cast<float>(i)), hider_);
        }
        if (!simd::any(hiders_ > S(0))) return false;
        for (std::size_t i = 0; i < ShadowShares::lines; ++i)
            hidden_[i].measure(seen_.lines[i]);
        return true;
    }

    // Lets find(half, where, numbers) find `count` numbers of the body; where they are of use.
    template<class Find>
    GONIO_FORCE_INLINE mask find_numbers(std::size_t body, std::size_t count, const Find& find) {
        for (std::size_t half = 0; half < half_count; ++half) {
            const auto where = simd::both(half_at(mark_of(body), half) == D(1), halves_[half].frame.is_seen);
            D numbers[ShadowShares::numbers_of_body];
            const auto is_found = find(halves_[half], where, numbers);
            put_half(simd::select(is_found, D(1), D(0)), mark_of(body), half);
            for (std::size_t i = 0; i < count; ++i)
                put_half(numbers[i], row_of(body, i), half);
        }
        return is_near(body);
    }

    // Of a body that is apart from the light.
    mask add_section(std::size_t i, const gonio::detail::LightSides<S>& sides) {
        const ShadowBody& body = bodies_[i];
        return gonio::detail::with_section<S>(body, [&]<class Section>(const Section* /*type*/) {
            static_assert(Section::numbers <= ShadowShares::numbers_of_body);
            const mask near = find_numbers(i, Section::numbers, [&](const Half& half, auto where, D* numbers) {
                return simd::both(where, Section::put(body, half.point, half.frame, numbers));
            });
            if (!simd::any(near)) return near;
            S numbers[ShadowShares::numbers_of_body];
            for (std::size_t number = 0; number < Section::numbers; ++number)
                numbers[number] = at(row_of(i, number));
            mask may_hide = near;
            if constexpr (Section::numbers > 0)
                may_hide =
                    simd::both(near, !sides.template is_beside<Section::half_axes>(numbers, spread<S>(body.radius)));
            if (!simd::any(may_hide)) return may_hide;
            const Section section(body, numbers, seen_.frame.rise);
            return add_pieces(may_hide, [&](std::size_t line) { return section.hidden(seen_.lines[line]); });
        });
    }
    // Of one that may enter the light's bounding sphere: what the lines themselves show, in D.
    mask add_slopes(std::size_t i) {
        const mask near =
            find_numbers(i, 2 * ShadowShares::lines, [&](const Half& half, simd::mask_of<D> where, D* numbers) {
                return find_slopes(bodies_[i], half, where, numbers);
            });
        if (!simd::any(near)) return near;
        return add_pieces(near, [&](std::size_t line) {
            return HiddenSlopes<S>{simd::max(at(row_of(i, 2 * line)), seen_.lines[line].low),
                                   simd::min(at(row_of(i, 2 * line + 1)), seen_.lines[line].high)};
        });
    }
    simd::mask_of<D> find_slopes(const ShadowBody& body, const Half& half, simd::mask_of<D> where, D* slopes) const {
        gonio::detail::LightLines<D> seen;
        seen.frame = half.frame;
        gonio::detail::find_light_lines(light_, seen);
        return gonio::detail::with_hiding(body, half.point, [&](const auto& hiding) {
            simd::mask_of<D> hides = D(1) < D(0);
            for (std::size_t i = 0; i < ShadowShares::lines; ++i) {
                const LightLine<D>& line = seen.lines[i];
                const HiddenPiece<D> piece = hiding.hidden(LightLineSeen<D>(
                    seen.position(line, line.low_x, line.low), seen.position(line, line.high_x, line.high)));
                const auto slope_at = [&](D t) {
                    const D low_y = line.low_x * line.low;
                    const D x = line.low_x + t * (line.high_x - line.low_x);
                    const D y = low_y + t * (line.high_x * line.high - low_y);
                    return y / x;
                };
                const auto is_hidden = simd::both(where, piece.is_there());
                const HiddenSlopes<D> none;
                const D low = simd::select(piece.low <= D(0), none.high, slope_at(piece.low));
                const D high = simd::select(piece.high >= D(1), none.low, slope_at(piece.high));
                slopes[2 * i] = simd::select(is_hidden, low, none.low);
                slopes[2 * i + 1] = simd::select(is_hidden, high, none.high);
                hides = simd::either(hides, is_hidden);
            }
            return hides;
        });
    }
    // Where the body hides some piece; hidden(line).
    template<class Hidden>
    GONIO_FORCE_INLINE mask add_pieces(mask near, const Hidden& hidden) {
        mask hides = S(1) < S(0);
        for (std::size_t i = 0; i < ShadowShares::lines; ++i) {
            const HiddenSlopes<S> piece = hidden(i);
            const mask where = simd::both(near, piece.is_there());
            if (!simd::any(where)) continue;
            hidden_[i].add(where, piece);
            hides = simd::either(hides, where);
        }
        return hides;
    }

    // The share of the illuminance that the lines let through.
    S integrate(const Packet& packet, const ShadowReceivers& receivers, const ShadowShares& to) const {
        double normal[3][lanes];
        for (std::size_t half = 0; half < half_count; ++half) {
            const vec3<D> n = load_vector(half_of(packet, half), receivers.normal);
            const LightFrame<D>& frame = halves_[half].frame;
            put_half(unfused::dot(n, frame.axis), normal[0], half);
            put_half(unfused::dot(n, frame.forward), normal[1], half);
            put_half(unfused::dot(n, frame.side), normal[2], half);
        }
        S all(0);
        S seen(0);
        S all_above(0);
        S seen_above(0);
        S least_seen(1);
        S most_seen(0);
        const vec3<S> n{at(normal[0]), at(normal[1]), at(normal[2])};
        for (std::size_t i = 0; i < ShadowShares::lines; ++i) {
            const LightLine<S>& line = seen_.lines[i];
            const S n_across = n.y * line.cosine + n.z * line.sine;
            const S cell_width = line.width * S(1.0 / ShadowShares::cells_of_line);
            const S solid_angle = line.solid_angle();
            const auto is_wide = cell_width > S(0);
            const S per_width = S(1) / simd::select(is_wide, cell_width, S(1));
            S from(0);
            for (std::size_t cell = 0; cell < ShadowShares::cells_of_line; ++cell) {
                const bool is_last = cell + 1 == ShadowShares::cells_of_line;
                const S to_end = is_last ? line.width : cell_width * S(static_cast<float>(cell + 1));
                const S hidden = hidden_[i].within(from, to_end);
                const auto is_hidden = simd::both(hidden > S(0), hidden >= to_end - from);
                const S shown = simd::select(is_hidden, S(0), simd::max(S(1) - hidden * per_width, S(0)));
                const S share = simd::select(is_wide, shown, S(1));
                const S up = line.low_sine + cell_width * S(static_cast<float>(cell) + 0.5F);
                const S out = simd::sqrt(simd::max((S(1) - up) * (S(1) + up), S(0)));
                const S weight = solid_angle * simd::max(n.x * up + n_across * out, S(0));
                all = all + solid_angle;
                seen = seen + solid_angle * share;
                all_above = all_above + weight;
                seen_above = seen_above + weight * share;
                least_seen = simd::min(least_seen, share);
                most_seen = simd::max(most_seen, simd::select(is_wide, share, S(0)));
                from = to_end;
                if (to.seen != nullptr) {
                    const std::size_t first = (i * ShadowShares::cells_of_line + cell) * to.stride;
                    const vec3<S> towards = seen_.direction(line, up);
                    store(packet, share, to.seen + first);
                    store(packet, solid_angle, to.solid_angle + first);
                    store(packet, towards.x, to.towards[0] + first);
                    store(packet, towards.y, to.towards[1] + first);
                    store(packet, towards.z, to.towards[2] + first);
                }
            }
        }
        // If no cell has its middle above the horizon, a sliver of the light is.
        const auto is_above = all_above > S(0);
        const auto is_there = all > S(0);
        const S of_all = simd::select(is_there, simd::min(seen / simd::select(is_there, all, S(1)), S(1)), S(1));
        const S of_above = simd::min(seen_above / simd::select(is_above, all_above, S(1)), S(1));
        const S share = simd::select(is_above, of_above, of_all);
        const auto is_whole = simd::either(simd::either(!seen_.frame.is_seen, hiders_ == S(0)), least_seen == S(1));
        return simd::select(is_whole, S(1), simd::select(most_seen == S(0), S(0), share));
    }

    const LinedLight& light_;
    const ShadowBody* bodies_;
    std::size_t body_count_;
    double* body_rows_; // of each body a mark, and numbers
    Half halves_[half_count];
    double hint_[3][lanes];
    LightLines<S> seen_;
    HiddenPieces<S> hidden_[ShadowShares::lines];
    S hiders_; // the number of bodies that hide something, and the last of them
    S hider_;
};

template<class S>
void visible_shares(const LinedLight& light, const ShadowBody* bodies, std::size_t body_count,
                    const ShadowReceivers& receivers, std::byte* scratch, const ShadowShares& to) {
    simd::for_each_packet<simd::Packet<S>>(receivers.count, [&](const simd::Packet<S>& packet) {
        ShadowedReceivers<S>(light, bodies, body_count, scratch).find(packet, receivers, to);
    });
}

template<class S>
void near_bodies(const LinedLight& light, const ShadowBody* bodies, std::size_t body_count,
                 const ShadowReceivers& receivers, double* near) {
    using D = simd::in_double<S>;
    simd::for_each_packet<simd::Packet<D>>(receivers.count, [&](const simd::Packet<D>& packet) {
        const vec3<D> point = load_vector(packet, receivers.position);
        const gonio::detail::WaysFromSphere<D> ways(point, light.around, light.around_radius);
        D found(NearBodies::none);
        for (std::size_t i = 0; i < body_count; ++i) {
            const auto may_hide = may_hide_from(point, ways, bodies[i]);
            const D with_it =
                simd::select(found == D(NearBodies::none), D(static_cast<double>(i)), D(NearBodies::several));
            found = simd::select(may_hide, with_it, found);
        }
        packet.store(found, near);
    });
}

template<class S>
void share_past_balls(const LinedLight& light, const ReceiversBehindBalls& of, double* share) {
    using D = simd::in_double<S>;
    const vec3<D> center = spread<D>(light.center);
    const ShadowReceivers& receivers = of.receivers;
    simd::for_each_packet<simd::Packet<D>>(receivers.count, [&](const simd::Packet<D>& packet) {
        const vec3<D> point = load_vector(packet, receivers.position);
        const vec3<D> to_ball = load_vector(packet, of.middle) - point;
        packet.store(gonio::detail::share_past_ball<D>(center - point, D(light.radius), to_ball, packet.load(of.radius),
                                                       load_vector(packet, receivers.normal)),
                     share);
    });
}

extern const ShadowKernels kernels_shadow_scalar;
extern const ShadowKernels kernels_shadow_sse2;
extern const ShadowKernels kernels_shadow_avx2;
extern const ShadowKernels kernels_shadow_avx512;
extern const ShadowKernels kernels_shadow_neon;
extern const ShadowKernels kernels_shadow_wasm128;

} // namespace gonio::transport::detail
