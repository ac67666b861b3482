// The exact irradiance of many receivers, those that share a packet sorted by what their horizon does to the light.
//
// A packet takes the time of the dearest of its lanes, so lanes that the horizon cuts, lanes that see all of the light
// and lanes that see nothing should not share one. Receivers are taken by blocks and told apart by height and reach. A
// block of one kind is computed where it lies; of others the receivers are copied into a queue for each kind and packed
// full. Which packet a receiver gets into depends on the arrays alone.
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
inline constexpr bool has_ends = false;
template<class S>
inline constexpr bool has_ends<TubeLight<S>> = true;

// first, first + 1, …: exact below 2²⁴.
template<class S>
GONIO_FORCE_INLINE S places(std::size_t first) {
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    float numbers[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane)
        numbers[lane] = static_cast<float>(lane);
    S step;
    simd::load(&numbers[0], step);
    return step + S(static_cast<float>(first));
}

// So cheap above the horizon that telling the kinds apart would take as long: all are computed so, and only the cut
// ones are copied.
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

// Receivers of one kind from here and there. S: what they will be computed with.
template<class S>
struct ReceiverQueue {
    static constexpr std::size_t lanes = simd::Traits<S>::lanes;

    std::size_t count = 0;
    // Rows of queue_length: position, normal, and the place in the arrays, which is below 2²⁴.
    static constexpr std::size_t rows = 7;
    float values[rows * queue_length];

    // What lies beyond `count` is not read, and filling it would take as long as a packet.
    ReceiverQueue() {} // NOLINT(*-member-init, *-use-equals-default)

    GONIO_FORCE_INLINE void add(std::uint32_t lanes_chosen, const SurfacePoint<S>& point, S places) {
        const simd::Choice<S> which(lanes_chosen);
        // Packets may be stored over anything, `count` too for all that the compiler knows.
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

    // The last receiver repeated until a packet is full.
    void pad() {
        for (std::size_t i = count; i % lanes != 0; ++i)
            for (std::size_t k = 0; k < rows; ++k)
                row(k)[i] = row(k)[count - 1];
    }

    void drop(std::size_t first_ones) {
        for (std::size_t i = first_ones; i < count; ++i)
            for (std::size_t k = 0; k < rows; ++k)
                row(k)[i - first_ones] = row(k)[i];
        count -= first_ones;
    }

    void append(const ReceiverQueue& other) {
        for (std::size_t i = 0; i < other.count; ++i)
            for (std::size_t k = 0; k < rows; ++k)
                row(k)[count + i] = other.row(k)[i];
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

// What a block is sorted into; what is left is dark.
enum class Kind : std::uint8_t { above, cut, end };

// Surely beyond an end of the tube and within its prolongation; the few that are as good as there are hard to the
// others.
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> sees_end_alone(const TubeLight<S>& light, vec3<S> c) {
    // In units of the light, so that squares are normal numbers; what is too far for that sees more than an end.
    const S size = simd::max(simd::abs(light.radius), simd::abs(light.length));
    const S scale = simd::reciprocal_power_of_two(size);
    const S r = simd::abs(light.radius) * scale;
    const S half = S(0.5) * (simd::abs(light.length) * scale);
    const vec3<S> scaled = c * scale;
    const S along = dot(light.axis, scaled);
    const vec3<S> across = scaled - light.axis * along;
    const S slack = S(2e-6) * (simd::abs(along) + r);
    return simd::both(dot(across, across) < r * (r - slack), simd::abs(along) - half > slack);
}

template<Kind kind, class Light, class S>
GONIO_FORCE_INLINE Survey<S> survey_kind(const Light& light, vec3<S> to_center, vec3<S> normal) {
    if constexpr (kind == Kind::end) {
        return survey_end(light, to_center, normal);
    } else if constexpr (kind == Kind::above) {
        return survey_above(light, to_center, normal);
    } else {
        return survey(light, to_center, normal);
    }
}

template<class S, template<class> class Light>
struct SortedBatch {
    static constexpr std::size_t lanes = simd::Traits<S>::lanes;
    static constexpr std::size_t packets = receivers_per_block / lanes;

    const LightConstants& light;
    ReceiverQueue<S> above, cut, end;

    explicit SortedBatch(const LightConstants& of) : light(of) {}

    // A block of whole packets, of which the first `count` receivers are real; the first of them is the `first` of all.
    // Each gets its illuminance [lx] for 1 nt, or 0 and is queued.
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
            return in_order<Kind::cut>(block, count, nullptr, first, lx);
        for (std::size_t at = 0; at < block.count; at += lanes)
            if (cut_bits[at / lanes] != 0) cut.add(cut_bits[at / lanes], receiver<S>(block, at), places<S>(first + at));
    }

    [[gnu::noinline]] void take_told_apart(const Surfaces& block, std::size_t count, std::size_t first, float* lx) {
        Light<S> spread;
        constants(light, spread);
        const S size = largest_size(spread);
        std::uint32_t above_bits[packets];
        std::uint32_t cut_bits[packets];
        std::uint32_t end_bits[packets];
        std::uint32_t count_above = 0;
        std::uint32_t count_cut = 0;
        std::uint32_t count_end = 0;
        for (std::size_t at = 0; at < block.count; at += lanes) {
            const SurfacePoint<S> point = receiver<S>(block, at);
            const vec3<S> c = spread.center - point.position;
            const S height = dot(point.normal, c);
            const S most = reach(spread, point.normal);
            // More than rounding leaves open: a receiver on the light, turned to it, sees all of it in its own plane.
            const S least = -(most + S(3e-6) * ((simd::abs(c.x) + simd::abs(c.y)) + (simd::abs(c.z) + size)));
            std::uint32_t real = lanes_below(count - at);
            if constexpr (has_ends<Light<S>>) {
                const std::uint32_t is_end =
                    simd::lane_bits(simd::both(sees_end_alone(spread, c), height >= least)) & real;
                end_bits[at / lanes] = is_end;
                count_end += simd::bit_count(is_end);
                real &= ~is_end;
            }
            const std::uint32_t is_above = simd::lane_bits(height > most) & real;
            // What is no number, of a product that overflows, counts as cut.
            const std::uint32_t is_cut = ~(simd::lane_bits(height < least) | is_above) & real;
            above_bits[at / lanes] = is_above;
            cut_bits[at / lanes] = is_cut;
            count_above += simd::bit_count(is_above);
            count_cut += simd::bit_count(is_cut);
        }
        if (count == block.count && count_end == 0) {
            if (count_cut > nearly_all(count)) return in_order<Kind::cut>(block, count, nullptr, first, lx);
            if (count_cut == 0 && count_above > nearly_all(count))
                return in_order<Kind::above>(block, count, nullptr, first, lx);
        }
        for (std::size_t at = 0; at < block.count; at += lanes) {
            const SurfacePoint<S> point = receiver<S>(block, at);
            const S place = places<S>(first + at);
            simd::store(S(0), lx + at);
            if (above_bits[at / lanes] != 0) above.add(above_bits[at / lanes], point, place);
            if (cut_bits[at / lanes] != 0) cut.add(cut_bits[at / lanes], point, place);
            if constexpr (has_ends<Light<S>>)
                if (end_bits[at / lanes] != 0) end.add(end_bits[at / lanes], point, place);
        }
    }

    // Copying takes the time of a tenth of a packet.
    static std::size_t nearly_all(std::size_t count) { return count - count / 8; }

    // A bit for each of `count` lanes, at most all.
    GONIO_FORCE_INLINE static std::uint32_t lanes_below(std::size_t count) {
        return ~std::uint32_t{0} >> (32 - (count < lanes ? count : lanes));
    }

    // The illuminance [lx] for 1 nt of `surfaces`, packet after packet: a whole number of packets, no more than a
    // queue. The few that are not of their kind after all are queued as cut; their places are `place` or count from
    // `first` on. Those beyond the first `count` only fill their packet.
    template<Kind kind>
    [[gnu::noinline]] void in_order(const Surfaces& surfaces, std::size_t count, const float* place, std::size_t first,
                                    float* lx) {
        Light<S> spread;
        constants(light, spread);
        std::uint32_t hard[queue_length / lanes];
        std::uint32_t any_hard = 0;
        for (std::size_t at = 0; at < surfaces.count; at += lanes) {
            const SurfacePoint<S> point = receiver<S>(surfaces, at);
            const vec3<S> c = spread.center - point.position;
            const Survey<S> seen = survey_kind<kind>(spread, c, point.normal);
            hard[at / lanes] = simd::lane_bits(seen.hard) & lanes_below(count - at);
            any_hard |= hard[at / lanes];
            simd::store(seen.irradiance * window(c, spread.inverse_range), lx + at);
        }
        if (any_hard == 0) return;
        if constexpr (kind == Kind::above) {
            for (std::size_t at = 0; at < surfaces.count; at += lanes) {
                if (hard[at / lanes] == 0) continue;
                S where = places<S>(first + at);
                if (place != nullptr) simd::load(place + at, where);
                cut.add(hard[at / lanes], receiver<S>(surfaces, at), where);
            }
        } else {
            for (std::size_t at = 0; at < surfaces.count; at += lanes)
                for (std::uint32_t left = hard[at / lanes]; left != 0; left &= left - 1) {
                    const std::size_t i = at + static_cast<std::size_t>(__builtin_ctz(left));
                    lx[i] = illuminance_in_double<S, Light>(surfaces, i, light);
                }
        }
    }

    // Computes what fills packets, or all, of a queue.
    template<Kind kind>
    void compute(ReceiverQueue<S>& queue, bool all, float* lx) {
        const std::size_t some = all ? queue.count : queue.count - queue.count % lanes;
        if (some == 0) return;
        if (all) queue.pad();
        Surfaces surfaces = queue.surfaces();
        surfaces.count = (some + lanes - 1) / lanes * lanes;
        float results[queue_length];
        const float* const place = queue.row(6);
        in_order<kind>(surfaces, some, place, 0, &results[0]);
        for (std::size_t i = 0; i < some; ++i)
            lx[static_cast<std::int32_t>(place[i])] = results[i];
        queue.drop(some);
    }

    void compute(bool all, float* lx) {
        compute<Kind::above>(above, false, lx);
        if (all && above.count != 0) {
            // What fills no packet joins a cut one that has room.
            const std::size_t cut_rest = cut.count % lanes;
            if (cut_rest != 0 && cut_rest + above.count <= lanes) {
                cut.append(above);
            } else {
                compute<Kind::above>(above, true, lx);
            }
        }
        compute<Kind::cut>(cut, all, lx);
        if constexpr (has_ends<Light<S>>) compute<Kind::end>(end, all, lx);
    }
};

// At most 2²⁴ receivers.
template<class S, template<class> class Light>
void irradiance_of_part(const Surfaces& surfaces, const LightConstants& light, float* lx) {
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    SortedBatch<S, Light> batch(light);
    const std::size_t whole = surfaces.count - surfaces.count % lanes;
    for (std::size_t first = 0; first < whole; first += receivers_per_block) {
        const std::size_t count = whole - first < receivers_per_block ? whole - first : receivers_per_block;
        batch.take(part_of<S>(surfaces, first, count), count, first, lx + first);
        batch.compute(false, lx);
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

// Illuminance [lx] for 1 nt of a disk, rectangle or tube.
template<class S, template<class> class Light>
void irradiance_sorted(const Surfaces& surfaces, const LightConstants& light, float* lx) {
    constexpr std::size_t part = std::size_t{1} << 16;
    for (std::size_t first = 0; first < surfaces.count; first += part) {
        const std::size_t rest = surfaces.count - first;
        irradiance_of_part<S, Light>(part_of<S>(surfaces, first, rest < part ? rest : part), light, lx + first);
    }
}

} // namespace gonio::shading::detail
