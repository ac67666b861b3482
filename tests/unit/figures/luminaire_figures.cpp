// All figures of a profile: in every format and convention, and the reasons for those that are not there.
#include <gonio/asset/figures_record.hpp>
#include <gonio/figures/figure_rules.hpp>
#include <gonio/figures/luminaire_figures.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/to_profile.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gonio {
namespace {

Profile profile_named(const std::string& name) {
    return read_profile_file(std::string(test::source_folder) + "/profiles/" + name).value();
}

LuminaireFigures figures_of(const Profile& profile, const ResolveOptions& options = {}) {
    return luminaire_figures(profile, resolve_web(profile, options).value().web, options);
}

void expect_same(const UgrTable& a, const UgrTable& b, double tolerance) {
    for (std::size_t row = 0; row < a.size(); ++row)
        for (std::size_t column = 0; column < a[row].size(); ++column)
            EXPECT_NEAR(a[row][column], b[row][column], tolerance) << row << ' ' << column;
}

// C0 is along a luminaire in LM-63 and across it in EULUMDAT: turned from one to the other, the view is the same.
TEST(LuminaireFigures, AreTheSameInBothConventions) {
    for (const char* const name : {"batwing.ldt", "batwing.ies", "bare-tube.ldt", "street.ies"}) {
        const Profile profile = profile_named(name);
        ResolveOptions ies;
        ies.azimuth = AzimuthConvention::lm63;
        ResolveOptions eulumdat;
        eulumdat.azimuth = AzimuthConvention::eulumdat;
        const LuminaireFigures a = figures_of(profile, ies);
        const LuminaireFigures b = figures_of(profile, eulumdat);
        EXPECT_EQ(a.crosswise_c_deg, -90.0);
        EXPECT_EQ(b.crosswise_c_deg, 0.0);
        expect_same(*a.ugr, *b.ugr, 1e-9);
        expect_same(*figures_of(profile).ugr, *b.ugr, 1e-9);
        EXPECT_NEAR(a.luminances->nt[4][0], b.luminances->nt[4][6], 1e-6 * b.luminances->nt[4][6]);
        EXPECT_NEAR(a.glare->cd_per_m, b.glare->cd_per_m, 1e-9);
        EXPECT_EQ(to_text(*a.bug), to_text(*b.bug));
    }
}

TEST(LuminaireFigures, SurviveAConversionWithItsAzimuth) {
    const Profile ldt = profile_named("bare-tube.ldt");
    ResolveOptions ies;
    ies.azimuth = AzimuthConvention::lm63;
    const Profile converted = convert_profile(ldt, ProfileTarget::lm63, ies).value().profile;
    const LuminaireFigures before = figures_of(ldt);
    const LuminaireFigures after = figures_of(converted);
    expect_same(*before.ugr, *after.ugr, 0.01);
    EXPECT_NEAR((*before.coefficients)[5][3], (*after.coefficients)[5][3], 1e-5);
}

TEST(LuminaireFigures, OfTheLampsAndOfTheLuminaire) {
    const LuminaireFigures figures = figures_of(profile_named("bare-tube.ldt"));
    EXPECT_NEAR(figures.output->all, 1.0, 1e-4);
    EXPECT_NEAR(figures.output->downward, 0.5, 1e-4);
    EXPECT_NEAR(*figures.upward_share, 0.5, 1e-4);
    EXPECT_EQ(*figures.distribution, 'C');
    EXPECT_NEAR(*figures.ugr_correction, 8.0 * std::log10(3.35), 1e-12);
    // The last column has no reflections: the direct ratio of the downward light.
    for (std::size_t k = 0; k < room_indices.size(); ++k)
        EXPECT_NEAR(figures.factors.value()[k].back(), figures.output->downward * (*figures.direct_ratios)[k], 1e-12);
}

TEST(LuminaireFigures, SayWhyTheyAreNotThere) {
    const std::string radiometric = "IESNA:LM-63-2002\n[TEST] x\n[_INTENSITYUNITS] mW/sr\nTILT=NONE\n"
                                    "1 -1 1 2 1 1 2 0 0 0 1 1 10\n0 90\n0\n5 1\n";
    const LuminaireFigures none = figures_of(read_profile(radiometric, "uv.ies").value());
    EXPECT_EQ(none.ugr.error(), "the file states mW/sr, not candela");
    EXPECT_EQ(none.bug.error(), none.ugr.error());
    const std::string point = "IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0 1 1 10\n0 90\n0\n5 1\n";
    const LuminaireFigures no_opening = figures_of(read_profile(point, "point.ies").value());
    EXPECT_EQ(no_opening.ugr.error(), "the file states no luminous opening");
    EXPECT_EQ(no_opening.luminances.error(), no_opening.ugr.error());
    EXPECT_TRUE(no_opening.factors);
}

TEST(FiguresRecord, HasARuleForEachFigureAndAReasonForEachGap) {
    for (const char* const name : {"bare-tube.ldt", "portable/downlight.ies"}) {
        const detail::Json json = detail::figures_json(figures_of(profile_named(name)));
        EXPECT_EQ(json.find("figure_rules")->size(), figure_rules.size());
        for (const FigureRule& rule : figure_rules) {
            ASSERT_TRUE(json.contains(rule.figure)) << rule.figure;
            EXPECT_EQ(json.find(rule.figure)->is_null(), json.find("missing_figures")->contains(rule.figure));
        }
    }
    const detail::Json json = detail::figures_json(figures_of(profile_named("bare-tube.ldt")));
    EXPECT_EQ(json.find("ugr_table")->size(), 19);
    EXPECT_EQ(json.find("ugr_table")->front().size(), 10);
    EXPECT_EQ(json.find("ugr_rooms")->front().as_string(), "2x2");
    EXPECT_EQ(json.find("ugr_reflectances")->front().as_string(), "70/50/20");
    EXPECT_EQ(json.find("direct_ratios")->size(), 10);
}

} // namespace
} // namespace gonio
