// --smooth: a smooth curve through a profile's table.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <optional>

namespace gonio::cli {

inline constexpr Option smooth_option{
    "--smooth", "STEP",
    "draw a smooth curve through the profile's table in steps of STEP, for example 1deg: no facets on walls (linear)"};

// The step in degrees, if --smooth is given.
Result<std::optional<double>> smooth_step(const Arguments& arguments);

} // namespace gonio::cli
