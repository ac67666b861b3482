// Google Benchmark of colour temperatures: the batch kernels against Krystek's formula and the 1 nm sum, and the
// inverse against Newton's method on that sum.
//
// How to read it: times vary with the machine; ratios within one run are stable. Divide by the `krystek` row of the
// same instruction set (written as in its paper: two quotients, then the projection), by `sum/1nm`, or by
// `inverse/newton-on-sum`. `items_per_second` counts values.
#include <gonio/color/kernels.hpp>
#include <gonio/color/light_quality.hpp>
#include <gonio/color/planckian.hpp>
#include <gonio/measure/color_methods.hpp>

#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace gonio;

constexpr std::size_t values = 4096; // fits in the second-level cache

struct Arrays {
    std::vector<float> kelvin;
    std::vector<float> duv;
    std::array<std::vector<float>, 3> rgb;
    float* out[3] = {};

    Arrays() {
        for (const Kelvin T : measure::temperatures_between(Kelvin(1000), Kelvin(15000), values))
            kelvin.push_back(static_cast<float>(T.value));
        duv.assign(values, 0.003F);
        for (std::size_t c = 0; c < 3; ++c) {
            rgb[c].resize(values);
            out[c] = rgb[c].data();
        }
    }
};

template<class Call>
void run(benchmark::State& state, const Call& call) {
    Arrays arrays;
    const color::RgbConstants space = color::rgb_constants(*find_rgb_space("rec709"));
    for (auto _ : state) {
        call(arrays, space);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(values));
}

void sum_1nm(benchmark::State& state) {
    const std::vector<Kelvin> kelvin = measure::temperatures_between(Kelvin(1000), Kelvin(15000), 64);
    for (auto _ : state)
        for (const Kelvin T : kelvin)
            benchmark::DoNotOptimize(planckian_xyz(T));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kelvin.size()));
}

template<class Call>
void inverse(benchmark::State& state, const Call& call) {
    const auto cases = measure::chromaticities_between(Kelvin(1500), Kelvin(40000), 0.05, 256);
    for (auto _ : state)
        for (const measure::OffLocus& c : cases)
            benchmark::DoNotOptimize(call(c.at));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases.size()));
}

template<class Call>
void quality(benchmark::State& state, const std::string& name, const Call& call) {
    const Spectrum spectrum = *read_spectrum(name);
    for (auto _ : state)
        benchmark::DoNotOptimize(call(spectrum));
}

} // namespace

int main(int argc, char** argv) {
    for (const simd::InstructionSet set : simd::available_sets()) {
        const color::Kernels& kernels = color::kernels(set);
        const std::string name = kernels.name;
        benchmark::RegisterBenchmark(("krystek/" + name).c_str(), [&kernels](benchmark::State& state) {
            run(state, [&](Arrays& a, const color::RgbConstants& space) {
                kernels.krystek_rgb(a.kelvin.data(), values, space, a.out);
            });
        });
        benchmark::RegisterBenchmark(("planckian/" + name).c_str(), [&kernels](benchmark::State& state) {
            run(state, [&](Arrays& a, const color::RgbConstants& space) {
                kernels.planckian_rgb(a.kelvin.data(), values, space, a.out);
            });
        });
        benchmark::RegisterBenchmark(("cct-and-duv/" + name).c_str(), [&kernels](benchmark::State& state) {
            run(state, [&](Arrays& a, const color::RgbConstants& space) {
                kernels.cct_rgb(a.kelvin.data(), a.duv.data(), values, space, a.out);
            });
        });
    }
    benchmark::RegisterBenchmark("sum/1nm", sum_1nm);
    benchmark::RegisterBenchmark("inverse/fit",
                                 [](benchmark::State& state) { inverse(state, [](Uv at) { return fast_cct(at); }); });
    benchmark::RegisterBenchmark("inverse/newton-on-sum",
                                 [](benchmark::State& state) { inverse(state, [](Uv at) { return exact_cct(at); }); });
    for (const std::string name : {"FL2", "blackbody:2700K"}) { // in steps of 5 nm and of 1 nm
        benchmark::RegisterBenchmark(("quality/all/" + name).c_str(), [name](benchmark::State& state) {
            quality(state, name, [](const Spectrum& spectrum) { return light_quality(spectrum); });
        });
        benchmark::RegisterBenchmark(("quality/cri/" + name).c_str(), [name](benchmark::State& state) {
            quality(state, name, [](const Spectrum& spectrum) { return color_rendering(spectrum); });
        });
        benchmark::RegisterBenchmark(("quality/tm30/" + name).c_str(), [name](benchmark::State& state) {
            quality(state, name, [](const Spectrum& spectrum) { return color_fidelity(spectrum); });
        });
        benchmark::RegisterBenchmark(("quality/alpha-opic/" + name).c_str(), [name](benchmark::State& state) {
            quality(state, name, [](const Spectrum& spectrum) { return alpha_opic(spectrum); });
        });
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
