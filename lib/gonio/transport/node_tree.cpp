#include <gonio/scene/figure.hpp>
#include <gonio/transport/light_tree.hpp>
#include <gonio/transport/node_tree.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/spacing.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

namespace gonio::detail {

namespace {

// Distances in squares, the size of a patch.
constexpr double widest = 2.8;
constexpr double narrowest = 0.25;
constexpr double inset = 1e-3; // of the nodes at edges

constexpr double per_radius = 4.2;       // distances between the nodes of a sphere
constexpr double near_solid = 0.25;      // of its radius, between nodes that it touches
constexpr double at_figure = 4.0;        // times as far apart on and beside the scale figure
constexpr double near_sheet = 0.25;      // of the radius of the sphere that touches it
constexpr double least_near_thin = 0.1;  // squares
constexpr double growth = 0.4;           // with the distance from a solid
constexpr double near_light = 1.0 / 3.0; // of the distance from a light
constexpr double near_contact = 0.6;     // of the distance along the surface from where something round touches,
constexpr double least_at_contact = 0.1; // and at least this share of its radius

// What brings nodes closer together, besides edges.
struct Attraction {
    const Primitive* geometry;
    double spacing_m; // where it touches the chart
    double radius_m;  // of what is round where they touch; 0: neither is
};

std::vector<LightSphere> points_of(std::span<const LightPlace> lights) {
    std::vector<LightSphere> points;
    for (const LightPlace& light : lights)
        points.push_back({light.position, 0.0, static_cast<std::uint32_t>(points.size())});
    return points;
}

// The radius of the thinnest part.
std::optional<double> size_of(const Primitive& geometry) {
    if (const auto* ball = std::get_if<Ball>(&geometry)) return ball->radius;
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) return capsule->radius;
    if (const auto* box = std::get_if<Box>(&geometry))
        return std::min({box->half_size.x, box->half_size.y, box->half_size.z});
    return std::nullopt;
}

} // namespace

class NodeTreeMaker {
public:
    NodeTreeMaker(NodeTree& tree, const Stage& stage, std::span<const LightPlace> lights, const Chart& chart,
                  double square_m, double coarseness, std::vector<Node>& nodes)
        : tree_(tree),
          stage_(stage),
          lights_(lights),
          light_tree_(points_of(lights)),
          chart_(chart),
          is_round_(chart.kind == Chart::Kind::round),
          widest_m_(widest * square_m * coarseness),
          least_m_(narrowest * square_m * coarseness),
          lift_m_(Patches::lift(square_m)),
          square_m_(square_m),
          coarseness_(coarseness),
          nodes_(nodes) {}

    void make() {
        add_roots();
        find_attractions();
        for (std::uint32_t part = 0; part < tree_.parts_.size(); ++part)
            divide(part);
        if (tree_.parts_.size() > roots_)
            for (std::size_t i = 0; i < nodes_.size(); ++i)
                find_ends(static_cast<std::uint32_t>(i));
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (nodes_[i].gathers() && !nodes_[i].is_pole)
                for (const int axis : {0, 1})
                    find_slope(static_cast<std::uint32_t>(i), axis);
        if (is_round_) find_slopes_of_poles();
    }

private:
    struct Extent {
        glm::dvec2 low{0.0}, high{0.0};
    };

    void add_roots() {
        if (is_round_) {
            const double spacing_m =
                std::min(widest_m_, chart_.radius / per_radius * coarseness_ * widening(chart_.surface));
            const auto add = [](std::vector<double>& lines, double low, double high, double count) {
                for (double i = lines.empty() ? 0.0 : 1.0; i <= count; i += 1.0)
                    lines.push_back(i == count ? high : low + (high - low) * i / count);
            };
            std::vector<double> around;
            add(around, chart_.u.low, chart_.u.high,
                std::clamp(std::ceil(2.0 * std::numbers::pi * chart_.radius / spacing_m), 8.0, 64.0));
            const double quarter_m = 0.5 * std::numbers::pi * chart_.radius;
            const double of_quarter = std::clamp(std::ceil(quarter_m / spacing_m), 2.0, 32.0);
            std::vector<double> along;
            add(along, chart_.v.low, quarter_m, of_quarter);
            if (chart_.half_length > 0.0)
                add(along, quarter_m, chart_.v.high - quarter_m,
                    std::clamp(std::ceil(2.0 * chart_.half_length / widest_m_), 1.0, 400.0));
            add(along, chart_.v.high - quarter_m, chart_.v.high, of_quarter);
            tree_.columns_ = Axis(std::move(around));
            tree_.rows_ = Axis(std::move(along));
        } else {
            const SpacingPair spacing = spacing_of_nodes(stage_, chart_, widest_m_, least_m_);
            tree_.columns_ = Axis(lines_of(spacing.u, inset * square_m_));
            tree_.rows_ = Axis(lines_of(spacing.v, inset * square_m_));
            tree_.gap_m_ = 2.5 * inset * square_m_;
        }
        for (std::uint32_t row = 0; row < tree_.rows_.intervals(); ++row)
            for (std::uint32_t column = 0; column < tree_.columns_.intervals(); ++column)
                add_part({{tree_.columns_.line(column), tree_.rows_.line(row)},
                          {tree_.columns_.line(column + 1), tree_.rows_.line(row + 1)}});
        roots_ = tree_.parts_.size();
    }

    void add_part(const Extent& extent) {
        NodeTree::Part part;
        part.corner = {node_at({extent.low.x, extent.low.y}), node_at({extent.high.x, extent.low.y}),
                       node_at({extent.low.x, extent.high.y}), node_at({extent.high.x, extent.high.y})};
        tree_.parts_.push_back(part);
        extents_.push_back(extent);
    }

    // On a sphere both ends of a row are one node, and each pole.
    std::uint32_t node_at(glm::dvec2 at) {
        if (is_round_ && (at.x == chart_.u.high || at.y == chart_.v.low || at.y == chart_.v.high)) at.x = chart_.u.low;
        const auto [found, is_new] =
            node_by_place_.try_emplace({at.x, at.y}, static_cast<std::uint32_t>(nodes_.size()));
        if (is_new) {
            Node node;
            node.surface = chart_.surface;
            node.normal = chart_.normal(at);
            node.position = chart_.position(at) + lift_m_ * node.normal;
            node.covered = Patches::is_covered(stage_, chart_.surface, node.position, node.normal, lift_m_);
            node.is_pole = is_round_ && (at.y == chart_.v.low || at.y == chart_.v.high);
            nodes_.push_back(node);
            places_.push_back(at);
        }
        return found->second;
    }

    void find_attractions() {
        for (std::size_t i = 0; i < stage_.surfaces.size(); ++i) {
            if (i == chart_.surface) continue;
            const Primitive& geometry = stage_.surfaces[i].geometry;
            const std::optional<double> size = size_of(geometry);
            if (size && std::holds_alternative<Box>(geometry) && !is_round_ && touches(geometry)) continue; // an edge
            if (!size && !is_round_) continue; // edges, and sheets far away
            const double wider = std::max(widening(i), widening(chart_.surface));
            const double spacing_m = wider * (size && is_round_ ? near_solid * std::min(*size, chart_.radius)
                                              : size            ? near_solid * *size
                                                                : near_sheet * chart_.radius);
            attractions_.push_back({&geometry, coarseness_ * std::max(spacing_m, least_near_thin * square_m_),
                                    wider > 1.0 ? 0.0 : contact_radius(geometry)});
        }
    }

    double widening(std::size_t surface) const { return is_of_figure(stage_.surfaces[surface]) ? at_figure : 1.0; }

    // Of a sphere with the gap at every distance that these two have where they touch.
    double contact_radius(const Primitive& other) const {
        const auto* const ball = std::get_if<Ball>(&other);
        const bool is_ball = is_round_ && chart_.half_length == 0.0;
        if (is_ball && is_sheet(other)) return chart_.radius;
        if (ball == nullptr) return 0.0;
        return is_ball ? ball->radius * chart_.radius / (ball->radius + chart_.radius) : is_round_ ? 0.0 : ball->radius;
    }

    bool touches(const Primitive& geometry) const {
        const Box& box = std::get<Box>(geometry);
        const double reach = box.half_size.x * std::abs(glm::dot(box.frame.x, chart_.frame.z)) +
                             box.half_size.y * std::abs(glm::dot(box.frame.y, chart_.frame.z)) +
                             box.half_size.z * std::abs(glm::dot(box.frame.z, chart_.frame.z));
        return std::abs(glm::dot(box.frame.origin - chart_.frame.origin, chart_.frame.z)) < reach + least_m_;
    }

    // How far apart nodes may lie in a part, if that is less than the part's longest side; if it is less than the
    // shortest one, perhaps more than that.
    double spacing_in(const glm::dvec3& middle, const glm::dvec3& normal, double half_diagonal_m, double shortest_m,
                      double longest_m) const {
        double spacing_m = std::numeric_limits<double>::infinity();
        for (const Attraction& attraction : attractions_) {
            const double gap_m = distance_to_surface(*attraction.geometry, middle);
            spacing_m = std::min(spacing_m, attraction.spacing_m + growth * std::max(gap_m - half_diagonal_m, 0.0));
            if (!(gap_m < attraction.radius_m)) continue;
            // Near a contact the gap at s is s²/(2r).
            const double from_contact_m = std::sqrt(2.0 * attraction.radius_m * gap_m) - half_diagonal_m;
            spacing_m = std::min(spacing_m, coarseness_ * std::max(least_at_contact * attraction.radius_m,
                                                                   near_contact * from_contact_m));
        }
        // Any farther away lets parts be as long as this one is, or as the spacing is already.
        const auto reach_m = [&] {
            constexpr double rounding = 1.0 + 1e-9;
            return rounding * (half_diagonal_m + std::min(longest_m, spacing_m) / (coarseness_ * near_light));
        };
        light_tree_.visit_near({middle, normal, half_diagonal_m}, reach_m(), [&](std::uint32_t light) {
            const glm::dvec3 to = lights_[light].position - middle;
            const bool is_behind = glm::dot(to, normal) + half_diagonal_m < 0.0;
            if (!is_behind && lights_[light].may_light(middle, half_diagonal_m)) {
                const double away_m = std::max(glm::length(to) - half_diagonal_m, 0.5 * least_m_);
                spacing_m = std::min(spacing_m, coarseness_ * near_light * away_m);
            }
            return spacing_m < shortest_m ? -1.0 : reach_m(); // the part is divided both ways
        });
        return spacing_m;
    }

    void divide(std::uint32_t part) {
        constexpr std::size_t most_parts = 40000;
        if (tree_.parts_.size() > most_parts) return;
        const Extent extent = extents_[part];
        const glm::dvec2 size = extent.high - extent.low;
        if (tree_.gap_m_ > 0.0 && std::min(size.x, size.y) < tree_.gap_m_) return;
        const glm::dvec2 at = 0.5 * (extent.low + extent.high);
        const glm::dvec3 middle = chart_.position(at);
        // Of the rectangle's sides [m].
        const double width_m =
            is_round_ ? glm::distance(chart_.position({extent.low.x, at.y}), chart_.position({extent.high.x, at.y}))
                      : size.x;
        const double height_m = size.y;
        const double spacing_m = spacing_in(middle, chart_.normal(at), 0.5 * std::hypot(width_m, height_m),
                                            std::min(width_m, height_m), std::max(width_m, height_m));
        const bool along_u = width_m > spacing_m;
        const bool along_v = height_m > spacing_m;
        if (!along_u && !along_v) return;
        const NodeTree::Part& whole = tree_.parts_[part];
        if (nodes_[whole.corner[0]].covered && nodes_[whole.corner[1]].covered && nodes_[whole.corner[2]].covered &&
            nodes_[whole.corner[3]].covered)
            return;
        tree_.parts_[part].along_u = along_u;
        tree_.parts_[part].along_v = along_v;
        tree_.parts_[part].first_part = static_cast<std::uint32_t>(tree_.parts_.size());
        for (int v = 0; v < (along_v ? 2 : 1); ++v)
            for (int u = 0; u < (along_u ? 2 : 1); ++u)
                add_part({{u == 0 ? extent.low.x : at.x, v == 0 ? extent.low.y : at.y},
                          {along_u && u == 0 ? at.x : extent.high.x, along_v && v == 0 ? at.y : extent.high.y}});
    }

    // The rectangle beside a place on its boundary, in one of four directions.
    std::optional<std::uint32_t> leaf_beside(const glm::dvec2& at, bool above_u, bool above_v) const {
        const auto root = [](const Axis& axis, double x, bool above) -> std::optional<std::uint32_t> {
            const std::uint32_t in = axis.index(x);
            if (above) return x < axis.line(axis.intervals()) ? std::optional(in) : std::nullopt;
            if (x > axis.line(in)) return in;
            return in > 0 ? std::optional(in - 1) : std::nullopt;
        };
        const std::optional<std::uint32_t> column = root(tree_.columns_, at.x, above_u);
        const std::optional<std::uint32_t> row = root(tree_.rows_, at.y, above_v);
        if (!column || !row) return std::nullopt;
        std::uint32_t part = *row * tree_.columns_.intervals() + *column;
        while (tree_.parts_[part].first_part != 0) {
            const NodeTree::Part& whole = tree_.parts_[part];
            const glm::dvec2 middle = 0.5 * (extents_[part].low + extents_[part].high);
            const bool high_u = whole.along_u && (above_u ? at.x >= middle.x : at.x > middle.x);
            const bool high_v = whole.along_v && (above_v ? at.y >= middle.y : at.y > middle.y);
            part = whole.first_part + (high_v ? (whole.along_u ? 2U : 1U) : 0U) + (high_u ? 1U : 0U);
        }
        return part;
    }

    void find_ends(std::uint32_t index) {
        const glm::dvec2 at = places_[index];
        if (is_round_ && (at.y == chart_.v.low || at.y == chart_.v.high)) return;
        for (const bool seam : {false, true}) {
            if (seam && !(is_round_ && at.x == chart_.u.low)) continue;
            const glm::dvec2 here(seam ? chart_.u.high : at.x, at.y);
            for (const bool above_v : {false, true})
                for (const bool above_u : {false, true})
                    if (const std::optional<std::uint32_t> leaf = leaf_beside(here, above_u, above_v);
                        leaf && take_ends(index, here, *leaf))
                        return;
        }
    }

    bool take_ends(std::uint32_t index, const glm::dvec2& at, std::uint32_t leaf) {
        const std::array<std::uint32_t, 4>& corner = tree_.parts_[leaf].corner;
        if (std::find(corner.begin(), corner.end(), index) != corner.end()) return false;
        const Extent& extent = extents_[leaf];
        // Between the two lines of a cut, where nothing is interpolated.
        if (std::min(extent.high.x - extent.low.x, extent.high.y - extent.low.y) < tree_.gap_m_) return false;
        std::array<std::uint32_t, 2> ends{};
        double share = 0.0;
        if (at.y == extent.low.y || at.y == extent.high.y) {
            const std::size_t row = at.y == extent.low.y ? 0 : 2;
            ends = {corner.at(row), corner.at(row + 1)};
            share = (at.x - extent.low.x) / (extent.high.x - extent.low.x);
        } else {
            const std::size_t column = at.x == extent.low.x ? 0 : 1;
            ends = {corner.at(column), corner.at(column + 2)};
            share = (at.y - extent.low.y) / (extent.high.y - extent.low.y);
        }
        if (nodes_[index].covered || nodes_[ends[0]].covered || nodes_[ends[1]].covered) return true; // gathers itself
        nodes_[index].ends = ends;
        nodes_[index].share = share;
        nodes_[index].axis = at.y == extent.low.y || at.y == extent.high.y ? 0 : 1;
        nodes_[index].length = extent.high[nodes_[index].axis] - extent.low[nodes_[index].axis];
        return true;
    }

    struct Beside {
        std::uint32_t node = Node::none;
        double distance = 0.0; // along the axis
    };

    // The nearest node that gathers, along an axis, on one side of a place that is the corner of a rectangle there.
    // None beyond a cut and what is covered.
    Beside beside(std::uint32_t index, int axis, bool above) const {
        glm::dvec2 at = places_[index];
        double distance = 0.0;
        constexpr int most_steps = 4; // over nodes between others
        for (int step = 0; step < most_steps; ++step) {
            if (is_round_ && axis == 0) {
                if (above && at.x == chart_.u.high) at.x = chart_.u.low;
                if (!above && at.x == chart_.u.low) at.x = chart_.u.high;
            }
            double nearest = std::numeric_limits<double>::infinity();
            std::uint32_t found = Node::none;
            for (const bool across : {false, true}) {
                const std::optional<std::uint32_t> leaf =
                    axis == 0 ? leaf_beside(at, above, across) : leaf_beside(at, across, above);
                if (!leaf) continue;
                const Extent& extent = extents_[*leaf];
                const glm::dvec2 low = extent.low;
                const glm::dvec2 high = extent.high;
                const int other = 1 - axis;
                const bool is_corner = (above ? at[axis] == low[axis] : at[axis] == high[axis]) &&
                                       (at[other] == low[other] || at[other] == high[other]);
                const double size = high[axis] - low[axis];
                if (!is_corner || size >= nearest || size < tree_.gap_m_) continue;
                const std::size_t beyond = above ? 1 : 0;
                const std::size_t aside = at[other] == high[other] ? 1 : 0;
                const std::uint32_t node =
                    tree_.parts_[*leaf].corner.at(axis == 0 ? 2 * aside + beyond : 2 * beyond + aside);
                if (nodes_[node].covered) continue;
                nearest = size;
                found = node;
            }
            if (found == Node::none) return {};
            distance += nearest;
            if (nodes_[found].gathers()) return {found, distance};
            at[axis] += above ? nearest : -nearest;
            at = {axis == 0 ? places_[found].x : at.x, axis == 1 ? places_[found].y : at.y};
        }
        return {};
    }

    // Exact for quadratic functions, with two nodes beside it; with one, what keeps a line straight.
    void find_slope(std::uint32_t index, int axis) {
        const Beside low = beside(index, axis, false);
        const Beside high = beside(index, axis, true);
        const auto add = [&](std::uint32_t from, double weight) {
            SlopeTerm term{index, from, glm::dvec2(0.0)};
            term.weight[axis] = weight;
            tree_.slopes_.push_back(term);
        };
        if (low.node != Node::none && high.node != Node::none) {
            const double both = low.distance + high.distance;
            add(low.node, -high.distance / (low.distance * both));
            add(high.node, low.distance / (high.distance * both));
        } else if (low.node != Node::none) {
            add(low.node, -1.0 / low.distance);
        } else if (high.node != Node::none) {
            add(high.node, 1.0 / high.distance);
        }
    }

    // The first harmonic of the nodes around each pole.
    void find_slopes_of_poles() {
        for (std::size_t part = 0; part < tree_.parts_.size(); ++part) {
            const NodeTree::Part& leaf = tree_.parts_[part];
            if (leaf.first_part != 0) continue;
            const Extent& extent = extents_[part];
            for (const bool above : {false, true}) {
                if (above ? extent.high.y != chart_.v.high : extent.low.y != chart_.v.low) continue;
                const std::uint32_t pole = leaf.corner.at(above ? 2 : 0);
                if (!nodes_[pole].gathers()) continue;
                const double half =
                    0.5 * (extent.high.x - extent.low.x) / (std::numbers::pi * (extent.high.y - extent.low.y));
                for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
                    const double azimuth = side == 0 ? extent.low.x : extent.high.x;
                    add_to_pole(pole, leaf.corner.at((above ? 0 : 2) + side),
                                half * glm::dvec2(std::cos(azimuth), std::sin(azimuth)));
                }
            }
        }
    }

    void add_to_pole(std::uint32_t pole, std::uint32_t from, const glm::dvec2& weight) {
        const Node& node = nodes_[from];
        if (node.covered) return;
        if (!node.is_between()) {
            tree_.slopes_.push_back({pole, from, weight});
            return;
        }
        add_to_pole(pole, node.ends[0], (1.0 - node.share) * weight);
        add_to_pole(pole, node.ends[1], node.share * weight);
    }

    NodeTree& tree_;
    const Stage& stage_;
    std::span<const LightPlace> lights_;
    LightTree light_tree_;
    const Chart& chart_;
    bool is_round_;
    double widest_m_, least_m_, lift_m_, square_m_, coarseness_;
    std::vector<Node>& nodes_;
    std::size_t roots_ = 0;
    std::vector<Extent> extents_;    // of the parts
    std::vector<glm::dvec2> places_; // of the nodes
    std::map<std::pair<double, double>, std::uint32_t> node_by_place_;
    std::vector<Attraction> attractions_;
};

NodeTree::NodeTree(const Stage& stage, std::span<const LightPlace> lights, const Chart& chart, double square_m,
                   double coarseness, std::vector<Node>& nodes) {
    NodeTreeMaker(*this, stage, lights, chart, square_m, coarseness, nodes).make();
}

void NodeTree::append(std::span<const Node> made, std::vector<Node>& nodes, std::vector<SlopeTerm>& slopes) {
    const auto first = static_cast<std::uint32_t>(nodes.size());
    for (const SlopeTerm& term : slopes_)
        slopes.push_back({term.of + first, term.from + first, term.weight});
    slopes_ = {};
    for (Part& part : parts_)
        for (std::size_t i = 0; i < part.corner.size(); ++i) {
            part.is_covered[i] = made[part.corner[i]].covered;
            part.is_pole[i] = made[part.corner[i]].is_pole;
            part.corner[i] += first;
        }
    for (Node node : made) {
        if (node.is_between())
            for (std::uint32_t& end : node.ends)
                end += first;
        nodes.push_back(node);
    }
}

NodeTree::Spot NodeTree::spot(const glm::dvec2& at, Leaf& last) const {
    if (last.part != Leaf::none) {
        const double u = columns_.share(last.column, at.x) * last.per.x - last.first.x;
        const double v = rows_.share(last.row, at.y) * last.per.y - last.first.y;
        if (u >= 0.0 && u < 1.0 && v >= 0.0 && v < 1.0) return {last.part, u, v, last.size};
    }
    struct Place {
        std::uint32_t index;
        double share;
    };
    const auto place = [&](const Axis& axis, double x) {
        const std::uint32_t in = axis.index(x);
        const double width = axis.line(in + 1) - axis.line(in);
        const double share = width > 0.0 ? std::clamp(axis.share(in, x), 0.0, 1.0) : 0.0;
        if (width >= gap_m_ || axis.intervals() < 3) return Place{in, share};
        // Between the two lines of a cut: the nearer one.
        return share < 0.5 ? Place{in - 1, 1.0} : Place{in + 1, 0.0};
    };
    const Place column = place(columns_, at.x);
    const Place row = place(rows_, at.y);
    Spot spot{row.index * columns_.intervals() + column.index,
              column.share,
              row.share,
              {columns_.line(column.index + 1) - columns_.line(column.index),
               rows_.line(row.index + 1) - rows_.line(row.index)}};
    last = {0, column.index, row.index, glm::dvec2(1.0), glm::dvec2(0.0), glm::dvec2(0.0)};
    const auto halve = [&](double& share, double& size, int axis) {
        const bool high = share >= 0.5;
        share = 2.0 * share - (high ? 1.0 : 0.0);
        size *= 0.5;
        last.per[axis] *= 2.0;
        last.first[axis] = 2.0 * last.first[axis] + (high ? 1.0 : 0.0);
        return high;
    };
    while (parts_[spot.part].first_part != 0) {
        const Part& whole = parts_[spot.part];
        std::uint32_t next = whole.first_part;
        if (whole.along_v && halve(spot.v, spot.size.y, 1)) next += whole.along_u ? 2 : 1;
        if (whole.along_u && halve(spot.u, spot.size.x, 0)) ++next;
        spot.part = next;
    }
    last.part = spot.part;
    last.size = spot.size;
    return spot;
}

NodeMean NodeTree::around(const Chart& chart, const glm::dvec3& position, Leaf& last) const {
    const glm::dvec2 place = chart.coordinates(position);
    const Spot in = spot(place, last);
    const std::array<double, 4> weight{(1.0 - in.u) * (1.0 - in.v), in.u * (1.0 - in.v), (1.0 - in.u) * in.v,
                                       in.u * in.v};
    NodeMean mean;
    double sum = 0.0;
    const auto add = [&](const Part& part, std::size_t i, double of, const glm::dvec2& from_node) {
        if (part.is_covered[i] || !(of > 0.0)) return;
        mean.node[mean.count] = part.corner[i];
        mean.of_slopes[mean.count] = 0.5 * of * from_node;
        mean.weight[mean.count++] = of;
        sum += of;
    };
    const Part& here = parts_[in.part];
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 from_node = in.size * glm::dvec2(in.u - (i % 2 == 1 ? 1.0 : 0.0), in.v - (i > 1 ? 1.0 : 0.0));
        add(here, i, weight[i],
            here.is_pole[i] ? std::abs(from_node.y) * glm::dvec2(std::cos(place.x), std::sin(place.x)) : from_node);
    }
    // All covered: a free corner of the same rectangle, or of one around it.
    for (std::size_t i = 0; mean.count == 0 && i < 4; ++i)
        add(here, i, 1.0, glm::dvec2(0.0));
    if (mean.count == 0) {
        const std::int64_t columns = columns_.intervals();
        const std::int64_t rows = rows_.intervals();
        const std::int64_t column = columns_.index(place.x);
        const std::int64_t row = rows_.index(place.y);
        for (std::int64_t ring = 1; mean.count == 0 && ring < 4; ++ring)
            for (std::int64_t r = std::max<std::int64_t>(row - ring, 0); r <= std::min(row + ring, rows - 1); ++r)
                for (std::int64_t c = std::max<std::int64_t>(column - ring, 0);
                     c <= std::min(column + ring, columns - 1); ++c)
                    for (std::size_t i = 0; mean.count == 0 && i < 4; ++i)
                        add(parts_[static_cast<std::size_t>(r * columns + c)], i, 1.0, glm::dvec2(0.0));
    }
    if (sum == 1.0) return mean;
    for (std::size_t i = 0; i < mean.count; ++i) {
        mean.weight[i] /= sum;
        mean.of_slopes[i] /= sum;
    }
    return mean;
}

glm::dvec3 NodeMean::operator()(std::span<const NodeValue> of_nodes) const {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < count; ++i) {
        const NodeValue& of_node = of_nodes[node[i]];
        sum += weight[i] * of_node.value + of_slopes[i].x * of_node.slope[0] + of_slopes[i].y * of_node.slope[1];
    }
    // Beside a steep rise the curve between nodes passes below what light can be.
    return glm::max(sum, glm::dvec3(0.0));
}

} // namespace gonio::detail
