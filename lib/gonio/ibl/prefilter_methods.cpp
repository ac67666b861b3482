#include <gonio/base/parallel.hpp>
#include <gonio/ibl/detail/lobe_over_texel.hpp>
#include <gonio/ibl/ggx_lobe.hpp>
#include <gonio/ibl/prefilter_methods.hpp>
#include <gonio/sky/environment_resample.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

using std::numbers::pi;

// The base-2 radical inverse.
double radical_inverse(std::uint32_t bits) {
    bits = (bits << 16U) | (bits >> 16U);
    bits = ((bits & 0x55555555U) << 1U) | ((bits & 0xAAAAAAAAU) >> 1U);
    bits = ((bits & 0x33333333U) << 2U) | ((bits & 0xCCCCCCCCU) >> 2U);
    bits = ((bits & 0x0F0F0F0FU) << 4U) | ((bits & 0xF0F0F0F0U) >> 4U);
    bits = ((bits & 0x00FF00FFU) << 8U) | ((bits & 0xFF00FF00U) >> 8U);
    return static_cast<double>(bits) * 0x1p-32;
}

// Σ L(l) n·l / Σ n·l over GGX samples; L(l, D/4).
template<class Radiance>
glm::dvec3 mean_of_samples(const LobeQuery& query, int count, const Radiance& radiance) {
    const double alpha = GgxLobe(query.roughness).alpha();
    const glm::dvec3& n = query.direction;
    const glm::dvec3 other = std::abs(n.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 e = glm::normalize(glm::cross(other, n));
    const glm::dvec3 f = glm::cross(n, e);
    glm::dvec3 light(0.0);
    double weight = 0.0;
    for (int i = 0; i < count; ++i) {
        const double phi = 2.0 * pi * (i + 0.5) / count;
        const double xi = radical_inverse(static_cast<std::uint32_t>(i));
        const double cosine_square = (1.0 - xi) / (1.0 + (alpha * alpha - 1.0) * xi);
        const double n_dot_l = 2.0 * cosine_square - 1.0;
        if (!(n_dot_l > 0.0)) continue;
        const double sine = 2.0 * std::sqrt(cosine_square * (1.0 - cosine_square));
        const glm::dvec3 l = n_dot_l * n + sine * (std::cos(phi) * e + std::sin(phi) * f);
        const double t = (alpha * alpha - 1.0) * cosine_square + 1.0;
        const double density = 0.25 * alpha * alpha / (pi * t * t);
        light += n_dot_l * radiance(l, density);
        weight += n_dot_l;
    }
    return weight > 0.0 ? light / weight : glm::dvec3(0.0);
}

EnvironmentMap halved(const EnvironmentMap& map) {
    const int side = map.grid().side() / 2;
    Image image(6 * side, side, 3);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < 6 * side; ++column)
            for (int c = 0; c < 3; ++c) {
                float sum = 0.0F;
                for (int y = 0; y < 2; ++y)
                    for (int x = 0; x < 2; ++x)
                        sum += map.image().at(2 * column + x, 2 * row + y)[c];
                image.at(column, row)[c] = 0.25F * sum;
            }
    return EnvironmentMap::of_valid(*EnvironmentGrid::create(EnvironmentLayout::cube_strip, 6 * side, side),
                                    std::move(image), map.nits_per_unit());
}

} // namespace

std::vector<glm::dvec3> prefiltered_by_quadrature(const EnvironmentMap& map, std::span<const LobeQuery> queries,
                                                  unsigned threads) {
    std::vector<GgxLobe> lobes;
    lobes.reserve(queries.size());
    for (const LobeQuery& query : queries)
        lobes.emplace_back(query.roughness);
    const EnvironmentGrid& grid = map.grid();
    const double reach = grid.texel_reach();
    using Sums = std::vector<glm::dvec3>;
    std::vector<Sums> rows(static_cast<std::size_t>(grid.height()));
    parallel_for(rows.size(), threads, [&](std::size_t at) {
        const int row = static_cast<int>(at);
        Sums sums(queries.size(), glm::dvec3(0.0));
        for (int column = 0; column < grid.width(); ++column) {
            const TexelIndex texel{column, row};
            if (!grid.covers(texel)) continue;
            const glm::dvec3 light = map.texel(texel);
            if (light == glm::dvec3(0.0)) continue;
            const detail::TexelOutline outline = detail::outline_of(grid, texel);
            const glm::dvec3 middle = grid.direction({column + 0.5, row + 0.5});
            for (std::size_t i = 0; i < sums.size(); ++i)
                sums[i] += light * detail::LobeOverTexel<8>(lobes[i], queries[i].direction)(outline, middle, reach);
        }
        rows[at] = std::move(sums);
    });
    Sums total(queries.size(), glm::dvec3(0.0));
    for (const Sums& row : rows)
        for (std::size_t i = 0; i < total.size(); ++i)
            total[i] += row[i];
    for (std::size_t i = 0; i < total.size(); ++i)
        total[i] /= lobes[i].whole();
    return total;
}

glm::dvec3 prefiltered_by_samples(const EnvironmentMap& map, const LobeQuery& query, int count) {
    return mean_of_samples(query, count,
                           [&](const glm::dvec3& l, double) { return map.texel(map.grid().texel_at(l)); });
}

EnvironmentMips::EnvironmentMips(const EnvironmentMap& map, unsigned threads) {
    const EnvironmentGrid& grid = map.grid();
    const int like = side_like(grid.layout(), grid.side(), EnvironmentLayout::cube_strip);
    const int side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(1, like))));
    if (grid.layout() == EnvironmentLayout::cube_strip && grid.side() == side)
        levels_.push_back(map);
    else
        levels_.push_back(
            resampled(map, *EnvironmentGrid::create(EnvironmentLayout::cube_strip, 6 * side, side), {}, threads));
    while (levels_.back().grid().side() > 1)
        levels_.push_back(halved(levels_.back()));
    texel_solid_angle_ = 4.0 * pi / (6.0 * side * side);
}

glm::dvec3 EnvironmentMips::radiance(const glm::dvec3& direction, double level) const {
    const double at = std::clamp(level, 0.0, static_cast<double>(levels_.size() - 1));
    const auto sharper = static_cast<std::size_t>(at);
    const double share = at - static_cast<double>(sharper);
    const glm::dvec3 light = levels_[sharper].radiance(direction);
    return share > 0.0 ? (1.0 - share) * light + share * levels_[sharper + 1].radiance(direction) : light;
}

glm::dvec3 prefiltered_by_filtered_samples(const EnvironmentMips& mips, const LobeQuery& query, int count) {
    constexpr double k = 4.0;
    return mean_of_samples(query, count, [&](const glm::dvec3& l, double density) {
        const double of_sample = 1.0 / (count * density);
        return mips.radiance(l, 0.5 * std::log2(k * of_sample / mips.texel_solid_angle()));
    });
}

} // namespace gonio
