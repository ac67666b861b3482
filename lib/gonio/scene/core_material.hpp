// A material of a scene in the form that the shading core uses, in double.
#pragma once

#include <gonio/scene/material.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/shading/brdf.hpp>
#include <gonio/shading/coated.hpp>

#include <variant>

namespace gonio {

namespace detail {

template<class List>
struct CoresOf;
template<template<class> class... Core>
struct CoresOf<shading::MaterialList<Core...>> {
    using type = std::variant<Core<double>..., shading::Coated>;
};

} // namespace detail

using CoreMaterial = detail::CoresOf<shading::Materials>::type;

// By the simple BRDF where a description has one.
shading::AnyMaterial core_material(const BaseMaterial& material);
CoreMaterial core_material(const Material& material);

// The same of the base, with the coat on it.
shading::Coated core_material(const CoatedMaterial& material);

// Whether its lobe, or that below its coat, depends on the tangent of a surface.
bool is_anisotropic(const CoreMaterial& material);

} // namespace gonio
