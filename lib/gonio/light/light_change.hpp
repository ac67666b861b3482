// Lights that differ in amount and colour alone: light is linear, so what the one gives follows from the other.
#pragma once

#include <gonio/light/light.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <span>

namespace gonio {

// Factors from one light to another.
struct LightChange {
    double amount = 1.0;
    glm::dvec3 rgb{1.0}; // of amount and colour together, per channel

    bool is_of_color() const;
};

// The factor that is common to all lights, which are the same but for their amounts and colours. Empty if there is
// none, if a light or a channel that was dark is lit, and without lights.
std::optional<LightChange> common_change(std::span<const Light> before, std::span<const Light> now);

// Whether the lights are the same but for their amounts, colours and names. False, too, for lights whose profiles,
// masks or images were read anew (gonio/light/kept_profiles.hpp).
bool differ_in_amount_alone(std::span<const Light> a, std::span<const Light> b);

} // namespace gonio
