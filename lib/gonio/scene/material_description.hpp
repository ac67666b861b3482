// Each material of a scene that can be below a coat, described once: its keys and the members that they set, its
// parameters, its BRDF, and what charts and exports use of it.
//
// MaterialDescription<M> of an alternative M of BaseMaterial has
//
//   kind, summary
//       Its name in the grammar, and its text in `gonio list materials`.
//   keys
//       A tuple of MaterialKey, in the order in which the grammar writes them; the first is a colour. Defaults are
//       those of M's members.
//   core(values of the keys in their order)
//       Its BRDF of shading/brdf_*.hpp, for numbers S and colours vec3<S>.
//   is_simple(const M&), simple(values of the keys in their order)
//       Only where some values of the keys have a BRDF that is the same and takes less time: whether they are these,
//       and that BRDF.
//   chart_colors(const M&)
//       The colours that the artists' charts judge.
//
// None of these has a default: if one is missing, the code that reads it does not compile. HOW_TO_ADD_A_MATERIAL.md
// gives the steps.
#pragma once

#include <gonio/scene/material.hpp>
#include <gonio/shading/brdf.hpp>

#include <glm/vec3.hpp>

#include <cstdint>
#include <numbers>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace gonio {

enum class KeyForm : std::uint8_t {
    plain,
    alpha,      // α: the grammar takes its root, `roughness`, instead
    smoothness, // 1 − roughness: a sweep can set it by that too
    degrees     // a whole turn at most, either way
};

// A number in [0, 1], or an angle, where Value is double, a colour where it is glm::dvec3.
template<class M, class Value>
struct MaterialKey {
    std::string_view name;
    Value M::*member;
    KeyForm form = KeyForm::plain;
    std::string_view parameter = name; // its name in a sweep
};

template<class M>
using ColorKey = MaterialKey<M, glm::dvec3>;
template<class M>
using NumberKey = MaterialKey<M, double>;

// A colour of a material that the charts can judge: scene/material_charts.hpp.
struct ChartColor {
    enum class As : std::uint8_t { albedo, specular, metal };

    As as;
    std::string_view key;
    glm::dvec3 value;
};
using ChartColors = std::vector<ChartColor>;

// A material that is only partly metal is not judged.
inline ChartColors metallic_chart_colors(const glm::dvec3& base, double metallic, const shading::vec3<double>& f0) {
    if (metallic == 1.0) return {{ChartColor::As::metal, "base", base}};
    if (metallic != 0.0) return {};
    return {{ChartColor::As::albedo, "base", base}, {ChartColor::As::specular, "f0", {f0.x, f0.y, f0.z}}};
}

template<class M>
struct MaterialDescription;

// A lobe's tangent in a scene (material.hpp): the vertical is across it.
template<class S>
shading::Grain<S> grain_of(S rotation_deg) {
    const S angle = rotation_deg * S(std::numbers::pi / 180.0);
    return {{S(0), S(0), S(1)}, simd::cos(angle), simd::sin(angle)};
}

// Whether the materials are of one kind and have the same numbers.
bool are_same(const Material& a, const Material& b);

namespace detail {

// Calls build(values of the keys in their order).
template<class M, class Build>
auto from_values(const M& material, const Build& build) {
    const auto value = [&](const auto& key) {
        const auto& member = material.*key.member;
        if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>)
            return member;
        else
            return shading::vec3<double>{member.x, member.y, member.z};
    };
    return std::apply([&](const auto&... key) { return build(value(key)...); }, MaterialDescription<M>::keys);
}

} // namespace detail

// Calls core(…) of a material.
template<class M>
auto core_material(const M& material) {
    return detail::from_values(material, [](const auto&... values) { return MaterialDescription<M>::core(values...); });
}

// Has values of the keys with a BRDF that takes less time.
template<class M>
concept HasSimpleForm = requires(const M& material) {
    MaterialDescription<M>::is_simple(material);
};

template<>
struct MaterialDescription<LambertMaterial> {
    static constexpr std::string_view kind = "lambert";
    static constexpr std::string_view summary = "matte: the same luminance in every direction";
    static constexpr std::tuple keys{ColorKey<LambertMaterial>{"albedo", &LambertMaterial::albedo}};

    template<class S>
    static shading::Lambert<S> core(shading::vec3<S> albedo) {
        return {albedo};
    }
    static ChartColors chart_colors(const LambertMaterial& m) { return {{ChartColor::As::albedo, "albedo", m.albedo}}; }
};

template<>
struct MaterialDescription<EonMaterial> {
    static constexpr std::string_view kind = "eon";
    static constexpr std::string_view summary =
        "rough and matte, energy-preserving Oren-Nayar (Portsmouth, Kutz and Hill 2025)";
    static constexpr std::tuple keys{ColorKey<EonMaterial>{"albedo", &EonMaterial::albedo},
                                     NumberKey<EonMaterial>{"roughness", &EonMaterial::roughness}};

    template<class S>
    static shading::Eon<S> core(shading::vec3<S> albedo, S roughness) {
        return {albedo, roughness};
    }
    static ChartColors chart_colors(const EonMaterial& m) { return {{ChartColor::As::albedo, "albedo", m.albedo}}; }
};

template<>
struct MaterialDescription<FrostbiteMaterial> {
    static constexpr std::string_view kind = "frostbite";
    static constexpr std::string_view summary = "renormalised Disney diffuse and GGX (Lagarde and de Rousiers 2014)";
    static constexpr std::tuple keys{
        ColorKey<FrostbiteMaterial>{"base", &FrostbiteMaterial::base},
        NumberKey<FrostbiteMaterial>{"smoothness", &FrostbiteMaterial::smoothness, KeyForm::smoothness},
        NumberKey<FrostbiteMaterial>{"metal", &FrostbiteMaterial::metal, KeyForm::plain, "metallic"},
        NumberKey<FrostbiteMaterial>{"reflectance", &FrostbiteMaterial::reflectance}};

    template<class S>
    static shading::Frostbite<S> core(shading::vec3<S> base, S smoothness, S metal, S reflectance) {
        return shading::frostbite_material(base, smoothness, metal, reflectance);
    }
    static ChartColors chart_colors(const FrostbiteMaterial& m) {
        return metallic_chart_colors(m.base, m.metal, core_material(m).f0);
    }
};

template<>
struct MaterialDescription<Ue4Material> {
    static constexpr std::string_view kind = "ue4";
    static constexpr std::string_view summary = "Lambert and GGX (Karis 2013)";
    static constexpr std::tuple keys{ColorKey<Ue4Material>{"base", &Ue4Material::base},
                                     NumberKey<Ue4Material>{"roughness", &Ue4Material::roughness},
                                     NumberKey<Ue4Material>{"metallic", &Ue4Material::metallic},
                                     NumberKey<Ue4Material>{"specular", &Ue4Material::specular},
                                     NumberKey<Ue4Material>{"cavity", &Ue4Material::cavity}};

    template<class S>
    static shading::Ue4<S> core(shading::vec3<S> base, S roughness, S metallic, S specular, S cavity) {
        return shading::ue4_material(base, metallic, roughness, specular, cavity);
    }
    static ChartColors chart_colors(const Ue4Material& m) {
        return metallic_chart_colors(m.base, m.metallic, core_material(m).f0);
    }
};

template<>
struct MaterialDescription<GltfMaterial> {
    static constexpr std::string_view kind = "gltf";
    // glTF's own defaults, 1 each, are a rough white metal; with these the material can be compared with ue4.
    static constexpr std::string_view summary = "metallic-roughness of glTF 2.0 (appendix B), with "
                                                "KHR_materials_anisotropy; defaults as ue4's, where glTF has 1";
    static constexpr std::tuple keys{
        ColorKey<GltfMaterial>{"base", &GltfMaterial::base},
        NumberKey<GltfMaterial>{"metallic", &GltfMaterial::metallic},
        NumberKey<GltfMaterial>{"roughness", &GltfMaterial::roughness},
        NumberKey<GltfMaterial>{"anisotropy", &GltfMaterial::anisotropy},
        NumberKey<GltfMaterial>{"rotation", &GltfMaterial::rotation_deg, KeyForm::degrees}};

    template<class S>
    static shading::Anisotropic<S> core(shading::vec3<S> base, S metallic, S roughness, S anisotropy, S rotation_deg) {
        const shading::Gltf<S> even = shading::gltf_material(base, metallic, roughness);
        return {even.albedo, even.f0, even.f90, shading::gltf_alpha(even.alpha, anisotropy), grain_of(rotation_deg)};
    }
    static bool is_simple(const GltfMaterial& m) { return m.anisotropy == 0.0; }
    template<class S>
    static shading::Gltf<S> simple(shading::vec3<S> base, S metallic, S roughness, S /*anisotropy*/, S /*rotation*/) {
        return shading::gltf_material(base, metallic, roughness);
    }
    static ChartColors chart_colors(const GltfMaterial& m) {
        return metallic_chart_colors(m.base, m.metallic, core_material(m).f0);
    }
};

template<>
struct MaterialDescription<BlinnMaterial> {
    static constexpr std::string_view kind = "blinn";
    static constexpr std::string_view summary =
        "Lambert and a cosine power, dry to wet, of Remember Me (Lagarde and Harduin 2013)";
    static constexpr std::tuple keys{
        ColorKey<BlinnMaterial>{"albedo", &BlinnMaterial::albedo},
        ColorKey<BlinnMaterial>{"specular", &BlinnMaterial::specular},
        NumberKey<BlinnMaterial>{"smoothness", &BlinnMaterial::smoothness, KeyForm::smoothness},
        NumberKey<BlinnMaterial>{"wet", &BlinnMaterial::wet}};

    template<class S>
    static shading::Blinn<S> core(shading::vec3<S> albedo, shading::vec3<S> specular, S smoothness, S wet) {
        return shading::blinn_material(albedo, specular, smoothness, wet);
    }
    static ChartColors chart_colors(const BlinnMaterial& m) {
        return {{ChartColor::As::specular, "f0", m.specular}, {ChartColor::As::albedo, "albedo", m.albedo}};
    }
};

template<>
struct MaterialDescription<GgxMaterial> {
    static constexpr std::string_view kind = "ggx";
    static constexpr std::string_view summary =
        "GGX only, single scattering, anisotropic as OpenPBR's; or roughness, the root of alpha";
    static constexpr std::tuple keys{ColorKey<GgxMaterial>{"f0", &GgxMaterial::f0},
                                     NumberKey<GgxMaterial>{"alpha", &GgxMaterial::alpha, KeyForm::alpha},
                                     NumberKey<GgxMaterial>{"anisotropy", &GgxMaterial::anisotropy},
                                     NumberKey<GgxMaterial>{"rotation", &GgxMaterial::rotation_deg, KeyForm::degrees}};

    template<class S>
    static shading::Anisotropic<S> core(shading::vec3<S> f0, S alpha, S anisotropy, S rotation_deg) {
        return {{S(0), S(0), S(0)}, f0, S(1), shading::openpbr_alpha(alpha, anisotropy), grain_of(rotation_deg)};
    }
    static bool is_simple(const GgxMaterial& m) { return m.anisotropy == 0.0; }
    template<class S>
    static shading::Ggx<S> simple(shading::vec3<S> f0, S alpha, S /*anisotropy*/, S /*rotation*/) {
        return {f0, alpha};
    }
    static ChartColors chart_colors(const GgxMaterial& m) { return {{ChartColor::As::specular, "f0", m.f0}}; }
};

template<>
struct MaterialDescription<KullaContyMaterial> {
    static constexpr std::string_view kind = "kulla-conty";
    static constexpr std::string_view summary = "GGX with multiple scattering (Kulla and Conty 2017); or roughness";
    static constexpr std::tuple keys{
        ColorKey<KullaContyMaterial>{"f0", &KullaContyMaterial::f0},
        NumberKey<KullaContyMaterial>{"alpha", &KullaContyMaterial::alpha, KeyForm::alpha}};

    template<class S>
    static shading::KullaConty<S> core(shading::vec3<S> f0, S alpha) {
        return shading::kulla_conty_material(f0, alpha);
    }
    static ChartColors chart_colors(const KullaContyMaterial& m) { return {{ChartColor::As::specular, "f0", m.f0}}; }
};

namespace detail {

template<class Visit, class... M>
void visit_types(const Visit& visit, std::type_identity<std::variant<M...>> /*of*/) {
    (visit.template operator()<M>(), ...);
}

} // namespace detail

// Calls visit.template operator()<M>() for each alternative of BaseMaterial.
template<class Visit>
void for_each_material(const Visit& visit) {
    detail::visit_types(visit, std::type_identity<BaseMaterial>());
}

// Calls visit(key) for each key of M.
template<class M, class Visit>
void for_each_key(const Visit& visit) {
    std::apply([&](const auto&... key) { (visit(key), ...); }, MaterialDescription<M>::keys);
}

} // namespace gonio
