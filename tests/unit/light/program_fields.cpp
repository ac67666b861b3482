// What to type into programs: the number is that with which the program emits the light's flux.
#include <gonio/light/program_fields.hpp>

#include "shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace gonio {
namespace {

using std::numbers::pi;

ProgramLight light_of(const char* program, const char* shape_text, const char* value) {
    const Shape shape = test::shape(shape_text);
    const Result<ProgramLight> light =
        program_light(**find_policy(program), shape, emission_of(shape, *parse_photometric_value(value)).value());
    EXPECT_TRUE(light) << program << ' ' << shape_text;
    return *light;
}

std::string field(const ProgramLight& light, std::string_view name) {
    for (const ProgramField& field : light.fields)
        if (field.name == name) return field.value + (field.unit.empty() ? "" : " " + field.unit);
    return "none";
}

TEST(ProgramFields, ABulbOf800Lumens) {
    const ProgramLight unreal = light_of("unreal", "sphere:r=3cm", "800lm");
    EXPECT_EQ(field(unreal, "Intensity"), "800 lm");
    EXPECT_EQ(field(unreal, "Source Radius"), "3 cm");
    EXPECT_EQ(field(light_of("unity-hdrp", "sphere:r=3cm", "800lm"), "Radius"), "0.03 m");
    EXPECT_EQ(field(light_of("godot", "sphere:r=3cm", "800lm"), "light_size"), "0.03 m");
    // A point of the same flux: 800/4π cd.
    const ProgramLight gltf = light_of("gltf", "sphere:r=3cm", "800lm");
    EXPECT_EQ(field(gltf, "intensity"), rounded(800.0 / (4.0 * pi)) + " cd");
    EXPECT_EQ(gltf.note, "a point of the same flux");
    EXPECT_EQ(field(light_of("blender", "sphere:r=3cm", "800lm"), "Power"), rounded(800.0 / 177.83) + " W");
}

// The flux that the program makes of the number is that of the light.
TEST(ProgramFields, AmountsUndoThePolicies) {
    const char* const text = "spot:outer=40deg,inner=25deg";
    const Shape shape = test::shape(text);
    for (const char* name : {"unreal", "unity-hdrp", "filament", "godot"}) {
        const ProgramLight light = light_of(name, text, "800lm");
        const double typed = *parse_number(light.fields[0].value);
        const PolicyMeaning meaning = *policy_meaning(**find_policy(name), shape, Dimension::luminous_flux);
        EXPECT_NEAR(typed * meaning.emitted_over_said, 800.0, 5e-6 * 800.0) << name; // six digits
    }
    EXPECT_EQ(field(light_of("unreal", text, "800lm"), "Outer Cone Angle"), "40 deg");
    EXPECT_EQ(field(light_of("unity-hdrp", text, "800lm"), "Outer Angle"), "80 deg");
    EXPECT_EQ(field(light_of("unity-hdrp", text, "800lm"), "Inner Angle"), "62.5 %");
    // Cycles: full intensity where cosθ is blend of the way from the rim to the axis.
    const double rim = std::cos(40.0 * pi / 180.0);
    EXPECT_EQ(field(light_of("blender", text, "800lm"), "Blend"),
              rounded((std::cos(25.0 * pi / 180.0) - rim) / (1.0 - rim)));
    EXPECT_EQ(field(light_of("threejs", text, "800lm"), "penumbra"), "0.375");
    EXPECT_EQ(field(light_of("gltf", text, "800lm"), "outerConeAngle"), rounded(40.0 * pi / 180.0) + " rad");
}

TEST(ProgramFields, SizesAreInTheProgramsUnits) {
    const ProgramLight unreal = light_of("unreal", "rect:w=60cm,h=30cm", "2000lm");
    EXPECT_EQ(field(unreal, "Source Width"), "60 cm");
    EXPECT_EQ(field(unreal, "Source Height"), "30 cm");
    EXPECT_EQ(field(light_of("threejs", "rect:w=60cm,h=30cm", "2000lm"), "intensity"),
              rounded(2000.0 / (pi * 0.18)) + " nt");
    EXPECT_EQ(field(light_of("blender", "disk:r=10cm", "100lm"), "Size"), "0.2 m");
    EXPECT_EQ(field(light_of("filament", "sun:angle=0.53deg", "100klx"), "sunAngularRadius"), "0.265 deg");
}

TEST(ProgramFields, WhatAProgramLacksIsSaid) {
    for (const auto& [program, shape] : {std::pair{"unreal", "disk:r=1cm"},
                                         {"godot", "rect:w=1m,h=1m"},
                                         {"gltf", "tube:r=1cm,l=1m"},
                                         {"usd", "point"},
                                         {"blender", "sun:angle=0.5deg"},
                                         {"filament", "frustum:h=30deg,v=30deg"}}) {
        const Shape made = test::shape(shape);
        const Emission emission =
            emission_of(made, *parse_photometric_value(class_of(made) == ShapeClass::sun ? "100lx" : "100lm")).value();
        const Result<ProgramLight> light = program_light(**find_policy(program), made, emission);
        ASSERT_FALSE(light) << program << ' ' << shape;
        EXPECT_EQ(light.error().failure, Failure::unsupported);
    }
}

} // namespace
} // namespace gonio
