// An environment as a tree of texels and blocks of texels, for sums of light weighted by a lobe.
//
// A block of 2×2 children has the sum of their light and its moments up to the second, so a lobe that is nearly
// quadratic over a block takes the whole block at once (the second moment is that of the luminance, for all channels).
// Where that is not good enough, its children are taken, down to the texels, which are uniform over the directions that
// they cover; a lobe that is narrow beside a texel is integrated along its outline. Weights are summed alongside, so
// that a uniform environment stays uniform.
#pragma once

#include <gonio/ibl/ggx_lobe.hpp>
#include <gonio/sky/environment_map.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// The moments of an environment by blocks of texels, from which means over lobes are fast.
class EnvironmentTree {
public:
    static constexpr std::size_t most_leaves = std::size_t{1} << 21;

    // About 180 bytes a texel, and 450 while it is made. If the map has more texels than `leaves`, the leaves are
    // blocks of them, which have exact moments but are not divided for a narrow lobe.
    explicit EnvironmentTree(const EnvironmentMap& map, unsigned threads = 0, std::size_t leaves = most_leaves);

    // The weighted mean of the light, RGB [cd/m²], for a unit direction. A block is divided while its estimated error
    // is greater than `tolerance` times the map's mean luminance; the sum is some times less exact (README.md).
    [[nodiscard]] glm::dvec3 mean(const GgxLobe& lobe, const glm::dvec3& direction, double tolerance) const;

    // The mean over all directions, RGB [cd/m²].
    [[nodiscard]] const glm::dvec3& mean() const { return mean_; }

    [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }

private:
    struct Node {
        std::array<float, 3> middle; // unit direction
        float reach;                 // no direction of it is farther from the middle [rad]
        float solid_angle;           // [sr]
        float spread;                // half the mean square of the distance from the middle
        float unevenness;            // root mean square of the luminance's difference from a linear one, over its mean
        std::array<float, 3> light;  // ∫ L dω
        std::array<float, 9> moment; // ∫ L (ω − middle) dω, channel by channel
        std::array<float, 6> extent; // the mean of d dᵀ, d = ω − middle: xx yy zz xy xz yz
        std::array<float, 6> second; // the same weighted by the luminance over its mean
    };
    // Its children are up to 2×2 nodes, whose rows lie `row_length` apart; `across` is 0 if there are none.
    struct Link {
        std::int32_t first;
        std::int32_t row_length;
        std::int16_t across;
        std::int16_t down;
    };
    struct Sum;

    EnvironmentGrid grid_;
    std::vector<Node> nodes_; // blocks after their children
    std::vector<Link> links_;
    std::vector<std::int32_t> roots_;
    std::vector<TexelIndex> places_; // of the first nodes, if these are texels
    glm::dvec3 mean_{0.0};
};

} // namespace gonio
#pragma GCC visibility pop
