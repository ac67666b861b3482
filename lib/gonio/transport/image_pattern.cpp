#include <gonio/base/gauss_legendre.hpp>
#include <gonio/transport/image_pattern.hpp>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gonio::detail {

namespace {

constexpr std::size_t order = 4;
constexpr std::size_t most_pixels = 512; // a side
constexpr std::size_t most_tiles = 4096; // of a level
constexpr std::size_t tiles_of_long_side = 16;
constexpr auto rule = gauss_legendre<order>();

// ∫ of the polynomial that is 1 at one node of the rule on [−1, 1] and 0 at the others, over [low, high].
std::array<double, order> integrals(double low, double high) {
    static constexpr auto inner = gauss_legendre<2>(); // exact for a cubic
    std::array<double, order> sums{};
    for (const QuadratureNode& node : inner) {
        const double at = 0.5 * (low + high) + 0.5 * (high - low) * node.at;
        for (std::size_t i = 0; i < order; ++i) {
            double value = 0.5 * (high - low) * node.weight;
            for (std::size_t k = 0; k < order; ++k)
                if (k != i) value *= (at - rule[k].at) / (rule[i].at - rule[k].at);
            sums[i] += value;
        }
    }
    return sums;
}

// What each pixel of a line of `pixels` adds to the nodes of each of `tiles` tiles.
struct Share {
    std::size_t tile;
    std::array<double, order> of_node; // of half a tile's width
};

std::vector<std::vector<Share>> shares_of_pixels(std::size_t pixels, std::size_t tiles) {
    std::vector<std::vector<Share>> shares(pixels);
    const auto count = static_cast<double>(pixels);
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        const double begin = static_cast<double>(tile) / static_cast<double>(tiles);
        const double end = static_cast<double>(tile + 1) / static_cast<double>(tiles);
        const auto local = [&](double at) { return 2.0 * (at - begin) / (end - begin) - 1.0; };
        const auto first = static_cast<std::size_t>(begin * count);
        for (std::size_t pixel = first; pixel < pixels; ++pixel) {
            const double low = std::max(static_cast<double>(pixel) / count, begin);
            const double high = std::min(static_cast<double>(pixel + 1) / count, end);
            if (low >= end) break;
            if (high > low) shares[pixel].push_back({tile, integrals(local(low), local(high))});
        }
    }
    return shares;
}

// The distance between an interval and [low, high]; 0 if they overlap.
double gap(double center, double half, double low, double high) {
    return std::max({low - (center + half), (center - half) - high, 0.0});
}

} // namespace

ImagePattern::ImagePattern(const RectShape& rect, const ImagePlane& image)
    : half_x_(0.5 * rect.width.value), half_y_(0.5 * rect.height.value) {
    const auto width = std::min(static_cast<std::size_t>(image.width()), most_pixels);
    const auto height = std::min(static_cast<std::size_t>(image.height()), most_pixels);
    std::vector<double> pixels(width * height);
    for (std::size_t row = 0; row < height; ++row)
        for (std::size_t column = 0; column < width; ++column) {
            const glm::dvec2 size(width, height);
            const glm::dvec2 low = glm::dvec2(column, row) / size;
            pixels[row * width + column] = image.mean(low, low + 1.0 / size);
        }
    const auto tiles_along = [&](double side, double other) {
        return static_cast<std::size_t>(
            std::clamp(std::round(side / other), 1.0, static_cast<double>(tiles_of_long_side)));
    };
    Level level{tiles_along(half_x_, half_y_), tiles_along(half_y_, half_x_), 0};
    while (level.columns * level.rows <= most_tiles) {
        levels_.push_back(level);
        const std::vector<std::vector<Share>> across = shares_of_pixels(width, level.columns);
        const std::vector<std::vector<Share>> down = shares_of_pixels(height, level.rows);
        const double half_x = half_x_ / static_cast<double>(level.columns); // of a tile
        const double half_y = half_y_ / static_cast<double>(level.rows);
        const std::size_t count = level.columns * level.rows;
        std::vector<double> weights(count * nodes_of_tile);
        std::vector<double> along(level.columns * order);
        for (std::size_t row = 0; row < height; ++row) {
            std::fill(along.begin(), along.end(), 0.0);
            for (std::size_t column = 0; column < width; ++column)
                for (const Share& share : across[column])
                    for (std::size_t i = 0; i < order; ++i)
                        along[share.tile * order + i] += pixels[row * width + column] * share.of_node[i];
            for (const Share& share : down[row])
                for (std::size_t tile = 0; tile < level.columns; ++tile)
                    for (std::size_t j = 0; j < order; ++j)
                        for (std::size_t i = 0; i < order; ++i)
                            weights[(share.tile * level.columns + tile) * nodes_of_tile + j * order + i] +=
                                half_x * half_y * share.of_node[j] * along[tile * order + i];
        }
        for (std::size_t tile = 0; tile < count; ++tile) {
            const std::size_t row = tile / level.columns;
            // Columns of the image run against X, its rows against Y.
            const double x = half_x_ - half_x * (2.0 * static_cast<double>(tile % level.columns) + 1.0);
            const double y = half_y_ - half_y * (2.0 * static_cast<double>(row) + 1.0);
            for (std::size_t node = 0; node < nodes_of_tile; ++node) {
                const QuadratureNode& in_row = rule[node % order];
                const QuadratureNode& in_column = rule[node / order];
                x_.push_back(static_cast<float>(x - half_x * in_row.at));
                y_.push_back(static_cast<float>(y - half_y * in_column.at));
                image_.push_back(static_cast<float>(weights[tile * nodes_of_tile + node]));
                uniform_.push_back(static_cast<float>(half_x * half_y * in_row.weight * in_column.weight));
            }
        }
        level = {2 * level.columns, 2 * level.rows, level.first + count};
    }
}

void ImagePattern::evaluate(const Light& light, const transport::Receivers& receivers, const glm::dvec3& anchor,
                            const transport::LuminanceKernels& kernels, float* share) const {
    // The same for all instruction sets, so that pictures are alike.
    constexpr std::size_t group = 16;
    // Sides of a tile over its distance up to which the sum over its nodes is taken: 1 takes three to five times as
    // long, and with 2 the 95th percentile of errors stays below 1e-3.
    constexpr double largest = 2.0;
    struct Tile {
        std::size_t level;
        std::size_t column;
        std::size_t row;
    };
    transport::NodeLight to;
    const auto copy = [](const glm::dvec3& from, float(&into)[3]) {
        for (int i = 0; i < 3; ++i)
            into[i] = static_cast<float>(from[i]);
    };
    copy(light.frame.origin - anchor, to.origin);
    copy(light.frame.x, to.x);
    copy(light.frame.y, to.y);
    copy(light.frame.z, to.z);
    to.two_sided = std::get<RectShape>(light.shape).two_sided;
    std::vector<Tile> open;
    std::vector<float> x, y, image, uniform;
    for (std::size_t first = 0; first < receivers.count; first += group) {
        const std::size_t count = std::min(group, receivers.count - first);
        glm::dvec3 low(1e300);
        glm::dvec3 high(-1e300);
        for (std::size_t i = first; i < first + count; ++i) {
            const glm::dvec3 at(receivers.position[0][i], receivers.position[1][i], receivers.position[2][i]);
            const glm::dvec3 local = light.frame.to_local(anchor + at - light.frame.origin);
            low = glm::min(low, local);
            high = glm::max(high, local);
        }
        x.clear();
        y.clear();
        image.clear();
        uniform.clear();
        open.clear();
        for (std::size_t tile = 0; tile < levels_.front().columns * levels_.front().rows; ++tile)
            open.push_back({0, tile % levels_.front().columns, tile / levels_.front().columns});
        while (!open.empty()) {
            const Tile tile = open.back();
            open.pop_back();
            const Level& level = levels_[tile.level];
            const double half_x = half_x_ / static_cast<double>(level.columns);
            const double half_y = half_y_ / static_cast<double>(level.rows);
            const double at_x = half_x_ - half_x * (2.0 * static_cast<double>(tile.column) + 1.0);
            const double at_y = half_y_ - half_y * (2.0 * static_cast<double>(tile.row) + 1.0);
            const double away = std::hypot(gap(at_x, half_x, low.x, high.x), gap(at_y, half_y, low.y, high.y),
                                           gap(0.0, 0.0, low.z, high.z));
            if (tile.level + 1 < levels_.size() && 2.0 * std::max(half_x, half_y) > largest * away) {
                for (std::size_t part = 0; part < 4; ++part)
                    open.push_back({tile.level + 1, 2 * tile.column + part % 2, 2 * tile.row + part / 2});
                continue;
            }
            const std::size_t of_tile = (level.first + tile.row * level.columns + tile.column) * nodes_of_tile;
            const auto take = [&](const std::vector<float>& from, std::vector<float>& into) {
                const auto begin = from.begin() + static_cast<std::ptrdiff_t>(of_tile);
                into.insert(into.end(), begin, begin + static_cast<std::ptrdiff_t>(nodes_of_tile));
            };
            take(x_, x);
            take(y_, y);
            take(image_, image);
            take(uniform_, uniform);
        }
        const auto part = [&](const float* const(&of)[3], const float*(&into)[3]) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                into[axis] = of[axis] + first;
        };
        transport::Receivers some;
        part(receivers.position, some.position);
        part(receivers.normal, some.normal);
        some.count = count;
        kernels.nodes(some, to, {x.data(), y.data(), image.data(), uniform.data(), x.size()}, share + first);
    }
}

} // namespace gonio::detail
