#include <gonio/transport/sample_bounds.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace gonio::detail {

namespace {

// Several numbers side by side: the compiler makes registers of them, but not of one minimum.
constexpr std::size_t lanes = 8;

struct Extent {
    float least;
    float greatest;
};

Extent extent_of(std::span<const float> values) {
    std::array<float, lanes> least;
    std::array<float, lanes> greatest;
    least.fill(values[0]);
    greatest.fill(values[0]);
    const auto take = [&](std::size_t lane, float value) {
        least[lane] = value < least[lane] ? value : least[lane];
        greatest[lane] = value > greatest[lane] ? value : greatest[lane];
    };
    std::size_t i = 0;
    for (; i + lanes <= values.size(); i += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane)
            take(lane, values[i + lane]);
    for (; i < values.size(); ++i)
        take(0, values[i]);
    return {*std::min_element(least.begin(), least.end()), *std::max_element(greatest.begin(), greatest.end())};
}

bool are_equal(std::span<const float> values) {
    unsigned different = 0; // counted, not looked for, so that it runs in packs
    for (const float value : values)
        different += value == values[0] ? 0U : 1U;
    return different == 0;
}

} // namespace

void BoundsBuilder::add(const glm::dvec3& point, const glm::dvec3& normal) {
    if (empty_) {
        empty_ = false;
        low_ = high_ = point;
        first_normal_ = normal_low_ = normal_high_ = normal;
        least_height_ = glm::dot(normal, point);
        return;
    }
    low_ = glm::min(low_, point);
    high_ = glm::max(high_, point);
    least_height_ = std::min(least_height_, glm::dot(first_normal_, point));
    if (normal == first_normal_) return;
    flat_ = false;
    normal_low_ = glm::min(normal_low_, normal);
    normal_high_ = glm::max(normal_high_, normal);
}

void BoundsBuilder::add(const BoundsBuilder& others) {
    if (others.empty_) return;
    if (empty_) {
        *this = others;
        return;
    }
    flat_ = flat_ && others.flat_ && first_normal_ == others.first_normal_;
    low_ = glm::min(low_, others.low_);
    high_ = glm::max(high_, others.high_);
    least_height_ = std::min(least_height_, others.least_height_);
    normal_low_ = glm::min(normal_low_, others.normal_low_);
    normal_high_ = glm::max(normal_high_, others.normal_high_);
}

void BoundsBuilder::add(const glm::dvec3& anchor, const std::array<std::span<const float>, 3>& points,
                        const std::array<std::span<const float>, 3>& normals) {
    const std::size_t count = points[0].size();
    const auto point = [&](std::size_t i) { return anchor + glm::dvec3(points[0][i], points[1][i], points[2][i]); };
    const auto normal = [&](std::size_t i) { return glm::dvec3(normals[0][i], normals[1][i], normals[2][i]); };
    add(point(0), normal(0));
    if (!std::all_of(normals.begin(), normals.end(), are_equal)) {
        for (std::size_t i = 1; i < count; ++i)
            add(point(i), normal(i));
        return;
    }
    // Rounding keeps the order, so that the sums of the least and of the greatest are the least and the greatest sums.
    glm::dvec3 low(0.0);
    glm::dvec3 high(0.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Extent extent = extent_of(points[axis]);
        low[static_cast<int>(axis)] = extent.least;
        high[static_cast<int>(axis)] = extent.greatest;
    }
    low_ = glm::min(low_, anchor + low);
    high_ = glm::max(high_, anchor + high);
    std::array<double, lanes> height;
    height.fill(least_height_);
    const auto take_height = [&](std::size_t lane, std::size_t i) {
        const double at = glm::dot(first_normal_, point(i));
        height[lane] = at < height[lane] ? at : height[lane];
    };
    std::size_t i = 1;
    for (; i + lanes <= count; i += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane)
            take_height(lane, i + lane);
    for (; i < count; ++i)
        take_height(0, i);
    least_height_ = *std::min_element(height.begin(), height.end());
    if (normal(0) == first_normal_) return;
    flat_ = false;
    normal_low_ = glm::min(normal_low_, normal(0));
    normal_high_ = glm::max(normal_high_, normal(0));
}

SampleBounds BoundsBuilder::bounds() const {
    SampleBounds bounds;
    bounds.low = low_;
    bounds.high = high_;
    bounds.center = 0.5 * (low_ + high_);
    bounds.radius = 0.5 * glm::length(high_ - low_);
    bounds.flat = flat_;
    bounds.normal = first_normal_;
    bounds.least_height = least_height_;
    if (flat_) return bounds;
    // Every normal is inside a sphere about the middle of their box, which subtends this half angle at the origin.
    const glm::dvec3 middle = 0.5 * (normal_low_ + normal_high_);
    const double length = glm::length(middle);
    const double ball = 0.5 * glm::length(normal_high_ - normal_low_);
    bounds.spread_sin = ball < length ? ball / length : 1.0;
    bounds.spread_cos = std::sqrt((1.0 - bounds.spread_sin) * (1.0 + bounds.spread_sin));
    if (length > 0.0) bounds.normal = middle / length;
    return bounds;
}

} // namespace gonio::detail
