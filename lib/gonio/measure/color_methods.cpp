#include <gonio/color/kernels.hpp>
#include <gonio/color/named_methods.hpp>
#include <gonio/color/planckian.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/measure/color_methods.hpp>
#include <gonio/measure/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace gonio::measure {

namespace {

constexpr Kelvin coolest_measured{800.0};
constexpr Kelvin hottest_measured{25000.0};

// Fills in the errors of a subject against the sum.
void fill(ColorMeasurement& measured, const ColorSubject& subject, std::size_t cases) {
    const std::vector<Kelvin> kelvin = temperatures_between(measured.coolest, measured.hottest, cases);
    std::vector<glm::dvec3> xyz(kelvin.size());
    subject.xyz(kelvin, xyz);
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
    subject.xyz({Kelvin(2700)}, warm);
    measured.luminance_2700k = warm[0].y;
}

ColorSubject function_subject(std::string name, Kelvin coolest, Kelvin hottest, glm::dvec3 (*xyz)(Kelvin)) {
    ColorSubject subject;
    subject.name = std::move(name);
    subject.code = "double";
    subject.coolest = Kelvin(std::max(coolest.value, coolest_measured.value));
    subject.hottest = Kelvin(std::min(hottest.value, hottest_measured.value));
    subject.xyz = [xyz](const std::vector<Kelvin>& kelvin, std::vector<glm::dvec3>& colors) {
        for (std::size_t i = 0; i < kelvin.size(); ++i)
            colors[i] = xyz(kelvin[i]);
    };
    // The sum adds 471 exponentials per value, so few values are timed.
    const std::vector<Kelvin> kelvin = temperatures_between(subject.coolest, subject.hottest, 256);
    const auto colors = std::make_shared<std::vector<glm::dvec3>>(kelvin.size());
    subject.timed = {[xyz, kelvin, colors] {
                         for (std::size_t i = 0; i < kelvin.size(); ++i)
                             (*colors)[i] = xyz(kelvin[i]);
                     },
                     kelvin.size()};
    return subject;
}

// Arrays in the layout that the kernels need.
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

ColorSubject batch_subject(std::string name, const char* code, Kelvin coolest, Kelvin hottest, Batch batch) {
    const RgbSpace& space = *find_rgb_space("rec709");
    const color::RgbConstants constants = color::rgb_constants(space);
    const auto call = [constants, batch](Arrays& arrays) {
        float* const rgb[3] = {arrays.rgb[0].data(), arrays.rgb[1].data(), arrays.rgb[2].data()};
        batch(arrays.kelvin.data(), arrays.kelvin.size(), constants, rgb);
    };
    ColorSubject subject;
    subject.name = std::move(name);
    subject.code = code;
    subject.coolest = coolest;
    subject.hottest = hottest;
    subject.xyz = [&space, call](const std::vector<Kelvin>& kelvin, std::vector<glm::dvec3>& colors) {
        Arrays arrays(kelvin);
        call(arrays);
        for (std::size_t i = 0; i < kelvin.size(); ++i)
            colors[i] = space.to_xyz * glm::dvec3(arrays.rgb[0][i], arrays.rgb[1][i], arrays.rgb[2][i]);
    };
    // Few enough to stay in the second-level cache.
    const auto arrays = std::make_shared<Arrays>(temperatures_between(coolest, hottest, 4096));
    subject.timed = {[call, arrays] { call(*arrays); }, arrays->kelvin.size()};
    return subject;
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

std::vector<ColorSubject> color_subjects() {
    std::vector<ColorSubject> subjects{
        function_subject("sum-1nm", coolest_measured, hottest_measured, [](Kelvin T) { return planckian_xyz(T); })};
    for (const simd::InstructionSet set : simd::available_sets()) {
        const color::Kernels& kernels = color::kernels(set);
        subjects.push_back(
            batch_subject("fit", kernels.name, coolest_measured, hottest_measured, kernels.planckian_rgb));
        subjects.push_back(batch_subject("krystek", kernels.name, Kelvin(1000), Kelvin(15000), kernels.krystek_rgb));
    }
    for (const ColorMethod& method : color_methods())
        if (method.name != "fit-float") // the kernels above
            subjects.push_back(function_subject(std::string(method.name), method.coolest, method.hottest, method.xyz));
    return subjects;
}

std::vector<CctSubject> cct_subjects() {
    std::vector<CctSubject> subjects{{"newton-on-sum", cct_by_sum}};
    for (const CctMethod& method : cct_methods())
        subjects.push_back({std::string(method.name), method.cct_k});
    return subjects;
}

TimedWork timed_cct(double (*cct_k)(Uv), std::vector<OffLocus> cases) {
    const std::size_t count = cases.size();
    return {[cct_k, of = std::move(cases), sink = std::make_shared<double>()] {
                double sum = 0.0;
                for (const OffLocus& c : of)
                    sum += cct_k(c.at);
                *sink = sum;
            },
            count};
}

Result<std::vector<ColorMeasurement>> compare_color_methods(const ColorComparisonOptions& options) {
    std::vector<ColorMeasurement> all;
    for (const ColorSubject& subject : color_subjects()) {
        ColorMeasurement measured;
        measured.name = subject.name;
        measured.code = subject.code;
        measured.coolest = subject.coolest;
        measured.hottest = subject.hottest;
        fill(measured, subject, options.cases);
        Result<Timing> timing = time_work(subject.timed.work, subject.timed.items, options.timing);
        if (!timing) return pass_on(timing);
        measured.timing = *timing;
        all.push_back(std::move(measured));
    }
    return all;
}

Result<std::vector<CctMeasurement>> compare_cct_methods(const ColorComparisonOptions& options) {
    const std::vector<OffLocus> wide = chromaticities_between(Kelvin(1500), Kelvin(40000), 0.05, options.cases);
    const std::vector<OffLocus> narrow = chromaticities_between(Kelvin(2000), Kelvin(10000), 0.005, options.cases);
    std::vector<CctMeasurement> all;
    for (const CctSubject& subject : cct_subjects()) {
        CctMeasurement measured{subject.name, worst(subject.cct_k, wide), worst(subject.cct_k, narrow), {}};
        const TimedWork timed = timed_cct(
            subject.cct_k,
            {narrow.begin(), narrow.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(256, narrow.size()))});
        Result<Timing> timing = time_work(timed.work, timed.items, options.timing);
        if (!timing) return pass_on(timing);
        measured.timing = *timing;
        all.push_back(std::move(measured));
    }
    return all;
}

} // namespace gonio::measure
