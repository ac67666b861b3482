#include <gonio/profile/text_encoding.hpp>

#include <gtest/gtest.h>

namespace {

using namespace gonio;

TEST(TextEncoding, WellFormedUtf8IsLeftAlone) {
    for (const std::string text : {"", "plain", "\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\x92\xA1", "\xF4\x8F\xBF\xBF",
                                   "\xEF\xBF\xBF", "\xED\x9F\xBF"}) {
        EXPECT_TRUE(is_utf8(text)) << text;
        EXPECT_EQ(to_utf8(text), text);
    }
}

TEST(TextEncoding, IllFormedUtf8IsSeen) {
    // A lone lead and follow byte, overlong forms of two, three and four bytes, surrogates, above U+10FFFF, cut off.
    for (const std::string text :
         {"\xC3", "\xA4", "\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xE0\x9F\xBF", "\xF0\x80\x80\x80",
          "\xF0\x8F\xBF\xBF", "\xED\xA0\x80", "\xED\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF",
          "\xE2\x82", "\xE2\x28\xA1", "\xF0\x9F\x92", "a\xC3 b"}) {
        EXPECT_FALSE(is_utf8(text));
        EXPECT_TRUE(is_utf8(to_utf8(text)));
        EXPECT_NE(to_utf8(text), text);
    }
}

TEST(TextEncoding, OtherTextIsWindows1252) {
    EXPECT_EQ(to_utf8("Stra\xDF"
                      "enleuchte 10\xB0"),
              "Stra\xC3\x9F"
              "enleuchte 10\xC2\xB0");
    EXPECT_EQ(to_utf8("\x80 \x99 \x9F"), "\xE2\x82\xAC \xE2\x84\xA2 \xC5\xB8"); // euro, trade mark, Y with diaeresis
    EXPECT_EQ(to_utf8("\x81"), "\xC2\x81");
    std::string all;
    for (int c = 1; c < 256; ++c)
        all += static_cast<char>(c);
    EXPECT_TRUE(is_utf8(to_utf8(all)));
}

TEST(TextEncoding, Utf16) {
    EXPECT_EQ(utf16_to_utf8(std::string("A\0\xE4\0\xAC\x20", 6), false), "A\xC3\xA4\xE2\x82\xAC");
    EXPECT_EQ(utf16_to_utf8(std::string("\0A\0\xE4\x20\xAC", 6), true), "A\xC3\xA4\xE2\x82\xAC");
    EXPECT_EQ(utf16_to_utf8("\xD8\x3D\xDC\xA1", true), "\xF0\x9F\x92\xA1");
    // A lead without its trail, a trail alone, a lead at the end, an odd byte.
    EXPECT_EQ(utf16_to_utf8(std::string("\xD8\x3D\0A", 4), true), "\xEF\xBF\xBD"
                                                                  "A");
    EXPECT_EQ(utf16_to_utf8("\xDC\xA1", true), "\xEF\xBF\xBD");
    EXPECT_EQ(utf16_to_utf8("\xD8\x3D", true), "\xEF\xBF\xBD");
    EXPECT_EQ(utf16_to_utf8(std::string("\0A\0", 3), true), "A\xEF\xBF\xBD");
}

} // namespace
