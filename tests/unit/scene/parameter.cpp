#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/scene/parameter.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <set>
#include <string>
#include <variant>

namespace gonio {
namespace {

LightDescription described(const char* shape) {
    LightDescription light;
    light.shape = parse_shape(shape).value();
    light.intensity = parse_photometric_value("800lm").value();
    return light;
}

// Every value of a shape, to the last bit.
std::vector<double> numbers(const Shape& shape) {
    std::vector<double> found;
    for (const ShapeValue& value : values_of(shape))
        std::visit(
            [&]<class Value>(const Value& of_key) {
                if constexpr (requires { of_key.value; })
                    found.push_back(of_key.value);
                else
                    found.push_back(static_cast<double>(of_key));
            },
            value.value);
    return found;
}

// A light with a value set equals a light that was written with it.
TEST(Parameter, OfAShapeIsThatOfItsGrammar) {
    struct Case {
        const char* before;
        const char* name;
        const char* value;
        const char* after;
    };
    for (const Case& c : {Case{"sphere:r=3cm", "radius", "1.3cm", "sphere:r=1.3cm"},
                          Case{"disk:r=3cm", "radius", "0.7ft", "disk:r=0.7ft"},
                          Case{"ellipse:w=3cm,h=2cm", "width", "1in", "ellipse:w=1in,h=2cm"},
                          Case{"ellipse:w=3cm,h=2cm", "h", "4cm", "ellipse:w=3cm,h=4cm"},
                          Case{"ellipse:w=3cm,h=2cm", "size", "2", "ellipse:w=6cm,h=4cm"},
                          Case{"rect:w=1m,h=2m", "width", "33cm", "rect:w=33cm,h=2m"},
                          Case{"rect:w=1m,h=2m", "h", "33cm", "rect:w=1m,h=33cm"},
                          Case{"rect:w=1m,h=2m", "size", "2", "rect:w=2m,h=4m"},
                          Case{"tube:r=1cm,l=2m", "length", "33cm", "tube:r=1cm,l=33cm"},
                          Case{"cylinder:r=1cm,l=2m", "length", "33cm", "cylinder:r=1cm,l=33cm"},
                          Case{"tube:r=1cm,l=2m", "radius", "2cm", "tube:r=2cm,l=2m"},
                          Case{"sun:angle=0.5deg", "angle", "3deg", "sun:angle=3deg"},
                          Case{"frustum:h=50deg,v=30deg", "h", "20deg", "frustum:h=20deg,v=30deg"},
                          Case{"frustum:h=50deg,v=30deg", "v", "0.1rad", "frustum:h=50deg,v=0.1rad"},
                          Case{"spot:outer=50deg,inner=7deg", "outer", "33deg", "spot:outer=33deg,inner=7deg"},
                          Case{"spot:outer=50deg,inner=7deg", "cone", "33deg", "spot:cone=33deg,inner=7deg"},
                          Case{"spot:outer=50deg,inner=7deg", "inner", "50deg", "spot:outer=50deg,inner=50deg"},
                          Case{"spot:outer=50deg", "falloff", "linear-cos", "spot:outer=50deg,falloff=linear-cos"}}) {
        LightDescription light = described(c.before);
        Diagnostics unheard;
        EXPECT_TRUE(set_parameter(light, c.name, c.value, unheard).value()) << c.after;
        EXPECT_EQ(numbers(light.shape), numbers(parse_shape(c.after).value())) << c.after;
    }
}

TEST(Parameter, BeamIsTheAngleAtHalfOfThePeak) {
    for (const char* shape : {"spot:outer=30deg,inner=10deg", "spot:outer=60deg", "spot:outer=20deg,falloff=hard",
                              "spot:outer=30deg,inner=29deg,falloff=smoothstep-angle"})
        for (const double beam_deg : {3.0, 25.0, 61.0}) {
            LightDescription light = described(shape);
            const auto before = std::get<SpotShape>(light.shape);
            Diagnostics unheard;
            ASSERT_TRUE(set_parameter(light, "beam", shortest(beam_deg) + "deg", unheard).value());
            const auto& spot = std::get<SpotShape>(light.shape);
            EXPECT_NEAR(spot.inner / spot.outer, before.inner / before.outer, 1e-15);
            // Computed in double: at this angle the lobe is one half, up to rounding times its slope; `hard` jumps
            // there.
            constexpr double hair = 1e-9;
            const Radians edge(0.5 * beam_deg * std::numbers::pi / 180.0);
            EXPECT_GE(lobe(spot, edge * (1.0 - hair)), 0.5);
            EXPECT_LE(lobe(spot, edge * (1.0 + hair)), 0.5);
        }
}

TEST(Parameter, OfALightIsWhatARigSays) {
    LightDescription light = described("sphere:r=3cm");
    light.position = {1.0, 2.0, 3.0};
    light.direction = {1.0, 0.0, -1.0};
    Diagnostics noticed;
    EXPECT_TRUE(set_parameter(light, "cct", "2700K", noticed).value());
    EXPECT_EQ(light.color, parse_light_color("2700K").value());
    EXPECT_TRUE(set_parameter(light, "color", "#ffd9a0", noticed).value());
    EXPECT_EQ(light.color, parse_light_color("#ffd9a0").value());
    EXPECT_TRUE(set_parameter(light, "intensity", "300lx@2m", noticed).value());
    EXPECT_EQ(light.intensity->number, 300.0);
    EXPECT_TRUE(set_parameter(light, "height", "1.5m", noticed).value());
    EXPECT_EQ(light.position, glm::dvec3(1.0, 2.0, 1.5));
    EXPECT_TRUE(set_parameter(light, "range", "12m", noticed).value());
    EXPECT_EQ(light.range->value, 12.0);
    EXPECT_TRUE(set_parameter(light, "yaw", "90deg", noticed).value());
    EXPECT_NEAR(light.direction.x, 0.0, 1e-15);
    EXPECT_NEAR(light.direction.y, 1.0, 1e-15);
    EXPECT_EQ(light.direction.z, -1.0);
    EXPECT_TRUE(noticed.empty());
    EXPECT_TRUE(set_parameter(light, "cct", "1200K", noticed).value());
    EXPECT_EQ(noticed.size(), 1U); // outside Rec.709
}

TEST(Parameter, OfAMaterialIsThatOfItsGrammar) {
    struct Case {
        const char* before;
        const char* name;
        const char* value;
        const char* after;
    };
    for (const Case& c : {Case{"lambert:albedo=0.2", "albedo", "rgb(0.1,0.2,0.3)", "lambert:albedo=rgb(0.1,0.2,0.3)"},
                          Case{"eon:albedo=0.2", "roughness", "0.9", "eon:albedo=0.2,roughness=0.9"},
                          Case{"ue4:base=0.2", "metallic", "1", "ue4:base=0.2,metallic=1"},
                          Case{"ue4:base=0.2", "cavity", "0.3", "ue4:base=0.2,cavity=0.3"},
                          Case{"gltf:base=0.2", "metallic", "1", "gltf:base=0.2,metallic=1"},
                          Case{"gltf:base=0.2", "roughness", "0.25", "gltf:base=0.2,roughness=0.25"},
                          Case{"frostbite:base=0.2", "metallic", "1", "frostbite:base=0.2,metal=1"},
                          Case{"frostbite:base=0.2", "roughness", "0.25", "frostbite:base=0.2,smoothness=0.75"},
                          Case{"blinn:albedo=0.2", "wet", "1", "blinn:albedo=0.2,wet=1"},
                          Case{"ggx:f0=0.9", "roughness", "0.25", "ggx:f0=0.9,roughness=0.25"},
                          Case{"ggx:f0=0.9", "anisotropy", "0.6", "ggx:f0=0.9,anisotropy=0.6"},
                          Case{"gltf:base=0.2", "rotation", "30", "gltf:base=0.2,rotation=30deg"},
                          Case{"kulla-conty:f0=0.9", "alpha", "0.25", "kulla-conty:f0=0.9,alpha=0.25"}}) {
        Material material = parse_material(c.before).value();
        EXPECT_TRUE(set_parameter(material, c.name, c.value).value()) << c.after;
        const Material expected = parse_material(c.after).value();
        std::visit(
            [&]<class M>(const M& found) {
                const auto& wanted = std::get<M>(expected);
                for_each_key<M>([&](const auto& key) {
                    EXPECT_EQ(found.*key.member, wanted.*key.member) << c.after << ' ' << key.name;
                });
            },
            base_of(material));
    }
}

TEST(Parameter, IsLackedOrRefused) {
    Diagnostics unheard;
    LightDescription light = described("sphere:r=3cm");
    for (const char* name : {"cone", "beam", "width", "length", "h", "v", "angle", "nothing", ""})
        EXPECT_FALSE(set_parameter(light, name, "1m", unheard).value()) << name;
    LightDescription sun = described("sun:angle=0.5deg");
    EXPECT_FALSE(set_parameter(sun, "height", "1m", unheard).value());
    struct Case {
        const char* shape;
        const char* name;
        const char* value;
    };
    for (const Case& c :
         {Case{"sphere:r=3cm", "radius", "0m"}, Case{"sphere:r=3cm", "radius", "3"},
          Case{"sphere:r=3cm", "radius", "3deg"}, Case{"sphere:r=3cm", "size", "-1"},
          Case{"sphere:r=3cm", "size", "1m"}, Case{"sphere:r=3cm", "cct", "2700"}, Case{"sphere:r=3cm", "cct", "d65"},
          Case{"sphere:r=3cm", "range", "0m"}, Case{"sphere:r=3cm", "intensity", "-1lm"},
          Case{"spot:outer=30deg", "inner", "31deg"}, Case{"spot:outer=30deg,inner=20deg", "outer", "19deg"},
          Case{"spot:outer=30deg", "beam", "0deg"}, Case{"spot:outer=30deg", "beam", "180deg"},
          Case{"spot:outer=30deg", "falloff", "soft"}, Case{"sun:angle=1deg", "angle", "181deg"}}) {
        light = described(c.shape);
        const auto before = numbers(light.shape);
        EXPECT_FALSE(set_parameter(light, c.name, c.value, unheard).has_value()) << c.name << '=' << c.value;
        EXPECT_EQ(numbers(light.shape), before);
    }
    Material material = parse_material("frostbite:base=0.2").value();
    EXPECT_FALSE(set_parameter(material, "cavity", "0.3").value());
    for (const char* value : {"1.1", "-0.1", "nan", "", "1m"})
        EXPECT_FALSE(set_parameter(material, "roughness", value).has_value()) << value;
}

// Each material's keys are in the list by their names, and the list names the materials that have them.
TEST(Parameter, OfEveryKeyIsListed) {
    for_each_material([]<class M>() {
        const std::vector<std::string_view> names = parameters_of(Material(M()));
        for_each_key<M>([&](const auto& key) {
            EXPECT_NE(std::find(names.begin(), names.end(), key.parameter), names.end()) << key.name;
        });
        for (const std::string_view name : names)
            for (const ParameterName& parameter : material_parameters())
                if (parameter.name == name) {
                    EXPECT_TRUE(parameter.summary.starts_with("any material") ||
                                parameter.summary.find(MaterialDescription<M>::kind) != std::string_view::npos)
                        << name;
                    Material material = M();
                    EXPECT_TRUE(set_parameter(material, name, parameter.example).value()) << name;
                }
    });
    for (const ParameterName& parameter : material_parameters()) {
        if (parameter.name == "metallic") {
            EXPECT_NE(parameter.summary.find("frostbite: metal"), std::string_view::npos) << parameter.summary;
        }
        if (parameter.name == "roughness") {
            EXPECT_NE(parameter.summary.find("; frostbite and blinn: 1 - smoothness"), std::string_view::npos)
                << parameter.summary;
        }
    }
}

// A parameter takes one value: a second key is refused.
TEST(Parameter, IsOneValue) {
    Material material = parse_material("ue4:roughness=0.2").value();
    EXPECT_FALSE(set_parameter(material, "roughness", "0.3,base=1").has_value());
    EXPECT_EQ(std::get<Ue4Material>(material).roughness, 0.2);
}

// Everything in the list belongs to some light or material, and each light's list contains what can be set.
TEST(Parameter, ListsAreWhatThereIs) {
    std::set<std::string_view> met;
    for (const char* shape :
         {"point", "spot:outer=30deg", "frustum:h=30deg,v=20deg", "sphere:r=3cm", "disk:r=3cm", "ellipse:w=3cm,h=2cm",
          "rect:w=1m,h=1m", "tube:r=3cm,l=1m", "cylinder:r=3cm,l=1m", "sun:angle=1deg", "ies:lamp.ies"})
        for (const std::string_view name : parameters_of(described(shape)))
            met.insert(name);
    EXPECT_EQ(met.size(), light_parameters().size());
    EXPECT_EQ(parameters_of(described("sphere:r=3cm")),
              (std::vector<std::string_view>{"cct", "color", "intensity", "radius", "size", "x", "y", "height",
                                             "rotate", "yaw", "range"}));
    met.clear();
    for (const MaterialKind& kind : material_kinds())
        for (const std::string_view name : parameters_of(parse_material(kind.kind).value()))
            met.insert(name);
    for (const std::string_view name : parameters_of(parse_material("lambert:coat=1").value()))
        met.insert(name);
    EXPECT_EQ(met.size(), material_parameters().size());
}

TEST(Parameter, OfACoat) {
    Material material = parse_material("ue4:roughness=0.2").value();
    EXPECT_FALSE(set_parameter(material, "coat-smoothness", "0.5").value()); // there is none
    EXPECT_TRUE(set_parameter(material, "coat", "0.5").value());
    EXPECT_TRUE(set_parameter(material, "coat-smoothness", "0.25").value());
    EXPECT_TRUE(set_parameter(material, "coat-order", "ue4").value());
    EXPECT_TRUE(set_parameter(material, "roughness", "0.75").value()); // of the base
    const auto& coated = std::get<CoatedMaterial>(material);
    EXPECT_EQ(coated.coat, (Coat{0.5, 0.25, CoatOrder::ue4}));
    EXPECT_EQ(std::get<Ue4Material>(coated.base).roughness, 0.75);
    EXPECT_FALSE(set_parameter(material, "coat", "1.5").has_value());
    EXPECT_FALSE(set_parameter(material, "coat-order", "unreal").has_value());
    EXPECT_FALSE(set_parameter(material, "metal", "1").value());
}

} // namespace
} // namespace gonio
