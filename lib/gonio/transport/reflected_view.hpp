// What a glossy surface shows of the lit stage around it, and of the sky.
//
// A lobe's rays are cast at the corners of squares of pixels. Where all four rays of one kind meet the same surface
// close together, or the sky, what they show is interpolated between; all other rays are cast at each point. Which are,
// depends on surfaces alone, so that the shares of several lights add up.
//
// Where a ray meets a metal, it goes on once as a ray of the metal's own lobe: what bounced before and a
// metal reflects is taken from there, since light between metals keeps its direction. Which ray of the lobe, depends on
// the number of the first.
#pragma once

#include <gonio/sky/blurred_sky.hpp>
#include <gonio/transport/bundle_caster.hpp>
#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/lobe_rays.hpp>
#include <gonio/transport/surface_samples.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::detail {

class ExchangeGeometry;

// One for each thread. Lights themselves are not seen: their highlights are direct light.
class ReflectedView {
public:
    // Without `indirect`, surfaces are black; without `sky`, what is around the stage is. They must outlive it.
    ReflectedView(const ExchangeGeometry& geometry, const Interreflection* indirect, const BlurredSky* sky,
                  const SurroundingsReflectances& surfaces, simd::InstructionSet set);

    // The luminance that the lobe of the samples' surface reflects [nt], by sample.
    const std::vector<glm::vec3>& luminance(const SurfaceSamples& samples, const SampleSquares& squares,
                                            const LobeRays& lobe);

private:
    // Sums over rays.
    struct Shown {
        glm::vec3 nt{0.0F};
        glm::vec3 kept{0.0F}; // weights that count
        glm::vec3 all{0.0F};  // weights

        void add(float share, const Shown& other) {
            nt += share * other.nt;
            kept += share * other.kept;
            all += share * other.all;
        }
    };
    // Where a ray from a corner ends.
    struct CornerEnd {
        PatchPlace place;
        glm::vec3 direction{0.0F};
        float width = 0.0F; // of the ray [rad]
        bool is_cast = false;
    };
    // A ray that goes on from a metal.
    struct OnMetal {
        std::uint32_t surface = 0;
        glm::dvec3 position{0.0};
        glm::dvec3 normal{0.0};
        glm::dvec3 view{0.0}; // where it came from
        glm::vec3 weight{0.0F};
        float width = 0.0F;
        std::uint32_t of = 0;
        std::uint32_t index = 0; // of the first ray in its lobe
    };
    // The lobe at a point.
    struct Mirror {
        bool is_seen = false;
        LobeRays::View view;
        glm::vec3 origin{0.0F}; // from the anchor of the samples
        glm::vec3 x{0.0F}, y{0.0F}, z{0.0F};
    };

    Mirror mirror(const SurfaceSamples& samples, std::size_t sample, const LobeRays& lobe) const;
    Mirror mirror(const glm::dvec3& from_anchor, const glm::dvec3& normal, const glm::dvec3& view,
                  const LobeRays& lobe) const;
    void add(const Mirror& mirror, const LobeRay& ray, std::uint32_t of, std::size_t index);
    glm::vec3 seen_at(const glm::dvec3& anchor, std::size_t ray, float between_m, const glm::vec3& weight,
                      bool goes_on);
    void add(const glm::dvec3& anchor, const OnMetal& at, const LobeRays& lobe);
    void go_on(const glm::dvec3& anchor, std::vector<Shown>& shown);
    void clear_rays();
    void cast(const SurfaceSamples& samples, std::vector<Shown>& shown, std::vector<CornerEnd>* ends);
    void cast_at_corners(const SampleSquares& squares, const LobeRays& lobe);
    bool is_even(const std::array<std::uint32_t, 4>& corners, std::size_t ray, std::size_t rays) const;

    const ExchangeGeometry& geometry_;
    const Interreflection* indirect_;
    const BlurredSky* sky_;
    const SurroundingsReflectances& surfaces_;
    bool has_metals_ = false;
    std::size_t rays_of_lobe_ = 1; // of the lobe whose rays are cast
    ScatteredCaster caster_;
    std::vector<float> width_m_;  // of the surface of each chart, where it is thinnest
    std::vector<float> per_turn_; // of each chart, metres for one of its u
    // Rays to be cast:
    std::array<std::vector<float>, 3> origin_, direction_;
    std::vector<glm::vec3> weight_;
    std::vector<float> ray_width_;     // [rad]
    std::vector<std::uint32_t> of_;    // which sum gets it
    std::vector<std::uint32_t> index_; // in its lobe
    std::vector<PatchPlace> ends_;
    std::vector<OnMetal> on_metal_;
    // Of squares:
    std::vector<Shown> at_corners_; // [corner][ray]
    std::vector<CornerEnd> corner_ends_;
    std::vector<std::array<Shown, 4>> between_; // of the rays that are interpolated
    std::vector<std::uint32_t> uneven_;         // the other rays of all squares
    std::vector<std::size_t> first_uneven_;
    std::vector<Shown> shown_; // by sample
    std::vector<glm::vec3> luminance_;
};

} // namespace gonio::detail
