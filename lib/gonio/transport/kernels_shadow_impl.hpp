// The bodies of kernels_shadow.hpp, for one scalar: double or simd::doubles. Included only by kernels_shadow_<set>.cpp;
// the rule of shading/kernels_impl.hpp applies here too.
#pragma once

#include <gonio/scene/light_lines.hpp>
#include <gonio/scene/shadow_edge.hpp>
#include <gonio/scene/shadow_line.hpp>
#include <gonio/simd/packet.hpp>
#include <gonio/transport/kernels_shadow.hpp>

#include <cstddef>

namespace gonio::transport::detail {

using gonio::detail::HiddenPiece;
using gonio::detail::LightLine;
using gonio::detail::LightLines;
using gonio::detail::LightLineSeen;
using gonio::detail::LinedLight;
using gonio::detail::ShadowBody;
using gonio::detail::ShadowEdge;
using gonio::detail::spread;
using shading::vec3;

static_assert(ShadowShares::lines == gonio::detail::light_line_count);

// Numbers of one packet's lanes, in memory of the caller.
template<class S>
class LaneArray {
public:
    explicit LaneArray(double* memory) : memory_(memory) {}

    GONIO_FORCE_INLINE S operator[](std::size_t i) const {
        S value;
        simd::load(memory_ + i * lanes, value);
        return value;
    }
    GONIO_FORCE_INLINE void set(std::size_t i, S value) const { simd::store(value, memory_ + i * lanes); }

    static constexpr std::size_t lanes = simd::Traits<S>::lanes;

private:
    double* memory_;
};

// The hidden pieces of one line, disjoint in each lane; empty ones from 2 to −1. Pieces that were taken into another
// stay as empty ones, so the order of sums, and with it their bits, does not depend on the other lanes.
template<class S>
class HiddenPieces {
public:
    HiddenPieces() : bounds_(nullptr) {}
    explicit HiddenPieces(double* memory) : bounds_(memory) {}

    std::size_t count() const { return count_; }
    GONIO_FORCE_INLINE S low(std::size_t i) const { return bounds_[2 * i]; }
    GONIO_FORCE_INLINE S high(std::size_t i) const { return bounds_[2 * i + 1]; }

    // Takes those that touch it into the new piece.
    GONIO_FORCE_INLINE void add(simd::mask_of<S> where, const HiddenPiece<S>& piece) {
        S new_low = simd::select(where, piece.low, S(2));
        S new_high = simd::select(where, piece.high, S(-1));
        for (std::size_t i = 0; i < count_; ++i) {
            const S low_i = low(i);
            const S high_i = high(i);
            const auto touches = simd::both(new_low <= high_i, low_i <= new_high);
            new_low = simd::select(touches, simd::min(new_low, low_i), new_low);
            new_high = simd::select(touches, simd::max(new_high, high_i), new_high);
            set(i, simd::select(touches, S(2), low_i), simd::select(touches, S(-1), high_i));
        }
        set(count_++, new_low, new_high);
    }
    // From positions on a line to sines of the elevation, which grow with them.
    GONIO_FORCE_INLINE void measure(const LightLines<S>& lines, const LightLine<S>& line,
                                    const LightLineSeen<S>& seen) {
        const auto sine_at = [&](S t) {
            const S within = lines.sine_of(seen.at(t));
            return simd::select(t <= S(0), line.low, simd::select(t >= S(1), line.high, within));
        };
        for (std::size_t i = 0; i < count_; ++i) {
            const auto is_there = low(i) < high(i);
            set(i, simd::select(is_there, sine_at(low(i)), S(2)), simd::select(is_there, sine_at(high(i)), S(-2)));
        }
    }
    GONIO_FORCE_INLINE S within(S from, S to) const {
        S sum(0);
        for (std::size_t i = 0; i < count_; ++i)
            sum = sum + simd::max(simd::min(high(i), to) - simd::max(low(i), from), S(0));
        return sum;
    }

private:
    GONIO_FORCE_INLINE void set(std::size_t i, S low, S high) const {
        bounds_.set(2 * i, low);
        bounds_.set(2 * i + 1, high);
    }

    LaneArray<S> bounds_;
    std::size_t count_ = 0;
};

// The receivers of one packet.
template<class S>
class ShadowedReceivers {
public:
    using mask = simd::mask_of<S>;
    using Packet = simd::Packet<S>;

    ShadowedReceivers(const LinedLight& light, const ShadowBody* bodies, std::size_t body_count, double* scratch)
        : light_(light), bodies_(bodies), body_count_(body_count), is_near_(scratch) {
        double* const pieces = scratch + body_count * LaneArray<S>::lanes;
        for (std::size_t i = 0; i < ShadowShares::lines; ++i)
            hidden_[i] = HiddenPieces<S>(pieces + i * 2 * body_count * LaneArray<S>::lanes);
    }

    void find(const Packet& packet, const ShadowReceivers& receivers, const ShadowShares& to) {
        point_ = {packet.load(receivers.position[0]), packet.load(receivers.position[1]),
                  packet.load(receivers.position[2])};
        packet.store(S(1), to.visible);
        packet.store(S(ShadowShares::several), to.hiding);
        if (!find_near()) return;
        lines_ = gonio::detail::light_lines(light_, point_, hint_);
        if (!simd::any(lines_.is_seen) || !find_hidden()) return;
        const vec3<S> normal{packet.load(receivers.normal[0]), packet.load(receivers.normal[1]),
                             packet.load(receivers.normal[2])};
        packet.store(integrate(packet, normal, to), to.visible);
        packet.store(simd::select(hiders_ == S(1), hider_, S(ShadowShares::several)), to.hiding);
    }

private:
    // Which bodies may hide something, and a direction across the edge nearest to the middle of the light.
    bool find_near() {
        const vec3<S> light_center = spread<S>(light_.around);
        const S light_radius(light_.around_radius);
        const vec3<S> to_light = light_center - point_;
        const S distance = length(to_light);
        const vec3<S> towards = to_light * shading::reciprocal_or_zero(distance);
        // Near a wide light, its bounding sphere is all around.
        const auto is_within = distance <= light_radius;
        const S half_angle = simd::select(is_within, S(3.14159265358979323846),
                                          simd::arc_sine(simd::select(is_within, S(0), light_radius / distance)));
        const gonio::detail::NearestEdge<S> nearest_edge(point_, towards);
        ShadowEdge<S> nearest;
        bool is_any = false;
        for (std::size_t i = 0; i < body_count_; ++i) {
            const ShadowBody& body = bodies_[i];
            mask is_near =
                simd::both(distance > S(0), gonio::detail::may_stand_before(body, point_, light_center, light_radius));
            if (simd::any(is_near)) {
                const ShadowEdge<S> edge = nearest_edge(body);
                // Leaves out a solid beside the light that does not overlap it. One without an edge in front of the
                // light may also cover all of it, so the ray to the middle is tested.
                const auto is_beside = edge.distance > half_angle * S(1.0 + 1e-9);
                if (body.is_apart && simd::any(simd::both(is_near, is_beside)))
                    is_near = simd::both(is_near, simd::either(!is_beside, blocks(body, to_light)));
                nearest.take(simd::both(is_near, simd::abs(edge.distance) < simd::abs(nearest.distance)), edge);
                is_any = is_any || simd::any(is_near);
            }
            is_near_.set(i, simd::select(is_near, S(1), S(0)));
        }
        // Rotated a little: other edges are often perpendicular to this one, and lines parallel to an edge are either
        // wholly hidden or not at all.
        constexpr double turn = 0.6; // tangent of the angle
        const vec3<S> straight = nearest.across - towards * dot(nearest.across, towards);
        hint_ = straight + cross(towards, straight) * S(turn);
        return is_any;
    }

    mask blocks(const ShadowBody& body, const vec3<S>& way) const {
        return gonio::detail::with_hiding(body, point_, [&](const auto& hiding) { return hiding.blocks(way); });
    }

    // Which pieces of the lines are hidden.
    bool find_hidden() {
        for (std::size_t i = 0; i < ShadowShares::lines; ++i)
            seen_[i] = LightLineSeen<S>(lines_.lines[i].from, lines_.lines[i].to);
        hiders_ = S(0);
        hider_ = S(0);
        for (std::size_t i = 0; i < body_count_; ++i) {
            const mask is_near = simd::both(is_near_[i] == S(1), lines_.is_seen);
            if (!simd::any(is_near)) continue;
            const mask hides = gonio::detail::with_hiding(
                bodies_[i], point_, [&](const auto& hiding) { return add_pieces(hiding, is_near); });
            hiders_ = hiders_ + simd::select(hides, S(1), S(0));
            hider_ = simd::select(hides, S(static_cast<double>(i)), hider_);
        }
        for (std::size_t i = 0; i < ShadowShares::lines; ++i)
            hidden_[i].measure(lines_, lines_.lines[i], seen_[i]);
        return simd::any(hiders_ > S(0));
    }

    // Where the body hides some piece.
    template<class Hiding>
    mask add_pieces(const Hiding& hiding, mask is_near) {
        mask hides = S(1) < S(0);
        for (std::size_t i = 0; i < ShadowShares::lines; ++i) {
            const HiddenPiece<S> piece = hiding.hidden(seen_[i]);
            const mask where = simd::both(is_near, piece.is_there());
            if (!simd::any(where)) continue;
            hidden_[i].add(where, piece);
            hides = simd::either(hides, where);
        }
        return hides;
    }

    // The share of the illuminance that the lines let through.
    S integrate(const Packet& packet, const vec3<S>& normal, const ShadowShares& to) {
        S all(0);
        S seen(0);
        S all_above(0);
        S seen_above(0);
        S least_seen(1);
        S most_seen(0);
        for (std::size_t i = 0; i < ShadowShares::lines; ++i) {
            const LightLine<S>& line = lines_.lines[i];
            const S solid_angle = line.solid_angle();
            const S width = (line.high - line.low) * S(1.0 / ShadowShares::cells_of_line);
            const auto is_wide = width > S(0);
            const S per_width = S(1) / simd::select(is_wide, width, S(1));
            S from = line.low;
            for (std::size_t cell = 0; cell < ShadowShares::cells_of_line; ++cell) {
                const bool is_last = cell + 1 == ShadowShares::cells_of_line;
                const S to_end = is_last ? line.high : line.low + width * S(static_cast<double>(cell + 1));
                const S hidden = hidden_[i].within(from, to_end);
                const auto is_hidden = simd::both(hidden > S(0), hidden >= to_end - from);
                const S shown = simd::select(is_hidden, S(0), simd::max(S(1) - hidden * per_width, S(0)));
                const S share = simd::select(is_wide, shown, S(1));
                const vec3<S> towards = lines_.direction(
                    line, line.low + (line.high - line.low) * S((static_cast<double>(cell) + 0.5) /
                                                                static_cast<double>(ShadowShares::cells_of_line)));
                const S weight = solid_angle * simd::max(dot(normal, towards), S(0));
                all = all + solid_angle;
                seen = seen + solid_angle * share;
                all_above = all_above + weight;
                seen_above = seen_above + weight * share;
                least_seen = simd::min(least_seen, share);
                most_seen = simd::max(most_seen, simd::select(is_wide, share, S(0)));
                from = to_end;
                if (to.seen != nullptr) {
                    const std::size_t first = (i * ShadowShares::cells_of_line + cell) * to.stride;
                    packet.store(share, to.seen + first);
                    packet.store(solid_angle, to.solid_angle + first);
                    packet.store(towards.x, to.towards[0] + first);
                    packet.store(towards.y, to.towards[1] + first);
                    packet.store(towards.z, to.towards[2] + first);
                }
            }
        }
        // If no cell has its middle above the horizon, a sliver of the light is.
        const auto is_above = all_above > S(0);
        const auto is_there = all > S(0);
        const S of_all = simd::select(is_there, simd::min(seen / simd::select(is_there, all, S(1)), S(1)), S(1));
        const S of_above = simd::min(seen_above / simd::select(is_above, all_above, S(1)), S(1));
        const S share = simd::select(is_above, of_above, of_all);
        const auto is_whole = simd::either(simd::either(!lines_.is_seen, hiders_ == S(0)), least_seen == S(1));
        return simd::select(is_whole, S(1), simd::select(most_seen == S(0), S(0), share));
    }

    const LinedLight& light_;
    const ShadowBody* bodies_;
    std::size_t body_count_;
    LaneArray<S> is_near_; // of each body, 1 or 0
    HiddenPieces<S> hidden_[ShadowShares::lines];

    vec3<S> point_;
    vec3<S> hint_;
    LightLines<S> lines_;
    LightLineSeen<S> seen_[ShadowShares::lines];
    S hiders_; // the number of bodies that hide something, and the last of them
    S hider_;
};

template<class S>
void visible_shares(const LinedLight& light, const ShadowBody* bodies, std::size_t body_count,
                    const ShadowReceivers& receivers, double* scratch, const ShadowShares& to) {
    simd::for_each_packet<simd::Packet<S>>(receivers.count, [&](const simd::Packet<S>& packet) {
        ShadowedReceivers<S>(light, bodies, body_count, scratch).find(packet, receivers, to);
    });
}

extern const ShadowKernels kernels_shadow_scalar;
extern const ShadowKernels kernels_shadow_sse2;
extern const ShadowKernels kernels_shadow_avx2;
extern const ShadowKernels kernels_shadow_avx512;
extern const ShadowKernels kernels_shadow_neon;
extern const ShadowKernels kernels_shadow_wasm128;

} // namespace gonio::transport::detail
