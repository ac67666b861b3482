// Google Benchmark of disk, rectangle and tube: every method, one instruction set beside the other.
//
// How to read it: times swing with the machine, ratios within one run hold. The baselines are the `exact/scalar` row of
// the same shape and poses (the plain float code, compiled for the least processor) and `frostbite/float`.
// `items_per_second` counts surface points.
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

constexpr std::size_t points = 4096; // stays in the second-level cache

// Poses of one stratum, in the order in which they were made, so that each group keeps its light.
AreaCases only(Kind kind, Stratum stratum) {
    const AreaCases all = measure::area_cases(kind, points * measure::stratum_count, 3);
    AreaCases some;
    for (std::size_t g = 0; g < all.lights.size() && some.size() < points; ++g) {
        std::vector<std::size_t> of_group;
        for (std::size_t i = g * AreaCases::group_size; i < (g + 1) * AreaCases::group_size; ++i)
            if (all.stratum[i] == stratum) of_group.push_back(i);
        some.lights.push_back(all.lights[g]);
        for (std::size_t k = 0; k < AreaCases::group_size; ++k) {
            const std::size_t i = of_group[k % of_group.size()];
            for (std::size_t c = 0; c < 3; ++c) {
                some.position[c].push_back(all.position[c][i]);
                some.normal[c].push_back(all.normal[c][i]);
            }
            some.stratum.push_back(stratum);
        }
    }
    return some;
}

void run(benchmark::State& state, const measure::AreaMethod& method, const AreaCases& cases) {
    std::vector<float> lx(cases.size());
    for (auto _ : state) {
        method.evaluate(cases, lx);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases.size()));
}

measure::AreaMethod scalar_kernel() {
    const shading::Kernels& kernels = shading::kernels(simd::InstructionSet::scalar);
    return {"exact", "scalar", [&kernels](const AreaCases& cases, std::span<float> lx) {
                for (std::size_t g = 0; g < cases.lights.size(); ++g)
                    kernels.irradiance(cases.surfaces(g), cases.lights[g], lx.data() + g * AreaCases::group_size);
            }};
}

} // namespace

int main(int argc, char** argv) {
    std::vector<std::pair<std::string, AreaCases>> sets;
    for (const auto& [kind, name] :
         {std::pair{Kind::disk, "disk"}, std::pair{Kind::rectangle, "rectangle"}, std::pair{Kind::tube, "tube"}}) {
        sets.clear();
        for (const Stratum stratum : {Stratum::above, Stratum::straddling, Stratum::near, Stratum::far})
            sets.emplace_back(measure::to_text(stratum), only(kind, stratum));
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
