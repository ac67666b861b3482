// Material: how a surface answers light, by name and parameters. The reflectances themselves stand in shading/.
#pragma once

#include <gonio/base/result.hpp>

#include <glm/vec3.hpp>

#include <span>
#include <string_view>
#include <variant>

namespace gonio {

// Colours are linear Rec.709, each channel in [0, 1].
struct LambertMaterial {
    glm::dvec3 albedo{0.5};
};

// Moving Frostbite to Physically Based Rendering (Lagarde and de Rousiers 2014): renormalised Disney diffuse and GGX.
struct FrostbiteMaterial {
    glm::dvec3 base{0.5};
    double smoothness = 0.6;  // [0, 1]
    double metal = 0.0;       // [0, 1]
    double reflectance = 0.5; // [0, 1]; f0 = 0.16 reflectance² of a dielectric
};

using Material = std::variant<LambertMaterial, FrostbiteMaterial>;

struct MaterialKind {
    std::string_view kind;
    std::string_view grammar;
    std::string_view summary;
};

std::span<const MaterialKind> material_kinds();

// "frostbite:base=rgb(0.9,0.7,0.3),metal=1". Fails (usage) on unknown kinds and keys and on values outside [0, 1].
Result<Material> parse_material(std::string_view text);

} // namespace gonio
