// Materials, eyes and lights to measure reflectances on, from ordinary ones to the corners that formulas break in.
#pragma once

#include <gonio/measure/random.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/shading/vec3.hpp>

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace gonio::measure {

// Directions are unit and point away from the surface; u is what a sampler is given. All numbers are floats.
struct BrdfPose {
    shading::vec3<float> n, l, v, u;
};

// Any normal; l and v evenly over the hemisphere above it.
BrdfPose ordinary_brdf_pose(Random& random);

// Directions even over the sphere, as close to the surface as floats are, near the mirror, near the eye and opposite to
// it, in the surface and below; u at the ends of its range too.
BrdfPose hostile_brdf_pose(Random& random);

// Eight numbers in [0, 1] that each material takes its parameters from.
struct BrdfParameters {
    std::array<double, 8> p{};

    // Even; or `hostile`: 0, 1e-4 or 1 as often as not.
    explicit BrdfParameters(Random& random, bool hostile = false);
};

namespace detail {

template<class Key>
inline constexpr bool is_color = false;
template<class M>
inline constexpr bool is_color<ColorKey<M>> = true;

} // namespace detail

// The material of those parameters, which its keys take in their order, as the shading core takes it.
template<class M, class S>
auto make(const BrdfParameters& from) {
    std::size_t next = 0;
    const auto value = [&](const auto& key) {
        const auto number = [&] { return S(from.p[next++]); };
        if constexpr (detail::is_color<std::decay_t<decltype(key)>>)
            return shading::vec3<S>{number(), number(), number()};
        else
            return number();
    };
    return std::apply(
        [&](const auto&... key) {
            // In braces they are taken from left to right.
            return std::apply([](auto... values) { return MaterialDescription<M>::core(values...); },
                              std::tuple{value(key)...});
        },
        MaterialDescription<M>::keys);
}

// The same as a material of a scene; `kind` counts in the order of Material's alternatives.
Material scene_material(std::size_t kind, const BrdfParameters& parameters);

// What should give back all light: a white surface, or a mirror of f0 = 1, of that roughness and otherwise as it comes.
template<class M>
M white(double roughness) {
    M material;
    material.*std::get<0>(MaterialDescription<M>::keys).member = glm::dvec3(1.0);
    for_each_key<M>([&](const auto& key) {
        if constexpr (!detail::is_color<std::decay_t<decltype(key)>>) {
            if (key.form == KeyForm::alpha) material.*key.member = roughness * roughness;
            if (key.form == KeyForm::smoothness) material.*key.member = 1.0 - roughness;
            if (key.name == "roughness") material.*key.member = roughness;
        }
    });
    return material;
}

} // namespace gonio::measure
