// The data beside a table, written into files: nothing is lost that the format can store, and everything else is
// reported.
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
#include <utility>

namespace {

using namespace gonio;
using namespace gonio::test;

TEST(ToProfileHeader, RelativeAndAbsolutePhotometry) {
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

TEST(ToProfileHeader, TextsGoToTheirFieldsAndBack) {
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
    // LAMPCAT is used if there is no LAMP, and DATE for ISSUEDATE.
    header.keywords = {{"LAMPCAT", "L-9"}, {"DATE", "1994"}};
    const LdtFile older = std::get<LdtFile>(round_trip(web, header, ProfileTarget::eulumdat).read.file);
    EXPECT_EQ(older.lamp_sets.at(0).lamp_type, "L-9");
    EXPECT_EQ(older.date_user, "1994");
}

TEST(ToProfileHeader, IesKeepsEveryKeywordInItsOrder) {
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

TEST(ToProfileHeader, LampSetsAndFieldsThatAreLost) {
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

TEST(ToProfileHeader, FactorsStayFactorsBetweenEditions) {
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
    // The same edition, or none given: kept field by field.
    EXPECT_EQ(write_profile(convert_profile(profile, ProfileTarget::lm63)->profile, ProfileTarget::lm63),
              write_ies(an_old_file()));
    // A tilt other than the one at 0 is a factor that must be multiplied in.
    ResolveOptions tilted;
    tilted.tilt_deg = 90.0;
    const Result<MadeProfile> made = convert_profile(profile, ProfileTarget::lm63, tilted);
    EXPECT_EQ(std::get<IesFile>(made->profile.file).tilt_keyword, "NONE");
    EXPECT_NEAR(std::get<IesFile>(made->profile.file).candela.at(0), 63.0, 1e-12);
    EXPECT_TRUE(says(made->diagnostics, "WEB0202"));
}

TEST(ToProfileHeader, FileGenerationTypeAndTiltFile) {
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
TEST(ToProfileHeader, Tm33KeepsEveryKeywordAndFactor) {
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
    // Then into a format without tilts or spectra.
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
