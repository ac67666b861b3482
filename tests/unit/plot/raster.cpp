#include <gonio/plot/palette.hpp>
#include <gonio/plot/raster.hpp>
#include <gonio/plot/stroke_font.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>

namespace gonio {
namespace {

constexpr Ink black;

// The amount of ink on a page that was white.
double inked(const Image& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3)
        sum += 1.0 - static_cast<double>(image.pixels[i]);
    return sum;
}

TEST(Raster, APolygonCoversItsAreaWhereverItLies) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> at(2.0, 38.0);
    for (int i = 0; i < 300; ++i) {
        const PagePoint a{at(random), at(random)};
        const PagePoint b{at(random), at(random)};
        const PagePoint c{at(random), at(random)};
        PagePath path;
        path.move_to(a).line_to(b).line_to(c).close();
        Drawing page(40, 40, "");
        page.fill(std::move(path), black);
        const double area = 0.5 * std::fabs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
        // Coverage is exact, except for pixels that are entered twice; it is summed in float.
        EXPECT_NEAR(inked(to_image(page)), area, 1e-4 + 1e-5 * area);
    }
}

TEST(Raster, NeighboursLeaveNoSeam) {
    PagePath path; // two halves of a square that meet inside pixels
    path.move_to({2.3, 2.3}).line_to({7.6, 2.3}).line_to({4.1, 9.7}).line_to({2.3, 9.7}).close();
    path.move_to({7.6, 2.3}).line_to({9.7, 2.3}).line_to({9.7, 9.7}).line_to({4.1, 9.7}).close();
    Drawing page(12, 12, "");
    page.fill(std::move(path), black);
    const Image image = to_image(page);
    for (int y = 3; y < 9; ++y)
        for (int x = 3; x < 9; ++x)
            EXPECT_NEAR(*image.at(x, y), 0.0F, 1e-6F) << x << ',' << y;
    EXPECT_NEAR(inked(image), 7.4 * 7.4, 1e-4);
}

TEST(Raster, ALineHasItsWidthAtEveryAngle) {
    for (const double width : {0.4, 1.0, 1.7, 3.0})
        for (int angle = 5; angle < 90; angle += 13) {
            const double radians = angle * std::numbers::pi / 180.0;
            const PagePoint half{20.0 * std::cos(radians), 20.0 * std::sin(radians)};
            Drawing page(60, 60, "");
            page.line({30.3 - half.x, 29.6 - half.y}, {30.3 + half.x, 29.6 + half.y}, {black, width});
            // Coverage is measured across the line as if the pixel were rotated with it, and the ends are round.
            const double ends = std::numbers::pi * 0.25 * width * width + width;
            EXPECT_NEAR(inked(to_image(page)), 40.0 * width, 0.03 * 40.0 * width + ends) << width << " at " << angle;
        }
}

TEST(Raster, DashesLeaveTheirGaps) {
    Drawing page(120, 10, "");
    page.line({5.0, 5.0}, {105.0, 5.0}, {black, 1.0, {6.0, 4.0}});
    const Image image = to_image(page);
    // Ten dashes of 6 px, each with a fraction of a pixel of a round end on both sides.
    EXPECT_NEAR(inked(image), 60.0, 10.0);
    EXPECT_LT(*image.at(7, 5), 0.01F);
    EXPECT_GT(*image.at(13, 5), 0.99F);
}

TEST(Raster, WhatLiesOutsideIsLeftOut) {
    Image image(10, 10, 3);
    Drawing drawing(10, 10, "");
    drawing.begin_clip({2.0, 2.0}, 3.0, 3.0);
    drawing.rectangle({-1e12, -1e12}, 2e12, 2e12, ink(0xffffff));
    drawing.end_clip();
    drawing.line({-1e9, 50.0}, {1e9, 60.0}, {black, 3.0});
    drawing.text({-500.0, 1e9}, "far away", {});
    drawing.circle({1e300, 1e300}, 5.0, black);
    draw(drawing, image);
    double sum = 0.0;
    for (const float value : image.pixels)
        sum += static_cast<double>(value);
    EXPECT_NEAR(sum, 3.0 * 9.0, 1e-5);
}

TEST(Raster, PastedPicturesAreCutAtTheEdges) {
    Image small(3, 3, 3);
    std::fill(small.pixels.begin(), small.pixels.end(), 1.0F);
    Image large(4, 4, 3);
    paste(small, large, -2, 3);
    paste(small, large, 9, 9);
    paste(small, large, 0, -5);
    EXPECT_EQ(*large.at(0, 3), 1.0F);
    EXPECT_EQ(std::count(large.pixels.begin(), large.pixels.end(), 1.0F), 3);
}

// The shapes of all letters, as text for comparison.
std::string shape_of(std::string_view letter) {
    std::string shape;
    for (const Polyline& line : text_lines(letter, {}, 100.0, false)) {
        for (const PagePoint p : line)
            shape += std::to_string(std::lround(p.x)) + "," + std::to_string(std::lround(p.y)) + " ";
        shape += ";";
    }
    return shape;
}

TEST(StrokeFont, EveryLetterIsThereAndDiffersFromTheOthers) {
    std::set<std::string> shapes{shape_of("\xef\xbf\xbd")}; // the box for a missing glyph
    for (char c = '!'; c <= '~'; ++c)
        EXPECT_TRUE(shapes.insert(shape_of(std::string(1, c))).second) << c;
    for (const char* sign : {"°", "²", "³", "µ", "·", "×", "γ", "Φ", "π", "α", "±", "≤", "≥", "→", "ä", "Ö", "ß", "é"})
        EXPECT_TRUE(shapes.insert(shape_of(sign)).second) << sign;
    EXPECT_EQ(shape_of("μ"), shape_of("µ"));
}

TEST(StrokeFont, WidthIsWhereTheNextLetterBegins) {
    const std::string word = "Φ 12.5 klm";
    const std::vector<Polyline> word_lines = text_lines(word + "|", {}, 20.0, false);
    const std::vector<Polyline> bar = text_lines("|", {text_width_px(word, 20.0), 0.0}, 20.0, false);
    EXPECT_NEAR(word_lines.back()[0].x, bar[0][0].x, 1e-9);
    EXPECT_DOUBLE_EQ(text_width_px("1111", 12.0), text_width_px("0472", 12.0)) << "figures are of one width";
}

TEST(StrokeFont, HintedTextStandsOnPixels) {
    for (double size = 8.0; size < 30.0; size += 0.7) {
        const auto lines = text_lines("H", {3.2, 40.37}, size, true);
        const auto fraction = [](double v) { return v - std::floor(v); };
        EXPECT_NEAR(fraction(lines[0][0].y), 0.5, 1e-9); // the lower end
        EXPECT_NEAR(fraction(lines[0][1].y), 0.5, 1e-9); // the upper end
    }
}

TEST(StrokeFont, BytesThatAreNoTextAreBoxes) {
    const double box = text_width_px("\xef\xbf\xbd", 12.0);
    EXPECT_DOUBLE_EQ(text_width_px("\xff", 12.0), box);
    EXPECT_DOUBLE_EQ(text_width_px("\xe2\x82", 12.0), 2.0 * box); // a truncated character
    EXPECT_DOUBLE_EQ(text_width_px("\xc3", 12.0), box);
    EXPECT_FALSE(text_lines("\x80\xc0 漢", {}, 12.0, true).empty());
}

// CIE lightness of an sRGB colour.
double lightness(const std::array<float, 3>& rgb) {
    const auto linear = [](float v) {
        return v <= 0.04045F ? v / 12.92 : std::pow((static_cast<double>(v) + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2]);
    return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

TEST(Palette, LightnessRisesEvenly) {
    for (const Palette& palette : palettes()) {
        if (!palette.rises) continue;
        const double span = lightness(palette.at(1.0)) - lightness(palette.at(0.0));
        EXPECT_GT(span, 60.0) << palette.name;
        double before = lightness(palette.at(0.0));
        for (int i = 1; i <= 20; ++i) {
            const double now = lightness(palette.at(i / 20.0));
            // A twentieth of the ramp is a twentieth of its lightness, within a factor of two; at the very dark end the
            // encoded bytes of grey and inferno start flat.
            EXPECT_GT(now - before, 0.2 * span / 20.0) << palette.name << ' ' << i;
            EXPECT_LT(now - before, 2.0 * span / 20.0) << palette.name << ' ' << i;
            before = now;
        }
    }
}

// Turbo is light in the middle: blue below, red above.
TEST(Palette, TurboGoesFromBlueThroughGreenToRed) {
    const Palette* const turbo = find_palette("turbo").value();
    EXPECT_FALSE(turbo->rises);
    EXPECT_GT(lightness(turbo->at(0.5)), 85.0);
    EXPECT_LT(lightness(turbo->at(0.0)), 20.0);
    EXPECT_LT(lightness(turbo->at(1.0)), 30.0);
    const auto low = turbo->at(0.15);
    const auto high = turbo->at(0.85);
    EXPECT_GT(low[2], 2.0F * low[0]);
    EXPECT_GT(high[0], 2.0F * high[2]);
}

TEST(Palette, OfSignedValuesIsAsDarkToBothSides) {
    const Palette& signed_values = diverging_palette();
    const std::array<float, 3> zero = signed_values.at(0.5);
    EXPECT_EQ(zero[0], zero[1]);
    EXPECT_EQ(zero[1], zero[2]);
    for (int i = 1; i <= 10; ++i) {
        const auto below = signed_values.at(0.5 - i / 20.0);
        const auto above = signed_values.at(0.5 + i / 20.0);
        // The table is rounded to bytes; the paper makes both halves equal in Lab lightness.
        EXPECT_NEAR(lightness(below), lightness(above), 2.0) << i;
        EXPECT_LT(lightness(below), lightness(signed_values.at(0.5 - (i - 1) / 20.0)));
        EXPECT_GT(below[2], below[0]);
        EXPECT_GT(above[0], above[2]);
    }
}

TEST(Palette, EndsHoldBeyond) {
    for (const Palette& palette : palettes()) {
        EXPECT_EQ(palette.at(-3.0), palette.at(0.0));
        EXPECT_EQ(palette.at(7.0), palette.at(1.0));
        EXPECT_EQ(palette.at(std::nan("")), palette.at(0.0));
    }
    EXPECT_EQ((*find_palette("grey"))->name, "gray");
    EXPECT_FALSE(find_palette("virdis").has_value());
}

} // namespace
} // namespace gonio
