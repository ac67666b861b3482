#include <gonio/scene/receiver_grid.hpp>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace gonio {
namespace {

using Corners = std::vector<glm::dvec3>;

// The printed table of the standard, and its formula.
TEST(ReceiverGrid, SpacingIsThatOfEn12464) {
    EXPECT_NEAR(grid_spacing_m(1, 1), 0.2, 1e-12);
    EXPECT_NEAR(grid_spacing_m(5, 5), 0.616, 1e-3);
    EXPECT_NEAR(grid_spacing_m(10, 10), 1.0, 1e-12);
    EXPECT_NEAR(grid_spacing_m(50, 50), 3.080, 1e-3);
    EXPECT_NEAR(grid_spacing_m(100, 100), 5.0, 1e-12);
    EXPECT_NEAR(grid_spacing_m(1e4, 1e4), 10.0, 1e-12);
    // The shorter side of a corridor.
    EXPECT_NEAR(grid_spacing_m(20, 1), 0.2, 1e-12);
    EXPECT_NEAR(grid_spacing_m(2, 1), 0.2, 1e-12);
    // The numbers of points that the standard prints, where they follow from the formula.
    for (const auto& [side, points] : {std::pair(1.0, 5U), {2.0, 6U}, {5.0, 8U}, {10.0, 10U}, {100.0, 20U}})
        EXPECT_EQ(cells_along(side, grid_spacing_m(side, side)), points) << side;
    EXPECT_EQ(cells_along(4.0, grid_spacing_m(5, 4)), 6U);
    EXPECT_EQ(cells_along(0.01, 1.0), 1U);
}

TEST(ReceiverGrid, HasTheCentresOfItsCells) {
    const ReceiverGrid grid = parallelogram_grid({1, 2, 0.8}, {4, 0, 0}, {0, 2, 0}, {1.0}, {0, 0, 1}, 1000).value();
    EXPECT_EQ(grid.columns, 4U);
    EXPECT_EQ(grid.rows, 2U);
    ASSERT_EQ(grid.receivers.size(), 8U);
    EXPECT_EQ(grid.receivers[0].position, glm::dvec3(1.5, 2.5, 0.8));
    EXPECT_EQ(grid.receivers[1].position, glm::dvec3(2.5, 2.5, 0.8));
    EXPECT_EQ(grid.receivers[7].position, glm::dvec3(4.5, 3.5, 0.8));
    EXPECT_FALSE(parallelogram_grid({}, {0, 0, 0}, {0, 2, 0}, {1.0}, {0, 0, 1}, 1000));
    EXPECT_FALSE(parallelogram_grid({}, {4, 0, 0}, {0, 2, 0}, {1e-3}, {0, 0, 1}, 1000));
    EXPECT_FALSE(parallelogram_grid({}, {1e300, 0, 0}, {0, 2, 0}, {}, {0, 0, 1}, 1000));
}

TEST(ReceiverGrid, APolygonHasTheCellsInIt) {
    // An L, either way round.
    Corners corners{{0, 0, 1}, {4, 0, 1}, {4, 2, 1}, {2, 2, 1}, {2, 4, 1}, {0, 4, 1}};
    for (int way = 0; way < 2; ++way) {
        const ReceiverGrid grid = polygon_grid(corners, {1.0}, {}, 1000).value();
        EXPECT_EQ(grid.columns, 4U);
        EXPECT_EQ(grid.rows, 4U);
        ASSERT_EQ(grid.receivers.size(), 12U);
        EXPECT_EQ(grid.receivers[0].normal, glm::dvec3(0, 0, 1));
        EXPECT_EQ(grid.receivers[0].position, glm::dvec3(0.5, 0.5, 1));
        EXPECT_EQ(grid.cell_of(11), 13U);
        corners = {corners.rbegin(), corners.rend()};
    }
    // On a wall.
    const Corners wall{{0, 3, 0}, {2, 3, 0}, {2, 3, 2}};
    const ReceiverGrid upright = polygon_grid(wall, {0.5}, {}, 1000).value();
    EXPECT_EQ(upright.columns * upright.rows, 16U);
    for (const Receiver& receiver : upright.receivers) {
        EXPECT_NEAR(receiver.position.y, 3.0, 1e-12);
        EXPECT_NEAR(std::abs(receiver.normal.y), 1.0, 1e-12);
    }
}

std::string refusal(const Corners& corners, double spacing = 0.5) {
    const Result<ReceiverGrid> grid = polygon_grid(corners, {spacing}, {}, 1000);
    return grid ? "no failure" : grid.error().diagnostics.back().message;
}

TEST(ReceiverGrid, WrongPolygonsAreRefused) {
    EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}}), "a polygon has at least three corners, not 2");
    EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), "the polygon has no area");
    EXPECT_EQ(refusal({{0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {0, 2, 0}}),
              "corners 2 and 3 of the polygon are the same, 2,0,0");
    EXPECT_EQ(refusal({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 3, 0}}),
              "edges of the polygon cross: 0,0,0 to 4,4,0, and 4,0,0 to 0,3,0");
    EXPECT_EQ(refusal({{0, 0, 0}, {2, 0, 0}, {2, 2, 0.5}, {0, 2, 0}}).substr(0, 23), "the polygon is not flat");
    EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 1e-4).substr(0, 9), "a grid of");
    EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}, {1, 0.1, 0}, {0.1, 0.1, 0}, {0.1, 1, 0}, {0, 1, 0}}, 0.9).substr(0, 38),
              "no point of the grid lies in the polyg");
    EXPECT_NE(refusal(Corners(2000, glm::dvec3(1, 2, 3))).find("polygon-corners"), std::string::npos);
}

TEST(ReceiverGrid, PercentilesAreLinearBetweenValues) {
    const std::vector<double> values{4, 1, 3, 2, 5};
    EXPECT_EQ(percentile(values, 0.0), 1.0);
    EXPECT_EQ(percentile(values, 50.0), 3.0);
    EXPECT_DOUBLE_EQ(percentile(values, 95.0), 4.8);
    EXPECT_EQ(percentile(values, 100.0), 5.0);
    EXPECT_EQ(percentile({}, 50.0), 0.0);
}

TEST(ReceiverGrid, WallsOfAStage) {
    const std::optional<FloorArea> room = area_between_walls(make_stage("room").value(), 0.8);
    ASSERT_TRUE(room);
    EXPECT_LT(room->low.x, room->high.x);
    EXPECT_FALSE(area_between_walls(make_stage("floor").value(), 0.8));
    EXPECT_EQ(beyond_height(make_stage("room").value(), 0.8), nullptr);
    EXPECT_EQ(beyond_height(make_stage("room").value(), 80.0)->name, "ceiling");
    EXPECT_EQ(beyond_height(make_stage("room").value(), -0.1)->name, "floor");
}

// A football pitch of 105 m by 68 m: p = 5.17 m, 20.3 and 13.2 cells. A tennis court has the spacing of its longer
// side.
TEST(ReceiverGrid, OfSportsIsOdd) {
    const GridSpacing sports{{}, true};
    const ReceiverGrid pitch = parallelogram_grid({}, {105, 0, 0}, {0, 68, 0}, sports, {0, 0, 1}, 1000).value();
    EXPECT_EQ(pitch.columns, 21);
    EXPECT_EQ(pitch.rows, 13);
    const ReceiverGrid court = parallelogram_grid({}, {36, 0, 0}, {0, 18, 0}, sports, {0, 0, 1}, 1000).value();
    EXPECT_EQ(court.columns, 15);
    EXPECT_EQ(court.rows, 7);
    const ReceiverGrid spot = parallelogram_grid({}, {0.01, 0, 0}, {0, 0.01, 0}, sports, {0, 0, 1}, 1000).value();
    EXPECT_EQ(spot.columns * spot.rows, 1);
}

} // namespace
} // namespace gonio
