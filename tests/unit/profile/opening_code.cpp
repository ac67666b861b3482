// Luminous openings as every edition of LM-63 and EULUMDAT encode them, and back.
#include <gonio/profile/opening_code.hpp>

#include <gtest/gtest.h>

namespace {

using namespace gonio;

TEST(OpeningCode, EveryShapeInEveryEdition) {
    const LuminousOpening shapes[] = {
        {OpeningShape::point, 0, 0, 0},
        {OpeningShape::rectangle, 0.3, 1.2, 0},
        {OpeningShape::rectangle, 0, 1.2, 0},
        {OpeningShape::box, 0.3, 1.2, 0.1},
        {OpeningShape::disk, 0.2, 0.2, 0},
        {OpeningShape::ellipse, 0.2, 0.4, 0},
        {OpeningShape::vertical_cylinder, 0.2, 0.2, 0.5},
        {OpeningShape::vertical_cylinder, 0.2, 0.3, 0.5},
        {OpeningShape::horizontal_cylinder, 0.026, 1.2, 0.026},
        {OpeningShape::horizontal_cylinder_across, 1.2, 0.026, 0.026},
        {OpeningShape::upright_disk, 0.2, 0, 0.2},
        {OpeningShape::upright_disk, 0, 0.2, 0.2},
        {OpeningShape::sphere, 0.25, 0.25, 0.25},
        {OpeningShape::ellipsoid, 0.25, 0.3, 0.4},
    };
    int kept_in_1995 = 0;
    for (const LuminousOpening& opening : shapes) {
        for (const IesVersion version : {IesVersion::lm63_1995, IesVersion::lm63_2002, IesVersion::lm63_2019}) {
            Profile profile;
            IesFile file;
            file.version = version;
            const LuminousOpening written = set_opening(file, opening);
            profile.file = file;
            const LuminousOpening read = luminous_opening(profile);
            EXPECT_EQ(read.shape, written.shape);
            const bool same = read.shape == opening.shape;
            if (version == IesVersion::lm63_1995)
                kept_in_1995 += same ? 1 : 0;
            else
                EXPECT_TRUE(same) << to_text(opening.shape) << " read as " << to_text(read.shape);
            EXPECT_NEAR(read.width_m, opening.width_m, same ? 1e-12 : 1.0) << to_text(opening.shape);
            EXPECT_NEAR(read.length_m, opening.length_m, same ? 1e-12 : 1.0) << to_text(opening.shape);
            EXPECT_NEAR(read.height_m, opening.height_m, same ? 1e-12 : 1.0) << to_text(opening.shape);
        }
        LdtFile ldt;
        const LuminousOpening written = set_opening(ldt, opening);
        const bool known = opening.shape == OpeningShape::point || opening.shape == OpeningShape::rectangle ||
                           opening.shape == OpeningShape::box || opening.shape == OpeningShape::disk ||
                           (opening.shape == OpeningShape::vertical_cylinder && opening.width_m == opening.length_m);
        EXPECT_EQ(written.shape == opening.shape, known) << to_text(opening.shape) << " as " << to_text(written.shape);
    }
    EXPECT_EQ(kept_in_1995, 11); // all but the flat ellipse and the two upright disks
}

} // namespace
