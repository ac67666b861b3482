#include <gonio/sky/equal_area_square.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace gonio {

namespace {

// A convex polygon of at most eight corners: four, and one more for each side of a texel that cuts it.
struct Polygon {
    std::array<glm::dvec2, 8> corners{};
    std::size_t count = 0;

    void add(const glm::dvec2& corner) { corners.at(count++) = corner; }
};

double area(const Polygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec2& a = polygon.corners.at(i);
        const glm::dvec2& b = polygon.corners.at(i + 1 < polygon.count ? i + 1 : 0);
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(twice);
}

// The part with sign·(p[axis] − at) ≥ 0.
Polygon clipped(const Polygon& polygon, int axis, double at, double sign) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec2& a = polygon.corners.at(i);
        const glm::dvec2& b = polygon.corners.at(i + 1 < polygon.count ? i + 1 : 0);
        const double inside_a = sign * (a[axis] - at);
        const double inside_b = sign * (b[axis] - at);
        if (inside_a >= 0.0) kept.add(a);
        if ((inside_a >= 0.0) != (inside_b >= 0.0)) kept.add(a + inside_a / (inside_a - inside_b) * (b - a));
    }
    return kept;
}

class Square {
public:
    explicit Square(int side)
        : side_(side), sums_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), glm::dvec3(0.0)) {}

    // `whole` in texels of the square.
    void add(const Polygon& whole, const glm::dvec3& value) {
        glm::dvec2 low = whole.corners[0];
        glm::dvec2 high = low;
        for (std::size_t i = 1; i < whole.count; ++i) {
            low = {std::min(low.x, whole.corners.at(i).x), std::min(low.y, whole.corners.at(i).y)};
            high = {std::max(high.x, whole.corners.at(i).x), std::max(high.y, whole.corners.at(i).y)};
        }
        const auto texel = [&](double at) { return std::clamp(static_cast<int>(at), 0, side_ - 1); };
        for (int row = texel(low.y); row <= texel(high.y); ++row)
            for (int column = texel(low.x); column <= texel(high.x); ++column) {
                Polygon part = whole;
                if (low.x < column) part = clipped(part, 0, column, 1.0);
                if (high.x > column + 1) part = clipped(part, 0, column + 1, -1.0);
                if (low.y < row) part = clipped(part, 1, row, 1.0);
                if (high.y > row + 1) part = clipped(part, 1, row + 1, -1.0);
                sums_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
                      static_cast<std::size_t>(column)] += area(part) * value;
            }
    }

    Image image() const {
        Image made(side_, side_, 3);
        for (std::size_t i = 0; i < sums_.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                made.pixels[3 * i + c] = static_cast<float>(sums_[i][static_cast<int>(c)]);
        return made;
    }

private:
    int side_;
    std::vector<glm::dvec3> sums_; // a texel has the area 1
};

} // namespace

Image equal_area_square(const EnvironmentMap& latlong, int side) {
    const int height = latlong.grid().height();
    const int width = latlong.grid().width(); // 2 height: a multiple of four
    const Image& image = latlong.image();
    Square square(side);
    const auto radius = [&](int row) { // of the parallel above a row of the upper half
        return std::sqrt(2.0) * std::sin(0.5 * std::numbers::pi * row / height);
    };
    for (int row = 0; row < height; ++row) {
        const bool below = row >= height / 2;
        const double inner = radius(below ? height - row - 1 : row);
        const double outer = radius(below ? height - row : row + 1);
        for (int column = 0; column < width; ++column) {
            // A quarter of the width is a quadrant: from south over west, north and east.
            const int quarter = width / 4;
            const int quadrant = column / quarter;
            const double east = quadrant < 2 ? -1.0 : 1.0;
            const double north = quadrant == 1 || quadrant == 2 ? 1.0 : -1.0;
            // v/r grows from the axis of east and west to that of north and south.
            const bool falls = quadrant % 2 == 0;
            const int first = column % quarter;
            const double turn0 = static_cast<double>(falls ? quarter - first : first) / quarter;
            const double turn1 = static_cast<double>(falls ? quarter - first - 1 : first + 1) / quarter;
            Polygon polygon;
            const auto add = [&](double r, double turn) {
                const glm::dvec2 above(r * (1.0 - turn), r * turn);
                const glm::dvec2 at = below ? glm::dvec2(1.0 - above.y, 1.0 - above.x) : above;
                polygon.add(0.5 * side * glm::dvec2(1.0 + east * at.x, 1.0 + north * at.y));
            };
            add(inner, turn0);
            add(outer, turn0);
            add(outer, turn1);
            add(inner, turn1);
            const float* const pixel = image.at(column, row);
            square.add(polygon, {pixel[0], pixel[1], pixel[2]});
        }
    }
    return square.image();
}

} // namespace gonio
