// A sweep as files: one picture each, named by its values.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../console.hpp"
#include "sweeper.hpp"

#include <string>
#include <vector>

namespace gonio::cli {

// The files of the cells, in order, below -O. Fails (io) if there is no such folder and (usage) on a file that exists,
// unless --overwrite is given.
Result<std::vector<std::string>> plan_sweep_files(const Arguments& arguments, const Sweeper& sweeper);

// Renders the cells into these files.
Result<void> make_sweep_files(Sweeper& sweeper, const std::vector<std::string>& files, const Console& console);

} // namespace gonio::cli
