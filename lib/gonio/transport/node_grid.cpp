#include <gonio/transport/node_grid.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

namespace gonio::detail {

namespace {

// Distances in squares, the size of a patch.
constexpr double widest = 2.5;
constexpr double narrowest = 0.25;
constexpr double least_solid = 2.0; // half of the width of a solid that lines lie closer for, in narrowest distances
constexpr double growth = 0.7;      // of the distance between lines, with the distance from what they are close to

// What makes the lines of a grid lie closer: an interval of the coordinate, and the distance between lines there.
struct Grading {
    double low;
    double high;
    double spacing;
};

struct Spacing {
    const Range& range;
    double widest_m;
    std::vector<Grading> gradings;
    std::vector<double> cuts; // a line on each side

    double operator()(double x) const {
        double spacing = widest_m;
        if (range.core > 0.0) {
            const double w = range.warped(x);
            spacing = range.unwarped(w + 0.5 * widest_m) - range.unwarped(w - 0.5 * widest_m);
        }
        for (const Grading& near : gradings) {
            const double away = std::max({near.low - x, x - near.high, 0.0});
            spacing = std::min(spacing, near.spacing + growth * away);
        }
        return spacing;
    }
};

// Lines from `low` to `high`, no farther apart than `spacing` says.
void add_lines(double low, double high, double inset, const Spacing& spacing, std::vector<double>& lines) {
    std::vector<double> steps{low};
    constexpr std::size_t most = 2000;
    while (steps.back() < high && steps.size() < most) {
        const double x = steps.back();
        const double there = spacing(std::min(x + 0.5 * spacing(x), high));
        steps.push_back(x + std::max(there, 1e-12 * std::abs(x)));
    }
    // The last step ends beyond: all are shortened alike.
    const std::size_t last = steps.size() - 1;
    const double steps_needed =
        static_cast<double>(last - 1) + (high - steps[last - 1]) / (steps[last] - steps[last - 1]);
    lines.push_back(low + inset);
    for (std::size_t i = 1; i < last; ++i) {
        const double step = steps_needed * static_cast<double>(i) / static_cast<double>(last);
        const auto whole = static_cast<std::size_t>(step);
        lines.push_back(steps[whole] + (step - static_cast<double>(whole)) * (steps[whole + 1] - steps[whole]));
    }
    lines.push_back(high - inset);
}

std::vector<double> lines_of(const Spacing& spacing, double inset) {
    std::vector<double> ends{spacing.range.low};
    std::vector<double> cuts = spacing.cuts;
    std::sort(cuts.begin(), cuts.end());
    for (const double cut : cuts)
        if (cut > ends.back() + 4.0 * inset && cut < spacing.range.high - 4.0 * inset) ends.push_back(cut);
    ends.push_back(spacing.range.high);
    std::vector<double> lines;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        add_lines(ends[i], ends[i + 1], inset, spacing, lines);
    return lines;
}

// What another surface does to the grid of a flat chart.
struct Closeness {
    const Chart& chart;
    double least_m; // distance between lines at an edge
    Spacing& along_u;
    Spacing& along_v;

    void add(Spacing& spacing, const glm::dvec3& axis, double low, double high, double distance) const {
        (void)axis;
        spacing.gradings.push_back({low, high, distance});
    }

    void edge(Spacing& spacing, double at) const {
        spacing.gradings.push_back({at, at, least_m});
        spacing.cuts.push_back(at);
    }

    // A one-sided surface across this one: an edge where it is perpendicular to an axis of the chart.
    void sheet(const glm::dvec3& point, const glm::dvec3& normal) const {
        const glm::dvec3 to = point - chart.frame.origin;
        if (std::abs(glm::dot(normal, chart.frame.x)) > 1.0 - 1e-9) edge(along_u, glm::dot(to, chart.frame.x));
        if (std::abs(glm::dot(normal, chart.frame.y)) > 1.0 - 1e-9) edge(along_v, glm::dot(to, chart.frame.y));
    }
    void operator()(const Plane& plane) const { sheet(plane.point, plane.normal); }
    void operator()(const Panel& panel) const {
        const glm::dvec3 to = panel.frame.origin - chart.frame.origin;
        const double reach = 0.5 * (panel.width * std::abs(glm::dot(panel.frame.x, chart.frame.z)) +
                                    panel.height * std::abs(glm::dot(panel.frame.y, chart.frame.z)));
        if (std::abs(glm::dot(to, chart.frame.z)) > reach + least_m) return; // does not touch it
        sheet(panel.frame.origin, panel.frame.z);
    }
    void round(const glm::dvec3& low_end, const glm::dvec3& high_end, double radius) const {
        const glm::dvec3 a = chart.frame.to_local(low_end - chart.frame.origin);
        const glm::dvec3 b = chart.frame.to_local(high_end - chart.frame.origin);
        const double gap = std::max(std::min(a.z, b.z) - radius, 0.0);
        if (radius < least_solid * least_m) return;    // sends and hides too little
        if (std::max(a.z, b.z) + radius < 0.0) return; // behind
        const double spacing = std::max({least_m, radius / 8.0, 0.5 * gap});
        along_u.gradings.push_back({std::min(a.x, b.x), std::max(a.x, b.x), spacing});
        along_v.gradings.push_back({std::min(a.y, b.y), std::max(a.y, b.y), spacing});
    }
    void operator()(const Ball& ball) const { round(ball.center, ball.center, ball.radius); }
    void operator()(const Capsule& capsule) const {
        const glm::dvec3 half = capsule.half_length * capsule.axis;
        round(capsule.center - half, capsule.center + half, capsule.radius);
    }
    void operator()(const Box& box) const {
        const glm::dvec3 to = chart.frame.to_local(box.frame.origin - chart.frame.origin);
        const auto reach = [&](const glm::dvec3& axis) {
            return box.half_size.x * std::abs(glm::dot(box.frame.x, axis)) +
                   box.half_size.y * std::abs(glm::dot(box.frame.y, axis)) +
                   box.half_size.z * std::abs(glm::dot(box.frame.z, axis));
        };
        if (to.z + reach(chart.frame.z) < 0.0) return; // behind
        const double gap = std::max(to.z - reach(chart.frame.z), 0.0);
        if (std::max(reach(chart.frame.x), reach(chart.frame.y)) < least_solid * least_m) return;
        const double spacing = std::max(least_m, 0.5 * gap);
        const auto sides = [&](Spacing& of, double middle, double half) {
            for (const double at : {middle - half, middle + half}) {
                of.gradings.push_back({at, at, spacing});
                if (gap < least_m) of.cuts.push_back(at);
            }
        };
        sides(along_u, to.x, reach(chart.frame.x));
        sides(along_v, to.y, reach(chart.frame.y));
    }
};

struct Place {
    std::size_t index; // of the line below
    double share;      // of the line above
};

Place place_among(const std::vector<double>& lines, double x) {
    const auto above = std::upper_bound(lines.begin(), lines.end(), x);
    const auto index = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - lines.begin() - 1, 0, static_cast<std::ptrdiff_t>(lines.size()) - 2));
    const double width = lines[index + 1] - lines[index];
    return {index, width > 0.0 ? std::clamp((x - lines[index]) / width, 0.0, 1.0) : 0.0};
}

} // namespace

NodeGrid::NodeGrid(const Stage& stage, const Charts& charts, std::size_t chart_index, double square_m,
                   double coarseness, std::vector<Node>& nodes)
    : first_(static_cast<std::uint32_t>(nodes.size())) {
    const Chart& chart = charts.all()[chart_index];
    is_round_ = chart.kind == Chart::Kind::round;
    const double widest_m = widest * square_m * coarseness;
    const double inset = 1e-3 * square_m;
    if (is_round_) {
        const double spacing = std::min(widest_m, chart.radius / 4.0 * coarseness);
        const double around = 2.0 * std::numbers::pi * chart.radius / spacing;
        const auto columns = static_cast<std::size_t>(std::clamp(std::ceil(around), 8.0, 64.0));
        for (std::size_t i = 0; i <= columns; ++i)
            columns_.push_back(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(columns));
        const double length = chart.v.high - chart.v.low;
        const auto rows = static_cast<std::size_t>(std::clamp(std::ceil(length / spacing), 4.0, 400.0));
        for (std::size_t i = 0; i <= rows; ++i)
            rows_.push_back(chart.v.low + length * static_cast<double>(i) / static_cast<double>(rows));
    } else {
        Spacing along_u{chart.u, widest_m, {}, {}};
        Spacing along_v{chart.v, widest_m, {}, {}};
        const double least_m = narrowest * square_m * coarseness;
        if (!chart.endless)
            for (Spacing* const along : {&along_u, &along_v})
                for (const double end : {along->range.low, along->range.high})
                    along->gradings.push_back({end, end, least_m});
        const Closeness close{chart, least_m, along_u, along_v};
        for (std::size_t i = 0; i < stage.surfaces.size(); ++i)
            if (i != chart.surface) std::visit(close, stage.surfaces[i].geometry);
        columns_ = lines_of(along_u, inset);
        rows_ = lines_of(along_v, inset);
    }
    const double lift_m = Patches::lift(square_m);
    for (std::size_t row = 0; row < rows_.size(); ++row)
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const glm::dvec2 at(columns_[column], rows_[row]);
            Node node;
            node.surface = chart.surface;
            node.normal = chart.normal(at);
            node.position = chart.position(at) + lift_m * node.normal;
            node.covered = Patches::is_covered(stage, chart.surface, node.position, node.normal, lift_m);
            const auto row_start = static_cast<std::uint32_t>(nodes.size() - column);
            const bool at_pole = is_round_ && (row == 0 || row + 1 == rows_.size());
            const bool closes = is_round_ && column + 1 == columns_.size();
            node.same_as = at_pole || closes ? row_start : static_cast<std::uint32_t>(nodes.size());
            nodes.push_back(node);
        }
}

NodeMean NodeGrid::around(const Chart& chart, const glm::dvec3& position, const std::vector<Node>& nodes) const {
    const glm::dvec2 at = chart.coordinates(position);
    const Place column = place_among(columns_, at.x);
    const Place row = place_among(rows_, at.y);
    NodeMean mean;
    double sum = 0.0;
    const auto add = [&](std::size_t c, std::size_t r, double weight) {
        const auto node = first_ + static_cast<std::uint32_t>(r * columns_.size() + c);
        if (nodes[node].covered || !(weight > 0.0)) return;
        mean.node[mean.count] = node;
        mean.weight[mean.count++] = weight;
        sum += weight;
    };
    add(column.index, row.index, (1.0 - column.share) * (1.0 - row.share));
    add(column.index + 1, row.index, column.share * (1.0 - row.share));
    add(column.index, row.index + 1, (1.0 - column.share) * row.share);
    add(column.index + 1, row.index + 1, column.share * row.share);
    // All covered: the nearest ring around the cell that has a free node.
    for (std::ptrdiff_t ring = 1; mean.count == 0 && ring < 4; ++ring)
        for (std::ptrdiff_t r = -ring; r <= 1 + ring && mean.count == 0; ++r)
            for (std::ptrdiff_t c = -ring; c <= 1 + ring && mean.count == 0; ++c) {
                const std::ptrdiff_t of_column = static_cast<std::ptrdiff_t>(column.index) + c;
                const std::ptrdiff_t of_row = static_cast<std::ptrdiff_t>(row.index) + r;
                if (of_column < 0 || of_row < 0 || of_column >= static_cast<std::ptrdiff_t>(columns_.size()) ||
                    of_row >= static_cast<std::ptrdiff_t>(rows_.size()))
                    continue;
                add(static_cast<std::size_t>(of_column), static_cast<std::size_t>(of_row), 1.0);
            }
    for (std::size_t i = 0; i < mean.count; ++i)
        mean.weight[i] /= sum;
    return mean;
}

} // namespace gonio::detail
