// Webs of random tables: their values in any direction, their flux, webs derived from them, their textures, and numbers
// as files write them.
#include <gonio/bake/bake.hpp>
#include <gonio/bake/kernels.hpp>
#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/profile/fast_number.hpp>
#include <gonio/profile/number_text.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/web/combine.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/transform.hpp>
#include <gonio/web/web.hpp>
#include <gonio/web/zones.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace gonio::measure::detail {

namespace {

// Strictly ascending, from `first` to at most `last`; with non-uniform steps and, if `finest`, sometimes with steps as
// small as doubles allow.
std::vector<double> angles(Random& random, double first, double last, std::size_t count, bool finest) {
    std::vector<double> at{first};
    for (std::size_t i = 1; i < count; ++i) {
        const double left = last - at.back();
        double step = left * random.uniform(0.05, 0.6);
        if (finest && random.bits() % 16 == 0) step = left * 1e-12;
        if (i + 1 == count && random.bits() % 2 == 0) step = left;
        if (at.back() + step > at.back() && at.back() + step <= last) at.push_back(at.back() + step);
    }
    return at;
}

struct RandomWeb {
    Web web;
    double greatest = 0.0; // of the web's table
};

Result<RandomWeb> random_web(Random& random, bool finest = true) {
    constexpr std::array symmetries{Symmetry::axial, Symmetry::quadrant, Symmetry::bilateral_0_180, Symmetry::none};
    const Symmetry symmetry = symmetries[random.bits() % symmetries.size()];
    const double last = symmetry == Symmetry::quadrant ? 90.0 : symmetry == Symmetry::none ? 360.0 : 180.0;
    std::vector<double> planes = symmetry == Symmetry::axial ? std::vector<double>{0.0}
                                                             : angles(random, 0.0, last, 1 + random.bits() % 6, finest);
    std::vector<double> gammas = angles(random, 0.0, 180.0, 1 + random.bits() % 9, finest);
    std::vector<double> candela(planes.size() * gammas.size());
    const double scale = std::exp(random.uniform(std::log(1e-30), std::log(1e30)));
    double greatest = 0.0;
    for (double& cd : candela) {
        cd = random.bits() % 4 == 0 ? 0.0 : scale * random.uniform();
        greatest = std::max(greatest, cd);
    }
    // For a full turn the last plane equals the first.
    if (symmetry == Symmetry::none && planes.back() == 360.0)
        std::copy_n(candela.begin(), gammas.size(), candela.end() - static_cast<std::ptrdiff_t>(gammas.size()));
    Result<Web> web = Web::create(symmetry, std::move(planes), std::move(gammas), std::move(candela));
    if (!web) return pass_on(web);
    return RandomWeb{std::move(*web), greatest};
}

// Between 0 and the table's greatest value, for any direction, including invalid ones.
void lookups(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::uint64_t of_one_web = 500;
    const auto odd = [&] {
        const std::uint64_t choice = random.bits() % 8;
        if (choice == 0) return std::numeric_limits<double>::quiet_NaN();
        if (choice == 1) return std::numeric_limits<double>::infinity();
        return hostile::number(random);
    };
    for (std::uint64_t done = 0; done < evaluations; done += of_one_web) {
        const Result<RandomWeb> made = random_web(random);
        tally.require(made.has_value(), [] { return std::string("a web of ascending angles was refused"); });
        if (!made) continue;
        // Interpolation takes three products and their sum: 4 roundings.
        const double most = made->greatest * (1.0 + 4.0 * std::numeric_limits<double>::epsilon());
        for (std::uint64_t i = 0; i < of_one_web; ++i) {
            const bool by_angles = random.bits() % 2 == 0;
            const bool ordinary = random.bits() % 4 != 0;
            double a = odd();
            double b = odd();
            double c = odd();
            if (ordinary) {
                const hostile::Vec d = hostile::random_direction(random);
                a = by_angles ? random.uniform(-720.0, 720.0) : d.x;
                b = by_angles ? random.uniform(0.0, 180.0) : d.y;
                c = d.z;
            }
            if (!by_angles &&
                !(std::isfinite(a) && std::isfinite(b) && std::isfinite(c) && (a != 0.0 || b != 0.0 || c != 0.0)))
                continue; // not a direction
            if (by_angles && !std::isfinite(a)) continue;
            const double cd = by_angles ? made->web.candela(a, b) : made->web.candela(glm::dvec3(a, b, c));
            tally.looked_at(1);
            tally.require(cd >= 0.0 && cd <= most, [&] {
                return fmt::format("{:a} cd of at most {:a} at {:a} {:a} {:a} ({})", cd, made->greatest, a, b, c,
                                   by_angles ? "C, gamma" : "direction");
            });
        }
    }
}

// The exact flux and the zonal flux lie between 0 and the peak intensity times 4π.
void fluxes(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; done += 2) {
        const Result<RandomWeb> made = random_web(random);
        if (!made) continue;
        const double most = made->greatest * 4.0 * std::numbers::pi * (1.0 + 1e-12);
        tally.looked_at(2);
        for (const double lm : {flux(made->web).value, zonal_flux(made->web).value})
            tally.require(lm >= 0.0 && lm <= most,
                          [&] { return fmt::format("{:a} lm of a web of at most {:a} cd", lm, made->greatest); });
    }
}

// Webs that are rotated, mirrored, made symmetric, rewritten, cut, scaled or added: each must have the expected flux.
// The zones of a web must add up to its flux.
void transformed(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; done += 10) {
        // The finer a step, the larger the rounding of a rotated angle is relative to it.
        const Result<RandomWeb> made = random_web(random, false);
        if (!made || !(peak(made->web).intensity.value > 0.0)) {
            tally.looked_at(10);
            continue;
        }
        const Web web = made->web.scaled(1000.0 / made->greatest);
        const double whole = flux(web).value;
        // The flux of a web with its peak intensity in all directions.
        const double size = 4.0 * std::numbers::pi * peak(web).intensity.value;
        const auto hold = [&](const char* what, double lm, double expected, double bar) {
            tally.hold(std::fabs(lm - expected) / (bar * size), [&] {
                std::string text = fmt::format("{}: {:a} lm for {:a} of planes", what, lm, expected);
                for (const double angle : web.horizontal_deg())
                    text += fmt::format(" {:a}", angle);
                text += " gammas";
                for (const double angle : web.vertical_deg())
                    text += fmt::format(" {:a}", angle);
                return text;
            });
        };
        const double angle = random.uniform(-720.0, 720.0);
        hold("rotated", flux(rotated(web, angle).web).value, whole, 1e-10);
        hold("mirrored", flux(mirrored(web, MirrorPlane::c90_270)).value, whole, 1e-10);
        hold("expanded", flux(expanded(web)).value, whole, 1e-10);
        hold("compacted", flux(compacted(web)).value, whole, 1e-8); // 1e-9 of the peak over all directions
        if (const Result<Web> even = symmetrized(web, Symmetry::quadrant))
            hold("even", flux(*even).value, whole, 1e-10);
        const double low = random.uniform(0.0, 170.0);
        const double high = random.uniform(low + 1e-3, 180.0);
        const double zone = zone_flux(web, low, high).value;
        if (const Result<Web> cut = cropped(web, low, high)) hold("cropped", flux(*cut).value, zone, 1e-10);
        hold("zones", zone_flux(web, 0.0, low).value + zone + zone_flux(web, high, 180.0).value, whole, 1e-10);
        double tens = 0.0;
        for (const Lumens lm : ten_degree_zones(web))
            tens += lm.value;
        hold("zones of 10 degrees", tens, whole, 1e-10);
        if (const Result<Web> scaled = whole > 0.0 ? scaled_to(web, Lumens(800.0)) : Result<Web>(web); scaled)
            hold("scaled", whole > 0.0 ? flux(*scaled).value * whole / 800.0 : 0.0, whole, 1e-10);
        const std::array<WeightedWeb, 2> both{WeightedWeb{&web, 0.25}, WeightedWeb{&web, 1.5}};
        // A table that ends at a non-zero value gets a ramp of 1e-4 degrees.
        if (const Result<CombinedWeb> sum = combined(both)) hold("combined", flux(sum->web).value, 1.75 * whole, 1e-5);
        if (const std::optional<Radians> beam = spread_angle(web, random.uniform(0.0, 360.0), 0.5))
            tally.require(beam->value >= 0.0 && beam->value <= 2.0 * std::numbers::pi,
                          [&] { return fmt::format("a beam of {:a} rad", beam->value); });
    }
}

// A texture of any layout keeps the web's flux. Each texel is a float of 24 bits, which rounds up or down.
void textures(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; done += 512) { // approximately, in texels
        const Result<RandomWeb> made = random_web(random);
        if (!made || made->greatest == 0.0) continue;
        BakeOptions options;
        const std::uint64_t choice = random.bits() % 3;
        options.layout = choice == 0   ? Layout::latlong
                         : choice == 1 ? Layout::octahedral
                                       : Layout::octahedral_equal_area;
        options.width = choice == 0 ? 32 : 16;
        options.height = 16;
        options.threads = 1;
        // Candela in the range of a float texture.
        const Web web = made->web.scaled(1000.0 / made->greatest);
        const Result<Texture> texture = bake_texture(web, options);
        tally.looked_at(static_cast<std::uint64_t>(options.width) * 16);
        tally.require(texture.has_value(), [&] { return std::string("a texture was refused"); });
        if (!texture) continue;
        for (const float texel : texture->image.pixels)
            tally.require(is_amount(static_cast<double>(texel)) && texel <= 1000.1F,
                          [&] { return fmt::format("texel {:a} of at most 1000 cd, {}", texel, texture->layout); });
        const double lm = texture->flux.value;
        if (lm > 1e-3)
            tally.hold(std::fabs(texture->texture_flux.value - lm) / (1e-6 * lm), [&] {
                return fmt::format("{}: {:a} lm for {:a}", texture->layout, texture->texture_flux.value, lm);
            });
    }
}

// Runs of texels: every instruction set gives the same bits.
void ramps(Random& random, std::uint64_t evaluations, StressTally& tally) {
    std::array<float, 67> plain{};
    std::array<float, 67> wide{};
    for (std::uint64_t done = 0; done < evaluations; done += plain.size()) {
        bake::Ramp ramp;
        ramp.mean = hostile::number(random);
        ramp.mean_step = hostile::number(random) * 1e-3;
        ramp.center = hostile::number(random);
        ramp.center_step = hostile::number(random) * 1e-3;
        const auto type = static_cast<TexelType>(random.bits() % 4);
        const std::size_t count = 1 + random.bits() % plain.size();
        const bake::RampTotals expected =
            bake::kernels(simd::InstructionSet::scalar).store_ramp(ramp, type, plain.data(), count);
        for (const simd::InstructionSet set : simd::available_sets()) {
            const bake::RampTotals found = bake::kernels(set).store_ramp(ramp, type, wide.data(), count);
            tally.looked_at(count);
            bool same = __builtin_bit_cast(std::uint64_t, found.sum) == __builtin_bit_cast(std::uint64_t, expected.sum);
            for (std::size_t i = 0; i < count; ++i)
                same =
                    same && __builtin_bit_cast(std::uint32_t, plain[i]) == __builtin_bit_cast(std::uint32_t, wide[i]);
            tally.require(same, [&] {
                return fmt::format("{} differs: mean {:a} step {:a} centre {:a} step {:a} type {} of {}",
                                   simd::to_text(set), ramp.mean, ramp.mean_step, ramp.center, ramp.center_step,
                                   static_cast<int>(type), count);
            });
        }
    }
}

// Written numbers read back as the same double, and decimals read as the C library reads them.
void numbers(Random& random, std::uint64_t evaluations, StressTally& tally) {
    const std::string padding(static_cast<std::size_t>(profile_detail::decimal_lookahead), ' ');
    const auto read = [&](const std::string& text, double& value) {
        const std::string padded = text + padding;
        return profile_detail::read_decimal(padded.data(), padded.data() + padded.size(), value) != nullptr;
    };
    for (std::uint64_t done = 0; done < evaluations; done += 2) {
        const auto any = __builtin_bit_cast(double, random.bits());
        const double value = random.bits() % 2 == 0 && std::isfinite(any) ? any : random.uniform(-1e6, 1e6);
        std::string text;
        profile_detail::append_number(text, value);
        const double back = std::strtod(text.c_str(), nullptr);
        tally.looked_at(2);
        tally.require(back == value, [&] { return fmt::format("{:a} was written as {}", value, text); });
        double found = 0.0;
        if (read(text, found))
            tally.require(found == value, [&] { return fmt::format("{} was read as {:a}", text, found); });

        std::string decimals = std::to_string(random.bits() >> (random.bits() % 64));
        if (random.bits() % 4 != 0) decimals.insert(random.bits() % (decimals.size() + 1), 1, '.');
        if (random.bits() % 4 == 0) decimals.insert(0, 1, '-');
        const double truth = std::strtod(decimals.c_str(), nullptr);
        if (read(decimals, found))
            tally.require(found == truth, [&] { return fmt::format("{} was read as {:a}", decimals, found); });
    }
}

} // namespace

std::span<const StressSubject> web_stress() {
    static constexpr std::array subjects{
        StressSubject{"candela by direction", "from 0 to the table's greatest", 0.5, lookups},
        StressSubject{"flux of webs", "from 0 to the greatest intensity all around", 0.02, fluxes},
        StressSubject{"webs turned, cut and added", "1e-10 of a web as bright all around; added 1e-5, compacted 1e-8",
                      0.02, transformed},
        StressSubject{"textures of webs", "1e-6 of the flux, texels from 0 to the greatest intensity", 0.05, textures},
        StressSubject{"runs of texels", "the same bits from every instruction set", 0.5, ramps},
        StressSubject{"numbers in files", "the same double, to the bit", 0.5, numbers},
    };
    return subjects;
}

} // namespace gonio::measure::detail
