#include <gonio/light/light.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include "quadrature.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <tuple>
#include <utility>

namespace gonio {
namespace {

using std::numbers::pi;

TEST(Light, AProfileShinesAsMeasuredOrAsAsked) {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = test::measured();
    const Web& web = *std::get<ProfileShape>(description.shape).web;
    const Light plain = resolve_light(description, diagnostics).value();
    EXPECT_NEAR(plain.intensity_towards({0.3, 0.2, -1}).value, web.candela({0.3, 0.2, -1}), 1e-9);
    description.intensity = parse_photometric_value("1000lm").value();
    const Light scaled = resolve_light(description, diagnostics).value();
    EXPECT_NEAR(scaled.web_scale * flux(web).value, 1000.0, 1e-9);
}

TEST(Light, TurnsWithItsFrame) {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = test::measured();
    const Light hanging = resolve_light(description, diagnostics).value();
    description.rotation = degrees(90);
    const Light turned = resolve_light(description, diagnostics).value();
    // Rotated from C0 towards C90: light along +X now goes along +Y.
    EXPECT_NEAR(turned.intensity_towards({0.0, 1.0, -1.0}).value, hanging.intensity_towards({1.0, 0.0, -1.0}).value,
                1e-9);
    description.rotation = degrees(0);
    description.direction = {0, 1, 0};
    description.up = {0, 0, 1};
    const Light aimed = resolve_light(description, diagnostics).value();
    EXPECT_NEAR(aimed.intensity_towards({0, 1, 0}).value, hanging.intensity_towards({0, 0, -1}).value, 1e-9);
    // C90 points along `up`.
    EXPECT_NEAR(aimed.intensity_towards({0, 1, 0.5}).value, hanging.intensity_towards({0, 0.5, -1}).value, 1e-9);
}

TEST(Light, RefusesAnAmountThatFloatsCannotHold) {
    const auto reason = [](const char* shape, const char* intensity) {
        Diagnostics diagnostics;
        LightDescription description;
        description.shape = parse_shape(shape).value();
        description.intensity = parse_photometric_value(intensity).value();
        const Result<Light> light = resolve_light(description, diagnostics);
        return light ? "no failure" : light.error().diagnostics.back().message;
    };
    EXPECT_EQ(reason("point", "1e30cd"), "no failure");
    EXPECT_EQ(reason("point", "2e30cd"), "the light has a luminous intensity of 2e+30 cd, above 1e+30 cd");
    EXPECT_EQ(reason("sphere:r=1m", "1e29nt"), "no failure");
    EXPECT_NE(reason("sphere:r=0.000000001m", "1e20cd").find("a luminance of 3"), std::string::npos);
    EXPECT_NE(reason("sun:angle=60deg", "1e30lx").find("a luminance of 1.27"), std::string::npos);
    EXPECT_EQ(reason("sun:angle=180deg", "1e30lx"), "no failure");
    // A profile with almost no light: no factor can give it the requested amount.
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = ProfileShape{
        "dark", std::make_shared<const Web>(*Web::create(Symmetry::axial, {0.0}, {0.0, 90.0}, {1e-320, 0.0}))};
    description.intensity = parse_photometric_value("1000cd").value();
    EXPECT_FALSE(resolve_light(description, diagnostics));
}

TEST(Light, RefusesWhatCannotBePlaced) {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = PointShape{};
    EXPECT_FALSE(resolve_light(description, diagnostics)); // no intensity
    description.intensity = parse_photometric_value("1cd").value();
    EXPECT_TRUE(resolve_light(description, diagnostics));
    description.direction = {0, 0, 0};
    EXPECT_FALSE(resolve_light(description, diagnostics));
    description.direction = {0, 0, -1};
    description.position = {0, 0, NAN};
    EXPECT_FALSE(resolve_light(description, diagnostics));
    description.position = {};
    description.range = Meters(0);
    EXPECT_FALSE(resolve_light(description, diagnostics));
}

Light resolved(const Shape& shape, const char* amount) {
    LightDescription description;
    description.shape = shape;
    description.intensity = parse_photometric_value(amount).value();
    description.position = {1, 2, 3};
    description.direction = {0.3, -0.5, 0.7};
    description.up = {0.1, 0.9, 0.2};
    Diagnostics diagnostics;
    return resolve_light(description, diagnostics).value();
}

// ∬ of the emitted light, over rings around `axis` of its frame (2 = Z, 0 = X), split at the given angles.
double emitted_flux(const Light& light, int axis, std::vector<double> cuts) {
    cuts.insert(cuts.begin(), 0.0);
    cuts.push_back(pi);
    constexpr int around = 720;
    double sum = 0.0;
    for (std::size_t i = 1; i < cuts.size(); ++i)
        sum += test::integral(cuts[i - 1], cuts[i], 2, [&](double theta) {
            double ring = 0.0;
            for (int k = 0; k < around; ++k) {
                const double phi = (k + 0.5) * 2.0 * pi / around;
                const double u = std::sin(theta) * std::cos(phi);
                const double v = std::sin(theta) * std::sin(phi);
                const double w = std::cos(theta);
                const glm::dvec3 local = axis == 2 ? glm::dvec3(u, v, -w) : glm::dvec3(w, u, v);
                ring += light.intensity_towards(light.frame.to_world(2.5 * local)).value;
            }
            return ring * 2.0 * pi / around * std::sin(theta);
        });
    return sum;
}

TEST(Light, EmitsTheFluxThatItWasGiven) {
    for (const char* text : {"point", "sphere:r=3cm", "disk:r=10cm", "disk:r=10cm,two-sided", "ellipse:w=60cm,h=20cm",
                             "rect:w=60cm,h=30cm", "rect:w=60cm,h=30cm,two-sided"})
        EXPECT_NEAR(emitted_flux(resolved(test::shape(text), "800lm"), 2, {pi / 2}), 800.0, 1e-10) << text;
    for (const char* text : {"tube:r=1.3cm,l=1.2m", "tube:r=50cm,l=1mm", "cylinder:r=2cm,l=30cm"})
        EXPECT_NEAR(emitted_flux(resolved(test::shape(text), "800lm"), 0, {pi / 2}), 800.0, 1e-10) << text;
    for (const char* falloff :
         {"frostbite", "hard", "linear-cos", "smoothstep-cos", "linear-angle", "smoothstep-angle"}) {
        const Shape spot = test::shape(std::string("spot:outer=40deg,inner=25deg,falloff=") + falloff);
        const Light light = resolved(spot, "800lm");
        EXPECT_NEAR(emitted_flux(light, 2, {25 * pi / 180, 40 * pi / 180}), 800.0, 1e-10) << falloff;
    }
}

// ∬ over the plane z = −1, where dω is dx dy/(1 + x² + y²)^(3/2), inside the pyramid's edges and a margin outside them.
TEST(Light, AFrustumEmitsTheFluxThatItWasGiven) {
    for (const auto& [text, h, v] :
         {std::tuple{"frustum:h=60deg,v=40deg", 60.0, 40.0}, {"frustum:h=1deg,v=120deg", 1.0, 120.0}}) {
        const Light light = resolved(test::shape(text), "800lm");
        const double edge_x = std::tan(0.5 * h * pi / 180);
        const double edge_y = std::tan(0.5 * v * pi / 180);
        const auto over = [](double edge, auto&& f) {
            double sum = 0.0;
            for (const auto& [low, high] : {std::pair{-2 * edge, -edge}, {-edge, 0.0}, {0.0, edge}, {edge, 2 * edge}})
                sum += test::integral(low, high, 2, f);
            return sum;
        };
        const double flux = over(edge_x, [&](double x) {
            return over(edge_y, [&](double y) {
                const glm::dvec3 local(x, y, -1.0);
                return light.intensity_towards(light.frame.to_world(local)).value / std::pow(glm::length(local), 3);
            });
        });
        EXPECT_NEAR(flux, 800.0, 1e-9) << text;
    }
}

TEST(Light, OfAMaskedShapeEmitsTheFluxThatItWasGiven) {
    // Masks with angles that coincide with the rings and the cuts below; dark in some directions, brightest off the
    // axis.
    const Web mask = test::random_web(Symmetry::none, test::steps(0, 360, 5), test::steps(0, 90, 4), 12);
    std::vector<double> cuts;
    for (const double deg : {25.0, 30.0, 40.0, 60.0, 90.0})
        cuts.push_back(deg * pi / 180);
    for (const char* text : {"point", "spot:outer=40deg,inner=25deg"}) {
        const Light light = resolved(test::masked(test::shape(text), mask), "800lm");
        // Midpoints between planes integrate a function linear in C exactly.
        EXPECT_NEAR(emitted_flux(light, 2, cuts), 800.0, 1e-9) << text;
        EXPECT_DOUBLE_EQ(light.web_scale * peak(mask).intensity.value, 1.0);
    }
}

TEST(Light, CarriesWhatTheShadingReads) {
    const Light tube = resolved(test::shape("tube:r=1cm,l=1m"), "1000nt");
    EXPECT_NEAR(tube.luminance.value, 1000.0, 1e-12);
    EXPECT_NEAR(tube.intensity.value, 1000.0 * (0.02 + pi * 1e-4), 1e-12);
    EXPECT_NEAR(tube.intensity_towards(tube.frame.x).value, 1000.0 * pi * 1e-4, 1e-12); // end-on
    EXPECT_NEAR(tube.intensity_towards(tube.frame.y).value, tube.intensity.value, 1e-12);
    EXPECT_EQ(tube.illuminance.value, 0.0);

    const Light sun = resolved(test::shape("sun:angle=0.53deg"), "100klx");
    EXPECT_EQ(sun.illuminance.value, 100000.0);
    EXPECT_EQ(sun.intensity.value, 0.0);
    EXPECT_NEAR(sun.luminance.value * pi * std::pow(std::sin(0.265 * pi / 180), 2), 100000.0, 1e-9);
    EXPECT_EQ(sun.intensity_towards({1, 0, 0}).value, 0.0);

    const Light spot = resolved(test::shape("spot:outer=40deg"), "100cd");
    EXPECT_EQ(spot.luminance.value, 0.0);
    EXPECT_NEAR(spot.intensity_towards(-spot.frame.z).value, 100.0, 1e-12);
    EXPECT_EQ(spot.intensity_towards(spot.frame.z).value, 0.0);

    // The horizontal angle spans X.
    const Light frustum = resolved(test::shape("frustum:h=60deg,v=40deg"), "100cd");
    const auto towards = [&](double x_deg, double y_deg) {
        const glm::dvec3 local(std::tan(x_deg * pi / 180), std::tan(y_deg * pi / 180), -1.0);
        return frustum.intensity_towards(frustum.frame.to_world(local)).value;
    };
    EXPECT_EQ(towards(29.999, 19.999), 100.0);
    EXPECT_EQ(towards(-29.999, -19.999), 100.0);
    EXPECT_EQ(towards(30.001, 0.0), 0.0);
    EXPECT_EQ(towards(0.0, -20.001), 0.0);
    EXPECT_EQ(frustum.intensity_towards(frustum.frame.z).value, 0.0);
}

} // namespace
} // namespace gonio
