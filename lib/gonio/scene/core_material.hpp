// A material of a scene in the form that the shading core uses, in double.
#pragma once

#include <gonio/scene/material.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/shading/brdf.hpp>
#include <gonio/shading/coated.hpp>

#include <utility>
#include <variant>

namespace gonio {

// Calls core_material() of the base and puts the coat on it.
shading::Coated core_material(const CoatedMaterial& material);

namespace detail {

template<class Materials>
struct CoresOf;
template<class... M>
struct CoresOf<std::variant<M...>> {
    using type = std::variant<decltype(core_material(std::declval<const M&>()))...>;
};

} // namespace detail

using CoreMaterial = detail::CoresOf<Material>::type;

CoreMaterial core_material(const Material& material);

} // namespace gonio
