// Google Benchmark of the sphere kernels, with all instruction sets side by side.
//
// How to read it: times vary with the machine; ratios within one run are stable. The baseline is the `scalar` row of
// the same group (the plain float code, compiled for the minimum processor); divide its time by another row's.
// `items_per_second` counts surface points.
#include <gonio/measure/sphere_cases.hpp>
#include <gonio/measure/sphere_methods.hpp>
#include <gonio/shading/brdf.hpp>
#include <gonio/shading/kernels.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace gonio;
using measure::SphereCases;
using measure::Stratum;
using shading::LightConstants;
using shading::MaterialConstants;

constexpr std::size_t points = 4096; // fits in the second-level cache

void irradiance(benchmark::State& state, const shading::Kernels& kernels, const SphereCases& cases) {
    std::vector<float> lx(cases.size());
    const LightConstants light = SphereCases::light();
    for (auto _ : state) {
        kernels.irradiance(cases.surfaces(), light, lx.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases.size()));
}

const MaterialConstants matte = shading::constants_of(shading::Lambert<float>{{0.5F, 0.5F, 0.5F}});
const MaterialConstants glossy =
    shading::constants_of(shading::Frostbite<float>{{0.5F, 0.5F, 0.5F}, {0.04F, 0.04F, 0.04F}, 1.0F, 0.5F, 0.25F});

void shade(benchmark::State& state, const shading::Kernels& kernels, const SphereCases& cases,
           LightConstants::Kind light_kind, const MaterialConstants& material) {
    std::vector<float> rgb(3 * cases.size());
    std::vector<float> candela(cases.size(), 100.0F);
    float* const out[3] = {rgb.data(), rgb.data() + cases.size(), rgb.data() + 2 * cases.size()};
    LightConstants light = SphereCases::light();
    light.kind = light_kind;
    light.intensity_cd = candela.data();
    shading::Surfaces surfaces = cases.surfaces();
    std::copy(std::begin(surfaces.normal), std::end(surfaces.normal), std::begin(surfaces.view));
    for (auto _ : state) {
        kernels.shade(surfaces, light, material, out);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases.size()));
}

void named_method(benchmark::State& state, const measure::SphereMethod& method, const SphereCases& cases) {
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

} // namespace

int main(int argc, char** argv) {
    static const SphereCases above = measure::sphere_cases_of(Stratum::above, points, 3);
    static const SphereCases straddling = measure::sphere_cases_of(Stratum::straddling, points, 3);
    static const SphereCases mixed = measure::sphere_cases(points, 3);
    for (const simd::InstructionSet set : simd::available_sets()) {
        const shading::Kernels& kernels = shading::kernels(set);
        const std::string name = kernels.name;
        const auto add = [&](const std::string& group, auto&&... arguments) {
            benchmark::RegisterBenchmark((group + "/" + name).c_str(), arguments...);
        };
        add("irradiance/above", [&](benchmark::State& s) { irradiance(s, kernels, above); });
        add("irradiance/straddling", [&](benchmark::State& s) { irradiance(s, kernels, straddling); });
        add("irradiance/mixed", [&](benchmark::State& s) { irradiance(s, kernels, mixed); });
        add("shade/point-lambert",
            [&](benchmark::State& s) { shade(s, kernels, above, LightConstants::Kind::punctual, matte); });
        add("shade/point-frostbite",
            [&](benchmark::State& s) { shade(s, kernels, above, LightConstants::Kind::punctual, glossy); });
        add("shade/sphere-frostbite",
            [&](benchmark::State& s) { shade(s, kernels, mixed, LightConstants::Kind::sphere, glossy); });
    }
    static const std::vector<measure::SphereMethod> methods = measure::sphere_methods();
    for (const measure::SphereMethod& method : methods)
        benchmark::RegisterBenchmark(("method/" + method.name + "/" + method.precision).c_str(),
                                     [&](benchmark::State& s) { named_method(s, method, mixed); });
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
