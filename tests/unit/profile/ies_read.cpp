// Every rule of the LM-63 reader with the smallest file that triggers it.
#include <gonio/profile/luminous_opening.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/profile/write.hpp>

#include "equal.hpp"
#include "expect.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace {

using namespace gonio;
using namespace gonio::test;

const TextLines lamp = {"IESNA:LM-63-2002",
                        "[TEST] 1",
                        "[TESTLAB] bench",
                        "[ISSUEDATE] 2024-01-01",
                        "[MANUFAC] none",
                        "TILT=NONE",
                        "1 1000 1 3 2 1 2 0.1 0.2 0",
                        "1 1 10",
                        "0 45 90",
                        "0 90",
                        "100 80.5 0",
                        "100 70 0"};

Result<Profile> read(const std::string& text, bool strict = false) {
    return read_profile(text, "lamp", {ProfileFormat::ies, strict});
}
Result<Profile> read(const TextLines& lines, bool strict = false) {
    return read(joined(lines), strict);
}
IesFile file_of(const TextLines& lines) {
    Result<Profile> profile = read(lines);
    EXPECT_TRUE(profile) << said(profile);
    return profile ? std::get<IesFile>(profile->file) : IesFile{};
}

TEST(IesRead, ReadsEveryField) {
    const Result<Profile> profile = read(with(with(lamp, 7, "2 -1 1.5 3 2 1 1 -0.1 -0.2 +0.3"), 8, "0.9 1 35.25"));
    expect_silent(profile);
    const IesFile& file = std::get<IesFile>(profile->file);
    EXPECT_EQ(profile->source, "lamp");
    EXPECT_EQ(file.version, IesVersion::lm63_2002);
    EXPECT_EQ(file.version_line, "IESNA:LM-63-2002");
    ASSERT_EQ(file.keywords.size(), 4U);
    EXPECT_EQ(file.keywords[1].name, "TESTLAB");
    EXPECT_EQ(file.keywords[1].text, "bench");
    EXPECT_EQ(file.tilt_keyword, "NONE");
    EXPECT_EQ(file.lamp_count, 2);
    EXPECT_EQ(file.lumens_per_lamp, -1.0);
    EXPECT_EQ(file.candela_multiplier, 1.5);
    EXPECT_EQ(file.photometry, Photometry::c);
    EXPECT_TRUE(file.feet);
    EXPECT_EQ(file.width, -0.1);
    EXPECT_EQ(file.length, -0.2);
    EXPECT_EQ(file.height, 0.3);
    EXPECT_EQ(file.ballast_factor, 0.9);
    EXPECT_EQ(file.field_12, 1.0);
    EXPECT_EQ(file.input_watts, 35.25);
    EXPECT_EQ(file.vertical_deg, (std::vector<double>{0, 45, 90}));
    EXPECT_EQ(file.horizontal_deg, (std::vector<double>{0, 90}));
    EXPECT_EQ(file.candela, (std::vector<double>{100, 80.5, 0, 100, 70, 0}));
}

TEST(IesRead, StrictIsSilentAboutAFileAsTheStandardAsks) {
    expect_silent(read(joined(lamp, "\r\n"), true));
}

TEST(IesRead, AnyLineEndGivesTheSameFileAndTheSamePlaces) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const Result<Profile> profile = read(joined(lamp, end));
        ASSERT_TRUE(profile) << said(profile);
        EXPECT_EQ(std::get<IesFile>(profile->file).candela.size(), 6U);
        EXPECT_EQ(std::get<IesFile>(profile->file).keywords[0].text, "1");
        expect_error(read(joined(with(lamp, 11, "100 8x 0"), end)),
                     "lamp:11:5: error[IES0201]: expected a number, found '8x'");
    }
    // All three line ends in one file, and the last line without any.
    std::string mixed = lamp[0] + "\r" + lamp[1] + "\r\n" + lamp[2] + "\n" + lamp[3] + "\r" + lamp[4] + "\n";
    for (std::size_t i = 5; i < lamp.size(); ++i)
        mixed += lamp[i] + (i + 1 < lamp.size() ? "\r" : "");
    expect_silent(read(mixed));
}

struct VersionCase {
    const char* line;
    IesVersion version;
    const char* code; // empty: no diagnostic
};

class IesVersions : public testing::TestWithParam<VersionCase> {};

TEST_P(IesVersions, AreRecognised) {
    const VersionCase& c = GetParam();
    const Result<Profile> profile = read(with(lamp, 1, c.line));
    ASSERT_TRUE(profile) << said(profile);
    const IesFile& file = std::get<IesFile>(profile->file);
    EXPECT_EQ(file.version, c.version);
    EXPECT_EQ(file.version_line, c.line);
    if (*c.code == '\0') {
        EXPECT_TRUE(profile->diagnostics.empty()) << said(profile);
    } else {
        ASSERT_EQ(profile->diagnostics.size(), 1U) << said(profile);
        EXPECT_EQ(profile->diagnostics[0].code, c.code);
        EXPECT_EQ(profile->diagnostics[0].location.line, 1U);
        EXPECT_EQ(profile->diagnostics[0].location.column, 1U);
    }
}

INSTANTIATE_TEST_SUITE_P(Lines, IesVersions,
                         testing::Values(VersionCase{"IESNA91", IesVersion::lm63_1991, ""},
                                         VersionCase{"IESNA:LM-63-1995", IesVersion::lm63_1995, ""},
                                         VersionCase{"IESNA:LM-63-2002", IesVersion::lm63_2002, ""},
                                         VersionCase{"IES:LM-63-2019", IesVersion::lm63_2019, ""},
                                         VersionCase{"IESNA86", IesVersion::lm63_1986, "IES0101"},
                                         VersionCase{"IESNA95", IesVersion::lm63_1995, "IES0101"},
                                         VersionCase{"IESNA94", IesVersion::lm63_1995, "IES0101"},
                                         VersionCase{"IESNA: LM-63-1995", IesVersion::lm63_1995, "IES0101"},
                                         VersionCase{" IESNA:LM-63-1995", IesVersion::lm63_1995, "IES0101"},
                                         VersionCase{"IESNA:LM-63-2002  ", IesVersion::lm63_2002, "IES0101"},
                                         VersionCase{"IESNA:LM-63-2019", IesVersion::lm63_2019, "IES0101"},
                                         VersionCase{"iesna:lm-63-2002", IesVersion::lm63_2002, "IES0101"},
                                         VersionCase{"IESNA:", IesVersion::lm63_2002, "IES0102"},
                                         VersionCase{"IESNA:LM-63-2035", IesVersion::lm63_2002, "IES0102"}));

TEST(IesRead, NoVersionLineIs1986AndKeepsLabels) {
    const Result<Profile> profile = read(without(with(lamp, 2, "  Some Lamp Works"), 1));
    expect_says(profile, "lamp:1:1: warning[IES0103]: no version line, read as LM-63-1986");
    EXPECT_EQ(profile->diagnostics.size(), 1U) << said(profile);
    const IesFile& file = std::get<IesFile>(profile->file);
    EXPECT_EQ(file.version, IesVersion::lm63_1986);
    EXPECT_EQ(file.version_line, "");
    EXPECT_EQ(file.keywords[0].name, "");
    EXPECT_EQ(file.keywords[0].text, "Some Lamp Works");
}

TEST(IesRead, BlankLinesBeforeTheVersionLineAreOdd) {
    TextLines lines = lamp;
    lines.insert(lines.begin(), "");
    expect_says(read(lines), "lamp:2:1: warning[IES0101]: unusual version line, read as LM-63-2002");
}

TEST(IesRead, KeywordsKeepOrderRepeatsAndMore) {
    TextLines lines = lamp;
    lines.insert(lines.begin() + 5, {"[OTHER]   one", "[MORE] two", "[more]", "[OTHER] three\xE9", "[_own]x"});
    const IesFile file = file_of(lines);
    ASSERT_EQ(file.keywords.size(), 7U);
    EXPECT_EQ(file.keywords[4].name, "OTHER");
    EXPECT_EQ(file.keywords[4].text, "one\ntwo\n");
    EXPECT_EQ(file.keywords[5].name, "OTHER");
    EXPECT_EQ(file.keywords[5].text, "three\xE9");
    EXPECT_EQ(file.keywords[6].name, "_own");
    EXPECT_EQ(file.keywords[6].text, "x");
}

TEST(IesRead, OddLinesBeforeTilt) {
    TextLines lines = lamp;
    lines.insert(lines.begin() + 3, {"  a label", "[TEST no end"});
    expect_says(read(lines),
                "lamp:4:3: warning[IES0104]: a line before TILT= that does not begin with a [KEYWORD] (and 1 more)");
    lines = lamp;
    lines.insert(lines.begin() + 1, " [MORE] of nothing");
    expect_says(read(lines), "lamp:2:2: warning[IES0105]: [MORE] comes before any keyword");
    expect_says(read(without(without(lamp, 5), 3)),
                "lamp:1:1: warning[IES0106]: required by LM-63-2002: [TESTLAB], [MANUFAC]");
}

TEST(IesRead, TiltLine) {
    expect_says(read(with(lamp, 6, "TILT= NONE")), "lamp:6:1: warning[IES0109]: blanks before, within or after TILT=");
    expect_says(read(with(lamp, 6, " TILT=NONE")), "lamp:6:1: warning[IES0109]: blanks before, within or after TILT=");
    expect_says(read(with(lamp, 6, "tilt=none")), "lamp:6:1: warning[IES0110]: the TILT line is not in capitals");
    expect_error(read(with(lamp, 6, "tilt=none"), true), "lamp:6:1: error[IES0110]: the TILT line is not in capitals");
    expect_error(read(with(lamp, 6, "TILT=")), "lamp:6:6: error[IES0108]: nothing follows TILT=");
    expect_error(read(without(lamp, 6)),
                 "lamp:12:1: error[IES0108]: the text ends without a line TILT=NONE or TILT=INCLUDE");
}

TEST(IesRead, NumbersAreSeparatedByBlanksTabsCommasAndLines) {
    TextLines lines = with(lamp, 7, "1, 1000,1\t3");
    lines.insert(lines.begin() + 7, "2 1 2 0.1 0.2 0 1 1 10 ");
    lines.erase(lines.begin() + 8);
    expect_silent(read(lines));
    EXPECT_EQ(file_of(lines).candela, file_of(lamp).candela);
    // A decimal comma is never accepted: "80,5" is two numbers, so one is left over.
    expect_says(read(with(lamp, 11, "100 80,5 0")),
                "lamp:12:8: warning[IES0214]: '0' follows the 6 candela values announced");
}

TEST(IesRead, Numbers) {
    EXPECT_EQ(file_of(with(lamp, 11, "+100 .5 5.")).candela, (std::vector<double>{100, 0.5, 5, 100, 70, 0}));
    EXPECT_EQ(file_of(with(lamp, 11, "0.1 123456789012345678 0.30000000000000000001")).candela,
              (std::vector<double>{0.1, 123456789012345678.0, 0.3, 100, 70, 0}));
    EXPECT_EQ(file_of(with(lamp, 11, "1.5E+02 1e-400 4.9406564584124654e-324")).candela,
              (std::vector<double>{150, 0, std::numeric_limits<double>::denorm_min(), 100, 70, 0}));
    for (const std::string bad : {"8;", "0x10", "--1", "+-1", "1.2.3", "1e", ".", "-", "1d5", "#"})
        expect_error(read(with(lamp, 11, "100 " + bad + " 0")),
                     "lamp:11:5: error[IES0201]: expected a number, found '" + bad + "'");
    EXPECT_EQ(file_of(with(lamp, 11, "1e30 -1e30 0")).candela, (std::vector<double>{1e30, -1e30, 0, 100, 70, 0}));
    for (const std::string bad :
         {"inf", "-NaN", "1e999", "-1E+400", "1.0000001e30", "-1e31", "1000000000000000000000000000000.5e1"})
        expect_error(read(with(lamp, 11, "100 " + bad + " 0")),
                     "lamp:11:5: error[IES0202]: '" + bad + "' is not a finite number up to 1e30");
    // Fortran joins columns that are too wide; it also writes 1.5-300 for 1.5e-300: the reader does not guess.
    const Result<Profile> glued = read(with(lamp, 11, "100 1.5-3 0"));
    expect_error(glued, "lamp:11:5: error[IES0201]: expected a number, found '1.5-3'");
    EXPECT_EQ(glued.error().diagnostics.back().hint, "if these are two numbers, put a blank between them");
    expect_error(read(with(lamp, 11, "100 8\x01 0")), "lamp:11:5: error[IES0201]: expected a number, found '8\\x01'");
}

// Writing drops blank lines before it and moves it, so the position of a stray byte must not matter.
TEST(IesRead, AControlByteInARemarkIsKeptWhereverItStands) {
    std::vector<std::string> texts;
    for (const std::size_t before : {0U, 4000U, 4090U, 5000U})
        texts.push_back(joined(with(lamp, 2, "[OTHER] " + std::string(before, 'x') + "\r\n[MORE] a\x02z")));
    texts.push_back("\t\t\r\na\x02z\r\n" + joined(lamp)); // an LM-63-1986 file with a blank first line
    texts.push_back("a\x02z\r\n" + joined(lamp));
    for (const std::string& text : texts) {
        const Result<Profile> read_once = read(text);
        ASSERT_TRUE(read_once) << text;
        const std::string written = write_ies(std::get<IesFile>(read_once->file));
        EXPECT_NE(written.find("a\x02z"), std::string::npos);
        const Result<Profile> read_twice = read(written);
        ASSERT_TRUE(read_twice) << text;
        EXPECT_TRUE(test::equal(read_once->file, read_twice->file));
    }
}

TEST(IesRead, StrictSaysWhatTheTolerantReadingTakesSilently) {
    expect_silent(read(with(lamp, 11, "1.0E+02 80 0")));
    expect_says(read(with(lamp, 11, "1.0E+02 80 0"), true), "lamp:11:1: warning[IES0216]: a number with an exponent");
    expect_silent(read(with(lamp, 7, "1 1000 1 3.0 2 1 2 0.1 0.2 0")));
    expect_says(read(with(lamp, 7, "1 1000 1 3.0 2 1 2 0.1 0.2 0"), true),
                "lamp:7:10: warning[IES0217]: '3.0' instead of a whole number");
    // The edition of 1986 allows decimal points in counts.
    const Result<Profile> old_count = read(without(with(lamp, 7, "1 1000 1 3.0 2 1 2 0.1 0.2 0"), 1), true);
    ASSERT_TRUE(old_count) << said(old_count);
    EXPECT_EQ(old_count->diagnostics.size(), 1U) << said(old_count); // no version line
    expect_silent(read(with(lamp, 2, "[TEST] 1\n[LAMPE] x")));
    expect_says(read(with(lamp, 2, "[TEST] 1\n[LAMPE] x"), true),
                "lamp:1:1: warning[IES0115]: not defined in LM-63-2002: '[LAMPE]'");
    expect_silent(read(with(lamp, 2, "[TEST] 1\n[_LAMPE] x"), true));
    const std::string wide = "[TEST] " + std::string(248, 'x');
    expect_silent(read(with(lamp, 2, wide)));
    expect_says(read(with(lamp, 2, wide), true),
                "lamp:2:255: warning[IES0107]: a line of 257 characters; LM-63-2002 allows 256");
    const TextLines old = with(with(lamp, 1, "IESNA:LM-63-1995"), 2, "[TEST] " + std::string(124, 'x'));
    expect_says(read(old, true), "lamp:2:131: warning[IES0107]: a line of 133 characters; LM-63-1995 allows 132");
    expect_silent(read(with(with(lamp, 1, "IES:LM-63-2019"), 2, wide), true));
}

TEST(IesRead, CountsThatAreNone) {
    for (const std::string bad : {"0", "-3", "2.5", "1e10"})
        EXPECT_FALSE(read(with(lamp, 7, "1 1000 1 " + bad + " 2 1 2 0.1 0.2 0"))) << bad;
    expect_error(read(with(lamp, 7, "1 1000 1 2.5 2 1 2 0.1 0.2 0")),
                 "lamp:7:10: error[IES0203]: 2.5 is not a number of vertical angles");
    expect_error(read(with(lamp, 7, "1 1000 1 3 0 1 2 0.1 0.2 0")),
                 "lamp:7:12: error[IES0203]: 0 is not a number of horizontal angles");
    expect_error(read(with(lamp, 7, "1.5 1000 1 3 2 1 2 0.1 0.2 0")),
                 "lamp:7:1: error[IES0203]: 1.5 is not a number of lamps");
    expect_error(read(with(lamp, 7, "1 1000 1 3 2 4 2 0.1 0.2 0")),
                 "lamp:7:14: error[IES0208]: photometric type 4, expected 1, 2 or 3");
    expect_error(read(with(lamp, 7, "1 1000 1 3 2 1 3 0.1 0.2 0")),
                 "lamp:7:16: error[IES0209]: unit 3, expected 1 (feet) or 2 (metres)");
    EXPECT_EQ(file_of(with(lamp, 7, "1 1000 1 3.0 2.0 1.0 2.0 0.1 0.2 0")).candela.size(), 6U);
}

TEST(IesRead, TooFewAngles) {
    TextLines lines = lamp;
    lines[6] = "1 1000 1 4 2 1 2 0.1 0.2 0";
    expect_error(read(lines), "lamp:10:1: error[IES0204]: 4 vertical angles announced, 3 found");
    lines[6] = "1 1000 1 3 3 1 2 0.1 0.2 0";
    lines[10] = "10 8 0";
    expect_error(read(lines), "lamp:11:1: error[IES0205]: 3 horizontal angles announced, 2 found");
    lines.resize(8);
    expect_error(read(lines), "lamp:9:1: error[IES0204]: 3 vertical angles announced, 0 found");
    lines.emplace_back("0 45");
    expect_error(read(lines), "lamp:10:1: error[IES0204]: 3 vertical angles announced, 2 found");
    lines.back() = "0 45 90";
    lines.emplace_back("0");
    expect_error(read(lines), "lamp:11:1: error[IES0205]: 3 horizontal angles announced, 1 found");
    lines.resize(6);
    lines.emplace_back("1 1000 1 3");
    expect_error(read(lines), "lamp:8:1: error[IES0207]: 13 numbers must follow TILT=NONE, but 4 are found");
    // The TILT table is whole: what is missing is named, and the table is not blamed.
    lines.resize(5);
    lines.insert(lines.end(), {"TILT=INCLUDE", "1", "2", "0 90", "1 0.9", "1"});
    expect_error(read(lines), "lamp:12:1: error[IES0207]: 13 numbers must follow the TILT table, but 1 is found");
    EXPECT_EQ(read(lines).error().diagnostics.back().hint, "the file is cut off; next would be the lumens per lamp");
}

// Three angles are read as ballast factor, field 12 and watts: the counts are right, and no angle is to be changed.
TEST(IesRead, TheLineWithTheWattsIsMissing) {
    TextLines lines = with(lamp, 7, "1 1000 1 5 1 1 2 0.1 0.2 0");
    lines.resize(7);
    lines.insert(lines.end(), {"0 22.5 45 67.5 90", "0", "100 90 80 70 0"});
    expect_error(read(lines), "lamp:8:1: error[IES0220]: the line with ballast factor, field 12 and input watts is "
                              "missing: 0, 22.5 and 45 are vertical angles");
    lines.insert(lines.begin() + 7, "1 1 10");
    EXPECT_EQ(file_of(lines).vertical_deg.size(), 5U);
}

// What an edition requires is not asked of a file that does not name one.
TEST(IesRead, NothingIsRequiredByAnAssumedVersion) {
    TextLines lines = lamp;
    lines[0] = "IESNA:";
    lines[4] = "[OTHER] x";
    const Result<Profile> profile = read(lines);
    ASSERT_TRUE(profile);
    for (const Diagnostic& diagnostic : profile->diagnostics)
        EXPECT_NE(diagnostic.code, "IES0106");
}

// The message that the command line's documentation quotes.
TEST(IesRead, ThirtySevenAnnouncedThirtySixFound) {
    TextLines lines = with(lamp, 7, "1 1000 1 37 1 1 2 0.1 0.2 0");
    std::string angles;
    for (int i = 0; i < 36; ++i)
        angles += std::to_string(i * 5) + " ";
    lines.resize(8);
    lines.push_back(angles);
    lines.emplace_back("0");
    expect_error(read(lines), "lamp:10:1: error[IES0204]: 37 vertical angles announced, 36 found");
}

TEST(IesRead, TooManyAngles) {
    expect_error(read(with(lamp, 7, "1 1000 1 2 2 1 2 0.1 0.2 0")),
                 "lamp:9:6: error[IES0311]: 2 vertical angles announced, but the list continues with 90");
    TextLines single = without(with(lamp, 10, "0"), 12);
    single[6] = "1 1000 1 2 1 1 2 0.1 0.2 0"; // would read 90 as the plane and 0, 100 as its candela
    expect_error(read(single), "lamp:9:6: error[IES0311]: 2 vertical angles announced, but the list continues with 90");
}

TEST(IesRead, DiagnosticsStandInTheOrderOfTheFile) {
    const Result<Profile> profile = read(with(with(with(lamp, 11, "100 -1 0"), 9, "0 45 80"), 6, "TILT= NONE"));
    ASSERT_TRUE(profile) << said(profile);
    ASSERT_EQ(profile->diagnostics.size(), 3U) << said(profile);
    EXPECT_EQ(profile->diagnostics[0].code, "IES0109");
    EXPECT_EQ(profile->diagnostics[1].code, "IES0305");
    EXPECT_EQ(profile->diagnostics[2].code, "IES0401");
}

TEST(IesRead, TooFewCandela) {
    const std::string text = joined(lamp);
    // Without the end of the last line: the end of the text is after its last byte.
    expect_error(
        read(text.substr(0, text.size() - 3)),
        "lamp:12:7: error[IES0206]: 6 candela values announced (3 vertical times 2 horizontal angles), 5 found");
    expect_error(
        read(without(lamp, 12)),
        "lamp:12:1: error[IES0206]: 6 candela values announced (3 vertical times 2 horizontal angles), 3 found");
}

TEST(IesRead, HugeCountsAreNeverAllocated) {
    expect_error(read(with(lamp, 7, "1 1000 1 2147483647 2 1 2 0.1 0.2 0")),
                 "lamp:10:1: error[IES0204]: 2147483647 vertical angles announced, 3 found");
    expect_error(read(with(lamp, 7, "1 1000 1 2147483648 2 1 2 0.1 0.2 0")),
                 "lamp:7:10: error[IES0203]: 2147483648 is not a number of vertical angles");
    expect_error(read(with(lamp, 7, "1 1000 1 3 2147483647 1 2 0.1 0.2 0")),
                 "lamp:11:5: error[IES0302]: horizontal angle 80.5 follows 100");
    TextLines lines = with(lamp, 6, "TILT=INCLUDE");
    lines.insert(lines.begin() + 6, {"1", "2147483647", "0 90"});
    expect_error(read(lines), "lamp:10:1: error[IES0114]: tilt angle 1 follows 90");
}

TEST(IesRead, Angles) {
    expect_error(read(with(lamp, 9, "0 90 45")), "lamp:9:6: error[IES0301]: vertical angle 45 follows 90");
    expect_error(read(with(lamp, 10, "90 0")), "lamp:10:4: error[IES0302]: horizontal angle 0 follows 90");
    expect_says(read(with(lamp, 9, "0 90 90")), "lamp:9:6: warning[IES0303]: angle 90 is listed twice");
    expect_says(read(with(lamp, 10, "0 0")), "lamp:10:3: warning[IES0304]: angle 0 is listed twice");
    expect_says(read(with(lamp, 9, "0 45 80")),
                "lamp:9:6: warning[IES0305]: vertical angles from 0 to 80: there is no light outside them");
    expect_says(read(with(lamp, 9, "10 45 90")),
                "lamp:9:1: warning[IES0305]: vertical angles from 10 to 90: there is no light outside them");
    expect_error(read(with(lamp, 9, "0 90 181")), "lamp:9:6: error[IES0307]: vertical angle 181 is outside 0 to 180");
    expect_says(read(with(lamp, 10, "0 100")), "lamp:10:3: warning[IES0306]: planes from 0 to 100");
    expect_error(read(with(lamp, 10, "0 400")), "lamp:10:3: error[IES0307]: horizontal angles from 0 to 400");
    expect_says(read(with(lamp, 10, "90 270")),
                "lamp:10:1: warning[IES0310]: planes from 90 to 270 degrees in LM-63-2002");
    expect_silent(read(with(with(lamp, 10, "90 270"), 1, "IESNA:LM-63-1995")));
}

TEST(IesRead, PlanesAroundTheTurn) {
    TextLines single = with(lamp, 7, "1 1000 1 3 1 1 2 0.1 0.2 0");
    single[9] = "205";
    single.pop_back();
    expect_says(read(single), "lamp:10:1: warning[IES0308]: the only plane is at 205");

    TextLines open = with(lamp, 7, "1 1000 1 3 4 1 2 0.1 0.2 0");
    open[9] = "0 90 180 270";
    open.insert(open.end(), {"100 60 0", "100 50 0"});
    expect_says(read(open), "lamp:10:10: warning[IES0309]: the last plane is at 270, and the one at 360 is missing");
    open[9] = "0 90 180 360";
    expect_says(read(open), "lamp:11:1: warning[IES0404]: the planes at 0 and 360 degrees differ by up to 30.5 cd of a "
                            "peak of 100");
    open[9] = "0 60 120 180";
    expect_silent(read(open));
}

TEST(IesRead, TypesAAndB) {
    TextLines lines = with(lamp, 7, "1 1000 1 3 2 2 2 0.1 0.2 0");
    lines[8] = "-90 0 90";
    lines[9] = "0 90";
    expect_silent(read(lines));
    EXPECT_EQ(file_of(lines).photometry, Photometry::b);
    lines[6] = "1 1000 1 3 2 3 2 0.1 0.2 0";
    EXPECT_EQ(file_of(lines).photometry, Photometry::a);
    expect_error(read(with(lines, 9, "-91 0 90")), "lamp:9:1: error[IES0307]: vertical angle -91 is outside -90 to 90");
    expect_says(read(with(lines, 10, "-45 90")), "lamp:10:1: warning[IES0306]: horizontal angles from -45 to 90");
}

TEST(IesRead, HeaderValues) {
    expect_says(read(with(lamp, 7, "1 0 1 3 2 1 2 0.1 0.2 0")),
                "lamp:7:3: warning[IES0210]: 0 lumens per lamp, read as absolute photometry");
    expect_error(read(with(lamp, 7, "1 -2 1 3 2 1 2 0.1 0.2 0"), true),
                 "lamp:7:3: error[IES0210]: -2 lumens per lamp, read as absolute photometry");
    expect_error(read(with(lamp, 7, "1 1000 0 3 2 1 2 0.1 0.2 0")), "lamp:7:8: error[IES0211]: candela multiplier 0");
    expect_says(read(with(lamp, 8, "0 1 10")), "lamp:8:1: warning[IES0212]: ballast factor 0");
    expect_says(read(with(lamp, 8, "1 0.9 10")), "lamp:8:3: warning[IES0213]: field 12 is 0.9 in LM-63-2002");
    expect_silent(read(with(with(lamp, 8, "1 0.9 10"), 1, "IESNA91")));
    expect_silent(read(with(with(lamp, 8, "1 1.10000 10"), 1, "IES:LM-63-2019")));
    expect_says(read(with(with(lamp, 8, "1 1.5 10"), 1, "IES:LM-63-2019")),
                "lamp:8:3: warning[IES0213]: field 12 is 1.5 in LM-63-2019");
    expect_says(read(with(lamp, 7, "0 1000 1 3 2 1 2 0.1 0.2 0")), "lamp:7:1: warning[IES0215]: 0 lamps");
    expect_says(read(with(lamp, 8, "1 1 -10")), "lamp:8:5: warning[IES0218]: -10 input watts");
}

TEST(IesRead, UnknownShapeCodes) {
    const TextLines circle = with(lamp, 7, "1 1000 1 3 2 1 2 -0.1 0 0"); // a circle up to 1995
    expect_silent(read(with(circle, 1, "IESNA91")));
    expect_silent(read(with(circle, 1, "IESNA:LM-63-1995")));
    expect_says(read(circle),
                "lamp:7:18: warning[IES0219]: width -0.1, length 0 and height 0 encode no shape in LM-63-2002");
    expect_error(read(circle, true),
                 "lamp:7:18: error[IES0219]: width -0.1, length 0 and height 0 encode no shape in LM-63-2002");
    const Profile later = read(circle).value();
    EXPECT_EQ(luminous_opening(later).shape, OpeningShape::disk);
    EXPECT_EQ(luminous_opening(later).length_m, luminous_opening(later).width_m);
    const Profile unknown = read(with(lamp, 7, "1 1000 1 3 2 1 2 0.1 -0.2 0")).value();
    EXPECT_EQ(luminous_opening(unknown).shape, OpeningShape::box);
    const TextLines disk = with(lamp, 7, "1 1000 1 3 2 1 2 -0.1 -0.1 0"); // a circle since 2002
    expect_silent(read(disk));
    expect_silent(read(with(disk, 1, "IES:LM-63-2019")));
    EXPECT_FALSE(read(with(disk, 1, "IESNA:LM-63-1995"), true));
}

TEST(IesRead, Field12SaysHowAFileOf2019WasMade) {
    const auto type = [](const std::string& version, const std::string& field) {
        const char* text = file_generation_type(file_of(with(with(lamp, 8, "1 " + field + " 10"), 1, version)));
        return std::string(text != nullptr ? text : "none");
    };
    EXPECT_EQ(type("IES:LM-63-2019", "1.00001"), "undefined, or an older file");
    EXPECT_EQ(type("IES:LM-63-2019", "1.00010"), "computer simulation");
    EXPECT_EQ(type("IES:LM-63-2019", "1"), "test at an unaccredited laboratory");
    EXPECT_EQ(type("IES:LM-63-2019", "1.10000"), "test at an accredited laboratory");
    EXPECT_EQ(type("IES:LM-63-2019", "1.111"),
              "test at an accredited laboratory, angles interpolated and lumens scaled");
    EXPECT_EQ(type("IES:LM-63-2019", "0.9"), "none");
    EXPECT_EQ(type("IESNA:LM-63-2002", "1"), "none");
}

TEST(IesRead, TheTable) {
    expect_says(read(with(lamp, 11, "100 -0.5 0")), "lamp:11:5: warning[IES0401]: a negative candela value");
    expect_says(read(with(with(lamp, 11, "0 0 0"), 12, "0 0 0")),
                "lamp:11:1: warning[IES0402]: every candela value is zero");
    expect_says(read(with(lamp, 12, "90 70 0")),
                "lamp:11:1: warning[IES0403]: the planes differ by 10 % of the peak at nadir");
    expect_silent(read(with(lamp, 12, "99.1 70 0"))); // as goniometers do
    expect_says(read(with(lamp, 12, "100 70 0 END OF FILE")),
                "lamp:12:10: warning[IES0214]: 'END' follows the 6 candela values announced");
}

TEST(IesRead, StrictErrorsAreAllSaidAndTheLastIsTheReason) {
    const Result<Profile> profile = read(with(with(lamp, 6, "tilt=none"), 7, "1 0 1 3 2 1 2 0.1 0.2 0"), true);
    ASSERT_FALSE(profile);
    const Diagnostics& all = profile.error().diagnostics;
    ASSERT_EQ(all.size(), 2U) << said(all);
    EXPECT_EQ(all[0].code, "IES0110");
    EXPECT_EQ(all[1].code, "IES0210");
}

} // namespace
