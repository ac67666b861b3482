#include <gonio/scene/figure.hpp>
#include <gonio/transport/spacing.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace gonio::detail {

namespace {

// Beyond the core of a range lines lie farther apart in proportion to the distance from it.
constexpr double growth_of_nodes_beyond = 0.3;
constexpr double growth_of_patches_beyond = 0.15;
constexpr double growth_of_nodes = 0.8;
constexpr double growth_of_patches = 0.2;

// Patches below a light at distance d are d times this: its light changes by a few per cent from one to the next.
constexpr double patches_by_distance = 0.2;
constexpr double patches_by_radius = 0.25;  // at the foot of a solid of this radius
constexpr double patches_at_contact = 0.08; // of the radius, where something round touches
constexpr double touching = 0.1;            // of the radius: a gap that counts as a contact
constexpr double patches_at_edges = 0.3;    // of other surfaces, in squares

constexpr double growth_of_nodes_beside = 0.25; // a low box: what it sends falls with the square of the distance
constexpr double by_height = 0.25;              // of a box, between nodes beside it
constexpr double patches_by_height = 0.05;      // between patches
constexpr double nodes_beside = 0.05;           // and at least, in the distance at edges
constexpr double patches_beside = 0.2;

constexpr double least_spacing = 0.04; // of patches, in squares

// Lines from `low` to `high`.
void add_lines(double low, double high, double inset, const Spacing& spacing, std::vector<double>& lines) {
    std::vector<double> steps{low};
    constexpr std::size_t most = 2000;
    while (steps.back() < high && steps.size() < most) {
        const double x = steps.back();
        const double there = spacing(std::min(x + 0.5 * spacing(x), high));
        steps.push_back(x + std::max(there, 1e-12 * std::abs(x)));
    }
    const std::size_t last = steps.size() - 1;
    if (const double reached = steps.back(); reached < high) {
        for (double& step : steps)
            step = low + (step - low) / (reached - low) * (high - low);
        steps.back() = high;
    }
    // The last step ends beyond: all are shortened alike.
    const double steps_needed =
        static_cast<double>(last - 1) + (high - steps[last - 1]) / (steps[last] - steps[last - 1]);
    if (lines.empty() || inset > 0.0) lines.push_back(low + inset);
    for (std::size_t i = 1; i < last; ++i) {
        const double step = steps_needed * static_cast<double>(i) / static_cast<double>(last);
        const auto whole = static_cast<std::size_t>(step);
        lines.push_back(steps[whole] + (step - static_cast<double>(whole)) * (steps[whole + 1] - steps[whole]));
    }
    lines.push_back(high - inset);
}

// What another surface does to the lines of nodes.
struct Edges {
    const Chart& chart;
    double touching_m;   // what is farther away does not touch
    double least_m;      // distance between lines at an edge; 0: it is a cut alone
    double least_beside; // and beside a low box, in these
    SpacingPair& pair;

    void edge(Spacing& spacing, double at, double spacing_m,
              double growth = std::numeric_limits<double>::infinity()) const {
        if (least_m > 0.0) spacing.gradings.push_back({at, at, spacing_m, growth});
        spacing.cuts.push_back(at);
    }

    // A one-sided surface across this one: an edge where it is perpendicular to an axis of the chart.
    void sheet(const glm::dvec3& point, const glm::dvec3& normal) const {
        const glm::dvec3 to = point - chart.frame.origin;
        if (std::abs(glm::dot(normal, chart.frame.x)) > 1.0 - 1e-9) edge(pair.u, glm::dot(to, chart.frame.x), least_m);
        if (std::abs(glm::dot(normal, chart.frame.y)) > 1.0 - 1e-9) edge(pair.v, glm::dot(to, chart.frame.y), least_m);
    }
    void operator()(const Plane& plane) const { sheet(plane.point, plane.normal); }
    void operator()(const Panel& panel) const {
        const glm::dvec3 to = panel.frame.origin - chart.frame.origin;
        const double reach = 0.5 * (panel.width * std::abs(glm::dot(panel.frame.x, chart.frame.z)) +
                                    panel.height * std::abs(glm::dot(panel.frame.y, chart.frame.z)));
        if (std::abs(glm::dot(to, chart.frame.z)) > reach + touching_m) return; // does not touch it
        sheet(panel.frame.origin, panel.frame.z);
    }
    void operator()(const Box& box) const {
        const glm::dvec3 to = chart.frame.to_local(box.frame.origin - chart.frame.origin);
        const auto reach = [&](const glm::dvec3& axis) {
            return box.half_size.x * std::abs(glm::dot(box.frame.x, axis)) +
                   box.half_size.y * std::abs(glm::dot(box.frame.y, axis)) +
                   box.half_size.z * std::abs(glm::dot(box.frame.z, axis));
        };
        if (to.z + reach(chart.frame.z) < 0.0) return; // behind
        if (std::max(to.z - reach(chart.frame.z), 0.0) >= touching_m) return;
        const double spacing_m = std::clamp(by_height * (to.z + reach(chart.frame.z)), least_beside * least_m, least_m);
        const double growth = spacing_m < least_m ? growth_of_nodes_beside : std::numeric_limits<double>::infinity();
        const auto sides = [&](Spacing& of, double middle, double half) {
            edge(of, middle - half, spacing_m, growth);
            edge(of, middle + half, spacing_m, growth);
        };
        sides(pair.u, to.x, reach(chart.frame.x));
        sides(pair.v, to.y, reach(chart.frame.y));
    }
    template<class Round>
    void operator()(const Round& /*has no straight edge*/) const {}
};

// What a solid does to the lines of patches: it shades and reflects light close to its foot.
struct Feet {
    const Chart& chart;
    double widest_m;
    double coarseness;
    SpacingPair& pair;

    void add(const glm::dvec3& center, const glm::dvec3& reach, double size) const {
        const glm::dvec3 to = chart.frame.to_local(center - chart.frame.origin);
        if (to.z + reach.z < 0.0) return; // behind
        const double spacing_m = std::max(0.5 * (to.z - reach.z), coarseness * patches_by_radius * size);
        if (size < 0.25 * widest_m) {
            if (to.z - reach.z <= touching * size) foot_of_small(to);
            return;
        }
        if (spacing_m >= widest_m) return;
        pair.u.gradings.push_back({to.x - reach.x, to.x + reach.x, spacing_m});
        pair.v.gradings.push_back({to.y - reach.y, to.y + reach.y, spacing_m});
        if (std::abs(to.z - reach.z) > touching * size) return;
        const glm::dvec3 half = reach - size;
        pair.u.gradings.push_back({to.x - half.x, to.x + half.x, coarseness * patches_at_contact * size});
        pair.v.gradings.push_back({to.y - half.y, to.y + half.y, coarseness * patches_at_contact * size});
    }
    // Light before a pole and its shadow behind lie in patches of their own.
    void foot_of_small(const glm::dvec3& to) const {
        pair.u.cuts.push_back(to.x);
        pair.v.cuts.push_back(to.y);
    }
    void operator()(const Ball& ball) const { add(ball.center, glm::dvec3(ball.radius), ball.radius); }
    void operator()(const Capsule& capsule) const {
        const glm::dvec3 half = capsule.half_length * chart.frame.to_local(capsule.axis);
        add(capsule.center, glm::abs(half) + capsule.radius, capsule.radius);
    }
    void operator()(const Box& box) const {
        const glm::dvec3 to = chart.frame.to_local(box.frame.origin - chart.frame.origin);
        const glm::dvec3 reach = box.half_size.x * glm::abs(chart.frame.to_local(box.frame.x)) +
                                 box.half_size.y * glm::abs(chart.frame.to_local(box.frame.y)) +
                                 box.half_size.z * glm::abs(chart.frame.to_local(box.frame.z));
        if (to.z + reach.z < 0.0) return; // behind
        const double spacing_m =
            std::max(0.5 * (to.z - reach.z),
                     std::max(coarseness * patches_by_height * (to.z + reach.z), least_spacing * widest_m));
        if (spacing_m >= widest_m) return;
        for (const double side : {-1.0, 1.0}) {
            pair.u.gradings.push_back({to.x + side * reach.x, to.x + side * reach.x, spacing_m});
            pair.v.gradings.push_back({to.y + side * reach.y, to.y + side * reach.y, spacing_m});
        }
    }
    template<class Sheet>
    void operator()(const Sheet& /*leaves sharp shadows elsewhere*/) const {}
};

} // namespace

double Spacing::operator()(double x) const {
    double spacing = widest_m;
    if (range.core > 0.0) {
        const double beyond = std::max(std::abs(x - range.middle) - range.core, 0.0);
        spacing += beyond * std::max(widest_m / range.core, growth_beyond);
    }
    for (const Grading& near : gradings) {
        const double away = std::max({near.low - x, x - near.high, 0.0});
        spacing = std::min(spacing, near.spacing_m + std::min(growth, near.growth) * away);
    }
    return spacing;
}

SpacingPair spacing_of_nodes(const Stage& stage, const Chart& chart, double widest_m, double least_m) {
    SpacingPair pair{{chart.u, widest_m, growth_of_nodes, growth_of_nodes_beyond, {}, {}},
                     {chart.v, widest_m, growth_of_nodes, growth_of_nodes_beyond, {}, {}}};
    if (!chart.endless)
        for (Spacing* const along : {&pair.u, &pair.v})
            for (const double end : {along->range.low, along->range.high})
                along->gradings.push_back({end, end, least_m});
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i)
        if (i != chart.surface)
            std::visit(Edges{chart, least_m, least_m, nodes_beside, pair}, stage.surfaces[i].geometry);
    return pair;
}

SpacingPair spacing_of_patches(const Stage& stage, std::span<const LightPlace> lights, const Chart& chart,
                               double widest_m, double coarseness) {
    SpacingPair pair{{chart.u, widest_m, growth_of_patches, growth_of_patches_beyond, {}, {}},
                     {chart.v, widest_m, growth_of_patches, growth_of_patches_beyond, {}, {}}};
    for (const LightPlace& light : lights) {
        const glm::dvec3 at = chart.frame.to_local(light.position - chart.frame.origin);
        if (!light.may_light(light.position - at.z * chart.frame.z, 0.5 * at.z)) continue;
        const double spacing_m = std::max(coarseness * patches_by_distance * at.z, least_spacing * widest_m);
        if (!(at.z > 0.0) || spacing_m >= widest_m) continue;
        pair.u.gradings.push_back({at.x, at.x, spacing_m});
        pair.v.gradings.push_back({at.y, at.y, spacing_m});
        // Where its light begins, a line lies between patches.
        constexpr double parallel = 1.0 - 1e-9;
        if (std::abs(glm::dot(light.side, chart.frame.x)) > parallel) pair.u.cuts.push_back(at.x);
        if (std::abs(glm::dot(light.side, chart.frame.y)) > parallel) pair.v.cuts.push_back(at.y);
    }
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i)
        if (i != chart.surface) {
            if (!is_of_figure(stage.surfaces[i]))
                std::visit(Feet{chart, widest_m, coarseness, pair}, stage.surfaces[i].geometry);
            std::visit(Edges{chart, 1e-3 * widest_m, patches_at_edges * widest_m, patches_beside, pair},
                       stage.surfaces[i].geometry);
        }
    return pair;
}

std::vector<double> lines_of(const Spacing& spacing, double inset_m) {
    std::vector<double> ends{spacing.range.low};
    std::vector<double> cuts = spacing.cuts;
    std::sort(cuts.begin(), cuts.end());
    const double least_m = inset_m > 0.0 ? 4.0 * inset_m : 0.02 * spacing.widest_m;
    inset_m = std::min(inset_m, 0.05 * (spacing.range.high - spacing.range.low));
    for (const double cut : cuts)
        if (cut > ends.back() + least_m && cut < spacing.range.high - least_m) ends.push_back(cut);
    ends.push_back(spacing.range.high);
    std::vector<double> lines;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        add_lines(ends[i], ends[i + 1], inset_m, spacing, lines);
    return lines;
}

double distance_to_surface(const Primitive& geometry, const glm::dvec3& point) {
    struct From {
        const glm::dvec3& point;

        double operator()(const Plane& plane) const { return std::abs(glm::dot(point - plane.point, plane.normal)); }
        static double beyond(const glm::dvec3& local, const glm::dvec3& half_size) {
            return glm::length(glm::max(glm::abs(local) - half_size, glm::dvec3(0.0)));
        }
        double operator()(const Panel& panel) const {
            return beyond(panel.frame.to_local(point - panel.frame.origin),
                          {0.5 * panel.width, 0.5 * panel.height, 0.0});
        }
        double operator()(const Box& box) const {
            return beyond(box.frame.to_local(point - box.frame.origin), box.half_size);
        }
        double operator()(const Ball& ball) const {
            return std::max(glm::distance(point, ball.center) - ball.radius, 0.0);
        }
        double operator()(const Capsule& capsule) const {
            const glm::dvec3 to = point - capsule.center;
            const double along = std::clamp(glm::dot(to, capsule.axis), -capsule.half_length, capsule.half_length);
            return std::max(glm::length(to - along * capsule.axis) - capsule.radius, 0.0);
        }
    };
    return std::visit(From{point}, geometry);
}

} // namespace gonio::detail
