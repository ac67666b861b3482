// Composition of USD: which opinion holds, files that are missing or hostile, cycles, archives.
#include <gonio/interchange/detail/usda.hpp>

#include "../archives.hpp"
#include "../luminaires.hpp"
#include "scenes.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using test::code_of;
using test::has_remark;
using test::number_of;

using Files = std::map<std::string, std::string>;

std::string layer(const std::string& prims, const std::string& metadata = {}) {
    return "#usda 1.0\n(\n    metersPerUnit = 1\n    upAxis = \"Z\"\n" + metadata + ")\n" + prims;
}

SceneReadOptions with(const Files& files) {
    SceneReadOptions options;
    options.read_beside = [files](const std::string& name) -> Result<std::string> {
        const auto found = files.find(name);
        if (found == files.end()) return fail("FIL0101", "there is no such file", {}, name);
        return found->second;
    };
    return options;
}

FoundScene composed(const std::string& text, const Files& files = {}) {
    Result<FoundScene> scene = read_scene_lights(text, "scene.usda", with(files));
    EXPECT_TRUE(scene.has_value()) << (scene ? std::string() : to_text(scene.error().diagnostics.back()));
    return scene ? std::move(*scene) : FoundScene{};
}

std::string code(const std::string& text, const Files& files = {}) {
    return code_of(read_scene_lights(text, "scene.usda", with(files)));
}

// The intensity of the only light.
double only(const FoundScene& scene) {
    EXPECT_EQ(scene.lights.size(), 1U);
    return scene.lights.size() == 1 ? number_of(scene.lights[0]) : -1.0;
}

std::string rect(const std::string& name, int nits, const std::string& metadata = {}) {
    return fmt::format("def RectLight \"{}\" {} {{ float inputs:intensity = {} }}\n", name, metadata, nits);
}

TEST(UsdComposition, SublayersTheStrongestFirst) {
    const Files files{{"a.usda", layer(rect("lamp", 1) + rect("more", 7))}, {"b.usda", layer(rect("lamp", 2))}};
    const std::string both = "    subLayers = [ @a.usda@, @./b.usda@ (offset = 3) ]\n";
    const FoundScene scene = composed(layer("", both), files);
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(number_of(scene.lights[0]), 1.0);
    EXPECT_EQ(number_of(scene.lights[1]), 7.0);
    EXPECT_EQ(scene.lights[1].location.file, "a.usda");
    const FoundScene over = composed(layer("over \"lamp\" { float inputs:intensity = 5 }\n", both), files);
    EXPECT_EQ(number_of(over.lights[0]), 5.0);
    EXPECT_TRUE(over.lights[0].is_converted()); // an override of a prim that is defined
    // None hides what weaker layers say.
    const FoundScene blocked = composed(layer("over \"lamp\" { float inputs:intensity = None }\n", both), files);
    EXPECT_EQ(number_of(blocked.lights[0]), 1.0); // the schema's default
    const FoundScene off = composed(layer("over \"lamp\" ( active = false ) { }\n", both), files);
    EXPECT_TRUE(has_remark(off.lights[0], "SCN0204"));
}

TEST(UsdComposition, ReferencesToFilesAndWithin) {
    const Files files{{"lib/lamp.usda", layer("def Xform \"Lamp\" {\n" + rect("bulb", 3) +
                                                  "}\ndef Xform \"Other\" {\n" + rect("bulb", 4) + "}\n",
                                              "    defaultPrim = \"Lamp\"\n")}};
    EXPECT_EQ(only(composed(layer("def \"a\" ( references = @lib/lamp.usda@ ) { }"), files)), 3.0);
    EXPECT_EQ(only(composed(layer("def \"a\" ( prepend references = [@./lib/lamp.usda@</Other>] ) { }"), files)), 4.0);
    EXPECT_EQ(only(composed(layer("def \"a\" ( payload = @lib/lamp.usda@</Other/bulb> ) { }"), files)), 4.0);
    const FoundScene placed = composed(layer(R"(def Xform "a" ( references = @lib/lamp.usda@ ) {
    double3 xformOp:translate = (1, 2, 3)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    over "bulb" { float inputs:width = 2 }
})"),
                                       files);
    EXPECT_EQ(only(placed), 3.0);
    EXPECT_EQ(placed.lights[0].place, "/a/bulb");
    EXPECT_EQ(placed.lights[0].position.z, 3.0);
    EXPECT_EQ(std::get<RectShape>(*placed.lights[0].shape).width.value, 2.0);
    // Twice the same, in two places, and one that is referred to within the layer.
    const FoundScene two = composed(layer("def \"a\" ( references = @lib/lamp.usda@ ) { }\n"
                                          "def \"b\" ( references = @lib/lamp.usda@ ) { }\n"
                                          "def \"c\" ( references = </a> ) { }\n"),
                                    files);
    ASSERT_EQ(two.lights.size(), 3U);
    EXPECT_EQ(two.lights[2].place, "/c/bulb");
    // A direct reference is stronger than what the parent's brought, the first of a list than the second.
    const Files strong{{"a.usda", layer("def \"A\" { def \"x\" {} \n" + rect("x", 1) + "}\n" + rect("B", 2))}};
    EXPECT_EQ(
        only(composed(
            layer("def \"p\" ( references = @a.usda@</A> ) { def RectLight \"x\" ( references = @a.usda@</B> ) {} }"),
            strong)),
        2.0);
    EXPECT_EQ(only(composed(
                  layer("def \"a\" ( references = [ @lib/lamp.usda@</Lamp/bulb>, @lib/lamp.usda@</Other/bulb> ] ) { }"),
                  files)),
              3.0);
}

TEST(UsdComposition, ListsAreEdited) {
    const Files files{{"lamps.usda", layer(rect("a", 1) + rect("b", 2))},
                      {"weak.usda", layer("def \"x\" ( prepend references = @lamps.usda@</a> ) { }")}};
    const std::string sub = "    subLayers = [ @weak.usda@ ]\n";
    EXPECT_EQ(only(composed(layer("", sub), files)), 1.0);
    EXPECT_EQ(only(composed(layer("over \"x\" ( prepend references = @lamps.usda@</b> ) { }", sub), files)), 2.0);
    EXPECT_EQ(only(composed(layer("over \"x\" ( references = @lamps.usda@</b> ) { }", sub), files)), 2.0);
    EXPECT_TRUE(composed(layer("over \"x\" ( references = None ) { }", sub), files).lights.empty());
    EXPECT_TRUE(composed(layer("over \"x\" ( delete references = @lamps.usda@</a> ) { }", sub), files).lights.empty());
}

TEST(UsdComposition, ListsArePrependedAndAppended) {
    // Both say how bright it is, the first of the list wins.
    const Files files{
        {"lamps.usda", layer(rect("a", 1) + rect("b", 2) + rect("c", 3))},
        {"sub/weak.usda", layer("def \"x\" ( prepend references = @../lamps.usda@</a> ) { }")},
        {"back.usda", layer("def \"x\" ( append references = [ @lamps.usda@</a>, @lamps.usda@</b> ] ) { }")}};
    const auto over = [&](const std::string& below, const std::string& edits) {
        return only(
            composed(layer("over \"x\" ( " + edits + " ) { }", "    subLayers = [ @" + below + "@ ]\n"), files));
    };
    EXPECT_EQ(over("sub/weak.usda", "append references = @lamps.usda@</b>"), 1.0);
    EXPECT_EQ(over("sub/weak.usda", "add references = @lamps.usda@</b>"), 1.0);
    EXPECT_EQ(over("sub/weak.usda", "prepend references = @lamps.usda@</b>"), 2.0);
    EXPECT_EQ(over("back.usda", ""), 1.0);
    // What is listed already moves, but for what is added.
    EXPECT_EQ(over("back.usda", "append references = @lamps.usda@</a>"), 2.0);
    EXPECT_EQ(over("back.usda", "add references = @lamps.usda@</a>"), 1.0);
    EXPECT_EQ(over("back.usda", "prepend references = @lamps.usda@</b>"), 2.0);
    EXPECT_EQ(over("back.usda", "prepend references = [ @lamps.usda@</c>, @lamps.usda@</b> ]"), 3.0);
    EXPECT_EQ(over("back.usda", "delete references = @lamps.usda@</a> append references = @lamps.usda@</c>"), 2.0);
    EXPECT_EQ(over("back.usda", "references = @lamps.usda@</c>"), 3.0);
    // The same file by another path.
    EXPECT_TRUE(composed(layer("over \"x\" ( delete references = @lamps.usda@</a> ) { }",
                               "    subLayers = [ @sub/weak.usda@ ]\n"),
                         files)
                    .lights.empty());
}

TEST(UsdComposition, InheritsVariantsSpecializes) {
    const std::string classes = "class \"_lamp\" { float inputs:intensity = 8 float inputs:height = 3 }\n";
    EXPECT_EQ(only(composed(layer(classes + "def RectLight \"a\" ( inherits = </_lamp> ) { }"))), 8.0);
    EXPECT_EQ(
        only(composed(layer(classes + "def RectLight \"a\" ( inherits = </_lamp> ) { float inputs:intensity = 1 }"))),
        1.0);
    EXPECT_EQ(only(composed(layer("def \"_weak\" { float inputs:intensity = 9 } def RectLight \"a\" ( specializes = "
                                  "</_weak> inherits = </_lamp> ) { } " +
                                  classes))),
              8.0);
    const std::string sets = R"(def RectLight "a" (
    variants = { string tone = "warm" }
    prepend variantSets = "tone"
) {
    float inputs:exposure = 0
    variantSet "tone" = {
        "cold" { float inputs:intensity = 1 }
        "warm" ( apiSchemas = ["ShapingAPI"] ) {
            float inputs:intensity = 2
            variantSet "deep" = { "yes" { float inputs:height = 5 } }
        }
    }
}
)";
    const FoundScene warm = composed(layer(sets));
    EXPECT_EQ(only(warm), 2.0);
    ASSERT_EQ(warm.diagnostics.size(), 1U); // the inner set has no selection
    EXPECT_EQ(warm.diagnostics[0].code, "SCN0201");
    // A stronger layer selects another.
    const Files files{{"sets.usda", layer(sets)}};
    EXPECT_EQ(only(composed(layer("over \"a\" ( variants = { string tone = \"cold\" string deep = \"yes\" } ) { }",
                                  "    subLayers = [ @sets.usda@ ]\n"),
                            files)),
              1.0);
    EXPECT_EQ(
        only(composed(layer("def \"b\" ( references = @sets.usda@</a> variants = { string \"tone\" = \"cold\" } ) { }"),
                      files)),
        1.0);
    // A variant that refers to a file, with a light in it.
    const Files lamps{{"l.usda", layer("def \"L\" {\n" + rect("x", 6) + "}\n")}};
    EXPECT_EQ(only(composed(layer("def \"a\" ( variants = { string v = \"on\" } ) { variantSet \"v\" = { \"on\" ( "
                                  "references = @l.usda@</L> ) { } \"off\" { } } }"),
                            lamps)),
              6.0);
}

TEST(UsdComposition, TimesAreThoseOfTheScene) {
    const Files files{
        {"moving.usda", layer("def RectLight \"a\" { float inputs:intensity.timeSamples = { 0: 1, 10: 11 } }\n")}};
    SceneReadOptions options = with(files);
    options.time = 110.0;
    const std::string text = layer("def \"b\" ( references = @moving.usda@</a> (offset = 100; scale = 2) ) { }");
    const Result<FoundScene> scene = read_scene_lights(text, "scene.usda", options);
    ASSERT_TRUE(scene.has_value());
    EXPECT_EQ(only(*scene), 6.0); // its time 5
}

TEST(UsdComposition, TimesBeyondNumbersAreRefused) {
    const auto chain = [](const std::string& last) {
        std::string text;
        for (int i = 0; i < 4; ++i)
            text += fmt::format("def \"s{}\" ( references = </s{}> (scale = 1e100) ) {{}}\n", i, i + 1);
        return layer(text + "def RectLight \"s4\" { float inputs:intensity.timeSamples = { " + last + " } }\n");
    };
    EXPECT_EQ(code(chain("0: 5")), "SCN0105");
    const std::string twice = "    subLayers = [ @a.usda@ (scale = 1e100) ]\n";
    const Files files{{"a.usda", layer("", "    subLayers = [ @b.usda@ (scale = 1e100) ]\n")},
                      {"b.usda", layer("", "    subLayers = [ @c.usda@ (scale = 1e100) ]\n")},
                      {"c.usda", layer("", "    subLayers = [ @d.usda@ (scale = 1e100) ]\n")},
                      {"d.usda", layer("")}};
    EXPECT_EQ(code(layer("", twice), files), "SCN0105");
    // Samples at times that are none of the scene, and all at once.
    for (const std::string scale : {"1e100", "-1e100", "0"})
        for (const double time : {-1e308, 0.0, 3.0, 1e308}) {
            SceneReadOptions options;
            options.time = time;
            const Result<FoundScene> scene = read_scene_lights(
                layer(
                    "def \"a\" ( references = </b> (offset = -1e100; scale = " + scale +
                    ") ) {}\nclass RectLight \"b\" { float inputs:intensity.timeSamples = { 1e308: 5, -1e308: 5 } }\n"),
                "scene.usda", options);
            ASSERT_TRUE(scene.has_value()) << scale;
            ASSERT_EQ(scene->lights.size(), 2U);
            EXPECT_EQ(number_of(scene->lights[0]), 5.0) << scale << " at " << time;
        }
}

TEST(UsdComposition, WarningsAreCounted) {
    std::string many;
    for (int i = 0; i < 45; ++i)
        many += fmt::format("def \"a{0}\" ( references = @gone{0}.usda@</a> ) {{ }}\n", i);
    many += "def \"v\" { variantSet \"s\" = { \"x\" { } } }\n";
    const FoundScene scene = composed(layer(many + rect("lamp", 2)));
    ASSERT_EQ(scene.diagnostics.size(), 21U);
    EXPECT_EQ(scene.diagnostics[19].code, "SCN0107");
    EXPECT_TRUE(scene.diagnostics[19].message.ends_with(" (and 25 more)")) << scene.diagnostics[19].message;
    EXPECT_EQ(scene.diagnostics[20].code, "SCN0201"); // those of other codes have their own count
}

TEST(UsdComposition, WhatIsMissingIsSaid) {
    const Files files{{"binary.usd", "PXR-USDC and more"},
                      {"text.usda", "hello"},
                      {"units.usda", "#usda 1.0\ndef RectLight \"a\" {}\n"},
                      {"nothing.usda", layer("")}};
    for (const std::string of : {"@gone.usda@</a>", "@binary.usd@</a>", "@text.usda@</a>", "@nothing.usda@",
                                 "@nothing.usda@</a>", "@`\"${LAMP}\"`@", "</gone>", "<../relative>"}) {
        const FoundScene scene =
            composed(layer("def \"x\" ( references = " + of + " ) { }\n" + rect("lamp", 2)), files);
        EXPECT_EQ(scene.lights.size(), 1U) << of;
        ASSERT_EQ(scene.diagnostics.size(), 1U) << of;
        EXPECT_EQ(scene.diagnostics[0].code, "SCN0107") << of;
        EXPECT_EQ(scene.diagnostics[0].location.line, 6U) << of;
    }
    const FoundScene units = composed(layer("def \"x\" ( references = @units.usda@</a> ) { }"), files);
    ASSERT_EQ(units.diagnostics.size(), 1U);
    EXPECT_EQ(units.diagnostics[0].code, "SCN0201");
    EXPECT_EQ(
        code(layer("def \"x\" ( references = @broken.usda@</a> ) { }"), {{"broken.usda", "#usda 1.0\ndef \"a\" {"}}),
        "SCN0102");
}

TEST(UsdComposition, CyclesAreRefused) {
    EXPECT_EQ(code(layer("def \"a\" ( references = </a> ) { }")), "SCN0104");
    EXPECT_EQ(code(layer("def \"a\" ( inherits = </b> ) { } def \"b\" ( inherits = </a> ) { }")), "SCN0104");
    EXPECT_EQ(code(layer("def \"a\" { def \"b\" ( references = </a> ) { } }")), "SCN0104");
    EXPECT_EQ(code(layer("def \"a\" ( references = </a/b> ) { def \"b\" {} }")), "SCN0104");
    EXPECT_EQ(
        code(layer("", "    subLayers = [ @a.usda@ ]\n"), {{"a.usda", layer("", "    subLayers = [ @a.usda@ ]\n")}}),
        "SCN0104");
    EXPECT_EQ(code(layer("def \"a\" ( references = @b.usda@</b> ) { }"),
                   {{"b.usda", layer("def \"b\" ( references = @scene.usda@</a> ) { }")}}),
              "SCN0104");
    EXPECT_EQ(
        code(layer(
            "def \"a\" { def \"x\" ( references = </b> ) { } } def \"b\" { def \"y\" ( references = </a> ) { } }")),
        "SCN0108");
}

TEST(UsdComposition, BombsAreRefused) {
    // Each level has ten times the prims of the one before, or is composed of twice as many.
    std::string wide;
    std::string deep;
    for (int level = 0; level < 40; ++level) {
        wide += fmt::format("def \"w{}\" {{\n", level);
        for (int i = 0; i < 10; ++i)
            wide += fmt::format("def \"c{}\" ( references = </w{}> ) {{ }}\n", i, level + 1);
        wide += "}\n";
        deep += fmt::format("def \"d{0}\" ( references = [</d{1}>, </e{1}>] ) {{ }}\n"
                            "def \"e{0}\" ( references = [</d{1}>, </e{1}>] ) {{ }}\n",
                            level, level + 1);
    }
    EXPECT_EQ(code(layer(wide + "def \"w40\" {}\n")), "SCN0108");
    EXPECT_EQ(code(layer(deep + "def \"d40\" {} def \"e40\" {}\n")), "SCN0108");
    Files many;
    std::string all;
    for (int i = 0; i < 1100; ++i) {
        many[fmt::format("l{}.usda", i)] = layer("");
        all += fmt::format("def \"a{0}\" ( references = @l{0}.usda@</a> ) {{ }}\n", i);
    }
    EXPECT_EQ(code(layer(all), many), "SCN0108");
}

// Short files that name the same long list, chain or name again and again.
TEST(UsdComposition, RepetitionIsSharedOrRefused) {
    std::string references;
    for (int i = 0; i < 3000; ++i)
        references += fmt::format("def \"r{}\" ( references = </Q> ) {{}}\n", i);
    // Values are shared.
    Result<interchange_detail::UsdStage> stage = interchange_detail::compose_usd(
        layer("class RectLight \"Q\" { float inputs:intensity = 4 }\n" + references), "scene.usda", {});
    ASSERT_TRUE(stage.has_value());
    ASSERT_EQ(stage->layer.prims.size(), 3001U);
    const interchange_detail::UsdStage moved = std::move(*stage);
    const auto first = moved.layer.prims[1].find("inputs:intensity");
    const auto last = moved.layer.prims[3000].find("inputs:intensity");
    ASSERT_TRUE(first && last);
    EXPECT_EQ(first->said, last->said);
    EXPECT_EQ(first->said->value.numbers, std::vector<double>{4.0});
    // Names and lists that are copied.
    const std::string longest(100000, 'n');
    EXPECT_EQ(code(layer("class \"Q\" { def \"" + longest + "\" {} }\n" + references)), "SCN0108");
    EXPECT_EQ(code(layer("class \"Q\" ( apiSchemas = [\"" + longest + "\"] ) {}\n" + references)), "SCN0108");
    std::string schemas;
    for (int i = 0; i < 50000; ++i)
        schemas += fmt::format("\"{}\",", i);
    EXPECT_EQ(code(layer("class \"Q\" ( apiSchemas = [" + schemas + "] ) {}\n" + references)), "SCN0108");
    // Lists that are gone through.
    std::string gone;
    for (int i = 0; i < 30000; ++i)
        gone += fmt::format("</g{}>,", i);
    EXPECT_EQ(code(layer("class \"Q\" ( delete references = [" + gone + "] ) {}\n" + references)), "SCN0108");
    // Each path is composed of 4096 prims, and is only referred to.
    std::string chain;
    for (int level = 0; level < 12; ++level)
        chain += fmt::format("def \"d{0}\" ( references = [</d{1}>, </e{1}>] ) {{ }}\n"
                             "def \"e{0}\" ( references = [</d{1}>, </e{1}>] ) {{ }}\n",
                             level, level + 1);
    chain += "def \"d12\" {} def \"e12\" {}\n";
    std::string paths;
    for (int i = 0; i < 700; ++i)
        paths += fmt::format("def \"r{0}\" ( references = </p{0}/x> ) {{}}\n", i);
    std::string middle;
    for (int i = 0; i < 700; ++i)
        middle += fmt::format("over \"p{}\" ( references = </d1> ) {{}}\n", i);
    EXPECT_EQ(code(layer(paths + middle + chain)), "SCN0108");
    // Paths.
    std::string folders;
    for (int i = 0; i < 3000; ++i)
        folders += "a/";
    EXPECT_EQ(code(layer("def \"a\" ( references = @" + folders + "b.usda@ ) {}\n")), "SCN0108");
    EXPECT_EQ(code(layer("def \"a\" ( references = </" + folders + "b> ) {}\n")), "SCN0108");
    EXPECT_EQ(code(layer("", "    defaultPrim = \"" + folders + "\"\n")), "SCN0108");
}

// Arcs of a variant do not replace those of another set.
TEST(UsdComposition, SetsOfVariantsHaveTheirOwnArcs) {
    const FoundScene scene = composed(layer("class \"one\" {\n" + rect("p", 1) + rect("both", 2) +
                                            "}\nclass \"two\" {\n" + rect("q", 3) + rect("both", 4) + R"(}
def "a" ( variants = { string s = "x" string t = "y" } ) {
    variantSet "s" = { "x" ( append references = </one> ) { } }
    variantSet "t" = { "y" ( references = </two> ) { } }
}
)"));
    std::map<std::string, double> found;
    for (const FoundLight& light : scene.lights)
        if (light.place.starts_with("/a/")) found[light.place] = number_of(light);
    EXPECT_EQ(found, (std::map<std::string, double>{{"/a/both", 2.0}, {"/a/p", 1.0}, {"/a/q", 3.0}}));
}

// One of thousands of variants, by its name.
TEST(UsdComposition, ManyVariants) {
    std::string sets;
    for (int i = 0; i < 5000; ++i)
        sets += fmt::format("\"v{0}\" {{ float inputs:intensity = {0} }}\n", i);
    sets = "class RectLight \"Q\" { variantSet \"s\" = {\n" + sets + "} }\n";
    for (int i = 0; i < 2000; ++i)
        sets += fmt::format("def \"r{0}\" ( references = </Q> variants = {{ string s = \"v{0}\" }} ) {{}}\n", i);
    const FoundScene scene = composed(layer(sets));
    ASSERT_EQ(scene.lights.size(), 2001U);
    EXPECT_EQ(number_of(scene.lights[1]), 0.0);
    EXPECT_EQ(number_of(scene.lights[1778]), 1777.0);
    EXPECT_EQ(scene.diagnostics.size(), 1U); // the class has no selection
}

TEST(UsdComposition, Archives) {
    const std::string scene = layer(R"(def "lamp" ( references = @./lib/lamp.usda@</Lamp> ) { }
def "out" ( references = @../../secret.usda@</Lamp> ) { }
)");
    const std::string lamp = layer(R"(def SphereLight "Lamp" ( apiSchemas = ["ShapingAPI"] ) {
    bool treatAsPoint = true
    asset inputs:shaping:ies:file = @../profiles/half.ies@
})");
    const std::string bytes = write_archive(std::array<ArchiveFile, 3>{
        {{"scene.usda", scene}, {"lib/lamp.usda", lamp}, {"profiles/half.ies", test::half_sphere()}}});
    FoundScene found = composed(bytes);
    EXPECT_EQ(found.format, "usd");
    ASSERT_EQ(found.lights.size(), 1U);
    ASSERT_EQ(found.profiles.size(), 1U);
    EXPECT_EQ(found.profiles[0].name, "half");
    load_scene_profiles(found, {});
    EXPECT_TRUE(found.lights[0].is_converted());
    ASSERT_EQ(found.diagnostics.size(), 1U); // what leads out
    EXPECT_EQ(found.diagnostics[0].code, "SCN0107");
    // A scene that refers to such an archive.
    const std::string whole = write_archive(std::array<ArchiveFile, 2>{
        {{"a.usda", layer("def \"A\" { def \"b\" ( references = @b.usda@</x> ) {} }", "    defaultPrim = \"A\"\n")},
         {"b.usda", layer(rect("x", 4))}}});
    EXPECT_EQ(only(composed(layer("def \"r\" ( references = @lamp.usdz@ ) { }"), {{"lamp.usdz", whole}})), 4.0);
    EXPECT_EQ(code(write_archive(std::array{ArchiveFile{"a.usdc", "PXR-USDC"}})), "SCN0101");
    EXPECT_EQ(code(bytes.substr(0, bytes.size() - 3)), "ARC0101");
}

TEST(UsdComposition, ProfilesAreBesideTheirLayer) {
    const Files files{{"lib/lamp.usda", layer(R"(def SphereLight "Lamp" ( apiSchemas = ["ShapingAPI"] ) {
    asset inputs:shaping:ies:file = @half.ies@
})")},
                      {"lib/half.ies", test::half_sphere()}};
    FoundScene scene = composed(layer("def \"a\" ( references = @lib/lamp.usda@</Lamp> ) { }"), files);
    load_scene_profiles(scene, with(files));
    ASSERT_EQ(scene.lights.size(), 1U);
    ASSERT_TRUE(scene.lights[0].is_converted());
    EXPECT_EQ(std::get<ProfileShape>(*scene.lights[0].shape).file, "lib/half.ies");
}

} // namespace

} // namespace gonio
