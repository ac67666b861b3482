// Lights of luminaires and stage fixtures: GLDF and GDTF.
#include "../luminaires.hpp"

#include <gonio/web/integrate.hpp>
#include <gonio/web/web.hpp>

#include "../archives.hpp"
#include "scenes.hpp"

#include <glm/geometric.hpp>

#include <numbers>
#include <string>

namespace gonio {

namespace {

using std::numbers::pi;
using test::failure_of;
using test::gdtf_of;
using test::gldf_of;
using test::has_remark;
using test::number_of;
using test::replaced;
using test::scene_of;
using test::unit_of;

TEST(InterchangeGldf, EmittersOfAVariantAreLights) {
    FoundScene first = scene_of(gldf_of(test::product()));
    EXPECT_EQ(first.format, "gldf");
    ASSERT_EQ(first.lights.size(), 1U);
    ASSERT_EQ(first.diagnostics.size(), 1U); // which variant
    EXPECT_EQ(first.diagnostics[0].code, "SCN0201");
    const FoundLight& down = first.lights[0];
    EXPECT_EQ(down.name, "below");
    EXPECT_EQ(number_of(down), 500.0);
    EXPECT_EQ(unit_of(down), "lm");
    EXPECT_EQ(down.temperature->value, 3000.0);
    EXPECT_TRUE(has_remark(down, "SCN0201")); // its photometry has 628 lm
    load_scene_profiles(first, {});
    ASSERT_TRUE(first.lights[0].shape.has_value());
    EXPECT_NEAR(flux(*std::get<ProfileShape>(*first.lights[0].shape).web).value, 200.0 * pi, 1e-9);
    EXPECT_EQ(first.profiles[0].ending, "ies");

    SceneReadOptions options;
    options.variant = "v2";
    const FoundScene second = scene_of(gldf_of(test::product()), options);
    ASSERT_EQ(second.lights.size(), 2U);
    const FoundLight& up = second.lights[0];
    EXPECT_NEAR(number_of(up), 100.0 * pi * 0.8, 1e-9); // its lamps have 800 lm, the file's 1000 lm
    EXPECT_LT(glm::distance(up.direction, glm::dvec3(0.0, 0.0, 1.0)), 1e-12);
    EXPECT_FALSE(second.lights[1].is_converted());
    EXPECT_TRUE(has_remark(second.lights[1], "SCN0204")); // in an emergency only
    options.variant = "none of them";
    EXPECT_EQ(test::code_of(read_scene_lights(gldf_of(test::product()), "scene", options)), "USE0103");
}

TEST(InterchangeGldf, TheColourIsThatOfTheSpectrum) {
    EXPECT_TRUE(has_remark(scene_of(gldf_of(test::product())).lights[0], "SCN0202")); // of two wavelengths
    std::string red;
    for (int nm = 380; nm <= 780; nm += 5)
        red += "<Intensity wavelength=\"" + std::to_string(nm) + "\">" + (nm < 600 ? "0.1" : "1") + "</Intensity>";
    const FoundScene scene = scene_of(gldf_of(
        replaced(test::product(),
                 "<Intensity wavelength=\"400\">0.5</Intensity><Intensity wavelength=\"700\">1</Intensity>", red)));
    const FoundLight& light = scene.lights[0];
    EXPECT_FALSE(has_remark(light, "SCN0202"));
    EXPECT_GT(light.color.x, 2.0 * light.color.y);
    EXPECT_EQ(light.temperature->value, 3000.0);
}

TEST(InterchangeGldf, WhatCannotBeReadIsListed) {
    const FoundScene told = scene_of(gldf_of(replaced(test::product(), "emitterId=\"down\"", "emitterId=\"told\"")));
    ASSERT_EQ(told.lights.size(), 1U);
    EXPECT_FALSE(told.lights[0].is_converted());
    EXPECT_TRUE(has_remark(told.lights[0], "SCN0203"));
    const FoundScene broken = scene_of(gldf_of(test::product(), "nothing"));
    EXPECT_TRUE(has_remark(broken.lights[0], "SCN0107"));
    EXPECT_EQ(failure_of(write_archive(std::array{ArchiveFile{"a.txt", "text"}})).code, "SCN0101");
    EXPECT_EQ(failure_of(gldf_of(test::product()).substr(0, 500)).code, "ARC0101");
}

// A profile goes to where its file of factors does not.
TEST(InterchangeGldf, FactorsOfTiltGoIntoTheProfile) {
    const std::string tilted = replaced(test::half_sphere(), "TILT=NONE", "TILT=t.tlt");
    const FoundScene scene = scene_of(write_archive(
        std::array{ArchiveFile{"product.xml", test::product()}, ArchiveFile{"ldc/a.ies", tilted},
                   ArchiveFile{"ldc/b.ies", test::half_sphere()}, ArchiveFile{"ldc/t.tlt", "1\n2\n0 90\n1 0.5\n"}}));
    ASSERT_EQ(scene.profiles.size(), 1U);
    EXPECT_NE(scene.profiles[0].bytes.find("TILT=INCLUDE"), std::string::npos);
}

TEST(InterchangeGldf, AVariantIsChosenByIdentifierBeforeName) {
    SceneReadOptions options;
    options.variant = "v2";
    EXPECT_EQ(scene_of(gldf_of(replaced(test::product(), ">one<", ">v2<")), options).lights.size(), 2U);
}

TEST(InterchangeGldf, ManyFilesOfOneEntryAreOneProfile) {
    const std::string xml = replaced(replaced(test::product(), "photometryId=\"p1\"/>",
                                              "photometryId=\"p1\"/></FixedLightEmitter>"
                                              "<FixedLightEmitter><PhotometryReference photometryId=\"p2\"/>"),
                                     ">b.ies<", ">a.ies<");
    const FoundScene scene = scene_of(gldf_of(xml));
    EXPECT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.profiles.size(), 1U);
}

// A yoke at 2 m with a beam half a metre below it, turned to shine along +X.
std::string fixture(const std::string& beam, const std::string& channels = {}) {
    return "<GDTF DataVersion=\"1.2\"><FixtureType Name=\"Spot\" Manufacturer=\"Works\"><Geometries>"
           "<Geometry Name=\"Base\"><Axis Name=\"Yoke\" Position=\"{1,0,0,0}{0,1,0,0}{0,0,1,2}{0,0,0,1}\">"
           "<Beam Name=\"Lens\" Position=\"{0,0,-1,0}{0,1,0,0}{1,0,0,-0.5}{0,0,0,1}\" " +
           beam + "/></Axis></Geometry></Geometries><DMXModes><DMXMode Name=\"Basic\" Geometry=\"Base\"><DMXChannels>" +
           channels +
           "</DMXChannels></DMXMode><DMXMode Name=\"Other\" Geometry=\"Base\"/></DMXModes></FixtureType></GDTF>";
}

constexpr const char* stated =
    R"(LuminousFlux="8000" ColorTemperature="6500" BeamAngle="20" FieldAngle="40" BeamRadius="0.1" BeamType="Spot")";

std::string zoom(const std::string& from, const std::string& to) {
    return "<DMXChannel Geometry=\"Yoke\"><LogicalChannel Attribute=\"Zoom\"><ChannelFunction Attribute=\"Zoom\" "
           "PhysicalFrom=\"" +
           from + "\" PhysicalTo=\"" + to + "\"/></LogicalChannel></DMXChannel>";
}

TEST(InterchangeGdtf, ABeamIsAProfileThroughItsAngles) {
    FoundScene scene = scene_of(gdtf_of(fixture(stated)));
    EXPECT_EQ(scene.format, "gdtf");
    ASSERT_EQ(scene.lights.size(), 1U);
    load_scene_profiles(scene, {});
    const FoundLight& light = scene.lights[0];
    EXPECT_EQ(light.name, "Lens");
    EXPECT_EQ(light.place, "Base/Yoke/Lens");
    EXPECT_EQ(number_of(light), 8000.0);
    EXPECT_LT(glm::distance(light.position, glm::dvec3(0.0, 0.0, 1.5)), 1e-12);
    EXPECT_LT(glm::distance(light.direction, glm::dvec3(1.0, 0.0, 0.0)), 1e-12);
    const Web& web = *std::get<ProfileShape>(*light.shape).web;
    const double peak = web.candela(0.0, 0.0);
    EXPECT_NEAR(web.candela(0.0, 10.0) / peak, 0.5, 1e-3);
    EXPECT_NEAR(web.candela(0.0, 20.0) / peak, 0.1, 1e-3);
    EXPECT_EQ(web.candela(0.0, 89.0), 0.0);
    EXPECT_FALSE(light.zoom);
}

TEST(InterchangeGdtf, ZoomKeepsTheFluxAndScalesTheAngles) {
    const std::string bytes = gdtf_of(fixture(stated, zoom("50", "5")));
    const FoundScene as_stated = scene_of(bytes);
    ASSERT_TRUE(as_stated.lights[0].zoom.has_value());
    EXPECT_NEAR(to_degrees(as_stated.lights[0].zoom->least), 5.0, 1e-12);
    EXPECT_NEAR(to_degrees(as_stated.lights[0].zoom->most), 50.0, 1e-12);
    SceneReadOptions options;
    options.zoom = degrees(10.0);
    FoundScene narrow = scene_of(bytes, options);
    load_scene_profiles(narrow, options);
    EXPECT_EQ(number_of(narrow.lights[0]), 8000.0);
    const Web& web = *std::get<ProfileShape>(*narrow.lights[0].shape).web;
    EXPECT_NEAR(web.candela(0.0, 10.0) / web.candela(0.0, 0.0), 0.1, 1e-3); // the field angle of 40° is 20° now
    EXPECT_EQ(scene_of(gdtf_of(fixture(stated, zoom("0", "400")))).diagnostics.size(), 2U); // left out; which mode
}

TEST(InterchangeGdtf, WideZooms) {
    SceneReadOptions options;
    options.zoom = degrees(100.0); // the field angle would be 200°
    FoundScene wide = scene_of(gdtf_of(fixture(stated, zoom("6", "100"))), options);
    load_scene_profiles(wide, options);
    ASSERT_TRUE(wide.lights[0].is_converted());
    const auto says = [&](const std::string& what) {
        for (const LightRemark& said : wide.lights[0].remarks)
            if (said.message.find(what) != std::string::npos) return true;
        return false;
    };
    EXPECT_TRUE(says("field angle to 200°"));
    options.zoom = degrees(2.0);
    wide = scene_of(gdtf_of(fixture(stated, zoom("6", "100"))), options);
    EXPECT_TRUE(says("from 6° to 100°: 6° is taken"));
    EXPECT_FALSE(says("at the most"));
}

TEST(InterchangeGdtf, HostileFixtures) {
    std::string attributes;
    for (int i = 0; i < 101; ++i)
        attributes += " a" + std::to_string(i) + "=\"\"";
    EXPECT_EQ(failure_of(gdtf_of(fixture(stated + attributes))).code, "SCN0108");
    EXPECT_EQ(failure_of(gdtf_of(fixture(stated, "<DMXChannel" + attributes + "/>"))).code, "SCN0108");
    std::string beams;
    for (int i = 0; i < 1001; ++i)
        beams += "/><Beam Name=\"b\" BeamAngle=\"" + std::to_string(1.0 + 0.01 * i) + "\" FieldAngle=\"50\"";
    EXPECT_EQ(failure_of(gdtf_of(fixture(stated + beams))).code, "SCN0108");
    std::string wrong;
    for (int i = 0; i < 1000; ++i)
        wrong += zoom("0", "400");
    EXPECT_LT(scene_of(gdtf_of(fixture(stated, wrong))).diagnostics.size(), 20U);
    std::string name; // its cut falls into a character
    for (int i = 0; i < 300; ++i)
        name += "é";
    const FoundLight light = scene_of(gdtf_of(replaced(fixture(stated), "\"Lens\"", "\"a" + name + "\""))).lights[0];
    EXPECT_EQ(light.name, "a" + name.substr(0, 398));
    const FoundLight below = scene_of(gdtf_of(replaced(fixture(stated), "\"Yoke\"", "\"" + name + "\""))).lights[0];
    EXPECT_EQ(below.place, "…" + name.substr(0, 394) + "/Lens");
}

TEST(InterchangeGdtf, ChannelsNameAReferenceOrWhatStandsForIt) {
    const std::string xml =
        "<GDTF><FixtureType><Geometries><Geometry Name=\"Bar\">"
        "<GeometryReference Name=\"1\" Geometry=\"Yoke\"/></Geometry><Beam Name=\"Yoke\"/></Geometries>"
        "<DMXModes><DMXMode Name=\"m\" Geometry=\"Bar\"><DMXChannels>" +
        zoom("5", "50") + "</DMXChannels></DMXMode></DMXModes></FixtureType></GDTF>";
    for (const char* const by : {"\"Yoke\"", "\"1\""}) {
        const FoundScene scene =
            scene_of(gdtf_of(replaced(xml, "DMXChannel Geometry=\"Yoke\"", std::string("DMXChannel Geometry=") + by)));
        ASSERT_EQ(scene.lights.size(), 1U);
        EXPECT_TRUE(scene.lights[0].zoom.has_value()) << by;
    }
}

TEST(InterchangeGdtf, KindsOfBeams) {
    const auto shape_of = [](const std::string& from, const std::string& to) {
        return *scene_of(gdtf_of(fixture(replaced(stated, from, to)))).lights[0].shape;
    };
    const Shape hard = shape_of("FieldAngle=\"40\"", "FieldAngle=\"20\"");
    EXPECT_NEAR(to_degrees(std::get<SpotShape>(hard).outer), 10.0, 1e-12);
    EXPECT_EQ(std::get<SpotShape>(hard).falloff, Falloff::hard);
    EXPECT_EQ(std::get<DiskShape>(shape_of("\"Spot\"", "\"Glow\"")).radius.value, 0.1);
    const Shape frustum = shape_of("BeamType=\"Spot\"", "BeamType=\"Rectangle\" RectangleRatio=\"2\"");
    EXPECT_NEAR(std::tan(0.5 * std::get<FrustumShape>(frustum).horizontal.value),
                2.0 * std::tan(0.5 * std::get<FrustumShape>(frustum).vertical.value), 1e-12);
    const FoundLight silent = scene_of(gdtf_of(fixture(""))).lights[0];
    EXPECT_EQ(number_of(silent), 10000.0);
    EXPECT_EQ(silent.temperature->value, 6000.0);
    EXPECT_GE(silent.remarks.size(), 5U); // each of them is said
}

TEST(InterchangeGdtf, References) {
    const std::string xml =
        "<GDTF><FixtureType><Geometries><Geometry Name=\"Bar\">"
        "<GeometryReference Name=\"1\" Geometry=\"Pixel\"/>"
        "<GeometryReference Name=\"2\" Geometry=\"Pixel\" Position=\"{1,0,0,3}{0,1,0,0}{0,0,1,0}{0,0,0,1}\"/>"
        "</Geometry><Beam Name=\"Pixel\"/></Geometries></FixtureType></GDTF>";
    const FoundScene bar = scene_of(gdtf_of(xml));
    ASSERT_EQ(bar.lights.size(), 2U);
    EXPECT_EQ(bar.lights[1].position.x, 3.0);
    EXPECT_EQ(failure_of(gdtf_of(replaced(xml, "Geometry=\"Pixel\"", "Geometry=\"Pixels\""))).code, "SCN0103");
    EXPECT_EQ(failure_of(gdtf_of(replaced(xml, "Geometry=\"Pixel\"", "Geometry=\"Bar\""))).code, "SCN0108");
    // Each level names the next one many times.
    std::string bomb = "<GDTF><FixtureType><Geometries>";
    for (int level = 0; level < 30; ++level) {
        bomb += "<Geometry Name=\"g" + std::to_string(level) + "\">";
        for (int i = 0; i < 10; ++i)
            bomb += "<GeometryReference Name=\"a\" Geometry=\"g" + std::to_string(level + 1) + "\"/>";
        bomb += "</Geometry>";
    }
    EXPECT_EQ(failure_of(gdtf_of(bomb + "<Geometry Name=\"g30\"/></Geometries></FixtureType></GDTF>")).code, "SCN0108");
}

TEST(InterchangeGdtf, BrokenFixtures) {
    EXPECT_EQ(failure_of(gdtf_of("<GDTF>")).code, "ARC0201");
    EXPECT_EQ(failure_of(gdtf_of("<!DOCTYPE GDTF><GDTF/>")).code, "ARC0202");
    EXPECT_EQ(failure_of(gdtf_of("<GDTF/>")).code, "SCN0103");
    EXPECT_EQ(failure_of(gdtf_of(replaced(fixture(stated), "{0,0,-1,0}", "{0,0,nan,0}"))).code, "SCN0105");
    EXPECT_EQ(failure_of(gdtf_of(replaced(fixture(stated), "Geometry=\"Base\"", "Geometry=\"Top\""))).code, "SCN0103");
    SceneReadOptions options;
    options.variant = "Extended";
    EXPECT_EQ(test::code_of(read_scene_lights(gdtf_of(fixture(stated)), "scene", options)), "USE0103");
    const FoundScene wide = scene_of(gdtf_of(fixture(replaced(stated, "\"20\"", "\"180\""))));
    EXPECT_FALSE(wide.lights[0].is_converted());
}

} // namespace

} // namespace gonio
