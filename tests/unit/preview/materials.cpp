// Every material of the grammar, from the grammar to the kernels of every instruction set.
#include <gonio/scene/core_material.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/shade.hpp>
#include <gonio/transport/shading_constants.hpp>

#include "../shading/poses.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace gonio;
using measure::Random;
using poses::Vec;
using shading::LightConstants;
using LightKind = LightConstants::Kind;

constexpr std::array materials{"lambert:albedo=rgb(0.8,0.5,0.2)",
                               "eon:albedo=rgb(0.8,0.5,0.2),roughness=0.8",
                               "frostbite:base=rgb(0.8,0.5,0.2),smoothness=0.4",
                               "ue4:base=rgb(0.8,0.5,0.2),roughness=0.6,metallic=0.3,cavity=0.8",
                               "gltf:base=rgb(0.8,0.5,0.2),roughness=0.6,metallic=0.3",
                               "blinn:albedo=rgb(0.8,0.5,0.2),smoothness=0.3,wet=0.5",
                               "ggx:f0=rgb(0.9,0.5,0.1),alpha=0.3",
                               "ggx:f0=rgb(0.9,0.5,0.1),alpha=0.3,anisotropy=0.7,rotation=30",
                               "gltf:base=rgb(0.8,0.5,0.2),roughness=0.5,anisotropy=0.6",
                               "kulla-conty:f0=rgb(0.9,0.5,0.1),alpha=0.5"};
constexpr std::array kinds{LightKind::punctual,  LightKind::sphere, LightKind::disk,    LightKind::ellipse,
                           LightKind::rectangle, LightKind::tube,   LightKind::cylinder};

// Surface points and the parts of them that the kernels read.
struct Points {
    std::array<std::vector<float>, 9> columns;
    std::vector<float> intensity_cd;

    void add(const float (&values)[9], float cd) {
        for (std::size_t k = 0; k < 9; ++k)
            columns[k].push_back(values[k]);
        intensity_cd.push_back(cd);
    }
    [[nodiscard]] shading::Surfaces surfaces() const {
        shading::Surfaces all;
        for (std::size_t k = 0; k < 3; ++k) {
            all.position[k] = columns[k].data();
            all.normal[k] = columns[3 + k].data();
            all.view[k] = columns[6 + k].data();
        }
        all.count = intensity_cd.size();
        return all;
    }
    [[nodiscard]] Vec at(std::size_t first, std::size_t i) const {
        return {columns[first][i], columns[first + 1][i], columns[first + 2][i]};
    }
};

LightConstants light_of(LightKind kind, const Points& points) {
    LightConstants light;
    light.kind = kind;
    light.radius = 0.1F;
    light.width = 0.3F;
    light.height = 0.2F;
    light.length = 0.4F;
    light.position[2] = 1.0F;
    light.intensity_cd = points.intensity_cd.data();
    // A single direction, which float follows closely; shade_area_test.cpp has all methods.
    light.specular_method = shading::SpecularMethod::representative_point;
    return light;
}

template<class Light, class CoreMaterial>
Vec shaded(const LightConstants& constants, const Points& points, std::size_t i, const CoreMaterial& material) {
    Light light;
    shading::detail::constants(constants, light);
    if constexpr (std::is_same_v<Light, shading::PunctualLight<double>>) light.intensity_cd = points.intensity_cd[i];
    return shading::shade<shading::SpecularMethod::representative_point>(
        shading::SurfacePoint<double>{points.at(0, i), points.at(3, i), points.at(6, i)}, light, material);
}

Vec truth_of(const LightConstants& light, const Points& points, std::size_t i, const Material& material) {
    return std::visit(
        [&](const auto& m) {
            const auto core = core_material(m);
            switch (light.kind) {
            case LightKind::sphere:
                return shaded<shading::SphereLight<double>>(light, points, i, core);
            case LightKind::disk:
                return shaded<shading::DiskLight<double>>(light, points, i, core);
            case LightKind::ellipse:
                return shaded<shading::EllipseLight<double>>(light, points, i, core);
            case LightKind::rectangle:
                return shaded<shading::RectangleLight<double>>(light, points, i, core);
            case LightKind::tube:
                return shaded<shading::TubeLight<double>>(light, points, i, core);
            case LightKind::cylinder:
                return shaded<shading::CylinderLight<double>>(light, points, i, core);
            default:
                return shaded<shading::PunctualLight<double>>(light, points, i, core);
            }
        },
        base_of(material));
}

class MaterialKernels : public testing::TestWithParam<simd::InstructionSet> {
protected:
    std::array<std::vector<float>, 3> run(const Points& points, const LightConstants& light, const Material& material) {
        std::array<std::vector<float>, 3> rgb;
        for (auto& channel : rgb)
            channel.assign(points.intensity_cd.size(), -1.0F);
        float* const out[3] = {rgb[0].data(), rgb[1].data(), rgb[2].data()};
        shading::kernels(GetParam()).shade(points.surfaces(), light, material_constants(material), out);
        return rgb;
    }
};
INSTANTIATE_TEST_SUITE_P(Sets, MaterialKernels,
                         testing::ValuesIn(simd::available_sets().begin(), simd::available_sets().end()),
                         [](const auto& set) { return std::string(simd::to_text(set.param)); });

TEST_P(MaterialKernels, ShadeAsTheDoubleReference) {
    Random random(71);
    Points points;
    for (int i = 0; i < 2'003; ++i) {
        const Vec p = Vec{0.0, 0.0, 1.0} + poses::random_direction(random) * random.uniform(0.6, 4.0);
        const Vec to_light = poses::unit(Vec{0.0, 0.0, 1.0} - p);
        const Vec n = poses::tilted(to_light, random.uniform(0.35, 1.0), random);
        const Vec v = poses::tilted(n, random.uniform(0.2, 1.0), random);
        const double values[9] = {p.x, p.y, p.z, n.x, n.y, n.z, v.x, v.y, v.z};
        float rounded[9];
        std::transform(std::begin(values), std::end(values), std::begin(rounded),
                       [](double x) { return static_cast<float>(x); });
        points.add(rounded, static_cast<float>(random.uniform(1.0, 2000.0)));
    }
    for (const char* text : materials) {
        const Material material = parse_material(text).value();
        for (const LightKind kind : kinds) {
            const LightConstants light = light_of(kind, points);
            const auto rgb = run(points, light, material);
            // The representative point of a plane light jumps where the mirrored ray runs parallel to the plane.
            std::size_t off = 0;
            double sum = 0.0;
            for (std::size_t i = 0; i < points.intensity_cd.size(); ++i) {
                const Vec truth = truth_of(light, points, i, material);
                const double channels[3] = {truth.x, truth.y, truth.z};
                sum += truth.x;
                for (std::size_t k = 0; k < 3; ++k)
                    if (std::fabs(static_cast<double>(rgb[k][i]) - channels[k]) > 1e-4 * channels[k] + 1e-6) ++off;
            }
            EXPECT_GT(sum, 0.0) << text;
            EXPECT_LE(off, points.intensity_cd.size() / 200) << text << " under light " << int(kind);
        }
    }
}

// Below a coat; shade_area_test.cpp has the lights with a size.
TEST_P(MaterialKernels, CoatsUnderAPointAsTheDoubleReference) {
    Random random(72);
    Points points;
    for (int i = 0; i < 501; ++i) {
        const Vec n = poses::random_direction(random);
        const Vec to_light = poses::tilted(n, random.uniform(0.1, 1.0), random);
        const Vec v = poses::tilted(n, random.uniform(0.2, 1.0), random);
        const Vec p = Vec{0.0, 0.0, 1.0} - to_light * 2.0;
        const double values[9] = {p.x, p.y, p.z, n.x, n.y, n.z, v.x, v.y, v.z};
        float rounded[9];
        std::transform(std::begin(values), std::end(values), std::begin(rounded),
                       [](double x) { return static_cast<float>(x); });
        points.add(rounded, 400.0F);
    }
    for (const char* text : materials)
        for (const CoatOrderName& order : coat_orders()) {
            const Material material =
                parse_material(fmt::format("{},coat=0.8,coat-smoothness=0.4,coat-order={}", text, order.name)).value();
            const shading::Coated core = core_material(std::get<CoatedMaterial>(material));
            const auto rgb = run(points, light_of(LightKind::punctual, points), material);
            for (std::size_t i = 0; i < points.intensity_cd.size(); ++i) {
                const Vec way = Vec{0.0, 0.0, 1.0} - points.at(0, i);
                const Vec l = poses::unit(way);
                const double lx = 400.0 * dot(points.at(3, i), l) / dot(way, way);
                const Vec truth = shading::brdf(core, points.at(3, i), l, points.at(6, i)) * lx;
                EXPECT_NEAR(rgb[0][i], truth.x, 2e-4 * truth.x + 1e-5) << text << ' ' << order.name;
                EXPECT_NEAR(rgb[2][i], truth.z, 2e-4 * truth.z + 1e-5) << text << ' ' << order.name;
            }
        }
}

TEST_P(MaterialKernels, HostileInputGivesFiniteNumbersThatAreNotNegative) {
    Random random(73);
    Points points;
    for (int i = 0; i < 1'001; ++i) {
        float values[9];
        for (float& value : values)
            value = static_cast<float>(poses::hostile(random));
        points.add(values, static_cast<float>(std::fabs(poses::hostile(random))));
    }
    for (const char* text :
         {"lambert", "eon:roughness=1", "frostbite:smoothness=1", "ue4:roughness=0", "gltf:roughness=0",
          "blinn:smoothness=1", "blinn:smoothness=0,wet=1", "ggx:alpha=0", "kulla-conty:alpha=0", "kulla-conty:alpha=1",
          "lambert:coat=1,coat-smoothness=1", "ggx:alpha=0,coat=1,coat-smoothness=0", "blinn:coat=1,coat-order=ue4"})
        for (const LightKind kind : kinds) {
            LightConstants light = light_of(kind, points);
            light.specular_method = shading::standard_specular_method;
            const auto rgb = run(points, light, parse_material(text).value());
            for (const auto& channel : rgb)
                for (std::size_t i = 0; i < channel.size(); ++i)
                    ASSERT_TRUE(channel[i] >= 0.0F && channel[i] <= std::numeric_limits<float>::max())
                        << text << " under light " << int(kind) << ", point " << i << ": " << channel[i];
        }
}

} // namespace
