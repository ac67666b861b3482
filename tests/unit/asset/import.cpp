// The output of import: the requested light, and files that describe it.
#include <gonio/asset/light_scene.hpp>
#include <gonio/asset/measured_light.hpp>
#include <gonio/asset/scene_content.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/base/file.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/light/closed_forms.hpp>
#include <gonio/light/light.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/light/policy.hpp>
#include <gonio/light/program_fields.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/resolve.hpp>

#include "../folders.hpp"
#include "json_schema.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

namespace gonio {
namespace {

using nlohmann::json;
using std::numbers::pi;

MeasuredLight delivered(const std::string& name, const MeasuredLightOptions& options = {}) {
    const std::string path = std::string(test::source_folder) + "/profiles/" + name;
    const Profile profile = *read_profile_file(path);
    const ResolvedWeb resolved = *resolve_web(profile);
    Diagnostics ignored;
    return *measured_light({path, "", resolved.web, header_of(profile)}, options, ignored);
}

std::vector<AssetFile> files_of(const char* target, const MeasuredLight& light) {
    return light_scene(**find_target(target), light)->files;
}

TEST(MeasuredLight, IsScaledAndTurned) {
    const MeasuredLight measured = delivered("street.ies");
    MeasuredLightOptions options;
    options.flux = Lumens(800);
    options.rotation = degrees(90);
    const MeasuredLight turned = delivered("street.ies", options);
    EXPECT_NEAR(turned.flux.value, 800.0, 1e-6 * 800.0); // the values have nine digits
    const double factor = turned.flux.value / measured.flux.value;
    for (const double c : {0.0, 12.0, 93.0, 181.0, 340.0})
        for (const double gamma : {0.0, 33.0, 61.0, 80.0})
            EXPECT_NEAR(turned.web.candela(c + 90.0, gamma), factor * measured.web.candela(c, gamma),
                        1e-6 * turned.peak.value);
    EXPECT_LT(turned.max_error.value, 1e-6 * turned.peak.value);
    EXPECT_EQ(turned.name, "street");
}

TEST(MeasuredLight, TakesTheColourOfTheProfile) {
    for (const auto& [text, kelvin] : {std::pair{"3000", 3000.0},
                                       {"3000 K", 3000.0},
                                       {" 4000K warm", 4000.0},
                                       {"830", 3000.0},
                                       {"865", 6500.0},
                                       {"2700/3000", 2700.0}})
        EXPECT_EQ(color_temperature_of(text), kelvin) << text;
    for (const char* text : {"", "warm", "300", "80", "805", "3000x", "1e9", "-3000", "nan"})
        EXPECT_FALSE(color_temperature_of(text)) << text;
    MeasuredLightOptions options;
    options.color = "2700K";
    EXPECT_NEAR(glm::dot(delivered("street.ies", options).color, rec709_luminance), 1.0, 1e-12);
}

TEST(MeasuredLight, NamesSuitFilesAndNodes) {
    EXPECT_EQ(asset_name("a/b.c/My lamp (2).ies"), "My_lamp__2_");
    EXPECT_EQ(asset_name("-"), "light");
    EXPECT_EQ(asset_name("x/.ies"), "_ies");
    EXPECT_EQ(asset_name("4\xc3\xa9.ldt"), "4__");
}

// Checks EXT_lights_ies against the schema beside this file, and that its indices point to something.
std::string schema_complaint(const char* part, const json& value) {
    json schema =
        json::parse(*read_file(std::string(test::source_folder) + "/tests/unit/asset/ext_lights_ies.schema.json"));
    schema["$ref"] = std::string("#/$defs/") + part;
    return test::JsonSchema(std::move(schema)).complaint(value);
}

void check_indices(const json& document) {
    EXPECT_EQ(schema_complaint("document", document["extensions"]["EXT_lights_ies"]), "");
    const std::size_t profiles = document["extensions"]["EXT_lights_ies"]["lights"].size();
    const std::size_t lights = document["extensions"]["KHR_lights_punctual"]["lights"].size();
    for (const json& profile : document["extensions"]["EXT_lights_ies"]["lights"])
        if (profile.contains("bufferView")) {
            const json& view = document["bufferViews"].at(profile["bufferView"].get<std::size_t>());
            EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
                      document["buffers"].at(view["buffer"].get<std::size_t>())["byteLength"].get<std::size_t>());
        }
    for (const json& index : document["scenes"][0]["nodes"]) {
        const json& node = document["nodes"].at(index.get<std::size_t>());
        EXPECT_LT(node["extensions"]["KHR_lights_punctual"]["light"].get<std::size_t>(), lights);
        if (!node["extensions"].contains("EXT_lights_ies")) continue;
        EXPECT_EQ(schema_complaint("node", node["extensions"]["EXT_lights_ies"]), "");
        EXPECT_LT(node["extensions"]["EXT_lights_ies"]["light"].get<std::size_t>(), profiles);
    }
}

TEST(Gltf, SchemaFindsFaults) {
    for (const char* bad :
         {R"({"light": -1})", R"({"light": 0.5})", R"({"multiplier": 1})", R"({"light": 0, "color": [1, 1]})",
          R"({"light": 0, "color": [1, 1, 1.5]})", R"({"light": 0, "colour": [1, 1, 1]})"})
        EXPECT_NE(schema_complaint("node", json::parse(bad)), "") << bad;
    for (const char* bad :
         {R"({})", R"({"lights": []})", R"({"lights": [{}]})", R"({"lights": [{"bufferView": 0}]})",
          R"({"lights": [{"uri": "a.ies", "bufferView": 0, "mimeType": "application/x-ies-lm-63"}]})"})
        EXPECT_NE(schema_complaint("document", json::parse(bad)), "") << bad;
}

void check_gltf(const json& document, const MeasuredLight& light, bool embedded) {
    check_indices(document);
    const json& profiles = document["extensions"]["EXT_lights_ies"]["lights"];
    ASSERT_EQ(profiles.size(), 1U);
    if (embedded) {
        const json& view = document["bufferViews"][profiles[0]["bufferView"].get<std::size_t>()];
        EXPECT_EQ(view["byteLength"], light.portable_ies.size());
    } else {
        EXPECT_EQ(profiles[0]["uri"], light.name + ".ies");
    }
    const json& node = document["nodes"][document["scenes"][0]["nodes"][0].get<std::size_t>()];
    const json& use = node["extensions"]["EXT_lights_ies"];
    EXPECT_EQ(use["light"], 0);
    double luminance = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double channel = use["color"][static_cast<std::size_t>(k)].get<double>();
        EXPECT_GE(channel, 0.0);
        EXPECT_LE(channel, 1.0);
        luminance += channel * rec709_luminance[k];
    }
    // The candela of the file times multiplier and colour give the file's luminous intensity.
    EXPECT_NEAR(luminance * use["multiplier"].get<double>(), 1.0, 1e-12);
    // The rotation turns the light's −Z, γ = 0, downwards.
    const auto q = node["rotation"].get<std::vector<double>>();
    EXPECT_NEAR(-2.0 * (q[1] * q[2] - q[0] * q[3]), -1.0, 1e-15);
    const json& fallback = document["extensions"]["KHR_lights_punctual"]["lights"][0];
    double lumens = 4.0 * pi * fallback["intensity"].get<double>();
    if (fallback["type"] == "spot") {
        const double inner = fallback["spot"]["innerConeAngle"].get<double>();
        const double outer = fallback["spot"]["outerConeAngle"].get<double>();
        EXPECT_LT(inner, outer);
        EXPECT_LE(outer, 0.5 * pi);
        lumens = fallback["intensity"].get<double>() * closed_form::spot_solid_angle(Falloff::frostbite, inner, outer);
    }
    EXPECT_NEAR(lumens * luminance, light.flux.value, 1e-9 * light.flux.value);
}

TEST(Gltf, HoldsTheProfileAndAFallbackOfItsFlux) {
    for (const char* name : {"street.ies", "pendant.ies", "accent.ies", "flood.ldt", "bare-tube.xml"}) {
        MeasuredLightOptions options;
        options.color = "2700K";
        const MeasuredLight light = delivered(name, options);
        const auto files = files_of("gltf", light);
        ASSERT_EQ(files.size(), 3U);
        check_gltf(json::parse(files[0].bytes), light, false);
        EXPECT_EQ(files[1].bytes, light.portable_ies);
        const std::string& glb = files[2].bytes;
        const auto u32 = [&](std::size_t at) {
            std::size_t value = 0;
            for (std::size_t k = 4; k-- > 0;)
                value = value << 8 | static_cast<unsigned char>(glb[at + k]);
            return value;
        };
        EXPECT_EQ(glb.substr(0, 4), "glTF");
        EXPECT_EQ(u32(8), glb.size());
        const std::size_t json_length = u32(12);
        EXPECT_EQ(json_length % 4, 0U);
        check_gltf(json::parse(glb.substr(20, json_length)), light, true);
        EXPECT_EQ(glb.substr(20 + json_length + 4, 4), std::string("BIN\0", 4));
        EXPECT_EQ(glb.substr(20 + json_length + 8, light.portable_ies.size()), light.portable_ies);
    }
}

TEST(Targets, ShineUpWhereTheProfileDoes) {
    const auto type = [](const char* name) {
        const auto document = json::parse(files_of("gltf", delivered(name))[0].bytes);
        return document["extensions"]["KHR_lights_punctual"]["lights"][0]["type"].get<std::string>();
    };
    EXPECT_EQ(type("street.ies"), "spot");
    EXPECT_EQ(type("pendant.ies"), "point");
}

// Every target writes files with plain names, and its own text is pure ASCII.
TEST(Targets, WriteWhatEverySystemTakes) {
    const MeasuredLight light = delivered("street.ies");
    for (const Target& target : targets()) {
        const auto files = light_scene(target, light)->files;
        EXPECT_FALSE(files.empty()) << target.name;
        for (const AssetFile& file : files) {
            EXPECT_TRUE(file.name.starts_with("street.")) << file.name;
            EXPECT_NE(file.bytes.empty(), !file.picture) << file.name;
            if (file.name.ends_with(".glb")) continue;
            EXPECT_TRUE(std::all_of(file.bytes.begin(), file.bytes.end(), [](char c) {
                return (c >= 0x20 && c < 0x7f) || c == '\n' || c == '\r';
            })) << file.name;
        }
    }
    EXPECT_FALSE(find_target("gtlf"));
}

// A spectrum takes precedence over a colour temperature, and the user's value over both.
TEST(MeasuredLight, TakesTheColourOfASpectrum) {
    const std::string path = std::string(test::source_folder) + "/profiles/street.ies";
    const Profile profile = *read_profile_file(path);
    const ResolvedWeb resolved = *resolve_web(profile);
    ProfileHeader header = header_of(profile);
    set_keyword(header, "_CCT", "6500");
    const std::vector<Spectrum> one{*blackbody_spectrum(Kelvin(2700.0))};
    const std::vector<Spectrum> two{one[0], *find_illuminant("D65")};
    Diagnostics said;
    const MeasuredLight light = *measured_light({path, "", resolved.web, header, one}, {}, said);
    EXPECT_EQ(light.color_text, "spectrum");
    // As for the black body itself: color/ sums both at 1 nm.
    EXPECT_LT(glm::length(light.color - *parse_light_color("2700K")), 1e-6);
    EXPECT_TRUE(std::none_of(said.begin(), said.end(),
                             [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::warning; }));
    EXPECT_EQ(measured_light({path, "", resolved.web, header, two}, {}, said)->color, light.color);
    EXPECT_TRUE(said.back().message.find("has 2 spectra") != std::string::npos);
    MeasuredLightOptions options;
    options.color = "d65";
    EXPECT_EQ(measured_light({path, "", resolved.web, header, one}, options, said)->color, glm::dvec3(1.0));
}

// One light of every kind, in unusual places.
std::vector<Light> studio() {
    const std::string street = "ies:" + std::string(test::source_folder) + "/profiles/street.ies";
    std::vector<Light> lights;
    const auto add = [&](const char* name, const std::string& shape, const char* intensity) {
        LightDescription light;
        light.name = name;
        light.shape = *parse_shape(shape);
        if (*intensity != '\0') light.intensity = *parse_photometric_value(intensity);
        light.position = {0.1 * static_cast<double>(lights.size()), -0.4, 2.0};
        light.direction = {0.3, 0.2, -1.0};
        light.range = Meters(8.0);
        Diagnostics ignored;
        lights.push_back(*resolve_light(std::move(light), ignored));
    };
    add("point", "point", "40cd");
    add("key light", "sphere:r=10cm", "800lm");
    add("disk", "disk:r=20cm,two-sided", "900lm");
    add("panel", "rect:w=60cm,h=30cm", "2000lm");
    add("tube", "tube:r=2cm,l=1.2m", "1500lm");
    add("cylinder", "cylinder:r=10cm,l=30cm", "900lm");
    add("sun", "sun:angle=0.53deg", "500lx");
    add("door", "frustum:h=50deg,v=30deg", "600lm");
    add("ellipse", "ellipse:w=40cm,h=10cm", "700lm");
    add("street", street, "");
    lights.push_back(lights.back()); // the same profile, and the same name
    add("masked", "rect:w=60cm,h=30cm,mask=" + street.substr(4), "700lm");
    add("hard", "spot:outer=20deg,falloff=hard", "300lm");
    add("default", "spot:outer=40deg,inner=25deg", "300lm");
    add("soft", "spot:outer=40deg,inner=25deg,falloff=smoothstep-cos", "300lm");
    add("angle", "spot:outer=40deg,inner=25deg,falloff=smoothstep-angle", "300lm");
    add("linear", "spot:outer=40deg,inner=25deg,falloff=linear-angle", "300lm");
    add("ray", "spot:outer=0deg", "300cd");
    return lights;
}

// Every light is in the target's text under its own name, or a diagnostic reports its replacement.
TEST(LightScene, SaysWhatATargetCannotHold) {
    const std::vector<Light> lights = studio();
    for (const Target& target : targets()) {
        // Pictures take time to bake: import.scenes checks these targets.
        if (target.name == "pbrt" || target.name == "unity" || target.name == "godot" || target.name == "mitsuba")
            continue;
        const LightScene scene = *light_scene(target, lights, {"studio", "16 lights", Meters(1.0)});
        std::string said;
        for (const std::string& line : scene.instead)
            said += line + "\n";
        std::string text;
        for (const AssetFile& file : scene.files) {
            EXPECT_TRUE(file.name.starts_with("studio.")) << file.name;
            EXPECT_NE(file.bytes.empty(), !file.picture) << file.name;
            if (!file.name.ends_with(".ies") && !file.name.ends_with(".glb")) text += file.bytes;
        }
        EXPECT_NE(said.find("light 'ray': is dark and is left out"), std::string::npos) << target.name;
        EXPECT_NE(said.find("light 'door':"), std::string::npos) << target.name;
        EXPECT_EQ(said.find("light 'masked': a mask on an area light") == std::string::npos, target.holds.near_profiles)
            << target.name;
        EXPECT_EQ(said.find("light 'sun'") == std::string::npos, target.name != "raw") << target.name << said;
        EXPECT_EQ(said.find("range of 8 m") == std::string::npos, target.holds.range) << target.name;
        for (const char* name : {"point", "key_light", "disk", "panel", "tube", "door", "street", "street_2", "masked",
                                 "hard", "default", "soft", "angle", "linear"})
            EXPECT_NE(text.find(name), std::string::npos) << target.name << ' ' << name;
        // Spots with the target's own falloff remain spots; all other spots do not.
        const auto stays = [&](const char* name) {
            return said.find(std::string("light '") + name + "': " + std::string(target.name) +
                             " does not have spots") == std::string::npos;
        };
        if (target.name == "raw") continue;
        EXPECT_EQ(stays("default"), target.holds.spot_falloff == Falloff::frostbite) << target.name;
        EXPECT_EQ(stays("soft"), target.holds.spot_falloff == Falloff::smoothstep_cos) << target.name;
        EXPECT_EQ(stays("angle"), target.holds.spot_falloff == Falloff::smoothstep_angle) << target.name;
        EXPECT_EQ(stays("linear"), target.holds.spot_falloff == Falloff::linear_angle) << target.name;
    }
}

SceneContent seen_content;

std::vector<AssetFile> keep_content(const SceneContent& scene) {
    seen_content = scene;
    return {};
}

// What a target whose area lights take profiles gets of an opening: faces whose intensities add up to the light's, in
// its own unit.
TEST(LightScene, FacesAddUpToTheProfile) {
    Target target{"near", "", "", "", "", {}, keep_content};
    constexpr std::array kinds{LightKind::rect, LightKind::ellipse, LightKind::disk, LightKind::sphere};
    target.holds.kinds = kinds;
    target.holds.near_profiles = true;
    for (const char* const opening : {"rect:w=1.2m,h=0.3m", "box:w=0.5m,h=0.2m,d=0.15m", "sphere:r=0.1m"}) {
        LightDescription description;
        description.name = "lamp";
        description.shape =
            *parse_shape(fmt::format("ies:{}/profiles/wall-washer.ies,opening={}", test::source_folder, opening));
        description.intensity = PhotometricValue{3000.0, {find_unit("lm"), std::nullopt, std::nullopt}};
        description.position = {1.0, 2.0, 3.0};
        description.direction = {0.3, -0.2, -1.0};
        Diagnostics ignored;
        const std::vector<Light> lights{*resolve_light(description, ignored)};
        const LightScene scene = *light_scene(target, lights, {"near", "", Meters(0.01)});
        EXPECT_TRUE(scene.instead.empty()) << opening;
        ASSERT_EQ(seen_content.luminaires.size(), 1U) << opening;
        const SceneLuminaire& luminaire = seen_content.luminaires.front();
        EXPECT_EQ(seen_content.lights.size(), luminaire.facing.size()) << opening;
        const Web& web = seen_content.profiles.at(luminaire.profile).web;
        for (const glm::dvec3 towards :
             {glm::dvec3(0.1, 0.2, -1.0), glm::dvec3(-0.6, 0.3, -0.4), glm::dvec3(1, 0, -3)}) {
            const glm::dvec3 local = luminaire.frame.to_local(glm::normalize(towards));
            double facing = 0.0;
            for (const SceneLuminaire::Facing& face : luminaire.facing)
                facing +=
                    face.area * (face.normal == glm::dvec3(0.0) ? 1.0 : std::max(glm::dot(face.normal, local), 0.0));
            double area = 0.0; // of the lights that face there
            for (const SceneLight& face : seen_content.lights) {
                const double cosine = std::max(-glm::dot(face.frame.z, glm::normalize(towards)), 0.0);
                area +=
                    face.kind == LightKind::sphere ? pi * face.radius * face.radius : face.width * face.height * cosine;
            }
            const double luminance = luminaire.scale * web.candela(local) / facing;
            const double intensity = lights.front().intensity_towards(towards).value;
            EXPECT_NEAR(luminance * area, 1e4 * intensity, 1e-4 * 1e4 * intensity) << opening;
        }
    }
}

// Lights that differ only in position, direction and name share a profile: 600 of them took a minute to write.
TEST(LightScene, LikeLightsShareAProfile) {
    const std::vector<Light> all = studio();
    const Light& masked = *std::find_if(all.begin(), all.end(), [](const Light& l) { return l.name == "masked"; });
    std::vector<Light> lights(600, masked);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const double turn = 0.01 * static_cast<double>(i);
        lights[i].name = fmt::format("panel{}", i);
        lights[i].frame.origin.x = turn;
        lights[i].frame.x = {std::cos(turn), std::sin(turn), 0.0};
        lights[i].frame.z = {0.0, 0.0, 1.0};
        lights[i].frame.y = glm::cross(lights[i].frame.z, lights[i].frame.x);
    }
    const auto profiles = [&] {
        const LightScene scene = *light_scene(**find_target("raw"), lights, {"hall", "", Meters(1.0)});
        return std::count_if(scene.files.begin(), scene.files.end(),
                             [](const AssetFile& file) { return file.name.ends_with(".ies"); });
    };
    EXPECT_EQ(profiles(), 1);
    // Everything that the profile depends on makes lights differ.
    lights.resize(8, masked);
    lights[1].intensity = Candelas(2.0 * lights[1].intensity.value);
    lights[2].color = {0.5, 1.0, 2.0};
    lights[3].web_scale *= 2.0;
    std::get<RectShape>(lights[4].shape).width = Meters(0.7);
    std::get<RectShape>(lights[5].shape).two_sided = true;
    std::get<RectShape>(lights[6].shape).mask = std::make_shared<Web>(*std::get<RectShape>(masked.shape).mask);
    EXPECT_EQ(profiles(), 7);
}

// Far-field profiles have the flux and the intensity of the shape; lights with the same profile share it.
TEST(LightScene, FarProfilesAreThoseOfTheShapes) {
    const std::vector<Light> lights = studio();
    const LightScene scene = *light_scene(**find_target("raw"), lights, {"studio", "", Meters(1.0)});
    EXPECT_EQ(std::count_if(scene.files.begin(), scene.files.end(),
                            [](const AssetFile& file) { return file.name.find("street") != std::string::npos; }),
              1);
    const auto web_of = [&](const std::string& name) {
        for (const AssetFile& file : scene.files)
            if (file.name == "studio." + name + ".ies") return resolve_web(*read_profile(file.bytes, file.name))->web;
        ADD_FAILURE() << name;
        return *Web::create(Symmetry::axial, {0.0}, {0.0, 90.0}, {1.0, 1.0});
    };
    for (const auto& [name, lumens] : {std::pair{"key_light", 800.0},
                                       {"panel", 2000.0},
                                       {"disk", 900.0},
                                       {"tube", 1500.0},
                                       {"door", 600.0},
                                       {"hard", 300.0},
                                       {"default", 300.0},
                                       {"linear", 300.0}})
        // The edge of a hard spot is a ten-thousandth of its angle wide and is written with nine digits.
        EXPECT_NEAR(flux(web_of(name)).value, lumens, 1e-5 * lumens) << name;
    for (const std::size_t index : {1U, 2U, 3U, 4U, 9U, 11U}) {
        const Light& light = lights[index];
        std::string name = light.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        const Web web = web_of(name);
        const double most = light.intensity.value;
        for (const double c : {0.0, 33.0, 121.0, 260.0})
            for (const double gamma : {0.0, 14.0, 31.5, 62.0, 85.0, 130.0}) {
                const double truth =
                    light.intensity_towards(light.frame.to_world(direction_of({degrees(c), degrees(gamma)}))).value;
                // Linear interpolation between the table's angles: h²/8 of the second derivative, and the scaling to
                // the flux.
                EXPECT_NEAR(web.candela(c, gamma), truth, 2e-3 * most) << name << ' ' << c << ' ' << gamma;
            }
    }
}

// Engines without an area light of a shape take its size where they have a field for it.
TEST(LightScene, KeepsTheSizesThatEnginesTake) {
    std::vector<Light> lights = studio();
    std::erase_if(lights, [](const Light& light) { return light.name != "tube" && light.name != "key light"; });
    const auto written = [&](const char* target) {
        return *light_scene(**find_target(target), lights, {"pair", "", Meters(1.0)});
    };
    const auto text_of = [](const LightScene& scene, std::string_view ending) {
        for (const AssetFile& file : scene.files)
            if (file.name.ends_with(ending)) return file.bytes;
        return std::string();
    };
    EXPECT_NE(text_of(written("godot"), ".tscn").find("omni_attenuation = 2.0\nlight_size = 0.1\n"), std::string::npos);

    const LightScene unity = written("unity");
    const std::string made = text_of(unity, ".cs");
    EXPECT_NE(made.find("SetRadius(light, 0.1f);"), std::string::npos);
    EXPECT_NE(made.find("light.areaSize = new Vector2(1.2f, 0.04f);"), std::string::npos);
    EXPECT_EQ(unity.instead.size(), 1U); // the sphere
    // The same number as 'gonio units' names for the light's fields.
    const std::size_t tube = made.find("LightType.Tube");
    ASSERT_NE(tube, std::string::npos);
    const std::size_t unit = made.find("f, LightUnit.Lumen", tube);
    ASSERT_NE(unit, std::string::npos);
    const std::size_t number = made.rfind(' ', unit);
    const Light& light = lights[1];
    const Emission emission{light.intensity, light.luminance, light.illuminance};
    const ProgramLight fields = *program_light(**find_policy("unity-hdrp"), light.shape, emission);
    EXPECT_NEAR(std::stod(made.substr(number, unit - number)), std::stod(fields.fields[0].value), 0.01);

    const LightScene unreal = written("unreal");
    EXPECT_NE(text_of(unreal, ".py").find("source_radius=2, source_length=120, ies_texture"), std::string::npos);
    // The length lies along C90, where a tube hardly shines.
    const Web web = resolve_web(*read_profile(text_of(unreal, ".ies"), "tube.ies"))->web;
    EXPECT_LT(web.candela(90.0, 90.0), 0.03 * web.candela(0.0, 90.0));
    EXPECT_NEAR(flux(web).value, 1500.0, 0.02);
}

TEST(LightScene, OfGltfHasIndicesAndPlaces) {
    const std::vector<Light> lights = studio();
    const LightScene scene = *light_scene(**find_target("gltf"), lights, {"studio", "", Meters(1.0)});
    const json document = json::parse(scene.files[0].bytes);
    check_indices(document);
    for (const json& node : document["nodes"]) {
        const auto q = node["rotation"].get<std::vector<double>>();
        EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1.0, 1e-12);
        if (node["name"] == "disk_back") continue;
        // −Z of the node: Y up, from (0.3, 0.2, −1).
        const double length = std::sqrt(1.13);
        EXPECT_NEAR(-2.0 * (q[0] * q[2] + q[1] * q[3]), 0.3 / length, 1e-12);
        EXPECT_NEAR(-2.0 * (q[1] * q[2] - q[0] * q[3]), -1.0 / length, 1e-12);
        EXPECT_NEAR(-(1.0 - 2.0 * (q[0] * q[0] + q[1] * q[1])), -0.2 / length, 1e-12);
        if (node["name"] == "sun") continue;
        EXPECT_EQ(node["translation"][1], 2.0);
        EXPECT_EQ(node["translation"][2], 0.4);
    }
}

// Rectangles and disks have their luminance and size, and a light of the same flux beside them.
TEST(LightScene, OfGltfHasAreas) {
    const std::vector<Light> lights = studio();
    const LightScene scene = *light_scene(**find_target("gltf"), lights, {"studio", "", Meters(1.0)});
    const json document = json::parse(scene.files[0].bytes);
    const json& extensions = document["extensions"];
    std::size_t areas = 0;
    for (const json& node : document["nodes"]) {
        if (!node["extensions"].contains("EXT_lights_area")) continue;
        ++areas;
        const json& area =
            extensions["EXT_lights_area"]["lights"][node["extensions"]["EXT_lights_area"]["light"].get<std::size_t>()];
        const json& punctual = extensions["KHR_lights_punctual"]["lights"]
                                         [node["extensions"]["KHR_lights_punctual"]["light"].get<std::size_t>()];
        EXPECT_EQ(area["name"], node["name"]);
        const double size = area["size"];
        const double square_meters =
            area["type"] == "rect" ? size * size * area["rect"]["aspect"].get<double>() : 0.25 * pi * size * size;
        const double lumens = pi * square_meters * area["intensity"].get<double>();
        EXPECT_NEAR(lumens, node["name"] == "panel" ? 2000.0 : 450.0, 1e-9); // the disk's, of each of its sides
        const double solid_angle =
            closed_form::spot_solid_angle(Falloff::frostbite, punctual["spot"]["innerConeAngle"].get<double>(),
                                          punctual["spot"]["outerConeAngle"].get<double>());
        EXPECT_NEAR(punctual["intensity"].get<double>() * solid_angle, lumens, 1e-9);
    }
    EXPECT_EQ(areas, 3U); // the panel, and the disk with its back
}

// Filament takes lumens, of which a spot has π for a candela; it has no profiles.
TEST(LightScene, OfFilamentIsInLumens) {
    const std::vector<Light> lights = studio();
    const LightScene scene = *light_scene(**find_target("filament"), lights, {"studio", "", Meters(1.0)});
    const std::string text = scene.files[0].bytes;
    EXPECT_NE(text.find(fmt::format("[\"point\", light(Filament, 'POINT', [1, 1, 1], {}", 4.0 * pi * 40.0)),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("[\"sun\", light(Filament, 'SUN', [1, 1, 1], 500, "), std::string::npos) << text;
    const auto named = std::find_if(lights.begin(), lights.end(), [](const Light& of) { return of.name == "default"; });
    ASSERT_NE(named, lights.end());
    EXPECT_NE(
        text.find(fmt::format("[\"default\", light(Filament, 'SPOT', [1, 1, 1], {}", pi * named->intensity.value)),
        std::string::npos)
        << text;
    const auto alone = light_scene(**find_target("filament"), delivered("street.ies"));
    ASSERT_EQ(alone->instead.size(), 1U);
    EXPECT_NE(alone->instead[0].find("does not have profiles"), std::string::npos);
}

// All of PlayCanvas' amounts are over π, and profiles are cookies.
TEST(LightScene, OfPlayCanvasIsOverPi) {
    const std::vector<Light> lights = studio();
    const LightScene scene = *light_scene(**find_target("playcanvas"), lights, {"studio", "", Meters(1.0)});
    const std::string text = scene.files[0].bytes;
    EXPECT_NE(text.find(fmt::format(", {}, 4 * Math.PI, [1, 1, 1], {{ range: ", 40.0 / pi)), std::string::npos) << text;
    EXPECT_NE(text.find(fmt::format(", {}, 1, [1, 1, 1], {{  }})", 500.0 / pi)), std::string::npos) << text;
    EXPECT_NE(text.find("cookie: cookies[0], cookieChannel: 'rrr'"), std::string::npos);
}

// Godot counts 2π lumens for a candela of an area light.
TEST(LightScene, OfGodotHasAreas) {
    const std::vector<Light> lights = studio();
    const auto panel = std::find_if(lights.begin(), lights.end(), [](const Light& of) { return of.name == "panel"; });
    ASSERT_NE(panel, lights.end());
    const LightScene scene = *light_scene(**find_target("godot"), {&*panel, 1}, {"studio", "", Meters(1.0)});
    const std::string text = scene.files[0].bytes;
    EXPECT_NE(text.find("type=\"AreaLight3D\""), std::string::npos) << text;
    EXPECT_NE(text.find(fmt::format("light_intensity_lumens = {}\narea_size = Vector2(0.6, 0.3)",
                                    2.0 * pi * panel->intensity.value)),
              std::string::npos)
        << text;
}

TEST(LightScene, OfFilamentHasOneSun) {
    std::vector<Light> lights;
    for (const auto& [name, amount] :
         {std::pair("dim", "500lx"), std::pair("bright", "800lx"), std::pair("late", "800lx")}) {
        LightDescription sun;
        sun.name = name;
        sun.shape = *parse_shape("sun:angle=0.53deg");
        sun.intensity = *parse_photometric_value(amount);
        Diagnostics ignored;
        lights.push_back(*resolve_light(std::move(sun), ignored));
    }
    const LightScene scene = *light_scene(**find_target("filament"), lights, {"studio", "", Meters(1.0)});
    EXPECT_EQ(scene.files[0].bytes.find("[\"dim\","), std::string::npos);
    EXPECT_EQ(scene.files[0].bytes.find("[\"late\","), std::string::npos);
    EXPECT_NE(scene.files[0].bytes.find("[\"bright\","), std::string::npos);
    ASSERT_EQ(scene.instead.size(), 2U);
    EXPECT_NE(scene.instead[0].find("has one sun"), std::string::npos);
}

// The shapes, sizes and amounts of pbrt's lights, each checked separately.
TEST(LightScene, OfPbrtHoldsEveryKind) {
    const std::vector<Light> lights = studio();
    const Target& pbrt = **find_target("pbrt");
    const auto text = [&](std::string_view name) {
        for (const Light& light : lights)
            if (light.name == name) return light_scene(pbrt, {&light, 1}, {"one", "", Meters(1.0)})->files[0].bytes;
        return std::string();
    };
    const auto luminance = [](double nits) {
        return fmt::format("AreaLightSource \"diffuse\" \"rgb L\" [ 1 1 1 ] \"float scale\" [ {} ]", nits);
    };
    const auto holds = [&](std::string_view name, std::string_view part) {
        const std::string all = text(name);
        EXPECT_NE(all.find(part), std::string::npos) << name << " lacks " << part << "\n" << all;
    };
    for (const Light& light : lights)
        for (const char* area : {"key light", "disk", "panel", "tube"})
            if (light.name == area) holds(area, luminance(light.luminance.value));
    holds("key light", "Shape \"sphere\" \"float radius\" 0.1\n");
    holds("disk", "Shape \"disk\" \"float radius\" 0.2\n");
    holds("panel", "[ -0.3 -0.15 0  -0.3 0.15 0  0.3 -0.15 0  0.3 0.15 0 ]");
    holds("tube", "Translate -0.6 0 0\n    Shape \"sphere\" \"float radius\" 0.02");
    holds("tube", "\"cylinder\" \"float radius\" 0.02 \"float zmin\" -0.6 \"float zmax\" 0.6");
    holds("sun", "LightSource \"distant\" \"rgb L\" [ 1 1 1 ] \"float illuminance\" [ 500 ]");
    holds("soft", "\"float coneangle\" [ 40 ] \"float conedeltaangle\" [ 14.99999999"); // 40° − 25° in radians
    holds("point", "LightSource \"point\" \"rgb I\" [ 1 1 1 ] \"float scale\" [ 40 ]");
}

// Illuminance over distances is in the scene's unit, or the light is refused.
TEST(LightScene, CountsInTheSceneUnit) {
    const std::vector<Light> lights = studio();
    const std::vector<Light> point{lights[0]};
    const auto text = [&](const char* target, double unit) {
        return light_scene(**find_target(target), point, {"studio", "", Meters(unit)})->files[0].bytes;
    };
    EXPECT_NE(text("pbrt", 0.01).find("\"float scale\" [ 400000 ]"), std::string::npos);
    EXPECT_NE(text("pbrt", 0.01).find(" -40 200 1 ]"), std::string::npos) << text("pbrt", 0.01);
    EXPECT_NE(text("usd", 0.01).find("metersPerUnit = 0.01"), std::string::npos);
    EXPECT_NE(text("usd", 0.01).find("inputs:intensity = 40\n"), std::string::npos) << text("usd", 0.01);
    EXPECT_EQ(text("unreal", 0.01), text("unreal", 1.0));
    EXPECT_NE(text("unreal", 1.0).find("(0, 40, 200)"), std::string::npos) << text("unreal", 1.0);
    for (const auto& [target, unit] :
         {std::pair{"gltf", 0.01}, {"godot", 0.01}, {"unity", 0.01}, {"unreal", 0.0254}, {"raw", 0.01}})
        EXPECT_EQ(light_scene(**find_target(target), point, {"studio", "", Meters(unit)}).error().failure,
                  Failure::usage)
            << target;
}

TEST(LightScene, OfNothingIsRefused) {
    const std::vector<Light> lights = studio();
    const std::vector<Light> sun{lights[6]};
    EXPECT_EQ(light_scene(**find_target("raw"), sun, {"studio", "", Meters(1.0)}).error().failure,
              Failure::unsupported);
}

} // namespace
} // namespace gonio
