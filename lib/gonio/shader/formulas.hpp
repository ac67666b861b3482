// The formulas that have a shader: what is asked for, and how it is recorded.
#pragma once

#include <gonio/shader/function.hpp>
#include <gonio/shader/shader.hpp>

#include <span>
#include <string_view>

namespace gonio::shader {

struct Formula {
    ShaderFormula names;
    std::string_view function; // its name in the shader
    std::string_view title;    // one sentence
    std::string_view result;   // what is returned, with its unit and range
    std::string_view source;
    ShaderError error;
    std::string_view error_of; // what `error` is a share of
    std::string_view near;     // where `error.near` holds; empty if `error.apart` holds everywhere
    void (*record)(Function&);
};

// Whether a light is seen from one side of its plane.
constexpr bool is_flat(std::string_view light) {
    return light == "disk" || light == "rect";
}

// What lights give and what they leave of a sky; BRDFs and their samples; materials under lights, with highlights by
// points; highlights by linearly transformed cosines.
std::span<const Formula> formulas_of_lights();
std::span<const Formula> formulas_of_materials();
std::span<const Formula> formulas_of_shading();
std::span<const Formula> formulas_of_highlights();
// All of them.
std::span<const Formula> formulas();

// The formula, recorded anew.
Function recorded(const Formula& formula);

} // namespace gonio::shader
