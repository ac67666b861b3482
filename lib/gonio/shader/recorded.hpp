// The recording scalar with its vectors, and the shading core's functions that become functions of the shader.
//
// Include it before the headers of shading/: their templates find what is declared here only if it comes first.
#pragma once

#include <gonio/shader/recorded_scalar.hpp>
// After the vocabulary above.
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/loop.hpp>
#include <gonio/simd/math.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::shading::detail {
template<class>
struct RulePointOf;
template<class>
struct AnglePairOf;
template<class>
struct EitherPairOf;
} // namespace gonio::shading::detail

namespace gonio::shader {

// The names of the numbers of a table's elements, in their order.
template<template<class> class Element>
inline constexpr std::array<std::string_view, 0> column_names{};
template<>
inline constexpr std::array<std::string_view, 3> column_names<shading::detail::RulePointOf>{"x", "y", "weight"};
template<>
inline constexpr std::array<std::string_view, 2> column_names<shading::detail::AnglePairOf>{"weight", "angle"};
template<>
inline constexpr std::array<std::string_view, 4> column_names<shading::detail::EitherPairOf>{"weight", "angle",
                                                                                             "few_weight", "few_angle"};

} // namespace gonio::shader

namespace gonio::simd {

template<>
inline constexpr bool is_recorded<shader::Recorded> = true;

// `work` runs once, on an element whose numbers are those of any row.
template<class S, template<class> class Element, std::size_t count, class Work>
requires is_recorded<S>
void for_each_of(const Element<float> (&table)[count], const Work& work) {
    constexpr auto& names = shader::column_names<Element>;
    constexpr std::size_t width = sizeof(Element<float>) / sizeof(float);
    static_assert(names.size() == width && sizeof(Element<S>) == width * sizeof(S));
    std::vector<shader::Column> columns;
    for (const std::string_view name : names)
        columns.push_back({name, {}});
    for (const Element<float>& row : table) {
        const auto numbers = __builtin_bit_cast(std::array<float, width>, row);
        for (std::size_t i = 0; i < width; ++i)
            columns[i].numbers.push_back(static_cast<double>(numbers[i]));
    }
    shader::Graph& graph = shader::Recording::graph();
    const std::uint8_t loop = graph.begin_loop(std::move(columns));
    std::array<S, width> of_row;
    for (std::size_t i = 0; i < width; ++i)
        of_row[i] = S::of(graph.element(loop, i));
    work(__builtin_bit_cast(Element<S>, of_row));
    graph.end_loop();
}
inline void accumulate(shader::Recorded& total, shader::Recorded term) {
    total = total + shader::Recorded::of(shader::Recording::graph().sum(term.node));
}
inline void accumulate_product(shader::Recorded& total, shader::Recorded a, shader::Recorded b) {
    accumulate(total, a * b);
}

} // namespace gonio::simd

namespace gonio::shading {

// Vectors are recorded as such: a shader has `dot` and `cross` instead of their products.
template<>
struct vec3<shader::Recorded> {
    shader::Recorded x, y, z;

    shader::NodeId node() const { return shader::Recording::graph().pack(x.node, y.node, z.node); }
    static vec3 of(shader::NodeId node) {
        shader::Graph& graph = shader::Recording::graph();
        return {shader::Recorded::of(graph.component(node, 0)), shader::Recorded::of(graph.component(node, 1)),
                shader::Recorded::of(graph.component(node, 2))};
    }
    static vec3 binary(shader::Operation operation, shader::NodeId a, shader::NodeId b) {
        return of(shader::Recording::graph().binary(operation, a, b));
    }

    friend vec3 operator+(vec3 a, vec3 b) { return binary(shader::Operation::add, a.node(), b.node()); }
    friend vec3 operator-(vec3 a, vec3 b) { return binary(shader::Operation::subtract, a.node(), b.node()); }
    friend vec3 operator*(vec3 a, vec3 b) { return binary(shader::Operation::multiply, a.node(), b.node()); }
    friend vec3 operator*(vec3 a, shader::Recorded s) { return binary(shader::Operation::multiply, a.node(), s.node); }
};

using RecordedVector = vec3<shader::Recorded>;

inline shader::Recorded dot(RecordedVector a, RecordedVector b) {
    return shader::Recorded::of(shader::Recording::graph().binary(shader::Operation::dot, a.node(), b.node()));
}
inline RecordedVector cross(RecordedVector a, RecordedVector b) {
    return RecordedVector::binary(shader::Operation::cross, a.node(), b.node());
}
inline RecordedVector fused_cross(RecordedVector a, RecordedVector b) {
    return cross(a, b);
}
inline RecordedVector mul_add(RecordedVector a, shader::Recorded s, RecordedVector b) {
    return a * s + b;
}
inline shader::Recorded length(RecordedVector a) {
    return shader::Recorded::of(shader::Recording::graph().unary(shader::Operation::length, a.node()));
}
inline RecordedVector select(shader::RecordedMask condition, RecordedVector if_true, RecordedVector if_false) {
    return RecordedVector::of(shader::Recording::graph().select(condition.node, if_true.node(), if_false.node()));
}

// The functions below are calls of helpers. helpers.cpp records their templates, once each.

RecordedVector normalized(RecordedVector a);
shader::Recorded schlick_weight(shader::Recorded x);
shader::Recorded window_squared(shader::Recorded distance, shader::Recorded inverse_range);
shader::Recorded horizon_arc(RecordedVector p, RecordedVector step, RecordedVector normal);

namespace detail {

// A shader has floats only: what the core would compute in double stays as it is.
template<class Exact, std::size_t count>
shader::Recorded in_double(shader::RecordedMask /*hard*/, shader::Recorded easy,
                           const shader::Recorded (&/*inputs*/)[count]) {
    return easy;
}

shader::Recorded solid_angle(RecordedVector a, RecordedVector b, RecordedVector c);
shader::Recorded frostbite_cap(shader::Recorded cosine, shader::Recorded square_sine);

} // namespace detail

} // namespace gonio::shading

namespace gonio::shader {

Recorded reciprocal_or_zero(Recorded x); // found by its argument

} // namespace gonio::shader
