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

// So cheap above the horizon that receivers are not worth the copying.
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
    float values[6][queue_length]; // position, normal
    float place[queue_length];     // in the arrays; below 2²⁴

    // What lies beyond `count` is not read, and filling it would take as long as a packet.
    ReceiverQueue() {} // NOLINT(*-member-init, *-use-equals-default)

    GONIO_FORCE_INLINE void add(std::uint32_t lanes_chosen, const SurfacePoint<S>& point, S places) {
        const simd::Choice<S> which(lanes_chosen);
        simd::store_chosen(which, point.position.x, &values[0][count]);
        simd::store_chosen(which, point.position.y, &values[1][count]);
        simd::store_chosen(which, point.position.z, &values[2][count]);
        simd::store_chosen(which, point.normal.x, &values[3][count]);
        simd::store_chosen(which, point.normal.y, &values[4][count]);
        simd::store_chosen(which, point.normal.z, &values[5][count]);
        simd::store_chosen(which, places, &place[count]);
        count += simd::bit_count(lanes_chosen);
    }

    // The last receiver repeated until a packet is full.
    void pad() {
        for (std::size_t i = count; i % lanes != 0; ++i)
            for (auto& value : values)
                value[i] = value[count - 1];
    }

    void drop(std::size_t first_ones) {
        for (std::size_t i = first_ones; i < count; ++i) {
            for (auto& value : values)
                value[i - first_ones] = value[i];
            place[i - first_ones] = place[i];
        }
        count -= first_ones;
    }

    void append(const ReceiverQueue& other) {
        for (std::size_t i = 0; i < other.count; ++i) {
            for (std::size_t k = 0; k < 6; ++k)
                values[k][count + i] = other.values[k][i];
            place[count + i] = other.place[i];
        }
        count += other.count;
    }

    [[nodiscard]] Surfaces surfaces() const {
        Surfaces all;
        for (std::size_t k = 0; k < 3; ++k) {
            all.position[k] = &values[k][0];
            all.normal[k] = &values[3 + k][0];
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
    [[gnu::noinline]] void take(const Surfaces& block, std::size_t count, std::size_t first, float* lx) {
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
        // Copying takes the time of a tenth of a packet.
        const std::size_t nearly_all = block.count - block.count / 8;
        if (count == block.count && count_end == 0) {
            if (count_cut > nearly_all) return in_order<Kind::cut>(block, nullptr, first, lx);
            if (count_cut == 0 && count_above > nearly_all) return in_order<Kind::above>(block, nullptr, first, lx);
        }
        for (std::size_t at = 0; at < block.count; at += lanes) {
            const SurfacePoint<S> point = receiver<S>(block, at);
            const S place = places<S>(first + at);
            S easy = S(0);
            if (above_bits[at / lanes] != 0) {
                if constexpr (is_cheap_above<Light<S>>) {
                    const vec3<S> c = spread.center - point.position;
                    easy = survey_above(spread, c, point.normal).irradiance * window(c, spread.inverse_range);
                } else {
                    above.add(above_bits[at / lanes], point, place);
                }
            }
            simd::store(easy, lx + at);
            if (cut_bits[at / lanes] != 0) cut.add(cut_bits[at / lanes], point, place);
            if constexpr (has_ends<Light<S>>)
                if (end_bits[at / lanes] != 0) end.add(end_bits[at / lanes], point, place);
        }
    }

    // A bit for each of `count` lanes, at most all.
    GONIO_FORCE_INLINE static std::uint32_t lanes_below(std::size_t count) {
        return ~std::uint32_t{0} >> (32 - (count < lanes ? count : lanes));
    }

    // The illuminance [lx] for 1 nt of `surfaces`, packet after packet: a whole number of packets, no more than a
    // queue. The few that are not of their kind after all are queued as cut; their places are `place` or count from
    // `first` on.
    template<Kind kind>
    [[gnu::noinline]] void in_order(const Surfaces& surfaces, const float* place, std::size_t first, float* lx) {
        Light<S> spread;
        constants(light, spread);
        std::uint32_t hard[queue_length / lanes];
        std::uint32_t any_hard = 0;
        for (std::size_t at = 0; at < surfaces.count; at += lanes) {
            const SurfacePoint<S> point = receiver<S>(surfaces, at);
            const vec3<S> c = spread.center - point.position;
            const Survey<S> seen = survey_kind<kind>(spread, c, point.normal);
            hard[at / lanes] = simd::lane_bits(seen.hard);
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
        in_order<kind>(surfaces, &queue.place[0], 0, &results[0]);
        for (std::size_t i = 0; i < some; ++i)
            lx[static_cast<std::int32_t>(queue.place[i])] = results[i];
        queue.drop(some);
    }

    void compute(bool all, float* lx) {
        compute<Kind::above>(above, false, lx);
        if (all) cut.append(above); // what fills no packet shares one
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
