// The shapes encoded by the signs of width, length and height, edition by edition.
#include <gonio/profile/luminous_opening.hpp>

#include <gtest/gtest.h>

namespace {

using namespace gonio;

struct OpeningCase {
    IesVersion version;
    double width;
    double length;
    double height;
    OpeningShape shape;
    double width_m;
    double length_m;
    double height_m;
};

class Openings : public testing::TestWithParam<OpeningCase> {};

TEST_P(Openings, OfLm63) {
    const OpeningCase& c = GetParam();
    IesFile file;
    file.version = c.version;
    file.width = c.width;
    file.length = c.length;
    file.height = c.height;
    const LuminousOpening opening = luminous_opening({"lamp", file, {}});
    EXPECT_STREQ(to_text(opening.shape), to_text(c.shape)) << to_text(c.version);
    EXPECT_EQ(opening.width_m, c.width_m);
    EXPECT_EQ(opening.length_m, c.length_m);
    EXPECT_EQ(opening.height_m, c.height_m);
}

constexpr IesVersion v86 = IesVersion::lm63_1986;
constexpr IesVersion v91 = IesVersion::lm63_1991;
constexpr IesVersion v95 = IesVersion::lm63_1995;
constexpr IesVersion v02 = IesVersion::lm63_2002;
constexpr IesVersion v19 = IesVersion::lm63_2019;
using enum OpeningShape;

INSTANTIATE_TEST_SUITE_P(
    Editions, Openings,
    testing::Values(
        OpeningCase{v86, 0, 0, 0, point, 0, 0, 0}, OpeningCase{v19, 0, 0, 0, point, 0, 0, 0},
        OpeningCase{v91, 1, 2, 0, rectangle, 1, 2, 0}, OpeningCase{v02, 1, 2, 3, box, 1, 2, 3},
        OpeningCase{v02, 0, 2, 3, box, 0, 2, 3}, OpeningCase{v86, -1, 0, 0, disk, 1, 1, 0},
        OpeningCase{v91, -1, 0, 2, vertical_cylinder, 1, 1, 2}, OpeningCase{v91, -1, 3, 0, ellipse, 1, 3, 0},
        OpeningCase{v86, -1, 3, 2, ellipsoid, 1, 3, 2}, OpeningCase{v86, -1, -1, 0, box, 1, 1, 0},
        OpeningCase{v95, -1, 0, 0, disk, 1, 1, 0}, OpeningCase{v95, -1, 0, -1, sphere, 1, 1, 1},
        OpeningCase{v95, -1, 0, 2, vertical_cylinder, 1, 1, 2},
        OpeningCase{v95, 0, 2, -1, horizontal_cylinder, 1, 2, 1},
        OpeningCase{v95, 2, 0, -1, horizontal_cylinder_across, 2, 1, 1},
        OpeningCase{v95, -1, 3, 2, vertical_cylinder, 1, 3, 2}, OpeningCase{v95, 1, -3, 2, vertical_cylinder, 1, 3, 2},
        OpeningCase{v95, -1, 3, -2, ellipsoid, 1, 3, 2}, OpeningCase{v95, 1, -3, -2, ellipsoid, 1, 3, 2},
        OpeningCase{v95, -1, -1, 0, box, 1, 1, 0}, OpeningCase{v02, -1, -1, 0, disk, 1, 1, 0},
        OpeningCase{v19, -1, -2, 0, ellipse, 1, 2, 0}, OpeningCase{v02, -1, -1, 2, vertical_cylinder, 1, 1, 2},
        OpeningCase{v02, -1, -3, 2, vertical_cylinder, 1, 3, 2}, OpeningCase{v19, -1, -1, -1, sphere, 1, 1, 1},
        OpeningCase{v19, -1, -1, -2, ellipsoid, 1, 1, 2}, OpeningCase{v02, -1, 2, -1, horizontal_cylinder, 1, 2, 1},
        OpeningCase{v02, 2, -1, -1, horizontal_cylinder_across, 2, 1, 1},
        OpeningCase{v02, -1, 0, -1, upright_disk, 1, 0, 1}, OpeningCase{v02, 0, -1, -1, upright_disk, 0, 1, 1},
        OpeningCase{v02, -1, 0, 0, disk, 1, 1, 0}, OpeningCase{v02, 1, -2, 0, box, 1, 2, 0}));

TEST(LuminousOpening, FeetBecomeMetres) {
    IesFile file;
    file.feet = true;
    file.width = 1;
    file.length = -2;
    const LuminousOpening opening = luminous_opening({"lamp", file, {}});
    EXPECT_DOUBLE_EQ(opening.width_m, 0.3048);
    EXPECT_DOUBLE_EQ(opening.length_m, 0.6096);
}

TEST(LuminousOpening, OfEulumdat) {
    LdtFile file;
    EXPECT_EQ(luminous_opening({"lamp", file, {}}).shape, point);
    file.luminous_length_mm = 90;
    EXPECT_EQ(luminous_opening({"lamp", file, {}}).shape, disk);
    EXPECT_DOUBLE_EQ(luminous_opening({"lamp", file, {}}).width_m, 0.09);
    file.luminous_height_c180_mm = 30;
    EXPECT_EQ(luminous_opening({"lamp", file, {}}).shape, vertical_cylinder);
    EXPECT_DOUBLE_EQ(luminous_opening({"lamp", file, {}}).height_m, 0.03);
    file.luminous_width_mm = 10;
    EXPECT_EQ(luminous_opening({"lamp", file, {}}).shape, box);
    file.luminous_height_c180_mm = 0;
    EXPECT_EQ(luminous_opening({"lamp", file, {}}).shape, rectangle);
}

} // namespace
