// Luminaires, arrays, lists of positions, groups, targets, dimming and maintenance factors of a rig.
#include <gonio/base/limits.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/rig.hpp>

#include "../folders.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace gonio {
namespace {

const std::string profiles = std::string(test::source_folder) + "/profiles";

std::string rig_of(const std::string& lights, const std::string& members = {}) {
    return fmt::format(R"({{"schema":"gonio.rig/1",{}"lights":[{}]}})", members, lights);
}

Result<Rig> read(const std::string& text) {
    return read_rig(text, "rig.json", profiles);
}

std::vector<Light> lights_of(const std::string& text) {
    Result<Rig> rig = read(text);
    EXPECT_TRUE(rig) << (rig ? "" : to_text(rig.error().diagnostics.back()));
    if (!rig) return {};
    Diagnostics diagnostics;
    Result<std::vector<Light>> lights = resolve_lights(std::move(*rig), diagnostics, 1);
    EXPECT_TRUE(lights) << (lights ? "" : to_text(lights.error().diagnostics.back()));
    return lights ? *lights : std::vector<Light>();
}

std::string refusal(const std::string& text) {
    const Result<Rig> rig = read(text);
    if (rig) return "no failure";
    EXPECT_EQ(rig.error().failure, Failure::malformed);
    // Line and column have a test of their own (Rig.WrongValuesHaveALineAndAColumn).
    Diagnostic said = rig.error().diagnostics.back();
    EXPECT_EQ(said.location.line, 1U);
    said.location = {said.location.file, 0, 0};
    return to_text(said);
}

std::vector<std::string> names_of(const std::vector<Light>& lights) {
    std::vector<std::string> names;
    for (const Light& light : lights)
        names.push_back(light.name);
    return names;
}

void expect_at(const glm::dvec3& got, const glm::dvec3& wanted) {
    EXPECT_NEAR(glm::distance(got, wanted), 0.0, 1e-12) << got.x << ' ' << got.y << ' ' << got.z;
}

const std::string lamp = R"("shape":"point","intensity":"100cd")";

TEST(RigExpand, AnArrayIsCentredAndCountsAlongXFirst) {
    const std::vector<Light> lights = lights_of(rig_of(
        fmt::format(R"({{"name":"desk",{},"position":[1,2,3],"array":{{"count":[3,2],"spacing":[2,1.5]}}}})", lamp)));
    EXPECT_EQ(names_of(lights),
              (std::vector<std::string>{"desk[1,1]", "desk[2,1]", "desk[3,1]", "desk[1,2]", "desk[2,2]", "desk[3,2]"}));
    expect_at(lights[0].frame.origin, {-1, 1.25, 3});
    expect_at(lights[1].frame.origin, {1, 1.25, 3});
    expect_at(lights[5].frame.origin, {3, 2.75, 3});
}

TEST(RigExpand, AnArrayInARoomHasHalfTheSpacingToItsWalls) {
    const std::vector<Light> lights =
        lights_of(rig_of(fmt::format(R"({{{},"array":{{"count":[3,4],"room":[7.2,6]}}}})", lamp)));
    ASSERT_EQ(lights.size(), 12U);
    expect_at(lights.front().frame.origin, {-2.4, -2.25, 0});
    expect_at(lights.back().frame.origin, {2.4, 2.25, 0});
    EXPECT_EQ(lights.back().name, "light 1[3,4]");
}

TEST(RigExpand, SeveralLevelsAreNumberedToo) {
    const std::vector<Light> lights = lights_of(rig_of(fmt::format(
        R"({{"name":"a",{},"positions":[[0,0,1],[5,0,1]],"array":{{"count":[1,1,2],"spacing":[0,0,0.5]}}}})", lamp)));
    EXPECT_EQ(names_of(lights), (std::vector<std::string>{"a[1][1,1,1]", "a[1][1,1,2]", "a[2][1,1,1]", "a[2][1,1,2]"}));
    expect_at(lights[3].frame.origin, {5, 0, 1.25});
}

TEST(RigExpand, AnArrayOfOneNeedsNoSpacing) {
    EXPECT_EQ(lights_of(rig_of(fmt::format(R"({{{},"array":{{"count":[1,1]}}}})", lamp))).size(), 1U);
}

TEST(RigExpand, ALightHasWhatItsLuminaireHas) {
    const std::string luminaires = R"json("luminaires":{"A":{"shape":"sphere:r=10cm","intensity":"800lm",
        "color":"rgb(1,0,0)","range":"5m","maintenance":0.8}},)json";
    const std::string lights = R"({"luminaire":"A"},{"name":"b","luminaire":"A","intensity":"400lm","range":"7m",
        "maintenance":0.5,"dimming":"50%"},{"luminaire":"A","positions":[[1,0,0],[2,0,0]]})";
    const std::vector<Light> before = lights_of(rig_of(lights, luminaires));
    EXPECT_EQ(names_of(before), (std::vector<std::string>{"A 1", "b", "A 3[1]", "A 3[2]"}));
    EXPECT_EQ(before[0].color.y, 0.0);
    EXPECT_EQ(before[0].range->value, 5.0);
    EXPECT_EQ(before[1].range->value, 7.0);
    EXPECT_DOUBLE_EQ(before[1].luminance.value / before[0].luminance.value, 0.5 * 0.5 * 0.5);
    // Luminaires may follow the lights.
    std::string behind = R"({"schema":"gonio.rig/1","lights":[)" + lights + "]," + luminaires;
    behind.back() = '}';
    const std::vector<Light> after = lights_of(behind);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_EQ(after[i].luminance, before[i].luminance);
        EXPECT_EQ(after[i].frame.origin, before[i].frame.origin);
    }
}

TEST(RigExpand, LightsAreAimedAtATarget) {
    const std::vector<Light> lights = lights_of(rig_of(fmt::format(
        R"({{{0},"position":[0,0,3],"target":[4,0,0]}},{{{0},"position":[0,0,3],"direction":[4,0,-3]}},
           {{{0},"array":{{"count":[2,1],"spacing":[2,0]}},"target":[0,0,-1]}})",
        lamp)));
    EXPECT_EQ(lights[0].frame.z, lights[1].frame.z);
    EXPECT_EQ(lights[0].frame.y, lights[1].frame.y);
    expect_at(-lights[0].frame.z, {0.8, 0, -0.6});
    // Each light of an array.
    expect_at(-lights[2].frame.z, glm::normalize(glm::dvec3(1, 0, -1)));
    expect_at(-lights[3].frame.z, glm::normalize(glm::dvec3(-1, 0, -1)));
}

TEST(RigExpand, GroupsMoveTurnAndDim) {
    const std::vector<Light> lights = lights_of(rig_of(
        fmt::format(R"({{"name":"row","position":[10,0,0],"rotate":"90deg","dimming":0.5,"maintenance":0.8,"lights":[
            {{"name":"a",{0},"position":[1,0,2],"direction":[1,0,0]}},
            {{"position":[0,1,0],"up":[1,0,0],"dimming":0.5,"lights":[{{"name":"b",{0},"position":[0,0,1],"target":[0,0,3]}}]}},
            {{"name":"c",{0},"dimming":"50%"}} ]}})",
                    lamp),
        R"("maintenance":"50%",)"));
    EXPECT_EQ(names_of(lights), (std::vector<std::string>{"row/a", "row/b", "row/c"}));
    // X of the group is Y of the rig, and Y is −X.
    expect_at(lights[0].frame.origin, {10, 1, 2});
    expect_at(-lights[0].frame.z, {0, 1, 0});
    expect_at(lights[0].frame.y, {-1, 0, 0});
    // The inner group's Z is the outer one's X, which is the rig's Y.
    expect_at(lights[1].frame.origin, {9, 1, 0});
    expect_at(-lights[1].frame.z, {0, 1, 0});
    EXPECT_DOUBLE_EQ(lights[0].intensity.value, 100.0 * 0.5 * 0.8 * 0.5);
    EXPECT_DOUBLE_EQ(lights[1].intensity.value, 100.0 * 0.5 * 0.5 * 0.8 * 0.5);
    EXPECT_DOUBLE_EQ(lights[2].intensity.value, 100.0 * 0.5 * 0.5 * 0.8 * 0.5);
}

TEST(RigExpand, CopiesOfGroupsAreNumbered) {
    const std::vector<Light> lights = lights_of(rig_of(
        fmt::format(R"({{{0}}},{{"array":{{"count":[2,1],"spacing":[4,0]}},"lights":[{{{0}}},{{"name":"x",{0}}}]}},
                              {{"lights":[{{{0}}}]}})",
                    lamp)));
    EXPECT_EQ(names_of(lights), (std::vector<std::string>{"light 1", "group 2[1,1]/light 1", "group 2[1,1]/x",
                                                          "group 2[2,1]/light 1", "group 2[2,1]/x", "light 1"}));
    expect_at(lights[3].frame.origin, {2, 0, 0});
}

// A rotated group lights the same points as its lights turned by hand.
TEST(RigExpand, TurnedGroupsLightTurnedPoints) {
    const std::string light =
        R"({"shape":"ies:street.ies","position":[0.4,0.2,3],"direction":[0.3,0.1,-1],"rotate":"20deg"})";
    const std::vector<Light> straight = lights_of(rig_of(light));
    const std::vector<Light> turned =
        lights_of(rig_of(R"({"rotate":"35deg","position":[1,-2,0.5],"lights":[)" + light + "]}"));
    const double turn = 35.0 / 180.0 * std::numbers::pi;
    for (const glm::dvec3& point : {glm::dvec3(1, 0, 0), glm::dvec3(-2, 1.5, 0.3), glm::dvec3(0.1, -3, 0)}) {
        const glm::dvec3 there(1 + std::cos(turn) * point.x - std::sin(turn) * point.y,
                               -2 + std::sin(turn) * point.x + std::cos(turn) * point.y, 0.5 + point.z);
        const Receiver here{point, {0, 0, 1}};
        const Receiver moved{there, {0, 0, 1}};
        const double lx = probe(straight, {&here, 1}).value().illuminance_lx[0];
        EXPECT_GT(lx, 0.0);
        EXPECT_NEAR(probe(turned, {&moved, 1}).value().illuminance_lx[0], lx, 1e-11 * lx);
    }
}

// Whatever emits, its light is in proportion to dimming, and at 0 it is dark.
TEST(RigExpand, DimmingScalesTheLightOfEveryShape) {
    const Receiver receiver{{0.3, 0.2, -1.5}, {0, 0, 1}};
    for (const char* shape :
         {R"("shape":"point","intensity":"800lm")",
          R"("shape":"spot:outer=60deg,mask=downlight.ies","intensity":"800lm")",
          R"("shape":"sphere:r=10cm","intensity":"11ev")", R"("shape":"rect:w=60cm,h=20cm","intensity":"5000nt")",
          R"("shape":"tube:r=2cm,l=1m","intensity":"300lx@2m")", R"("shape":"sun:angle=0.53deg","intensity":"10klx")",
          R"("shape":"ies:downlight.ies")", R"("shape":"ies:downlight.ies","intensity":"500lm")",
          R"("shape":"ies:downlight.ies,opening","intensity":"500lm")", R"("shape":"ies:downlight.ies,opening")"}) {
        const double full =
            probe(lights_of(rig_of(fmt::format("{{{}}}", shape))), {&receiver, 1}).value().illuminance_lx[0];
        const double dimmed = probe(lights_of(rig_of(fmt::format(R"({{{},"dimming":"25%"}})", shape))), {&receiver, 1})
                                  .value()
                                  .illuminance_lx[0];
        const double dark = probe(lights_of(rig_of(fmt::format(R"({{{},"dimming":0}})", shape))), {&receiver, 1})
                                .value()
                                .illuminance_lx[0];
        EXPECT_GT(full, 0.0) << shape;
        EXPECT_NEAR(dimmed, 0.25 * full, 1e-12 * full) << shape;
        EXPECT_EQ(dark, 0.0) << shape;
    }
}

// The same lights to the last bit, with the same names.
TEST(RigExpand, AnExpandedRigHasTheSameLights) {
    const std::string text = rig_of(R"({"shape":"point","intensity":"10cd","direction":[0,1,0]},
        {"luminaire":"A","positions":[[0.1,0,3],[1,0.7,3]],"rotate":"15deg","dimming":0.7,"target":[0.2,0,0]},
        {"name":"g","rotate":"33deg","up":[0.1,0,1],"position":[0.1,0.2,0.3],"maintenance":0.9,
         "array":{"count":[2,3],"spacing":[1.1,1.7]},
         "lights":[{"luminaire":"A","color":"2700K","dimming":"70%"},{"luminaire":"A","target":[1,2,-4]},
                   {"shape":"rect:w=1m,h=20cm","intensity":"3000lm","direction":[0,1,0]}]})",
                                    R"("luminaires":{"A":{"shape":"ies:street.ies","smooth":"2deg","maintenance":0.8}},
        "maintenance":0.95,"stage":"floor",)");
    const std::string expanded = expand_rig(text, "rig.json").value();
    EXPECT_EQ(expanded.find("array"), std::string::npos);
    EXPECT_EQ(expanded.find("luminaire"), std::string::npos);
    const std::vector<Light> written = lights_of(text);
    const std::vector<Light> single = lights_of(expanded);
    ASSERT_EQ(written.size(), 1U + 2U + 18U);
    ASSERT_EQ(single.size(), written.size());
    for (std::size_t i = 0; i < single.size(); ++i) {
        EXPECT_EQ(single[i].name, written[i].name);
        EXPECT_EQ(single[i].frame.origin, written[i].frame.origin);
        EXPECT_EQ(single[i].frame.z, written[i].frame.z);
        EXPECT_EQ(single[i].frame.y, written[i].frame.y);
        EXPECT_EQ(single[i].intensity, written[i].intensity);
        EXPECT_EQ(single[i].web_scale, written[i].web_scale);
        EXPECT_EQ(single[i].color, written[i].color);
    }
    EXPECT_EQ(read(expanded)->stage->name, "floor");
    EXPECT_EQ(expand_rig(expanded, "rig.json").value(), expanded);
}

TEST(RigExpand, MistakesAreNamedWithTheirPlace) {
    const auto array = [](const std::string& value) {
        return refusal(rig_of(fmt::format(R"({{{},"array":{}}})", lamp, value)));
    };
    EXPECT_EQ(array("3"), "rig.json: error[RIG0105]: lights[0].array: must be an object, not a number\n"
                          "hint: for example { \"count\": [3, 4], \"spacing\": [2.4, 1.8] }");
    EXPECT_EQ(array("{}").substr(0, 77),
              "rig.json: error[RIG0104]: lights[0].array: the key 'count' is missing\nhint: f");
    EXPECT_EQ(array(R"({"cuont":[1,1]})"), "rig.json: error[RIG0103]: lights[0].array: unknown key 'cuont'\n"
                                           "hint: did you mean 'count'? there are: count, spacing, room");
    EXPECT_EQ(array(R"({"count":[3,0],"spacing":[1,1]})"),
              "rig.json: error[RIG0106]: lights[0].array.count[1]: must be a whole number from 1, not 0");
    EXPECT_EQ(array(R"({"count":[3,1.5],"spacing":[1,1]})"),
              "rig.json: error[RIG0106]: lights[0].array.count[1]: must be a whole number from 1, not 1.5");
    EXPECT_EQ(array(R"({"count":[-3,1],"spacing":[1,1]})"),
              "rig.json: error[RIG0106]: lights[0].array.count[0]: must be a whole number from 1, not -3");
    EXPECT_EQ(array(R"({"count":4})"),
              "rig.json: error[RIG0105]: lights[0].array.count: must be an array of two or three whole numbers, "
              "not a number\nhint: along X, Y and Z, for example [3, 4] or [3, 4, 1]");
    EXPECT_EQ(array(R"({"count":[3,2]})"),
              "rig.json: error[RIG0104]: lights[0].array: the key 'spacing' is missing\nhint: metres from centre "
              "to centre, for example \"spacing\": [2.4, 1.8], or \"room\": [7.2, 7.2]");
    EXPECT_EQ(array(R"({"count":[3,2],"spacing":[2,0]})"),
              "rig.json: error[RIG0106]: lights[0].array.spacing[1]: must be greater than 0 where the count is 2");
    EXPECT_EQ(array(R"({"count":[3,2,2],"spacing":[2,1]})").substr(0, 97),
              "rig.json: error[RIG0104]: lights[0].array.spacing: has no number along Z, where the count is 2\nhi");
    EXPECT_EQ(array(R"({"count":[3,2],"spacing":[2,1],"room":[6,4]})").substr(0, 76),
              "rig.json: error[RIG0107]: lights[0].array: has both 'spacing' and 'room'\nhin");
    EXPECT_EQ(array(R"({"count":[3,2],"room":[6,-4]})"),
              "rig.json: error[RIG0106]: lights[0].array.room[1]: must be greater than 0");
    EXPECT_EQ(array(R"({"count":[3,2],"room":[6,4,3]})").substr(0, 83),
              "rig.json: error[RIG0105]: lights[0].array.room: must be an array of two numbers, no");

    EXPECT_EQ(refusal(rig_of(fmt::format(R"({{{},"position":[1,2,3],"target":[1,2,3]}})", lamp))),
              "rig.json: error[RIG0106]: lights[0].target: is at the position of 'light 1', so there is no "
              "direction to it\nhint: move one of them, or give a direction");
    EXPECT_EQ(refusal(rig_of(fmt::format(R"({{{},"direction":[1,2,3],"target":[1,2,3]}})", lamp))).substr(0, 70),
              "rig.json: error[RIG0107]: lights[0]: has both 'direction' and 'target'");
    EXPECT_EQ(refusal(rig_of(R"({"luminaire":"a"})")).substr(0, 68),
              "rig.json: error[RIG0103]: lights[0].luminaire: unknown luminaire 'a'");
    EXPECT_EQ(refusal(rig_of(R"({"luminaire":"downlihgt"})", R"("luminaires":{"downlight":{"shape":"point"}},)")),
              "rig.json: error[RIG0103]: lights[0].luminaire: unknown luminaire 'downlihgt'\n"
              "hint: did you mean 'downlight'? there are: downlight");
    EXPECT_EQ(refusal(rig_of("", R"("luminaires":{"A":{"shape":"point","position":[0,0,1]}},)")).substr(0, 69),
              "rig.json: error[RIG0106]: luminaires.A: 'position' is for a light\nhin");
    EXPECT_EQ(refusal(rig_of("", R"("luminaires":{"A":{"shpae":"point"}},)")).substr(0, 57),
              "rig.json: error[RIG0103]: luminaires.A: unknown key 'shpa");
    EXPECT_EQ(refusal(rig_of("", R"("luminaires":{"A":{"intensity":"1lm"}},)")).substr(0, 68),
              "rig.json: error[RIG0104]: luminaires.A: the key 'shape' is missing\nh");
    EXPECT_EQ(refusal(rig_of(fmt::format(R"({{{},"dimming":80}})", lamp))),
              "rig.json: error[RIG0106]: lights[0].dimming: must lie in 0 to 1, or 0% to 100%, not 80\n"
              "hint: write 0.8 or \"80%\"");
    EXPECT_EQ(refusal(rig_of(fmt::format(R"({{{},"dimming":"half"}})", lamp))),
              "rig.json: error[RIG0106]: lights[0].dimming: does not take 'half'\nhint: write 0.8 or \"80%\"");
    EXPECT_EQ(refusal(rig_of(fmt::format(R"({{{},"maintenance":0}})", lamp))).substr(0, 74),
              "rig.json: error[RIG0106]: lights[0].maintenance: must be greater than 0\nhi");
    EXPECT_EQ(refusal(rig_of(fmt::format(R"({{"lights":[{{{}}}],"shape":"point"}})", lamp))).substr(0, 68),
              "rig.json: error[RIG0107]: lights[0]: has both 'lights' and 'shape'\nh");
    EXPECT_EQ(refusal(rig_of(R"({"lights":[]})")).substr(0, 71),
              "rig.json: error[RIG0104]: lights[0].lights: must be an array of at leas");
    EXPECT_EQ(refusal(rig_of(fmt::format(R"({{"lights":[{{{}}},{{"shape":"pont"}}]}})", lamp))).substr(0, 60),
              "rig.json: error[RIG0103]: lights[0].lights[1].shape: unknown");
    EXPECT_EQ(refusal(rig_of(fmt::format(R"({{{},"positions":[[0,0,1],[0,1]]}})", lamp))).substr(0, 92),
              "rig.json: error[RIG0105]: lights[0].positions: position 2 must be an array of three numbers,");
    EXPECT_EQ(
        refusal(rig_of(fmt::format(R"({{"position":[1e100,0,0],"lights":[{{{},"position":[1e100,0,0]}}]}})", lamp)))
            .substr(0, 56),
        "rig.json: error[RIG0106]: lights[0].lights[0]: places 'l");
}

// A light that cannot be resolved is named by its place, not by its number after expansion.
TEST(RigExpand, LightsThatCannotBeResolvedHaveTheirPlace) {
    Rig rig = read(rig_of(R"({"shape":"point","intensity":"1cd","array":{"count":[2,2],"spacing":[1,1]}},
        {"lights":[{"shape":"point","intensity":"1cd"},{"shape":"point"}]},{"shape":"point"})"))
                  .value();
    Diagnostics diagnostics;
    EXPECT_EQ(resolve_lights(rig, diagnostics, 1).error().diagnostics.back().message,
              "lights[1].lights[1]: a point light needs an intensity");
    rig.lights.erase(rig.lights.begin() + 5);
}

// A few bytes do not make more lights than the limits allow, whatever is multiplied.
TEST(RigExpand, CountsAreBounded) {
    const auto nested = [](const std::string& count) {
        const std::string array = fmt::format(R"("array":{{"count":{},"spacing":[1,1,1]}})", count);
        return rig_of(
            fmt::format(R"({{{1},"lights":[{{{1},"lights":[{{{1},"lights":[{{{1},{0}}}]}}]}}]}})", lamp, array));
    };
    const std::string beyond = "makes more than 262144 lights, the limit 'rig-array'";
    EXPECT_NE(refusal(nested("[262144,262144,262144]")).find(beyond), std::string::npos);
    EXPECT_NE(refusal(nested("[100,100,100]")).find(beyond), std::string::npos);
    EXPECT_NE(refusal(nested("[262145,1]")).find(beyond), std::string::npos);
    EXPECT_NE(refusal(nested("[1e300,1]")).find(beyond), std::string::npos);
    EXPECT_EQ(lights_of(nested("[3,2,1]")).size(), 1296U);
    // All together.
    std::string several;
    for (int i = 0; i < 5; ++i)
        several += fmt::format(R"({}{{{},"array":{{"count":[256,256],"spacing":[1,1]}}}})", i > 0 ? "," : "", lamp);
    EXPECT_NE(refusal(rig_of(several)).find("lights[4]: " + beyond), std::string::npos);
}

} // namespace
} // namespace gonio
