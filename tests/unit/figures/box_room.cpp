// The three-surface room: printed factors of CIE 190, a sum over reflections, conservation.
#include <gonio/figures/box_room.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace gonio {
namespace {

TEST(BoxRoom, HasTheFactorsOfCie190) {
    const auto expect = [](double x, double y, const RoomReflectances& reflectances, double floor, double walls,
                           double ceiling) {
        const FluxTransfer transfer = flux_transfer(x, y, reflectances);
        EXPECT_NEAR(transfer.walls_from.floor, floor, 6e-5);
        EXPECT_NEAR(transfer.walls_from.walls - 1.0, walls, 6e-5);
        EXPECT_NEAR(transfer.walls_from.ceiling, ceiling, 6e-5);
    };
    expect(2, 2, {0.7, 0.5, 0.2}, 0.2199, 0.4218, 0.6459);
    expect(4, 8, {0.7, 0.5, 0.2}, 0.1149, 0.2113, 0.3074);
    expect(12, 8, {0.3, 0.3, 0.2}, 0.0494, 0.0591, 0.0692);
}

// All that is absorbed is all that was emitted, wherever it fell first.
TEST(BoxRoom, LosesNoLight) {
    const RoomReflectances reflectances{0.8, 0.4, 0.1};
    const FluxTransfer transfer = flux_transfer(3.0, 0.7, reflectances);
    const auto absorbed = [&](auto source) {
        return (1.0 - reflectances.floor) * transfer.floor_from.*source +
               (1.0 - reflectances.walls) * transfer.walls_from.*source +
               (1.0 - reflectances.ceiling) * transfer.ceiling_from.*source;
    };
    EXPECT_NEAR(absorbed(&FluxTransfer::Sources::floor), 1.0, 1e-14);
    EXPECT_NEAR(absorbed(&FluxTransfer::Sources::walls), 1.0, 1e-14);
    EXPECT_NEAR(absorbed(&FluxTransfer::Sources::ceiling), 1.0, 1e-14);
}

TEST(BoxRoom, WithoutReflectionKeepsWhatFell) {
    const FluxTransfer transfer = flux_transfer(2.0, 5.0, {});
    EXPECT_DOUBLE_EQ(transfer.floor_from.floor, 1.0);
    EXPECT_DOUBLE_EQ(transfer.floor_from.walls, 0.0);
    EXPECT_DOUBLE_EQ(transfer.floor_from.ceiling, 0.0);
}

TEST(BoxRoom, OfInfiniteSidesIsTwoPlanes) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const FluxTransfer transfer = flux_transfer(infinity, infinity, {0.7, 0.5, 0.2});
    EXPECT_NEAR(transfer.floor_from.floor, 1.0 / (1.0 - 0.14), 1e-14);
    EXPECT_NEAR(transfer.floor_from.ceiling, 0.7 / (1.0 - 0.14), 1e-14);
    const FluxTransfer wide = flux_transfer(1e6, 1e6, {0.7, 0.5, 0.2});
    EXPECT_NEAR(wide.floor_from.floor, transfer.floor_from.floor, 1e-5);
}

TEST(BoxRoom, FormFactorOfACube) {
    EXPECT_NEAR(facing_rectangles_form_factor(1.0, 1.0), 0.1998249, 1e-7);
    EXPECT_DOUBLE_EQ(facing_rectangles_form_factor(2.0, 3.0), facing_rectangles_form_factor(3.0, 2.0));
}

} // namespace
} // namespace gonio
