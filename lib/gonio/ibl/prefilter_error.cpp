#include <gonio/ibl/prefilter_error.hpp>
#include <gonio/ibl/prefilter_methods.hpp>
#include <gonio/light/light_color.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gonio {

std::vector<PrefilterError> prefilter_errors(const EnvironmentMap& source, std::span<const PrefilteredLevel> levels,
                                             int per_level, unsigned threads) {
    std::vector<LobeQuery> queries;
    std::vector<glm::dvec3> stored;
    std::vector<std::size_t> level_of_query;
    for (std::size_t level = 0; level < levels.size(); ++level) {
        if (!(levels[level].roughness > 0.0)) continue;
        const EnvironmentMap& map = levels[level].map;
        const EnvironmentGrid& grid = map.grid();
        std::vector<TexelIndex> texels;
        for (int row = 0; row < grid.height(); ++row)
            for (int column = 0; column < grid.width(); ++column)
                if (grid.covers({column, row})) texels.push_back({column, row});
        const std::size_t count = std::min(texels.size(), static_cast<std::size_t>(std::max(1, per_level)));
        for (std::size_t i = 0; i < count; ++i) {
            // A texel of each of `count` parts of the picture, each at another place in its part: by the golden ratio.
            constexpr double golden_ratio = 0.6180339887498949;
            const double place = static_cast<double>(i) * golden_ratio;
            const double at = (static_cast<double>(i) + place - std::floor(place)) / static_cast<double>(count);
            const TexelIndex texel = texels[static_cast<std::size_t>(at * static_cast<double>(texels.size()))];
            queries.push_back({grid.direction({texel.column + 0.5, texel.row + 0.5}), levels[level].roughness});
            stored.push_back(map.texel(texel));
            level_of_query.push_back(level);
        }
    }
    const std::vector<glm::dvec3> exact = prefiltered_by_quadrature(source, queries, threads);
    std::vector<PrefilterError> errors(levels.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
        PrefilterError& error = errors[level_of_query[i]];
        ++error.texels;
        error.mean_nt += glm::dot(exact[i], rec709_luminance);
        for (int c = 0; c < 3; ++c) {
            const double apart = std::abs(stored[i][c] - exact[i][c]);
            error.rms += apart * apart / 3.0;
            error.greatest = std::max(error.greatest, apart);
        }
    }
    for (PrefilterError& error : errors) {
        if (error.texels == 0) continue;
        error.mean_nt /= error.texels;
        const double scale = error.mean_nt > 0.0 ? 1.0 / error.mean_nt : 0.0;
        error.rms = scale * std::sqrt(error.rms / error.texels);
        error.greatest *= scale;
    }
    return errors;
}

} // namespace gonio
