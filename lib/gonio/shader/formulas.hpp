// The closed table of the formulas that have a shader: what is asked for, and how it is recorded.
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

std::span<const Formula> formulas();

// The formula, recorded anew.
Function recorded(const Formula& formula);

} // namespace gonio::shader
