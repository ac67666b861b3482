// How often light bounces: --indirect.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"

namespace gonio::cli {

// all, off or a number; `all` if it is not given. Fails (usage) on anything else and on more than max_bounces.
Result<int> read_bounces(const Arguments& arguments);

} // namespace gonio::cli
