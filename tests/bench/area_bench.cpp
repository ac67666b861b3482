// Google Benchmark of disk, rectangle and tube: every method, with all instruction sets side by side.
//
// How to read it: times vary with the machine; ratios within one run are stable. The baselines are the `exact/scalar`
// row of the same shape and poses (the plain float code, compiled for the minimum processor), and
// `rectangle/…/frostbite` of the same instruction set. `items_per_second` counts surface points.
#include <gonio/measure/area_methods.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/simd/dispatch.hpp>

#include <benchmark/benchmark.h>

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace gonio;
using Kind = shading::LightConstants::Kind;
using measure::AreaCases;
using measure::Stratum;

constexpr std::size_t points = 4096; // fits in the second-level cache

void run(benchmark::State& state, const measure::AreaMethod& method, const AreaCases& cases) {
    std::vector<float> lx(cases.size());
    std::vector<double> wide(cases.size());
    for (auto _ : state) {
        if (method.evaluate_double) {
            method.evaluate_double(cases, wide);
        } else {
            method.evaluate(cases, lx);
        }
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases.size()));
}

measure::AreaMethod scalar_kernel() {
    const shading::Kernels& kernels = shading::kernels(simd::InstructionSet::scalar);
    return {"exact",
            "scalar",
            [&kernels](const AreaCases& cases, std::span<float> lx) {
                for (std::size_t g = 0; g < cases.lights.size(); ++g)
                    kernels.irradiance(cases.surfaces(g), cases.lights[g], lx.data() + g * AreaCases::group_size);
            },
            {}};
}

} // namespace

int main(int argc, char** argv) {
    std::vector<std::pair<std::string, AreaCases>> sets;
    for (const auto& [kind, name] : {std::pair{Kind::disk, "disk"}, std::pair{Kind::ellipse, "ellipse"},
                                     std::pair{Kind::rectangle, "rectangle"}, std::pair{Kind::tube, "tube"}}) {
        sets.clear();
        for (const Stratum stratum : {Stratum::above, Stratum::straddling, Stratum::near, Stratum::far})
            sets.emplace_back(measure::to_text(stratum), measure::area_cases_of(kind, stratum, points, 3));
        sets.emplace_back("mixed", measure::area_cases(kind, points, 3));
        auto methods = measure::area_methods(kind);
        methods.push_back(scalar_kernel());
        for (const auto& [poses, cases] : sets)
            for (const auto& method : methods)
                benchmark::RegisterBenchmark(
                    (std::string(name) + '/' + poses + '/' + method.name + '/' + method.precision).c_str(),
                    [method, cases](benchmark::State& s) { run(s, method, cases); });
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
