// Other ways to a texel of a prefiltered environment, to measure against: a quadrature and what engines sample.
//
// All take the source as its texels, uniform over the directions that they cover, and the lobe of ggx_lobe.hpp.
#pragma once

#include <gonio/sky/environment_map.hpp>

#include <glm/vec3.hpp>

#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// The lobe to integrate over.
struct LobeQuery {
    glm::dvec3 direction; // unit
    double roughness;     // linear, in (0, 1]
};

// By quadrature, RGB [cd/m²], within 1e-7 of the map's mean: the lobe over each texel is an integral along the texel's
// outline, by Gauss nodes, Σ over all texels in one pass for all queries. About 0.2 µs a texel and query.
std::vector<glm::dvec3> prefiltered_by_quadrature(const EnvironmentMap& map, std::span<const LobeQuery> queries,
                                                  unsigned threads = 0);

// Plain importance sampling: `count` GGX samples at Hammersley points, weighted by n·l.
glm::dvec3 prefiltered_by_samples(const EnvironmentMap& map, const LobeQuery& query, int count);

// A source with its mip levels: each texel the mean over 2×2 texels of the level above.
class EnvironmentMips {
public:
    // A cube-strip whose side is a power of two; other maps are resampled to one of about their size.
    explicit EnvironmentMips(const EnvironmentMap& map, unsigned threads = 0);

    [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction, double level) const;
    [[nodiscard]] double texel_solid_angle() const { return texel_solid_angle_; }

private:
    std::vector<EnvironmentMap> levels_;
    double texel_solid_angle_ = 0.0; // of level 0, on average
};

// Filtered importance sampling (J. Křivánek and M. Colbert, "Real-time Shading with Filtered Importance Sampling",
// 2008), as Filament's cmgen does it: each sample from level log4(K Ωs/Ωp), K = 4.
glm::dvec3 prefiltered_by_filtered_samples(const EnvironmentMips& mips, const LobeQuery& query, int count);

} // namespace gonio
#pragma GCC visibility pop
