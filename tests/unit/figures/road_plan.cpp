// Planned roads: against closed forms and a plain sum, under mirrors and scales, and no wider apart than they may be.
#include <gonio/figures/disability_glare.hpp>
#include <gonio/figures/road_plan.hpp>

#include "lambertian.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace gonio {
namespace {

LightDescription luminaire(Web web, double flux_lm = 0.0) {
    ProfileShape profile;
    profile.web = std::make_shared<const Web>(std::move(web));
    LightDescription light;
    light.name = "luminaire";
    light.shape = profile;
    if (flux_lm > 0.0) light.intensity = parse_photometric_value(std::to_string(flux_lm) + "lm").value();
    return light;
}

// A street luminaire: brightest at C 20° and 160° from the road, at γ 65°; nothing to the back.
Web street_web() {
    std::vector<double> cs;
    std::vector<double> gammas;
    std::vector<double> candela;
    for (int c = 0; c <= 360; c += 10)
        cs.push_back(c);
    for (int gamma = 0; gamma <= 90; gamma += 5)
        gammas.push_back(gamma);
    for (const double c : cs)
        for (const double gamma : gammas) {
            const double from_road_deg = std::min(std::abs(c - 20.0), std::abs(c - 160.0));
            const double lobe = std::exp(-std::pow(from_road_deg / 40.0, 2.0) - std::pow((gamma - 65.0) / 20.0, 2.0));
            candela.push_back(gamma == 90.0 ? 0.0 : 300.0 + (c <= 180.0 && gamma > 0.0 ? 3000.0 * lobe : 0.0));
        }
    return *Web::create(Symmetry::none, cs, gammas, candela);
}

// r = ρ cos³γ/π of a matte road, at the angles of the standard table.
RoadSurface matte_surface(double albedo) {
    RoadSurface surface = known_road_surfaces().front();
    for (std::size_t i = 0; i < surface.r.size(); ++i) {
        const double tan_gamma = surface.tan_gamma[i / surface.beta_deg.size()];
        surface.r[i] = 1e4 * albedo / std::numbers::pi * std::pow(1.0 + tan_gamma * tan_gamma, -1.5);
    }
    return surface;
}

RoadPlanRequest road(double width_m = 7.0, double spacing_m = 30.0, double height_m = 8.0) {
    RoadPlanRequest request;
    request.surface = known_road_surfaces().front();
    request.width_m = width_m;
    request.spacing_m = spacing_m;
    request.height_m = height_m;
    request.maintenance_factor = 1.0;
    request.street_side_c_deg = 90.0;
    return request;
}

RoadPlan planned(const LightDescription& light, const RoadPlanRequest& request) {
    Diagnostics diagnostics;
    return plan_road(light, request, diagnostics).value();
}

std::string failure(const RoadPlanRequest& request) {
    Diagnostics diagnostics;
    const Result<RoadPlan> plan = plan_road(luminaire(street_web()), request, diagnostics);
    return plan ? std::string("planned") : plan.error().diagnostics.back().message;
}

TEST(RoadSurface, R3HasTheFiguresThatItIsKnownBy) {
    const RoadSurface& r3 = known_road_surfaces().front();
    ASSERT_EQ(r3.r.size(), 29 * 20);
    EXPECT_NEAR(r3.specular_factor(), 1.11, 0.005);
    EXPECT_DOUBLE_EQ(r3.reduced_coefficient(0.0, 0.0), 0.0294);
    EXPECT_DOUBLE_EQ(r3.reduced_coefficient(2.0, 180.0), 0.0038);
    EXPECT_DOUBLE_EQ(r3.reduced_coefficient(12.0, 0.0), 0.0053);
    EXPECT_DOUBLE_EQ(r3.reduced_coefficient(12.001, 0.0), 0.0);
    // Between angles it is linear in both.
    EXPECT_NEAR(r3.reduced_coefficient(0.375, 1.0), 0.25e-4 * (326 + 326 + 344 + 344), 1e-12);
    EXPECT_NEAR(r3.reduced_coefficient(2.25, 12.5), 0.25e-4 * (190 + 136 + 127 + 86), 1e-12);
    // Q0: the mean of q over the solid angle of the area that luminaires are in, −4 to 12 by ± 3 heights.
    double sum = 0.0;
    double solid_angle = 0.0;
    constexpr int steps = 400;
    for (int i = 0; i < 2 * steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const double x = -4.0 + 16.0 * (i + 0.5) / (2 * steps);
            const double y = 3.0 * (k + 0.5) / steps;
            sum += r3.reduced_coefficient(std::hypot(x, y), std::atan2(y, x) * 180.0 / std::numbers::pi);
            solid_angle += std::pow(1.0 + x * x + y * y, -1.5);
        }
    EXPECT_NEAR(sum / solid_angle, 0.07, 0.002); // the standard sums with few and rounded weights
}

TEST(RoadSurface, IsReadWithAndWithoutHeadings) {
    std::string bare = "# R3\nq0 0.07\n";
    std::string headed = "tan/beta";
    const RoadSurface& r3 = known_road_surfaces().front();
    for (const double beta : r3.beta_deg)
        headed += ";" + std::to_string(static_cast<int>(beta));
    for (std::size_t i = 0; i < r3.tan_gamma.size(); ++i) {
        headed += "\n" + std::to_string(r3.tan_gamma[i]);
        for (std::size_t k = 0; k < r3.beta_deg.size(); ++k) {
            const std::string number = std::to_string(r3.r[i * r3.beta_deg.size() + k]);
            bare += (k == 0 ? "" : "\t") + number;
            headed += ";" + number;
        }
        bare += '\n';
    }
    std::replace(headed.begin(), headed.end(), '.', ',');
    for (const std::string& text : {bare, headed}) {
        const Result<RoadSurface> surface = parse_road_surface(text, "own.csv");
        ASSERT_TRUE(surface) << surface.error().diagnostics.back().message;
        EXPECT_EQ(surface->r, r3.r);
        EXPECT_EQ(surface->tan_gamma, r3.tan_gamma);
        EXPECT_EQ(surface->beta_deg, r3.beta_deg);
    }
    EXPECT_EQ(parse_road_surface(bare, "own.csv")->average, 0.07);
    EXPECT_DOUBLE_EQ(with_average(r3, 0.08)->reduced_coefficient(0.0, 0.0), 0.0294 * 8.0 / 7.0);
    EXPECT_FALSE(with_average(*parse_road_surface(headed, "own.csv"), 0.08));
    EXPECT_FALSE(with_average(r3, 1.5));
    EXPECT_FALSE(with_average(r3, std::nan("")));
}

TEST(RoadSurface, SaysWhereATableIsWrong) {
    struct Case {
        const char* text;
        std::uint32_t line;
        std::uint32_t column;
    };
    for (const Case& tried :
         {Case{"0 90 180\n0 1 2 x\n1 1 2 3\n", 2, 7}, Case{"0 90 180\n0 1 2 -3\n1 1 2 3\n", 2, 7},
          Case{"0 90 180\n0 1 2 3\n1 1 2\n", 3, 1}, Case{"0 90 170\n0 1 2 3\n1 1 2 3\n", 1, 1},
          Case{"0 90 180\n1 1 2 3\n2 1 2 3\n", 3, 1}, Case{"0 90 180\n0 0 0 0\n1 0 0 0\n", 3, 1},
          Case{"q0 7\n0 90 180\n0 1 2 3\n1 1 2 3\n", 1, 4}, Case{"", 0, 1},
          Case{"0 90 180\n0 1 2 1e999\n1 1 2 3\n", 2, 7}, Case{"0 90 90 180\n0 1 2 3 4\n1 1 2 3 4\n", 1, 1}}) {
        const Result<RoadSurface> surface = parse_road_surface(tried.text, "own.csv");
        ASSERT_FALSE(surface) << tried.text;
        const Diagnostic& said = surface.error().diagnostics.back();
        EXPECT_EQ(said.location.line, tried.line) << tried.text;
        EXPECT_EQ(said.location.column, tried.column) << tried.text;
    }
}

// The two places of a worked example in double precision: 1000 cd, 10 m high, an eye at 1.5 m that looks 1° down.
TEST(DisabilityGlare, HasTheVeilOfAWorkedExample) {
    LightDescription lamp;
    lamp.shape = PointShape();
    lamp.intensity = parse_photometric_value("1000cd").value();
    lamp.position = {40.0, 0.0, 10.0};
    Diagnostics diagnostics;
    const Light light = resolve_light(lamp, diagnostics).value();
    constexpr double down = 1.0 * std::numbers::pi / 180.0;
    const Observer driver{{0.0, 0.0, 1.5}, {std::cos(down), 0.0, -std::sin(down)}};
    const Nits veil = veiling_luminance(light, driver);
    EXPECT_NEAR(veil.value, 0.034501, 1e-6);
    EXPECT_NEAR(threshold_increment(veil, Nits(1.0)).value(), 2.243, 1e-3);
    EXPECT_NEAR(threshold_increment(veil, Nits(6.0)).value(), 95.0 * veil.value / std::pow(6.0, 1.05), 1e-12);
    EXPECT_FALSE(threshold_increment(veil, Nits(0.05)));
    EXPECT_GT(veiling_luminance(light, driver, 70.0).value, 2.0 * veil.value); // 1 + (70/66.4)⁴ over 1.0144
    // Behind the eye, and nearer to the line of sight than 1.5°.
    EXPECT_EQ(veiling_luminance(light, {driver.eye, -driver.view}).value, 0.0);
    EXPECT_EQ(veiling_luminance(light, {driver.eye, light.frame.origin - driver.eye}).value, 0.0);
}

TEST(DisabilityGlare, RatesPlayingFields) {
    EXPECT_NEAR(field_glare_rating(Nits(1.0), Lux(500.0), 0.25),
                27.0 - 24.0 * 0.9 * std::log10(0.035 * 500.0 * 0.25 / std::numbers::pi), 1e-12);
    LightDescription lamp;
    lamp.shape = PointShape();
    lamp.intensity = parse_photometric_value("100000cd").value();
    lamp.position = {50.0, 0.0, 20.0};
    Diagnostics diagnostics;
    const std::vector<Light> lights{resolve_light(lamp, diagnostics).value()};
    // Only the direction towards the mast matters.
    constexpr double dip = 2.0 * std::numbers::pi / 180.0;
    const Nits veil = veiling_luminance(lights, {{0.0, 0.0, 1.5}, {std::cos(dip), 0.0, -std::sin(dip)}});
    const std::vector<glm::dvec3> points{{0.0, 0.0, 0.0}, {-20.0, 0.0, 0.0}};
    EXPECT_NEAR(greatest_field_glare_rating(lights, points, Lux(200.0)), field_glare_rating(veil, Lux(200.0), 0.25),
                1e-12);
}

// On a matte road L = ρE/π, with all luminaires that the table reaches.
TEST(RoadPlan, OfAMatteSurfaceFollowsTheIlluminance) {
    RoadPlanRequest request = road();
    request.surface = matte_surface(0.2);
    const RoadPlan plan = planned(luminaire(street_web()), request);
    const glm::dvec3 point = plan.luminance_grid.receivers.at(17).position;
    double lx = 0.0;
    const Light& one = plan.lights.front();
    for (int i = -4; i <= 4; ++i) {
        const glm::dvec3 path = point - glm::dvec3(30.0 * i, one.frame.origin.y, 8.0);
        const double squared = path.x * path.x + path.y * path.y + path.z * path.z;
        if (std::hypot(path.x, path.y) <= 96.0) lx += one.intensity_towards(path).value * 8.0 / std::pow(squared, 1.5);
    }
    // The table is linear between its angles and cos³γ is not: that adds up to 2 %.
    for (const RoadLane& lane : plan.lanes)
        EXPECT_NEAR(lane.luminance_nt.at(17), 0.2 * lx / std::numbers::pi, 0.02 * lx * 0.2 / std::numbers::pi);
}

// Every luminance by a literal sum, as the standard has it.
TEST(RoadPlan, IsThePlainSumOverLuminaires) {
    RoadPlanRequest request = road(10.5, 40.0, 10.0);
    request.lanes = 3;
    request.arrangement = RoadArrangement::staggered;
    request.overhang_m = 1.0;
    request.tilt = degrees(5.0);
    request.maintenance_factor = 0.8;
    const LightDescription described = luminaire(street_web());
    const RoadPlan plan = planned(described, request);
    ASSERT_EQ(plan.luminance_grid.columns, 14);
    ASSERT_EQ(plan.luminance_grid.rows, 9);
    ASSERT_EQ(plan.illuminance_grid.rows, 7);
    ASSERT_EQ(plan.lights.size(), 3); // two of the near row, one of the far row between them
    const Light& near = plan.lights.at(0);
    const Light& far = plan.lights.at(1);
    EXPECT_EQ(near.frame.origin, glm::dvec3(0.0, 1.0, 10.0));
    EXPECT_EQ(far.frame.origin, glm::dvec3(20.0, 9.5, 10.0));
    for (std::size_t k = 0; k < 3; ++k) {
        const RoadLane& lane = plan.lanes.at(k);
        const glm::dvec3 eye(-60.0, 1.75 + 3.5 * static_cast<double>(k), 1.5);
        EXPECT_EQ(lane.observer.eye, eye);
        for (std::size_t p = 0; p < plan.luminance_grid.receivers.size(); ++p) {
            const glm::dvec3 point = plan.luminance_grid.receivers.at(p).position;
            double nt = 0.0;
            for (int i = -10; i <= 10; ++i)
                for (const Light* const light : {&near, &far}) {
                    const glm::dvec3 at(light->frame.origin.x + 40.0 * i, light->frame.origin.y, 10.0);
                    const double tan_gamma = std::hypot(at.x - point.x, at.y - point.y) / 10.0;
                    const double along = std::atan2(point.y - eye.y, point.x - eye.x);
                    const double towards = std::atan2(at.y - point.y, at.x - point.x);
                    const double beta_deg = std::acos(std::cos(towards - along)) * 180.0 / std::numbers::pi;
                    nt += 0.8 * light->intensity_towards(point - at).value *
                          request.surface.reduced_coefficient(tan_gamma, beta_deg) / 100.0;
                }
            EXPECT_NEAR(lane.luminance_nt.at(p), nt, 1e-9 * nt + 1e-12);
        }
        double least = 1e9;
        double greatest = 0.0;
        for (std::size_t i = 0; i < 14; ++i) {
            const double nt = lane.luminance_nt.at((3 * k + 1) * 14 + i);
            least = std::min(least, nt);
            greatest = std::max(greatest, nt);
        }
        EXPECT_DOUBLE_EQ(lane.longitudinal_uniformity, least / greatest);
    }
    EXPECT_NEAR(plan.luminaires_per_km, 50.0, 1e-12);
}

TEST(RoadPlan, ScalesWithLumensAndLengths) {
    const RoadPlan one = planned(luminaire(street_web(), 5000.0), road());
    const RoadPlan two = planned(luminaire(street_web(), 10000.0), road());
    EXPECT_NEAR(two.lanes[0].luminance.mean, 2.0 * one.lanes[0].luminance.mean, 1e-9);
    EXPECT_NEAR(two.illuminance.mean, 2.0 * one.illuminance.mean, 1e-9);
    // 65 Lv/L^0.8: twice the light makes 2^0.2 of it.
    EXPECT_NEAR(two.lanes[0].ti_percent.value(), std::pow(2.0, 0.2) * one.lanes[0].ti_percent.value(), 1e-9);
    // Half as large everywhere, four times as bright; up to 30 m apart there are ten points.
    const RoadPlan half = planned(luminaire(street_web(), 5000.0), road(3.5, 15.0, 4.0));
    EXPECT_NEAR(half.edge_ratio, one.edge_ratio, 1e-9);
    EXPECT_NEAR(half.illuminance_lx.at(0) / one.illuminance_lx.at(0), 4.0, 0.5); // rows are 1.5 m apart, not scaled
}

TEST(RoadPlan, IsTheSameFromBothEnds) {
    RoadPlanRequest request = road(7.0, 31.0, 9.0);
    request.arrangement = RoadArrangement::opposite; // half a turn about the middle of the field changes nothing
    request.two_way = true;
    const RoadPlan plan = planned(luminaire(street_web()), request);
    ASSERT_EQ(plan.lanes.size(), 2);
    EXPECT_EQ(plan.lanes[1].observer.eye.x, 91.0);
    EXPECT_NEAR(plan.lanes[1].luminance.mean, plan.lanes[0].luminance.mean, 1e-9);
    EXPECT_NEAR(plan.lanes[1].veil.value, plan.lanes[0].veil.value, 1e-12);
    EXPECT_NEAR(plan.lanes[1].longitudinal_uniformity, plan.lanes[0].longitudinal_uniformity, 1e-9);
    const std::size_t columns = plan.illuminance_grid.columns;
    const std::size_t last = columns * (plan.illuminance_grid.rows - 1);
    for (std::size_t i = 0; i < columns; ++i)
        EXPECT_NEAR(plan.illuminance_lx.at(i), plan.illuminance_lx.at(last + i), 1e-9);
    EXPECT_NEAR(plan.edge_ratio, planned(luminaire(street_web()), request).edge_ratio, 0.0); // bit for bit
}

// The street side, wherever the profile has it, faces across the road; a tilt moves light away from the near kerb.
TEST(RoadPlan, TurnsTheStreetSideAcrossTheRoad) {
    const RoadPlan plan = planned(luminaire(street_web()), road());
    const Light& light = plan.lights.front();
    EXPECT_GT(light.intensity_towards({0.3, 0.8, -0.4}).value, 2.0 * light.intensity_towards({0.3, -0.8, -0.4}).value);
    RoadPlanRequest turned = road();
    turned.street_side_c_deg = 270.0;
    const RoadPlan away = planned(luminaire(street_web()), turned);
    EXPECT_LT(away.illuminance.mean, 0.6 * plan.illuminance.mean);
    turned.street_side_c_deg = 90.0;
    turned.tilt = degrees(10.0);
    const Light tilted = planned(luminaire(street_web()), turned).lights.front();
    const double up = std::tan(10.0 * std::numbers::pi / 180.0);
    EXPECT_NEAR(tilted.intensity_towards({0.0, up, -1.0}).value, light.intensity_towards({0.0, 0.0, -1.0}).value, 1e-6);
}

TEST(RoadPlan, FindsTheWidestSpacingThatPasses) {
    Task task;
    task.name = "own";
    task.mean_nt = 0.7;
    task.luminance_uniformity = 0.3;
    Diagnostics diagnostics;
    const Result<RoadPlan> found = plan_road(luminaire(street_web()), road(), task, diagnostics);
    ASSERT_TRUE(found) << found.error().diagnostics.back().message;
    const auto passes = [&](const RoadPlan& plan) {
        const std::vector<Verdict> all = verdicts(task, plan.reached());
        return std::all_of(all.begin(), all.end(), [](const Verdict& verdict) { return *verdict.passes(); });
    };
    EXPECT_TRUE(passes(*found));
    for (double wider = found->spacing_m + 0.5; wider <= 96.0; wider += 0.5)
        EXPECT_FALSE(passes(planned(luminaire(street_web()), road(7.0, wider)))) << wider;
    task.mean_nt = 100.0;
    const Result<RoadPlan> none = plan_road(luminaire(street_web()), road(), task, diagnostics);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().diagnostics.back().message.find("mean luminance"), std::string::npos);
}

TEST(RoadPlan, RefusesWhatNoRoadIs) {
    RoadPlanRequest request = road();
    request.height_m = 1.4;
    EXPECT_NE(failure(request).find("eyes of drivers"), std::string::npos);
    request = road(0.0);
    EXPECT_NE(failure(request).find("wide"), std::string::npos);
    request = road(7.0, std::nan(""));
    EXPECT_NE(failure(request).find("spacing"), std::string::npos);
    request = road();
    request.lanes = 0;
    EXPECT_NE(failure(request).find("lanes"), std::string::npos);
    request = road();
    request.maintenance_factor = 1.5;
    EXPECT_NE(failure(request).find("maintenance"), std::string::npos);
    request = road();
    request.tilt = degrees(120.0);
    EXPECT_NE(failure(request).find("tilt"), std::string::npos);
}

} // namespace
} // namespace gonio
