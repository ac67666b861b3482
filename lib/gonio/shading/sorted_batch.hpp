// The exact irradiance of many receivers, sorted so that those in a packet have a similar horizon relative to the
// light.
//
// A packet takes as long as the slowest of its lanes, so lanes that the horizon cuts, lanes that see all of the light
// and lanes that see nothing should not share one. Receivers are taken in blocks and classified by height and reach,
// and for a tube also by their position. A block of one kind is computed in place; otherwise the receivers are copied
// into one queue per kind and packed full. Which packet a receiver gets into depends on the arrays alone.
#pragma once

#include <gonio/shading/irradiance_area.hpp>
#include <gonio/shading/packet.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::shading::detail {

inline constexpr std::size_t receivers_per_block = 256;
inline constexpr std::size_t most_lanes = 32;
inline constexpr std::size_t queue_length = 2 * receivers_per_block + 4 * most_lanes;

template<class Light>
inline constexpr bool is_tube = false;
template<class S>
inline constexpr bool is_tube<TubeLight<S>> = true;

// The integers first, first + 1, … as bits of lanes, to be stored and moved but not used in arithmetic.
template<class S>
GONIO_FORCE_INLINE S places(std::size_t first) {
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    float numbers[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane)
        numbers[lane] = __builtin_bit_cast(float, static_cast<std::int32_t>(lane));
    S steps;
    simd::load(&numbers[0], steps);
    S all;
    simd::from_bits(simd::bits(steps) + static_cast<std::int32_t>(first), all);
    return all;
}
GONIO_FORCE_INLINE std::size_t place_of(float bits) {
    return static_cast<std::size_t>(__builtin_bit_cast(std::int32_t, bits));
}

// True if the form above the horizon is so cheap that classification would take as long: all receivers are computed
// that way, and only those that the horizon cuts are copied.
template<class Light>
inline constexpr bool is_cheap_above = false;
template<class S>
inline constexpr bool is_cheap_above<SphereLight<S>> = true;

// How far the light reaches from its centre along the receiver's normal, up and down.
template<class S>
GONIO_FORCE_INLINE S reach(const SphereLight<S>& light, vec3<S> /*normal*/) {
    return simd::abs(light.radius);
}
template<class S>
GONIO_FORCE_INLINE S reach(const DiskLight<S>& light, vec3<S> normal) {
    const S cosine = dot(normal, light.axis);
    return simd::abs(light.radius) * simd::sqrt(simd::max(S(1) - cosine * cosine, S(0)));
}
template<class S>
GONIO_FORCE_INLINE S reach(const RectangleLight<S>& light, vec3<S> normal) {
    const S along_x = simd::abs(dot(normal, light.width_direction));
    const S along_y = simd::abs(dot(normal, cross(light.axis, light.width_direction)));
    return S(0.5) * simd::mul_add(along_x, simd::abs(light.width), along_y * simd::abs(light.height));
}
template<class S>
GONIO_FORCE_INLINE S reach(const TubeLight<S>& light, vec3<S> normal) {
    const S along = simd::abs(dot(normal, light.axis));
    return simd::mul_add(along, S(0.5) * simd::abs(light.length), simd::abs(light.radius));
}

// Receivers of one kind, gathered from several places. S: the type used to compute them.
template<class S>
struct ReceiverQueue {
    std::size_t count = 0;
    // Rows of queue_length: position, normal, and the place in the arrays.
    static constexpr std::size_t rows = 7;
    float values[rows * queue_length];

    // Values beyond `count` are not read, and filling them would take as long as a packet.
    ReceiverQueue() {} // NOLINT(*-member-init, *-use-equals-default)

    GONIO_FORCE_INLINE void add(std::uint32_t lanes_chosen, const SurfacePoint<S>& point, S places) {
        const simd::Choice<S> which(lanes_chosen);
        // A local pointer: for all the compiler knows, storing a packet may overwrite anything, including `count`.
        float* const to = row(0) + count;
        simd::store_chosen(which, point.position.x, to);
        simd::store_chosen(which, point.position.y, to + queue_length);
        simd::store_chosen(which, point.position.z, to + 2 * queue_length);
        simd::store_chosen(which, point.normal.x, to + 3 * queue_length);
        simd::store_chosen(which, point.normal.y, to + 4 * queue_length);
        simd::store_chosen(which, point.normal.z, to + 5 * queue_length);
        simd::store_chosen(which, places, to + 6 * queue_length);
        count += simd::bit_count(lanes_chosen);
    }

    // Repeats the last receiver until a packet is full, and beyond.
    void pad() {
        for (std::size_t k = 0; k < rows; ++k)
            simd::store(S(row(k)[count - 1]), row(k) + count);
    }

    // Drops all but fewer than a packet.
    void drop(std::size_t first_ones) {
        for (std::size_t k = 0; k < rows; ++k)
            copy(row(k) + first_ones, row(k));
        count -= first_ones;
    }

    // Takes fewer than a packet.
    void append(const ReceiverQueue& other) {
        for (std::size_t k = 0; k < rows; ++k)
            copy(other.row(k), row(k) + count);
        count += other.count;
    }

    [[nodiscard]] float* row(std::size_t k) { return &values[k * queue_length]; }
    [[nodiscard]] const float* row(std::size_t k) const { return &values[k * queue_length]; }
    [[nodiscard]] Surfaces surfaces() const {
        Surfaces all;
        for (std::size_t k = 0; k < 3; ++k) {
            all.position[k] = row(k);
            all.normal[k] = row(3 + k);
        }
        all.count = count;
        return all;
    }

private:
    // Copies a packet; values beyond the last receiver are not read.
    GONIO_FORCE_INLINE static void copy(const float* from, float* to) {
        S packet;
        simd::load(from, packet);
        simd::store(packet, to);
    }
};

// One receiver in double.
template<class S, template<class> class Light>
[[gnu::noinline]] float illuminance_in_double(const Surfaces& surfaces, std::size_t i, const LightConstants& from) {
    Light<double> light;
    constants(from, light);
    SurfacePoint<double> point;
    point.position = {static_cast<double>(surfaces.position[0][i]), static_cast<double>(surfaces.position[1][i]),
                      static_cast<double>(surfaces.position[2][i])};
    point.normal = {static_cast<double>(surfaces.normal[0][i]), static_cast<double>(surfaces.normal[1][i]),
                    static_cast<double>(surfaces.normal[2][i])};
    return static_cast<float>(illuminance(point, light));
}

// The kinds that a block is sorted into; the remaining receivers are dark. `plain`: everything that does not belong to
// another kind; for disks and rectangles, receivers with a horizon that cuts the light. Only for a tube: split between
// its ends by the horizon, cut though well apart, or seen from beyond an end.
enum class Kind : std::uint8_t { above, plain, split, cut, end };

template<class Light>
inline constexpr std::size_t kind_count = is_tube<Light> ? 5 : 2;

constexpr std::size_t index_of(Kind kind) {
    return static_cast<std::size_t>(kind);
}

// The position from which a tube is seen. The few receivers that rounding leaves undecided are in neither mask.
template<class S>
struct TubeSight {
    simd::mask_of<S> end; // beyond an end and within the prolongation
    TubeApart<S> apart;
};

template<class S>
GONIO_FORCE_INLINE TubeSight<S> sight(const TubeLight<S>& light, vec3<S> c) {
    // In units of the light, so that squares are normal numbers; receivers too far away for that are plain.
    const S size = simd::max(simd::abs(light.radius), simd::abs(light.length));
    const S scale = simd::reciprocal_power_of_two(size);
    const S r = simd::abs(light.radius) * scale;
    const S half = S(0.5) * (simd::abs(light.length) * scale);
    const vec3<S> scaled = c * scale;
    const S along = dot(light.axis, scaled);
    const vec3<S> across = mul_add(light.axis, -along, scaled);
    const S d2 = dot(across, across);
    const S slack = S(2e-6) * (simd::abs(along) + r);
    const S within2 = r * (r - slack);
    const S beyond = simd::abs(along) - half;
    const auto within = d2 < within2;
    return {simd::both(within, beyond > slack), tube_apart(d2, along * along, r, half)};
}

template<Kind kind, class Light, class S>
GONIO_FORCE_INLINE Survey<S> survey_kind(const Light& light, vec3<S> to_center, vec3<S> normal) {
    if constexpr (kind == Kind::end) {
        return survey_end(light, to_center, normal);
    } else if constexpr (kind == Kind::above) {
        return survey_above(light, to_center, normal);
    } else if constexpr (kind == Kind::split) {
        return survey_split(light, to_center, normal);
    } else if constexpr (kind == Kind::cut) {
        return survey_cut(light, to_center, normal);
    } else {
        return survey(light, to_center, normal);
    }
}

template<class S, template<class> class Light>
struct SortedBatch {
    static constexpr std::size_t lanes = simd::Traits<S>::lanes;
    static constexpr std::size_t packets = receivers_per_block / lanes;

    using Queue = ReceiverQueue<S>;
    using Half = simd::half<S>;
    static constexpr std::size_t half_lanes = simd::Traits<Half>::lanes;

    const LightConstants& light;
    Queue queues[kind_count<Light<S>>];

    explicit SortedBatch(const LightConstants& of) : light(of) {}

    template<Kind kind>
    Queue& queue() {
        return queues[index_of(kind)];
    }

    // A block of whole packets. The first `count` receivers are real; the first of them has the index `first` overall.
    // Each one gets its illuminance [lx] for 1 nt, or 0 and is queued.
    void take(const Surfaces& block, std::size_t count, std::size_t first, float* lx) {
        if constexpr (is_cheap_above<Light<S>>) {
            take_computed(block, count, first, lx);
        } else {
            take_told_apart(block, count, first, lx);
        }
    }

    [[gnu::noinline]] void take_computed(const Surfaces& block, std::size_t count, std::size_t first, float* lx) {
        Light<S> spread;
        constants(light, spread);
        std::uint32_t cut_bits[packets];
        std::uint32_t count_cut = 0;
        for (std::size_t at = 0; at < block.count; at += lanes) {
            const SurfacePoint<S> point = receiver<S>(block, at);
            const vec3<S> c = spread.center - point.position;
            const Survey<S> seen = survey_above(spread, c, point.normal);
            simd::store(seen.irradiance * window(c, spread.inverse_range), lx + at);
            cut_bits[at / lanes] = simd::lane_bits(seen.hard) & lanes_below(count - at);
            count_cut += simd::bit_count(cut_bits[at / lanes]);
        }
        if (count_cut == 0) return;
        if (count == block.count && count_cut > nearly_all(count))
            return in_order<Kind::plain>(block, count, nullptr, first, lx);
        for (std::size_t at = 0; at < block.count; at += lanes)
            if (cut_bits[at / lanes] != 0)
                queue<Kind::plain>().add(cut_bits[at / lanes], receiver<S>(block, at), places<S>(first + at));
    }

    [[gnu::noinline]] void take_told_apart(const Surfaces& block, std::size_t count, std::size_t first, float* lx) {
        constexpr std::size_t kinds = kind_count<Light<S>>;
        Light<S> spread;
        constants(light, spread);
        const S size = largest_size(spread);
        std::uint32_t bits[packets][kinds];
        std::size_t counts[kinds] = {};
        for (std::size_t at = 0; at < block.count; at += lanes) {
            const SurfacePoint<S> point = receiver<S>(block, at);
            const vec3<S> c = spread.center - point.position;
            const Kinds of_packet = tell_apart(spread, c, point.normal, size, lanes_below(count - at));
            for (std::size_t kind = 0; kind < kinds; ++kind) {
                bits[at / lanes][kind] = of_packet.bits[kind];
                counts[kind] += simd::bit_count(of_packet.bits[kind]);
            }
        }
        if (count == block.count && take_in_order<Kind::above>(block, counts, first, lx)) return;
        for (std::size_t at = 0; at < block.count; at += lanes) {
            const SurfacePoint<S> point = receiver<S>(block, at);
            const S place = places<S>(first + at);
            simd::store(S(0), lx + at);
            for (std::size_t kind = 0; kind < kinds; ++kind)
                if (bits[at / lanes][kind] != 0) queues[kind].add(bits[at / lanes][kind], point, place);
        }
    }

    // For each kind, a mask of its lanes.
    struct Kinds {
        std::uint32_t bits[kind_count<Light<S>>];
    };

    GONIO_FORCE_INLINE static Kinds tell_apart(const Light<S>& spread, vec3<S> c, vec3<S> normal, S size,
                                               std::uint32_t real) {
        const S height = dot(normal, c);
        const S most = reach(spread, normal);
        // More than rounding leaves undecided: a receiver on the light, facing it, sees all of the light in its own
        // plane.
        const S least = -(most + S(3e-6) * ((simd::abs(c.x) + simd::abs(c.y)) + (simd::abs(c.z) + size)));
        // A NaN from a product that overflows does not count as dark.
        const std::uint32_t lit = ~simd::lane_bits(height < least) & real;
        const std::uint32_t is_above = simd::lane_bits(height > most) & lit;
        if constexpr (is_tube<Light<S>>) {
            const TubeSight<S> seen = sight(spread, c);
            const std::uint32_t is_end = simd::lane_bits(seen.end) & lit;
            const std::uint32_t is_apart = simd::lane_bits(seen.apart.whole) & lit;
            // The height from the middle to an end's sphere.
            const std::uint32_t is_split =
                simd::lane_bits(simd::abs(height) < most - S(2) * simd::abs(spread.radius)) & is_apart;
            const std::uint32_t is_whole = is_above & is_apart;
            const std::uint32_t is_cut = simd::lane_bits(seen.apart.cut) & lit & ~(is_above | is_split);
            return {{is_whole, lit & ~(is_whole | is_split | is_cut | is_end), is_split, is_cut, is_end}};
        } else {
            return {{is_above, lit & ~is_above}};
        }
    }

    // If a block is nearly all of one kind, and the rest is dark or marked hard by the form for that kind, computes it
    // in place.
    template<Kind kind>
    bool take_in_order(const Surfaces& block, const std::size_t* counts, std::size_t first, float* lx) {
        if constexpr (index_of(kind) == kind_count<Light<S>>) {
            return false;
        } else {
            constexpr Kind next{index_of(kind) + 1};
            constexpr bool knows_others = kind == Kind::plain || (is_tube<Light<S>> && kind != Kind::end);
            std::size_t others = 0;
            for (std::size_t k = 0; k < kind_count<Light<S>>; ++k)
                if (k != index_of(kind)) others += counts[k];
            if (counts[index_of(kind)] <= nearly_all(block.count) || (!knows_others && others != 0))
                return take_in_order<next>(block, counts, first, lx);
            in_order<kind>(block, block.count, nullptr, first, lx);
            return true;
        }
    }

    // Copying takes a tenth of the time of a packet.
    static std::size_t nearly_all(std::size_t count) { return count - count / 8; }

    // One bit for each of `count` lanes, at most all lanes.
    GONIO_FORCE_INLINE static std::uint32_t lanes_below(std::size_t count) {
        return ~std::uint32_t{0} >> (32 - (count < lanes ? count : lanes));
    }

    // Returns the lanes of a packet that are not of the kind after all; the others get their illuminance [lx] for 1 nt.
    template<Kind kind, class Lanes>
    GONIO_FORCE_INLINE static std::uint32_t step(const Light<Lanes>& spread, const Surfaces& surfaces, std::size_t at,
                                                 float* lx) {
        const SurfacePoint<Lanes> point = receiver<Lanes>(surfaces, at);
        const vec3<Lanes> c = spread.center - point.position;
        const Survey<Lanes> seen = survey_kind<kind>(spread, c, point.normal);
        simd::store(seen.irradiance * window(c, spread.inverse_range), lx + at);
        return simd::lane_bits(seen.hard);
    }

    // The same for one packet of half the lanes.
    template<Kind kind>
    [[gnu::noinline]] std::uint32_t step_of_half(const Surfaces& surfaces, std::size_t at, float* lx) {
        Light<Half> spread;
        constants(light, spread);
        return step<kind>(spread, surfaces, at, lx);
    }

    // The illuminance [lx] for 1 nt of `surfaces`, packet by packet: a whole number of packets and half packets, no
    // more than a queue. The few receivers that are not of their kind after all are queued as plain; their indices are
    // in `place`, or count from `first` on. Receivers after the first `count` only fill their packet.
    template<Kind kind>
    [[gnu::noinline]] void in_order(const Surfaces& surfaces, std::size_t count, const float* place, std::size_t first,
                                    float* lx) {
        Light<S> spread;
        constants(light, spread);
        std::uint32_t hard[queue_length / lanes];
        std::uint32_t any_hard = 0;
        const std::size_t whole = surfaces.count - surfaces.count % lanes;
        for (std::size_t at = 0; at < whole; at += lanes) {
            hard[at / lanes] = step<kind>(spread, surfaces, at, lx) & lanes_below(count - at);
            any_hard |= hard[at / lanes];
        }
        if constexpr (half_lanes < lanes)
            if (whole < surfaces.count) {
                hard[whole / lanes] = step_of_half<kind>(surfaces, whole, lx) & lanes_below(count - whole);
                any_hard |= hard[whole / lanes];
            }
        if (any_hard == 0) return;
        if constexpr (kind != Kind::plain && kind != Kind::end) {
            for (std::size_t at = 0; at < surfaces.count; at += lanes) {
                if (hard[at / lanes] == 0) continue;
                S where = places<S>(first + at);
                if (place != nullptr) simd::load(place + at, where);
                queue<Kind::plain>().add(hard[at / lanes], receiver<S>(surfaces, at), where);
            }
        } else {
            for (std::size_t at = 0; at < surfaces.count; at += lanes)
                for (std::uint32_t left = hard[at / lanes]; left != 0; left &= left - 1) {
                    const std::size_t i = at + static_cast<std::size_t>(__builtin_ctz(left));
                    lx[i] = illuminance_in_double<S, Light>(surfaces, i, light);
                }
        }
    }

    // Computes the full packets of a queue, or all of it.
    template<Kind kind>
    void compute(bool all, float* lx) {
        Queue& of_kind = queue<kind>();
        const std::size_t some = all ? of_kind.count : of_kind.count - of_kind.count % lanes;
        if (some == 0) return;
        if (all) of_kind.pad();
        Surfaces surfaces = of_kind.surfaces();
        surfaces.count = (some + half_lanes - 1) / half_lanes * half_lanes;
        float results[queue_length];
        const float* const place = of_kind.row(6);
        in_order<kind>(surfaces, some, place, 0, &results[0]);
        std::size_t i = 0;
        for (; i + half_lanes <= some; i += half_lanes)
            for (std::size_t lane = 0; lane < half_lanes; ++lane)
                lx[place_of(place[i + lane])] = results[i + lane];
        for (; i < some; ++i)
            lx[place_of(place[i])] = results[i];
        of_kind.drop(some);
    }

    // Receivers that do not fill a packet of their kind join another kind that can compute them and has room.
    template<Kind kind, Kind other>
    void join() {
        Queue& few = queue<kind>();
        const std::size_t rest = queue<other>().count % half_lanes;
        if (rest == 0 || rest + few.count > half_lanes) return;
        queue<other>().append(few);
        few.count = 0;
    }

    void compute(bool all, float* lx) {
        compute<Kind::above>(false, lx);
        if constexpr (is_tube<Light<S>>) {
            compute<Kind::split>(false, lx);
            if (all) join<Kind::split, Kind::cut>();
            compute<Kind::split>(all, lx);
            compute<Kind::cut>(false, lx);
            if (all) join<Kind::cut, Kind::plain>();
            compute<Kind::cut>(all, lx);
        }
        if (all) join<Kind::above, Kind::plain>();
        compute<Kind::above>(all, lx);
        compute<Kind::plain>(all, lx);
        if constexpr (is_tube<Light<S>>) compute<Kind::end>(all, lx);
    }
};

// For fewer than 2³¹ receivers.
template<class S, template<class> class Light>
void irradiance_of_part(const Surfaces& surfaces, const LightConstants& light, float* lx) {
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    SortedBatch<S, Light> batch(light);
    const std::size_t whole = surfaces.count - surfaces.count % lanes;
    for (std::size_t first = 0; first < whole; first += receivers_per_block) {
        const std::size_t count = whole - first < receivers_per_block ? whole - first : receivers_per_block;
        batch.take(part_of<S>(surfaces, first, count), count, first, lx + first);
        if (first + count < whole) batch.compute(false, lx);
    }
    if (whole < surfaces.count) {
        const PaddedPacket<S> last(surfaces, whole);
        const std::size_t count = surfaces.count - whole;
        float results[lanes];
        batch.take(last.surfaces(), count, whole, &results[0]);
        for (std::size_t i = 0; i < count; ++i)
            lx[whole + i] = results[i];
    }
    batch.compute(true, lx);
}

// Illuminance [lx] for 1 nt of an area light.
template<class S, template<class> class Light>
void irradiance_sorted(const Surfaces& surfaces, const LightConstants& light, float* lx) {
    constexpr std::size_t part = std::size_t{1} << 16;
    for (std::size_t first = 0; first < surfaces.count; first += part) {
        const std::size_t rest = surfaces.count - first;
        irradiance_of_part<S, Light>(part_of<S>(surfaces, first, rest < part ? rest : part), light, lx + first);
    }
}

} // namespace gonio::shading::detail
