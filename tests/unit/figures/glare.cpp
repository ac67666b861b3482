// UGR for an observer: a known case, scaling, small sources, lights with a size, what is not rated.
#include <gonio/figures/glare.hpp>
#include <gonio/light/opening.hpp>

#include "lambertian.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace gonio {
namespace {

// A Lambertian square of 0.6 m and 1000 lm, aimed down.
LightDescription square_luminaire() {
    static const auto web = std::make_shared<const Web>(test::lambertian_web(1000.0));
    Opening opening;
    opening.shape = OpeningShape::rectangle;
    opening.size_m = {0.6, 0.6, 0.0};
    ProfileShape profile;
    profile.web = web;
    profile.declared = std::make_shared<const Opening>(opening);
    LightDescription light;
    light.shape = profile;
    return light;
}

Light at(LightDescription description, const glm::dvec3& position) {
    Diagnostics diagnostics;
    description.position = position;
    return resolve_light(std::move(description), diagnostics).value();
}

const Observer observer{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};

double ugr_of(const Light& light, double background_nt) {
    return unified_glare_rating(glare_share(light, observer).value().sum, Nits(background_nt));
}

TEST(Glare, OfASquareAhead) {
    EXPECT_NEAR(ugr_of(at(square_luminaire(), {0.0, 4.0, 2.0}), 50.0), 4.681, 5e-4);
    EXPECT_NEAR(ugr_of(at(square_luminaire(), {2.0, 4.0, 2.0}), 50.0), 3.590, 5e-4);
    EXPECT_NEAR(ugr_of(at(square_luminaire(), {-2.0, 4.0, 2.0}), 50.0), 3.590, 5e-4);
}

TEST(Glare, ScalesByTheRule) {
    const Light light = at(square_luminaire(), {1.0, 4.0, 2.0});
    EXPECT_NEAR(ugr_of(light, 25.0) - ugr_of(light, 50.0), 8.0 * std::log10(2.0), 1e-12);
    LightDescription brighter = square_luminaire();
    brighter.intensity = parse_photometric_value("3000lm").value();
    EXPECT_NEAR(ugr_of(at(brighter, {1.0, 4.0, 2.0}), 50.0) - ugr_of(light, 50.0), 16.0 * std::log10(3.0), 1e-3);
}

// A light with a size is rated as a luminaire of the same light and opening.
TEST(Glare, OfAnAreaLight) {
    LightDescription rectangle;
    rectangle.shape = RectShape{Meters(0.6), Meters(0.6)};
    rectangle.intensity = parse_photometric_value("1000lm").value();
    EXPECT_NEAR(ugr_of(at(rectangle, {1.0, 4.0, 2.0}), 50.0), ugr_of(at(square_luminaire(), {1.0, 4.0, 2.0}), 50.0),
                1e-3);
}

// CIE 147: below 0.005 m² the size does not count.
TEST(Glare, OfSmallSources) {
    const auto rated = [](double side_m) {
        LightDescription light;
        light.shape = RectShape{Meters(side_m), Meters(side_m)};
        light.intensity = parse_photometric_value("100lm").value();
        return glare_share(at(light, {0.0, 4.0, 2.0}), observer).value();
    };
    EXPECT_TRUE(rated(0.05).is_small);
    EXPECT_NEAR(rated(0.05).sum, rated(0.01).sum, 1e-9 * rated(0.05).sum);
    EXPECT_FALSE(rated(0.2).is_small);
    const GlareShare share = rated(0.05);
    const double cosine = 2.0 / std::sqrt(20.0);
    const double intensity = 100.0 / std::numbers::pi * cosine;
    EXPECT_NEAR(share.sum * share.position_index * share.position_index, 200.0 * intensity * intensity / 20.0, 1e-6);
}

TEST(Glare, OfWhatIsNotSeen) {
    EXPECT_EQ(glare_share(at(square_luminaire(), {0.0, -4.0, 2.0}), observer).value().sum, 0.0);
    EXPECT_EQ(glare_share(at(square_luminaire(), {0.0, 4.0, -1.0}), observer).value().sum, 0.0); // from above
    LightDescription point;
    point.shape = PointShape{};
    point.intensity = parse_photometric_value("1000lm").value();
    EXPECT_FALSE(glare_share(at(point, {0.0, 4.0, 2.0}), observer));
    EXPECT_TRUE(glare_share(at(square_luminaire(), {0.0, 0.3, 0.3}), observer).value().is_too_large);
}

} // namespace
} // namespace gonio
