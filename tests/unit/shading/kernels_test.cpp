// The kernels of every instruction set: against shade.hpp in double, for every count, and on hostile input.
#include <gonio/measure/random.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/shade.hpp>

#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace gonio::shading;
using gonio::measure::Random;
using poses::Vec;
using Light = LightConstants::Kind;

enum class Material : std::uint8_t { lambert, frostbite };

struct Points {
    std::array<std::vector<float>, 3> position, normal, view;
    std::vector<float> intensity_cd;

    void add(Vec p, Vec n, Vec v, double cd) {
        const std::pair<std::array<std::vector<float>, 3>*, Vec> parts[] = {{&position, p}, {&normal, n}, {&view, v}};
        for (const auto& [to, from] : parts) {
            (*to)[0].push_back(static_cast<float>(from.x));
            (*to)[1].push_back(static_cast<float>(from.y));
            (*to)[2].push_back(static_cast<float>(from.z));
        }
        intensity_cd.push_back(static_cast<float>(cd));
    }
    std::size_t size() const { return intensity_cd.size(); }
    Surfaces surfaces() const {
        Surfaces s;
        for (std::size_t k = 0; k < 3; ++k) {
            s.position[k] = position[k].data();
            s.normal[k] = normal[k].data();
            s.view[k] = view[k].data();
        }
        s.count = size();
        return s;
    }
    template<class S>
    SurfacePoint<S> point(std::size_t i) const {
        const auto at = [i](const auto& v) {
            return vec3<S>{static_cast<S>(v[0][i]), static_cast<S>(v[1][i]), static_cast<S>(v[2][i])};
        };
        return {at(position), at(normal), at(view)};
    }
};

using Rgb = std::array<std::vector<float>, 3>;

Rgb run(const Kernels& kernels, const Points& points, const LightConstants& light, const MaterialConstants& material) {
    Rgb rgb;
    for (auto& channel : rgb)
        channel.assign(points.size(), -1.0F);
    float* const out[3] = {rgb[0].data(), rgb[1].data(), rgb[2].data()};
    kernels.shade(points.surfaces(), light, material, out);
    return rgb;
}

// The double reference of the same float constants.
vec3<double> reference(const Points& points, std::size_t i, const LightConstants& light,
                       const MaterialConstants& material) {
    const auto three = [](const float(&v)[3]) {
        return vec3<double>{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
    };
    const SurfacePoint<double> point = points.point<double>(i);
    const PunctualLight<double> punctual{three(light.position), three(light.color), points.intensity_cd[i],
                                         light.inverse_range};
    const SphereLight<double> sphere{three(light.position), three(light.color), light.radius, light.inverse_range};
    vec3<double> result{};
    with_material(material.kind, [&]<template<class> class Kind>() {
        const auto made = gonio::shading::material_of<Kind, double>(material);
        result = light.kind == Light::punctual ? shade(point, punctual, made)
                                               : shade<SpecularMethod::representative_point>(point, sphere, made);
    });
    return result;
}

LightConstants light_at(Light kind, const Points& points) {
    LightConstants light;
    light.kind = kind;
    light.position[0] = 0.25F;
    light.position[1] = -0.5F;
    light.position[2] = 2.0F;
    light.radius = 0.3F;
    light.color[0] = 1.25F;
    light.color[1] = 0.95F;
    light.color[2] = 0.5F;
    light.intensity_cd = points.intensity_cd.data();
    light.inverse_range = 0.05F;
    // A single direction, which float follows closely; shade_area_test.cpp has all methods.
    light.specular_method = SpecularMethod::representative_point;
    return light;
}

Frostbite<float> frostbite_of(float smoothness) {
    return frostbite_material<float>({0.8F, 0.5F, 0.2F}, smoothness, 0.25F, 0.5F);
}

double alpha_of(float smoothness) {
    return static_cast<double>(lobe_alpha(frostbite_of(smoothness)));
}

MaterialConstants material_of(Material kind, float smoothness) {
    const Frostbite<float> frostbite = frostbite_of(smoothness);
    return kind == Material::lambert ? constants_of(Lambert<float>{frostbite.albedo}) : constants_of(frostbite);
}

Points ordinary_points(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec n = poses::random_direction(random);
        const double distance = std::exp(random.uniform(std::log(0.35), std::log(30.0)));
        const Vec p = Vec{0.25, -0.5, 2.0} + poses::random_direction(random) * distance;
        points.add(p, n, poses::random_direction(random), random.uniform(0.0, 2000.0));
    }
    return points;
}

class Kernel : public testing::TestWithParam<gonio::simd::InstructionSet> {
protected:
    const Kernels& kernels = gonio::shading::kernels(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Sets, Kernel,
                         testing::ValuesIn(gonio::simd::available_sets().begin(), gonio::simd::available_sets().end()),
                         [](const auto& each) { return std::string(gonio::simd::to_text(each.param)); });

TEST_P(Kernel, IsTheOneThatWasAskedFor) {
    EXPECT_EQ(kernels.set, GetParam());
    EXPECT_STREQ(kernels.name, gonio::simd::to_text(GetParam()));
}

TEST_P(Kernel, ShadesAsTheDoubleReference) {
    const Points points = ordinary_points(100'003, 31);
    for (const Light kind : {Light::punctual, Light::sphere}) {
        for (const float smoothness : {0.0F, 0.5F, 0.8F}) {
            for (const Material material_kind : {Material::lambert, Material::frostbite}) {
                const LightConstants light = light_at(kind, points);
                const MaterialConstants material = material_of(material_kind, smoothness);
                const Rgb rgb = run(kernels, points, light, material);
                double worst = 0.0;
                for (std::size_t i = 0; i < points.size(); ++i) {
                    const vec3<double> truth = reference(points, i, light, material);
                    const double channels[3] = {truth.x, truth.y, truth.z};
                    // Relative to a fully lit white surface at that distance: cosines near 0 lose digits relative to
                    // it.
                    const SurfacePoint<double> p = points.point<double>(i);
                    const vec3<double> to = vec3<double>{0.25, -0.5, 2.0} - p.position;
                    const double full = kind == Light::punctual
                                            ? static_cast<double>(points.intensity_cd[i]) / dot(to, to) * 1.25
                                            : 3.2 * 0.09 / dot(to, to);
                    // A smooth lobe magnifies the rounding of the half vector by 1/α; a grazing view magnifies that of
                    // n·v by 1/n·v.
                    const double relative =
                        material_kind == Material::lambert
                            ? 1e-5
                            : 1e-5 + 1e-6 / alpha_of(smoothness) + 5e-7 / std::fabs(dot(p.normal, p.view));
                    for (std::size_t k = 0; k < 3; ++k) {
                        const double error = std::fabs(static_cast<double>(rgb[k][i]) - channels[k]);
                        worst = std::max(worst, error / (relative * channels[k] + 1e-6 * full));
                    }
                }
                EXPECT_LE(worst, 1.0) << "light " << int(kind) << " material " << int(material_kind) << " smoothness "
                                      << smoothness;
            }
        }
    }
}

TEST_P(Kernel, IrradianceIsWhatALambertSurfaceReflects) {
    const Points points = ordinary_points(1000, 32);
    const MaterialConstants white = constants_of(Lambert<float>{{1.0F, 1.0F, 1.0F}});
    for (const Light kind : {Light::punctual, Light::sphere}) {
        const LightConstants light = light_at(kind, points);
        std::vector<float> lx(points.size());
        kernels.irradiance(points.surfaces(), light, lx.data());
        const Rgb rgb = run(kernels, points, light, white);
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(rgb[k][i], lx[i] * light.color[k] * std::numbers::inv_pi_v<float>, 1e-6F * rgb[k][i]) << i;
    }
}

TEST_P(Kernel, EveryCountGivesWhatAFullPacketGivesAndWritesNoMore) {
    const Points points = ordinary_points(48, 33);
    for (const Light kind : {Light::punctual, Light::sphere}) {
        for (const Material material_kind : {Material::lambert, Material::frostbite}) {
            const LightConstants light = light_at(kind, points);
            const MaterialConstants material = material_of(material_kind, 0.5F);
            const Rgb whole = run(kernels, points, light, material);
            std::vector<float> whole_lx(points.size());
            kernels.irradiance(points.surfaces(), light, whole_lx.data());
            for (std::size_t count = 0; count <= 33; ++count) {
                Surfaces surfaces = points.surfaces();
                surfaces.count = count;
                Rgb rgb;
                for (auto& channel : rgb)
                    channel.assign(points.size(), -7.0F);
                float* const out[3] = {rgb[0].data(), rgb[1].data(), rgb[2].data()};
                kernels.shade(surfaces, light, material, out);
                std::vector<float> lx(points.size(), -7.0F);
                kernels.irradiance(surfaces, light, lx.data());
                for (std::size_t i = 0; i < points.size(); ++i) {
                    for (std::size_t k = 0; k < 3; ++k)
                        ASSERT_EQ(rgb[k][i], i < count ? whole[k][i] : -7.0F) << count;
                    ASSERT_EQ(lx[i], i < count ? whole_lx[i] : -7.0F) << count;
                }
            }
        }
    }
}

TEST_P(Kernel, LambertNeedsNoView) {
    const Points points = ordinary_points(37, 34);
    Surfaces surfaces = points.surfaces();
    const LightConstants light = light_at(Light::sphere, points);
    const MaterialConstants material = material_of(Material::lambert, 0.0F);
    const Rgb with = run(kernels, points, light, material);
    for (auto& component : surfaces.view)
        component = nullptr;
    Rgb without = with;
    for (auto& channel : without)
        std::fill(channel.begin(), channel.end(), 0.0F);
    float* const out[3] = {without[0].data(), without[1].data(), without[2].data()};
    kernels.shade(surfaces, light, material, out);
    EXPECT_EQ(with, without);
}

TEST_P(Kernel, HostileInputGivesFiniteNumbersThatAreNotNegative) {
    Random random(35);
    Points points;
    constexpr std::size_t count = 31'250; // × 32 lights and materials: a million shaded points
    for (std::size_t i = 0; i < count; ++i) {
        const Vec n = i % 4 == 0 ? Vec{0.0, 0.0, 1.0} : poses::random_direction(random);
        Vec v = poses::random_direction(random);
        if (i % 5 == 0) v = n * -1.0;
        if (i % 5 == 1) v = n;
        points.add({poses::hostile(random), poses::hostile(random), poses::hostile(random)}, n, v,
                   std::fabs(poses::hostile(random)));
    }
    for (int round = 0; round < 32; ++round) {
        LightConstants light;
        light.kind = round % 2 == 0 ? Light::punctual : Light::sphere;
        const MaterialConstants material =
            material_of(round % 4 < 2 ? Material::lambert : Material::frostbite, static_cast<float>(round) / 31.0F);
        light.intensity_cd = points.intensity_cd.data();
        light.inverse_range = static_cast<float>(std::fabs(round % 3 == 0 ? poses::hostile(random) : 0.0));
        light.radius = static_cast<float>(std::fabs(poses::hostile(random)));
        for (float& component : light.position)
            component = static_cast<float>(poses::hostile(random));
        for (float& channel : light.color)
            channel = static_cast<float>(std::fabs(poses::hostile(random)));
        // Some points lie on the light itself, on its surface, or a little inside.
        if (round % 5 == 0) {
            for (std::size_t k = 0; k < 3; ++k)
                light.position[k] = points.position[k][17];
        }
        const Rgb rgb = run(kernels, points, light, material);
        std::vector<float> lx(count);
        kernels.irradiance(points.surfaces(), light, lx.data());
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_TRUE(std::isfinite(lx[i]) && lx[i] >= 0.0F) << round << ' ' << i << ' ' << lx[i];
            if (light.kind == Light::sphere) {
                ASSERT_LE(lx[i], std::numbers::pi_v<float>) << round << ' ' << i;
            }
            for (std::size_t k = 0; k < 3; ++k)
                ASSERT_TRUE(std::isfinite(rgb[k][i]) && rgb[k][i] >= 0.0F) << round << ' ' << i << ' ' << rgb[k][i];
        }
    }
}

TEST_P(Kernel, BehindTheSurfaceNothingIsSeen) {
    Points points;
    points.add({0, 0, 0}, {0, 0, 1}, {0, 0, -1}, 100.0); // the eye below the surface
    points.add({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 100.0);  // and in the surface's plane
    const LightConstants light = light_at(Light::punctual, points);
    for (const auto& channel : run(kernels, points, light, material_of(Material::frostbite, 0.5F)))
        EXPECT_EQ(channel, (std::vector<float>{0.0F, 0.0F}));
}

TEST(Shade, PunctualInverseSquareAndWindow) {
    const SurfacePoint<double> point{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
    PunctualLight<double> light{{0, 0, 4}, {1, 1, 1}, 800.0, 0.0};
    EXPECT_DOUBLE_EQ(illuminance(point, light), 50.0);
    light.inverse_range = 1.0 / 8.0;
    EXPECT_DOUBLE_EQ(illuminance(point, light), 50.0 * (15.0 / 16.0) * (15.0 / 16.0));
    light.inverse_range = 1.0 / 4.0;
    EXPECT_EQ(illuminance(point, light), 0.0);
    light.position = {0, 0, 0};
    EXPECT_EQ(illuminance(point, light), 0.0) << "no direction, no light";
    EXPECT_EQ(window_gltf(4.0, 1.0 / 8.0), 15.0 / 16.0);
    EXPECT_EQ(window_gltf(9.0, 1.0 / 8.0), 0.0);
    EXPECT_DOUBLE_EQ(range_of_threshold(800.0, 2.0), 20.0);
    // The loss by the squared window: 1.0887·I/r² at most, at 0.904 r.
    double worst = 0.0;
    double at = 0.0;
    for (int i = 1; i < 10'000; ++i) {
        const double d = i / 10'000.0;
        const double lost = (1.0 - window_squared(d, 1.0)) / (d * d);
        if (lost > worst) {
            worst = lost;
            at = d;
        }
    }
    EXPECT_NEAR(worst, 1.0887, 1e-4);
    EXPECT_NEAR(at, 0.904, 1e-3);
}

// Far away a sphere light looks the same as the point light with the same intensity π r² L, diffuse and specular.
TEST(Shade, ASmallSphereIsAPoint) {
    Random random(36);
    const Frostbite<double> material = frostbite_material<double>({0.8, 0.5, 0.2}, 0.5, 0.0, 0.5);
    for (int i = 0; i < 500; ++i) {
        const Vec n = poses::random_direction(random);
        const Vec l = poses::tilted(n, random.uniform(0.05, 1.0), random);
        const SurfacePoint<double> point{{0, 0, 0}, n, poses::tilted(n, random.uniform(0.05, 1.0), random)};
        const double r = 1e-6;
        const SphereLight<double> sphere{l * 2.0, {1e9, 1e9, 1e9}, r, 0.0};
        const PunctualLight<double> punctual{l * 2.0, {1, 1, 1}, std::numbers::pi * r * r * 1e9, 0.0};
        const double a = shade(point, sphere, material).x;
        const double b = shade(point, punctual, material).x;
        EXPECT_NEAR(a, b, 2e-5 * b) << i;
    }
}

} // namespace
