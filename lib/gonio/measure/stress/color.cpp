// Colours of temperatures and temperatures of colours: within the errors that the headers state, and NaN outside their
// ranges.
#include <gonio/base/exposure_value.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/kernels.hpp>
#include <gonio/color/named_methods.hpp>
#include <gonio/color/planckian.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/simd/dispatch.hpp>

#include <fmt/format.h>

#include <array>
#include <limits>
#include <vector>

namespace gonio::measure::detail {

namespace {

double temperature(Random& random, double coolest, double hottest) {
    return 1e6 / random.uniform(1e6 / hottest, 1e6 / coolest); // uniform in mired
}

// u'v' of black bodies by the kernels of every set, within 4e-7 of the fit in double, which is within 1.2e-12 of the
// sum.
void kernels_of_temperature(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t count = 251;
    std::vector<float> kelvin(count);
    std::array<std::vector<float>, 2> uv;
    for (std::vector<float>& each : uv)
        each.resize(count);
    float* const out[2] = {uv[0].data(), uv[1].data()};
    for (std::uint64_t done = 0; done < evaluations; done += count * simd::available_sets().size()) {
        for (float& T : kelvin)
            T = random.bits() % 8 == 0 ? __builtin_bit_cast(float, static_cast<std::uint32_t>(random.bits() >> 32U))
                                       : static_cast<float>(temperature(random, 800.0, 1e6));
        for (const simd::InstructionSet set : simd::available_sets()) {
            const color::Kernels& kernels = color::kernels(set);
            kernels.planckian_uv_prime(kelvin.data(), count, out);
            for (std::size_t i = 0; i < count; ++i) {
                const auto T = static_cast<double>(kelvin[i]);
                const auto input = [&] {
                    return fmt::format("{}: {} {} at {:a} K", kernels.name, uv[0][i], uv[1][i], T);
                };
                if (!(T >= 800.0 && T <= 1e6)) {
                    tally.looked_at(1);
                    tally.require(std::isnan(uv[0][i]) && std::isnan(uv[1][i]), input);
                    continue;
                }
                const Uv truth = fast_uv({Kelvin(T), 0.0});
                const Uv found{static_cast<double>(uv[0][i]), static_cast<double>(uv[1][i]) / 1.5};
                tally.hold(delta_uv_prime(found, truth) / 4e-7, input);
            }
        }
    }
}

// Round trip: a temperature and its Duv, their chromaticity, and its nearest black body.
void round_trip(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; ++done) {
        const Cct cct{Kelvin(temperature(random, 1500.0, 40000.0)), random.uniform(-0.05, 0.05)};
        const Cct back = fast_cct(fast_uv(cct));
        // 1e-5 K is stated up to 40000 K, where a step of 1e-16 in u moves the temperature by 1e-8 K.
        const double off = std::max(std::fabs(back.temperature.value - cct.temperature.value) / 1e-5,
                                    std::fabs(back.duv - cct.duv) / 1e-10);
        tally.hold(off, [&] {
            return fmt::format("{:a} K {:a}: back {:a} K {:a}", cct.temperature.value, cct.duv, back.temperature.value,
                               back.duv);
        });
    }
}

// The fit against the sum that it was made from: 1.2e-12 in u'v' on the locus, 6e-11 off it.
void fit_to_sum(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; ++done) {
        const double duv = random.bits() % 2 == 0 ? 0.0 : random.uniform(-0.05, 0.05);
        const Cct cct{Kelvin(temperature(random, 800.0, 1e6)), duv};
        const auto input = [&] { return fmt::format("{:a} K {:a}", cct.temperature.value, duv); };
        const Result<Uv> sum = exact_uv(cct);
        if (!sum) { // not a real colour
            tally.looked_at(1);
            tally.require(duv != 0.0, input);
            continue;
        }
        tally.hold(delta_uv_prime(fast_uv(cct), *sum) / (duv == 0.0 ? 1.2e-12 : 6e-11), input);
    }
}

// Chromaticity to coordinates and to every space, and back; photometric quantities of black bodies.
void spaces(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; ++done) {
        const Uv at{random.uniform(0.05, 0.6), random.uniform(0.1, 0.39)};
        const auto input = [&] { return fmt::format("u {:a} v {:a}", at.u, at.v); };
        double off = 0.0;
        const auto look = [&](Uv back) { off = std::fmax(off, delta_uv_prime(at, back)); };
        look(to_uv(to_xy(at)));
        look(to_uv(to_xyz(at)));
        look(to_uv(to_xyz(to_xy(at))));
        look(to_uv(to_uv_prime(at)));
        for (const RgbSpaceName& space : rgb_spaces()) {
            const RgbSpace* const found = find_rgb_space(space.name);
            const SpaceColor kept = to_space(at, *found);
            const Result<Uv> back = uv_of_rgb(kept.rgb, *found);
            tally.require(back.has_value(), input);
            if (back) look(*back);
            const SpaceColor clipped = to_space(at, *found, Gamut::clip, Normalize::max);
            for (const double c : {clipped.rgb.x, clipped.rgb.y, clipped.rgb.z})
                tally.require(c >= 0.0 && c <= 1.0 + 1e-12, input);
        }
        // 1e-15 each of X, Y and Z, relative to the greatest, by which v divides.
        tally.hold(off / 1e-13, input);
        const Kelvin T(std::exp(random.uniform(std::log(coolest.value), std::log(hottest.value))));
        const BlackbodyEfficacy efficacy = blackbody_efficacy(T);
        tally.require(is_amount(efficacy.total_lm_per_w) && efficacy.band_lm_per_w >= efficacy.total_lm_per_w &&
                          efficacy.band_lm_per_w <= 683.0 && is_amount(blackbody_luminance(T).value),
                      [&] { return fmt::format("black body of {:a} K", T.value); });
    }
}

// The sRGB curve (its two pieces meet within 2e-8) and exposure values, each with its inverse.
void curves(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; done += 3) {
        const double linear = random.bits() % 2 == 0 ? random.uniform() : std::exp(random.uniform(-30.0, 5.0));
        tally.hold(std::fabs(decode_srgb(encode_srgb(linear)) - linear) / (1e-14 * linear + 3e-8 * (linear < 0.0032)),
                   [&] { return fmt::format("sRGB of {:a}", linear); });
        const double amount = std::exp(random.uniform(-600.0, 600.0));
        // The relative rounding error of the amount grows with the exponent.
        const double bar = (4.0 + std::fabs(std::log2(amount))) * 4e-16 * amount;
        tally.hold(std::fabs(luminance_of_ev(ev_of_luminance(amount)) - amount) / bar,
                   [&] { return fmt::format("EV of {:a} nt", amount); });
        tally.hold(std::fabs(illuminance_of_ev(ev_of_illuminance(amount)) - amount) / bar,
                   [&] { return fmt::format("EV of {:a} lx", amount); });
    }
}

// Any numbers: a result within its range or none, and every named method gives a number within its stated range.
void any_numbers(Random& random, std::uint64_t evaluations, StressTally& tally) {
    const auto coordinate = [&] {
        return random.bits() % 4 == 0 ? hostile::number(random) : random.uniform(-0.1, 0.8);
    };
    for (std::uint64_t done = 0; done < evaluations; done += 2) {
        const Uv at{random.bits() % 32 == 0 ? std::numeric_limits<double>::quiet_NaN() : coordinate(), coordinate()};
        const Cct found = fast_cct(at);
        const bool none = std::isnan(found.temperature.value) && std::isnan(found.duv);
        const bool some = found.temperature.value >= 799.0 && found.temperature.value <= 1.001e6 &&
                          std::fabs(found.duv) <= greatest_duv * 1.0001;
        tally.looked_at(2);
        tally.require(none || some, [&] {
            return fmt::format("fast_cct of u {:a} v {:a}: {} K {}", at.u, at.v, found.temperature.value, found.duv);
        });
        const ColorMethod& method = color_methods()[random.bits() % color_methods().size()];
        const double T = temperature(random, method.coolest.value, std::min(method.hottest.value, 1e6));
        const glm::dvec3 xyz = method.xyz(Kelvin(T));
        tally.require(is_amount(xyz.x) && is_amount(xyz.y) && is_amount(xyz.z),
                      [&] { return fmt::format("{} at {:a} K: {} {} {}", method.name, T, xyz.x, xyz.y, xyz.z); });
    }
}

} // namespace

std::span<const StressSubject> color_stress() {
    static constexpr std::array subjects{
        StressSubject{"colours of temperatures", "4e-7 in u'v' from 800 K to 1e6 K, NaN outside", 0.5,
                      kernels_of_temperature},
        StressSubject{"temperature to colour and back", "1e-5 K and 1e-10 in Duv, 1500-40000 K", 0.05, round_trip},
        StressSubject{"the fit to the sum", "1.2e-12 in u'v' on the locus, 6e-11 off it", 0.003, fit_to_sum},
        StressSubject{"colour spaces and back", "1e-13 in u'v'; clipped in [0, 1]", 0.01, spaces},
        StressSubject{"sRGB and exposure values and back", "1e-14, and 4e-16 of the exponent", 0.2, curves},
        StressSubject{"temperatures of any numbers", "an answer in its range or none; named methods finite", 0.02,
                      any_numbers},
    };
    return subjects;
}

} // namespace gonio::measure::detail
