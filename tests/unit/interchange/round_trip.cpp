// Rig → target → lights of the written scene: the same to 1e-6, or the target has said what it wrote instead.
#include <gonio/asset/light_scene.hpp>
#include <gonio/light/light.hpp>

#include "../folders.hpp"
#include "scenes.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace gonio {

namespace {

struct Written {
    std::string_view name;
    std::string_view shape;
    std::string_view amount;
};

constexpr std::array lights{
    Written{"point", "point", "800lm"},
    Written{"spot", "spot:outer=40deg,inner=25deg", "1200cd"},
    Written{"spot_cos", "spot:outer=40deg,inner=25deg,falloff=smoothstep-cos", "1200cd"},
    Written{"spot_angle", "spot:outer=40deg,inner=25deg,falloff=smoothstep-angle", "1200cd"},
    Written{"spot_linear", "spot:outer=40deg,inner=25deg,falloff=linear-angle", "1200cd"},
    Written{"sphere", "sphere:r=10cm", "800lm"},
    Written{"disk", "disk:r=20cm", "3000nt"},
    Written{"ellipse", "ellipse:w=40cm,h=20cm", "3000nt"},
    Written{"rect", "rect:w=60cm,h=30cm", "2000lm"},
    Written{"tube", "tube:r=1.3cm,l=1.2m", "3000lm"},
    Written{"cylinder", "cylinder:r=10cm,l=30cm", "900lm"},
    Written{"sun", "sun:angle=0.53deg", "80000lx"},
    Written{"profile", "ies:street.ies", ""},
};

struct Way {
    std::string_view target;
    std::string_view ending;
    bool photometric = false;
};

std::vector<Light> written_lights() {
    std::vector<Light> resolved;
    Diagnostics diagnostics;
    double turn = 0.1;
    for (const Written& written : lights) {
        LightDescription light;
        light.name = written.name;
        light.shape = *parse_shape(written.shape);
        if (auto* const profile = std::get_if<ProfileShape>(&light.shape))
            profile->file = std::string(test::source_folder) + "/profiles/" + profile->file;
        if (!written.amount.empty()) light.intensity = *parse_photometric_value(written.amount);
        light.color = glm::dvec3(1.9351000704968926, 0.80355312121199354, 0.19179632432587745); // 2700 K
        light.position = {turn, 2.0 - turn, 3.0 + turn};
        light.direction = {0.3 * turn, -0.2, -1.0};
        light.up = {1.0, turn, 0.0};
        turn += 0.13;
        Result<Light> one = resolve_light(std::move(light), diagnostics);
        EXPECT_TRUE(one.has_value()) << written.name;
        if (one) resolved.push_back(std::move(*one));
    }
    return resolved;
}

Result<Light> resolved(const FoundLight& found) {
    LightDescription light;
    light.name = found.name;
    light.shape = *found.shape;
    light.intensity = found.intensity;
    light.color = found.color;
    light.position = found.position;
    light.direction = found.direction;
    light.up = found.up;
    Diagnostics diagnostics;
    return resolve_light(std::move(light), diagnostics);
}

class InterchangeRoundTrip : public testing::TestWithParam<Way> {};

TEST_P(InterchangeRoundTrip, KeepsLightsOrSaysWhatIsLost) {
    const Target* const target = *find_target(GetParam().target);
    const std::vector<Light> before = written_lights();
    LightSceneOptions options;
    options.name = "scene";
    options.photometric = GetParam().photometric;
    const Result<LightScene> written = light_scene(*target, before, options);
    ASSERT_TRUE(written.has_value());
    SceneReadOptions reading;
    reading.read_beside = [&](const std::string& name) -> Result<std::string> {
        for (const AssetFile& file : written->files)
            if (file.name == name || "./" + file.name == name) return file.bytes;
        return fail(Failure::io, "no such file");
    };
    const auto file = std::find_if(written->files.begin(), written->files.end(),
                                   [](const AssetFile& one) { return one.name.ends_with(GetParam().ending); });
    ASSERT_NE(file, written->files.end());
    FoundScene scene = test::scene_of(file->bytes, reading);
    EXPECT_EQ(scene.format, GetParam().target);
    load_scene_profiles(scene, reading);
    std::size_t exact = 0;
    for (const Light& light : before) {
        SCOPED_TRACE(light.name);
        const auto found = std::find_if(scene.lights.begin(), scene.lights.end(),
                                        [&](const FoundLight& one) { return one.name == light.name; });
        ASSERT_NE(found, scene.lights.end());
        const bool was_replaced =
            std::any_of(written->instead.begin(), written->instead.end(), [&](const std::string& said) {
                return said.find("'" + light.name + "'") != std::string::npos;
            });
        if (!found->is_converted()) { // a picture instead of a profile
            EXPECT_FALSE(found->remarks.empty());
            continue;
        }
        const Result<Light> after = resolved(*found);
        ASSERT_TRUE(after.has_value());
        const bool is_sun = std::holds_alternative<SunShape>(light.shape);
        if (!is_sun) {
            EXPECT_LT(glm::distance(after->frame.origin, light.frame.origin), 1e-6);
        }
        EXPECT_LT(glm::distance(after->color, light.color), 1e-6);
        if (was_replaced) continue;
        ++exact;
        EXPECT_EQ(std::string(kind_of(after->shape)), kind_of(light.shape));
        const bool has_direction =
            !std::holds_alternative<PointShape>(light.shape) && !std::holds_alternative<SphereShape>(light.shape);
        if (has_direction) {
            const bool is_round =
                std::holds_alternative<TubeShape>(light.shape) || std::holds_alternative<CylinderShape>(light.shape);
            if (!is_round) { // which may turn about its axis
                EXPECT_LT(glm::distance(after->frame.z, light.frame.z), 1e-6);
            }
            if (!is_sun && !std::holds_alternative<DiskShape>(light.shape)) {
                // A rectangle turned by half a turn is the same; so is an ellipse, and a tube.
                EXPECT_NEAR(std::abs(glm::dot(after->frame.x, light.frame.x)), 1.0, 1e-6);
            }
        }
        const auto near = [](double a, double b) { EXPECT_NEAR(a, b, 1e-6 * std::abs(b)); };
        near(after->intensity.value, light.intensity.value);
        near(after->luminance.value, light.luminance.value);
        near(after->illuminance.value, light.illuminance.value);
        const auto sizes_before = values_of(light.shape);
        const auto sizes_after = values_of(after->shape);
        ASSERT_EQ(sizes_before.size(), sizes_after.size());
        for (std::size_t i = 0; i < sizes_before.size(); ++i) {
            if (const auto* const length = std::get_if<Meters>(&sizes_before[i].value))
                near(std::get<Meters>(sizes_after[i].value).value, length->value);
            else if (const auto* const angle = std::get_if<Radians>(&sizes_before[i].value))
                near(std::get<Radians>(sizes_after[i].value).value, angle->value);
            else
                EXPECT_EQ(sizes_before[i].value.index(), sizes_after[i].value.index());
        }
        for (const glm::dvec3& toward :
             {glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.3, 0.2, -1.0), glm::dvec3(1.0, 0.5, -0.7)}) {
            const double there = light.intensity_towards(toward).value;
            EXPECT_NEAR(after->intensity_towards(toward).value, there, 1e-6 * light.intensity.value);
        }
    }
    EXPECT_GE(exact, 3U);
}

INSTANTIATE_TEST_SUITE_P(Targets, InterchangeRoundTrip,
                         testing::Values(Way{"gltf", ".gltf"}, Way{"gltf", ".glb"}, Way{"pbrt", ".pbrt"},
                                         Way{"mitsuba", ".xml"}, Way{"usd", ".usda"}, Way{"usd", ".usda", true},
                                         Way{"luxcore", ".scn"}),
                         [](const testing::TestParamInfo<Way>& way) {
                             return std::string(way.param.target) + "_" + std::string(way.param.ending.substr(1)) +
                                    (way.param.photometric ? "_photometric" : "");
                         });

} // namespace

} // namespace gonio
