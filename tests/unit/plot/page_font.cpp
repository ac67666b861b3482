#include <gonio/plot/page_font.hpp>
#include <gonio/plot/page_font_widths.hpp>

#include <gtest/gtest.h>

#include <string>

namespace gonio {
namespace {

TEST(PageFont, BlanksAndControlCharactersBecomeOneLine) {
    EXPECT_EQ(page_text("  a\n\nb\tc \xc2\xa0 d ").text, "a b c d");
    const PageText text = page_text("a\x01"
                                    "b\x7f\xc2\x85");
    EXPECT_EQ(text.text, "a\uFFFD"
                         "b\uFFFD\uFFFD");
    EXPECT_EQ(text.replaced, 3U);
}

TEST(PageFont, LatinGreekAndCyrillicStay) {
    for (const char* text : {"é", "²", "°", "Ø", "ß", "ő", "Ω", "γ", "Светильник", "m²", "€", "–", "…", "≥"}) {
        EXPECT_EQ(page_text(text).text, text);
        EXPECT_EQ(page_text(text).replaced, 0U) << text;
    }
}

TEST(PageFont, OtherScriptsAreReplaced) {
    EXPECT_EQ(page_text("照明 lamp").text, "\uFFFD\uFFFD lamp");
    EXPECT_EQ(page_text("\xd7\xa9").replaced, 1U); // Hebrew runs to the left
}

TEST(PageFont, BytesThatAreNotUtf8AreWindows1252) {
    EXPECT_EQ(page_text("caf\xe9").text, "café");
}

TEST(PageFont, TextIsCutToTheWidthAtAWholeLetter) {
    EXPECT_EQ(fitted_text("lamp", 100.0, 8.0), "lamp");
    for (double width = 12.0; width < 80.0; width += 3.7) {
        const std::string cut = fitted_text("Светильник для офиса", width, 8.0);
        EXPECT_LE(page_text_width(cut, 8.0), width);
        EXPECT_TRUE(cut.ends_with("…"));
        EXPECT_EQ(page_text(cut).replaced, 0U) << cut;
    }
}

TEST(PageFont, WidthsGrowWithTheSizeAndBoldIsWider) {
    EXPECT_DOUBLE_EQ(page_text_width("Lamp", 16.0), 2.0 * page_text_width("Lamp", 8.0));
    EXPECT_GT(page_text_width("Lamp", 8.0, true), page_text_width("Lamp", 8.0));
    EXPECT_EQ(page_text_width("", 8.0), 0.0);
}

TEST(PageFont, RangesAscend) {
    char32_t before = 0;
    for (const plot_detail::LetterRange& range : plot_detail::letter_ranges()) {
        EXPECT_GT(range.first, before);
        EXPECT_GE(range.last, range.first);
        before = range.last;
    }
}

} // namespace
} // namespace gonio
