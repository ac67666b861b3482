// Material: how a surface reflects light, by name and parameters. The reflectances themselves are in shading/.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/shading/coat_order.hpp>

#include <glm/vec3.hpp>

#include <span>
#include <string_view>
#include <variant>

#pragma GCC visibility push(default)
namespace gonio {

// Colours are linear Rec.709, each channel in [0, 1]; every number without a unit is in [0, 1] too. An α of 0 counts as
// 1e-4: a mirror's lobe.
//
// A lobe with an anisotropy is wider along the tangent of a surface, as on brushed metal. The tangent is level,
// counter-clockwise about the vertical, and along X on a level surface; `rotation_deg` turns it counter-clockwise, seen
// from outside.
struct LambertMaterial {
    glm::dvec3 albedo{0.5};
};

// GGX alone, single scattering: height-correlated Smith, Schlick's reflectance up to 1 at grazing, no diffuse part.
struct GgxMaterial {
    glm::dvec3 f0{1.0};
    double alpha = 0.3;
    double anisotropy = 0.0; // of OpenPBR: α_y = (1 − anisotropy) α_x, α_x² + α_y² = 2 α²
    double rotation_deg = 0.0;
};

// The same with multiple scattering between facets (Kulla and Conty 2017): f0 = 1 reflects all light.
struct KullaContyMaterial {
    glm::dvec3 f0{1.0};
    double alpha = 0.3;
};

// Moving Frostbite to Physically Based Rendering (Lagarde and de Rousiers 2014): renormalised Disney diffuse and GGX.
struct FrostbiteMaterial {
    glm::dvec3 base{0.5};
    double smoothness = 0.6;
    double metal = 0.0;
    double reflectance = 0.5; // f0 = 0.16 reflectance² for a dielectric
};

// Real Shading in Unreal Engine 4 (Karis 2013): Lambert and GGX.
struct Ue4Material {
    glm::dvec3 base{0.5};
    double roughness = 0.4;
    double metallic = 0.0;
    double specular = 0.5; // f0 = 0.08 specular for a dielectric
    double cavity = 1.0;   // multiplies both parts
};

// The metallic-roughness material of glTF 2.0 (Khronos, appendix B of its specification).
struct GltfMaterial {
    glm::dvec3 base{0.5};
    double metallic = 0.0;
    double roughness = 0.4;
    double anisotropy = 0.0; // the strength of KHR_materials_anisotropy: α_x = lerp(α, 1, strength²), α_y = α
    double rotation_deg = 0.0;

    friend bool operator==(const GltfMaterial&, const GltfMaterial&) = default;
};

// The Art of Remember Me (Lagarde and Harduin 2013): Lambert and Blinn's cosine power, dry to wet.
struct BlinnMaterial {
    glm::dvec3 albedo{0.5};
    glm::dvec3 specular{0.04}; // linear f0
    double smoothness = 0.6;
    double wet = 0.0;
};

// Energy-preserving Oren–Nayar (Portsmouth, Kutz and Hill 2025).
struct EonMaterial {
    glm::dvec3 albedo{0.5};
    double roughness = 0.4;
};

// In the order in which they are listed. material_description.hpp describes each of them.
using BaseMaterial = std::variant<LambertMaterial, EonMaterial, FrostbiteMaterial, Ue4Material, GltfMaterial,
                                  BlinnMaterial, GgxMaterial, KullaContyMaterial>;

// How a coat attenuates what is below it: shading/coat.hpp.
using shading::CoatOrder;

// A clear coat without thickness and colour: a GGX lobe of f0 = 0.04 and α = (1 − smoothness)².
struct Coat {
    double amount = 1.0; // share of what a whole coat reflects
    double smoothness = 0.9;
    CoatOrder order = CoatOrder::physical;

    friend bool operator==(const Coat&, const Coat&) = default;
};

// A material below a clear coat.
struct CoatedMaterial {
    BaseMaterial base;
    Coat coat;
};

// One of the above, or one of them below a coat.
using Material = std::variant<LambertMaterial, EonMaterial, FrostbiteMaterial, Ue4Material, GltfMaterial, BlinnMaterial,
                              GgxMaterial, KullaContyMaterial, CoatedMaterial>;

// The material without its coat.
BaseMaterial base_of(const Material& material);

// A material by its name, as `gonio list materials` shows it.
struct MaterialKind {
    std::string_view kind;
    std::string_view grammar;
    std::string_view summary;
};

// All of them.
std::span<const MaterialKind> material_kinds();

// An order by its name in text.
struct CoatOrderName {
    CoatOrder order;
    std::string_view name;
    std::string_view summary;
};

// All of them.
std::span<const CoatOrderName> coat_orders();

// "frostbite:base=rgb(0.9,0.7,0.3),metal=1"; `ggx` and `kulla-conty` take roughness instead of alpha, its root. Every
// kind takes a coat: "lambert:coat=1,coat-smoothness=0.9,coat-order=physical". Fails (usage) on unknown kinds and keys,
// on values outside [0, 1] and on the keys of a coat without `coat`.
Result<Material> parse_material(std::string_view text);

} // namespace gonio
#pragma GCC visibility pop
