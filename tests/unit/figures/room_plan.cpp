// Planned rooms: against utilisation factors, symmetric under turns, and no larger than needed.
#include <gonio/figures/room_plan.hpp>
#include <gonio/figures/utilisation.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/web/direct_ratios.hpp>
#include <gonio/web/zones.hpp>

#include "../scaled.hpp"
#include "lambertian.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace gonio {
namespace {

LightDescription luminaire(double flux_lm, const glm::dvec3& size_m = {0.3, 0.6, 0.0}) {
    static const auto web = std::make_shared<const Web>(test::lambertian_web(1000.0));
    Opening opening;
    opening.shape = OpeningShape::rectangle;
    opening.size_m = size_m;
    ProfileShape profile;
    profile.web = web;
    profile.declared = std::make_shared<const Opening>(opening);
    LightDescription light;
    light.name = "luminaire";
    light.shape = profile;
    light.intensity = parse_photometric_value(std::to_string(flux_lm) + "lm").value();
    return light;
}

RoomPlanRequest room(double x, double y, double z) {
    RoomPlanRequest request;
    request.size_m = {x, y, z};
    return request;
}

RoomPlan planned(const LightDescription& light, const RoomPlanRequest& request) {
    Diagnostics diagnostics;
    return plan_room(light, request, diagnostics).value();
}

std::string failure(const LightDescription& light, const RoomPlanRequest& request) {
    Diagnostics diagnostics;
    const Result<RoomPlan> plan = plan_room(light, request, diagnostics);
    return plan ? std::string("planned") : plan.error().diagnostics.back().message;
}

// CIE 52 takes a ceiling that is full of luminaires, and the mean over the whole floor.
TEST(RoomPlan, HasTheIlluminanceOfUtilisationFactors) {
    const Web web = test::lambertian_web(1000.0);
    const UtilisationFactors factors = utilisation_factors(ten_degree_zones(web), direct_ratios(web), Lumens(1000.0));
    struct Case {
        std::size_t index; // of room_indices
        std::size_t column;
    };
    constexpr std::array cases{Case{2, 2}, Case{5, 5}, Case{0, 7}};
    for (const Case& tried : test::scaled(cases)) {
        const double side = 2.0 * room_indices.at(tried.index) * 3.0;
        RoomPlanRequest request = room(side, side, 3.0);
        request.reflectances = utilisation_reflectances.at(tried.column);
        request.plane_height_m = 0.0;
        request.wall_zone_m = 0.0;
        request.maintenance_factor = 1.0;
        request.layout = RoomLayout{8, 8};
        const RoomPlan plan = planned(luminaire(1000.0, {0.1, 0.1, 0.0}), request);
        const double expected_lx = 64.0 * 1000.0 * factors.at(tried.index).at(tried.column) / (side * side);
        EXPECT_NEAR(plan.spread.mean, expected_lx, 0.03 * expected_lx) << tried.index << ' ' << tried.column;
    }
}

TEST(RoomPlan, IsTheSmallestThatReachesTheMean) {
    RoomPlanRequest request = room(6.0, 4.0, 2.8);
    request.mean = Lux(500.0);
    const RoomPlan plan = planned(luminaire(3000.0), request);
    EXPECT_GE(plan.spread.mean, 500.0);
    EXPECT_EQ(plan.lights.size(), plan.layout.count());
    // With one luminaire less in every regular layout it is too dark.
    request.mean.reset();
    constexpr std::array layouts{RoomLayout{2, 2}, RoomLayout{3, 1}, RoomLayout{2, 1}};
    for (const RoomLayout& fewer : test::scaled(layouts))
        if (fewer.count() < plan.layout.count()) {
            request.layout = fewer;
            EXPECT_LT(planned(luminaire(3000.0), request).spread.mean, 500.0);
        }
}

TEST(RoomPlan, TurnsWithTheRoom) {
    if (test::is_sanitized) GTEST_SKIP() << "IsTheSmallestThatReachesTheMean plans the same room";
    RoomPlanRequest request = room(6.0, 4.0, 2.8);
    request.layout = RoomLayout{3, 2};
    const RoomPlan plan = planned(luminaire(3000.0), request);
    RoomPlanRequest turned = room(4.0, 6.0, 2.8);
    turned.layout = RoomLayout{2, 3};
    LightDescription light = luminaire(3000.0);
    light.rotation = degrees(90.0);
    const RoomPlan other = planned(light, turned);
    EXPECT_NEAR(plan.spread.mean, other.spread.mean, 2e-3 * plan.spread.mean);
    EXPECT_NEAR(plan.observers[0].glare.ugr.value(), other.observers[2].glare.ugr.value(), 0.02);
    EXPECT_NEAR(plan.observers[0].glare.ugr.value(), plan.observers[1].glare.ugr.value(), 0.02); // from both ends
    EXPECT_NEAR(plan.observers[2].glare.ugr.value(), other.observers[0].glare.ugr.value(), 0.02);
}

// A body that shines to all sides hangs below the ceiling, which would hide half of it.
TEST(RoomPlan, HangsBodiesBelowTheCeiling) {
    const auto web = std::make_shared<const Web>(*Web::create(Symmetry::axial, {0.0}, {0.0, 180.0}, {100.0, 100.0}));
    LightDescription light = luminaire(1000.0);
    auto& profile = std::get<ProfileShape>(light.shape);
    profile.web = web;
    Opening box;
    box.shape = OpeningShape::box;
    box.size_m = {0.2, 0.2, 0.2};
    box.side_heights_m = {0.2, 0.2, 0.2, 0.2};
    profile.declared = std::make_shared<const Opening>(box);
    profile.size = ProfileSize::opening;
    RoomPlanRequest request = room(4.0, 4.0, 3.0);
    request.reflectances = {0.0, 0.0, 0.0};
    request.maintenance_factor = 1.0;
    request.layout = RoomLayout{1, 1};
    EXPECT_NEAR(planned(light, request).lights.front().frame.origin.z, 2.899, 1e-12);
}

TEST(RoomPlan, MaintainsLess) {
    if (test::is_sanitized) GTEST_SKIP() << "HasTheIlluminanceOfUtilisationFactors states a maintenance factor";
    RoomPlanRequest request = room(5.0, 5.0, 3.0);
    request.layout = RoomLayout{2, 2};
    request.maintenance_factor = 1.0;
    const RoomPlan fresh = planned(luminaire(3000.0), request);
    request.maintenance_factor = 0.7;
    const RoomPlan later = planned(luminaire(3000.0), request);
    EXPECT_NEAR(later.spread.mean, 0.7 * fresh.spread.mean, 1e-9);
    EXPECT_EQ(later.observers[0].glare.ugr, fresh.observers[0].glare.ugr); // of the new installation
}

TEST(RoomPlan, RefusesWhatCannotBe) {
    RoomPlanRequest request = room(6.0, 4.0, 2.8);
    EXPECT_EQ(failure(luminaire(3000.0), request), "a room is planned for a mean illuminance or with a layout");
    request.mean = Lux(500.0);
    RoomPlanRequest bad = request;
    bad.reflectances.ceiling = 0.96;
    EXPECT_NE(failure(luminaire(3000.0), bad).find("96 %"), std::string::npos);
    bad = request;
    bad.mounting_height_m = 3.0;
    EXPECT_NE(failure(luminaire(3000.0), bad).find("above the ceiling"), std::string::npos);
    bad = request;
    bad.plane_height_m = 2.8;
    EXPECT_NE(failure(luminaire(3000.0), bad).find("not below the luminaires"), std::string::npos);
    bad = request;
    bad.wall_zone_m = 2.0;
    EXPECT_NE(failure(luminaire(3000.0), bad).find("leaves nothing"), std::string::npos);
    EXPECT_NE(failure(luminaire(3000.0, {7.0, 0.3, 0.0}), request).find("do not fit"), std::string::npos);
    EXPECT_NE(failure(luminaire(0.001), request).find("more than 4096"), std::string::npos);
    bad = request;
    bad.size_m.y = 0.0;
    EXPECT_NE(failure(luminaire(3000.0), bad).find("above 0"), std::string::npos);
}

} // namespace
} // namespace gonio
