// `gonio preview --sheet`: a labelled thumbnail of every profile, in one picture.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"

#include <array>

namespace gonio::cli {

inline constexpr std::array preview_sheet_options{
    Option{"--sheet", "",
           "show FILE… (folders and @LIST too) as labelled thumbnails: floor, polar diagram, lm, cd, beam"},
};

// Returns the exit status: the worst of all profiles. A profile that cannot be read gets a tile with the error. -s is
// the size of each tile's picture. Fails (usage) on options that a sheet does not use, before a profile is read.
Result<int> preview_sheet(const Arguments& arguments, Console& console);

} // namespace gonio::cli
