// Prefiltered environments: what a glossy surface of each roughness mirrors, one image per level.
//
// The lobe and its weights are those of ggx_lobe.hpp, which Unreal Engine, Frostbite and Filament share; they differ in
// which level holds which roughness (roughness_mapping.hpp) and in the direction that they look up. A texel holds the
// lobe about the direction of its middle; in a level of roughness 0 the mean over its solid angle. The same for any
// number of threads; 0: all.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/ibl/roughness_mapping.hpp>
#include <gonio/sky/environment_map.hpp>

#include <glm/vec3.hpp>

#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

class EnvironmentTree;

// An environment blurred by one lobe.
struct PrefilteredLevel {
    double roughness; // linear
    EnvironmentMap map;
};

// An environment blurred by the lobes of growing roughness.
class PrefilteredEnvironment {
public:
    // At least one level, the sharpest first, with the roughnesses of the mapping.
    PrefilteredEnvironment(std::vector<PrefilteredLevel> levels, RoughnessMapping mapping);

    [[nodiscard]] std::span<const PrefilteredLevel> levels() const { return levels_; }
    [[nodiscard]] RoughnessMapping mapping() const { return mapping_; }

    // RGB [cd/m²] for a direction of any length > 0 and a roughness in [0, 1]: bilinear in a level, linear between
    // levels, as a texture unit does it.
    [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction, double roughness) const;

private:
    std::vector<PrefilteredLevel> levels_;
    RoughnessMapping mapping_;
};

// What to prefilter an environment for.
struct PrefilterOptions {
    EnvironmentLayout layout = EnvironmentLayout::cube_strip;
    int side = 256; // of level 0 (EnvironmentGrid::side()); each level has half of the one before
    int levels = 5;
    RoughnessMapping mapping = RoughnessMapping::linear;
    double tolerance = 1e-5; // EnvironmentTree::mean()
    unsigned threads = 0;
};

// Fails (usage) on a size that cannot be halved that often (at least 1 texel a side, 2 for an octahedral and a
// lat-long), on fewer than 1 level, and above the limit environment-values.
Result<void> check_levels(const PrefilterOptions& options);

// Fails as check_levels(). The second form takes the tree of the source, which other levels may share.
Result<PrefilteredEnvironment> prefilter(const EnvironmentMap& source, const PrefilterOptions& options);
Result<PrefilteredEnvironment> prefilter(const EnvironmentMap& source, const EnvironmentTree& tree,
                                         const PrefilterOptions& options);

// One level: of a tree, so that several share it. Roughness in (0, 1].
EnvironmentMap prefiltered(const EnvironmentTree& tree, const EnvironmentGrid& to, double roughness, double tolerance,
                           unsigned threads = 0);

// The illuminance over π of a plane that faces the direction of each texel, RGB [cd/m²]: a matte white surface's
// luminance.
EnvironmentMap irradiance_map(const EnvironmentTree& tree, const EnvironmentGrid& to, double tolerance,
                              unsigned threads = 0);

} // namespace gonio
#pragma GCC visibility pop
