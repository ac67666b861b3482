#include <gonio/plot/diagram.hpp>
#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/falloff_diagram.hpp>
#include <gonio/plot/sheet.hpp>
#include <gonio/plot/svg.hpp>
#include <gonio/web/metrics.hpp>

#include "../light/lights.hpp"
#include "../web/webs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

namespace gonio {
namespace {

using test::random_web;
using test::steps;

Web isotropic(double candela) {
    return *Web::create(Symmetry::axial, {0.0}, {0.0, 180.0}, {candela, candela});
}

// A narrow downlight, cos^n-like, that ends at 90°.
Web downlight() {
    const std::vector<double> gammas = steps(0.0, 90.0, 46);
    std::vector<double> candela;
    for (const double gamma : gammas)
        candela.push_back(1000.0 * std::pow(std::cos(gamma * std::numbers::pi / 180.0), 12.0));
    return *Web::create(Symmetry::axial, {0.0}, gammas, candela);
}

// Checks that every element is closed, in order, and that no number is missing. Enough XML for these files.
void expect_whole(const std::string& svg) {
    std::vector<std::string> open;
    for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
        const std::size_t end = svg.find('>', at);
        ASSERT_NE(end, std::string::npos);
        const std::string tag = svg.substr(at + 1, end - at - 1);
        ASSERT_EQ(tag.find('<'), std::string::npos);
        if (tag.starts_with('/')) {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ(open.back(), tag.substr(1));
            open.pop_back();
        } else if (!tag.ends_with('/')) {
            open.push_back(tag.substr(0, tag.find(' ')));
        }
    }
    EXPECT_TRUE(open.empty());
    for (const char* number : {"nan", "inf"})
        for (const char* before : {"\"", " ", "M", "L", "-", ">"})
            EXPECT_EQ(svg.find(std::string(before) + number), std::string::npos);
}

struct Ring {
    double radius = 0.0;
    double unroundness = 0.0;
};

// The closed paths with that attribute, as circles around the mean of their points.
std::vector<Ring> rings(const std::string& svg, std::string_view attribute) {
    std::vector<Ring> found;
    for (std::size_t at = svg.find("<path d=\""); at != std::string::npos; at = svg.find("<path d=\"", at + 1)) {
        const std::size_t begin = at + 9;
        const std::size_t end = svg.find('"', begin);
        const std::string rest = svg.substr(end, svg.find('>', end) - end);
        if (rest.find(attribute) == std::string::npos) continue;
        std::vector<PagePoint> points;
        for (const char* c = svg.data() + begin; c < svg.data() + end; ++c) {
            if (*c != 'M' && *c != 'L') continue;
            char* next = nullptr;
            PagePoint point;
            point.x = std::strtod(c + 1, &next);
            point.y = std::strtod(next, nullptr);
            points.push_back(point);
        }
        double left = points[0].x, right = left, top = points[0].y, bottom = top;
        for (const PagePoint& p : points) {
            left = std::fmin(left, p.x), right = std::fmax(right, p.x);
            top = std::fmin(top, p.y), bottom = std::fmax(bottom, p.y);
        }
        Ring ring;
        ring.radius = 0.25 * (right - left + bottom - top);
        for (const PagePoint& p : points)
            ring.unroundness =
                std::fmax(ring.unroundness,
                          std::fabs(std::hypot(p.x - 0.5 * (left + right), p.y - 0.5 * (top + bottom)) - ring.radius));
        found.push_back(ring);
    }
    return found;
}

TEST(Diagram, CurvesAreTheInterpolantWithTheEndsOfTheTable) {
    const Web web = random_web(Symmetry::none, steps(0.0, 360.0, 9), {10.0, 33.3, 70.0, 121.7}, 3);
    const auto curve = plot_detail::plane_curve(web, 30.0, 2.0);
    double before = -180.0;
    for (const auto& point : curve) {
        EXPECT_DOUBLE_EQ(point.intensity,
                         2.0 * web.candela(point.gamma_deg < 0.0 ? 210.0 : 30.0, std::fabs(point.gamma_deg)));
        EXPECT_LE(before, point.gamma_deg);
        before = point.gamma_deg;
    }
    // A straight line between neighbours is the interpolant: the curve has no bends between them.
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const double middle = 0.5 * (curve[i - 1].gamma_deg + curve[i].gamma_deg);
        if (curve[i].gamma_deg - curve[i - 1].gamma_deg < 1e-6 || std::fabs(middle) < 1e-6) continue;
        EXPECT_NEAR(0.5 * (curve[i - 1].intensity + curve[i].intensity),
                    2.0 * web.candela(middle < 0.0 ? 210.0 : 30.0, std::fabs(middle)), 1e-6 * 2000.0);
    }
}

TEST(Diagram, AnIsotropicLightIsACircleInThePolarDiagram) {
    const Web web = isotropic(500.0);
    const PlottedWeb plotted{"globe", &web};
    PlotOptions options;
    const auto page = polar_diagram({&plotted, 1}, options);
    ASSERT_TRUE(page.has_value());
    const std::string svg = to_svg(*page);
    expect_whole(svg);
    const auto curves = rings(svg, R"(stroke-width="2")");
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_LT(curves[0].unroundness, 0.02) << "hundredths of a pixel are written";
}

TEST(Diagram, IsoluxLinesOfAnIsotropicLightHaveTheRadiiOfTheInverseSquareLaw) {
    const double candela = 1000.0;
    const double height_m = 2.5;
    const Web web = isotropic(candela);
    const PlottedWeb plotted{"globe", &web};
    PlotOptions options;
    options.mounting_height_m = height_m;
    options.extent_m = 12.0;
    const auto page = isolux_diagram({&plotted, 1}, options);
    ASSERT_TRUE(page.has_value());
    const std::string svg = to_svg(*page);
    expect_whole(svg);
    const auto lines = rings(svg, R"(stroke-width="0.8")");
    // 160 lx under the light; two decades below it: 2, 5, 10, 20, 50, 100 lx.
    const std::vector<double> levels{2, 5, 10, 20, 50, 100};
    ASSERT_EQ(lines.size(), levels.size());
    const auto radius_m = [&](double lux) {
        return std::sqrt(std::pow(candela * height_m / lux, 2.0 / 3.0) - height_m * height_m);
    };
    const double px_per_m = lines[0].radius / radius_m(levels[0]);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        // Cells are 0.15 m; the error of the chord is below a tenth of a pixel.
        EXPECT_NEAR(lines[i].radius, px_per_m * radius_m(levels[i]), 0.1) << levels[i] << " lx";
        EXPECT_LT(lines[i].unroundness, 0.1);
    }
}

TEST(Diagram, TheConeIsAsWideAsTheBeam) {
    const Web web = downlight();
    const PlottedWeb plotted{"downlight", &web};
    PlotOptions options;
    options.mounting_height_m = 2.0;
    const auto page = cone_diagram({&plotted, 1}, options);
    ASSERT_TRUE(page.has_value());
    const std::string svg = to_svg(*page);
    expect_whole(svg);
    const double beam = spread_angle(web, 0.0, 0.5)->value;
    char angle[32];
    (void)std::snprintf(angle, sizeof angle, "beam angle %.1f°", to_degrees(Radians(beam)));
    EXPECT_NE(svg.find(angle), std::string::npos) << angle;
    char width[32];
    (void)std::snprintf(width, sizeof width, ">%.4g<", 2.0 * 2.0 * std::tan(0.5 * beam));
    EXPECT_NE(svg.find(width), std::string::npos) << width;
    EXPECT_NE(svg.find(">250<"), std::string::npos) << "1000 cd at 2 m";
}

TEST(Diagram, EveryKindDrawsEverySymmetryAndIsRepeatable) {
    const Web webs[] = {downlight(), random_web(Symmetry::quadrant, steps(0.0, 90.0, 7), steps(0.0, 90.0, 19), 1),
                        random_web(Symmetry::bilateral_90_270, steps(90.0, 270.0, 9), steps(0.0, 180.0, 13), 2),
                        random_web(Symmetry::none, steps(0.0, 360.0, 25), steps(0.0, 60.0, 13), 4)};
    for (const DiagramKind& kind : diagram_kinds())
        for (const Web& web : webs) {
            if (kind.draw == nullptr) continue; // a diagram of lights
            const PlottedWeb plotted{"a & b <c>", &web};
            PlotOptions options;
            options.title = "\x01\"quoted\"";
            options.per_klm = true;
            const auto page = kind.draw({&plotted, 1}, options);
            if (!page) {
                EXPECT_EQ(kind.name, "cone") << page.error().diagnostics.back().message;
                continue;
            }
            const std::string svg = to_svg(*page);
            expect_whole(svg);
            EXPECT_EQ(to_svg(*kind.draw({&plotted, 1}, options)), svg);
        }
}

TEST(Diagram, WhatCannotBeDrawnIsRefused) {
    const Web dark = isotropic(0.0);
    const Web upward = *Web::create(Symmetry::axial, {0.0}, {100.0, 180.0}, {5.0, 5.0});
    const Web faint = isotropic(1e-205);
    for (const DiagramKind& kind : diagram_kinds()) {
        if (kind.draw == nullptr) continue; // a diagram of lights
        const PlottedWeb plotted[] = {{"dark", &dark}, {"up", &upward}, {"faint", &faint}};
        const PlotOptions options;
        for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
            const auto svg = kind.draw({&plotted[i], 1}, options);
            ASSERT_FALSE(svg.has_value()) << kind.name;
            EXPECT_EQ(svg.error().failure, Failure::usage);
        }
        PlotOptions per_klm;
        per_klm.per_klm = true;
        EXPECT_FALSE(kind.draw({&plotted[0], 1}, per_klm).has_value());
        PlotOptions tiny;
        tiny.width_px = 10;
        EXPECT_FALSE(kind.draw({&plotted[1], 1}, tiny).has_value());
        EXPECT_FALSE(kind.draw({}, options).has_value());
        EXPECT_EQ(kind.draw({&plotted[1], 1}, options).has_value(), kind.name != "isolux" && kind.name != "cone");
    }
    EXPECT_FALSE(find_diagram("polr").has_value());
}

Light slanting_light(const char* shape, const char* intensity) {
    return light_of(shape, intensity, {1.0, -2.0, 3.0}, {1.0, 1.0, -1.0});
}

// The points of the lines in a drawing with that width and dash.
std::vector<std::vector<PagePoint>> lines_of(const Drawing& drawing, double width_px, double dash_px) {
    std::vector<std::vector<PagePoint>> lines;
    for (const DrawingStep& step : drawing.steps())
        if (const auto* line = std::get_if<StrokedPath>(&step))
            if (line->pen.width_px == width_px && line->pen.dash_px[0] == dash_px &&
                line->path.parts()[0].points.size() > 9)
                lines.push_back(line->path.parts()[0].points);
    return lines;
}

// A disk on its axis gives π L r²/(d²+r²) and the inverse square law π L r²/d²: the gap between the curves, in decades,
// is log10(1 + r²/d²). The window multiplies by (1 − (d/R)⁴)².
TEST(Diagram, FalloffIsTheExactLightBesideTheInverseSquare) {
    const double radius_m = 0.3;
    const double range_m = 10.0;
    PlottedLight plotted{"disk", slanting_light("disk:r=30cm", "500cd")};
    plotted.light.range = Meters(range_m);
    FalloffOptions options;
    options.nearest_m = 0.1;
    options.farthest_m = 9.9;
    const Result<Drawing> page = falloff_diagram({&plotted, 1}, options);
    ASSERT_TRUE(page.has_value());
    expect_whole(to_svg(*page));
    const auto square = lines_of(*page, 1.0, 6.0);
    const auto windowed = lines_of(*page, 2.0, 0.0);
    const auto unlimited = lines_of(*page, 1.5, 1.5);
    ASSERT_EQ(square.size(), 1U);
    ASSERT_EQ(windowed.size(), 1U);
    ASSERT_EQ(unlimited.size(), 1U);
    const std::size_t count = square[0].size();
    ASSERT_EQ(windowed[0].size(), count);
    const double decades = std::log10(options.farthest_m / options.nearest_m);
    const double px_per_decade = (square[0].back().y - square[0].front().y) / (2.0 * decades);
    for (std::size_t i = 0; i < count; ++i) {
        const double d =
            options.nearest_m * std::pow(10.0, decades * static_cast<double>(i) / static_cast<double>(count - 1));
        const double gap = (unlimited[0][i].y - square[0][i].y) / px_per_decade;
        EXPECT_NEAR(gap, std::log10(1.0 + radius_m * radius_m / (d * d)), 1e-9) << d;
        const double window = std::pow(1.0 - std::pow(d / range_m, 4.0), 2.0);
        EXPECT_NEAR((windowed[0][i].y - unlimited[0][i].y) / px_per_decade, -std::log10(window), 1e-8) << d;
    }
}

TEST(Diagram, FalloffRefusesWhatHasNone) {
    const FalloffOptions options;
    EXPECT_FALSE(falloff_diagram({}, options).has_value());
    const PlottedLight sun{"sun", slanting_light("sun:angle=0.53deg", "100000lx")};
    EXPECT_FALSE(falloff_diagram({&sun, 1}, options).has_value());
    const PlottedLight bulb{"bulb", slanting_light("sphere:r=3cm", "800lm")};
    EXPECT_TRUE(falloff_diagram({&bulb, 1}, options).has_value());
    for (const auto& [from, to] : {std::pair{0.0, 1.0}, {2.0, 1.0}, {1.0, 1.1}, {1.0, 1e9}, {std::nan(""), 1.0}}) {
        FalloffOptions wrong;
        wrong.nearest_m = from;
        wrong.farthest_m = to;
        EXPECT_FALSE(falloff_diagram({&bulb, 1}, wrong).has_value()) << from << ':' << to;
    }
}

TEST(Sheet, HoldsEveryTileInItsPlace) {
    const Web web = downlight();
    std::vector<SheetTile> tiles(7);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        tiles[i].name = "a name that is far too long for the tile of a sheet, and goes on and on.ies";
        tiles[i].picture = Image(64, 64, 3);
        std::fill(tiles[i].picture.pixels.begin(), tiles[i].picture.pixels.end(), 0.1F * static_cast<float>(i + 1));
        tiles[i].polar = polar_thumbnail(web);
    }
    tiles[3].picture = {};
    tiles[3].fault = "91 candela values announced, 21 found, and so on, a long sentence that is cut somewhere";
    SheetOptions options;
    options.picture_width_px = 64;
    options.picture_height_px = 64;
    options.columns = 3;
    options.title = "Seven";
    const SheetLayout layout = layout_of(tiles.size(), options);
    EXPECT_EQ(layout.columns, 3);
    EXPECT_EQ(layout.rows, 3);
    const Image image = sheet(tiles, options);
    EXPECT_EQ(image.width, layout.width_px);
    EXPECT_EQ(image.height, layout.height_px);
    const int pitch_x = (layout.width_px - 10) / 3;
    const int pitch_y = (layout.height_px - 40 - 10) / 3;
    for (int i = 0; i < 7; ++i) {
        const float expected = 0.1F * static_cast<float>(i + 1);
        const float shown = image.at(10 + i % 3 * pitch_x + 32, 50 + i / 3 * pitch_y + 32)[0];
        if (i != 3) { // which holds text
            EXPECT_FLOAT_EQ(shown, expected) << i;
        }
    }
    EXPECT_EQ(sheet(tiles, options).pixels, image.pixels);
    options.columns = 0;
    for (const std::size_t count : {1U, 2U, 50U, 172U}) {
        const SheetLayout chosen = layout_of(count, options);
        EXPECT_GE(static_cast<std::size_t>(chosen.columns * chosen.rows), count);
        EXPECT_LT(static_cast<std::size_t>(chosen.columns * (chosen.rows - 1)), count);
    }
}

TEST(Diagram, NumbersHaveNoNegativeZeroAndNoExponent) {
    EXPECT_EQ(svg_number(-0.001), "0");
    EXPECT_EQ(svg_number(12.5), "12.5");
    EXPECT_EQ(svg_number(1e6), "1000000");
    EXPECT_EQ(svg_number(-3.14159), "-3.14");
}

} // namespace
} // namespace gonio
