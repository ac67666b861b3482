// A luminous opening that is far away as a point at its centre, with a bound of the difference: by inequality, for all
// points of a group at once.
//
// The exact light of a flat opening is ∫ L(ω_x) f ⟨n·l⟩ dω over its places x. From far away it is nearly that of a
// point with the intensity of the profile, which costs a fraction: no form factor, no columns, no rule over the lobe.
// Far lights as points are the oldest approximation of many lights (E. Paquette, P. Poulin, G. Drettakis, "A Light
// Hierarchy for Fast Rendering of Scenes with Many Lights", Eurographics 1998; B. Walter and others, "Lightcuts",
// SIGGRAPH 2005). Their bounds are those of a cluster's greatest and least value, in the first order of its size over
// its distance; here the first order cancels between opposite places. Derived beside the code.
#pragma once

#include <gonio/scene/core_material.hpp>
#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/sample_bounds.hpp>
#include <gonio/transport/surface_samples.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>
#include <optional>

namespace gonio::detail {

// How fast a material can change with the direction of the light, as far as a bound needs it.
struct LobeVariation {
    // Of Lambert's, Frostbite's and GGX alone, without a coat; nothing for other materials, which have no bound.
    static std::optional<LobeVariation> of(const CoreMaterial& material);

    double alpha = 1.0;             // of the lobe
    double f0 = 0.0;                // the least of the channels
    double f90 = 0.0;               // both are 0 without a lobe
    double linear_roughness = -1.0; // of Frostbite's diffuse part; negative if the diffuse part is uniform, or dark
    bool has_lobe = false;
};

// From where the points of a group are seen.
struct ViewBounds {
    ViewBounds(const SurfaceSamples& samples, std::size_t first, std::size_t count);

    glm::dvec3 axis{0.0, 0.0, 1.0}; // unit
    double cosine = -1.0;           // of the angle about it that all views are within
};

// At each point, let V(I) be the light that a point with the intensity I [cd] gives; it is proportional to I. The
// opening's light is within V(share · I + cd) of V(I), with I what the web gives from the centre.
struct PointForm {
    double share = std::numeric_limits<double>::infinity();
    double cd = std::numeric_limits<double>::infinity();
    double most_lx = std::numeric_limits<double>::infinity(); // of illuminance that it is off, about the most

    bool is_bounded() const { return share < 1.0 && cd < std::numeric_limits<double>::infinity(); }
};

// Whether no point within the bounds gets light from a face of a flat opening, since its web is dark towards all of
// them from every place of the face. False for other lights.
bool is_web_dark(const LitLight& light, const SampleBounds& points);

// Unbounded for lights other than faces of flat openings, where the light is not all above the horizon of all points,
// and where it is too near. Neither fails nor allocates.
PointForm point_form(const LitLight& light, const SampleBounds& points, const ViewBounds& views,
                     const LobeVariation& lobe);

} // namespace gonio::detail
