// Which formulas `gonio shader` is asked for.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/shader/shader.hpp>

#include "../arguments.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace gonio::cli {

struct ShaderRequest {
    std::vector<std::size_t> formulas; // their places in the library's list
    ShaderLanguage language = ShaderLanguage::glsl450;
    ShaderBranches branches = ShaderBranches::real;
};

// Fails (usage) on names that there are not, and on combinations that there are not, and says which there are.
Result<ShaderRequest> shader_request(const Arguments& arguments);

// The values that a part of the formulas has, each once, in the order of the list.
std::vector<std::string_view> shader_values(std::string_view ShaderFormula::*part);

// The options that ask for a formula: "--light sphere --method frostbite".
std::string shader_options_of(const ShaderFormula& formula);

} // namespace gonio::cli
