#include <gonio/scene/camera.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/material_charts.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/stage.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace gonio {
namespace {

TEST(Camera, LooksAtItsTarget) {
    const Camera camera{{1, 2, 3}, {4, 5, 6}, {0, 0, 1}, 40.0};
    const CameraRays rays(camera, 640, 480);
    const glm::dvec3 expected = glm::normalize(camera.target - camera.position);
    const glm::dvec3 got = rays.ray(320, 240).direction;
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(got[i], expected[i], 1e-14);
    // The angle between the top and bottom edges is the field of view.
    const double angle = std::acos(glm::dot(rays.ray(320, 0).direction, rays.ray(320, 480).direction));
    EXPECT_NEAR(angle * 180.0 / std::numbers::pi, 40.0, 1e-10);
    EXPECT_GT(rays.ray(320, 0).direction.z, rays.ray(320, 480).direction.z);
}

TEST(Stage, FloorIsHitWhereItShould) {
    const Stage stage = make_stage("floor").value();
    EXPECT_FALSE(make_stage("flor"));
    const auto down = first_hit(stage, {{-1, 0, 3}, {0, 0, -1}});
    ASSERT_TRUE(down);
    EXPECT_EQ(stage.surfaces[down->surface].name, "floor");
    EXPECT_NEAR(down->distance, 3.0, 1e-15);
    EXPECT_FALSE(first_hit(stage, {{0, 0, 1}, glm::normalize(glm::dvec3(0, -1, 1))}));
    // Surface normals look back along the ray.
    for (double x = -1.5; x < 1.5; x += 0.1) {
        const auto hit =
            first_hit(stage, {stage.camera.position, glm::normalize(glm::dvec3(x, 0.0, 0.4) - stage.camera.position)});
        ASSERT_TRUE(hit);
        EXPECT_LT(glm::dot(hit->normal, hit->position - stage.camera.position), 0.0);
        EXPECT_NEAR(glm::length(hit->normal), 1.0, 1e-14);
    }
}

TEST(Occlusion, CapOverlapHasItsLimits) {
    const double quarter = std::numbers::pi / 2;
    EXPECT_EQ(cap_overlap(0.2, 0.3, 0.6), 0.0);
    EXPECT_NEAR(cap_overlap(0.2, 0.3, 0.05), 2.0 * std::numbers::pi * (1.0 - std::cos(0.2)), 1e-15);
    // Two hemispheres with axes d apart share a lune of angle π − d.
    EXPECT_NEAR(cap_overlap(quarter, quarter, 0.7), 2.0 * (std::numbers::pi - 0.7), 1e-14);
}

TEST(Occlusion, CapOverlapAgreesWithCounting) {
    struct Case {
        double a, b, d;
    };
    for (const Case c : {Case{0.5, 0.7, 0.6}, Case{1.2, 0.4, 1.3}, Case{0.9, 0.9, 0.3}, Case{0.02, 0.03, 0.04}}) {
        // Directions of the first cap, uniform in solid angle; counts how many are in the second.
        const int rings = 2000;
        const int around = 2000;
        long inside = 0;
        for (int i = 0; i < rings; ++i) {
            const double s2 = std::sin(0.5 * c.a) * std::sin(0.5 * c.a) * (i + 0.5) / rings; // sin²(θ/2)
            const double cos_theta = 1.0 - 2.0 * s2;
            const double sin_theta = 2.0 * std::sqrt(s2 * (1.0 - s2));
            for (int k = 0; k < around; ++k) {
                const double phi = 2.0 * std::numbers::pi * (k + 0.5) / around;
                inside +=
                    cos_theta * std::cos(c.d) + sin_theta * std::cos(phi) * std::sin(c.d) >= std::cos(c.b) ? 1 : 0;
            }
        }
        const double cap = 4.0 * std::numbers::pi * std::sin(0.5 * c.a) * std::sin(0.5 * c.a);
        const double counted = cap * static_cast<double>(inside) / (double(rings) * around);
        EXPECT_NEAR(cap_overlap(c.a, c.b, c.d), counted, 2e-3 * counted) << c.a << ' ' << c.b << ' ' << c.d;
    }
}

TEST(Occlusion, ABallCastsAShadow) {
    Stage stage;
    stage.surfaces.push_back({"floor", Plane{}, LambertMaterial{}});
    stage.surfaces.push_back({"ball", Ball{{0, 0, 1}, 0.25}, LambertMaterial{}});
    EXPECT_EQ(visible_share(stage, 0, {0, 0, 0}, {0, 0, 3}, 0.0), 0.0);
    EXPECT_EQ(visible_share(stage, 0, {2, 0, 0}, {0, 0, 3}, 0.0), 1.0);
    EXPECT_EQ(visible_share(stage, 0, {0, 0, 0}, {0, 0, 0.5}, 0.0), 1.0);  // the light is in front of the sphere
    EXPECT_EQ(visible_share(stage, 1, {0, 0, 1.25}, {0, 0, 3}, 0.0), 1.0); // no shadow on itself
    // Behind it is the centre of a light twice as wide as the sphere; the sphere covers its own solid angle.
    const double light = std::asin(1.0 / 3.0);
    const double ball = std::asin(0.25);
    const double share = std::pow(std::sin(0.5 * ball) / std::sin(0.5 * light), 2);
    EXPECT_NEAR(visible_share(stage, 0, {0, 0, 0}, {0, 0, 3}, 1.0), 1.0 - share, 1e-12);
}

template<class Kind>
Kind parsed(const char* text) {
    return std::get<Kind>(parse_material(text).value());
}

TEST(Material, GrammarAndItsErrors) {
    const auto frostbite = parsed<FrostbiteMaterial>("frostbite:base=rgb(0.1,0.2,0.3),metal=1");
    EXPECT_EQ(frostbite.base, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_EQ(frostbite.metal, 1.0);
    EXPECT_EQ(frostbite.smoothness, 0.6);
    EXPECT_EQ(parsed<LambertMaterial>("lambert").albedo, glm::dvec3(0.5));
    EXPECT_EQ(parsed<Ue4Material>("ue4:roughness=0.25,cavity=0.5").cavity, 0.5);
    EXPECT_EQ(parsed<Ue4Material>("ue4:roughness=0.25,cavity=0.5").specular, 0.5);
    EXPECT_EQ(parsed<GltfMaterial>("gltf:base=rgb(1,0.77,0.34),metallic=1").base, glm::dvec3(1.0, 0.77, 0.34));
    EXPECT_EQ(parsed<GltfMaterial>("gltf:roughness=0").roughness, 0.0);
    EXPECT_EQ(parsed<BlinnMaterial>("blinn:specular=rgb(1,0.77,0.34),wet=1").specular, glm::dvec3(1.0, 0.77, 0.34));
    EXPECT_EQ(parsed<BlinnMaterial>("blinn").specular, glm::dvec3(0.04));
    EXPECT_EQ(parsed<EonMaterial>("eon:roughness=1").roughness, 1.0);
    EXPECT_EQ(parsed<GgxMaterial>("ggx").alpha, 0.3);
    EXPECT_EQ(parsed<GgxMaterial>("ggx:roughness=0.5").alpha, 0.25);
    EXPECT_EQ(parsed<GgxMaterial>("ggx:anisotropy=0.7,rotation=-45").anisotropy, 0.7);
    EXPECT_EQ(parsed<GgxMaterial>("ggx:anisotropy=0.7,rotation=-45").rotation_deg, -45.0);
    EXPECT_NEAR(parsed<GltfMaterial>("gltf:rotation=0.5rad").rotation_deg, 28.6478897565412, 1e-12);
    EXPECT_EQ(parsed<KullaContyMaterial>("kulla-conty:f0=0.5,alpha=0").alpha, 0.0);
    for (const char* text : {"",
                             "lambert:albedo=2",
                             "lambert:base=1",
                             "lambert:albedo",
                             "lambert:albedo=x",
                             "frostbite:metal=-0.1",
                             "frostbite:smoothness=1.01",
                             "frostbyte",
                             "ggx:alpha=1.5",
                             "ggx:alpha=nan",
                             "ggx:alpha=0.1,roughness=0.1",
                             "ue4:metal=1",
                             "gltf:metal=1",
                             "gltf:specular=0.5",
                             "blinn:wet=-1",
                             "eon:albedo=rgb(1,2,0)",
                             "kulla-conty:albedo=1",
                             "ggx:f0=0.5,f0=0.5",
                             "ggx:anisotropy=1.1",
                             "gltf:rotation=400",
                             "ggx:rotation=3m",
                             "ue4:anisotropy=0.5"})
        EXPECT_FALSE(parse_material(text)) << text;
    EXPECT_EQ(parse_material("ggx:alpha=1.5").error().diagnostics.front().message,
              "alpha of 'ggx' must lie in [0, 1], not 1.5");
}

TEST(Material, EveryKindTakesACoat) {
    for (const MaterialKind& kind : material_kinds()) {
        const std::string name(kind.kind);
        const auto coated =
            parsed<CoatedMaterial>((name + ":coat=0.5,coat-smoothness=0.7,coat-order=filament").c_str());
        EXPECT_EQ(coated.coat, (Coat{0.5, 0.7, CoatOrder::filament})) << name;
        EXPECT_EQ(coated.base.index(), parse_material(name)->index()) << name;
        EXPECT_EQ(base_of(Material(coated)).index(), coated.base.index()) << name;
        EXPECT_EQ(parsed<CoatedMaterial>((std::string(kind.grammar) + ",coat=1").c_str()).coat, Coat()) << name;
        for (const char* keys : {":coat", ":coat=1.1", ":coat=x", ":coat-smoothness=0.5", ":coat-order=ue4",
                                 ":coat=1,coat-order=unreal", ":coat=1,coat-smoothness=-1", ":coat=1,coat=1"})
            EXPECT_FALSE(parse_material(name + keys)) << name << keys;
    }
    EXPECT_EQ(parse_material("lambert:coat-order=ue4").error().diagnostics.front().message,
              "coat-order of 'lambert' needs a coat");
}

// The grammar that `gonio list materials` prints is the one that is parsed, and its values are the defaults.
TEST(Material, IsTheSameWithTheSameNumbers) {
    const std::vector<const char*> texts{"lambert",
                                         "lambert:albedo=0.4",
                                         "ue4:base=rgb(0.5,0.4,0.3),roughness=0.3",
                                         "ue4:base=rgb(0.5,0.4,0.3),roughness=0.4",
                                         "gltf:base=rgb(0.5,0.4,0.3),roughness=0.3",
                                         "lambert:coat=1",
                                         "lambert:albedo=0.4,coat=1",
                                         "lambert:coat=0.5"};
    for (const char* const a : texts)
        for (const char* const b : texts)
            EXPECT_EQ(are_same(parse_material(a).value(), parse_material(b).value()), a == b) << a << ' ' << b;
}

TEST(Material, GrammarIsThatOfTheList) {
    for (const MaterialKind& kind : material_kinds()) {
        const auto written = parse_material(kind.grammar);
        const auto bare = parse_material(kind.kind);
        ASSERT_TRUE(written && bare) << kind.kind;
        EXPECT_EQ(written->index(), bare->index());
        const shading::vec3<double> n{0.0, 0.0, 1.0};
        const shading::vec3<double> v{0.6, 0.0, 0.8};
        const auto value = [&](const Material& material) {
            return std::visit([&](const auto& m) { return shading::brdf(core_material(m), n, n, v).y; }, material);
        };
        EXPECT_GT(value(*bare), 0.0) << kind.kind;
        EXPECT_EQ(value(*written), value(*bare)) << kind.kind;
        // The text that completion leaves.
        const auto begun = parse_material(std::string(kind.kind) + ":");
        ASSERT_TRUE(begun) << kind.kind;
        EXPECT_EQ(value(*begun), value(*bare)) << kind.kind;
        EXPECT_TRUE(check_charts(*bare).empty()) << kind.kind;
    }
}

TEST(Material, ChartsJudgeWhatIsNoRealSurface) {
    const auto warnings = [](const char* text) { return check_charts(parse_material(text).value()).size(); };
    EXPECT_EQ(warnings("lambert:albedo=0.0144"), 0U); // 32 of sRGB
    EXPECT_EQ(warnings("lambert:albedo=0.0137"), 1U); // 31
    EXPECT_EQ(warnings("eon:albedo=0.896"), 0U);      // 243
    EXPECT_EQ(warnings("eon:albedo=0.906"), 1U);      // 244
    EXPECT_EQ(warnings("frostbite:base=1,reflectance=1"), 2U);
    EXPECT_EQ(warnings("frostbite:base=rgb(1,0.77,0.34),metal=1"), 0U); // gold
    EXPECT_EQ(warnings("frostbite:base=0.2,metal=1"), 1U);
    EXPECT_EQ(warnings("frostbite:base=0,metal=0.5"), 0U);
    EXPECT_EQ(warnings("ue4:specular=1"), 1U);
    EXPECT_EQ(warnings("gltf:base=0.2,metallic=1"), 1U);
    EXPECT_EQ(warnings("gltf:base=0.2,metallic=0.5"), 0U);
    EXPECT_EQ(warnings("gltf:base=1"), 1U);
    EXPECT_EQ(warnings("blinn:albedo=0,specular=0.9"), 0U); // a metal has no diffuse part
    EXPECT_EQ(warnings("blinn:albedo=0,specular=0.04"), 1U);
    EXPECT_EQ(warnings("blinn:specular=0.2"), 1U); // neither
    EXPECT_EQ(warnings("ggx:f0=0.2"), 1U);
    const Diagnostics said = check_charts(parse_material("lambert:albedo=1").value());
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].severity, Severity::warning);
    EXPECT_EQ(said[0].message, "albedo of 'lambert' is 255 in sRGB, but dielectrics lie within 32 to 243");
}

} // namespace
} // namespace gonio
