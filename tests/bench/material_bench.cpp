// Google Benchmark of the materials under a point light, with all instruction sets side by side; and of Frostbite on a
// floor under each light with a size.
//
// How to read it: times vary with the machine; ratios within one run are stable. The baseline is the `frostbite` row of
// the same instruction set; divide its time by another row's. For a light with a size the baseline is that light's
// `representative-point`. `items_per_second` counts surface points.
#include <gonio/measure/sphere_cases.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace gonio;
using measure::SphereCases;

constexpr std::size_t points = 4096; // fits in the second-level cache

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

// A floor of 6 m by 6 m, 2 m below the light, seen by an eye at its edge; in the order of a picture's tiles.
struct Floor {
    std::vector<float> numbers[9];

    Floor() {
        constexpr int side = 64;
        for (int i = 0; i < side * side; ++i) {
            const float x = 6.0F * (static_cast<float>(i % side) / side - 0.5F);
            const float y = 6.0F * (static_cast<float>(i / side) / side - 0.5F);
            const float to_eye[3] = {-x, -5.0F - y, 1.6F};
            const float length = std::sqrt(to_eye[0] * to_eye[0] + to_eye[1] * to_eye[1] + to_eye[2] * to_eye[2]);
            const float of_point[9] = {
                x, y, 0.0F, 0.0F, 0.0F, 1.0F, to_eye[0] / length, to_eye[1] / length, to_eye[2] / length};
            for (std::size_t k = 0; k < 9; ++k)
                numbers[k].push_back(of_point[k]);
        }
    }
    shading::Surfaces surfaces() const {
        shading::Surfaces all;
        for (std::size_t k = 0; k < 3; ++k) {
            all.position[k] = numbers[k].data();
            all.normal[k] = numbers[3 + k].data();
            all.view[k] = numbers[6 + k].data();
        }
        all.count = numbers[0].size();
        return all;
    }
};

shading::LightConstants area_light(shading::LightConstants::Kind kind, float size) {
    shading::LightConstants light;
    light.kind = kind;
    light.position[2] = 2.0F;
    light.radius = kind == shading::LightConstants::Kind::tube ? 0.05F * size : 0.5F * size;
    light.width = size;
    light.height = 0.5F * size;
    light.length = 2.0F * size;
    light.angular_radius = 0.1F * size;
    if (kind == shading::LightConstants::Kind::tube) {
        light.axis[0] = 1.0F;
        light.axis[2] = 0.0F;
    }
    return light;
}

void shade_floor(benchmark::State& state, const shading::Kernels& kernels, const Floor& floor,
                 const shading::LightConstants& light) {
    const shading::Surfaces surfaces = floor.surfaces();
    std::vector<float> rgb(3 * surfaces.count);
    float* const out[3] = {rgb.data(), rgb.data() + surfaces.count, rgb.data() + 2 * surfaces.count};
    const shading::MaterialConstants material = material_constants(parse_material("frostbite").value());
    for (auto _ : state) {
        kernels.shade(surfaces, light, material, out);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(surfaces.count));
}

void register_area_lights(const Floor& floor) {
    using Kind = shading::LightConstants::Kind;
    using shading::SpecularMethod;
    const std::pair<const char*, Kind> kinds[] = {{"sphere", Kind::sphere},
                                                  {"disk", Kind::disk},
                                                  {"rectangle", Kind::rectangle},
                                                  {"tube", Kind::tube},
                                                  {"sun", Kind::sun}};
    const std::pair<const char*, SpecularMethod> methods[] = {
        {"ltc", SpecularMethod::ltc}, {"representative-point", SpecularMethod::representative_point}};
    for (const simd::InstructionSet set : simd::available_sets())
        for (const auto& [shape, kind] : kinds)
            for (const auto& [size_name, size] : {std::pair{"small", 0.1F}, {"ordinary", 0.6F}, {"large", 2.0F}})
                for (const auto& [method_name, method] : methods) {
                    shading::LightConstants light = area_light(kind, size);
                    light.specular_method = method;
                    const shading::Kernels& kernels = shading::kernels(set);
                    benchmark::RegisterBenchmark(
                        (std::string(kernels.name) + "/" + shape + "/" + size_name + "/" + method_name).c_str(),
                        [&kernels, &floor, light](benchmark::State& s) { shade_floor(s, kernels, floor, light); });
                }
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
    static const Floor floor;
    register_area_lights(floor);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
