#include <gonio/color/kernels.hpp>
#include <gonio/color/named_methods.hpp>
#include <gonio/color/planckian.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/measure/color_methods.hpp>
#include <gonio/measure/random.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace gonio::measure {

namespace {

constexpr Kelvin coolest_measured{800.0};
constexpr Kelvin hottest_measured{25000.0};

using Colors = std::function<void(const std::vector<Kelvin>&, std::vector<glm::dvec3>&)>; // XYZ of each

// The errors of what `colors` gives, against the sum.
void fill(ColorMeasurement& measured, const Colors& colors, std::size_t cases) {
    const std::vector<Kelvin> kelvin = temperatures_between(measured.coolest, measured.hottest, cases);
    std::vector<glm::dvec3> xyz(kelvin.size());
    colors(kelvin, xyz);
    double squares = 0.0;
    for (std::size_t i = 0; i < kelvin.size(); ++i) {
        const double error = delta_uv_prime(to_uv(xyz[i]), to_uv(planckian_xyz(kelvin[i])));
        squares += error * error;
        if (error > measured.worst) {
            measured.worst = error;
            measured.worst_at = kelvin[i];
        }
        if (kelvin[i].value >= 2000.0 && kelvin[i].value <= 10000.0)
            measured.worst_2_to_10_kk = std::max(measured.worst_2_to_10_kk, error);
    }
    measured.rms = std::sqrt(squares / static_cast<double>(kelvin.size()));
    std::vector<glm::dvec3> warm(1);
    colors({Kelvin(2700)}, warm);
    measured.luminance_2700k = warm[0].y;
}

Result<ColorMeasurement> measure_function(std::string name, Kelvin coolest, Kelvin hottest,
                                          const std::function<glm::dvec3(Kelvin)>& xyz,
                                          const ColorComparisonOptions& options) {
    ColorMeasurement measured;
    measured.name = std::move(name);
    measured.code = "double";
    measured.coolest = Kelvin(std::max(coolest.value, coolest_measured.value));
    measured.hottest = Kelvin(std::min(hottest.value, hottest_measured.value));
    fill(
        measured,
        [&](const std::vector<Kelvin>& kelvin, std::vector<glm::dvec3>& colors) {
            for (std::size_t i = 0; i < kelvin.size(); ++i)
                colors[i] = xyz(kelvin[i]);
        },
        options.cases);
    // A sum of 471 exponentials wants fewer of them.
    const std::vector<Kelvin> kelvin = temperatures_between(measured.coolest, measured.hottest, 256);
    std::vector<glm::dvec3> colors(kelvin.size());
    Result<Timing> timing = time_work(
        [&] {
            for (std::size_t i = 0; i < kelvin.size(); ++i)
                colors[i] = xyz(kelvin[i]);
        },
        kelvin.size(), options.timing);
    if (!timing) return pass_on(timing);
    measured.timing = *timing;
    return measured;
}

// Arrays as the kernels want them.
struct Arrays {
    std::vector<float> kelvin;
    std::array<std::vector<float>, 3> rgb;

    explicit Arrays(const std::vector<Kelvin>& temperatures) {
        for (const Kelvin T : temperatures)
            kelvin.push_back(static_cast<float>(T.value));
        for (std::vector<float>& channel : rgb)
            channel.resize(kelvin.size());
    }
};

using Batch = void (*)(const float*, std::size_t, const color::RgbConstants&, float* const[3]);

Result<ColorMeasurement> measure_batch(std::string name, const char* code, Kelvin coolest, Kelvin hottest, Batch batch,
                                       const ColorComparisonOptions& options) {
    const RgbSpace& space = *find_rgb_space("rec709");
    const color::RgbConstants constants = color::rgb_constants(space);
    const auto call = [&](Arrays& arrays) {
        float* const rgb[3] = {arrays.rgb[0].data(), arrays.rgb[1].data(), arrays.rgb[2].data()};
        batch(arrays.kelvin.data(), arrays.kelvin.size(), constants, rgb);
    };
    ColorMeasurement measured;
    measured.name = std::move(name);
    measured.code = code;
    measured.coolest = coolest;
    measured.hottest = hottest;
    fill(
        measured,
        [&](const std::vector<Kelvin>& kelvin, std::vector<glm::dvec3>& colors) {
            Arrays arrays(kelvin);
            call(arrays);
            for (std::size_t i = 0; i < kelvin.size(); ++i)
                colors[i] = space.to_xyz * glm::dvec3(arrays.rgb[0][i], arrays.rgb[1][i], arrays.rgb[2][i]);
        },
        options.cases);
    Arrays arrays(temperatures_between(coolest, hottest, 4096)); // stays in the second-level cache
    Result<Timing> timing = time_work([&] { call(arrays); }, arrays.kelvin.size(), options.timing);
    if (!timing) return pass_on(timing);
    measured.timing = *timing;
    return measured;
}

double cct_by_sum(Uv at) {
    const Result<Cct> found = exact_cct(at);
    return found ? found->temperature.value : std::numeric_limits<double>::quiet_NaN();
}

double worst(double (*cct_k)(Uv), const std::vector<OffLocus>& cases) {
    double found = 0.0;
    for (const OffLocus& c : cases) {
        const double error = std::abs(cct_k(c.at) - c.truth.temperature.value);
        found = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(found, error);
    }
    return found;
}

} // namespace

std::vector<Kelvin> temperatures_between(Kelvin coolest, Kelvin hottest, std::size_t count) {
    std::vector<Kelvin> kelvin;
    const double first = 1e6 / hottest.value;
    const double last = 1e6 / coolest.value;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
        kelvin.emplace_back(std::clamp(1e6 / (first + (last - first) * share), coolest.value, hottest.value));
    }
    return kelvin;
}

std::vector<OffLocus> chromaticities_between(Kelvin coolest, Kelvin hottest, double greatest, std::size_t count) {
    Random random(1);
    std::vector<OffLocus> found;
    for (std::size_t i = 0; i < count; ++i) {
        const double mired = random.uniform(1e6 / hottest.value, 1e6 / coolest.value);
        const double duv = random.uniform(-greatest, greatest);
        const LocusPoint p = planckian_sum(mired * 1e-3);
        const double length = std::hypot(p.first.u, p.first.v);
        found.push_back(
            {{p.at.u - duv * p.first.v / length, p.at.v + duv * p.first.u / length}, {Kelvin(1e6 / mired), duv}});
    }
    return found;
}

Result<std::vector<ColorMeasurement>> compare_color_methods(const ColorComparisonOptions& options) {
    std::vector<ColorMeasurement> all;
    const auto keep = [&](Result<ColorMeasurement> measured) -> Result<void> {
        if (!measured) return pass_on(measured);
        all.push_back(std::move(*measured));
        return {};
    };
    Result<void> kept = keep(measure_function(
        "sum of 1 nm", coolest_measured, hottest_measured, [](Kelvin T) { return planckian_xyz(T); }, options));
    for (const simd::InstructionSet set : simd::available_sets()) {
        const color::Kernels& kernels = color::kernels(set);
        if (kept)
            kept = keep(
                measure_batch("fit", kernels.name, coolest_measured, hottest_measured, kernels.planckian_rgb, options));
        if (kept)
            kept =
                keep(measure_batch("krystek", kernels.name, Kelvin(1000), Kelvin(15000), kernels.krystek_rgb, options));
    }
    for (const ColorMethod& method : color_methods())
        if (kept && method.name != "fit-float") // the kernels above
            kept =
                keep(measure_function(std::string(method.name), method.coolest, method.hottest, method.xyz, options));
    if (!kept) return pass_on(kept);
    return all;
}

Result<std::vector<CctMeasurement>> compare_cct_methods(const ColorComparisonOptions& options) {
    const std::vector<OffLocus> wide = chromaticities_between(Kelvin(1500), Kelvin(40000), 0.05, options.cases);
    const std::vector<OffLocus> narrow = chromaticities_between(Kelvin(2000), Kelvin(10000), 0.005, options.cases);
    std::vector<std::pair<std::string, double (*)(Uv)>> methods{{"Newton on the sum", cct_by_sum}};
    for (const CctMethod& method : cct_methods())
        methods.emplace_back(method.name, method.cct_k);
    std::vector<CctMeasurement> all;
    for (const auto& [name, cct_k] : methods) {
        CctMeasurement measured{name, worst(cct_k, wide), worst(cct_k, narrow), {}};
        constexpr std::size_t timed = 256;
        double sink = 0.0;
        Result<Timing> timing = time_work(
            [&, call = cct_k] {
                for (std::size_t i = 0; i < timed; ++i)
                    sink += call(narrow[i % narrow.size()].at);
            },
            timed, options.timing);
        if (!timing) return pass_on(timing);
        if (std::isnan(sink)) measured.worst_near_k = std::numeric_limits<double>::infinity();
        measured.timing = *timing;
        all.push_back(std::move(measured));
    }
    return all;
}

} // namespace gonio::measure
