// A glossy lobe of a material as a few rays for each view, and as its share of uniform light.
#pragma once

#include <gonio/scene/core_material.hpp>
#include <gonio/shading/anisotropic_lobe.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace gonio::detail {

// In the surface's own frame: the normal is Z, the view lies in the plane of X and Z with x ≥ 0.
struct LobeRay {
    glm::vec3 direction{0.0F}; // not quite unit
    glm::vec3 weight{0.0F};    // of the luminance in its direction, per channel
    float width = 0.0F;        // roughly the angle to the rays beside it [rad]
};

// How facets are drawn.
struct LobeFacets {
    shading::AnisotropicAlpha<double> alphas;
    std::optional<shading::Grain<double>> grain; // none: both are the same
};

// Visible normals of the GGX lobe of the material's α (E. Heitz, "Sampling the GGX Distribution of Visible Normals",
// 2018) at the points of a lattice, in a table over the cosine of the view. Weights are f ⟨n·l⟩/pdf, scaled so that
// they add up to the lobe's directional albedo of many more samples. A black lobe has no rays.
class LobeRays {
public:
    // `value(n, l, v)` is the lobe [1/sr], of about the width of `facets`. `more` times as many rays as usual, of wide
    // lobes of metals three times that.
    template<class Value>
    LobeRays(const LobeFacets& facets, const Value& value, std::size_t more);

    bool empty() const { return rays_ == 0; }
    bool is_metal() const { return is_metal_; } // reflects much at every angle
    std::size_t count() const { return rays_; } // for each view
    double alpha() const { return alpha_; }     // of GGX

    // A view, for ray().
    struct View {
        std::size_t first = 0;  // in the table, of the two views beside it
        float share = 0.0F;     // of the second
        std::size_t beside = 0; // as `first`, at the next azimuth
        float share_beside = 0.0F;
        glm::vec3 direction{0.0F, 0.0F, 1.0F};
    };
    // `aside` is the unit direction in which the view leans from the normal.
    View view(double cosine, const glm::dvec3& normal, const glm::dvec3& aside) const;
    // One of count(); those below the surface have the weight 0.
    LobeRay ray(const View& view, std::size_t index) const;
    // The directional albedo of the lobe alone, per channel.
    glm::dvec3 albedo(double cosine) const;
    // Over both hemispheres.
    glm::dvec3 albedo() const;

private:
    // From table_, at a place of first or beside.
    LobeRay between(std::size_t first, float share, std::size_t index) const;

    std::size_t rays_ = 0;
    std::optional<shading::Grain<double>> grain_; // of an anisotropic lobe
    double alpha_ = 0.0;
    bool is_metal_ = false;
    // Of each ray the normal of the facet that reflects it, instead of its direction, which changes faster with the
    // view; [azimuth][node][ray], at the cosines (i/(n−1))². Azimuths are from the tangent, over half a turn; one
    // without a grain.
    std::vector<LobeRay> table_;
    std::vector<glm::dvec3> albedo_;
};

// The lobes of a material that are not black: none, one, or that of a coat and the one below it.
// `more` times as many rays: for skies, whose brightest parts lie beside the dark bodies that hide them.
std::vector<LobeRays> lobe_rays(const CoreMaterial& material, std::size_t more = 1);

// Whether any of them is_metal().
bool has_metal_lobe(const CoreMaterial& material);

} // namespace gonio::detail
