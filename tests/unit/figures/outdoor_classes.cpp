// Classes of outdoor luminaires at their limits.
#include <gonio/figures/outdoor_classes.hpp>

#include "lambertian.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

TEST(BugRating, OfALambertianLuminaire) {
    const LuminaireClassification classes = luminaire_classification(test::lambertian_web(12000.0));
    EXPECT_NEAR(classes.front[2].value, 1319.08, 0.05);
    EXPECT_NEAR(classes.back[3].value, 180.92, 0.05);
    const BugRating rating = bug_rating(classes);
    EXPECT_EQ(to_text(rating), "B3 U0 G3");
    EXPECT_EQ(to_text(rating, true), "B3 U0 G2");
}

TEST(BugRating, TakesTheWorstAngle) {
    LuminaireClassification classes;
    EXPECT_EQ(to_text(bug_rating(classes)), "B0 U0 G0");
    classes.up_high = Lumens(11.0);
    EXPECT_EQ(bug_rating(classes).uplight, 2);
    classes.up_low = Lumens(1001.0);
    EXPECT_EQ(bug_rating(classes).uplight, 5);
    classes.back[1] = Lumens(220.0);
    EXPECT_EQ(bug_rating(classes).backlight, 0);
    classes.back[0] = Lumens(110.1);
    EXPECT_EQ(bug_rating(classes).backlight, 1);
}

TEST(CutOff, ByTheIntensitiesFrom80And90Degrees) {
    const auto with = [](double at_80, double at_90) {
        return cut_off(high_angles(*Web::create(Symmetry::axial, {0.0}, {0.0, 79.0, 80.0, 90.0, 180.0},
                                                {500, 500, at_80, at_90, 0})),
                       Lumens(1000.0));
    };
    EXPECT_EQ(with(100, 0), CutOff::full_cutoff);
    EXPECT_EQ(with(100, 25), CutOff::cutoff);
    EXPECT_EQ(with(101, 0), CutOff::semi_cutoff);
    EXPECT_EQ(with(200, 50), CutOff::semi_cutoff);
    EXPECT_EQ(with(201, 0), CutOff::non_cutoff);
    EXPECT_EQ(with(0, 51), CutOff::non_cutoff);
}

TEST(LuminousIntensityClass, OfKnownLights) {
    EXPECT_EQ(luminous_intensity_class(high_angles(test::lambertian_web(1000.0)), Lumens(1000.0)), 6);
    const auto with = [](std::vector<double> candela) {
        return luminous_intensity_class(
            high_angles(*Web::create(Symmetry::axial, {0.0}, {0, 70, 80, 90, 94, 180}, std::move(candela))),
            Lumens(1000.0));
    };
    EXPECT_EQ(with({100, 350, 100, 0, 0, 0}), 6);
    EXPECT_EQ(with({100, 351, 100, 0, 0, 0}), 4);
    EXPECT_EQ(with({100, 350, 100, 10, 0, 0}), 5);
    EXPECT_EQ(with({100, 500, 100, 10, 9, 0}), 3); // it shines above 95°
    EXPECT_EQ(with({100, 900, 150, 30, 0, 0}), 2);
    EXPECT_EQ(with({100, 900, 200, 50, 0, 0}), 1);
    EXPECT_EQ(with({100, 900, 201, 50, 0, 0}), 0);
}

TEST(GlareIndex, DividesByTheRootOfTheArea) {
    Opening disk;
    disk.shape = OpeningShape::disk;
    disk.size_m = {0.3, 0.3, 0.0};
    const double cosine = std::cos(85.0 * std::numbers::pi / 180.0);
    const double intensity = 10000.0 / std::numbers::pi * cosine;
    const GlareIndex index = glare_index(test::lambertian_web(10000.0), disk).value();
    EXPECT_NEAR(index.cd_per_m, intensity / std::sqrt(std::numbers::pi / 4.0 * 0.09 * cosine), 1.0);
    EXPECT_EQ(index.glare_index_class, 3); // 3530 of at most 4000
    EXPECT_FALSE(glare_index(test::lambertian_web(10000.0), {}));
}

TEST(DistributionClass, ByTheDownwardShare) {
    EXPECT_EQ(distribution_class(1.0), 'A');
    EXPECT_EQ(distribution_class(0.9), 'A');
    EXPECT_EQ(distribution_class(0.89), 'B');
    EXPECT_EQ(distribution_class(0.5), 'C');
    EXPECT_EQ(distribution_class(0.2), 'D');
    EXPECT_EQ(distribution_class(0.0), 'E');
}

} // namespace
} // namespace gonio
