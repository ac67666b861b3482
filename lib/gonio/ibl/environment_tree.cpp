#include <gonio/base/parallel.hpp>
#include <gonio/ibl/detail/lobe_over_texel.hpp>
#include <gonio/ibl/environment_tree.hpp>
#include <gonio/light/light_color.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

// A rectangle of the picture in which neighbours are neighbours on the sphere: a face, or all of it.
struct Chart {
    int column;
    int row;
    int width;
    int height;
};

std::vector<Chart> charts_of(const EnvironmentGrid& grid) {
    if (grid.layout() == EnvironmentLayout::latlong || grid.layout() == EnvironmentLayout::octahedral)
        return {{0, 0, grid.width(), grid.height()}};
    std::vector<Chart> charts;
    const int side = grid.side();
    for (int row = 0; row < grid.height(); row += side)
        for (int column = 0; column < grid.width(); column += side)
            if (grid.covers({column, row})) charts.push_back({column, row, side, side});
    return charts;
}

// d dᵀ times a weight: xx yy zz xy xz yz.
using Tensor = std::array<double, 6>;

void add_square(Tensor& tensor, const glm::dvec3& d, double weight) {
    tensor[0] += weight * d.x * d.x;
    tensor[1] += weight * d.y * d.y;
    tensor[2] += weight * d.z * d.z;
    tensor[3] += weight * d.x * d.y;
    tensor[4] += weight * d.x * d.z;
    tensor[5] += weight * d.y * d.z;
}

void add(Tensor& tensor, const Tensor& other) {
    for (std::size_t i = 0; i < tensor.size(); ++i)
        tensor.at(i) += other.at(i);
}

// In double while the tree is built. Second moments are about the middle.
struct Block {
    glm::dvec3 directions{0.0}; // ∫ ω dω
    double solid_angle = 0.0;
    glm::dvec3 middle{0.0};
    double reach = 0.0;
    double square = 0.0; // ∫ Y² dω
    double luminance = 0.0;
    glm::dvec3 light{0.0};
    std::array<glm::dvec3, 3> moment{}; // ∫ L ω dω, channel by channel
    Tensor extent{};                    // ∫ d dᵀ dω, d = ω − middle
    Tensor second{};                    // ∫ Y d dᵀ dω
};

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return 2.0 * std::asin(std::min(1.0, 0.5 * glm::length(a - b)));
}

Block block_of(const EnvironmentMap& map, TexelIndex texel) {
    const EnvironmentGrid& grid = map.grid();
    Block block;
    block.directions = grid.direction_integral(texel);
    block.solid_angle = grid.solid_angle(texel);
    block.middle = glm::normalize(block.directions);
    constexpr double inwards = 1e-9; // of the same face
    std::array<glm::dvec3, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) {
        const double right = i % 2 == 0 ? inwards : 1.0 - inwards;
        const double below = i < 2 ? inwards : 1.0 - inwards;
        corners.at(i) = grid.direction({texel.column + right, texel.row + below});
        block.reach = std::max(block.reach, angle_between(block.middle, corners.at(i)));
    }
    // As a parallelogram.
    const glm::dvec3 across = 0.5 * (corners[1] - corners[0] + corners[3] - corners[2]);
    const glm::dvec3 down = 0.5 * (corners[2] - corners[0] + corners[3] - corners[1]);
    add_square(block.extent, across, block.solid_angle / 12.0);
    add_square(block.extent, down, block.solid_angle / 12.0);
    const glm::dvec3 light = map.texel(texel);
    const double luminance = glm::dot(light, rec709_luminance);
    block.light = light * block.solid_angle;
    block.luminance = luminance * block.solid_angle;
    block.square = luminance * luminance * block.solid_angle;
    for (int c = 0; c < 3; ++c)
        block.moment.at(static_cast<std::size_t>(c)) = light[c] * block.directions;
    for (std::size_t i = 0; i < block.extent.size(); ++i)
        block.second.at(i) = luminance * block.extent.at(i);
    return block;
}

// ∫ Y ω dω
glm::dvec3 luminance_moment(const Block& block) {
    glm::dvec3 moment(0.0);
    for (int c = 0; c < 3; ++c)
        moment += rec709_luminance[c] * block.moment.at(static_cast<std::size_t>(c));
    return moment;
}

// Second moments about another middle: d' = d − by. `first` and `zeroth` are the lower moments.
void add_moved(Tensor& to, const Tensor& from, const glm::dvec3& first, double zeroth, const glm::dvec3& by) {
    add(to, from);
    const glm::dvec3 mean = zeroth > 0.0 ? first / zeroth : glm::dvec3(0.0);
    add_square(to, mean - by, zeroth);
    add_square(to, mean, -zeroth);
}

Block joined(const Block* const* children, std::size_t count) {
    Block block;
    for (std::size_t i = 0; i < count; ++i) {
        const Block& child = *children[i];
        block.directions += child.directions;
        block.solid_angle += child.solid_angle;
        block.light += child.light;
        block.luminance += child.luminance;
        block.square += child.square;
        for (std::size_t c = 0; c < 3; ++c)
            block.moment.at(c) += child.moment.at(c);
    }
    // All columns of a lat-long may cancel.
    const double length = glm::length(block.directions);
    block.middle = length > 0.0 ? block.directions / length : children[0]->middle;
    for (std::size_t i = 0; i < count; ++i) {
        const Block& child = *children[i];
        const glm::dvec3 by = block.middle - child.middle;
        add_moved(block.extent, child.extent, child.directions - child.solid_angle * child.middle, child.solid_angle,
                  by);
        add_moved(block.second, child.second, luminance_moment(child) - child.luminance * child.middle, child.luminance,
                  by);
        block.reach = std::max(block.reach, angle_between(block.middle, child.middle) + child.reach);
    }
    block.reach = std::min(block.reach, std::numbers::pi);
    return block;
}

// The part of a block's variance of luminance that a linear slope over it does not explain, as a root over the mean.
double unevenness_of(const Block& block, double spread) {
    const double mean = block.luminance / block.solid_angle;
    if (!(mean > 0.0)) return 0.0;
    glm::dvec3 moment = luminance_moment(block) / block.solid_angle - mean * block.middle;
    moment -= glm::dot(moment, block.middle) * block.middle;
    const double slope = spread > 0.0 ? glm::dot(moment, moment) / spread : 0.0;
    return std::sqrt(std::max(0.0, block.square / block.solid_angle - mean * mean - slope)) / mean;
}

} // namespace

// The sum over blocks for one direction.
struct EnvironmentTree::Sum {
    const GgxLobe& lobe;
    glm::dvec3 direction;
    double most_error;     // that a block may have: of ∫ L w dω
    double mean_luminance; // for the error of the weights
    glm::dvec3 light{0.0};
    double weight = 0.0;

    // What a block needs of the lobe.
    struct At {
        double u; // of its middle
        double sine_square;
        double nearest;  // u of its nearest direction
        bool is_clipped; // at the horizon
    };
    [[nodiscard]] At at(const glm::dvec3& middle, double reach) const {
        const glm::dvec3 apart = direction - middle;
        const double u = 0.5 * glm::dot(apart, apart);
        const double sine_square = std::max(0.0, u * (2.0 - u));
        const double variation = reach * std::sqrt(sine_square) + 0.5 * reach * reach;
        return {u, sine_square, std::max(0.0, u - variation), u + variation > 1.0};
    }
    // What is left out: the lobe's third order where the luminance is uneven, else its fourth, as its second order
    // times powers of the ratio of the block to the distance over which the lobe changes.
    [[nodiscard]] bool is_good(const At& at, double reach, double spread, double solid_angle, double luminance,
                               double unevenness) const {
        const double second = 0.5 * lobe.curvature(at.nearest) * (at.sine_square + spread) * spread;
        const double ratio = std::min(1.0, spread / (at.nearest + lobe.alpha() * lobe.alpha()));
        double of_weight = second * ratio;
        if (at.is_clipped) of_weight += at_horizon * lobe.slope(horizon) * reach;
        const double of_light = of_weight + second * unevenness * std::sqrt(ratio);
        return luminance * of_light + solid_angle * mean_luminance * of_weight <= 2.0 * most_error;
    }
    static constexpr double horizon = 1.0 - 1e-15; // u just above it
    static constexpr double at_horizon = 0.05;     // the greatest error of factors() there, of slope times reach

    // The lobe at a block's middle: w, w' and w''/2. Across the horizon only w, the mean of max(0, c) for a c that is
    // uniform within ± half, times the slope there.
    struct Orders {
        double zeroth;
        double first;
        double second;
    };
    [[nodiscard]] Orders orders(const At& at, double spread) const {
        if (at.is_clipped) {
            const double half = std::sqrt(3.0 * spread * at.sine_square);
            const double c = 1.0 - at.u;
            if (std::abs(c) >= half) return {lobe.weight(at.u), 0.0, 0.0};
            return {lobe.slope(horizon) * (c + half) * (c + half) / (4.0 * half), 0.0, 0.0};
        }
        return {lobe.weight(at.u), lobe.slope(at.u), 0.5 * lobe.curvature(at.u)};
    }
    // dᵀ T d of the direction.
    [[nodiscard]] double along(const std::array<float, 6>& t) const {
        const glm::dvec3& d = direction;
        return d.x * d.x * static_cast<double>(t[0]) + d.y * d.y * static_cast<double>(t[1]) +
               d.z * d.z * static_cast<double>(t[2]) +
               2.0 * (d.x * d.y * static_cast<double>(t[3]) + d.x * d.z * static_cast<double>(t[4]) +
                      d.y * d.z * static_cast<double>(t[5]));
    }
};

EnvironmentTree::EnvironmentTree(const EnvironmentMap& map, unsigned threads, std::size_t leaves) : grid_(map.grid()) {
    // The size of the smallest blocks.
    int least = 1;
    while (static_cast<std::size_t>(grid_.width()) * static_cast<std::size_t>(grid_.height()) /
               static_cast<std::size_t>(least) / static_cast<std::size_t>(least) >
           leaves)
        least *= 2;

    struct Level {
        Chart chart;
        int width;
        int height;
        std::vector<Block> blocks;
        std::int32_t first_node = 0;
    };
    std::vector<Level> levels;
    for (const Chart& chart : charts_of(grid_))
        levels.push_back({chart, (chart.width + least - 1) / least, (chart.height + least - 1) / least, {}, 0});
    for (Level& level : levels) {
        level.blocks.resize(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
        parallel_for(static_cast<std::size_t>(level.height), threads, [&](std::size_t at) {
            const int row = static_cast<int>(at);
            std::vector<Block> texels;
            std::vector<const Block*> children;
            for (int column = 0; column < level.width; ++column) {
                texels.clear();
                children.clear();
                for (int y = row * least; y < std::min((row + 1) * least, level.chart.height); ++y)
                    for (int x = column * least; x < std::min((column + 1) * least, level.chart.width); ++x)
                        texels.push_back(block_of(map, {level.chart.column + x, level.chart.row + y}));
                for (const Block& texel : texels)
                    children.push_back(&texel);
                level.blocks.at(at * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(column)) =
                    texels.size() == 1 ? texels.front() : joined(children.data(), children.size());
            }
        });
    }

    glm::dvec3 light(0.0);
    double solid_angle = 0.0;
    const auto push = [&](const Block& block, Link link) {
        Node node{};
        node.reach = static_cast<float>(block.reach * (1.0 + 1e-6));
        node.solid_angle = static_cast<float>(block.solid_angle);
        for (int i = 0; i < 3; ++i) {
            node.middle.at(static_cast<std::size_t>(i)) = static_cast<float>(block.middle[i]);
            node.light.at(static_cast<std::size_t>(i)) = static_cast<float>(block.light[i]);
        }
        // The middle as it is stored, so that what is summed is consistent.
        const glm::dvec3 middle(static_cast<double>(node.middle[0]), static_cast<double>(node.middle[1]),
                                static_cast<double>(node.middle[2]));
        const double spread = std::max(0.0, 1.0 - glm::dot(block.directions, block.middle) / block.solid_angle);
        node.spread = static_cast<float>(spread);
        node.unevenness = static_cast<float>(unevenness_of(block, spread));
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec3 moment = block.moment.at(c) - block.light[static_cast<int>(c)] * middle;
            for (int i = 0; i < 3; ++i)
                node.moment.at(3 * c + static_cast<std::size_t>(i)) = static_cast<float>(moment[i]);
        }
        for (std::size_t i = 0; i < node.extent.size(); ++i) {
            node.extent.at(i) = static_cast<float>(block.extent.at(i) / block.solid_angle);
            node.second.at(i) =
                block.luminance > 0.0 ? static_cast<float>(block.second.at(i) / block.luminance) : node.extent.at(i);
        }
        nodes_.push_back(node);
        links_.push_back(link);
    };
    // Texels first, chart by chart, then each level of blocks.
    for (Level& level : levels) {
        level.first_node = static_cast<std::int32_t>(nodes_.size());
        for (int row = 0; row < level.height; ++row)
            for (int column = 0; column < level.width; ++column) {
                const Block& block =
                    level.blocks.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(level.width) +
                                    static_cast<std::size_t>(column));
                light += block.light;
                solid_angle += block.solid_angle;
                push(block, {});
                if (least == 1) places_.push_back({level.chart.column + column, level.chart.row + row});
            }
    }
    mean_ = light / solid_angle;
    for (Level& level : levels) {
        while (level.width > 1 || level.height > 1) {
            Level next{level.chart, (level.width + 1) / 2, (level.height + 1) / 2, {}, 0};
            next.first_node = static_cast<std::int32_t>(nodes_.size());
            for (int row = 0; row < next.height; ++row)
                for (int column = 0; column < next.width; ++column) {
                    std::array<const Block*, 4> children{};
                    std::size_t count = 0;
                    for (int y = 2 * row; y < std::min(2 * row + 2, level.height); ++y)
                        for (int x = 2 * column; x < std::min(2 * column + 2, level.width); ++x)
                            children.at(count++) =
                                &level.blocks.at(static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) +
                                                 static_cast<std::size_t>(x));
                    next.blocks.push_back(joined(children.data(), count));
                }
            for (std::size_t i = 0; i < next.blocks.size(); ++i) {
                const int row = static_cast<int>(i) / next.width;
                const int column = static_cast<int>(i) % next.width;
                const std::int32_t first = level.first_node + 2 * row * level.width + 2 * column;
                const int across = std::min(2, level.width - 2 * column);
                const int down = std::min(2, level.height - 2 * row);
                push(next.blocks.at(i),
                     {first, level.width, static_cast<std::int16_t>(across), static_cast<std::int16_t>(down)});
            }
            level = std::move(next);
        }
        roots_.push_back(level.first_node);
    }
}

glm::dvec3 EnvironmentTree::mean(const GgxLobe& lobe, const glm::dvec3& direction, double tolerance) const {
    const double mean_luminance = glm::dot(mean_, rec709_luminance);
    Sum sum{lobe, direction, tolerance * lobe.whole() * mean_luminance, mean_luminance};
    const detail::LobeOverTexel<5> over_texel(lobe, direction);
    std::vector<std::int32_t> open = roots_;
    while (!open.empty()) {
        const auto index = static_cast<std::size_t>(open.back());
        open.pop_back();
        const Node& node = nodes_[index];
        const glm::dvec3 middle(node.middle[0], node.middle[1], node.middle[2]);
        const auto reach = static_cast<double>(node.reach);
        const Sum::At at = sum.at(middle, reach);
        if (at.nearest >= 1.0) continue;
        const auto spread = static_cast<double>(node.spread);
        const auto solid_angle = static_cast<double>(node.solid_angle);
        const glm::dvec3 light(node.light[0], node.light[1], node.light[2]);
        if (!sum.is_good(at, reach, spread, solid_angle, glm::dot(light, rec709_luminance),
                         static_cast<double>(node.unevenness))) {
            const Link& link = links_[index];
            if (link.across > 0) {
                for (int y = 0; y < link.down; ++y)
                    for (int x = 0; x < link.across; ++x)
                        open.push_back(link.first + y * link.row_length + x);
                continue;
            }
            if (index < places_.size()) {
                const double weight = over_texel(detail::outline_of(grid_, places_[index]), middle, reach);
                sum.light += weight / solid_angle * light;
                sum.weight += weight;
                continue;
            }
        }
        const Sum::Orders orders = sum.orders(at, spread);
        const auto moment = [&](std::size_t channel) {
            const float* const m = node.moment.data() + 3 * channel;
            return glm::dot(direction, glm::dvec3(m[0], m[1], m[2]));
        };
        sum.light += (orders.zeroth + orders.second * sum.along(node.second)) * light +
                     orders.first * glm::dvec3(moment(0), moment(1), moment(2));
        sum.weight += (orders.zeroth + orders.second * sum.along(node.extent) - orders.first * spread * (1.0 - at.u)) *
                      solid_angle;
    }
    return sum.weight > 0.0 ? sum.light / sum.weight : glm::dvec3(0.0);
}

} // namespace gonio
