// Webs and headers written into files: nothing lost that the format holds, everything else said.
#include <gonio/profile/read.hpp>
#include <gonio/profile/write.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/to_profile.hpp>

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

constexpr ProfileTarget every_target[] = {ProfileTarget::lm63_1995, ProfileTarget::lm63_2002, ProfileTarget::lm63_2019,
                                          ProfileTarget::portable,  ProfileTarget::eulumdat,  ProfileTarget::tm33};

std::string said(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics)
        text += to_text(diagnostic) + "\n";
    return text;
}

bool says(const Diagnostics& diagnostics, std::string_view code, std::string_view part = {}) {
    return std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& diagnostic) {
        return diagnostic.code == code && diagnostic.message.find(part) != std::string::npos;
    });
}

// Made, written, read and resolved again.
struct RoundTrip {
    MadeProfile made;
    Profile read;
    Web web;
};

RoundTrip round_trip(const Web& web, const ProfileHeader& header, ProfileTarget target) {
    Result<MadeProfile> made = to_profile(web, header, target);
    EXPECT_TRUE(made);
    Result<Profile> read = read_profile(write_profile(made->profile, target), "written");
    EXPECT_TRUE(read) << said(read.error().diagnostics);
    Result<ResolvedWeb> resolved = resolve_web(*read);
    EXPECT_TRUE(resolved) << said(resolved.error().diagnostics);
    return {*made, *read, resolved->web};
}

// Agreement at random directions, none of them within a hair of an angle of the table where it may end.
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
            // The ramps beside what is dark are 0.0001 degrees wide.
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
                // Random planes disagree at the poles, and of random light nothing is known of 0 and 360.
                const bool of_the_light = diagnostic.code.substr(3) == "0403" || diagnostic.code == "IES0404";
                if (diagnostic.code == "LDT0404" && web.gammas_deg().front() >= 90.0) continue; // all of it goes up
                EXPECT_TRUE(of_the_light) << name << " as " << to_text(target) << ": " << to_text(diagnostic);
            }
        }
    }
}

// Types A and B stay what they are in LM-63: the table itself, with zeros where the standard asks for more angles.
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
    // What knows type C alone gets a smooth web within the stated tolerance.
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
    // The last gap must not be the widest: readers would take it for a dark sector.
    const Web wide = *Web::create(Symmetry::none, {0, 90, 360}, {0, 90}, {1, 2, 3, 4, 1, 2});
    const LdtFile ldt = std::get<LdtFile>(to_profile(wide, {}, ProfileTarget::eulumdat)->profile.file);
    EXPECT_EQ(ldt.planes_deg, (List{0, 90, 225}));
    EXPECT_EQ(ldt.symmetry, 0);
}

// EULUMDAT computes planes from their step where it is not 0.
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

TEST(ToProfile, RelativeAndAbsolutePhotometry) {
    const Web web = random_web(Symmetry::axial, {0}, steps(0, 90, 10), 6);
    ProfileHeader header;
    header.lamp_count = 3;
    header.lamp_flux_lm = 2400.0;
    const RoundTrip relative = round_trip(web, header, ProfileTarget::eulumdat);
    const LdtFile& ldt = std::get<LdtFile>(relative.read.file);
    EXPECT_EQ(ldt.lamp_sets.at(0).lamp_count, 3);
    EXPECT_EQ(ldt.lamp_sets.at(0).flux_lm, 2400.0);
    EXPECT_NEAR(ldt.light_output_ratio_percent, 100.0 * flux(web).value / 2400.0, 0.006);
    EXPECT_EQ(ldt.downward_flux_percent, 100.0);
    EXPECT_EQ(declared_flux_lm(relative.read), 2400.0);
    const RoundTrip as_ies = round_trip(web, header, ProfileTarget::lm63_2002);
    EXPECT_EQ(std::get<IesFile>(as_ies.read.file).lumens_per_lamp, 800.0);
    EXPECT_EQ(std::get<IesFile>(as_ies.read.file).lamp_count, 3);

    header.lamp_flux_lm.reset();
    const RoundTrip absolute = round_trip(web, header, ProfileTarget::eulumdat);
    const LdtLampSet& set = std::get<LdtFile>(absolute.read.file).lamp_sets.at(0);
    EXPECT_EQ(set.lamp_count, -3);
    EXPECT_NEAR(set.flux_lm, flux(web).value, 1e-9 * flux(web).value);
    EXPECT_EQ(std::get<LdtFile>(absolute.read.file).light_output_ratio_percent, 100.0);
    EXPECT_EQ(declared_flux_lm(absolute.read), std::nullopt);
    EXPECT_EQ(std::get<IesFile>(round_trip(web, header, ProfileTarget::lm63_2002).read.file).lumens_per_lamp, -1.0);
    EXPECT_EQ(header_of(absolute.read).lamp_flux_lm, std::nullopt);
    EXPECT_EQ(header_of(absolute.read).lamp_count, 3);

    // A luminaire that shines upwards, and one that is dark.
    const Web up = random_web(Symmetry::axial, {0}, steps(90, 180, 10), 6);
    EXPECT_EQ(std::get<LdtFile>(round_trip(up, header, ProfileTarget::eulumdat).read.file).downward_flux_percent, 0.0);
    const Web dark = *Web::create(Symmetry::axial, {0}, {0, 90}, {0, 0});
    EXPECT_EQ(std::get<LdtFile>(round_trip(dark, header, ProfileTarget::eulumdat).read.file).candela_per_klm,
              (std::vector<double>{0, 0}));
}

TEST(ToProfile, TextsGoToTheirFieldsAndBack) {
    ProfileHeader header;
    header.keywords = {{"TEST", "T 17"},     {"MANUFAC", "Lamp Works"},
                       {"LUMCAT", "LW-1"},   {"luminaire", "Pendant\nof two lines"},
                       {"LAMP", "LED 930"},  {"ISSUEDATE", "2021-02-03"},
                       {"_CCT", "3000"},     {"_CRI", "90"},
                       {"OTHER", "a"},       {"OTHER", "b"},
                       {"BALLAST", "driver"}};
    header.input_watts = 12.5;
    const Web web = random_web(Symmetry::axial, {0}, {0, 45, 90}, 6);
    const RoundTrip out = round_trip(web, header, ProfileTarget::eulumdat);
    const LdtFile& file = std::get<LdtFile>(out.read.file);
    EXPECT_EQ(file.report_number, "T 17");
    EXPECT_EQ(file.company, "Lamp Works");
    EXPECT_EQ(file.luminaire_number, "LW-1");
    EXPECT_EQ(file.luminaire_name, "Pendant of two lines");
    EXPECT_EQ(file.date_user, "2021-02-03");
    EXPECT_EQ(file.lamp_sets.at(0).lamp_type, "LED 930");
    EXPECT_EQ(file.lamp_sets.at(0).color_temperature, "3000");
    EXPECT_EQ(file.lamp_sets.at(0).color_rendering, "90");
    EXPECT_EQ(file.lamp_sets.at(0).input_watts, 12.5);
    EXPECT_TRUE(says(out.made.diagnostics, "WEB0201", "[OTHER] ×2, [BALLAST]")) << said(out.made.diagnostics);

    const ProfileHeader back = header_of(out.read);
    for (const char* const name : {"TEST", "MANUFAC", "LUMCAT", "LAMP", "ISSUEDATE", "_CCT", "_CRI"})
        EXPECT_EQ(keyword_text(back, name), keyword_text(header, name)) << name;
    EXPECT_EQ(back.input_watts, 12.5);
    const RoundTrip as_ies = round_trip(web, back, ProfileTarget::lm63_2019);
    const LdtFile again = std::get<LdtFile>(round_trip(web, header_of(as_ies.read), ProfileTarget::eulumdat).read.file);
    EXPECT_EQ(again.company, file.company);
    EXPECT_EQ(again.lamp_sets.at(0).color_temperature, "3000");
    // LAMPCAT stands in where there is no LAMP, and DATE for ISSUEDATE.
    header.keywords = {{"LAMPCAT", "L-9"}, {"DATE", "1994"}};
    const LdtFile older = std::get<LdtFile>(round_trip(web, header, ProfileTarget::eulumdat).read.file);
    EXPECT_EQ(older.lamp_sets.at(0).lamp_type, "L-9");
    EXPECT_EQ(older.date_user, "1994");
}

TEST(ToProfile, IesKeepsEveryKeywordInItsOrder) {
    ProfileHeader header;
    header.keywords = {{"OTHER", "a\nb"}, {"", "label"}, {"MANUFAC", "M"}, {"DATE", "1990"}, {"OTHER", "c"}};
    const Web web = random_web(Symmetry::axial, {0}, {0, 90}, 6);
    const RoundTrip out = round_trip(web, header, ProfileTarget::lm63_2002);
    std::string names;
    for (const IesKeyword& keyword : std::get<IesFile>(out.read.file).keywords)
        names += keyword.name + "=" + keyword.text + ";";
    EXPECT_EQ(names, "TEST=unknown;TESTLAB=unknown;OTHER=a\nb;OTHER=label;MANUFAC=M;ISSUEDATE=1990;OTHER=c;");
    EXPECT_TRUE(says(out.made.diagnostics, "WEB0215", "[TEST], [TESTLAB]")) << said(out.made.diagnostics);
    const RoundTrip older = round_trip(web, header, ProfileTarget::lm63_1995);
    EXPECT_EQ(std::get<IesFile>(older.read.file).keywords.size(), 5U);
    EXPECT_FALSE(says(older.made.diagnostics, "WEB0215"));
}

TEST(ToProfile, LampSetsAndFieldsThatAreLost) {
    LdtFile file;
    file.symmetry = 1;
    file.plane_count = 1;
    file.gamma_count = 2;
    file.gamma_step_deg = 90;
    file.planes_deg = {0};
    file.gammas_deg = {0, 90};
    file.candela_per_klm = {100, 10};
    file.direct_ratios = {0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0};
    file.lamp_sets = {{1, "A", 1000, "2700", "80", 10}, {2, "B", 3000, "4000", "90", 30}, {-1, "C", 500, "", "", 5}};
    file.file_name = "LAMP.LDT";
    file.tilt_deg = 15;
    file.length_mm = 300;
    Profile profile;
    profile.source = "lamp.ldt";
    profile.file = file;
    ResolveOptions second;
    second.lamp_set = 2;
    const Result<MadeProfile> made = convert_profile(profile, ProfileTarget::lm63_2002, second);
    ASSERT_TRUE(made);
    const IesFile& ies = std::get<IesFile>(made->profile.file);
    EXPECT_EQ(ies.lamp_count, 2);
    EXPECT_EQ(ies.lumens_per_lamp, 1500.0);
    EXPECT_EQ(ies.input_watts, 30.0);
    EXPECT_EQ(ies.candela.at(0), 300.0);
    EXPECT_TRUE(says(made->diagnostics, "WEB0203", "2 other lamp sets"));
    EXPECT_TRUE(says(made->diagnostics, "WEB0210", "housing, file name, direct ratios, tilt"))
        << said(made->diagnostics);
    ResolveOptions third;
    third.lamp_set = 3;
    EXPECT_EQ(
        std::get<IesFile>(convert_profile(profile, ProfileTarget::lm63_2002, third)->profile.file).lumens_per_lamp,
        -1.0);
    ResolveOptions fourth;
    fourth.lamp_set = 4;
    EXPECT_EQ(convert_profile(profile, ProfileTarget::lm63_2002, fourth).error().failure, Failure::usage);
    // EULUMDAT itself keeps all of it.
    const Result<MadeProfile> kept = convert_profile(profile, ProfileTarget::eulumdat);
    EXPECT_EQ(std::get<LdtFile>(kept->profile.file).lamp_sets.size(), 3U);
    EXPECT_TRUE(kept->diagnostics.empty());
}

IesFile an_old_file() {
    IesFile file;
    file.version = IesVersion::lm63_1991;
    file.version_line = "IESNA91";
    file.lamp_count = 2;
    file.lumens_per_lamp = 500;
    file.candela_multiplier = 2.0;
    file.ballast_factor = 0.9;
    file.field_12 = 0.5;
    file.feet = true;
    file.width = -1.0;
    file.vertical_deg = {0, 90};
    file.horizontal_deg = {0};
    file.candela = {100, 10};
    file.tilt_keyword = "INCLUDE";
    file.tilt = {1, {0, 90}, {0.8, 0.7}};
    return file;
}

TEST(ToProfile, FactorsStayFactorsBetweenEditions) {
    Profile profile;
    profile.file = an_old_file();
    const Web before = resolve_web(profile)->web;
    EXPECT_DOUBLE_EQ(before.candela(0, 0), 100 * 2 * 0.9 * 0.5 * 0.8);
    for (const ProfileTarget target : {ProfileTarget::lm63_1995, ProfileTarget::lm63_2002, ProfileTarget::lm63_2019}) {
        const Result<MadeProfile> made = convert_profile(profile, target);
        ASSERT_TRUE(made);
        const IesFile& file = std::get<IesFile>(made->profile.file);
        EXPECT_EQ(file.candela_multiplier, 2.0);
        EXPECT_DOUBLE_EQ(file.ballast_factor, 0.45);
        EXPECT_EQ(file.field_12, 1.0);
        EXPECT_EQ(file.tilt_keyword, "INCLUDE");
        EXPECT_EQ(file.tilt.factors, (std::vector<double>{0.8, 0.7}));
        EXPECT_EQ(file.candela, (std::vector<double>{100, 10}));
        EXPECT_NEAR(resolve_web(*read_profile(write_profile(made->profile, target), "a"))->web.candela(0, 0),
                    before.candela(0, 0), 1e-12);
        EXPECT_EQ(luminous_opening(made->profile).shape, OpeningShape::disk);
        EXPECT_NEAR(luminous_opening(made->profile).width_m, 0.3048, 1e-9);
    }
    const Result<MadeProfile> portable = convert_profile(profile, ProfileTarget::portable);
    EXPECT_TRUE(says(portable->diagnostics, "WEB0202"));
    EXPECT_NEAR(std::get<IesFile>(portable->profile.file).candela.at(0), 72.0, 1e-9);
    // The same edition, or none named: field by field.
    EXPECT_EQ(write_profile(convert_profile(profile, ProfileTarget::lm63)->profile, ProfileTarget::lm63),
              write_ies(an_old_file()));
    // Another tilt than the one at 0 is a factor that must be multiplied in.
    ResolveOptions tilted;
    tilted.tilt_deg = 90.0;
    const Result<MadeProfile> made = convert_profile(profile, ProfileTarget::lm63, tilted);
    EXPECT_EQ(std::get<IesFile>(made->profile.file).tilt_keyword, "NONE");
    EXPECT_NEAR(std::get<IesFile>(made->profile.file).candela.at(0), 63.0, 1e-12);
    EXPECT_TRUE(says(made->diagnostics, "WEB0202"));
}

TEST(ToProfile, FileGenerationTypeAndTiltFile) {
    Profile profile;
    IesFile file = an_old_file();
    file.version = IesVersion::lm63_2019;
    file.version_line.clear();
    file.field_12 = 1.1;
    file.tilt_keyword = "LAMP.TLT";
    profile.file = file;
    EXPECT_TRUE(says(convert_profile(profile, ProfileTarget::eulumdat)->diagnostics, "WEB0211", "1.1"));
    EXPECT_TRUE(says(convert_profile(profile, ProfileTarget::lm63_2002)->diagnostics, "WEB0211", "1.1"));
    const Result<MadeProfile> kept = convert_profile(profile, ProfileTarget::lm63_2019);
    EXPECT_EQ(std::get<IesFile>(kept->profile.file).field_12, 1.1);
    EXPECT_EQ(std::get<IesFile>(kept->profile.file).tilt_keyword, "INCLUDE");
    EXPECT_TRUE(says(kept->diagnostics, "WEB0217", "TILT=LAMP.TLT"));
}

// TM-33 has an element for most of LM-63's keywords, and keeps the others in comments that name them.
TEST(ToProfile, Tm33KeepsEveryKeywordAndFactor) {
    Profile profile;
    IesFile file = an_old_file();
    file.keywords = {{"TEST", "T1"}, {"MANUFAC", "L\xE4mp"}, {"BALLAST", "driver"}, {"OTHER", "a\nb"}, {"LAMP", "LED"}};
    profile.file = file;
    const Result<MadeProfile> made = convert_profile(profile, ProfileTarget::tm33);
    ASSERT_TRUE(made);
    const Result<Profile> read = read_profile(write_profile(made->profile, ProfileTarget::tm33), "written");
    ASSERT_TRUE(read) << said(read.error().diagnostics);
    const auto& tm33 = std::get<Tm33File>(read->file);
    ASSERT_EQ(tm33.emitters.size(), 1U);
    EXPECT_EQ(tm33.emitters[0].intensity->multiplier, 2.0);
    EXPECT_DOUBLE_EQ(tm33.emitters[0].ballast_factor.value_or(0.0), 0.45);
    EXPECT_EQ(tm33.emitters[0].tilt.factors, (std::vector<double>{0.8, 0.7}));
    EXPECT_EQ(tm33.emitters[0].quantity, 2.0);
    EXPECT_EQ(tm33.emitters[0].rated_lumens, 500.0);
    EXPECT_NEAR(tm33.emitters[0].luminous_flux_lm.value_or(0.0), flux(resolve_web(profile)->web).value, 1e-9);
    EXPECT_NEAR(resolve_web(*read)->web.candela(0, 0), 72.0, 1e-12);
    const ProfileHeader back = header_of(*read);
    EXPECT_EQ(keyword_text(back, "TEST"), "T1");
    EXPECT_EQ(keyword_text(back, "MANUFAC"), "L\xC3\xA4mp"); // XML is UTF-8
    EXPECT_EQ(keyword_text(back, "BALLAST"), "driver");
    EXPECT_EQ(keyword_text(back, "OTHER"), "a\nb");
    EXPECT_EQ(keyword_text(back, "LAMP"), "LED");
    EXPECT_EQ(back.opening.shape, OpeningShape::disk);
    EXPECT_TRUE(says(made->diagnostics, "WEB0215", "Description, Laboratory, ReportDate")) << said(made->diagnostics);
    // On to a format without tilts or spectra.
    Profile rich = *read;
    auto& emitter = std::get<Tm33File>(rich.file).emitters[0];
    emitter.spectra.push_back({"s", {}, {}, {400, 500}, {1, 2}});
    emitter.cct_k = 3000.0;
    emitter.cri_ra = 95.0;
    const Result<MadeProfile> ldt = convert_profile(rich, ProfileTarget::eulumdat);
    EXPECT_TRUE(says(ldt->diagnostics, "WEB0204", "1 spectrum"));
    EXPECT_TRUE(says(ldt->diagnostics, "WEB0202"));
    EXPECT_EQ(std::get<LdtFile>(ldt->profile.file).lamp_sets[0].color_temperature, "3000");
    EXPECT_EQ(std::get<LdtFile>(ldt->profile.file).lamp_sets[0].color_rendering, "95");
    std::get<Tm33File>(rich.file).emitters.push_back(emitter);
    EXPECT_TRUE(says(convert_profile(rich, ProfileTarget::lm63_2019)->diagnostics, "WEB0218", "2 emitters"));
    EXPECT_TRUE(convert_profile(rich, ProfileTarget::tm33)->diagnostics.empty());
}

} // namespace
