// The methods that --compare names.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/scene/probe.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

// The names of a list, where "near" is exact and "far" is point: with a luminaire's luminous opening, and without.
std::string without_aliases(std::string_view list);

// "exact,frostbite": each once, in their order. Fails (usage) on an unknown name.
Result<std::vector<IrradianceMethod>> method_list(std::string_view text);

} // namespace gonio::cli
