#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/form_factor.hpp>
#include <gonio/transport/part_links.hpp>

#include "../preview/numbers.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace gonio::detail {
namespace {

const glm::dvec3 up(0.0, 0.0, 1.0);

// Of a rectangle in a place's frame, its half sides along x and y of the other.
SeenPolygon seen_of(const glm::dvec3& middle, const Frame& frame, const glm::dvec2& half_m) {
    const glm::dvec3 u = half_m.x * frame.x;
    const glm::dvec3 v = half_m.y * frame.y;
    return seen_above(up, {middle - u - v, middle + u - v, middle + u + v, middle - u + v});
}

// The form factor and its moments about the middle in sides, by the middles of n × n pieces.
struct Moments {
    double share = 0.0;
    glm::dvec2 moment{0.0};
};
Moments quadrature(const glm::dvec3& middle, const Frame& frame, const glm::dvec2& sides_m) {
    constexpr int n = 400;
    Moments sum;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const glm::dvec2 at((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5);
            const glm::dvec3 p = middle + at.x * sides_m.x * frame.x + at.y * sides_m.y * frame.y;
            const double p2 = glm::dot(p, p);
            const double share = std::max(p.z, 0.0) * std::abs(glm::dot(frame.z, p)) * sides_m.x * sides_m.y /
                                 (n * n * std::numbers::pi * p2 * p2);
            sum.share += share;
            sum.moment += share * at;
        }
    return sum;
}

TEST(PartKernels, AreAsExactAsSumsOfAnglesAndTheSameInEverySet) {
    constexpr std::size_t count = 999;
    test::Numbers numbers(1);
    const Frame frame = numbers.frame();
    std::array<std::vector<double>, 3> middle;
    std::array<std::vector<double>, 2> half_side;
    std::array<std::vector<double>, 2> at;
    std::array<std::vector<double>, 2> half;
    std::vector<double> factor;
    while (factor.size() < count) {
        const glm::dvec2 half_m{std::pow(10.0, numbers.between(-4.0, 0.0)), std::pow(10.0, numbers.between(-4.0, 0.0))};
        const glm::dvec3 way = numbers.direction();
        const double times = std::pow(100.0, numbers.between(0.0, 1.0) * numbers.between(0.0, 1.0));
        const glm::dvec3 to = 4.0 * glm::length(half_m) * times * way;
        if (!(to.z > half_m.x * std::abs(frame.x.z) + half_m.y * std::abs(frame.y.z))) continue;
        for (int axis = 0; axis < 3; ++axis)
            middle.at(static_cast<std::size_t>(axis)).push_back(to[axis]);
        for (int side = 0; side < 2; ++side) {
            half_side.at(static_cast<std::size_t>(side)).push_back(half_m[side]);
            at.at(static_cast<std::size_t>(side)).push_back(numbers.between(-0.5, 0.5));
            half.at(static_cast<std::size_t>(side)).push_back(numbers.between(0.0, 0.5));
        }
        factor.push_back(numbers.between(0.0, 1.0));
    }
    transport::FlatParts parts;
    for (int axis = 0; axis < 3; ++axis) {
        parts.x[axis] = frame.x[axis];
        parts.y[axis] = frame.y[axis];
        parts.middle[axis] = middle.at(static_cast<std::size_t>(axis)).data();
    }
    for (std::size_t side = 0; side < 2; ++side) {
        parts.half_side[side] = half_side.at(side).data();
        parts.at[side] = at.at(side).data();
        parts.half[side] = half.at(side).data();
    }
    parts.factor = factor.data();
    parts.count = count;
    std::vector<double> first;
    for (const simd::InstructionSet set : simd::available_sets()) {
        std::vector<double> shares(3 * count, -1.0);
        transport::part_kernels(set).shares(parts, {shares.data(), {shares.data() + count, shares.data() + 2 * count}});
        if (first.empty()) first = shares;
        EXPECT_EQ(shares, first) << simd::to_text(set);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 to(middle[0][i], middle[1][i], middle[2][i]);
        const glm::dvec2 half_m(half_side[0][i], half_side[1][i]);
        const double expected = factor[i] * seen_of(to, frame, half_m).form_factor;
        // The form factor is what remains of the sum of edges: little of a part that is narrow or far away. Doubles
        // round them, and the series for their angles is off by 1e-9 of one at the least distance, by the 14th power
        // less farther away.
        const double of_edges = factor[i] * (half_m.x + half_m.y) / glm::length(to);
        const double of_series = 1e-9 * std::pow(4.0 * glm::length(half_m) / glm::length(to), 14.0);
        EXPECT_NEAR(first[i], expected, 1e-9 * expected + (of_series + 1e-14) * of_edges) << i;
    }
}

// In parts, of patches that are near, far, on edge and cut by the horizon.
TEST(PartLinks, AddUpToThePatch) {
    test::Numbers numbers(2);
    PartLinks links(simd::best_available());
    int several = 0;
    int cut = 0;
    for (int i = 0; i < 200; ++i) {
        const Frame place = numbers.frame(numbers.direction());
        const Frame chart = numbers.frame();
        const glm::dvec2 sides_m{numbers.between(0.2, 1.2), numbers.between(0.2, 1.2)};
        const glm::dvec3 way = numbers.direction();
        const glm::dvec3 middle = place.origin + numbers.between(0.6, 2.6) * way;
        links.begin(place, chart, 4.0);
        links.add({middle, sides_m, 0.5}, 7, 3.0);
        links.find();
        Moments sum;
        for (std::size_t part = 0; part < links.size(); ++part) {
            EXPECT_EQ(links.number(part), 7U);
            sum.share += links.share(part);
            sum.moment += links.moment(part);
        }
        const glm::dvec3 to = place.to_local(middle - place.origin);
        const Frame in_place{glm::dvec3(0.0), place.to_local(chart.x), place.to_local(chart.y),
                             place.to_local(chart.z)};
        const double exact = seen_of(to, in_place, 0.5 * sides_m).form_factor;
        EXPECT_NEAR(sum.share, 3.0 * 0.5 * exact, 1e-8 * exact + 1e-10) << i;
        const double reach = 0.5 * (sides_m.x * std::abs(in_place.x.z) + sides_m.y * std::abs(in_place.y.z));
        const bool is_cut = std::abs(to.z) < reach;
        // Of each part as if the form factor were linear in it; none below 0.3 % of its share. Where the horizon cuts
        // it, they are estimates.
        const Moments expected = quadrature(to, in_place, sides_m);
        for (int side = 0; side < 2 && !is_cut; ++side)
            EXPECT_NEAR(sum.moment[side], 0.5 * expected.moment[side], 0.02 * expected.share + 1e-9) << i;
        if (links.size() > 1) ++several;
        if (is_cut) ++cut;
    }
    EXPECT_GT(several, 50);
    EXPECT_GT(cut, 20);
}

TEST(PartLinks, OfWhatIsBelowAreNone) {
    PartLinks links(simd::best_available());
    links.begin({}, {}, 4.0);
    links.add({{0.0, 0.0, -1.0}, {1.0, 1.0}, 1.0}, 0, 1.0);
    links.find();
    EXPECT_EQ(links.size(), 0U);
}

} // namespace
} // namespace gonio::detail
