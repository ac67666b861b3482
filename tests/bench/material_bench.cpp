// Google Benchmark of the materials under a point light, one instruction set beside the other.
//
// How to read it: times swing with the machine, ratios within one run hold. The baseline is the `frostbite` row of the
// same set; divide its time by another row's. `items_per_second` counts surface points.
#include <gonio/measure/sphere_cases.hpp>
#include <gonio/preview/shading_constants.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/shading/kernels.hpp>

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace gonio;
using measure::SphereCases;

constexpr std::size_t points = 4096; // stays in the second-level cache

void shade(benchmark::State& state, const shading::Kernels& kernels, const SphereCases& cases, const Material& kind) {
    std::vector<float> rgb(3 * cases.size());
    const std::vector<float> candela(cases.size(), 100.0F);
    float* const out[3] = {rgb.data(), rgb.data() + cases.size(), rgb.data() + 2 * cases.size()};
    shading::LightConstants light = SphereCases::light();
    light.kind = shading::LightConstants::Kind::punctual;
    light.intensity_cd = candela.data();
    const shading::MaterialConstants material = material_constants(kind);
    shading::Surfaces surfaces = cases.surfaces();
    for (std::size_t k = 0; k < 3; ++k)
        surfaces.view[k] = surfaces.normal[k];
    for (auto _ : state) {
        kernels.shade(surfaces, light, material, out);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases.size()));
}

} // namespace

int main(int argc, char** argv) {
    static const SphereCases above = measure::sphere_cases_of(measure::Stratum::above, points, 3);
    for (const simd::InstructionSet set : simd::available_sets())
        for (const MaterialKind& kind : material_kinds()) {
            const Material material = parse_material(kind.kind).value();
            const shading::Kernels& kernels = shading::kernels(set);
            benchmark::RegisterBenchmark(
                (std::string(kernels.name) + "/" + std::string(kind.kind)).c_str(),
                [&kernels, material](benchmark::State& s) { shade(s, kernels, above, material); });
        }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
