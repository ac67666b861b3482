#include <gonio/base/parallel.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/transport/exchange_geometry.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::detail {

namespace {

std::vector<LightPlace> places_of(std::span<const Light> lights) {
    std::vector<LightPlace> places;
    for (const Light& light : lights) {
        if (std::holds_alternative<SunShape>(light.shape)) continue;
        const Radians cone =
            with_traits(light.shape, [](const auto& kind, auto traits) { return traits.half_cone(kind); });
        const bool has_side = cone.value <= 0.5 * std::numbers::pi;
        places.push_back({light.frame.origin, has_side ? -light.frame.z : glm::dvec3(0.0)});
    }
    return places;
}

std::vector<glm::dvec3> positions_of(std::span<const LightPlace> lights) {
    std::vector<glm::dvec3> positions;
    for (const LightPlace& light : lights)
        positions.push_back(light.position);
    return positions;
}

bool same(const Frame& a, const Frame& b) {
    return a.origin == b.origin && a.x == b.x && a.y == b.y && a.z == b.z;
}

struct Same {
    bool operator()(const Plane& a, const Plane& b) const { return a.point == b.point && a.normal == b.normal; }
    bool operator()(const Panel& a, const Panel& b) const {
        return same(a.frame, b.frame) && a.width == b.width && a.height == b.height;
    }
    bool operator()(const Ball& a, const Ball& b) const { return a.center == b.center && a.radius == b.radius; }
    bool operator()(const Box& a, const Box& b) const { return same(a.frame, b.frame) && a.half_size == b.half_size; }
    bool operator()(const Capsule& a, const Capsule& b) const {
        return a.center == b.center && a.axis == b.axis && a.half_length == b.half_length && a.radius == b.radius;
    }
    template<class A, class B>
    bool operator()(const A& /*a*/, const B& /*of another kind*/) const {
        return false;
    }
};

} // namespace

ExchangeGeometry::ExchangeGeometry(Stage stage, std::span<const Light> lights, const ExchangeQuality& quality,
                                   unsigned threads, simd::InstructionSet set)
    : stage_(std::move(stage)),
      lights_(places_of(lights)),
      quality_(quality),
      patches_(stage_, interest_of(stage_, positions_of(lights_)), lights_, quality.patches, threads) {
    // Stages with many things in them get fewer nodes for each.
    const double most = 3.0 * quality.patches;
    for (double spacing = quality.node_spacing;;) {
        const std::vector<Chart>& charts = patches_.charts().all();
        trees_.assign(charts.size(), NodeTree());
        std::vector<std::vector<Node>> made(charts.size());
        parallel_for(charts.size(), threads, [&](std::size_t i) {
            trees_[i] = NodeTree(stage_, lights_, charts[i], patches_.square_m(), spacing, made[i]);
        });
        nodes_.clear();
        slopes_.clear();
        for (std::size_t i = 0; i < charts.size(); ++i)
            trees_[i].append(made[i], nodes_, slopes_);
        const auto gathering = static_cast<double>(
            std::count_if(nodes_.begin(), nodes_.end(), [](const Node& node) { return node.gathers(); }));
        if (gathering <= most || spacing > 10.0 * quality.node_spacing) break;
        spacing *= std::clamp(std::sqrt(gathering / most), 1.1, 2.0);
    }
    order_between();
    std::vector<Receivers::Place> places;
    for (const Cell& cell : patches_.cells())
        places.push_back({.position = cell.position,
                          .normal = cell.normal,
                          .own = own(patches_.charts().all()[cell.chart].surface),
                          .left_out = cell.covered,
                          .is_coarse = true});
    if (quality.cell_rays > 0) {
        from_cells_ = Bundles(stage_, patches_, places, quality.cell_rays, threads, set);
        for (std::size_t i = 0; i < places.size(); ++i)
            escaping_.push_back(from_cells_.escaping(i));
    }
    places.clear();
    for (const Node& node : nodes_) {
        const std::size_t chart =
            patches_.charts().index_of(node.surface, face_at(stage_.surfaces[node.surface].geometry, node.position));
        const std::size_t rays = patches_.ray_factor(chart);
        places.push_back(
            {node.position, node.normal, own(node.surface), !node.gathers(), rays, rays == Patches::rays_of_slight});
    }
    if (quality.node_rays > 0) from_nodes_ = Bundles(stage_, patches_, places, quality.node_rays, threads, set);
    if (quality.cell_rays == 0) return;
    around_.resize(patches_.count());
    constexpr std::size_t together = 256;
    parallel_for((around_.size() + together - 1) / together, threads, [&](std::size_t block) {
        for (std::size_t i = block * together; i < std::min((block + 1) * together, around_.size()); ++i) {
            const auto patch = static_cast<std::uint32_t>(i);
            if (patches_.area_m2(patch) > 0.0) around_[i] = around(patches_.chart_of(patch), patches_.middle(patch));
        }
    });
    balance();
}

void ExchangeGeometry::order_between() {
    // By the number of others that stand between a node and those that gather.
    enum class State : unsigned char { unseen, open, done };
    std::vector<State> state(nodes_.size(), State::unseen);
    const auto visit = [&](const auto& self, std::uint32_t index) -> void {
        state[index] = State::open;
        Node& node = nodes_[index];
        for (const std::uint32_t end : node.ends)
            if (node.is_between() && nodes_[end].is_between()) {
                if (state[end] == State::unseen) self(self, end);
                if (state[end] == State::open) node.ends = {Node::none, Node::none}; // between itself: it gathers
            }
        if (node.is_between()) between_.push_back(index);
        state[index] = State::done;
    };
    for (std::uint32_t i = 0; i < nodes_.size(); ++i)
        if (nodes_[i].is_between() && state[i] == State::unseen) visit(visit, i);
}

namespace {

// How a node between two others follows from the curve between them, whose ends have slopes. What comes from a pole
// has none along this curve, and the curve is straight.
struct OnCurve {
    explicit OnCurve(const Node& node, const std::vector<Node>& nodes)
        : share(node.share),
          axis(static_cast<std::size_t>(node.axis)),
          per_length(1.0 / node.length),
          ends{!nodes[node.ends[0]].is_pole, !nodes[node.ends[1]].is_pole} {
        if (!ends[0] || !ends[1]) return;
        bulge = 0.5 * node.length * share * (1.0 - share);
        turn = 0.5 * (1.0 - 2.0 * share);
    }

    double share;
    std::size_t axis;
    double per_length;
    std::array<bool, 2> ends; // whether they have slopes along u and v
    double bulge = 0.0;       // of the value, by the difference of the slopes of the ends
    double turn = 0.0;        // of the slope
};

} // namespace

std::vector<NodeValue> ExchangeGeometry::field_of(std::span<const glm::dvec3> gathered) const {
    std::vector<NodeValue> field(gathered.size());
    for (std::size_t i = 0; i < field.size(); ++i)
        field[i].value = gathered[i];
    for (const SlopeTerm& term : slopes_)
        for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
            field[term.of].slope[axis] +=
                term.weight[static_cast<int>(axis)] * (gathered[term.from] - gathered[term.of]);
    for (const std::uint32_t index : between_) {
        const Node& node = nodes_[index];
        const OnCurve curve(node, nodes_);
        const NodeValue& a = field[node.ends[0]];
        const NodeValue& b = field[node.ends[1]];
        const glm::dvec3 bend = a.slope[curve.axis] - b.slope[curve.axis];
        field[index].value = (1.0 - curve.share) * a.value + curve.share * b.value + curve.bulge * bend;
        field[index].slope[curve.axis] = curve.per_length * (b.value - a.value) + curve.turn * bend;
        const std::size_t across = 1 - curve.axis;
        field[index].slope[across] = (curve.ends[0] ? 1.0 - curve.share : 0.0) * a.slope[across] +
                                     (curve.ends[1] ? curve.share : 0.0) * b.slope[across];
    }
    return field;
}

void ExchangeGeometry::balance() {
    const std::size_t charts = patches_.charts().all().size();
    std::vector<double> sent(charts, 0.0);     // of 1 lm/m² from the chart, what does not escape
    std::vector<double> by_cells(charts, 0.0); // and what arrives at cells and at nodes
    std::vector<double> by_nodes(charts, 0.0);
    std::vector<double> area(charts, 0.0);
    std::vector<double> node_area(nodes_.size(), 0.0); // the transpose of field_of() and its means
    std::vector<glm::dvec2> slope_area(nodes_.size(), glm::dvec2(0.0));
    for (std::uint32_t patch = 0; patch < patches_.count(); ++patch) {
        const double area_m2 = patches_.area_m2(patch);
        if (!(area_m2 > 0.0)) continue;
        const std::size_t chart = patches_.chart_of(patch);
        const std::uint32_t cell = patches_.cell_of(patch);
        area[chart] += area_m2;
        sent[chart] += area_m2 * (1.0 - escaping_[cell]);
        const NodeMean& mean = around_[patch];
        for (std::size_t i = 0; i < mean.count; ++i) {
            node_area[mean.node[i]] += mean.weight[i] * area_m2;
            slope_area[mean.node[i]] += mean.of_slopes[i] * area_m2;
        }
    }
    for (std::size_t i = between_.size(); i-- > 0;) {
        const Node& node = nodes_[between_[i]];
        const OnCurve curve(node, nodes_);
        const auto axis = static_cast<int>(curve.axis);
        const int across = 1 - axis;
        const double area_m2 = node_area[between_[i]];
        const glm::dvec2 of_slopes = slope_area[between_[i]];
        const double by_slope = curve.per_length * of_slopes[axis];
        const double by_bend = curve.bulge * area_m2 + curve.turn * of_slopes[axis];
        node_area[node.ends[0]] += (1.0 - curve.share) * area_m2 - by_slope;
        node_area[node.ends[1]] += curve.share * area_m2 + by_slope;
        slope_area[node.ends[0]][axis] += by_bend;
        slope_area[node.ends[1]][axis] -= by_bend;
        if (curve.ends[0]) slope_area[node.ends[0]][across] += (1.0 - curve.share) * of_slopes[across];
        if (curve.ends[1]) slope_area[node.ends[1]][across] += curve.share * of_slopes[across];
        node_area[between_[i]] = 0.0;
    }
    for (const SlopeTerm& term : slopes_) {
        const double by_difference = term.weight.x * slope_area[term.of].x + term.weight.y * slope_area[term.of].y;
        node_area[term.from] += by_difference;
        node_area[term.of] -= by_difference;
    }
    for (std::size_t chart = 0; chart < charts; ++chart) {
        for (std::uint32_t i = 0; i < patches_.cells().size(); ++i)
            by_cells[chart] += patches_.cell_area_m2(i) * from_cells_.of_chart(i, chart);
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            by_nodes[chart] += node_area[i] * from_nodes_.of_chart(i, chart);
    }
    cell_factor_.assign(charts, 1.0);
    node_factor_.assign(charts, 1.0);
    if (patches_.charts().endless()) return; // parts of planes are farther away than patches reach
    for (std::size_t chart = 0; chart < charts; ++chart) {
        if (!(sent[chart] > 0.5 * area[chart])) continue;
        if (by_cells[chart] > 0.0) cell_factor_[chart] = sent[chart] / by_cells[chart];
        if (by_nodes[chart] > 0.0) node_factor_[chart] = sent[chart] / by_nodes[chart];
    }
}

bool ExchangeGeometry::fits(const Stage& stage, std::span<const Light> lights, const ExchangeQuality& quality) const {
    if (!(quality == quality_) || stage.surfaces.size() != stage_.surfaces.size()) return false;
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i)
        if (!std::visit(Same(), stage.surfaces[i].geometry, stage_.surfaces[i].geometry)) return false;
    if (patches_.charts().uses_interest() &&
        !(stage.light.position == stage_.light.position && stage.camera.position == stage_.camera.position &&
          stage.camera.target == stage_.camera.target))
        return false;
    return places_of(lights) == lights_;
}

NodeMean ExchangeGeometry::around(std::size_t chart, const glm::dvec3& position) const {
    return trees_[chart].around(patches_.charts().all()[chart], position);
}

std::size_t ExchangeGeometry::own(std::size_t surface) const {
    return is_sheet(stage_.surfaces[surface].geometry) ? RayEnd::nothing : surface;
}

std::size_t ExchangeGeometry::memory() const {
    return from_cells_.memory() + from_nodes_.memory() + nodes_.size() * sizeof(Node) +
           slopes_.size() * sizeof(SlopeTerm) + patches_.cells().size() * (sizeof(Cell) + 2 * sizeof(double)) +
           patches_.count() * (2 * sizeof(std::uint32_t) + 5 * sizeof(double)) + around_.size() * sizeof(NodeMean);
}

} // namespace gonio::detail
