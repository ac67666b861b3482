#include <gonio/base/parallel.hpp>
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

// In double while the tree is built.
struct Block {
    glm::dvec3 directions{0.0}; // ∫ ω dω
    double solid_angle = 0.0;
    glm::dvec3 middle{0.0};
    double reach = 0.0;
    glm::dvec3 light{0.0};
    std::array<glm::dvec3, 3> moment{}; // ∫ L ω dω, channel by channel
};

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return 2.0 * std::asin(std::min(1.0, 0.5 * glm::length(a - b)));
}

// How far the corners are from the middle.
double reach_of(const EnvironmentGrid& grid, TexelIndex texel, const glm::dvec3& middle) {
    constexpr double inwards = 1e-9; // of the same face
    double most = 0.0;
    for (const double right : {inwards, 1.0 - inwards})
        for (const double below : {inwards, 1.0 - inwards})
            most = std::max(most, angle_between(middle, grid.direction({texel.column + right, texel.row + below})));
    return most;
}

Block block_of(const EnvironmentMap& map, TexelIndex texel) {
    const EnvironmentGrid& grid = map.grid();
    Block block;
    block.directions = grid.direction_integral(texel);
    block.solid_angle = grid.solid_angle(texel);
    block.middle = glm::normalize(block.directions);
    block.reach = reach_of(grid, texel, block.middle);
    const glm::dvec3 light = map.texel(texel);
    block.light = light * block.solid_angle;
    for (int c = 0; c < 3; ++c)
        block.moment.at(static_cast<std::size_t>(c)) = light[c] * block.directions;
    return block;
}

Block joined(const Block* const* children, std::size_t count) {
    Block block;
    for (std::size_t i = 0; i < count; ++i) {
        const Block& child = *children[i];
        block.directions += child.directions;
        block.solid_angle += child.solid_angle;
        block.light += child.light;
        for (std::size_t c = 0; c < 3; ++c)
            block.moment.at(c) += child.moment.at(c);
    }
    // All columns of a lat-long may cancel.
    const double length = glm::length(block.directions);
    block.middle = length > 0.0 ? block.directions / length : children[0]->middle;
    for (std::size_t i = 0; i < count; ++i)
        block.reach =
            std::max(block.reach, angle_between(block.middle, children[i]->middle) + children[i]->reach);
    block.reach = std::min(block.reach, std::numbers::pi);
    return block;
}

// Parts of a texel that lobes narrower than it are summed over: 2^k a side.
constexpr int most_part_levels = 8;

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
    // Of a block under uniform light, were the second order left out: light that varies within it errs by a part of
    // that. Where the horizon crosses a block, its weight is that of its middle.
    [[nodiscard]] bool is_good(const At& at, double reach, double spread, double solid_angle, double luminance) const {
        double error = 0.5 * lobe.curvature(at.nearest) * (at.sine_square + spread) * spread;
        if (at.is_clipped) error += 0.25 * lobe.slope(1.0 - 1e-15) * reach;
        return error * 0.5 * (luminance + solid_angle * mean_luminance) <= most_error;
    }
    // The factors of ∫ L dω, of R·∫ L (ω − middle) dω, and of ∫ dω.
    struct Factors {
        double light;
        double moment;
        double solid_angle;
    };
    [[nodiscard]] Factors factors(const At& at, double spread) const {
        const double plain = lobe.weight(at.u);
        if (at.is_clipped) return {plain, 0.0, plain};
        const double slope = lobe.slope(at.u);
        const double even = plain + 0.5 * lobe.curvature(at.u) * at.sine_square * spread;
        return {even, slope, even - slope * spread * (1.0 - at.u)};
    }
};

EnvironmentTree::EnvironmentTree(const EnvironmentMap& map, unsigned threads) : grid_(map.grid()) {
    // The size of the smallest blocks.
    int least = 1;
    while (static_cast<std::size_t>(grid_.width()) * static_cast<std::size_t>(grid_.height()) /
               static_cast<std::size_t>(least) / static_cast<std::size_t>(least) >
           most_texels)
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
        node.spread = static_cast<float>(1.0 - glm::dot(block.directions, block.middle) / block.solid_angle);
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec3 moment = block.moment.at(c) - block.light[static_cast<int>(c)] * middle;
            for (int i = 0; i < 3; ++i)
                node.moment.at(3 * c + static_cast<std::size_t>(i)) = static_cast<float>(moment[i]);
        }
        nodes_.push_back(node);
        links_.push_back(link);
    };
    // Texels first, chart by chart, then each level of blocks.
    for (Level& level : levels) {
        level.first_node = static_cast<std::int32_t>(nodes_.size());
        for (int row = 0; row < level.height; ++row)
            for (int column = 0; column < level.width; ++column) {
                const Block& block = level.blocks.at(static_cast<std::size_t>(row) *
                                                         static_cast<std::size_t>(level.width) +
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
                            children.at(count++) = &level.blocks.at(static_cast<std::size_t>(y) *
                                                                        static_cast<std::size_t>(level.width) +
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

void EnvironmentTree::add_part(Sum& sum, const EnvironmentGrid& grid, TexelIndex part, const glm::dvec3& light,
                               int level) const {
    const glm::dvec3 directions = grid.direction_integral(part);
    const double solid_angle = grid.solid_angle(part);
    if (!(solid_angle > 0.0)) return;
    const glm::dvec3 middle = glm::normalize(directions);
    const double spread = std::max(0.0, 1.0 - glm::length(directions) / solid_angle);
    const double reach = reach_of(grid, part, middle);
    const Sum::At at = sum.at(middle, reach);
    if (at.nearest >= 1.0) return;
    const bool is_good =
        sum.is_good(at, reach, spread, solid_angle, glm::dot(light, rec709_luminance) * solid_angle);
    if (!is_good && level < most_part_levels) {
        const Result<EnvironmentGrid> finer =
            EnvironmentGrid::create(grid.layout(), 2 * grid.width(), 2 * grid.height());
        if (!finer) return;
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 2; ++x)
                add_part(sum, *finer, {2 * part.column + x, 2 * part.row + y}, light, level + 1);
        return;
    }
    const double weight = sum.factors(at, spread).solid_angle * solid_angle;
    sum.light += weight * light;
    sum.weight += weight;
}

glm::dvec3 EnvironmentTree::mean(const GgxLobe& lobe, const glm::dvec3& direction, double tolerance) const {
    const double mean_luminance = glm::dot(mean_, rec709_luminance);
    Sum sum{lobe, direction, tolerance * lobe.whole() * mean_luminance, mean_luminance};
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
        if (!sum.is_good(at, reach, spread, solid_angle, glm::dot(light, rec709_luminance))) {
            const Link& link = links_[index];
            if (link.across > 0) {
                for (int y = 0; y < link.down; ++y)
                    for (int x = 0; x < link.across; ++x)
                        open.push_back(link.first + y * link.row_length + x);
                continue;
            }
            if (index < places_.size()) {
                add_part(sum, grid_, places_[index], light / solid_angle, 0);
                continue;
            }
        }
        const Sum::Factors factors = sum.factors(at, spread);
        const auto moment = [&](std::size_t channel) {
            const float* const m = node.moment.data() + 3 * channel;
            return glm::dot(direction, glm::dvec3(m[0], m[1], m[2]));
        };
        sum.light += factors.light * light + factors.moment * glm::dvec3(moment(0), moment(1), moment(2));
        sum.weight += factors.solid_angle * solid_angle;
    }
    return sum.weight > 0.0 ? sum.light / sum.weight : glm::dvec3(0.0);
}

} // namespace gonio
