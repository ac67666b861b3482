// Lights with a size on every material by every specular method: the kernels of each instruction set against the same
// formulas in double.
#include <gonio/measure/shade_in_double.hpp>
#include <gonio/measure/specular_cases.hpp>
#include <gonio/shading/coated.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/shade.hpp>

#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace gonio::shading;
using gonio::measure::Random;
using gonio::measure::SpecularCases;
using Kind = LightConstants::Kind;

constexpr SpecularMethod methods[] = {SpecularMethod::ltc,        SpecularMethod::representative_point,
                                      SpecularMethod::specular_d, SpecularMethod::dominant_direction,
                                      SpecularMethod::sun_disk,   SpecularMethod::spherical_hack};

// Lights around the origin; each sphere is paired with a sun of the same cone.
struct Cases {
    SpecularCases all;
    std::vector<LightConstants> lights;

    Cases(Kind kind, std::size_t count)
        : all(gonio::measure::specular_cases(kind == Kind::sun ? Kind::sphere : kind, count, 51)) {
        Random random(52);
        lights = all.area.lights;
        for (LightConstants& light : lights) {
            light.color[0] = 1.25F;
            light.color[1] = 0.5F;
            light.color[2] = 2.0F;
            if (kind == Kind::sun) light.angular_radius = static_cast<float>(std::exp(random.uniform(-6.0, 0.45)));
            light.kind = kind;
        }
    }
};

// Each material with a lobe of that α.
std::vector<std::pair<std::string, MaterialConstants>> materials_of(float alpha) {
    const vec3<float> albedo{0.8F, 0.5F, 0.2F};
    const vec3<float> f0{0.04F, 0.3F, 0.9F};
    const float root = std::sqrt(alpha);
    return {{"lambert", constants_of(Lambert<float>{albedo})},
            {"eon", constants_of(Eon<float>{albedo, root})},
            {"frostbite", constants_of(Frostbite<float>{albedo, f0, 1.0F, root, alpha})},
            {"ue4", constants_of(Ue4<float>{albedo, f0, 1.0F, alpha})},
            {"gltf", constants_of(Gltf<float>{albedo, f0, 1.0F, alpha})},
            {"anisotropic", constants_of(Anisotropic<float>{
                                albedo, f0, 1.0F, {alpha, 0.4F * alpha}, {{0.0F, 0.0F, 1.0F}, 0.6F, 0.8F}})},
            {"blinn", constants_of(Blinn<float>{albedo, f0, 2.0F / (alpha * alpha) + 1.0F})},
            {"ggx", constants_of(Ggx<float>{f0, alpha})},
            {"kulla-conty", constants_of(kulla_conty_material(f0, alpha))}};
}

// The same below a coat, whose α and order differ from one to the next.
std::vector<std::pair<std::string, MaterialConstants>> coated_materials_of(float alpha) {
    std::vector<std::pair<std::string, MaterialConstants>> made = materials_of(alpha);
    std::size_t turn = 0;
    for (auto& [name, constants] : made) {
        constexpr CoatOrder orders[] = {CoatOrder::physical, CoatOrder::physical, CoatOrder::ue4, CoatOrder::filament};
        with_material(constants.kind, [&, &constants = constants]<template<class> class Material>() {
            const auto base = material_of<Material, double>(constants);
            constants = constants_of(
                coated_material(base, 0.9, 0.3 + 0.05 * static_cast<double>(turn), orders[turn % std::size(orders)]));
        });
        name += " with a coat";
        ++turn;
    }
    return made;
}

template<template<class> class... Material>
constexpr std::size_t count_of(MaterialList<Material...> /*list*/) {
    return sizeof...(Material);
}

SurfacePoint<double> point_of(const Surfaces& surfaces, std::size_t i) {
    const auto at = [i](const float* const(&v)[3]) {
        return vec3<double>{static_cast<double>(v[0][i]), static_cast<double>(v[1][i]), static_cast<double>(v[2][i])};
    };
    return {at(surfaces.position), at(surfaces.normal), at(surfaces.view)};
}

std::string name_of(Kind kind) {
    constexpr const char* names[] = {"punctual", "sphere", "disk", "ellipse", "rectangle", "tube", "cylinder", "sun"};
    return names[static_cast<std::size_t>(kind)];
}

class ShadeKernels : public testing::TestWithParam<std::tuple<Kind, gonio::simd::InstructionSet>> {
protected:
    Kind kind = std::get<0>(GetParam());
    const Kernels& kernels = gonio::shading::kernels(std::get<1>(GetParam()));
};

INSTANTIATE_TEST_SUITE_P(Sets, ShadeKernels,
                         testing::Combine(testing::Values(Kind::sphere, Kind::disk, Kind::ellipse, Kind::rectangle,
                                                          Kind::tube, Kind::cylinder, Kind::sun),
                                          testing::ValuesIn(gonio::simd::available_sets().begin(),
                                                            gonio::simd::available_sets().end())),
                         [](const auto& each) {
                             return name_of(std::get<0>(each.param)) + "_" +
                                    gonio::simd::to_text(std::get<1>(each.param));
                         });

// For 99.5 % of the points: a representative point jumps where the mirrored ray runs along the light's plane, and a
// sun's disk magnifies the rounding of a direction relative to the lobe's width.
TEST_P(ShadeKernels, EveryMethodOnEveryMaterialAsInDouble) {
    const Cases cases(kind, 2048);
    ASSERT_EQ(materials_of(0.5F).size(), count_of(Materials()));
    const auto all_of = [](float alpha) {
        auto all = materials_of(alpha);
        const auto coated = coated_materials_of(alpha);
        all.insert(all.end(), coated.begin(), coated.end());
        return all;
    };
    for (const SpecularMethod method : methods)
        for (std::size_t m = 0; m < all_of(0.5F).size(); ++m) {
            std::size_t off = 0;
            for (std::size_t g = 0; g < cases.lights.size(); ++g) {
                LightConstants light = cases.lights[g];
                light.specular_method = method;
                const MaterialConstants material = all_of(std::max(cases.all.alpha[g], 0.03F))[m].second;
                const Surfaces surfaces = cases.all.surfaces(g);
                std::vector<float> rgb(3 * surfaces.count);
                float* const out[3] = {rgb.data(), rgb.data() + surfaces.count, rgb.data() + 2 * surfaces.count};
                kernels.shade(surfaces, light, material, out);
                for (std::size_t i = 0; i < surfaces.count; ++i) {
                    const Reflected<double> truth =
                        gonio::measure::shade_parts_in_double(point_of(surfaces, i), light, material);
                    const vec3<double> sum = truth.diffuse + truth.specular;
                    const double channels[3] = {sum.x, sum.y, sum.z};
                    bool near = true;
                    for (std::size_t k = 0; k < 3; ++k)
                        near = near &&
                               std::fabs(static_cast<double>(out[k][i]) - channels[k]) <= 2e-3 * channels[k] + 2e-5;
                    off += near ? 0U : 1U;
                }
            }
            EXPECT_LE(off, cases.all.size() / 50)
                << "method " << static_cast<int>(method) << ' ' << all_of(0.5F)[m].first;
        }
}

// shade_parts_in_double() puts together from its parts what shade_parts() computes.
TEST(ShadeInDouble, IsWhatShadePartsComputes) {
    for (const Kind kind : {Kind::sphere, Kind::tube, Kind::sun}) {
        const Cases cases(kind, 256);
        for (std::size_t g = 0; g < cases.lights.size(); ++g) {
            LightConstants light = cases.lights[g];
            light.specular_method = SpecularMethod::representative_point;
            const MaterialConstants material = materials_of(std::max(cases.all.alpha[g], 0.03F))[2].second;
            const Surfaces surfaces = cases.all.surfaces(g);
            for (std::size_t i = 0; i < surfaces.count; ++i) {
                const SurfacePoint<double> point = point_of(surfaces, i);
                const Reflected<double> found = gonio::measure::shade_parts_in_double(point, light, material);
                Reflected<double> whole{};
                const auto by_type = [&](auto typed) {
                    detail::constants(light, typed);
                    whole = shade_parts<SpecularMethod::representative_point>(point, typed,
                                                                              material_of<Frostbite, double>(material));
                };
                if (kind == Kind::sphere) by_type(SphereLight<double>{});
                if (kind == Kind::tube) by_type(TubeLight<double>{});
                if (kind == Kind::sun) by_type(SunLight<double>{});
                EXPECT_NEAR(found.diffuse.y, whole.diffuse.y, 1e-13 * whole.diffuse.y);
                EXPECT_NEAR(found.specular.y, whole.specular.y, 1e-13 * whole.specular.y);
            }
        }
    }
}

// A sun gives the same as a very distant sphere with the same angle.
TEST(Sun, IsASphereFarAway) {
    Random random(53);
    for (int i = 0; i < 400; ++i) {
        const poses::Vec toward = poses::random_direction(random);
        const poses::Vec n = poses::random_direction(random);
        const SurfacePoint<double> point{{0, 0, 0}, n, poses::tilted(n, random.uniform(0.1, 1.0), random)};
        const double angle = random.uniform(1e-3, 1.5);
        constexpr double far = 1e6;
        const SunLight<double> sun{toward, {2, 2, 2}, std::sin(angle), std::cos(angle)};
        const SphereLight<double> sphere{toward * far, {2, 2, 2}, std::sin(angle) * far, 0.0};
        EXPECT_NEAR(illuminance(point, sun), illuminance(point, sphere), 1e-9);
        const Frostbite<double> material = frostbite_material<double>({0.5, 0.5, 0.5}, 0.6, 0.5, 0.5);
        const auto compare = [&](const Reflected<double>& a, const Reflected<double>& b) {
            EXPECT_NEAR(a.diffuse.x, b.diffuse.x, 1e-7 * b.diffuse.x + 1e-9);
            EXPECT_NEAR(a.specular.x, b.specular.x, 1e-7 * b.specular.x + 1e-9);
        };
        compare(shade_parts<SpecularMethod::ltc>(point, sun, material),
                shade_parts<SpecularMethod::ltc>(point, sphere, material));
        compare(shade_parts<SpecularMethod::representative_point>(point, sun, material),
                shade_parts<SpecularMethod::representative_point>(point, sphere, material));
        compare(shade_parts<SpecularMethod::sun_disk>(point, sun, material),
                shade_parts<SpecularMethod::sun_disk>(point, sphere, material));
    }
    // Half of the sky, overhead: π.
    const SurfacePoint<double> up{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
    EXPECT_NEAR(illuminance(up, SunLight<double>{{0, 0, 1}, {1, 1, 1}, 1.0, 0.0}), std::numbers::pi, 1e-15);
    EXPECT_NEAR(illuminance(up, SunLight<double>{{1, 0, 0}, {1, 1, 1}, 1.0, 0.0}), 0.5 * std::numbers::pi, 1e-15);
    EXPECT_EQ(illuminance(up, SunLight<double>{{0, 0, -1}, {1, 1, 1}, 0.5, std::sqrt(0.75)}), 0.0);
}

} // namespace
