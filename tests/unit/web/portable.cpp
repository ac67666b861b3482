// The portable dialect, claim by claim.
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/portable_text.hpp>
#include <gonio/web/to_profile.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace gonio;
using namespace gonio::test;

bool says(const Diagnostics& diagnostics, std::string_view code) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [&](const Diagnostic& diagnostic) { return diagnostic.code == code; });
}

// Every character that has an ASCII spelling, in both encodings that files use; one without a spelling becomes a
// question mark.
TEST(Portable, SpellsWhatAsciiLacks) {
    const auto ascii = [](std::string text) {
        EXPECT_TRUE(web_detail::make_ascii(text));
        return text;
    };
    EXPECT_EQ(ascii("\u00C6\u00E6\u00DF \u00C0\u00C9\u00D1\u00D8\u00FC\u00FF"), "AEaess AENOuy");
    EXPECT_EQ(ascii("a\u00A0b \u00A9\u00AE 5\u00B0 \u00B10.1 m\u00B2 m\u00B3 \u00B5\u03BCm"),
              "a b (C)(R) 5deg +-0.1 m2 m3 uum");
    EXPECT_EQ(ascii("\u0152\u0153 \u03A9 1\u20132\u20143\u22124"), "OEoe Ohm 1-2-3-4");
    EXPECT_EQ(ascii("\u2018a\u2019 \u201Cb\u201D \u201Ec \u2026 \u20AC \u2122 \u4E2D\U0001F4A1"),
              "'a' \"b\" \"c ... EUR (TM) ??");
    EXPECT_EQ(ascii("\x80 \x84\x93\x94 \x85 \x8C\x9C \x91\x92 \x96\x97 \x99 \xB0 \xFC \x81"),
              "EUR \"\"\" ... OEoe '' -- (TM) deg u ?");
    // Truncated, overlong, a lead surrogate: not UTF-8, so read as code page 1252.
    EXPECT_EQ(ascii("\xC3"), "A");
    EXPECT_EQ(ascii("\xC0\xAF"), "A?");
    std::string plain = "plain\ttext";
    EXPECT_FALSE(web_detail::make_ascii(plain));
    EXPECT_EQ(plain, "plain text");
}

// The requirements from the survey of loaders, claim by claim.
TEST(Portable, IsWhatEveryLoaderReads) {
    ProfileHeader header;
    header.keywords = {{"MANUFAC", "Gl\xFChlampen\tGmbH"},
                       {"LUMINAIRE", ""},
                       {"OTHER", std::string(300, 'x') + " " + std::string(100, 'y')}};
    header.keywords[1].text = "Gr\xC3\xB6\xC3\x9F"
                              "e 10 \xC2\xB5m";
    header.lamp_count = 4;
    Web web = random_web(Symmetry::quadrant, steps(0, 90, 10), steps(0, 180, 181), 6).scaled(1.0 / 3.0);
    const Result<MadeProfile> made = to_profile(web, header, ProfileTarget::portable);
    const std::string text = write_profile(made->profile, ProfileTarget::portable);
    EXPECT_EQ(text.substr(0, 18), "IESNA:LM-63-2002\r\n");
    EXPECT_NE(text.find("\r\nTILT=NONE\r\n"), std::string::npos);
    EXPECT_EQ(text.substr(text.size() - 2), "\r\n");
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find("\r\n", begin);
        ASSERT_NE(end, std::string::npos);
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 2;
    }
    std::size_t tilt = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string& line = lines[i];
        EXPECT_LE(line.size() + 2, 132U) << line;
        EXPECT_FALSE(line.empty());
        EXPECT_NE(line.back(), ' ') << line;
        EXPECT_EQ(line.find("  "), std::string::npos) << line;
        for (const char c : line)
            EXPECT_TRUE(c >= ' ' && c < 127) << line;
        if (line == "TILT=NONE") tilt = i;
        if (tilt == 0 || i == tilt) continue;
        EXPECT_EQ(line.find_first_not_of("0123456789. -"), std::string::npos) << line;
    }
    const auto numbers_in = [](const std::string& line) { return 1 + std::count(line.begin(), line.end(), ' '); };
    EXPECT_EQ(numbers_in(lines[tilt + 1]), 10);
    EXPECT_EQ(numbers_in(lines[tilt + 2]), 3);
    EXPECT_EQ(lines[tilt + 2], "1 1 0");
    const Result<Profile> read = read_profile(text, "portable");
    const IesFile& file = std::get<IesFile>(read->file);
    EXPECT_EQ(file.lamp_count, 1);
    EXPECT_NEAR(file.lumens_per_lamp, flux(web).value, 0.006);
    EXPECT_EQ(file.candela_multiplier, 1.0);
    EXPECT_EQ(file.photometry, Photometry::c);
    EXPECT_FALSE(file.feet);
    EXPECT_EQ(file.horizontal_deg.front(), 0.0);
    EXPECT_EQ(file.horizontal_deg.back(), 360.0);
    EXPECT_EQ(keyword_text(header_of(*read), "MANUFAC"), "Gluhlampen GmbH");
    EXPECT_EQ(keyword_text(header_of(*read), "LUMINAIRE"), "Grosse 10 um");
    EXPECT_TRUE(says(made->diagnostics, "WEB0212"));
    EXPECT_TRUE(says(made->diagnostics, "WEB0213"));
}

} // namespace
