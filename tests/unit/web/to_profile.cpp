// Tables of webs written into files: the light is kept, whatever the planes and angles are.
#include <gonio/profile/read.hpp>
#include <gonio/profile/write.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/to_profile.hpp>

#include "round_trip.hpp"
#include "webs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace {

using namespace gonio;
using namespace gonio::test;

// Agreement in random directions, none of them very close to an angle where the table may end.
void expect_same_light(const Web& a, const Web& b, double tolerance, const std::string& what) {
    const double bright = peak(a).intensity.value;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> c(0.0, 360.0);
    std::uniform_real_distribution<double> gamma(0.0, 180.0);
    for (int i = 0; i < 2000; ++i) {
        const double at_c = c(random);
        const double at_gamma = gamma(random);
        ASSERT_NEAR(a.candela(at_c, at_gamma), b.candela(at_c, at_gamma), tolerance * bright)
            << what << " at C " << at_c << ", gamma " << at_gamma;
    }
    EXPECT_LE(conversion_error(a, b).relative, tolerance) << what;
}

struct Case {
    const char* name;
    Web web;
};

std::vector<Case> every_kind_of_web() {
    const std::vector<double> half = steps(0.0, 90.0, 19);
    const std::vector<double> full = steps(0.0, 180.0, 37);
    return {
        {"axial", random_web(Symmetry::axial, {0.0}, full, 1)},
        {"axial, not at 0", random_web(Symmetry::axial, {205.0}, half, 2)},
        {"quadrant", random_web(Symmetry::quadrant, steps(0.0, 90.0, 7), half, 3)},
        {"quadrant, uneven", random_web(Symmetry::quadrant, {0.0, 7.0, 45.0, 90.0}, full, 4)},
        {"quadrant that misses 90", random_web(Symmetry::quadrant, {0.0, 20.0, 60.0}, full, 5)},
        {"0-180", random_web(Symmetry::bilateral_0_180, steps(0.0, 180.0, 13), full, 6)},
        {"0-180, two planes", random_web(Symmetry::bilateral_0_180, {0.0, 180.0}, half, 7)},
        {"90-270", random_web(Symmetry::bilateral_90_270, steps(90.0, 270.0, 13), half, 8)},
        {"90-270, uneven", random_web(Symmetry::bilateral_90_270, {90.0, 100.0, 185.0, 240.0, 270.0}, full, 9)},
        {"90-270 that misses 270", random_web(Symmetry::bilateral_90_270, {90.0, 150.0, 210.0}, full, 10)},
        {"none", random_web(Symmetry::none, steps(0.0, 345.0, 24), full, 11)},
        {"none, from -180", random_web(Symmetry::none, steps(-180.0, 180.0, 25), full, 12)},
        {"none, from 7.5", random_web(Symmetry::none, steps(7.5, 367.5, 25), half, 13)},
        {"none, wide last cell", random_web(Symmetry::none, {0.0, 90.0, 360.0}, half, 14)},
        {"none, 0 and 360", random_web(Symmetry::none, {0.0, 360.0}, half, 15)},
        {"a sector", random_web(Symmetry::none, {20.0, 50.0, 130.0}, full, 16)},
        {"a sector over 0", random_web(Symmetry::none, {-30.0, 10.0, 40.0}, full, 17)},
        {"gamma 10-140", random_web(Symmetry::axial, {0.0}, steps(10.0, 140.0, 14), 18)},
        {"gamma 30-60", random_web(Symmetry::quadrant, {0.0, 90.0}, {30.0, 40.0, 60.0}, 19)},
        {"gamma 90-180", random_web(Symmetry::bilateral_0_180, {0.0, 180.0}, steps(90.0, 180.0, 10), 20)},
        {"gamma 100-170", random_web(Symmetry::axial, {0.0}, steps(100.0, 170.0, 8), 21)},
    };
}

TEST(ToProfile, EveryKindOfWebSurvivesEveryTarget) {
    for (const auto& [name, web] : every_kind_of_web()) {
        for (const ProfileTarget target : every_target) {
            const std::string what = std::string(name) + " as " + to_text(target);
            const RoundTrip out = round_trip(web, {}, target);
            expect_same_light(web, out.web, target == ProfileTarget::portable ? 1e-8 : 1e-12, what);
            // The ramps next to dark parts are 0.0001 degrees wide.
            EXPECT_NEAR(flux(out.web).value, flux(web).value, 2e-5 * flux(web).value) << what;
        }
    }
}

TEST(ToProfile, WhatIsWrittenBreaksNoRule) {
    ProfileHeader header;
    header.keywords = {{"TEST", "1"}, {"TESTLAB", "L"}, {"ISSUEDATE", "2020"}, {"MANUFAC", "M"}};
    for (const auto& [name, web] : every_kind_of_web()) {
        for (const ProfileTarget target : every_target) {
            const Result<MadeProfile> made = to_profile(web, header, target);
            ASSERT_TRUE(made);
            ReadOptions strict;
            strict.strict = true;
            const Result<Profile> read = read_profile(write_profile(made->profile, target), "written", strict);
            ASSERT_TRUE(read) << name << " as " << to_text(target) << "\n" << said(read.error().diagnostics);
            for (const Diagnostic& diagnostic : read->diagnostics) {
                // Random planes disagree at the poles, and the planes at 0 and 360 of random light need not agree.
                const bool of_the_light = diagnostic.code.substr(3) == "0403" || diagnostic.code == "IES0404";
                if (diagnostic.code == "LDT0404" && web.gammas_deg().front() >= 90.0) continue; // all light goes up
                EXPECT_TRUE(of_the_light) << name << " as " << to_text(target) << ": " << to_text(diagnostic);
            }
        }
    }
}

// Types A and B are kept in LM-63: the table itself, with zeros if the standard requires more angles.
TEST(ToProfile, TypesAAndBKeepTheirCoordinates) {
    struct Table {
        Symmetry symmetry;
        std::vector<double> h;
        std::vector<double> v;
    };
    const Table tables[] = {{Symmetry::none, steps(-90, 90, 19), steps(-90, 90, 19)},
                            {Symmetry::none, {-30, 0, 45}, {-20, 10}},
                            {Symmetry::none, {10, 20, 45}, {5, 60}}, // not mirrored, though it begins above 0
                            {Symmetry::bilateral_90_270, {0, 20, 45}, {-30, 60}},
                            {Symmetry::bilateral_0_180, {-40, 45}, {0, 10, 90}},
                            {Symmetry::quadrant, {0, 30, 60}, {0, 10, 70}}};
    std::mt19937 random(3);
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        for (const Table& table : tables) {
            std::vector<double> candela(table.h.size() * table.v.size());
            for (double& cd : candela)
                cd = static_cast<double>(random() % 1000U);
            const Result<Web> web = Web::create(type, table.symmetry, table.h, table.v, candela);
            ASSERT_TRUE(web);
            for (const ProfileTarget target :
                 {ProfileTarget::lm63_1995, ProfileTarget::lm63_2002, ProfileTarget::lm63_2019}) {
                const RoundTrip out = round_trip(*web, {}, target);
                EXPECT_EQ(out.web.photometry(), type);
                EXPECT_EQ(out.web.stored_symmetry(), table.symmetry);
                EXPECT_EQ(conversion_error(*web, out.web).max.value, 0.0);
                EXPECT_NEAR(flux(out.web).value, flux(*web).value, 2e-5 * flux(*web).value);
                for (const Diagnostic& diagnostic : out.read.diagnostics)
                    EXPECT_NE(diagnostic.code.substr(0, 5), "IES03") << to_text(diagnostic);
            }
        }
    }
    // Formats that have only type C get a smooth web within the stated tolerance.
    constexpr double deg = std::numbers::pi / 180.0;
    std::vector<double> smooth;
    for (const double h : steps(-90, 90, 37))
        for (const double v : steps(-90, 90, 37))
            smooth.push_back(1000.0 * std::cos(h * deg) * std::cos(v * deg));
    const Result<Web> beam = Web::create(Photometry::b, Symmetry::none, steps(-90, 90, 37), steps(-90, 90, 37), smooth);
    for (const ProfileTarget target : {ProfileTarget::portable, ProfileTarget::eulumdat}) {
        const RoundTrip out = round_trip(*beam, {}, target);
        EXPECT_EQ(out.web.photometry(), Photometry::c);
        EXPECT_TRUE(says(out.made.diagnostics, "WEB0205", "type B resampled")) << said(out.made.diagnostics);
        for (const auto& [c, gamma] : {std::pair{0.0, 0.0}, {33.0, 21.5}, {90.0, 40.2}, {200.0, 12.3}, {300.0, 70.0}})
            EXPECT_NEAR(out.web.candela(c, gamma), beam->candela(c, gamma), 0.011 * 1000.0) << c << ", " << gamma;
        EXPECT_NEAR(flux(out.web).value, flux(*beam).value, 1e-3 * flux(*beam).value);
    }
}

TEST(ToProfile, SymmetriesStaySmall) {
    const auto planes = [](Symmetry symmetry, std::vector<double> list, ProfileTarget target) {
        const Result<MadeProfile> made =
            to_profile(random_web(symmetry, std::move(list), {0.0, 90.0}, 3), ProfileHeader(), target);
        const auto* ies = std::get_if<IesFile>(&made->profile.file);
        if (ies != nullptr) return ies->horizontal_deg;
        const LdtFile& ldt = std::get<LdtFile>(made->profile.file);
        std::vector<double> said_planes = ldt.planes_deg;
        said_planes.push_back(ldt.symmetry);
        return said_planes;
    };
    using List = std::vector<double>;
    EXPECT_EQ(planes(Symmetry::axial, {0}, ProfileTarget::eulumdat), (List{0, 1}));
    EXPECT_EQ(planes(Symmetry::quadrant, {0, 30, 90}, ProfileTarget::lm63_2002), (List{0, 30, 90}));
    EXPECT_EQ(planes(Symmetry::quadrant, {0, 30, 90}, ProfileTarget::eulumdat),
              (List{0, 30, 90, 150, 180, 210, 270, 330, 4}));
    EXPECT_EQ(planes(Symmetry::quadrant, {0, 30, 90}, ProfileTarget::portable),
              (List{0, 30, 90, 150, 180, 210, 270, 330, 360}));
    EXPECT_EQ(planes(Symmetry::bilateral_0_180, {0, 60, 180}, ProfileTarget::eulumdat), (List{0, 60, 180, 300, 2}));
    EXPECT_EQ(planes(Symmetry::bilateral_90_270, {90, 100, 270}, ProfileTarget::eulumdat), (List{80, 90, 100, 270, 3}));
    EXPECT_EQ(planes(Symmetry::bilateral_90_270, {90, 100, 270}, ProfileTarget::lm63_1995), (List{90, 100, 270}));
    EXPECT_EQ(planes(Symmetry::bilateral_90_270, {90, 100, 270}, ProfileTarget::lm63_2002),
              (List{0, 80, 90, 100, 270, 360}));
    // The last gap must not be the widest: readers would treat it as a dark sector.
    const Web wide = *Web::create(Symmetry::none, {0, 90, 360}, {0, 90}, {1, 2, 3, 4, 1, 2});
    const LdtFile ldt = std::get<LdtFile>(to_profile(wide, {}, ProfileTarget::eulumdat)->profile.file);
    EXPECT_EQ(ldt.planes_deg, (List{0, 90, 225}));
    EXPECT_EQ(ldt.symmetry, 0);
}

// EULUMDAT computes plane angles from their step unless the step is 0.
TEST(ToProfile, LdtStepsAreThoseOfTheLists) {
    const Web web = random_web(Symmetry::quadrant, steps(0, 90, 7), steps(0, 180, 73), 4);
    const LdtFile even = std::get<LdtFile>(to_profile(web, {}, ProfileTarget::eulumdat)->profile.file);
    EXPECT_EQ(even.plane_count, 24);
    EXPECT_EQ(even.plane_step_deg, 15.0);
    EXPECT_EQ(even.gamma_count, 73);
    EXPECT_EQ(even.gamma_step_deg, 2.5);
    EXPECT_EQ(even.candela_per_klm.size(), 7U * 73U);
    const Web other = random_web(Symmetry::none, {0, 10, 90}, {0, 45, 80}, 4);
    const LdtFile uneven = std::get<LdtFile>(to_profile(other, {}, ProfileTarget::eulumdat)->profile.file);
    EXPECT_EQ(uneven.plane_step_deg, 0.0);
    EXPECT_EQ(uneven.gamma_step_deg, 0.0);
}

TEST(ToProfile, PaddingIsSaid) {
    const Web cut = random_web(Symmetry::axial, {0}, steps(10, 140, 14), 5);
    for (const ProfileTarget target : every_target) {
        const Result<MadeProfile> made = to_profile(cut, {}, target);
        EXPECT_TRUE(says(made->diagnostics, "WEB0206", "10 to 140")) << said(made->diagnostics);
    }
    const Web sector = random_web(Symmetry::none, {0, 40, 80}, {0, 90}, 5);
    EXPECT_TRUE(says(to_profile(sector, {}, ProfileTarget::lm63_2002)->diagnostics, "WEB0207"));
    EXPECT_TRUE(says(to_profile(sector, {}, ProfileTarget::eulumdat)->diagnostics, "WEB0207"));
    const Web jump = random_web(Symmetry::none, {0, 120, 240, 360}, {0, 90}, 5);
    EXPECT_TRUE(says(to_profile(jump, {}, ProfileTarget::eulumdat)->diagnostics, "WEB0214"));
    EXPECT_FALSE(says(to_profile(jump, {}, ProfileTarget::lm63_2002)->diagnostics, "WEB0214"));
    // Where the table itself ends in zeros, one more angle is enough and no ramp is needed.
    const Web faded = *Web::create(Symmetry::axial, {0}, {0, 40, 70}, {100, 50, 0});
    const IesFile file = std::get<IesFile>(to_profile(faded, {}, ProfileTarget::lm63_2002)->profile.file);
    EXPECT_EQ(file.vertical_deg, (std::vector<double>{0, 40, 70, 90}));
}

} // namespace
