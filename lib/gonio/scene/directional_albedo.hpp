// The share of uniform light that a surface reflects towards a view, and of light from one direction in all.
#pragma once

#include <gonio/scene/core_material.hpp>

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace gonio {

// The luminance of a surface under a uniform sky of luminance 1: its directional albedo, by channel; of an anisotropic
// one its mean over all azimuths. A table over the cosine of the view, computed once per material; Lambert's is exact,
// others are within 0.5 % (a lattice of 1024 directions each).
class DirectionalAlbedo {
public:
    enum class Fineness : std::uint8_t {
        coarse, // a twelfth of the time, within 1 %
        fine
    };
    DirectionalAlbedo() = default; // to be assigned
    explicit DirectionalAlbedo(const CoreMaterial& material, Fineness fineness = Fineness::fine);

    glm::dvec3 operator()(double cosine) const;

    // Of light that is uniform over the hemisphere, in [0, 1]: 2 ∫ A(µ) µ dµ. Lambert's is its albedo.
    glm::dvec3 over_hemisphere() const;

private:
    std::vector<glm::dvec3> albedo_; // at the cosines (i/(n−1))²; a single one for Lambert
};

} // namespace gonio
