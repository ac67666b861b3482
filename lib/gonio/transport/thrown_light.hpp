// What glossy surfaces throw of the lights' direct light: its glossy part, which goes where the lobe of the material
// sends it, not in all directions.
//
// Of each light a patch has its illuminance and the light's direction at its middle. The lobe is widened by the size of
// the light, by what normal and direction change within the patch, and by the distance between the rays that meet it,
// so that no ray has to find a narrow lobe by chance. A wide lobe has about the same albedo, so the light is kept.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/directional_albedo.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/ray_bundle.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gonio::detail {

// With more lights, dark ones included, all light is spread in all directions: the cost is that of each light at each
// ray. It is the number of lights that counts, not what they give, so that the lights' shares add up.
inline constexpr std::size_t most_throwing_lights = 8;

// A material's glossy lobe, if light is thrown by it: not that of a coat and what is below it.
struct ThrowingLobe {
    bool is_ggx = true; // or a power of the cosine
    float alpha = 1.0F; // of GGX, or of the GGX lobe with the same peak
    float f90 = 1.0F;
    float factor = 1.0F;
    glm::vec3 f0{0.0F};
    std::optional<shading::AnisotropicGgxLobe<float>> anisotropic; // instead of GGX of alpha
    DirectionalAlbedo whole;                                       // of the lobe and
    DirectionalAlbedo rest;                                        // of what else the material scatters

    // The share of light from this cosine that the lobe reflects, per channel.
    glm::dvec3 share(double cosine) const;
};
std::optional<ThrowingLobe> throwing_lobe(const CoreMaterial& material, const DirectionalAlbedo& whole);

// What one light gives to the patches whose materials have such a lobe.
struct ThrowingLight {
    std::vector<glm::vec3> lx;        // by patch; none if the light is dark
    std::vector<glm::vec3> thrown_lx; // what the lobe reflects of it
};

class ThrownLight {
public:
    ThrownLight() = default;
    // `shares` by light and `lobes` by surface; no shares: nothing is thrown.
    ThrownLight(const Patches& patches, std::span<const Light> lights, std::span<const ThrowingLight> shares,
                std::span<const std::optional<ThrowingLobe>> lobes);

    // The same with all light times these factors, per channel.
    ThrownLight times(const glm::vec3& rgb) const;

    bool empty() const { return lobes_.empty(); }
    bool comes_from(std::size_t surface) const { return !empty() && lobes_[surface].has_value(); }

    // π times the luminance that the patches around a point send along a unit direction, to a ray that is this far from
    // others [rad].
    glm::vec3 along(const PatchMean& around, const glm::vec3& direction, float between_rays) const;

    // The illuminance that a place gathers of it by its rays and links.
    glm::dvec3 gathered(const Bundles& bundles, std::size_t place, const Receivers::Place& at) const;

    std::size_t memory() const;

private:
    // Of a patch, a cell or a group of cells.
    struct Sender {
        glm::vec3 normal{0.0F};
        glm::vec3 position{0.0F};
        std::uint32_t surface = 0;
        std::uint32_t first = 0; // of its shares, one for each light that is not dark
        float carried = 1.0F;    // Patches::carried()
    };
    struct Share {
        glm::vec3 lx{0.0F};
        glm::vec3 towards{0.0F}; // the light
        float widening2 = 0.0F;  // of α²
    };
    glm::vec3 along(const Sender& sender, const glm::vec3& direction, float widening2) const;

    static constexpr std::uint32_t nothing = 0xffffffffU;
    std::size_t lights_ = 0; // that are not dark
    std::vector<std::optional<ThrowingLobe>> lobes_;
    std::vector<std::uint32_t> index_; // by number of the sender, in senders_
    std::vector<Sender> senders_;
    std::vector<Share> shares_;
};

} // namespace gonio::detail
