// The methods that --compare names.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/scene/probe.hpp>

#include <string_view>
#include <vector>

namespace gonio::cli {

// "exact,frostbite": each once, in their order. Fails (usage) on an unknown name.
Result<std::vector<IrradianceMethod>> method_list(std::string_view text);

} // namespace gonio::cli
