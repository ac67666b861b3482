// Functions as text, in the words of one language.
#pragma once

#include <gonio/shader/formulas.hpp>

#include <span>
#include <string>

namespace gonio::shader {

// The source of the functions of these formulas, after the helpers that they call.
std::string printed(std::span<const Formula* const> formulas, ShaderLanguage language, ShaderBranches branches);

} // namespace gonio::shader
