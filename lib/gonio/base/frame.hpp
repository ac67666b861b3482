// Directions and frames, in GLM vectors.
//
// Right-handed. In a light's frame γ = 0 (nadir, the aim) is −Z, C0 is +X and C90 is +Y, so the direction of (C, γ) is
// (sinγ cosC, sinγ sinC, −cosγ): the light frame of glTF and USD. Angles are radians.
#pragma once

#include <gonio/base/quantity.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// C in [0, 2π) counted from +X towards +Y, γ in [0, π] counted from −Z.
struct PolarAngles {
    Radians c;
    Radians gamma;
};

// Unit vector; any C, any γ.
glm::dvec3 direction_of(PolarAngles angles);

// Angles of a vector of any length > 0. At the poles, where C has no meaning, C is 0.
PolarAngles angles_of(const glm::dvec3& direction);

// The orthonormal frame of a placed light or camera.
struct Frame {
    glm::dvec3 origin{0.0, 0.0, 0.0};
    glm::dvec3 x{1.0, 0.0, 0.0};
    glm::dvec3 y{0.0, 1.0, 0.0};
    glm::dvec3 z{0.0, 0.0, 1.0};

    glm::dvec3 to_local(const glm::dvec3& world_direction) const {
        return {glm::dot(world_direction, x), glm::dot(world_direction, y), glm::dot(world_direction, z)};
    }
    glm::dvec3 to_world(const glm::dvec3& local_direction) const {
        return local_direction.x * x + local_direction.y * y + local_direction.z * z;
    }
};

// Z = −direction, Y = `up` made orthogonal to Z, X = Y×Z. `direction` and `up` may have any length > 0; if `up` is
// parallel to the direction, +Y is used instead, or +Z if that is parallel too.
Frame aimed_frame(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& up);

} // namespace gonio
#pragma GCC visibility pop
