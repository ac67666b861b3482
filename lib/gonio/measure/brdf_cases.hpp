// Materials, view directions and lights for measuring reflectances, from ordinary ones to the corner cases that break
// formulas.
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

// Directions have unit length and point away from the surface; u is the input of a sampler. All numbers are floats.
struct BrdfPose {
    shading::vec3<float> n, l, v, u;
};

// Any normal; l and v uniform over the hemisphere above it.
BrdfPose ordinary_brdf_pose(Random& random);

// Directions uniform over the sphere, as close to the surface as floats can be, near the mirror direction, near the
// view direction and opposite to it, in the surface and below it; u also at the ends of its range.
BrdfPose hostile_brdf_pose(Random& random);

// Eight numbers in [0, 1] from which each material takes its parameters.
struct BrdfParameters {
    std::array<double, 8> p{};

    // Uniform; or if `hostile`: 0, 1e-4 or 1 half of the time.
    explicit BrdfParameters(Random& random, bool hostile = false);
};

namespace detail {

template<class Key>
inline constexpr bool is_color = false;
template<class M>
inline constexpr bool is_color<ColorKey<M>> = true;

} // namespace detail

// The material with those parameters, assigned in the order of its keys, as the shading core takes it; `simple`: in the
// form that takes less time; values that this form does not read have no effect.
template<class M, class S, bool simple = false>
auto make(const BrdfParameters& from) {
    std::size_t next = 0;
    const auto value = [&](const auto& key) {
        const auto number = [&] { return S(from.p[next++]); };
        if constexpr (detail::is_color<std::decay_t<decltype(key)>>)
            return shading::vec3<S>{number(), number(), number()};
        else
            return key.form == KeyForm::degrees ? number() * S(360) : number();
    };
    return std::apply(
        [&](const auto&... key) {
            // Braces guarantee evaluation from left to right.
            return std::apply(
                [](auto... values) {
                    if constexpr (simple)
                        return MaterialDescription<M>::simple(values...);
                    else
                        return MaterialDescription<M>::core(values...);
                },
                std::tuple{value(key)...});
        },
        MaterialDescription<M>::keys);
}

// The same as a material of a scene; `kind` is the index among Material's alternatives. The last one is a coat over one
// of the others: it takes its own keys and the choice from the last of the numbers.
Material scene_material(std::size_t kind, const BrdfParameters& parameters);

// A material that should reflect all light: a white surface, or a mirror of f0 = 1, with that roughness and otherwise
// default parameters.
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
