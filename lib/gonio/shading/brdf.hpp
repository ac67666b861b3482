// The list of all materials of the shading core. brdf_sample.hpp describes what they have in common.
//
// The kernels, their constants, the tables of measure/ and the tests that cover all materials go through the list
// `Materials`. If a material in the list lacks a part, the library does not compile.
#pragma once

#include <gonio/shading/brdf_anisotropic.hpp>
#include <gonio/shading/brdf_blinn.hpp>
#include <gonio/shading/brdf_eon.hpp>
#include <gonio/shading/brdf_frostbite.hpp>
#include <gonio/shading/brdf_ggx.hpp>
#include <gonio/shading/brdf_gltf.hpp>
#include <gonio/shading/brdf_kulla_conty.hpp>
#include <gonio/shading/brdf_lambert.hpp>
#include <gonio/shading/brdf_ue4.hpp>
#include <gonio/shading/kernels.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::shading {

template<template<class> class... Material>
struct MaterialList {};

using Materials = MaterialList<Lambert, Eon, Frostbite, Ue4, Gltf, Anisotropic, Blinn, Ggx, KullaConty>;

template<template<class> class Material>
concept Glossy = Material<double>::lobe != LobeKind::none;

namespace detail {

template<template<class> class One, template<class> class... Material>
constexpr MaterialConstants::Kind place_in(MaterialList<Material...> /*list*/) {
    constexpr bool found[] = {__is_same(One<float>, Material<float>)...};
    std::uint8_t place = 0;
    while (!found[place]) // not a constant if it is not in the list
        ++place;
    return MaterialConstants::Kind{place};
}

template<template<class> class Material>
inline constexpr std::size_t number_count = sizeof(Material<float>) / sizeof(float);

template<template<class> class Material>
concept IsMaterial = requires(const Material<double>& m, vec3<double> way) {
    brdf(m, way, way, way);
    {lobe_alpha(m) + pdf_brdf(m, way, way, way) + sample_brdf(m, way, way, way).pdf};
    diffuse_alone(m);
    Material<double>::scattering == Scattering::uniform;
    Material<double>::lobe == LobeKind::none;
    requires(!Glossy<Material> || requires { gloss(m); });
    requires(Material<double>::lobe != LobeKind::ggx_and_more || requires { multiple_scattering(m, way, way, way); });
    requires(Material<double>::scattering != Scattering::one_color || requires {
        scattered_color(m);
        white(m);
    });
    requires number_count<Material>
    <= MaterialConstants::most_numbers;
    requires sizeof(Material<float>) == number_count<Material> * sizeof(float);
    requires sizeof(Material<double>) == number_count<Material> * sizeof(double);
};

template<template<class> class... Material>
constexpr bool are_materials(MaterialList<Material...> /*list*/) {
    return (IsMaterial<Material> && ...);
}
static_assert(are_materials(Materials()), "a material of the list lacks a part that brdf_sample.hpp asks for");

} // namespace detail

template<template<class> class Material>
inline constexpr MaterialConstants::Kind kind_of = detail::place_in<Material>(Materials());

// The material's numbers, rounded to float.
template<template<class> class Material, class T>
GONIO_FORCE_INLINE MaterialConstants constants_of(const Material<T>& material) {
    constexpr std::size_t count = detail::number_count<Material>;
    T numbers[count];
    __builtin_memcpy(&numbers[0], &material, sizeof numbers);
    MaterialConstants constants;
    constants.kind = kind_of<Material>;
    for (std::size_t i = 0; i < count; ++i)
        constants.numbers[i] = static_cast<float>(numbers[i]);
    return constants;
}

// The material that the constants describe, the same in every lane.
template<template<class> class Material, class S>
GONIO_FORCE_INLINE Material<S> material_of(const MaterialConstants& constants) {
    constexpr std::size_t count = detail::number_count<Material>;
    S numbers[count];
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = S(constants.numbers[i]);
    Material<S> material;
    __builtin_memcpy(&material, &numbers[0], sizeof material);
    return material;
}

namespace detail {

template<class Visit, template<class> class... Material>
GONIO_FORCE_INLINE void visit_kind(MaterialConstants::Kind kind, const Visit& visit,
                                   MaterialList<Material...> /*all*/) {
    (void)((kind == kind_of<Material> && (visit.template operator()<Material>(), true)) || ...);
}

} // namespace detail

// Calls visit.template operator()<Material>() for the material of that kind.
template<class Visit>
GONIO_FORCE_INLINE void with_material(MaterialConstants::Kind kind, const Visit& visit) {
    detail::visit_kind(kind, visit, Materials());
}

} // namespace gonio::shading
