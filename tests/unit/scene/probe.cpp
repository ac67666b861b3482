#include <gonio/base/file.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/reference.hpp>
#include <gonio/shading/brdf_frostbite.hpp>

#include "../reference_rows.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {
namespace {

constexpr double pi = std::numbers::pi;

// Shines straight down from `position` unless `direction` is given.
Light make(std::string_view shape, std::string_view intensity, glm::dvec3 position,
           glm::dvec3 direction = {0.0, 0.0, -1.0}) {
    LightDescription description;
    description.name = shape;
    description.shape = parse_shape(shape).value();
    description.intensity = parse_photometric_value(intensity).value();
    description.position = position;
    description.direction = direction;
    Diagnostics diagnostics;
    return resolve_light(description, diagnostics).value();
}

ProbeResult probe_one(const Light& light, const Receiver& receiver, IrradianceMethod method = IrradianceMethod::exact) {
    ProbeOptions options;
    options.method = method;
    return probe({&light, 1}, {&receiver, 1}, options).value();
}

double lux(const Light& light, const Receiver& receiver, IrradianceMethod method = IrradianceMethod::exact) {
    return probe_one(light, receiver, method).illuminance_lx.at(0);
}

// ∫ L ⟨n·ω⟩⟨m·−ω⟩ / d² dA over a plane emitter by the midpoint rule: uses no outline.
double by_area(const glm::dvec3& center, const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& axis, bool disk,
               const Receiver& receiver) {
    constexpr int steps = 1500;
    double sum = 0.0;
    for (int j = 0; j < steps; ++j)
        for (int i = 0; i < steps; ++i) {
            const double u = (i + 0.5) / steps * 2.0 - 1.0;
            const double v = (j + 0.5) / steps * 2.0 - 1.0;
            // For a disk: equal areas in radius² and azimuth.
            const double radius = std::sqrt((u + 1.0) / 2.0);
            const glm::dvec3 offset =
                disk ? x * (radius * std::cos(pi * v)) + y * (radius * std::sin(pi * v)) : x * u + y * v;
            const glm::dvec3 way = center + offset - receiver.position;
            const double d2 = glm::dot(way, way);
            sum += std::max(glm::dot(way, receiver.normal), 0.0) * std::max(-glm::dot(way, axis), 0.0) / (d2 * d2);
        }
    const double area = disk ? pi * glm::length(x) * glm::length(y) : 4.0 * glm::length(x) * glm::length(y);
    return sum / (steps * steps) * area;
}

TEST(Probe, PointIsCosineOverSquare) {
    const Light light = make("point", "100cd", {1.0, 2.0, 3.0});
    const Receiver receiver{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    EXPECT_NEAR(lux(light, receiver), 100.0 * (3.0 / std::sqrt(14.0)) / 14.0, 1e-14);
    EXPECT_EQ(lux(light, {{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}}), 0.0);
    // Lumens of a point are 4π candela; a normal of any length is a direction.
    EXPECT_NEAR(lux(make("point", "800lm", {0, 0, 2}), {{0, 0, 0}, {0, 0, 1e-300}}), 800.0 / (4.0 * pi) / 4.0, 1e-13);
    EXPECT_NEAR(lux(make("point", "800lm", {0, 0, 2}), {{0, 0, 0}, {0, 0, 1e300}}), 800.0 / (4.0 * pi) / 4.0, 1e-13);
}

TEST(Probe, SpotFallsOffSquaredInTheCosine) {
    const Light light = make("spot:outer=40deg,inner=20deg", "1000cd", {0.0, 0.0, 2.0});
    const double a = std::cos(degrees(20).value);
    const double b = std::cos(degrees(40).value);
    for (const double deg : {0.0, 10.0, 25.0, 30.0, 39.0, 41.0}) {
        const double theta = degrees(deg).value;
        const double lobe = std::pow(std::clamp((std::cos(theta) - b) / (a - b), 0.0, 1.0), 2.0);
        const double cosine = std::cos(theta);
        EXPECT_NEAR(lux(light, {{2.0 * std::tan(theta), 0.0, 0.0}, {0, 0, 1}}),
                    1000.0 * lobe * cosine * cosine * cosine / 4.0, 1e-9)
            << deg;
    }
}

TEST(Probe, SphereIsItsClosedForm) {
    const Light light = make("sphere:r=50cm", "1000nt", {0.0, 0.0, 2.0});
    EXPECT_NEAR(lux(light, {{0, 0, 0}, {0, 0, 1}}), 1000.0 * pi * 0.0625, 1e-11);
    // Half below the horizon: L (atan(tanσ) − sinσ cosσ) = L (σ − sinσ cosσ).
    const double sigma = std::asin(0.25);
    EXPECT_NEAR(lux(light, {{0, 0, 0}, {1, 0, 0}}), 1000.0 * (sigma - std::sin(sigma) * std::cos(sigma)), 1e-11);
}

TEST(Probe, SunIsACapThatNoPositionChanges) {
    const Light sun = make("sun:angle=0.53deg", "100000lx", {7, 7, 7}, {0, 0.6, -0.8});
    for (const glm::dvec3 at : {glm::dvec3(0.0), glm::dvec3(1e90, -3.0, 12.0)})
        EXPECT_NEAR(lux(sun, {at, {0, 0, 1}}), 80000.0, 1e-6);
    EXPECT_EQ(lux(sun, {{0, 0, 0}, {0, 0, -1}}), 0.0);
    // On the horizon half of the disk is left: L (σ − sinσ cosσ), L = E/(π sin²σ).
    const double sigma = degrees(0.265).value;
    const double nt = 1e5 / (pi * std::sin(sigma) * std::sin(sigma));
    EXPECT_NEAR(lux(sun, {{0, 0, 0}, {0, 0.8, 0.6}}) / (nt * (sigma - std::sin(sigma) * std::cos(sigma))), 1.0, 1e-7);
    // The widest sun is a hemisphere: π L (1 + cosθ)/2, and never more.
    const Light sky = make("sun:angle=180deg", "1000nt", {0, 0, 0});
    for (const double deg : {0.0, 30.0, 90.0, 120.0, 180.0})
        EXPECT_NEAR(lux(sky, {{0, 0, 0}, {std::sin(degrees(deg).value), 0.0, std::cos(degrees(deg).value)}}),
                    1000.0 * pi * (1.0 + std::cos(degrees(deg).value)) / 2.0, 1e-9)
            << deg;
}

TEST(Probe, PlaneEmittersAgreeWithTheSumOverTheirArea) {
    const glm::dvec3 center(0.4, -0.3, 1.5);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.2, 0.1, -1.0));
    const Light rect = make("rect:w=120cm,h=60cm", "1000nt", center, direction);
    const Light disk = make("disk:r=50cm", "1000nt", center, direction);
    for (const Receiver& receiver :
         {Receiver{{0, 0, 0}, {0, 0, 1}}, Receiver{{0.3, 0.4, 0.2}, glm::normalize(glm::dvec3(1, 0.3, 0.2))}}) {
        const double of_rect =
            by_area(center, rect.frame.x * 0.6, rect.frame.y * 0.3, direction, false, receiver) * 1000.0;
        const double of_disk =
            by_area(center, disk.frame.x * 0.5, disk.frame.y * 0.5, direction, true, receiver) * 1000.0;
        EXPECT_NEAR(lux(rect, receiver) / of_rect, 1.0, 2e-5);
        EXPECT_NEAR(lux(disk, receiver) / of_disk, 1.0, 2e-5);
    }
}

// Beyond its end a receiver sees past the flat end, which is dark.
TEST(Probe, ReferenceOfACylinderIsTheExactForm) {
    LightDescription description;
    description.shape = parse_shape("cylinder:r=10cm,l=30cm").value();
    description.intensity = parse_photometric_value("900lm").value();
    description.position = {0.0, 0.0, 1.0};
    Diagnostics diagnostics;
    const Light light = resolve_light(description, diagnostics).value();
    for (const glm::dvec3 at : {glm::dvec3(0.0, 0.0, 0.0), glm::dvec3(0.3, 0.2, 0.9), glm::dvec3(0.6, 0.11, 0.97),
                                glm::dvec3(-2.0, 0.5, 0.8), glm::dvec3(1.0, 0.09, 0.99)}) {
        for (const glm::dvec3 normal : {glm::dvec3(0, 0, 1), glm::dvec3(-0.6, 0, 0.8), glm::dvec3(0, -1, 0)}) {
            const Receiver receiver{at, normal};
            const double exact = probe({&light, 1}, {&receiver, 1}).value().illuminance_lx.front();
            const ReferenceValue reference = reference_illuminance(light, at, normal, {1e-8, 4'000'000});
            EXPECT_NEAR(reference.value, exact, 1e-6 * exact + 1e-9) << at.x << ' ' << normal.x;
        }
    }
    // What is left of two integrals reaches the error that is asked for.
    std::mt19937 engine(17);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    for (int i = 0; i < 60; ++i) {
        const double x = between(0.2, 1.5);
        const double y = between(-0.5, 0.5);
        const glm::dvec3 at(x, y, between(0.5, 1.5));
        const ReferenceValue reference = reference_illuminance(light, at, {-0.8, 0.0, 0.6}, {1e-6, 1'000'000});
        EXPECT_TRUE(reference.converged) << at.x << ' ' << at.y << ' ' << at.z;
    }
    // On the side half of all around is light.
    const Receiver on_side{{0.0, 0.1, 1.0}, {0.0, 0.6, 0.8}};
    const double exact = probe({&light, 1}, {&on_side, 1}).value().illuminance_lx.front();
    EXPECT_NEAR(exact, light.luminance.value * std::numbers::pi * 0.5 * (1.0 - 0.6), 1e-9 * exact);
    EXPECT_NEAR(reference_illuminance(light, on_side.position, on_side.normal, {1e-8, 1'000'000}).value, exact,
                1e-6 * exact);
}

// Poses of every area shape to 17 digits, each placed as a light: checks that widths and axes have the right
// directions.
TEST(Probe, AgreesWithTheReference) {
    int poses = 0;
    for (const auto& [kind, v] : test::irradiance_rows()) {
        const glm::dvec3 axis(v[3], v[4], v[5]);
        LightDescription light;
        light.intensity = parse_photometric_value("1nt").value();
        light.position = {v[0], v[1], v[2]};
        if (kind == "sphere") {
            light.shape = SphereShape{Meters(v[9])};
        } else if (kind == "tube") {
            // The axis is X = Y×Z: any Z perpendicular to it will do.
            const glm::dvec3 y = glm::cross(axis, std::abs(axis.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
            light.shape = TubeShape{Meters(v[9]), Meters(v[10])};
            light.direction = -glm::cross(axis, y);
            light.up = y;
        } else {
            light.direction = axis;
            light.up = glm::cross(-axis, glm::dvec3(v[6], v[7], v[8]));
            if (kind == "disk")
                light.shape = DiskShape{Meters(v[9])};
            else
                light.shape = RectShape{Meters(v[9]), Meters(v[10])};
        }
        Diagnostics diagnostics;
        const double e = lux(resolve_light(light, diagnostics).value(), {{0, 0, 0}, {v[11], v[12], v[13]}});
        EXPECT_NEAR(e, v[14], 1e-10 * std::max(v[14], 1e-6)) << kind << " at row " << poses;
        ++poses;
    }
    EXPECT_EQ(poses, 1000);
}

TEST(Probe, TwoSidedShapesLightBothSides) {
    for (const char* const shape : {"rect:w=60cm,h=30cm", "disk:r=20cm", "ellipse:w=60cm,h=20cm"}) {
        const Light one = make(shape, "1000nt", {0, 0, 2});
        const Light two = make(std::string(shape) + ",two-sided", "1000nt", {0, 0, 2});
        const Receiver below{{0.5, 0, 0}, {0, 0, 1}};
        const Receiver above{{0.5, 0, 4}, {0, 0, -1}};
        EXPECT_GT(lux(one, below), 0.0);
        EXPECT_EQ(lux(one, above), 0.0);
        EXPECT_EQ(lux(two, below), lux(one, below));
        EXPECT_NEAR(lux(two, above), lux(two, below), 1e-10);
    }
}

TEST(Probe, EveryShapeIsAPointFromAfar) {
    for (const char* const shape : {"sphere:r=10cm", "disk:r=10cm", "ellipse:w=20cm,h=8cm", "rect:w=20cm,h=10cm",
                                    "tube:r=2cm,l=30cm", "cylinder:r=2cm,l=30cm"}) {
        const Light light = make(shape, "800lm", {0, 0, 0});
        const Receiver receiver{{30.0, 10.0, -40.0}, glm::normalize(glm::dvec3(-3, 1, 2))};
        const double exact = lux(light, receiver);
        EXPECT_GT(exact, 0.0) << shape;
        for (const IrradianceMethod method :
             {IrradianceMethod::frostbite, IrradianceMethod::ue4, IrradianceMethod::point}) {
            // The line of ue4 ignores direction, and that of Frostbite overlaps its sphere: the tolerance is wide for
            // both.
            const double tolerance =
                std::string_view(shape).starts_with("tube") && method != IrradianceMethod::point ? 0.5 : 1e-3;
            EXPECT_NEAR(lux(light, receiver, method) / exact, 1.0, tolerance) << shape << " " << to_text(method);
        }
    }
}

TEST(Probe, RangeIsTheSquaredWindowFromTheCentre) {
    for (const char* const shape : {"point", "sphere:r=10cm", "rect:w=60cm,h=30cm", "tube:r=2cm,l=1m"}) {
        Light light = make(shape, "800lm", {0, 0, 2});
        const Receiver receiver{{1.0, 0.0, 0.0}, {0, 0, 1}};
        const double whole = lux(light, receiver);
        light.range = Meters(4.0);
        const double x = std::sqrt(5.0) / 4.0;
        EXPECT_NEAR(lux(light, receiver) / whole, std::pow(1.0 - std::pow(x, 4.0), 2.0), 1e-14) << shape;
        EXPECT_EQ(lux(light, {{4.0, 0.0, 0.0}, {0, 0, 1}}), 0.0) << shape;
    }
}

TEST(Probe, GuardsBelongToMethods) {
    const Light light = make("point", "1cd", {0, 0, 0.005});
    const Receiver receiver{{0, 0, 0}, {0, 0, 1}};
    EXPECT_NEAR(lux(light, receiver), 40000.0, 1e-8);
    EXPECT_NEAR(lux(light, receiver, IrradianceMethod::frostbite), 10000.0, 1e-9);
    EXPECT_NEAR(lux(light, receiver, IrradianceMethod::ue4), 1.0 / (0.005 * 0.005 + 0.01 * 0.01), 1e-9);
    EXPECT_NEAR(lux(light, receiver, IrradianceMethod::point), 40000.0, 1e-8);
}

TEST(Probe, OnAPointLightIsDarkAndSaid) {
    const Light light = make("point", "1cd", {1, 2, 3});
    const ProbeResult result = probe_one(light, {{1, 2, 3}, {0, 0, 1}});
    EXPECT_EQ(result.illuminance_lx[0], 0.0);
    const Diagnostics said = to_diagnostics(result.remarks, {&light, 1});
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].severity, Severity::warning);
    EXPECT_EQ(said[0].message, "point 1 lies on 'point', which counts as a point: its light is 0 there");
}

TEST(Probe, InsideALightIsPiAndSaid) {
    for (const char* const shape : {"sphere:r=50cm", "tube:r=50cm,l=1m"}) {
        const Light light = make(shape, "1000nt", {0, 0, 0});
        const ProbeResult result = probe_one(light, {{0.2, 0.1, 0.1}, {0, 1, 1}});
        EXPECT_NEAR(result.illuminance_lx[0], 1000.0 * pi, 1e-9);
        EXPECT_EQ(to_diagnostics(result.remarks, {&light, 1}).at(0).severity, Severity::note);
        EXPECT_EQ(probe_one(light, {{2, 0, 0}, {-1, 0, 0}}).remarks.inside.count, 0U);
    }
}

TEST(Probe, LambertLuminanceIsTheIlluminance) {
    const Light light = make("rect:w=60cm,h=30cm", "3000lm", {0, 0.2, 2});
    const Receiver receiver{{0, 0, 0}, {0, 0, 1}};
    ProbeOptions options;
    options.view = ProbeView{{0, -3, 1}, parse_material("lambert:albedo=0.25").value()};
    const ProbeResult result = probe({&light, 1}, {&receiver, 1}, options).value();
    EXPECT_NEAR(result.luminance[0].diffuse.value, result.illuminance_lx[0] * 0.25 / pi, 1e-12);
    EXPECT_EQ(result.luminance[0].specular.value, 0.0);
    options.view->direction = {0, 0, -1}; // from below nothing is seen
    EXPECT_EQ(probe({&light, 1}, {&receiver, 1}, options).value().luminance[0].diffuse.value, 0.0);
}

TEST(Probe, FrostbiteLuminanceIsItsBrdfTimesLux) {
    Light light = make("point", "500cd", {1, -0.5, 2});
    light.color = parse_light_color("rgb(1,0.4,0.1)").value();
    const Receiver receiver{{0, 0, 0}, {0, 0, 1}};
    const glm::dvec3 v = glm::normalize(glm::dvec3(-1, 0.5, 1.5));
    ProbeOptions options;
    options.view = ProbeView{v * 3.0, parse_material("frostbite:base=rgb(0.6,0.3,0.1),smoothness=0.7").value()};
    const ProbeResult result = probe({&light, 1}, {&receiver, 1}, options).value();
    const glm::dvec3 l = glm::normalize(light.frame.origin);
    const auto material = shading::frostbite_material(shading::vec3<double>{0.6, 0.3, 0.1}, 0.7, 0.0, 0.5);
    const auto f = shading::brdf(material, {0, 0, 1}, {l.x, l.y, l.z}, {v.x, v.y, v.z});
    const double expected =
        glm::dot(glm::dvec3(f.x, f.y, f.z) * light.color, rec709_luminance) * result.illuminance_lx[0];
    EXPECT_NEAR((result.luminance[0].diffuse + result.luminance[0].specular).value / expected, 1.0, 1e-12);
    EXPECT_GT(result.luminance[0].specular.value, 0.0);
    options.method = IrradianceMethod::ue4;
    EXPECT_EQ(probe({&light, 1}, {&receiver, 1}, options).error().failure, Failure::unsupported);
}

// The named methods on every area light: without a lobe they give the exact diffuse part; for a light that is small
// against the lobe they agree with the exact integral; and a range reduces them as it reduces the exact result.
TEST(Probe, NamedMethodsAgreeWhereTheyMust) {
    const Receiver receiver{{0, 0, 0}, {0, 0, 1}};
    const auto seen = [&](const Light& light, std::string_view material, IrradianceMethod method) {
        ProbeOptions options;
        options.method = method;
        options.view = ProbeView{{-0.6, 0.1, 1.0}, parse_material(material).value()};
        return probe({&light, 1}, {&receiver, 1}, options).value().luminance.at(0);
    };
    for (const char* const shape : {"sphere:r=3mm", "disk:r=3mm", "ellipse:w=6mm,h=2mm", "rect:w=6mm,h=4mm",
                                    "tube:r=1mm,l=5mm", "cylinder:r=1mm,l=5mm", "sun:angle=0.1deg"}) {
        const bool sun = std::string_view(shape).starts_with("sun");
        Light light = make(shape, sun ? "900lx" : "900lm", {1.3, -0.4, 2.0}, {-1.3, 0.4, -2.0});
        light.color = parse_light_color("rgb(1,0.5,0.2)").value();
        for (const IrradianceMethod method :
             {IrradianceMethod::ltc, IrradianceMethod::representative_point, IrradianceMethod::dominant_direction,
              IrradianceMethod::specular_d, IrradianceMethod::spherical_hack, IrradianceMethod::sun_disk}) {
            const auto because = [&] {
                return std::string(shape) + " by method " + std::to_string(static_cast<int>(method));
            };
            for (const char* matte : {"lambert:albedo=0.5", "eon:albedo=0.5,roughness=0.7"}) {
                const ProbeLuminance named = seen(light, matte, method);
                const ProbeLuminance exact = seen(light, matte, IrradianceMethod::exact);
                EXPECT_EQ(named.specular.value, 0.0) << because();
                // For a rough surface the BRDF towards the centre represents the whole light: a seventh of a degree.
                EXPECT_NEAR(named.diffuse.value / exact.diffuse.value, 1.0, matte[0] == 'l' ? 1e-5 : 2e-3) << because();
            }
            const ProbeLuminance named = seen(light, "ggx:alpha=0.4", method);
            const ProbeLuminance exact = seen(light, "ggx:alpha=0.4", IrradianceMethod::exact);
            // ltc is a fit of the lobe; the others widen the lobe by the light's size, 4 % at ten times these sizes.
            EXPECT_NEAR(named.specular.value / exact.specular.value, 1.0, method == IrradianceMethod::ltc ? 0.06 : 0.01)
                << because();
            if (sun) continue;
            Light ranged = light;
            ranged.range = Meters(4.0);
            EXPECT_NEAR(seen(ranged, "ggx:alpha=0.4", method).specular.value / named.specular.value,
                        lux(ranged, receiver) / lux(light, receiver), 2e-3)
                << because();
        }
    }
}

TEST(Probe, RefusesWhatHasNoMeaning) {
    const Light light = make("point", "1cd", {0, 0, 1});
    constexpr double inf = std::numeric_limits<double>::infinity();
    const auto message = [&](const Receiver& receiver) {
        const auto result = probe({&light, 1}, {&receiver, 1});
        return result ? std::string("no failure") : result.error().diagnostics.back().message;
    };
    EXPECT_EQ(message({{0, 0, 0}, {0, 0, 0}}), "the normal of point 1 is zero or not finite");
    EXPECT_EQ(message({{0, 0, 0}, {0, inf, 0}}), "the normal of point 1 is zero or not finite");
    EXPECT_EQ(message({{0, -inf, 0}, {0, 0, 1}}), "the position of point 1 is out of range");
    EXPECT_EQ(message({{0, 0, 2e100}, {0, 0, 1}}), "the position of point 1 is out of range");
}

TEST(Probe, WhatEndsAtTheCeilingIsTold) {
    const std::vector<Light> lights{make("point", "1cd", {0, 0, 1}), make("point", "1e30cd", {0, 0, 1})};
    const auto warnings = [&](double height, ProbeOptions options) {
        const Receiver receiver{{0, 0, height}, {0, 0, 1}};
        const auto result = probe(lights, {&receiver, 1}, options);
        EXPECT_TRUE(result);
        std::string text;
        for (const Diagnostic& said : to_diagnostics(result->remarks, lights))
            text += to_text(said) + "\n";
        return text;
    };
    EXPECT_EQ(warnings(-1.0, {}), "");
    const std::string at_once = warnings(0.5, {});
    EXPECT_NE(at_once.find("warning[RES0203]: the light of '"), std::string::npos) << at_once;
    EXPECT_NE(at_once.find("at point 1 is limited to 1e+30 lx or cd/m2"), std::string::npos);
    // The luminance of a surface is limited too, even where the illuminance itself is in range.
    ProbeOptions mirror;
    mirror.view = ProbeView{{0.0, 0.0, 1.0}, *parse_material("ggx:alpha=0.001")};
    EXPECT_NE(warnings(-1.0, mirror).find("is limited to"), std::string::npos);
}

// Adversarial positions and sizes: never NaN, never negative, never above the ceiling.
TEST(Probe, ResultsAreFiniteEverywhere) {
    const std::vector<double> sizes{1e-300, 1e-150, 1e-9, 1e-3, 1.0, 1e3, 1e20, 1e100};
    std::mt19937_64 random(7);
    const auto pick = [&] {
        const double size = sizes[random() % sizes.size()];
        return random() % 4 == 0 ? 0.0 : random() % 2 == 0 ? size : -size;
    };
    for (const char* const shape :
         {"point", "spot:outer=90deg", "frustum:h=60deg,v=40deg", "sphere:r=1km", "sphere:r=0.000000001m", "disk:r=1m",
          "ellipse:w=3m,h=1m", "rect:w=1m,h=0.000000001m", "rect:w=1000km,h=1km,two-sided", "tube:r=1mm,l=1000km",
          "tube:r=1m,l=1m", "cylinder:r=1m,l=1m", "sun:angle=90deg"}) {
        const bool sun = std::string_view(shape).starts_with("sun");
        const bool tiny = std::string_view(shape).find("0.000000001m") != std::string_view::npos;
        const char* const most = sun ? "1e30lx" : tiny ? "1e29nt" : "1e30cd";
        for (int i = 0; i < 4000; ++i) {
            const glm::dvec3 direction(pick(), pick(), pick());
            const glm::dvec3 normal(pick(), pick(), pick());
            if (direction == glm::dvec3(0.0) || normal == glm::dvec3(0.0)) continue;
            const double longest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
            const Light light = make(shape, most, {pick(), pick(), pick()}, direction / longest);
            const Receiver receiver{{pick(), pick(), pick()}, normal};
            for (const IrradianceMethodName& method : irradiance_methods()) {
                if (method.method == IrradianceMethod::reference && i % 40 != 0)
                    continue; // takes a thousand times as long
                const double lx = lux(light, receiver, method.method);
                EXPECT_TRUE(lx >= 0.0 && lx <= 1e30) << shape << " " << method.name << " " << lx;
            }
        }
    }
}

TEST(Probe, ParallelSumsDoNotDependOnThreads) {
    std::vector<Light> lights;
    std::mt19937_64 random(3);
    const auto coordinate = [&] { return static_cast<double>(random() % 2001) / 100.0 - 10.0; };
    const std::vector<const char*> shapes{
        "point",           "sphere:r=10cm",      "disk:r=10cm", "ellipse:w=60cm,h=20cm", "rect:w=60cm,h=30cm",
        "tube:r=1cm,l=1m", "cylinder:r=1cm,l=1m"};
    for (std::size_t i = 0; i < 10000; ++i)
        lights.push_back(make(shapes[i % shapes.size()], "800lm", {coordinate(), coordinate(), 3.0}));
    std::vector<Receiver> receivers;
    for (int i = 0; i < 20; ++i)
        receivers.push_back({{coordinate(), coordinate(), 0.0}, {0.1, 0.2, 1.0}});
    ProbeOptions options;
    options.parts = true;
    options.threads = 1;
    const ProbeResult one = probe(lights, receivers, options).value();
    for (const unsigned threads : {2U, 5U}) {
        options.threads = threads;
        const ProbeResult many = probe(lights, receivers, options).value();
        EXPECT_EQ(many.illuminance_lx, one.illuminance_lx);
        EXPECT_EQ(many.parts_lx, one.parts_lx);
    }
    // The sum equals the sum of the parts.
    for (std::size_t r = 0; r < receivers.size(); ++r) {
        long double sum = 0.0L;
        for (std::size_t l = 0; l < lights.size(); ++l)
            sum += static_cast<long double>(one.parts_lx[r * lights.size() + l]);
        EXPECT_NEAR(one.illuminance_lx[r] / static_cast<double>(sum), 1.0, 1e-12);
    }
}

TEST(Probe, SpreadIsMinMeanMax) {
    const std::vector<double> values{2.0, 8.0, 5.0};
    const Spread s = spread(values);
    EXPECT_EQ(s.least, 2.0);
    EXPECT_DOUBLE_EQ(s.mean, 5.0);
    EXPECT_EQ(s.greatest, 8.0);
    EXPECT_DOUBLE_EQ(s.uniformity(), 0.4);
    EXPECT_DOUBLE_EQ(s.diversity(), 0.25);
    EXPECT_EQ(spread({}).uniformity(), 0.0);
    EXPECT_EQ(spread(std::vector<double>{0.0, 0.0}).diversity(), 0.0);
}

TEST(Probe, MethodsAreKnownByName) {
    for (const IrradianceMethodName& method : irradiance_methods()) {
        EXPECT_EQ(parse_irradiance_method(method.name).value(), method.method);
        EXPECT_EQ(to_text(method.method), method.name);
    }
    EXPECT_FALSE(parse_irradiance_method("exakt"));
}

// Lights in parts of any size give the values of all at once to the last bit, and the same remarks.
TEST(Probe, SumOfPartsIsThatOfAll) {
    std::mt19937 random(9);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    std::vector<Light> lights;
    for (int i = 0; i < 9000; ++i)
        lights.push_back(make(i % 3 == 0   ? "point"
                              : i % 3 == 1 ? "sphere:r=20cm"
                                           : "disk:r=30cm",
                              "800lm", {between(-20.0, 20.0), between(-20.0, 20.0), between(2.0, 5.0)}));
    lights[7002].name = "around it"; // a point
    lights[7002].frame.origin = {1.0, 2.0, 0.0};
    lights[5002].name = "over it"; // a sphere
    lights[5002].frame.origin = {3.0, 3.0, 0.1};
    const std::vector<Receiver> receivers{{{1.0, 2.0, 0.0}}, {{3.0, 3.0, 0.0}}, {{-5.0, 9.0, 0.0}, {0.3, 0.0, 1.0}}};
    for (const bool has_view : {false, true}) {
        ProbeOptions options;
        options.threads = 2;
        if (has_view) options.view = ProbeView{{1.0, 0.0, 0.2}, parse_material("lambert:albedo=0.5").value()};
        const ProbeResult all = probe(lights, receivers, options).value();
        for (const std::size_t most : {1U, 1000U, 4096U, 5000U, 20000U}) {
            ProbeSum sum = ProbeSum::of(receivers, options).value();
            for (std::size_t first = 0; first < lights.size();) {
                const std::size_t size = std::min(lights.size() - first, most == 1 ? 1 + random() % 7 : most);
                ASSERT_TRUE(sum.add(std::span(lights).subspan(first, size)));
                first += size;
            }
            const ProbeResult parts = sum.result();
            EXPECT_EQ(sum.lights(), lights.size());
            EXPECT_EQ(parts.illuminance_lx, all.illuminance_lx);
            ASSERT_EQ(parts.luminance.size(), all.luminance.size());
            for (std::size_t r = 0; r < all.luminance.size(); ++r)
                EXPECT_EQ(parts.luminance[r].diffuse.value, all.luminance[r].diffuse.value);
            const Diagnostics said = to_diagnostics(parts.remarks, sum.remarked());
            const Diagnostics expected = to_diagnostics(all.remarks, lights);
            ASSERT_EQ(said.size(), expected.size());
            EXPECT_GE(said.size(), 2U); // on a light, and in one
            for (std::size_t i = 0; i < said.size(); ++i)
                EXPECT_EQ(to_text(said[i]), to_text(expected[i]));
        }
    }
    EXPECT_EQ(ProbeSum::of(receivers).value().result().illuminance_lx, (std::vector{0.0, 0.0, 0.0}));
    EXPECT_FALSE(ProbeSum::of(std::vector<Receiver>{{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}}));
}

} // namespace
} // namespace gonio
