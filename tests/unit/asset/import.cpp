// What import delivers: the light that was asked for, and files that say it.
#include <gonio/asset/measured_light.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/light/closed_forms.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/resolve.hpp>

#include "../folders.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
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
    return (*find_target(target))->files(light);
}

TEST(MeasuredLight, IsScaledAndTurned) {
    const MeasuredLight measured = delivered("street.ies");
    MeasuredLightOptions options;
    options.flux = Lumens(800);
    options.rotation = degrees(90);
    const MeasuredLight turned = delivered("street.ies", options);
    EXPECT_NEAR(turned.flux.value, 800.0, 1e-6 * 800.0); // values of nine digits
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

// The properties that the extensions' schemas allow, with their ranges; indices that point to something.
void check_gltf(const json& document, const MeasuredLight& light, bool embedded) {
    const json& profiles = document["extensions"]["EXT_lights_ies"]["lights"];
    ASSERT_EQ(profiles.size(), 1U);
    for (const auto& [key, value] : profiles[0].items())
        EXPECT_TRUE(key == "name" || key == (embedded ? "bufferView" : "uri") || (embedded && key == "mimeType"))
            << key;
    if (embedded) {
        EXPECT_EQ(profiles[0]["mimeType"], "application/x-ies-lm-63");
        const json& view = document["bufferViews"][profiles[0]["bufferView"].get<std::size_t>()];
        EXPECT_EQ(view["byteLength"], light.portable_ies.size());
        EXPECT_LE(view["byteOffset"].get<std::size_t>() + light.portable_ies.size(),
                  document["buffers"][view["buffer"].get<std::size_t>()]["byteLength"].get<std::size_t>());
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
    // The candela of the file times multiplier and colour have the file's luminous intensity.
    EXPECT_NEAR(luminance * use["multiplier"].get<double>(), 1.0, 1e-12);
    // The rotation takes the light's −Z, γ = 0, down.
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

// Every target writes files of plain names and, in its own text, nothing but ASCII.
TEST(Targets, WriteWhatEverySystemTakes) {
    const MeasuredLight light = delivered("street.ies");
    for (const Target& target : targets()) {
        const auto files = target.files(light);
        EXPECT_FALSE(files.empty()) << target.name;
        for (const AssetFile& file : files) {
            EXPECT_TRUE(file.name.starts_with("street.")) << file.name;
            EXPECT_NE(file.bytes.empty(), !file.texture) << file.name;
            if (file.name.ends_with(".glb")) continue;
            EXPECT_TRUE(std::all_of(file.bytes.begin(), file.bytes.end(), [](char c) {
                return (c >= 0x20 && c < 0x7f) || c == '\n' || c == '\r';
            })) << file.name;
        }
    }
    EXPECT_FALSE(find_target("gtlf"));
}

} // namespace
} // namespace gonio
