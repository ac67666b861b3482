// Paths in few bytes: their points, and that an outline covers what its parts cover.
#include <gonio/plot/bands.hpp>
#include <gonio/plot/svg.hpp>
#include <gonio/plot/svg_path.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace gonio {
namespace {

using plot_detail::short_line;
using plot_detail::short_outline;

PagePath square(double x, double y, double side) {
    PagePath path;
    path.move_to({x, y}).line_to({x + side, y}).line_to({x + side, y + side}).line_to({x, y + side}).close();
    return path;
}

void add(PagePath& path, const PagePath& other) {
    for (const PagePath::Part& part : other.parts()) {
        path.move_to(part.points[0]);
        for (std::size_t i = 1; i < part.points.size(); ++i)
            path.line_to(part.points[i]);
        path.close();
    }
}

struct Point {
    double x;
    double y;
};

// The loops of data that short_outline() wrote.
std::vector<std::vector<Point>> loops_of(const std::string& data) {
    std::vector<std::vector<Point>> loops;
    const char* at = data.c_str();
    const auto number = [&] {
        char* end = nullptr;
        const double value = std::strtod(at, &end);
        EXPECT_NE(at, end) << at;
        at = end;
        return value;
    };
    char command = ' ';
    while (*at != '\0') {
        if (std::isalpha(static_cast<unsigned char>(*at)) != 0) command = *at++;
        if (command == 'z') continue;
        if (command == 'M') {
            const double x = number();
            loops.push_back({{x, number()}});
            continue;
        }
        Point point = loops.back().back();
        if (command != 'v') point.x += number();
        if (command != 'h') point.y += number();
        loops.back().push_back(point);
    }
    return loops;
}

double area(const std::vector<Point>& loop) {
    double sum = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point& a = loop[i];
        const Point& b = loop[(i + 1) % loop.size()];
        sum += 0.5 * (a.x * b.y - b.x * a.y);
    }
    return sum;
}

TEST(SvgPath, WritesStepsOfATenth) {
    PagePath path;
    path.move_to({10.0, 20.04})
        .line_to({10.5, 20.0})
        .line_to({10.5, 19.0})
        .line_to({10.51, 19.0})
        .line_to({12.5, 18.9});
    EXPECT_EQ(short_line(path), "M10 20h.5v-1l2-.1");
    EXPECT_EQ(short_line(square(0.0, 0.0, 1.0)), "M0 0h1v1h-1z");
}

TEST(SvgPath, LeavesOutEdgesBetweenParts) {
    PagePath path = square(0.0, 0.0, 1.0);
    add(path, square(1.0, 0.0, 1.0));
    EXPECT_EQ(short_outline(path), "M0 0h2v1h-2z");
    // A long part below, which has no corner in the middle.
    path.move_to({0.0, 1.0}).line_to({2.0, 1.0}).line_to({2.0, 3.0}).line_to({0.0, 3.0}).close();
    EXPECT_EQ(short_outline(path), "M0 0h2v3h-2z");
}

TEST(SvgPath, KeepsHolesAndLeavesOutSlivers) {
    PagePath ring;
    for (int i = 0; i < 9; ++i)
        if (i != 4) add(ring, square(i % 3, i / 3, 1.0));
    const auto loops = loops_of(short_outline(ring));
    ASSERT_EQ(loops.size(), 2U);
    EXPECT_NEAR(area(loops[0]) + area(loops[1]), 8.0, 1e-12);
    PagePath sliver;
    sliver.move_to({0.0, 0.0}).line_to({5.0, 0.01}).line_to({5.0, 0.02}).close();
    EXPECT_EQ(short_outline(sliver), "");
    EXPECT_EQ(short_outline(PagePath()), "");
}

// A region with bays, islands and saddles: on the grid of the path its outline has the area of its parts.
TEST(SvgPath, OutlinesCoverWhatTheirPartsCover) {
    Field field;
    for (int i = 0; i <= 60; ++i) {
        field.xs.push_back(i);
        field.ys.push_back(i);
    }
    for (const double y : field.ys)
        for (const double x : field.xs)
            field.values.push_back(std::sin(0.37 * x + 0.3) * std::sin(0.53 * y + 0.1));
    for (const double level : {-0.6, 0.0, 0.4}) {
        PagePath path;
        double covered = 0.0;
        std::size_t points = 0;
        for (const auto& polygon : region_at_least(field, level)) {
            std::vector<Point> rounded;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const PagePoint at{10.0 * polygon[i].x, 10.0 * polygon[i].y};
                i == 0 ? path.move_to(at) : path.line_to(at);
                rounded.push_back({std::round(10.0 * at.x) / 10.0, std::round(10.0 * at.y) / 10.0});
            }
            path.close();
            covered += area(rounded);
            points += polygon.size();
        }
        double outlined = 0.0;
        std::size_t corners = 0;
        for (const auto& loop : loops_of(short_outline(path))) {
            outlined += area(loop);
            corners += loop.size();
        }
        EXPECT_NEAR(outlined, covered, 1e-6 * covered);
        EXPECT_LT(corners, points / 2);
    }
}

TEST(Svg, ShortPathsAndPrefixesChangeNothingElse) {
    Drawing drawing(100, 100, "a title");
    drawing.begin_clip({0.0, 0.0}, 50.0, 50.0);
    drawing.fill(square(1.0, 1.0, 8.0), ink(0xff0000));
    drawing.end_clip();
    const std::string svg = to_svg(drawing, {"one-", true});
    EXPECT_NE(svg.find("<clipPath id=\"one-clip1\">"), std::string::npos);
    EXPECT_NE(svg.find("clip-path=\"url(#one-clip1)\""), std::string::npos);
    EXPECT_NE(svg.find("<path d=\"M1 1h8v8h-8z\" fill=\"#f00\"/>"), std::string::npos);
    EXPECT_NE(to_svg(drawing).find("<path d=\"M1 1L9 1L9 9L1 9Z\" fill=\"#f00\"/>"), std::string::npos);
}

} // namespace
} // namespace gonio
