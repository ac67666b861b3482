#include <gonio/light/shape.hpp>

#include "../temporary_folder.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <string>

namespace gonio {
namespace {

TEST(Shape, GrammarAndItsErrors) {
    EXPECT_TRUE(std::holds_alternative<PointShape>(parse_shape("point").value()));
    EXPECT_DOUBLE_EQ(std::get<SphereShape>(parse_shape("sphere:r=3cm").value()).radius.value, 0.03);
    EXPECT_EQ(std::get<ProfileShape>(parse_shape("ies:a,b=c:d.ies").value()).file, "a,b=c:d.ies");
    for (const char* text : {"", "point:r=1m", "sphere", "sphere:r=3", "sphere:r=0m", "sphere:r=-1m", "sphere:r=1lm",
                             "sphere:r=1m,q=2", "ies", "ies:", "cube:a=1m"})
        EXPECT_FALSE(parse_shape(text)) << text;
}

TEST(Shape, LengthsAreTakenAsPeopleWriteThem) {
    const auto radius = [](const char* text) { return std::get<SphereShape>(parse_shape(text).value()).radius.value; };
    EXPECT_EQ(radius("sphere:radius=3cm"), 0.03);
    EXPECT_EQ(radius("sphere:d=6cm"), 0.03);
    EXPECT_EQ(radius("sphere:diameter=6cm"), 0.03);
    const auto tube = std::get<TubeShape>(parse_shape("tube:d=26mm,length=1.2m").value());
    EXPECT_EQ(tube.radius.value, 0.013);
    EXPECT_EQ(tube.length.value, 1.2);
    const auto rect = std::get<RectShape>(parse_shape("rect:width=60cm,height=30cm,two-sided").value());
    EXPECT_EQ(rect.width.value, 0.6);
    EXPECT_EQ(rect.height.value, 0.3);
    EXPECT_TRUE(rect.two_sided);
    // A display's diagonal at 16:9: 55 in are 1.397 m.
    const auto display = std::get<RectShape>(parse_shape("rect:55in").value());
    EXPECT_NEAR(std::hypot(display.width.value, display.height.value), 1.397, 1e-15);
    EXPECT_NEAR(display.width.value / display.height.value, 16.0 / 9.0, 1e-15);
    // Two readings, or none: not guessed.
    for (const char* text : {"sphere:3cm", "disk:20cm", "sphere:r=3cm,d=6cm", "sphere:radius=3cm,d=6cm", "sphere:d=6",
                             "rect:55in,w=1m", "frustum:height=50deg,v=30deg", "ellipse:55in", "sphere:diameter"})
        EXPECT_FALSE(parse_shape(text)) << text;
}

TEST(Shape, EveryKindIsListedAndParsed) {
    std::set<std::string_view> listed;
    for (const ShapeKind& kind : shape_kinds())
        listed.insert(kind.kind);
    for (const char* text : {"point", "spot:outer=40deg", "frustum:h=60deg,v=40deg", "ies:lamp.ies", "sphere:r=3cm",
                             "disk:r=10cm", "ellipse:w=60cm,h=30cm", "rect:w=60cm,h=30cm", "tube:r=1.3cm,l=1.2m",
                             "cylinder:r=10cm,l=30cm", "sun:angle=0.53deg"})
        EXPECT_EQ(listed.erase(kind_of(test::shape(text))), 1U) << text;
    EXPECT_TRUE(listed.empty());
}

TEST(Shape, SpotTakesHalfAnglesOrItsCone) {
    const auto spot = std::get<SpotShape>(test::shape("spot:outer=40deg,inner=25deg,falloff=smoothstep-angle"));
    EXPECT_DOUBLE_EQ(to_degrees(spot.outer), 40.0);
    EXPECT_DOUBLE_EQ(to_degrees(spot.inner), 25.0);
    EXPECT_EQ(spot.falloff, Falloff::smoothstep_angle);
    const auto cone = std::get<SpotShape>(test::shape("spot:cone=80deg"));
    EXPECT_EQ(cone.outer.value, spot.outer.value);
    EXPECT_EQ(cone.inner.value, 0.0);
    EXPECT_EQ(cone.falloff, Falloff::frostbite);
    // Degrees may round to above π/2; a cone never does.
    for (const char* text : {"spot:outer=90deg", "spot:cone=180deg", "spot:outer=90deg,inner=90deg"})
        EXPECT_LE(std::get<SpotShape>(test::shape(text)).outer.value, std::numbers::pi / 2) << text;
    for (const Falloff falloff : {Falloff::frostbite, Falloff::hard, Falloff::linear_cos, Falloff::smoothstep_cos,
                                  Falloff::linear_angle, Falloff::smoothstep_angle})
        EXPECT_EQ(std::get<SpotShape>(test::shape(std::string("spot:outer=1deg,falloff=") + to_text(falloff))).falloff,
                  falloff);
}

TEST(Shape, AreaShapesTakeLengths) {
    const auto rect = std::get<RectShape>(test::shape("rect:w=60cm,h=1ft,two-sided"));
    EXPECT_DOUBLE_EQ(rect.width.value, 0.6);
    EXPECT_DOUBLE_EQ(rect.height.value, 0.3048);
    EXPECT_TRUE(rect.two_sided);
    EXPECT_FALSE(std::get<DiskShape>(test::shape("disk:r=10cm")).two_sided);
    const auto tube = std::get<TubeShape>(test::shape("tube:l=1.2m,r=13mm"));
    EXPECT_DOUBLE_EQ(tube.radius.value, 0.013);
    EXPECT_DOUBLE_EQ(tube.length.value, 1.2);
    EXPECT_DOUBLE_EQ(std::get<SunShape>(test::shape("sun:angle=0.53deg")).diameter.value,
                     0.53 * std::numbers::pi / 180.0);
}

TEST(Shape, WhatMakesNoShapeIsRefused) {
    for (const char* text : {"spot",
                             "spot:outer=-1deg",
                             "spot:outer=-1deg",
                             "spot:outer=91deg",
                             "spot:outer=40",
                             "spot:outer=40cm",
                             "spot:outer",
                             "spot:cone=181deg",
                             "spot:cone=80deg,outer=40deg",
                             "spot:outer=40deg,inner=41deg",
                             "spot:outer=40deg,inner=-1deg",
                             "spot:outer=40deg,inner",
                             "spot:outer=40deg,falloff=soft",
                             "spot:outer=40deg,falloff",
                             "spot:outer=40deg,mask",
                             "spot:outer=40deg,mask=",
                             "spot:outter=40deg",
                             "frustum:h=60deg",
                             "frustum:v=60deg",
                             "frustum:h=60deg,v=180deg",
                             "frustum:h=0deg,v=60deg",
                             "disk",
                             "disk:r=0m",
                             "ellipse:w=1m",
                             "ellipse:w=1m,h=0m",
                             "ellipse:r=1m",
                             "disk:r=1m,two-sided=1",
                             "disk:r=1m,twosided",
                             "rect:w=1m",
                             "rect:w=1m,h=-1m",
                             "tube:r=1cm",
                             "tube:r=1cm,l=0m",
                             "cylinder:r=1cm",
                             "cylinder:r=0m,l=1m",
                             "sun",
                             "sun:angle=0deg",
                             "sun:angle=181deg",
                             "sphere:r=1m,mask",
                             "sun:angle=1deg,mask=a.ies",
                             "point:mask"})
        EXPECT_FALSE(parse_shape(text)) << text;
    const auto reason = [](const char* text) {
        const Result<Shape> parsed = parse_shape(text);
        return parsed ? Diagnostic{} : parsed.error().diagnostics.back();
    };
    EXPECT_EQ(reason("spot:outer=40deg,falloff=lineer-cos").hint.find("did you mean 'linear-cos'?"), 0U);
    EXPECT_EQ(reason("disk:r=1m,twosided").hint.find("did you mean 'two-sided'?"), 0U);
    EXPECT_EQ(reason("spot:outer=95deg").message, "outer of 'spot' must be at least 0deg and at most 90deg, not 95deg");
    EXPECT_EQ(reason("frustum:h=200deg,v=1deg").message,
              "h of 'frustum' must be greater than 0deg and less than 180deg, not 200deg");
}

TEST(Shape, MasksAreLoadedLikeProfiles) {
    const test::TemporaryFolder folder;
    const std::string file = (folder.path() / "mask.ies").string();
    std::ofstream(file) << "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n200 100\n";
    for (const char* kind : {"point:", "spot:outer=40deg,", "frustum:h=60deg,v=40deg,", "sphere:r=1m,", "disk:r=1m,",
                             "ellipse:w=1m,h=2m,", "rect:w=1m,h=1m,", "tube:r=1m,l=1m,"}) {
        Shape shape = test::shape(std::string(kind) + "mask=" + file);
        EXPECT_EQ(*mask_of(shape).file, file);
        EXPECT_EQ(mask_of(shape).web, nullptr);
        // A mask that is not loaded is an error of the caller, never an unmasked light.
        EXPECT_FALSE(emission_of(shape, parse_photometric_value("1lm").value()));
        Diagnostics diagnostics;
        ASSERT_TRUE(load_profile(shape, diagnostics));
        ASSERT_NE(mask_of(shape).web, nullptr);
        EXPECT_DOUBLE_EQ(mask_of(shape).web->candela(0.0, 45.0), 150.0);
    }
    EXPECT_EQ(mask_of(test::shape("spot:outer=40deg")).file, nullptr);
    Diagnostics diagnostics;
    Shape missing = test::shape("point:mask=" + (folder.path() / "none.ies").string());
    const Result<void> loaded = load_profile(missing, diagnostics);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().failure, Failure::io);
}

} // namespace
} // namespace gonio
