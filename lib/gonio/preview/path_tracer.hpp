// Light by paths of light: what reaches a surface point from the lights directly, and over other surfaces.
//
// Each vertex of a path estimates direct light by multiple importance sampling between each light and the material
// (balance heuristic, E. Veach and L. Guibas, SIGGRAPH 1995) and continues in a direction of its material. Russian
// roulette ends paths without bias. Lights do not block paths, and the backs of one-sided surfaces absorb them, as in
// direct light. What a surface emits is a light: a path that arrives there adds what it reflects.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/transport/ray_caster.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gonio::detail {

// Numbers in [0, 1) for one pixel and pass. The first direction of a path is drawn from an additive recurrence in seven
// dimensions (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018), shifted by a number that
// depends on the pixel: the fractional parts of multiples of 1/g, 1/g², …, where g⁸ = g + 1.
class PixelSequence {
public:
    static constexpr std::size_t dimensions = 7;

    PixelSequence(std::size_t pass, std::uint32_t pixel) : pass_(pass), pixel_(pixel) {}

    // `turn` shifts all numbers: 0 for the pixel itself, other values for the lights and for the first bounce.
    double operator()(std::size_t dimension, std::uint32_t turn) const;
    // Independent of all others: for vertices after the first.
    double independent(std::uint32_t vertex, std::uint32_t dimension) const;

private:
    std::size_t pass_;
    std::uint32_t pixel_;
};

// What a surface shows and what it receives.
struct Shown {
    glm::dvec3 rgb{0.0}; // luminance [nt]
    double lx = 0.0;
};

class PathTracer {
public:
    struct Options {
        bool shadows = true;
        bool specular = true;           // false: only the diffuse parts of materials
        std::shared_ptr<const Sky> sky; // null: none
        int bounces = 0;
        bool illuminance = false; // also estimates Shown::lx of what bounced
    };

    // Stage and lights must outlive it.
    PathTracer(const Stage& stage, std::span<const Light> lights, const Options& options);

    // An estimate of the light that the hit shows towards `view`, direct and indirect.
    Shown at(const Hit& hit, const glm::dvec3& view, const PixelSequence& numbers) const;

    // An estimate of indirect light on a point of a surface: its illuminance per channel.
    glm::dvec3 indirect_lx(const Hit& hit, const PixelSequence& numbers) const;

    bool is_dark(std::size_t light) const { return is_dark_[light] != 0; }

private:
    // The luminance that arrives from `direction` after one bounce or more, per channel.
    glm::dvec3 arriving(std::size_t surface, const glm::dvec3& position, const glm::dvec3& normal,
                        const glm::dvec3& direction, const PixelSequence& numbers, std::uint32_t stream) const;
    glm::dvec3 direct(const Hit& hit, const glm::dvec3& view, const PixelSequence& numbers, std::uint32_t vertex) const;

    const Stage& stage_;
    std::span<const Light> lights_;
    Options options_;
    RayCaster caster_;
    std::vector<CoreMaterial> materials_; // by surface
    std::vector<std::uint8_t> is_dark_;   // by light
    std::vector<std::size_t> shining_;    // the lights that are not dark
    std::vector<double> chance_;          // sums of the chances by which one of them is drawn, if they are many
};

struct IndirectEstimate {
    glm::dvec3 lx{0.0}; // per channel
    glm::dvec3 standard_error_lx{0.0};
};

// By `paths` paths in independent groups.
IndirectEstimate indirect_by_paths(const PathTracer& tracer, const Hit& hit, std::size_t paths, std::uint32_t seed);

} // namespace gonio::detail
