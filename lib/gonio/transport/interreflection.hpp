// Interreflection: the light that the surfaces of a stage send each other.
//
// Each surface scatters light in all directions alike, per channel: direct light with the directional albedo of its own
// material, light that bounced with the albedo over both hemispheres. What a glossy lobe reflects of direct light goes
// where the lobe sends it, if there are not too many lights (thrown_light.hpp). Direct light is known on patches, what
// bounces is solved on cells by rays of fixed directions, and its illuminance is then gathered at nodes, between which
// it is interpolated. There is no noise. README.md has the method, its error and its cost.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/lighting_options.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gonio {

namespace detail {
class ExchangeGeometry;
class SkyLight;
struct SurroundingsReflectance;
struct PatchPlace;
class ThrownLight;
struct NodeValue;
struct Sent;
struct SentSlopes;
} // namespace detail

// How finely a stage is divided. The defaults are those of the benchmark's front.
struct ExchangeQuality {
    double patches = 8000.0;          // about as many carry direct light
    std::size_t cell_rays = 128;      // of each cell of 2×2 patches, in the solution; 0: for a sky alone
    std::size_t node_rays = 512;      // of each node, in the last gathering; 0: for receivers alone
    double node_spacing = 1.0;        // multiplies the distances between nodes
    std::size_t receiver_rays = 8192; // of a point that is not on a surface
    std::size_t sky_rays = 1024;      // of each node under a sky, whose light no surface has spread before

    friend bool operator==(const ExchangeQuality&, const ExchangeQuality&) = default;
};

// What balances in a stage, per channel [lm]: received = direct + indirect light on all surfaces.
struct ExchangeBalance {
    glm::dvec3 direct_lm{0.0};
    glm::dvec3 indirect_lm{0.0};
    glm::dvec3 absorbed_lm{0.0};
    glm::dvec3 escaped_lm{0.0}; // reflected out of the stage, or to the backs of one-sided surfaces
};

class Interreflection {
public:
    // Stage and lights are not needed afterwards. Uses these options: bounces, of which there must be at least one;
    // shadows, sky, threads, instruction_set. Fails (usage) on a closed stage that absorbs nothing, which has no
    // solution. `known`: for the same surfaces in any materials, and lights at the same positions that emit to the same
    // sides, what depends on these alone is taken from it; and all of it, if nothing but a factor changed that is
    // common to all lights.
    static Result<Interreflection> of(const Stage& stage, std::span<const Light> lights, const LightingOptions& options,
                                      const ExchangeQuality& quality = {}, const Interreflection* known = nullptr);

    // Illuminance by indirect light of a point on a surface, per channel [lx]: colours of luminance 1, so the
    // illuminance is the luminance of the three.
    glm::dvec3 on_surface(std::size_t surface, int face, const glm::dvec3& position) const;

    // The same at any point, which a bundle of its own rays gathers. `normal` is unit.
    glm::dvec3 at(const glm::dvec3& position, const glm::dvec3& normal) const;

    // The luminance that a point of a chart sends along a ray to its unit direction `towards`, per channel [nt], direct
    // light included: between the middles of patches. `fine_m`: the distance to the next ray. `left_out`: the share,
    // per channel, of what bounced before that is left out. For the transport room itself.
    glm::vec3 luminance_at(const detail::PatchPlace& place, float fine_m, const glm::vec3& towards,
                           const glm::vec3& left_out = glm::vec3(0.0F)) const;
    const std::shared_ptr<const detail::ExchangeGeometry>& geometry() const { return geometry_; }
    // The same illuminance by node of the geometry.
    std::span<const detail::NodeValue> nodes_lx() const;
    // What surfaces receive of the options' sky; null without one.
    const std::shared_ptr<const detail::SkyLight>& sky() const { return sky_; }

    // What the surfaces of a picture reflect of each other, kept here for the next one.
    const std::vector<std::shared_ptr<const detail::SurroundingsReflectance>>& reflectances() const {
        return reflectances_;
    }
    void keep(std::vector<std::shared_ptr<const detail::SurroundingsReflectance>> reflectances) {
        reflectances_ = std::move(reflectances);
    }

    int bounces() const { return bounces_; }
    const ExchangeBalance& balance() const { return balance_; }
    std::size_t node_count() const;
    std::size_t patch_count() const;
    // Of what is kept, in bytes.
    std::size_t memory() const;

    Interreflection(const Interreflection& other);
    Interreflection(Interreflection&& other) noexcept;
    Interreflection& operator=(const Interreflection& other);
    Interreflection& operator=(Interreflection&& other) noexcept;
    ~Interreflection();

private:
    Interreflection();
    std::optional<glm::dvec3> change_to(const Stage& stage, std::span<const Light> lights,
                                        const LightingOptions& options, const ExchangeQuality& quality) const;
    Interreflection times(const glm::dvec3& rgb) const;
    void sum_up(bool to_the_end, unsigned threads);
    glm::dvec3 reflected_lx(std::uint32_t patch, const glm::dvec3& indirect_lx) const;
    std::vector<glm::dvec3> finely_to_nodes(unsigned threads) const;
    std::vector<detail::Sent> seen_from_nodes(std::span<const glm::dvec3> indirect_lx) const;
    std::vector<detail::NodeValue> gathered(std::span<const detail::Sent> sent, std::size_t step,
                                            unsigned threads) const;
    std::vector<detail::NodeValue> gathered_of_uniform() const;
    std::vector<glm::dvec3> on_patches(std::span<const detail::NodeValue> nodes_lx, unsigned threads) const;

    std::shared_ptr<const detail::ExchangeGeometry> geometry_;
    std::shared_ptr<const detail::SkyLight> sky_;
    std::vector<std::shared_ptr<const detail::SurroundingsReflectance>> reflectances_;
    std::vector<Light> lights_;
    std::vector<Material> materials_; // by surface
    int bounces_ = 0;
    Shadows shadows_ = Shadows::soft;
    std::vector<glm::dvec3> albedo_;              // by surface
    std::vector<glm::dvec3> direct_lx_;           // by patch
    std::vector<glm::dvec3> direct_reflected_lx_; // what of it leaves again
    std::vector<glm::dvec3> direct_spread_lx_;    // what of that goes in all directions alike
    std::shared_ptr<const detail::ThrownLight> thrown_;
    std::shared_ptr<const detail::SentSlopes> slopes_; // of the direct light
    std::vector<glm::dvec3> direct_to_nodes_lx_;       // of slopes and of what is thrown
    std::vector<detail::NodeValue> nodes_lx_;
    std::vector<detail::Sent> sent_;             // what rays and links carry, by patch and then by cell [lx]
    std::vector<detail::Sent> shown_lx_;         // all that is sent, by patch
    std::vector<detail::Sent> bounced_shown_lx_; // what of it bounced before
    ExchangeBalance balance_;
    std::size_t receiver_rays_ = 0;
    simd::InstructionSet instruction_set_ = simd::best_available();
};

// The albedo over both hemispheres, per channel, in [0, 1]: the share of uniform light that the material reflects.
glm::dvec3 hemispherical_albedo(const Material& material, bool specular = true);

} // namespace gonio
