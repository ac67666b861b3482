#include <gonio/base/text.hpp>

#include <gtest/gtest.h>

namespace gonio {
namespace {

TEST(Text, OnlyLettersOfAsciiHaveACase) {
    EXPECT_EQ(to_upper("az AZ 09 _[`{@"), "AZ AZ 09 _[`{@");
    EXPECT_EQ(to_lower("az AZ 09 _[`{@"), "az az 09 _[`{@");
    for (int byte = 128; byte < 256; ++byte) {
        const char c = static_cast<char>(byte);
        EXPECT_EQ(to_upper(c), c);
        EXPECT_EQ(to_lower(c), c);
    }
}

TEST(Text, ComparesWithoutRegardToCase) {
    EXPECT_TRUE(equals_any_case("Tilt", "tILT"));
    EXPECT_TRUE(equals_any_case("", ""));
    EXPECT_FALSE(equals_any_case("TILT", "TILT="));
    EXPECT_FALSE(equals_any_case("[", "{")); // 0x20 apart, as upper and lower case are
    EXPECT_FALSE(equals_any_case("\xC4", "\xE4"));
    EXPECT_TRUE(starts_with_any_case("iesna:LM-63", "IESNA"));
    EXPECT_FALSE(starts_with_any_case("IES", "IESNA"));
    EXPECT_TRUE(ends_with_any_case("Lamp.XML", ".xml"));
    EXPECT_FALSE(ends_with_any_case("xml", ".xml"));
}

TEST(Text, IsTrimmedAtBothEndsOnly) {
    EXPECT_EQ(trimmed(" \t\v\f\r\na b\r\n"), "a b");
    EXPECT_EQ(trimmed("a b"), "a b");
    EXPECT_EQ(trimmed(" \r\n"), "");
    EXPECT_EQ(trimmed(""), "");
    EXPECT_EQ(trimmed(" a\r\n", blanks), "a\r\n");
    EXPECT_EQ(trimmed("\xA0 a"), "\xA0 a"); // a no-break space of CP1252 counts as a letter
    const std::string_view text = "  ";
    EXPECT_EQ(trimmed(text).data(), text.data() + 2); // a view into the same text, even if it is empty
}

} // namespace
} // namespace gonio
