#include <gonio/light/light_image.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/image_illuminance.hpp>
#include <gonio/shading/irradiance_area.hpp>
#include <gonio/shading/lights.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

namespace gonio::detail {

namespace {

using Vec = shading::vec3<double>;

// Columns and rows of pixels, first and one past the last.
struct Tile {
    int left = 0;
    int right = 0;
    int top = 0;
    int bottom = 0;
    int depth = 0;
    double uniform = 0.0; // E/L of the tile with L = 1
    double value = 0.0;   // the same with its mean

    bool is_pixel() const { return right - left == 1 && bottom - top == 1; }
    double pixels() const { return static_cast<double>(right - left) * (bottom - top); }
};

// Of a tile; fewer than four if it is one pixel wide or high.
class Quarters {
public:
    void add(const Tile& tile) { tiles_.at(count_++) = tile; }
    std::span<const Tile> all() const { return std::span(tiles_).first(count_); }

private:
    std::array<Tile, 4> tiles_;
    std::size_t count_ = 0;
};

class Tiles {
public:
    Tiles(const Light& light, const RectShape& rect, const glm::dvec3& position, const glm::dvec3& normal)
        : image_(*light.image), frame_(light.frame), rect_(rect), position_(position), normal_(vec(normal)) {}

    Tile measured(Tile tile) const {
        const glm::dvec2 size(image_.width(), image_.height());
        const glm::dvec2 low = glm::dvec2(tile.left, tile.top) / size;
        const glm::dvec2 high = glm::dvec2(tile.right, tile.bottom) / size;
        const glm::dvec2 middle = 0.5 * (low + high);
        // The inverse of place_on().
        const double x = (0.5 - middle.x) * rect_.width.value;
        const double y = (0.5 - middle.y) * rect_.height.value;
        const Vec center = vec(frame_.origin + x * frame_.x + y * frame_.y - position_);
        const Vec axis = vec(-frame_.z);
        const auto one_side = [&](const Vec& towards) {
            const shading::RectangleLight<double> light{center,
                                                        {1.0, 1.0, 1.0},
                                                        towards,
                                                        vec(frame_.x),
                                                        (high.x - low.x) * rect_.width.value,
                                                        (high.y - low.y) * rect_.height.value,
                                                        0.0,
                                                        false};
            return shading::detail::irradiance(light, center, normal_);
        };
        tile.uniform = one_side(axis);
        if (rect_.two_sided) tile.uniform += one_side(axis * -1.0);
        tile.value = tile.uniform > 0.0 ? tile.uniform * image_.mean(low, high) : 0.0;
        return tile;
    }

    // In the order of the image.
    Quarters quarters(const Tile& tile) const {
        const auto middle = [](int first, int end) { return end - first > 1 ? (first + end) / 2 : end; };
        const int column = middle(tile.left, tile.right);
        const int row = middle(tile.top, tile.bottom);
        Quarters parts;
        for (const auto& [top, bottom] : {std::pair(tile.top, row), std::pair(row, tile.bottom)})
            for (const auto& [left, right] : {std::pair(tile.left, column), std::pair(column, tile.right)})
                if (top < bottom && left < right) parts.add(measured({left, right, top, bottom, tile.depth + 1}));
        return parts;
    }

    // Of the sum of the parts: what the luminance varies by from part to part times what the irradiance of a uniform
    // light does, relative to its mean. Within the parts the product is about as large, of either sign.
    static double error_of(const Tile& tile, std::span<const Tile> parts) {
        double all = 0.0;
        for (const Tile& part : parts)
            all += part.uniform;
        if (!(all > 0.0)) return 0.0;
        double luminance = 0.0; // variances
        double irradiance = 0.0;
        const double mean = tile.value / tile.uniform;
        for (const Tile& part : parts) {
            const double per_area = part.uniform / all * tile.pixels() / part.pixels() - 1.0;
            irradiance += per_area * per_area;
            if (!(part.uniform > 0.0)) continue;
            const double above = part.value / part.uniform - mean;
            luminance += above * above;
        }
        return all * std::sqrt(luminance * irradiance) / static_cast<double>(parts.size());
    }

private:
    const ImagePlane& image_;
    const Frame& frame_;
    const RectShape& rect_;
    const glm::dvec3& position_;
    Vec normal_;
};

} // namespace

ReferenceValue image_illuminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                                 const ReferenceGoal& goal) {
    // Before this depth, quarters may agree by chance.
    constexpr int least_depth = 4;
    const auto& rect = std::get<RectShape>(light.shape);
    const Tiles tiles(light, rect, position, normal);
    const Tile whole = tiles.measured({0, light.image->width(), 0, light.image->height()});
    ReferenceValue sum{0.0, 0.0, 1, true};
    if (!(whole.uniform > 0.0)) return sum;
    const double tolerance = std::max(goal.relative_error, 1e-13) * whole.value / whole.uniform;
    std::vector<Tile> open{whole};
    while (!open.empty()) {
        const Tile tile = open.back();
        open.pop_back();
        if (tile.is_pixel() || !(tile.uniform > 0.0) || sum.evaluations >= goal.most_evaluations) {
            sum.value += tile.value;
            if (!tile.is_pixel()) sum.error_estimate += tile.value;
            continue;
        }
        const Quarters quarters = tiles.quarters(tile);
        const std::span<const Tile> parts = quarters.all();
        sum.evaluations += parts.size();
        const double error = Tiles::error_of(tile, parts);
        if (tile.depth >= least_depth && error <= tolerance * tile.uniform) {
            for (const Tile& part : parts)
                sum.value += part.value;
            sum.error_estimate += error;
            continue;
        }
        open.insert(open.end(), parts.rbegin(), parts.rend());
    }
    // Closed forms are good to some 1e-12 of the whole light.
    sum.error_estimate += 1e-12 * whole.value;
    sum.converged = sum.error_estimate <= std::max(goal.relative_error, 1e-13) * std::max(sum.value, whole.value);
    sum.value *= light.luminance.value;
    sum.error_estimate *= light.luminance.value;
    return sum;
}

} // namespace gonio::detail
