// Every rule of the EULUMDAT reader with the smallest file that triggers it.
#include <gonio/profile/read.hpp>

#include "expect.hpp"

#include <gtest/gtest.h>

namespace {

using namespace gonio;
using namespace gonio::test;

// Lines: 26 of head, 27–32 the lamp set, 33–42 direct ratios, 43–46 planes, 47–49 gammas, from 50 the table.
TextLines lamp(int symmetry = 1) {
    TextLines lines = {"Lamp Works", "1",    std::to_string(symmetry),
                       "4",          "90",   "3",
                       "45",         "R-1",  "Name",
                       "Number",     "F",    "2024",
                       "100",        "0",    "50",
                       "90",         "0",    "1",
                       "2",          "3",    "4",
                       "99",         "87.5", "1",
                       "0",          "1",    "2",
                       "LED",        "900",  "3000K/nw",
                       "1A",         "12.5"};
    for (int i = 1; i <= 10; ++i)
        lines.push_back("0." + std::to_string(i));
    lines.insert(lines.end(), {"0", "90", "180", "270", "0", "45", "90"});
    const int stored = stored_plane_count(symmetry, 4);
    for (int plane = 0; plane < stored; ++plane)
        for (int gamma = 0; gamma < 3; ++gamma)
            lines.push_back(gamma == 0 ? "100" : std::to_string(90 - 10 * plane - 20 * gamma));
    return lines;
}

Result<Profile> read(const TextLines& lines, bool strict = false) {
    return read_profile(joined(lines, "\r\n"), "lamp", {ProfileFormat::ldt, strict});
}
LdtFile file_of(const TextLines& lines) {
    Result<Profile> profile = read(lines);
    EXPECT_TRUE(profile) << said(profile);
    return profile ? std::get<LdtFile>(profile->file) : LdtFile{};
}

TEST(LdtRead, ReadsEveryField) {
    expect_silent(read(lamp()));
    expect_silent(read(lamp(), true));
    const LdtFile file = file_of(lamp());
    EXPECT_EQ(file.company, "Lamp Works");
    EXPECT_EQ(file.type_indicator, 1);
    EXPECT_EQ(file.symmetry, 1);
    EXPECT_EQ(file.plane_count, 4);
    EXPECT_EQ(file.plane_step_deg, 90.0);
    EXPECT_EQ(file.gamma_count, 3);
    EXPECT_EQ(file.gamma_step_deg, 45.0);
    EXPECT_EQ(file.report_number, "R-1");
    EXPECT_EQ(file.luminaire_name, "Name");
    EXPECT_EQ(file.luminaire_number, "Number");
    EXPECT_EQ(file.file_name, "F");
    EXPECT_EQ(file.date_user, "2024");
    EXPECT_EQ(file.length_mm, 100.0);
    EXPECT_EQ(file.width_mm, 0.0);
    EXPECT_EQ(file.height_mm, 50.0);
    EXPECT_EQ(file.luminous_length_mm, 90.0);
    EXPECT_EQ(file.luminous_width_mm, 0.0);
    EXPECT_EQ(file.luminous_height_c0_mm, 1.0);
    EXPECT_EQ(file.luminous_height_c90_mm, 2.0);
    EXPECT_EQ(file.luminous_height_c180_mm, 3.0);
    EXPECT_EQ(file.luminous_height_c270_mm, 4.0);
    EXPECT_EQ(file.downward_flux_percent, 99.0);
    EXPECT_EQ(file.light_output_ratio_percent, 87.5);
    EXPECT_EQ(file.conversion_factor, 1.0);
    EXPECT_EQ(file.tilt_deg, 0.0);
    ASSERT_EQ(file.lamp_sets.size(), 1U);
    EXPECT_EQ(file.lamp_sets[0].lamp_count, 2);
    EXPECT_EQ(file.lamp_sets[0].lamp_type, "LED");
    EXPECT_EQ(file.lamp_sets[0].flux_lm, 900.0);
    EXPECT_EQ(file.lamp_sets[0].color_temperature, "3000K/nw");
    EXPECT_EQ(file.lamp_sets[0].color_rendering, "1A");
    EXPECT_EQ(file.lamp_sets[0].input_watts, 12.5);
    ASSERT_EQ(file.direct_ratios.size(), 10U);
    EXPECT_EQ(file.direct_ratios[8], 0.9);
    EXPECT_EQ(file.planes_deg, (std::vector<double>{0, 90, 180, 270}));
    EXPECT_EQ(file.gammas_deg, (std::vector<double>{0, 45, 90}));
    EXPECT_EQ(file.candela_per_klm, (std::vector<double>{100, 70, 50}));
}

TEST(LdtRead, EverySymmetryStoresItsPlanes) {
    const std::size_t stored[] = {4, 1, 3, 3, 2};
    for (int symmetry = 0; symmetry <= 4; ++symmetry) {
        const Result<Profile> profile = read(lamp(symmetry));
        expect_silent(profile);
        const LdtFile& file = std::get<LdtFile>(profile->file);
        EXPECT_EQ(file.symmetry, symmetry);
        EXPECT_EQ(file.planes_deg.size(), 4U);
        EXPECT_EQ(file.candela_per_klm.size(), 3 * stored[symmetry]);
        TextLines one_less = lamp(symmetry);
        one_less.pop_back();
        EXPECT_FALSE(read(one_less)) << symmetry;
    }
    EXPECT_EQ(stored_plane_count(2, 24), 13);
    EXPECT_EQ(stored_plane_count(3, 24), 13);
    EXPECT_EQ(stored_plane_count(4, 24), 7);
}

TEST(LdtRead, LampSetsStandOneAfterTheOther) {
    TextLines lines = with(with(lamp(), 26, "2"), 23, "100");
    lines.insert(lines.begin() + 32, {"-3", "HIT", "3600", "4000", ">90", "40"});
    const LdtFile file = file_of(lines);
    ASSERT_EQ(file.lamp_sets.size(), 2U);
    EXPECT_EQ(file.lamp_sets[0].flux_lm, 900.0);
    EXPECT_EQ(file.lamp_sets[1].lamp_count, -3);
    EXPECT_EQ(file.lamp_sets[1].lamp_type, "HIT");
    EXPECT_EQ(file.lamp_sets[1].flux_lm, 3600.0);
    EXPECT_EQ(file.lamp_sets[1].color_temperature, "4000");
    EXPECT_EQ(file.lamp_sets[1].color_rendering, ">90");
    EXPECT_EQ(file.lamp_sets[1].input_watts, 40.0);
    expect_silent(read(lines));
    expect_says(read(with(lines, 23, "87.5")),
                "lamp:23:1: warning[LDT0408]: absolute photometry, but the light output ratio is 87.5");
    expect_says(read(with(lamp(), 27, "0")), "lamp:27:1: warning[LDT0210]: a set without lamps");
    expect_error(read(with(lamp(), 26, "0")), "lamp:26:1: error[LDT0201]: 0 is not a number of lamp sets");
    expect_error(read(with(lamp(), 26, "2147483647")),
                 "lamp:33:1: error[LDT0201]: 0.1 is not a number of lamps"); // no memory for what is only announced
}

TEST(LdtRead, Numbers) {
    const Result<Profile> comma = read(with(lamp(), 51, " 70,25"));
    expect_says(comma, "lamp:51:2: warning[LDT0105]: '70,25' has a decimal comma");
    EXPECT_EQ(std::get<LdtFile>(comma->file).candela_per_klm[1], 70.25);
    EXPECT_EQ(file_of(with(lamp(), 51, "\t+7.0e1  ")).candela_per_klm[1], 70.0);
    EXPECT_EQ(file_of(with(lamp(), 4, "4.0")).plane_count, 4);
    for (const std::string bad : {"70 80", "1,000.5", "7O", "70 cd", "1,2,3"})
        expect_error(read(with(lamp(), 51, bad)),
                     "lamp:51:1: error[LDT0102]: expected the intensity, found '" + bad + "'");
    for (const std::string bad : {"nan", "1e31"})
        expect_error(read(with(lamp(), 51, bad)),
                     "lamp:51:1: error[LDT0103]: '" + bad + "' is not a finite number up to 1e30");
    // Messages quote nothing from a text that is not EULUMDAT.
    for (const std::size_t line : {2U, 3U, 4U})
        EXPECT_EQ(said(read(with(lamp(), line, "hunter2"))).find("hunter2"), std::string::npos) << line;
    expect_error(read(with(lamp(), 2, "hunter2")), "lamp:2:1: error[LDT0102]: expected the type of luminaire, "
                                                   "found a text that is not a number");
    expect_error(read(with(lamp(), 4, "4.5")), "lamp:4:1: error[LDT0201]: 4.5 is not a number of C-planes");
    expect_error(read(with(lamp(), 6, "0")), "lamp:6:1: error[LDT0201]: 0 is not a number of gamma angles");
}

TEST(LdtRead, ABlankNumberIsZeroUnlessTheFileEnds) {
    const Result<Profile> blank = read(with(lamp(), 35, ""));
    expect_says(blank, "lamp:35:1: warning[LDT0104]: a blank line instead of the direct ratio, read as 0");
    EXPECT_EQ(std::get<LdtFile>(blank->file).direct_ratios[2], 0.0);
    expect_error(read(with(lamp(), 35, "  "), true),
                 "lamp:35:1: error[LDT0104]: a blank line instead of the direct ratio, read as 0");
    expect_error(read(with(lamp(), 48, "")),
                 "lamp:48:1: error[LDT0102]: a blank line where the gamma angle is expected");
    expect_error(read(with(lamp(), 52, "")),
                 "lamp:53:1: error[LDT0206]: 3 intensities announced (3 gamma angles in 1 stored planes), 2 found");
}

TEST(LdtRead, Codes) {
    EXPECT_EQ(file_of(with(lamp(), 2, "0")).type_indicator, 0);
    expect_silent(read(with(lamp(), 2, "0")));
    expect_says(read(with(lamp(), 2, "7")), "lamp:2:1: warning[LDT0203]: type of luminaire 7");
    expect_error(read(with(lamp(), 3, "5")), "lamp:3:1: error[LDT0202]: symmetry 5, expected 0 to 4");
    expect_says(read(with(lamp(), 9, std::string(79, 'x'))),
                "lamp:9:79: warning[LDT0106]: the luminaire's name has 79 characters, but 78 are allowed");
    expect_silent(read(with(lamp(), 9, std::string(78, 'x') + "   ")));
    expect_says(read(with(lamp(), 28, std::string(25, 'x'))),
                "lamp:28:25: warning[LDT0106]: the type of lamps has 25 characters, but 24 are allowed");
    expect_says(read(with(lamp(), 30, std::string(17, 'x'))),
                "lamp:30:17: warning[LDT0106]: the colour temperature has 17 characters, but 16 are allowed");
    expect_says(read(with(lamp(), 31, "1A/>90+")),
                "lamp:31:7: warning[LDT0106]: the colour rendering has 7 characters, but 6 are allowed");
}

TEST(LdtRead, FileNamesMayBeLongerThanDosAllowed) {
    expect_silent(read(with(lamp(), 11, "a-long-file-name.ldt")));
    expect_silent(read(with(lamp(), 11, "eight_ch.ldt"), true));
    expect_says(read(with(lamp(), 11, "nine_char.LDT"), true),
                "lamp:11:9: warning[LDT0107]: the file name has 9 characters, but 8 are allowed");
    EXPECT_EQ(file_of(with(lamp(), 11, " a-long-file-name.ldt ")).file_name, " a-long-file-name.ldt ");
}

TEST(LdtRead, Truncated) {
    TextLines lines = lamp();
    lines.resize(30);
    expect_error(read(lines), "lamp:31:1: error[LDT0101]: the file ends where the colour rendering is expected");
    lines = lamp();
    lines.resize(44);
    expect_error(read(lines), "lamp:45:1: error[LDT0204]: 4 C-planes announced, 2 found");
    lines = lamp();
    lines.resize(48);
    expect_error(read(lines), "lamp:49:1: error[LDT0205]: 3 gamma angles announced, 2 found");
    expect_error(read(with(lamp(), 4, "5")), "lamp:47:1: error[LDT0204]: 5 C-planes announced, 4 found");
    expect_error(read(with(with(lamp(), 6, "4"), 50, "80")),
                 "lamp:50:1: error[LDT0205]: 4 gamma angles announced, 3 found");
    expect_error(read(with(lamp(), 4, "2147483647")),
                 "lamp:47:1: error[LDT0204]: 2147483647 C-planes announced, 4 found");
}

TEST(LdtRead, Angles) {
    expect_error(read(with(lamp(), 45, "80")), "lamp:45:1: error[LDT0301]: C-plane 80 follows 90");
    expect_error(read(with(lamp(), 46, "361")), "lamp:46:1: error[LDT0307]: C-plane 361 is outside 0 to 360");
    expect_error(read(with(with(lamp(), 48, "50"), 49, "45")), "lamp:49:1: error[LDT0302]: gamma angle 45 follows 50");
    expect_error(read(with(lamp(), 48, "200")), "lamp:48:1: error[LDT0307]: gamma angle 200 is outside 0 to 180");
    expect_says(read(with(lamp(), 46, "180")), "lamp:46:1: warning[LDT0303]: C-plane 180 is listed twice");
    expect_says(read(with(lamp(), 48, "90")), "lamp:49:1: warning[LDT0304]: gamma angle 90 is listed twice");
    expect_says(read(with(lamp(), 49, "80")),
                "lamp:49:1: warning[LDT0308]: gamma angles from 0 to 80: there is no light outside them");
    expect_says(read(with(lamp(), 5, "15")),
                "lamp:5:1: warning[LDT0305]: 15 announced between the C-planes, but the angles are 90 apart");
    expect_says(
        read(with(lamp(), 48, "40")),
        "lamp:7:1: warning[LDT0306]: 45 announced between the gamma angles, but the angles are not equidistant");
    expect_silent(read(with(with(lamp(), 48, "40"), 7, "0")));
}

TEST(LdtRead, BehindTheTable) {
    TextLines lines = lamp();
    lines.insert(lines.end(), {"", "  "});
    expect_silent(read(lines));
    lines.emplace_back(" end");
    expect_says(read(lines), "lamp:55:2: warning[LDT0207]: 'end' follows the 3 intensities announced");
}

TEST(LdtRead, AllPlanesWrittenOutAreReadAsTheyStand) {
    TextLines lines = lamp(0);
    lines[2] = "2";
    const Result<Profile> full = read(lines);
    expect_says(full, "lamp:59:1: warning[LDT0208]: symmetry 2 announced, but the table holds all 4 planes");
    EXPECT_EQ(std::get<LdtFile>(full->file).symmetry, 0);
    EXPECT_EQ(std::get<LdtFile>(full->file).candela_per_klm, file_of(lamp(0)).candela_per_klm);
    EXPECT_FALSE(read(lines, true));
}

TEST(LdtRead, StoredPlanesCountedAloneAreCompleted) {
    TextLines lines = lamp(0); // four planes from 0 to 180
    lines[2] = "2";
    lines[4] = "60";
    lines[43] = "60";
    lines[44] = "120";
    lines[45] = "180";
    LdtFile file = file_of(lines);
    EXPECT_EQ(file.symmetry, 2);
    EXPECT_EQ(file.planes_deg, (std::vector<double>{0, 60, 120, 180, 240, 300}));
    EXPECT_EQ(file.candela_per_klm.size(), 12U);
    lines[2] = "4";
    lines[4] = "30";
    lines[43] = "30";
    lines[44] = "60";
    lines[45] = "90";
    file = file_of(lines);
    EXPECT_EQ(file.symmetry, 4);
    EXPECT_EQ(file.plane_count, 12);
    EXPECT_EQ(file.planes_deg, (std::vector<double>{0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330}));
    EXPECT_EQ(file.candela_per_klm.size(), 12U);
}

TEST(LdtRead, TheTable) {
    expect_says(read(with(lamp(), 51, "-1")), "lamp:51:1: warning[LDT0401]: a negative intensity");
    TextLines dark = lamp();
    for (std::size_t i = 49; i < 52; ++i)
        dark[i] = "0";
    expect_says(read(dark), "lamp:50:1: warning[LDT0402]: every intensity is zero");
    expect_says(read(with(lamp(2), 53, "97")),
                "lamp:50:1: warning[LDT0403]: the planes differ by 3 % of the peak at nadir");
    TextLines ratios = lamp();
    for (std::size_t i = 32; i < 42; ++i)
        ratios[i] = "0.000";
    expect_says(read(ratios), "lamp:33:1: note[LDT0404]: the ten direct ratios are zero");
    expect_says(read(with(lamp(), 23, "0")), "lamp:23:1: warning[LDT0405]: the light output ratio is zero");
    expect_says(read(with(lamp(), 24, "1.5")), "lamp:24:1: note[LDT0406]: the conversion factor is 1.5");
    expect_says(read(with(lamp(), 25, "15")), "lamp:25:1: note[LDT0407]: measured with a tilt of 15");
    TextLines three = lamp(2);
    three[3] = "3";
    three.erase(three.begin() + 45);
    three.resize(three.size() - 3);
    expect_says(read(three), "lamp:4:1: warning[LDT0209]: 3 C-planes with symmetry 2");
}

} // namespace
