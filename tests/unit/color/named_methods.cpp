// The published formulas have the errors that another program found (numpy, 3000 points, uniform in mired).
#include <gonio/color/cct.hpp>
#include <gonio/color/named_methods.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gonio {
namespace {

double worst(std::string_view name, double coolest, double hottest) {
    const ColorMethod& method = *parse_color_methods(name).value().front();
    double found = 0.0;
    for (int i = 0; i <= 300; ++i)
        found = std::fmax(
            found,
            error_of(method, Kelvin(1e6 / (1e6 / coolest + (1e6 / hottest - 1e6 / coolest) * i / 300))).delta_uv_prime);
    return found;
}

TEST(NamedColorMethods, HaveTheirKnownErrors) {
    struct Known {
        const char* name;
        double coolest, hottest, delta;
    };
    // Δu'v' in two digits; a coarser grid may miss a little of the peak.
    for (const Known& k : {Known{"krystek", 1000, 15000, 1.8e-4},
                           {"kang", 1667, 25000, 3.9e-4},
                           {"kang", 1000, 1667, 1.2e-1},
                           {"blender", 800, 12000, 4.9e-2},
                           {"blender", 12000, 25000, 2.1e-2},
                           {"usd", 2000, 10000, 5.3e-4},
                           {"usd", 1000, 10000, 2.4e-2},
                           {"filament", 1000, 15000, 9.9e-3},
                           {"filament", 2000, 10000, 1.9e-4},
                           {"helland", 1000, 40000, 4.7e-2},
                           {"bartlett", 2000, 10000, 3.3e-3},
                           {"robertson", 1667, 25000, 1.4e-4}})
        EXPECT_NEAR(worst(k.name, k.coolest, k.hottest) / k.delta, 1.0, 0.08) << k.name << ' ' << k.coolest;
    EXPECT_LT(worst("fit", 800, 1e6), 1.5e-12);
    EXPECT_LT(worst("fit-float", 800, 1e6), 1e-6);
}

TEST(NamedColorMethods, KeepOrLoseLuminance) {
    for (const char* keeps : {"krystek", "usd", "unreal", "osl", "blender", "materialx"})
        EXPECT_NEAR(error_of(*parse_color_methods(keeps).value().front(), Kelvin(2700)).luminance, 1.0, 3e-3) << keeps;
    EXPECT_NEAR(error_of(*parse_color_methods("filament").value().front(), Kelvin(2700)).luminance, 0.517, 1e-3);
}

TEST(NamedColorMethods, InversesGiveTheirPublishedValues) {
    const Uv d65 = to_uv(d65_white);
    const auto cct = [&](const char* name) { return parse_cct_methods(name).value().front()->cct_k(d65); };
    EXPECT_NEAR(cct("mccamy"), 6505.0805913, 1e-6);
    EXPECT_NEAR(cct("hernandez"), 6500.7420431, 1e-6);
    EXPECT_NEAR(cct("robertson"), 6503.7, 0.1);
    EXPECT_NEAR(cct("fit"), 6504.24, 0.01);
}

TEST(NamedColorMethods, AreNamed) {
    EXPECT_EQ(parse_color_methods("all")->size(), color_methods().size());
    EXPECT_EQ(parse_color_methods("usd,kang")->size(), 2U);
    for (const char* bad : {"", "krystec", "usd,", "usd,,kang"})
        EXPECT_EQ(parse_color_methods(bad).error().failure, Failure::usage) << bad;
    EXPECT_EQ(parse_cct_methods("krystek").error().failure, Failure::usage);
}

} // namespace
} // namespace gonio
