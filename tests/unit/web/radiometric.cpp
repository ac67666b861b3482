// Profiles of radiant intensity: recognised by what they state, and refused where lumens would be made of them.
#include <gonio/light/shape.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/radiometric.hpp>
#include <gonio/web/resolve.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

namespace gonio {
namespace {

std::string text_with(const std::string& keywords) {
    return "IESNA:LM-63-2002\n[TEST] 1\n[TESTLAB] x\n[ISSUEDATE] x\n[MANUFAC] x\n" + keywords +
           "TILT=NONE\n1 -1 1 3 1 1 2 0.1 0.1 0\n1 1 12\n0 45 90\n0\n100 50 0\n";
}

std::string unit_of(const std::string& keywords) {
    return radiometric_unit(*read_profile(text_with(keywords), "lamp.ies"));
}

bool has_code(const Diagnostics& diagnostics, std::string_view code) {
    return std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& d) { return d.code == code; });
}

TEST(Radiometric, IsWhatAKeywordStates) {
    EXPECT_EQ(unit_of(""), "");
    EXPECT_EQ(unit_of("[_INTENSITYUNITS]   mW/sr\n[_RADIATIONTYPE] UVC 222\n"), "mW/sr");
    EXPECT_EQ(unit_of("[_intensityUnits] W/sr\n"), "W/sr");
    EXPECT_EQ(unit_of("[_INTENSITYUNITS] cd\n[_RADIATIONTYPE] UVC 222\n"), "") << "the unit is what counts";
    EXPECT_EQ(unit_of("[_INTENSITYUNITS] Candela\n"), "");
    EXPECT_EQ(unit_of("[_INTENSITYUNITS]\n"), "");
    EXPECT_EQ(unit_of("[_RADIATIONTYPE] UVC 222\n"), "radiometric units");
    EXPECT_EQ(unit_of("[_RADIATIONTYPE] visible\n"), "");
}

TEST(Radiometric, IsReportedUnlessTakenAsCandela) {
    const Profile profile = *read_profile(text_with("[_INTENSITYUNITS] mW/sr\n"), "lamp.ies");
    EXPECT_TRUE(has_code(resolve_web(profile)->diagnostics, "WEB0110"));
    ResolveOptions as_candela;
    as_candela.as_candela = true;
    EXPECT_FALSE(has_code(resolve_web(profile, as_candela)->diagnostics, "WEB0110"));
    EXPECT_EQ(keyword_text(header_of(profile), "_INTENSITYUNITS"), "mW/sr");
    EXPECT_EQ(keyword_text(header_of(profile, as_candela), "_INTENSITYUNITS"), "");
}

TEST(Radiometric, DoesNotBecomeALight) {
    const std::string file = testing::TempDir() + "/radiometric.ies";
    std::ofstream(file) << text_with("[_INTENSITYUNITS] mW/sr\n");
    Shape shape = *parse_shape("ies:" + file);
    Diagnostics diagnostics;
    const Result<void> loaded = load_profile(shape, diagnostics);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().diagnostics.back().code, "UNS0104");
    EXPECT_NE(loaded.error().diagnostics.back().message.find("mW/sr"), std::string::npos);
    std::remove(file.c_str());
}

} // namespace
} // namespace gonio
