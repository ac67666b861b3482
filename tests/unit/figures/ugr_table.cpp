// Tables of UGR: of Lambertian luminaires against values computed in double from the rule by another program, and
// against a plain sum over the luminaires of a room.
#include <gonio/figures/position_index.hpp>
#include <gonio/figures/ugr_table.hpp>

#include "lambertian.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace gonio {
namespace {

constexpr std::size_t room_2x2 = 0;
constexpr std::size_t room_4x8 = 10;
constexpr std::size_t room_12x8 = 18;

Opening rectangle(double across_m, double along_m) {
    Opening opening;
    opening.shape = OpeningShape::rectangle;
    opening.size_m = {across_m, along_m, 0.0};
    return opening;
}

void expect_row(const UgrTable& table, std::size_t row, std::size_t first, const std::array<double, 5>& expected) {
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(table[row][first + i], expected[i], 0.006) << row << ' ' << first + i;
}

TEST(UgrTable, OfALambertianSquare) {
    const Web web = test::lambertian_web(1000.0);
    const Opening opening = rectangle(0.6, 0.6);
    const UgrTable table = ugr_table(web, opening).value();
    for (const std::size_t first : {std::size_t{0}, std::size_t{5}}) {
        expect_row(table, room_2x2, first, {11.99, 13.68, 12.35, 13.99, 14.31});
        expect_row(table, room_4x8, first, {17.07, 18.00, 17.54, 18.44, 18.91});
        expect_row(table, room_12x8, first, {17.95, 18.55, 18.45, 19.04, 19.57});
    }
    const UgrTable wide = ugr_table(web, opening, {1.0, UgrInterpolation::intensity, 0.0}).value();
    expect_row(wide, room_2x2, 0, {11.79, 13.48, 12.14, 13.79, 14.11});
    expect_row(wide, room_4x8, 0, {17.06, 17.98, 17.52, 18.42, 18.89});
}

TEST(UgrTable, OfADisk) {
    Opening disk;
    disk.shape = OpeningShape::disk;
    disk.size_m = {0.3, 0.3, 0.0};
    expect_row(ugr_table(test::lambertian_web(1000.0), disk).value(), room_4x8, 0, {22.73, 23.65, 23.19, 24.09, 24.56});
}

Opening long_box() {
    Opening box;
    box.shape = OpeningShape::box;
    box.size_m = {0.3, 1.2, 0.1};
    box.side_heights_m = {0.1, 0.1, 0.1, 0.1};
    return box;
}

TEST(UgrTable, OfABoxDiffersByTheView) {
    const UgrTable table = ugr_table(test::lambertian_web(1000.0), long_box()).value();
    expect_row(table, room_4x8, 0, {14.63, 15.55, 15.09, 15.99, 16.46});
    expect_row(table, room_4x8, 5, {15.63, 16.56, 16.10, 17.00, 17.47});
}

TEST(UgrTable, BackgroundOfALambertianSquare) {
    const Web web = test::lambertian_web(1000.0);
    const std::array<double, 5> at_2_m{242.80, 186.13, 212.41, 164.01, 143.26};
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(ugr_background_nt(web, room_4x8, i) / 4.0, at_2_m[i], 0.02);
}

// A luminaire that is turned by a quarter is seen crosswise as it was endwise.
TEST(UgrTable, TurnsWithTheLuminaire) {
    Opening turned = long_box();
    std::swap(turned.size_m.x, turned.size_m.y);
    const Web web = test::lambertian_web(3000.0, 5.0);
    const UgrTable table = ugr_table(web, long_box()).value();
    const UgrTable other = ugr_table(web, turned, {0.25, UgrInterpolation::intensity, -90.0}).value();
    for (std::size_t row = 0; row < ugr_rooms.size(); ++row)
        for (std::size_t column = 0; column < 10; ++column)
            EXPECT_NEAR(table[row][column], other[row][column], 1e-9);
}

// Twice the light adds 8 log₁₀2, and so does half of the area.
TEST(UgrTable, ScalesByTheRule) {
    const UgrTable table = ugr_table(test::lambertian_web(1000.0, 5.0), rectangle(0.6, 0.6)).value();
    const UgrTable brighter = ugr_table(test::lambertian_web(2000.0, 5.0), rectangle(0.6, 0.6)).value();
    const UgrTable smaller = ugr_table(test::lambertian_web(1000.0, 5.0), rectangle(0.6, 0.3)).value();
    for (std::size_t row = 0; row < ugr_rooms.size(); ++row)
        for (std::size_t column = 0; column < 10; ++column) {
            EXPECT_NEAR(brighter[row][column] - table[row][column], 8.0 * std::log10(2.0), 1e-9);
            EXPECT_NEAR(smaller[row][column] - table[row][column], 8.0 * std::log10(2.0), 1e-9);
        }
}

// The sums over a lattice that all rooms share, against the luminaires of each room one by one.
TEST(UgrTable, EqualsASumOverTheLuminairesOfARoom) {
    std::mt19937 generator(7);
    std::vector<double> gammas;
    std::vector<double> planes;
    std::vector<double> candela;
    for (int i = 0; i <= 6; ++i)
        planes.push_back(15.0 * i);
    for (int j = 0; j <= 18; ++j)
        gammas.push_back(5.0 * j);
    for (std::size_t i = 0; i < planes.size() * gammas.size(); ++i)
        candela.push_back(100.0 + 400.0 * static_cast<double>(generator()) / 4294967296.0);
    const Web web = *Web::create(Symmetry::quadrant, planes, gammas, candela);
    const Opening opening = long_box();
    for (const double spacing : {0.25, 1.0}) {
        const UgrTable table = ugr_table(web, opening, {spacing, UgrInterpolation::intensity, 0.0}).value();
        for (std::size_t row = 0; row < ugr_rooms.size(); ++row) {
            const UgrRoom& room = ugr_rooms[row];
            for (const bool endwise : {false, true}) {
                double sum = 0.0;
                for (int i = 0; i < std::lround(room.across / spacing); ++i)
                    for (int j = 0; j < std::lround(room.along / spacing); ++j) {
                        const double t = std::abs(-0.5 * room.across + (i + 0.5) * spacing);
                        const double r = (j + 0.5) * spacing;
                        if (t / r > 3.0 + 1e-9 || 1.0 / r > 1.6 + 1e-9) continue;
                        const double p = table_position_index(t / r, 1.0 / r).value();
                        const double c = endwise ? std::atan2(r, t) : std::atan2(t, r);
                        const double gamma = std::atan(std::hypot(r, t));
                        const double intensity =
                            web.candela(c * 180.0 / std::numbers::pi, gamma * 180.0 / std::numbers::pi);
                        const double area =
                            0.3 * 1.2 * std::cos(gamma) +
                            (1.2 * 0.1 * std::abs(std::cos(c)) + 0.3 * 0.1 * std::abs(std::sin(c))) * std::sin(gamma);
                        sum += intensity * intensity / area / (r * r + t * t + 1.0) / (p * p);
                    }
                for (std::size_t column = 0; column < 5; ++column)
                    EXPECT_NEAR(table[row][column + (endwise ? 5 : 0)],
                                8.0 * std::log10(0.25 * sum / ugr_background_nt(web, row, column, spacing)), 1e-9);
            }
        }
    }
}

// Where the luminance is linear between directions as well as the intensity is, both interpolations agree.
TEST(UgrTable, InterpolatesTheLuminanceIfAsked) {
    const Web web = test::lambertian_web(1000.0, 1.0);
    const UgrTable by_intensity = ugr_table(web, rectangle(0.6, 0.6)).value();
    const UgrTable by_luminance = ugr_table(web, rectangle(0.6, 0.6), {0.25, UgrInterpolation::luminance, 0.0}).value();
    EXPECT_NEAR(by_intensity[room_12x8][0], by_luminance[room_12x8][0], 0.01);
    const Web coarse = test::lambertian_web(1000.0, 15.0);
    const UgrTable other = ugr_table(coarse, rectangle(0.6, 0.6), {0.25, UgrInterpolation::luminance, 0.0}).value();
    EXPECT_GT(std::abs(ugr_table(coarse, rectangle(0.6, 0.6)).value()[room_12x8][0] - other[room_12x8][0]), 0.03);
}

TEST(UgrTable, SaysWhyThereIsNone) {
    EXPECT_EQ(ugr_table(test::lambertian_web(1000.0), {}).error(), "the file states no luminous opening");
    const Web spot = *Web::create(Symmetry::axial, {0.0}, {0.0, 5.0}, {1000.0, 1000.0});
    EXPECT_EQ(ugr_table(spot, rectangle(0.1, 0.1)).error(), "no light reaches the eye in the standard rooms");
    EXPECT_FALSE(ugr_table(test::lambertian_web(1000.0), rectangle(0.6, 0.6), {0.3, UgrInterpolation::intensity, 0.0}));
    Opening upright = rectangle(0.1, 0.0);
    EXPECT_NE(ugr_table(test::lambertian_web(1000.0), upright).error().find("has no area towards gamma"),
              std::string::npos);
}

} // namespace
} // namespace gonio
