// A coated material in double, its base named at run time. Compiled once, for path tracers, references and probes: a
// type for each base would double what they compile.
#pragma once

#include <gonio/shading/brdf.hpp>
#include <gonio/shading/coat.hpp>
#include <gonio/shading/vec3.hpp>

#include <variant>

namespace gonio::shading {

namespace detail {

template<class List>
struct AnyOf;
template<template<class> class... Material>
struct AnyOf<MaterialList<Material...>> {
    using type = std::variant<Material<double>...>;
};

} // namespace detail

using AnyMaterial = detail::AnyOf<Materials>::type;

struct Coated {
    AnyMaterial base;
    Coat<double> coat; // of coat_over(base, …)
};

// `amount` and `smoothness` in [0, 1].
Coated coated_material(const AnyMaterial& base, double amount, double smoothness, CoatOrder order);

// As for every material: brdf_sample.hpp. The lobe's α is that of the narrower one.
vec3<double> brdf(const Coated& material, vec3<double> n, vec3<double> l, vec3<double> v);
vec3<double> diffuse_part(const Coated& material, vec3<double> n, vec3<double> l, vec3<double> v);
vec3<double> specular_part(const Coated& material, vec3<double> n, vec3<double> l, vec3<double> v, double widening);
double lobe_alpha(const Coated& material);
Coated diffuse_alone(const Coated& material);
BrdfSample<double> sample_brdf(const Coated& material, vec3<double> n, vec3<double> v, vec3<double> u);
double pdf_brdf(const Coated& material, vec3<double> n, vec3<double> v, vec3<double> l);

// The coat's lobe alone, and the base's lobe below the coat: they add up to specular_part().
vec3<double> coat_part(const Coated& material, vec3<double> n, vec3<double> l, vec3<double> v);
vec3<double> base_specular_part(const Coated& material, vec3<double> n, vec3<double> l, vec3<double> v);

// Rounded to float, for the kernels.
MaterialConstants constants_of(const Coated& material);

} // namespace gonio::shading
