// Writing: a layout that all loaders read, and nothing lost.
#include <gonio/profile/read.hpp>
#include <gonio/profile/write.hpp>

#include "equal.hpp"
#include "expect.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace gonio;
using namespace gonio::test;

IesFile an_ies_file() {
    IesFile file;
    file.version_line = "IESNA:LM-63-2002";
    file.keywords = {{"TEST", "1"}, {"OTHER", "one\ntwo\n\nfour"}, {"_EMPTY", ""}, {"", "a label"}, {"OTHER", "\xE4 "}};
    file.tilt_keyword = "INCLUDE";
    file.tilt = {2, {0, 45, 90}, {1, 0.95, 0.9}};
    file.lamp_count = 3;
    file.lumens_per_lamp = 1234.5;
    file.candela_multiplier = 0.1;
    file.feet = true;
    file.width = -0.1;
    file.length = -0.1;
    file.ballast_factor = 0.95;
    file.input_watts = 100000.0;
    file.vertical_deg = {0, 1.0 / 3.0, 90};
    file.horizontal_deg = {0, 90};
    file.candela = {1e-12, 100000.0, 1e20, 0.1, 2.0 / 3.0, 12345.678};
    return file;
}

LdtFile an_ldt_file() {
    LdtFile file;
    file.company = " Lamp Works \xE4";
    file.type_indicator = 3;
    file.symmetry = 4;
    file.plane_count = 4;
    file.plane_step_deg = 90;
    file.gamma_count = 3;
    file.gamma_step_deg = 0;
    file.report_number = "r";
    file.luminaire_name = "";
    file.file_name = "f";
    file.length_mm = 0.1;
    file.luminous_height_c270_mm = 4;
    file.lamp_sets = {{-1, "LED", 1000.5, "3000", "1A/>90", 10.25}, {2, "", 1e5, "nw", "", 0}};
    file.direct_ratios = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
    file.planes_deg = {0, 90, 180, 270};
    file.gammas_deg = {0, 1.0 / 3.0, 90};
    file.candela_per_klm = {1, 2, 3, 1, 1e-300, 1e30};
    return file;
}

TEST(ProfileWrite, IesKeepsEveryField) {
    const IesFile file = an_ies_file();
    const Result<Profile> read = read_profile(write_ies(file), "lamp");
    ASSERT_TRUE(read) << said(read);
    EXPECT_TRUE(equal(file, std::get<IesFile>(read->file)));
    // The comparison detects a difference.
    IesFile other = file;
    other.keywords[1].text += "x";
    EXPECT_FALSE(equal(other, std::get<IesFile>(read->file)));
    other = file;
    other.candela[3] = 0.10000000000000002;
    EXPECT_FALSE(equal(other, std::get<IesFile>(read->file)));
}

TEST(ProfileWrite, LdtKeepsEveryField) {
    const LdtFile file = an_ldt_file();
    const Result<Profile> read = read_profile(write_ldt(file), "lamp");
    ASSERT_TRUE(read) << said(read);
    EXPECT_TRUE(equal(file, std::get<LdtFile>(read->file)));
}

TEST(ProfileWrite, IesLayout) {
    IesFile file = an_ies_file();
    file.tilt_keyword = "NONE";
    file.tilt = {};
    EXPECT_EQ(write_ies(file), "IESNA:LM-63-2002\r\n[TEST] 1\r\n[OTHER] one\r\n[MORE] two\r\n[MORE]\r\n[MORE] four\r\n"
                               "[_EMPTY]\r\na label\r\n[OTHER] \xE4 \r\nTILT=NONE\r\n"
                               "3 1234.5 0.1 3 2 1 1 -0.1 -0.1 0\r\n0.95 1 100000\r\n"
                               "0 0.3333333333333333 90\r\n0 90\r\n"
                               "0.000000000001 100000 1e+20\r\n0.1 0.6666666666666666 12345.678\r\n");
}

// Some readers of LM-63 stop before an exponent, and read 4e-05 as 4.
TEST(ProfileWrite, SmallNumbersHaveNoExponentAndReadBackTheSame) {
    std::vector<double> small{1e-4, 9.9e-5, 1e-5, 1e-7, 3.3333333333333333e-6, 4.0114128e-11, 1e-30};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> digits(1.0, 10.0);
    for (int power = 0; power <= 30; ++power)
        small.push_back(digits(random) * std::pow(10.0, -power));
    small.push_back(-small.back()); // the longest

    IesFile ies = an_ies_file();
    ies.vertical_deg.resize(small.size());
    for (std::size_t i = 0; i < small.size(); ++i)
        ies.vertical_deg[i] = static_cast<double>(i);
    ies.horizontal_deg = {0};
    ies.candela = small;
    const std::string ies_text = write_ies(ies);
    EXPECT_EQ(ies_text.find("e-"), std::string::npos) << ies_text;
    const Result<Profile> read = read_profile(ies_text, "lamp");
    ASSERT_TRUE(read) << said(read);
    EXPECT_EQ(std::get<IesFile>(read->file).candela, small);

    LdtFile ldt = an_ldt_file();
    ldt.symmetry = 1;
    ldt.plane_count = 1;
    ldt.planes_deg = {0};
    ldt.gamma_count = static_cast<int>(small.size());
    ldt.gammas_deg = ies.vertical_deg;
    ldt.candela_per_klm = small;
    const std::string ldt_text = write_ldt(ldt);
    EXPECT_EQ(ldt_text.find("e-"), std::string::npos) << ldt_text;
    const Result<Profile> read_ldt = read_profile(ldt_text, "lamp");
    ASSERT_TRUE(read_ldt) << said(read_ldt);
    EXPECT_EQ(std::get<LdtFile>(read_ldt->file).candela_per_klm, small);
}

TEST(ProfileWrite, TheStandardLineWhereTheFileHasNone) {
    IesFile file = an_ies_file();
    file.version_line.clear();
    EXPECT_EQ(write_ies(file).substr(0, 18), "IESNA:LM-63-2002\r\n");
    file.version = IesVersion::lm63_2019;
    EXPECT_EQ(write_ies(file).substr(0, 16), "IES:LM-63-2019\r\n");
    file.version = IesVersion::lm63_1995;
    EXPECT_EQ(write_ies(file).substr(0, 18), "IESNA:LM-63-1995\r\n");
    file.version = IesVersion::lm63_1991;
    EXPECT_EQ(write_ies(file).substr(0, 9), "IESNA91\r\n");
    file.version = IesVersion::lm63_1986;
    EXPECT_EQ(write_ies(file).substr(0, 8), "[TEST] 1");
}

TEST(ProfileWrite, LongListsAreBrokenWhereTheVersionAsks) {
    IesFile file = an_ies_file();
    file.tilt_keyword = "NONE";
    file.tilt = {};
    file.vertical_deg.clear();
    for (int i = 0; i <= 180; ++i)
        file.vertical_deg.push_back(i);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> candela(0.0, 1e4);
    file.candela.clear();
    for (int i = 0; i < 362; ++i)
        file.candela.push_back(candela(random));
    for (const auto& [version, line, longest] : {std::tuple{IesVersion::lm63_1995, "IESNA:LM-63-1995", 132U},
                                                 {IesVersion::lm63_2002, "IESNA:LM-63-2002", 256U}}) {
        file.version = version;
        file.version_line = line;
        const std::string text = write_ies(file);
        std::size_t longest_found = 0;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = text.find("\r\n", begin) + 2;
            longest_found = std::max(longest_found, end - begin);
            begin = end;
        }
        EXPECT_LE(longest_found, longest);
        EXPECT_GT(longest_found, longest - 24);
        const Result<Profile> read = read_profile(text, "lamp");
        ASSERT_TRUE(read) << said(read);
        EXPECT_TRUE(equal(file, std::get<IesFile>(read->file)));
    }
}

// A label that starts like another kind of file, or with the bytes of a byte order mark, is not written as one.
TEST(ProfileWrite, ALabelIsNoOtherFile) {
    for (const char* const label : {"\xEF\xBB\xBFlabel", "PK\x03\x04 label", "GIF8 lamps", "%PDF-lamps"}) {
        const std::string text = fmt::format(" {}\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n100 0\n", label);
        const Result<Profile> read = read_profile(text, "lamp");
        ASSERT_TRUE(read) << said(read);
        const Result<Profile> again = read_profile(write_ies(std::get<IesFile>(read->file)), "lamp");
        ASSERT_TRUE(again) << said(again);
        EXPECT_TRUE(equal(read->file, again->file));
    }
}

TEST(ProfileWrite, ACompanyIsNoOtherFile) {
    LdtFile file = an_ldt_file();
    file.company = "GIF8 lamps";
    const Result<Profile> read = read_profile(write_ldt(file), "lamp");
    ASSERT_TRUE(read) << said(read);
    EXPECT_EQ(std::get<LdtFile>(read->file).company, " GIF8 lamps");
}

} // namespace
