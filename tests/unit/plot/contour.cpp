#include <gonio/plot/contour.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gonio {
namespace {

Field field_of(int cells, double half, double (*f)(double, double)) {
    Field field;
    for (int i = 0; i <= cells; ++i)
        field.xs.push_back(half * (2.0 * i / cells - 1.0));
    field.ys = field.xs;
    for (const double y : field.ys)
        for (const double x : field.xs)
            field.values.push_back(f(x, y));
    return field;
}

double area(const std::vector<FieldPoint>& polygon) {
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const FieldPoint& p = polygon[i];
        const FieldPoint& q = polygon[(i + 1) % polygon.size()];
        sum += p.x * q.y - q.x * p.y;
    }
    return 0.5 * sum;
}

double area(const std::vector<std::vector<FieldPoint>>& region) {
    double sum = 0.0;
    for (const auto& polygon : region) {
        EXPECT_GT(area(polygon), -1e-15) << "all polygons turn the same way";
        sum += area(polygon);
    }
    return sum;
}

double dome(double x, double y) {
    return 1.0 - std::hypot(x, y);
}

double checker(double x, double y) {
    return std::sin(7.0 * x + 0.3) * std::sin(9.0 * y + 0.1);
}

TEST(Contour, ADiskHasTheAreaAndTheLineOfACircle) {
    const Field field = field_of(200, 1.0, dome);
    for (const double radius : {0.9, 0.5, 0.1}) {
        const double level = 1.0 - radius;
        // Marching squares replaces each arc by its chord: a relative error of about h²/(8 r²) with h = 0.01.
        const double tolerance = 3.0 * 1e-4 / (8.0 * radius * radius);
        const double exact = std::numbers::pi * radius * radius;
        EXPECT_NEAR(area(region_at_least(field, level)), exact, tolerance * exact);
        const auto lines = contour_lines(field, level);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_TRUE(lines[0].closed);
        EXPECT_NEAR(std::fabs(area(lines[0].points)), exact, tolerance * exact);
        for (const FieldPoint& p : lines[0].points)
            EXPECT_NEAR(std::hypot(p.x, p.y), radius, 1.3e-5 / radius);
    }
}

TEST(Contour, LinesAreTheRimOfTheRegion) {
    // Saddles and lines that leave the field: the area enclosed by the lines and the area of the polygons must agree.
    const Field field = field_of(41, 1.0, checker);
    const Field outside = [&] {
        Field f = field;
        const std::size_t n = f.xs.size();
        for (std::size_t r = 0; r < n; ++r)
            for (std::size_t c = 0; c < n; ++c)
                if (r == 0 || c == 0 || r == n - 1 || c == n - 1) f.values[r * n + c] = -10.0;
        return f;
    }();
    for (const double level : {-0.5, 0.0, 0.01, 0.5}) {
        const double covered = area(region_at_least(outside, level));
        // Lines may run in either direction, so the sign of an enclosed area depends on how many other lines contain
        // it.
        double by_parity = 0.0;
        const auto lines = contour_lines(outside, level);
        for (const ContourLine& line : lines) {
            EXPECT_TRUE(line.closed);
            int depth = 0;
            for (const ContourLine& other : lines) {
                if (&other == &line) continue;
                bool inside = false;
                const FieldPoint p = line.points[0];
                for (std::size_t i = 0, j = other.points.size() - 1; i < other.points.size(); j = i++) {
                    const FieldPoint& a = other.points[i];
                    const FieldPoint& b = other.points[j];
                    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
                        inside = !inside;
                }
                depth += inside ? 1 : 0;
            }
            by_parity += (depth % 2 == 0 ? 1.0 : -1.0) * std::fabs(area(line.points));
        }
        EXPECT_NEAR(by_parity, covered, 1e-12) << "level " << level;
    }
}

TEST(Contour, OpenLinesEndAtTheEdge) {
    const Field field = field_of(10, 1.0, [](double x, double) { return x; });
    const auto lines = contour_lines(field, 0.25);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_FALSE(lines[0].closed);
    EXPECT_EQ(std::fabs(lines[0].points.front().y), 1.0);
    EXPECT_EQ(lines[0].points.front().y, -lines[0].points.back().y);
    for (const FieldPoint& p : lines[0].points)
        EXPECT_NEAR(p.x, 0.25, 1e-15);
}

TEST(Contour, WhatIsNotANumberIsBelow) {
    Field field = field_of(4, 1.0, [](double, double) { return 1.0; });
    field.values[12] = std::nan("");
    const double covered = area(region_at_least(field, 0.5));
    EXPECT_LT(covered, 4.0);
    EXPECT_GE(covered, 3.0);
    for (const ContourLine& line : contour_lines(field, 0.5))
        for (const FieldPoint& p : line.points)
            EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
}

TEST(Contour, AFieldWithoutCellsHasNothing) {
    EXPECT_TRUE(region_at_least({{0.0}, {0.0}, {1.0}}, 0.5).empty());
    EXPECT_TRUE(contour_lines({{}, {}, {}}, 0.5).empty());
}

} // namespace
} // namespace gonio
