#include <gonio/plot/svg_path.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace gonio::plot_detail {

namespace {

// In tenths of a pixel.
struct GridPoint {
    long x = 0;
    long y = 0;

    bool operator==(const GridPoint&) const = default;
    bool operator<(const GridPoint& other) const { return x != other.x ? x < other.x : y < other.y; }
};

using Edge = std::pair<GridPoint, GridPoint>;

// Points that fall together count once.
std::vector<GridPoint> on_grid(const PagePath::Part& part) {
    std::vector<GridPoint> points;
    for (const PagePoint& point : part.points) {
        const GridPoint at{std::lround(10.0 * point.x), std::lround(10.0 * point.y)};
        if (points.empty() || points.back() != at) points.push_back(at);
    }
    return points;
}

// "-1.2", ".5", "12".
std::string number_text(long tenths) {
    const long size = std::labs(tenths);
    std::string text = tenths < 0 ? "-" : "";
    if (size >= 10 || size == 0) text += std::to_string(size / 10);
    if (size % 10 != 0) text += fmt::format(".{}", size % 10);
    return text;
}

void append(std::string& data, std::span<const GridPoint> points, bool closed) {
    data += fmt::format("M{} {}", number_text(points[0].x), number_text(points[0].y));
    char last = 'M';
    for (std::size_t i = 1; i < points.size(); ++i) {
        const long dx = points[i].x - points[i - 1].x;
        const long dy = points[i].y - points[i - 1].y;
        const char command = dy == 0 ? 'h' : dx == 0 ? 'v' : 'l';
        if (command != last)
            data += command;
        else if ((command == 'v' ? dy : dx) >= 0)
            data += ' ';
        last = command;
        if (command != 'v') data += number_text(dx);
        if (command == 'l' && dy > 0) data += ' ';
        if (command != 'h') data += number_text(dy);
    }
    if (closed) data += 'z';
}

// All edges of the parts; a horizontal one is split where another part has a corner on it.
std::vector<Edge> edges_of(const PagePath& path) {
    std::vector<std::vector<GridPoint>> parts;
    std::map<long, std::vector<long>> corners; // by y
    for (const PagePath::Part& part : path.parts()) {
        std::vector<GridPoint> points = on_grid(part);
        if (points.size() > 1 && points.front() == points.back()) points.pop_back();
        if (points.size() < 3) continue;
        for (const GridPoint& point : points)
            corners[point.y].push_back(point.x);
        parts.push_back(std::move(points));
    }
    for (auto& [_, xs] : corners) {
        std::sort(xs.begin(), xs.end());
        xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
    }
    std::vector<Edge> edges;
    for (const std::vector<GridPoint>& points : parts)
        for (std::size_t i = 0; i < points.size(); ++i) {
            GridPoint from = points[i];
            const GridPoint to = points[(i + 1) % points.size()];
            if (from.y == to.y) {
                const std::vector<long>& xs = corners[from.y];
                auto between = std::upper_bound(xs.begin(), xs.end(), std::min(from.x, to.x));
                std::vector<long> inner(between, std::lower_bound(between, xs.end(), std::max(from.x, to.x)));
                if (from.x > to.x) std::reverse(inner.begin(), inner.end());
                for (const long x : inner) {
                    edges.emplace_back(from, GridPoint{x, from.y});
                    from.x = x;
                }
            }
            edges.emplace_back(from, to);
        }
    return edges;
}

bool is_straight(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return (a.x == b.x && b.x == c.x && (b.y > a.y) == (c.y > b.y)) ||
           (a.y == b.y && b.y == c.y && (b.x > a.x) == (c.x > b.x));
}

std::vector<GridPoint> without_straight_corners(const std::vector<GridPoint>& loop) {
    std::vector<GridPoint> corners;
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (!is_straight(loop[(i + loop.size() - 1) % loop.size()], loop[i], loop[(i + 1) % loop.size()]))
            corners.push_back(loop[i]);
    return corners;
}

} // namespace

std::string short_line(const PagePath& path) {
    std::string data;
    for (const PagePath::Part& part : path.parts())
        if (const std::vector<GridPoint> points = on_grid(part); !points.empty()) append(data, points, part.closed);
    return data;
}

std::string short_outline(const PagePath& path) {
    std::map<Edge, int> left; // edges without one in the other direction
    for (const Edge& edge : edges_of(path)) {
        const auto other = left.find({edge.second, edge.first});
        if (other == left.end())
            ++left[edge];
        else if (--other->second == 0)
            left.erase(other);
    }
    std::string data;
    while (!left.empty()) {
        // As many edges end in a point as begin there, so the walk ends where it began.
        const GridPoint start = left.begin()->first.first;
        std::vector<GridPoint> loop;
        GridPoint at = start;
        do {
            loop.push_back(at);
            const auto next = left.lower_bound({at, GridPoint{std::numeric_limits<long>::min(), 0}});
            at = next->first.second;
            if (--next->second == 0) left.erase(next);
        } while (at != start);
        if (const std::vector<GridPoint> corners = without_straight_corners(loop); corners.size() > 2)
            append(data, corners, true);
    }
    return data;
}

} // namespace gonio::plot_detail
