#include <gonio/base/parallel.hpp>
#include <gonio/ibl/environment_tree.hpp>
#include <gonio/ibl/ggx_lobe.hpp>
#include <gonio/ibl/prefilter.hpp>
#include <gonio/sky/environment_resample.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gonio {

namespace {

// Of each level, from the sharpest.
Result<std::vector<EnvironmentGrid>> grids_of(const PrefilterOptions& options) {
    if (options.levels < 1) return fail("USE0106", "a prefiltered environment has at least one level", "for example 5");
    // A lat-long's height and an octahedral's side are even.
    const bool is_cube =
        options.layout != EnvironmentLayout::latlong && options.layout != EnvironmentLayout::octahedral;
    const int least = is_cube ? 1 : 2;
    std::vector<EnvironmentGrid> grids;
    int side = options.side;
    for (int level = 0; level < options.levels; ++level) {
        Result<EnvironmentGrid> grid = environment_grid(options.layout, side);
        if (!grid) return pass_on(grid);
        grids.push_back(*grid);
        if (level + 1 < options.levels && (side % 2 != 0 || side / 2 < least))
            return fail("USE0106",
                        fmt::format("{} levels need a size that can be halved {} times, to {} or more; {} cannot",
                                    options.levels, options.levels - 1, least, options.side),
                        "a power of two, or fewer levels");
        side /= 2;
    }
    return grids;
}

} // namespace

PrefilteredEnvironment::PrefilteredEnvironment(std::vector<PrefilteredLevel> levels, RoughnessMapping mapping)
    : levels_(std::move(levels)), mapping_(mapping) {}

glm::dvec3 PrefilteredEnvironment::radiance(const glm::dvec3& direction, double roughness) const {
    const int last = static_cast<int>(levels_.size()) - 1;
    const double level = level_of(mapping_, roughness, last);
    const int below = std::min(static_cast<int>(level), last);
    const double share = level - below;
    const glm::dvec3 sharper = levels_[static_cast<std::size_t>(below)].map.radiance(direction);
    if (!(share > 0.0)) return sharper;
    const glm::dvec3 rougher = levels_[static_cast<std::size_t>(below) + 1].map.radiance(direction);
    return (1.0 - share) * sharper + share * rougher;
}

EnvironmentMap prefiltered(const EnvironmentTree& tree, const EnvironmentGrid& to, double roughness, double tolerance,
                           unsigned threads) {
    const GgxLobe lobe(roughness);
    Image image(to.width(), to.height(), 3);
    parallel_for(static_cast<std::size_t>(to.height()), threads, [&](std::size_t at) {
        const int row = static_cast<int>(at);
        for (int column = 0; column < to.width(); ++column) {
            if (!to.covers({column, row})) continue;
            const glm::dvec3 light = tree.mean(lobe, to.direction({column + 0.5, row + 0.5}), tolerance);
            for (int c = 0; c < 3; ++c)
                image.at(column, row)[c] = static_cast<float>(std::max(0.0, light[c]));
        }
    });
    return EnvironmentMap::of_valid(to, std::move(image), 1.0);
}

EnvironmentMap irradiance_map(const EnvironmentTree& tree, const EnvironmentGrid& to, double tolerance,
                              unsigned threads) {
    return prefiltered(tree, to, 1.0, tolerance, threads);
}

Result<void> check_levels(const PrefilterOptions& options) {
    Result<std::vector<EnvironmentGrid>> grids = grids_of(options);
    if (!grids) return pass_on(grids);
    return {};
}

Result<PrefilteredEnvironment> prefilter(const EnvironmentMap& source, const PrefilterOptions& options) {
    if (Result<void> possible = check_levels(options); !possible) return pass_on(possible);
    return prefilter(source, EnvironmentTree(source, options.threads), options);
}

Result<PrefilteredEnvironment> prefilter(const EnvironmentMap& source, const EnvironmentTree& tree,
                                         const PrefilterOptions& options) {
    Result<std::vector<EnvironmentGrid>> grids = grids_of(options);
    if (!grids) return pass_on(grids);
    std::vector<PrefilteredLevel> levels;
    for (std::size_t level = 0; level < grids->size(); ++level) {
        const EnvironmentGrid& grid = (*grids)[level];
        const double roughness = roughness_of(options.mapping, static_cast<double>(level), options.levels - 1);
        levels.push_back({roughness, roughness > 0.0
                                         ? prefiltered(tree, grid, roughness, options.tolerance, options.threads)
                                         : resampled(source, grid, {}, options.threads)});
    }
    return PrefilteredEnvironment(std::move(levels), options.mapping);
}

} // namespace gonio
