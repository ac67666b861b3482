#include <gonio/base/codes/rig.hpp>
#include <gonio/base/file.hpp>
#include <gonio/scene/detail/rig_expand.hpp>
#include <gonio/scene/detail/rig_stage.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/web/web.hpp>

#include "../folders.hpp"
#include "../temporary_folder.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {
namespace {

const std::string profiles = std::string(test::source_folder) + "/profiles";

Result<Rig> read(const std::string& text) {
    return read_rig(text, "rig.json", profiles);
}

std::string with_lights(const std::string& lights) {
    return R"({"schema":"gonio.rig/1","lights":[)" + lights + "]}";
}

// The only diagnostic of a rig that cannot be read or resolved; without line and column, which a test of its own
// checks.
std::string refusal(const std::string& text, Failure failure = Failure::malformed) {
    Result<Rig> rig = read(text);
    Error error;
    if (rig) {
        Diagnostics diagnostics;
        const auto lights = resolve_lights(std::move(*rig), diagnostics);
        if (lights) return "no failure";
        error = lights.error();
    } else {
        error = rig.error();
    }
    EXPECT_EQ(error.failure, failure) << text;
    EXPECT_EQ(error.diagnostics.size(), 1U) << text;
    Diagnostic& said = error.diagnostics.back();
    if (said.code != "RIG0101" && said.code != "RIG0108") said.location = {said.location.file, 0, 0};
    return to_text(said);
}

std::string light_refusal(const std::string& light, Failure failure = Failure::malformed) {
    return refusal(with_lights(light), failure);
}

// The same, with the line and column that placed it.
std::string placed_refusal(const std::string& text) {
    const Result<Rig> rig = read(text);
    return rig ? "no failure" : to_text(rig.error().diagnostics.back());
}

TEST(Rig, WrongValuesHaveALineAndAColumn) {
    const std::string head = "{ \"schema\": \"gonio.rig/1\",\n  \"lights\": [\n    { \"shape\": \"point\", ";
    const std::string tail = " } ] }";
    EXPECT_EQ(placed_refusal(head + "\n      \"intensity\": 800" + tail).substr(0, 33),
              "rig.json:4:7: error[RIG0105]: lig");
    EXPECT_EQ(placed_refusal(head + "\"range\":\"0m\"" + tail).substr(0, 34), "rig.json:3:25: error[RIG0106]: lig");
    // An unknown key itself, not its object.
    EXPECT_EQ(placed_refusal(head + "\"a\\\"b\": [1, {\"shape\": 2}],\n  \"rnage\": 1" + tail).substr(0, 34),
              "rig.json:3:25: error[RIG0103]: lig");
    EXPECT_EQ(placed_refusal(head + "\"name\": \"\\\\\",\n  \"rnage\": 1" + tail).substr(0, 33),
              "rig.json:4:3: error[RIG0103]: lig");
    // An element of an array within, a string and a number.
    EXPECT_EQ(placed_refusal(head + "\"array\": { \"spacing\": [1, 1],\n\"count\": [1,\n 2.5] }" + tail).substr(0, 33),
              "rig.json:5:2: error[RIG0106]: lig");
    EXPECT_EQ(
        placed_refusal(head + "\"array\": { \"spacing\": [1, 1],\n\"count\": [1, \"t\\\"wo\"] }" + tail).substr(0, 34),
        "rig.json:4:14: error[RIG0105]: lig");
    EXPECT_EQ(placed_refusal(head + "\"array\": { \"spacing\": [1, 1],\n\"count\": [1, true] }" + tail).substr(0, 34),
              "rig.json:4:14: error[RIG0105]: lig");
    EXPECT_EQ(
        placed_refusal(R"({"schema":"gonio.rig/1","lights":[{"shape":"point","intensity":"1lm"},{}]})").substr(0, 34),
        "rig.json:1:71: error[RIG0104]: lig");
    EXPECT_EQ(placed_refusal("{\"schema\":\"gonio.rig/1\",\n\"lights\":[],\n\"maintenance\":2}").substr(0, 33),
              "rig.json:3:1: error[RIG0106]: mai");
}

TEST(Rig, ReadsEveryKey) {
    const Rig rig = read(R"json({ "schema": "gonio.rig/1",
        "lights": [ { "name": "key", "shape": "sphere:r=10cm", "intensity": "800lm", "color": "rgb(1,1,1)",
                      "position": [1, 2.5, -3e0], "direction": [1, 0, 0], "up": [0, 0, 2], "rotate": "90deg",
                      "range": "12m" },
                    { "shape": "ies:downlight.ies" } ],
        "materials": { "wall": "lambert:albedo=0.25" },
        "stage": "floor",
        "camera": {
    "position" : [ 0, -4, 2 ], "target" : [ 0, 0, 0.5 ], "up" : [ 0, 1, 1 ], "fov" : "30deg"
}
})json")
                        .value();
    ASSERT_EQ(rig.lights.size(), 2U);
    const LightDescription& key = rig.lights[0];
    EXPECT_EQ(key.name, "key");
    EXPECT_DOUBLE_EQ(std::get<SphereShape>(key.shape).radius.value, 0.1);
    EXPECT_EQ(key.intensity->number, 800.0);
    EXPECT_EQ(key.position, glm::dvec3(1, 2.5, -3));
    EXPECT_EQ(key.direction, glm::dvec3(1, 0, 0));
    EXPECT_EQ(key.up, glm::dvec3(0, 0, 2));
    EXPECT_DOUBLE_EQ(to_degrees(key.rotation), 90.0);
    EXPECT_EQ(key.range->value, 12.0);
    EXPECT_EQ(rig.lights[1].name, "light 2");
    EXPECT_EQ(rig.lights[1].position, glm::dvec3(0.0));
    EXPECT_EQ(rig.stage->name, "floor");
    EXPECT_EQ(rig.camera->position, glm::dvec3(0, -4, 2));
    EXPECT_EQ(rig.camera->target, glm::dvec3(0, 0, 0.5));
    EXPECT_EQ(rig.camera->up, glm::dvec3(0, 1, 1));
    EXPECT_DOUBLE_EQ(rig.camera->vertical_fov_deg, 30.0);
    ASSERT_EQ(rig.materials.size(), 1U);
    EXPECT_EQ(rig.materials[0].surface, "wall");
    EXPECT_EQ(std::get<LambertMaterial>(rig.materials[0].material).albedo, glm::dvec3(0.25));
}

TEST(Rig, BrokenJsonIsPlacedByLineAndColumn) {
    EXPECT_EQ(refusal(""),
              "rig.json:1:1: error[RIG0101]: the JSON ends too early\nhint: expected '[', '{', or a literal");
    EXPECT_EQ(refusal("{\n  \"schema\": \"gonio.rig/1\",\n  lights: []\n}"),
              "rig.json:3:3: error[RIG0101]: broken JSON: invalid literal\nhint: expected string literal");
    EXPECT_EQ(light_refusal("{\"shape\":\"point\"\n}\n]"),
              "rig.json:3:2: error[RIG0101]: broken JSON: unexpected ']'\nhint: expected '}'");
    EXPECT_EQ(light_refusal("{\"position\":[0,0,1e999]}"),
              "rig.json:1:52: error[RIG0101]: the number 1e999 is too large");
    EXPECT_EQ(light_refusal("{\"name\":\"\xff\"}"), "rig.json:1:44: error[RIG0101]: the text is not UTF-8");
    EXPECT_EQ(refusal(with_lights("") + "\n]"),
              "rig.json:2:1: error[RIG0101]: broken JSON: unexpected ']'\nhint: expected end of input");
}

TEST(Rig, WrongValuesArePlacedByTheirPath) {
    EXPECT_EQ(refusal("[]"), "rig.json: error[RIG0101]: a rig is a JSON object\n"
                             "hint: write { \"schema\": \"gonio.rig/1\", \"lights\": [ … ] }");
    EXPECT_EQ(refusal("{\"lights\":[]}"),
              "rig.json: error[RIG0104]: the key 'schema' is missing\nhint: write \"schema\": \"gonio.rig/1\"");
    EXPECT_EQ(refusal("{\"schema\":\"gonio.rig/1\"}"),
              "rig.json: error[RIG0104]: the key 'lights' is missing\nhint: write \"lights\": [ … ]");
    EXPECT_EQ(refusal(R"({"schema":"gonio.rig/2","lights":[]})", Failure::unsupported),
              "rig.json: error[RIG0102]: schema: must be \"gonio.rig/1\", not \"gonio.rig/2\"");
    EXPECT_EQ(refusal(R"({"schema":"gonio.rig/1","lights":{}})"), "rig.json: error[RIG0105]: lights: must be an array");
    EXPECT_EQ(refusal(R"({"schema":"gonio.rig/1","lights":[],"lihgts":1})"),
              "rig.json: error[RIG0103]: unknown key 'lihgts'\n"
              "hint: did you mean 'lights'? there are: schema, luminaires, lights, maintenance, sky, stage, camera, "
              "materials, emits");
    EXPECT_EQ(refusal(R"({"schema":"gonio.rig/1","lights":[],"lights":[]})"),
              "rig.json: error[RIG0107]: the key 'lights' is given twice");
    EXPECT_EQ(light_refusal("7"), "rig.json: error[RIG0105]: lights[0]: must be an object, not a number");
    EXPECT_EQ(light_refusal(R"({"shape":"point","intensity":"1lm"},{"shpae":"point"})"),
              "rig.json: error[RIG0103]: lights[1]: unknown key 'shpae'\n"
              "hint: did you mean 'shape'? there are: name, shape, luminaire, intensity, color, position, positions, "
              "direction, target, up, rotate, smooth, range, dimming, maintenance, array");
    EXPECT_EQ(light_refusal("{}"), "rig.json: error[RIG0104]: lights[0]: the key 'shape' is missing\nhint: for example "
                                   "\"shape\": \"sphere:r=10cm\"");
    EXPECT_EQ(light_refusal(R"({"shape":"point","shape":"point"})"),
              "rig.json: error[RIG0107]: lights[0]: the key 'shape' is given twice");
    EXPECT_EQ(light_refusal(R"({"shape":"point","intensity":"1lm","smooth":"1deg"})"),
              "rig.json: error[RIG0106]: lights[0].smooth: is for the table of a profile, not for a point");
    EXPECT_EQ(light_refusal(R"({"shape":"sphere:r=0cm","intensity":"1lm"})"),
              "rig.json: error[RIG0106]: lights[0].shape: r of 'sphere' must be greater than 0, not 0cm");
    EXPECT_EQ(light_refusal(R"({"shape":"point","intensity":800})"),
              "rig.json: error[RIG0105]: lights[0].intensity: must be a string, not a number\n"
              "hint: write it with its unit, for example \"800lm\"");
    EXPECT_EQ(light_refusal(R"({"shape":"point"})"),
              "rig.json: error[RIG0104]: lights[0]: a point light needs an intensity\nhint: for example 800lm");
    EXPECT_EQ(light_refusal(R"({"shape":"point","position":[0,0]})"),
              "rig.json: error[RIG0105]: lights[0].position: must be an array of three numbers, not of 2\n"
              "hint: for example [0, 0, 2.5]");
    EXPECT_EQ(light_refusal(R"({"shape":"point","position":[0,0,"1m"]})"),
              "rig.json: error[RIG0105]: lights[0].position: must be an array of three numbers, not one with a string\n"
              "hint: for example [0, 0, 2.5]");
    EXPECT_EQ(light_refusal(R"({"shape":"point","position":[0,0,1e101]})"),
              "rig.json: error[RIG0106]: lights[0].position: must lie within 1e+100 m");
    EXPECT_EQ(light_refusal(R"({"shape":"point","direction":[0,0,0]})"),
              "rig.json: error[RIG0106]: lights[0].direction: must not be zero");
    EXPECT_EQ(light_refusal(R"({"shape":"point","range":"0m"})"),
              "rig.json: error[RIG0106]: lights[0].range: must be greater than 0");
    EXPECT_EQ(light_refusal(R"({"name":null,"shape":"point"})"),
              "rig.json: error[RIG0105]: lights[0].name: must be a string, not null");
    EXPECT_EQ(refusal(R"({"schema":"gonio.rig/1","lights":[],"stage":"flor"})").substr(0, 53),
              "rig.json: error[RIG0103]: stage: unknown stage 'flor'");
    EXPECT_EQ(refusal(R"({"schema":"gonio.rig/1","lights":[],"camera":{"fov":"180deg"}})"),
              "rig.json: error[RIG0106]: camera.fov: must lie between 0deg and 180deg");
    EXPECT_EQ(refusal(R"({"schema":"gonio.rig/1","lights":[],"camera":{"position":[0,0,1]}})"),
              "rig.json: error[RIG0106]: camera: must not be at its own target");
    EXPECT_EQ(refusal(R"({"schema":"gonio.rig/1","lights":[],"materials":{"flor":"lambert"}})").substr(0, 64),
              "rig.json: error[RIG0103]: materials: unknown surface 'flor' of '");
    EXPECT_EQ(refusal(R"({"schema":"gonio.rig/1","lights":[],"materials":{"floor":"lambert:albedo=2"}})"),
              "rig.json: error[RIG0106]: materials.floor: albedo of 'lambert' must lie in [0, 1], not 2");
}

std::string with_stage(const std::string& stage) {
    return R"({"schema":"gonio.rig/1","lights":[],"stage":)" + stage + "}";
}

std::string surface_refusal(const std::string& surface) {
    return refusal(with_stage(R"({"surfaces":[{"name":"ground","plane":{}},)" + surface + "]}"));
}

TEST(Rig, ReadsAStageOfItsOwn) {
    const Rig rig = read(R"json({ "schema": "gonio.rig/1", "lights": [], "materials": { "leg": "lambert:albedo=0.2" },
        "stage": { "name": "desk", "figure": [1, 2, 0], "surfaces": [
            { "name": "floor", "plane": { "point": [0, 0, -1], "normal": [0, 0, 2] }, "material": "lambert:albedo=0.3" },
            { "name": "screen", "panel": { "center": [0, 1, 1], "normal": [0, -1, 0], "width": "2m", "height": "50cm" } },
            { "name": "table", "box": { "center": [0, 0, 0.7], "size": [1.6, 0.8, 0.04], "rotate": "90deg" } },
            { "name": "globe", "sphere": { "center": [0, 0, 0.9], "radius": "15cm" } },
            { "name": "leg", "capsule": { "from": [0.7, 0, 0], "to": [0.7, 0, 0.6], "radius": "3cm" } } ] } })json")
                        .value();
    const Stage& stage = *rig.stage;
    EXPECT_EQ(stage.name, "desk");
    EXPECT_EQ(stage.figure_position, glm::dvec3(1, 2, 0));
    ASSERT_EQ(stage.surfaces.size(), 5U);
    EXPECT_EQ(std::get<Plane>(stage.surfaces[0].geometry).normal, glm::dvec3(0, 0, 1));
    EXPECT_EQ(std::get<LambertMaterial>(stage.surfaces[0].material).albedo, glm::dvec3(0.3));
    const auto& screen = std::get<Panel>(stage.surfaces[1].geometry);
    EXPECT_EQ(screen.frame.z, glm::dvec3(0, -1, 0));
    EXPECT_EQ(screen.frame.y, glm::dvec3(0, 0, 1));
    EXPECT_EQ(screen.width, 2.0);
    EXPECT_EQ(screen.height, 0.5);
    const auto& table = std::get<Box>(stage.surfaces[2].geometry);
    EXPECT_EQ(table.half_size, glm::dvec3(0.8, 0.4, 0.02));
    EXPECT_NEAR(glm::distance(table.frame.x, glm::dvec3(0, 1, 0)), 0.0, 1e-15);
    EXPECT_EQ(table.frame.z, glm::dvec3(0, 0, 1));
    EXPECT_EQ(std::get<Ball>(stage.surfaces[3].geometry).radius, 0.15);
    const auto& leg = std::get<Capsule>(stage.surfaces[4].geometry);
    EXPECT_EQ(leg.center, glm::dvec3(0.7, 0, 0.3));
    EXPECT_EQ(leg.half_length, 0.3);
    EXPECT_FALSE(stage.surfaces[1].subject);
    EXPECT_TRUE(stage.surfaces[2].subject);
    // The camera sees the subjects of the stage.
    EXPECT_TRUE(check_camera(stage, stage.camera));
    const auto hit = first_hit(stage, CameraRays(stage.camera, 64, 64).ray(32, 32));
    ASSERT_TRUE(hit);
    EXPECT_TRUE(stage.surfaces[hit->surface].subject);
}

TEST(Rig, WrongStagesArePlacedByTheirPath) {
    EXPECT_EQ(refusal(with_stage("7")), "rig.json: error[RIG0105]: stage: must be a string or an object, not a number\n"
                                        "hint: for example \"floor\" or { \"surfaces\": [ … ] }");
    EXPECT_EQ(refusal(with_stage("{}")),
              "rig.json: error[RIG0104]: stage.surfaces: must be an array of at least one surface\n"
              "hint: for example [ { \"name\": \"floor\", \"plane\": {} } ]");
    EXPECT_EQ(refusal(with_stage(R"({"surface":[]})")),
              "rig.json: error[RIG0103]: stage: unknown key 'surface'\n"
              "hint: did you mean 'surfaces'? there are: name, surfaces, figure");
    EXPECT_EQ(surface_refusal("3"), "rig.json: error[RIG0105]: stage.surfaces[1]: must be an object, not a number");
    EXPECT_EQ(surface_refusal("{}"), "rig.json: error[RIG0104]: stage.surfaces[1]: the key 'name' is missing");
    EXPECT_EQ(surface_refusal(R"({"name":"a"})"), "rig.json: error[RIG0104]: stage.surfaces[1]: has no shape\n"
                                                  "hint: give it a plane, panel, box, sphere or capsule");
    EXPECT_EQ(
        surface_refusal(R"({"name":"a","plane":{},"box":{}})"),
        "rig.json: error[RIG0107]: stage.surfaces[1]: has both a plane and a box\nhint: a surface has only one shape");
    EXPECT_EQ(surface_refusal(R"({"name":"a","plane":[]})"),
              "rig.json: error[RIG0105]: stage.surfaces[1].plane: must be an object, not an array");
    EXPECT_EQ(surface_refusal(R"({"name":"a","sphere":{"center":[0,0,1],"radius":"0m"}})"),
              "rig.json: error[RIG0106]: stage.surfaces[1].sphere.radius: must be greater than 0");
    EXPECT_EQ(surface_refusal(R"({"name":"a","sphere":{"center":[0,0,1],"radius":2}})"),
              "rig.json: error[RIG0105]: stage.surfaces[1].sphere.radius: must be a string, not a number\n"
              "hint: write it with its unit, for example \"2m\"");
    EXPECT_EQ(surface_refusal(R"({"name":"a","sphere":{"center":[0,0,1]}})"),
              "rig.json: error[RIG0104]: stage.surfaces[1].sphere: the key 'radius' is missing");
    EXPECT_EQ(surface_refusal(R"({"name":"a","sphere":{"radius":"1m","centre":[0,0,1]}})"),
              "rig.json: error[RIG0103]: stage.surfaces[1].sphere: unknown key 'centre'\n"
              "hint: did you mean 'center'? there are: center, radius");
    EXPECT_EQ(surface_refusal(R"({"name":"a","box":{"center":[0,0,1],"size":[1,0,1]}})"),
              "rig.json: error[RIG0106]: stage.surfaces[1].box.size: must be greater than 0 along every axis\n"
              "hint: for a flat surface without thickness use a panel");
    EXPECT_EQ(surface_refusal(R"({"name":"a","box":{"center":[0,2e9,1],"size":[1,1,1]}})"),
              "rig.json: error[RIG0106]: stage.surfaces[1].box.center: must lie within 1e+09 m");
    EXPECT_EQ(surface_refusal(R"({"name":"a","capsule":{"from":[0,0,1],"to":[0,0,1],"radius":"1cm"}})"),
              "rig.json: error[RIG0106]: stage.surfaces[1].capsule: 'from' and 'to' must differ\nhint: for a ball use "
              "a sphere");
    EXPECT_EQ(surface_refusal(R"({"name":"a","plane":{"normal":[0,0,0]}})"),
              "rig.json: error[RIG0106]: stage.surfaces[1].plane.normal: must not be zero");
    EXPECT_EQ(surface_refusal(R"({"name":"a","plane":{},"material":"lambert:albedo=2"})"),
              "rig.json: error[RIG0106]: stage.surfaces[1].material: albedo of 'lambert' must lie in [0, 1], not 2");
    EXPECT_EQ(refusal(with_stage(R"({"surfaces":[{"name":"a","plane":{}}]},"camera":{"position":[0,-5,-1]})")),
              "rig.json: error[RIG0106]: camera: the camera at 0,-5,-1 is behind 'a'\n"
              "hint: a plane is seen from its lit side only");
    std::string many;
    for (int i = 0; i < 257; ++i)
        many += R"({"name":"a","plane":{}},)";
    many.pop_back();
    EXPECT_EQ(
        refusal(with_stage(R"({"surfaces":[)" + many + "]}")),
        "rig.json:1:46: error[RIG0108]: stage.surfaces: holds more than 256 surfaces, the limit 'stage-surfaces'\n"
        "hint: 'gonio list limits' describes each limit");
    std::string more;
    for (int i = 0; i < 1e6; ++i)
        more += "0,";
    EXPECT_EQ(refusal(with_stage(R"({"surfaces":[)" + more)).substr(0, 98),
              "rig.json:1:131129: error[RIG0108]: stage: holds more than 65536 values, the limit 'rig-values'\nhin");
}

// Otherwise a code could be documented but never reported.
TEST(Rig, EveryCodeHasTheSmallestRigThatBreaksIt) {
    const std::map<std::string_view, std::string> broken{
        {"RIG0101", "[]"},
        {"RIG0102", R"({"schema":"gonio.rig/2","lights":[]})"},
        {"RIG0103", with_lights(R"({"shpe":"point"})")},
        {"RIG0104", with_lights("{}")},
        {"RIG0105", with_lights("7")},
        {"RIG0106", with_lights(R"({"shape":"sphere:r=0m"})")},
        {"RIG0107", with_lights(R"({"shape":"point","shape":"point"})")},
        {"RIG0108", with_lights(std::string(17, '['))},
    };
    for (const DiagnosticCode& code : rig_codes) {
        const auto rig = broken.find(code.code);
        ASSERT_NE(rig, broken.end()) << code.code;
        const Result<Rig> got = read(rig->second);
        ASSERT_FALSE(got) << code.code;
        EXPECT_EQ(got.error().diagnostics.back().code, code.code);
        EXPECT_EQ(got.error().diagnostics.back().severity, code.severity);
    }
}

TEST(Rig, FilesAreNamedWithTheirPath) {
    EXPECT_EQ(
        light_refusal(R"({"shape":"ies:missing.ies"})", Failure::io),
        fmt::format("rig.json: error[FIL0102]: lights[0].shape: {}/missing.ies: cannot read: No such file or directory",
                    profiles));
    EXPECT_EQ(light_refusal(R"({"shape":"ies:."})", Failure::io),
              fmt::format("rig.json: error[FIL0101]: lights[0].shape: {}/.: cannot read: it is a folder\n"
                          "hint: name a file in it",
                          profiles));
    EXPECT_EQ(
        light_refusal(R"({"shape":"spot:outer=20deg,mask=missing.ies","intensity":"1cd"})", Failure::io),
        fmt::format("rig.json: error[FIL0102]: lights[0].shape: {}/missing.ies: cannot read: No such file or directory",
                    profiles));
    // A text that is not a profile, such as a rig that names itself.
    EXPECT_EQ(light_refusal(R"({"shape":"ies:README.md"})").substr(0, 46),
              "rig.json: error[PRF0103]: lights[0].shape: " + profiles.substr(0, 3));
}

// A folder with a rig's files, and beside it files that the rig must not read.
class RigFiles : public testing::Test {
protected:
    RigFiles() {
        std::filesystem::create_directory(folder_.path() / "rigs");
        std::filesystem::copy_file(profiles + "/downlight.ies", folder_.path() / "rigs/lamp.ies");
        std::ofstream(folder_.path() / "rigs/white.csv") << rows();
        std::ofstream(folder_.path() / "rigs/accounts.csv") << "root:x:0:0:root:/root:/bin/bash\nmallory:hunter2:1:1\n";
        std::filesystem::copy(folder_.path() / "rigs/lamp.ies", folder_.path() / "lamp.ies");
        std::ofstream(folder_.path() / "white.csv") << rows();
    }

    static std::string rows() {
        std::string text;
        for (int nm = 380; nm <= 780; nm += 5)
            text += fmt::format("{},1\n", nm);
        return text;
    }
    std::string at(const std::string& name) const { return (folder_.path() / name).string(); }
    Result<Rig> read_light(const std::string& light, const RigReadOptions& options = {}) const {
        return read_rig(with_lights(light), "rig.json", at("rigs"), options);
    }

    test::TemporaryFolder folder_;
};

constexpr std::array outside_lights{
    R"({"shape":"ies:../lamp.ies"})",
    R"({"shape":"point:mask=../lamp.ies","intensity":"1cd"})",
    R"({"shape":"point","intensity":"1cd","color":"spectrum:../white.csv"})",
    R"({"shape":"point","intensity":"1W@spectrum:../white.csv"})",
};

TEST_F(RigFiles, OutsideItsFolderAreRefusedUnlessAllowed) {
    for (const char* light : outside_lights) {
        const Result<Rig> rig = read_light(light);
        ASSERT_FALSE(rig) << light;
        EXPECT_EQ(rig.error().failure, Failure::io);
        const Diagnostic& said = rig.error().diagnostics.back();
        EXPECT_NE(said.message.find(fmt::format("is outside the folder '{}'", at("rigs"))), std::string::npos)
            << said.message;
        EXPECT_EQ(said.hint, "put it under that folder");
        EXPECT_TRUE(read_light(light, {true, {}})) << light;
    }
}

TEST_F(RigFiles, AreListedOnceAndSorted) {
    const Result<Rig> rig = read_light(R"({"shape":"ies:lamp.ies","color":"spectrum:white.csv"},
                      {"shape":"point:mask=lamp.ies","intensity":"1W@spectrum:white.csv","color":"spectrum:D50"},
                      {"shape":"ies:../lamp.ies"})",
                                       {true, {}});
    ASSERT_TRUE(rig);
    EXPECT_EQ(rig->files, (std::vector{at("rigs/../lamp.ies"), at("rigs/lamp.ies"), at("rigs/white.csv")}));
}

TEST_F(RigFiles, OfAnotherKindAreNotQuoted) {
    for (const char* light :
         {R"({"shape":"point","intensity":"1cd","color":"spectrum:accounts.csv"})",
          R"({"shape":"point","intensity":"1W@spectrum:accounts.csv"})", R"({"shape":"ies:accounts.csv"})"}) {
        const Result<Rig> rig = read_light(light);
        ASSERT_FALSE(rig) << light;
        const std::string said = to_text(rig.error().diagnostics.back());
        EXPECT_EQ(said.find("root"), std::string::npos) << said;
        EXPECT_EQ(said.find("hunter2"), std::string::npos) << said;
    }
    // Nor is a JSON text that is not a rig.
    EXPECT_EQ(refusal(R"({"api_token":"hunter2"})"), "rig.json: error[RIG0101]: not a rig: it begins with another key\n"
                                                     "hint: write \"schema\": \"gonio.rig/1\" first");
    EXPECT_EQ(refusal(R"({"schema":"hunter2"})", Failure::unsupported),
              "rig.json: error[RIG0102]: schema: must be \"gonio.rig/1\", not another");
}

TEST(Rig, SmoothTablesAreSharedToo) {
    Rig rig = read(with_lights(R"({"shape":"ies:downlight.ies"},
        {"shape":"ies:downlight.ies","smooth":"0.5deg"},
        {"smooth":"0.5deg","shape":"ies:downlight.ies","position":[3,0,0]},
        {"shape":"ies:downlight.ies","smooth":"2deg"})"))
                  .value();
    const auto web_of = [&](std::size_t i) { return std::get<ProfileShape>(rig.lights[i].shape).web; };
    EXPECT_EQ(web_of(1), web_of(2));
    EXPECT_NE(web_of(0), web_of(1));
    EXPECT_GT(web_of(1)->gammas_deg().size(), web_of(3)->gammas_deg().size());
    for (const double gamma : web_of(0)->gammas_deg())
        EXPECT_NEAR(web_of(1)->candela(0.0, gamma), web_of(0)->candela(0.0, gamma), 1e-9 * 3536.0);
    EXPECT_EQ(std::count_if(rig.diagnostics.begin(), rig.diagnostics.end(),
                            [](const Diagnostic& said) { return said.code == "RES0208"; }),
              2);
    EXPECT_NE(light_refusal(R"({"shape":"ies:downlight.ies","smooth":"0.01deg"})").find("lights[0].smooth"),
              std::string::npos);
}

TEST(Rig, ProfilesAreReadOnceAndShared) {
    Rig rig = read(with_lights(R"({"shape":"ies:downlight.ies"},
        {"shape":"ies:downlight.ies","intensity":"300lm","position":[3,0,0],"range":"5m","name":"dim"},
        {"shape":"ies:downlight.ies","intensity":"300lm"},
        {"shape":"spot:outer=60deg,mask=downlight.ies","intensity":"300lm"})"))
                  .value();
    EXPECT_EQ(std::get<ProfileShape>(rig.lights[0].shape).web, std::get<ProfileShape>(rig.lights[1].shape).web);
    EXPECT_TRUE(std::get<SpotShape>(rig.lights[3].shape).mask);
    const std::vector<LightDescription> descriptions = rig.lights;
    Diagnostics diagnostics;
    const std::vector<Light> lights = resolve_lights(std::move(rig), diagnostics).value();
    // As if each light were resolved alone.
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Light alone = resolve_light(descriptions[i], diagnostics).value();
        EXPECT_EQ(lights[i].name, alone.name);
        EXPECT_EQ(lights[i].intensity, alone.intensity);
        EXPECT_EQ(lights[i].web_scale, alone.web_scale);
        EXPECT_EQ(lights[i].frame.origin, alone.frame.origin);
        EXPECT_EQ(lights[i].range.has_value(), alone.range.has_value());
        EXPECT_EQ(lights[i].intensity_towards({0.1, 0.2, -1}).value, alone.intensity_towards({0.1, 0.2, -1}).value);
    }
}

TEST(Rig, NestingAndSizeAreBounded) {
    EXPECT_EQ(refusal(std::string(1000000, '[')).substr(0, 48), "rig.json: error[RIG0101]: a rig is a JSON object");
    EXPECT_EQ(light_refusal("{\"name\":" + std::string(1000000, '[')),
              "rig.json:1:58: error[RIG0108]: lights[0]: is nested deeper than 16 levels, the limit 'rig-depth'\n"
              "hint: 'gonio list limits' describes each limit");
    std::string deep;
    for (int i = 0; i < 100000; ++i)
        deep += "{\"a\":";
    EXPECT_EQ(refusal("{\"camera\":\n" + deep).substr(0, 94),
              "rig.json:2:81: error[RIG0108]: camera: is nested deeper than 16 levels, the limit 'rig-depth'\n");
    std::string wide = "{\"position\":[0";
    for (int i = 0; i < 70000; ++i)
        wide += ",0";
    EXPECT_NE(light_refusal(wide + "]}")
                  .find(": error[RIG0108]: lights[0]: holds more than 65536 values, the limit 'rig-values'"),
              std::string::npos);
}

TEST(Rig, ParallelResolveOfManyLights) {
    constexpr int count = 100000;
    std::string lights;
    for (int i = 0; i < count; ++i)
        lights += fmt::format("{}{{\"shape\":\"{}\",\"intensity\":\"100lm\",\"position\":[{},{},3]}}",
                              i > 0 ? ",\n" : "", i % 2 == 0 ? "point" : "ies:downlight.ies", i % 300, i / 300);
    Rig rig = read(with_lights(lights)).value();
    ASSERT_EQ(rig.lights.size(), static_cast<std::size_t>(count));
    Diagnostics diagnostics;
    const std::vector<Light> resolved = resolve_lights(std::move(rig), diagnostics, 3).value();
    ASSERT_EQ(resolved.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(resolved[99999].name, "light 100000");
    const Receiver receiver{{150, 150, 0}, {0, 0, 1}};
    const double lx = probe(resolved, {&receiver, 1}).value().illuminance_lx[0];
    EXPECT_TRUE(std::isfinite(lx) && lx > 0.0);

    // Of several bad lights the first is reported, whichever thread finds one first.
    const std::string bad = with_lights(lights + ",{\"shape\":\"point\"},{\"shape\":\"sphere:r=1m\"}");
    EXPECT_EQ(refusal(bad),
              "rig.json: error[RIG0104]: lights[100000]: a point light needs an intensity\nhint: for example "
              "800lm");
}

const std::string globe_stage = R"("stage": { "surfaces": [ { "name": "floor", "plane": {} }, { "name": "globe",
    "sphere": { "center": [0, 0, 1], "radius": "10cm" })";

std::string with_globe(const std::string& globe, const std::string& more = {}) {
    return R"({"schema":"gonio.rig/1","lights":[],)" + globe_stage + globe + " } ] }" + more + "}";
}

TEST(Rig, SurfacesEmit) {
    const Rig rig = read(with_globe(R"json(, "emits": "800lm,color=rgb(1,0,0)")json")).value();
    const std::vector<LightDescription> lights = emissive_lights(rig).value();
    ASSERT_EQ(lights.size(), 1U);
    EXPECT_EQ(lights[0].name, "globe");
    EXPECT_EQ(lights[0].emitted_by->surface, 1U);
    EXPECT_EQ(lights[0].intensity->number, 800.0);
    EXPECT_EQ(lights[0].color.y, 0.0);
    EXPECT_TRUE(require_lights(rig));
    // "emits" goes by name, and in place of what the surface says.
    const Rig named = read(with_globe(R"(, "emits": "800lm")", R"(, "emits": { "globe": "500nt" })")).value();
    ASSERT_EQ(named.emits.size(), 1U);
    EXPECT_EQ(emissive_lights(named).value()[0].intensity->number, 500.0);
    const Rig of_default = read(R"({"schema":"gonio.rig/1","lights":[],"emits":{"sphere":"500nt"}})").value();
    EXPECT_EQ(emissive_lights(of_default).value().size(), 1U);
    EXPECT_FALSE(require_lights(read(with_globe("")).value()));
}

TEST(Rig, RefusesEmissionThatASurfaceCannotHave) {
    EXPECT_EQ(refusal(with_globe(R"(, "emits": "0nt")")),
              "rig.json: error[RIG0106]: stage.surfaces[1].emits: a surface that emits needs an amount greater than 0\n"
              "hint: a surface that only reflects needs none");
    EXPECT_EQ(refusal(with_globe(R"(, "emits": 500)")),
              "rig.json: error[RIG0105]: stage.surfaces[1].emits: must be a string, not a number\nhint: write it with "
              "its unit, for example \"500nt\"");
    EXPECT_EQ(refusal(with_globe(R"(, "emits": "500nt,colr=d65")")),
              "rig.json: error[RIG0103]: stage.surfaces[1].emits: unknown key 'colr' of 'emits'\nhint: did you mean "
              "'color'? there are: color");
    EXPECT_EQ(refusal(with_globe("", R"(, "emits": { "globo": "500nt" })")),
              "rig.json: error[RIG0103]: emits.globo: unknown surface 'globo' of 'custom'\nhint: did you mean 'globe'? "
              "there are: floor, globe");
    EXPECT_EQ(
        refusal(with_globe("", R"(, "emits": { "floor": "500nt" })")),
        "rig.json: error[RIG0107]: emits.floor: a plane cannot emit light: it has no end, so neither a flux nor a "
        "light of its shape\nhint: use a panel, which has a width and a height");
    EXPECT_EQ(refusal(with_globe("", R"(, "emits": "500nt")")),
              "rig.json: error[RIG0105]: emits: must be an object, not a string\nhint: for example { \"sphere\": "
              "\"500nt\" }");
    // Files of colours must lie beside the rig, as those of lights.
    EXPECT_NE(refusal(with_globe(R"(, "emits": "500nt,color=spectrum:/etc/passwd")"), Failure::io), "no failure");
}

TEST(Rig, SchemaFileNamesTheKeysThatAreRead) {
    const std::string path = std::string(test::source_folder) + "/lib/gonio/scene/rig.schema.json";
    const auto schema = nlohmann::json::parse(read_file(path).value());
    const auto expect_keys = [](const nlohmann::json& properties, std::span<const std::string_view> keys) {
        EXPECT_EQ(properties.size(), keys.size());
        for (const std::string_view key : keys)
            EXPECT_TRUE(properties.contains(key)) << key;
    };
    expect_keys(schema["properties"], rig_keys());
    expect_keys(schema["$defs"]["light"]["properties"], rig_light_keys());
    expect_keys(schema["$defs"]["luminaire"]["properties"], detail::rig_luminaire_keys());
    expect_keys(schema["$defs"]["group"]["properties"], detail::rig_group_keys());
    expect_keys(schema["$defs"]["array"]["properties"], detail::rig_array_keys());
    expect_keys(schema["$defs"]["camera"]["properties"], rig_camera_keys());
    expect_keys(schema["$defs"]["stage"]["properties"], detail::rig_stage_keys());
    const auto& surface = schema["$defs"]["surface"]["properties"];
    expect_keys(surface, detail::rig_surface_keys());
    for (const char* primitive : {"plane", "panel", "box", "sphere", "capsule"})
        expect_keys(surface[primitive]["properties"], detail::rig_primitive_keys(primitive));
}

} // namespace
} // namespace gonio
