// `gonio preview --sweep`: the same picture with one or two values that vary.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"

#include <array>

namespace gonio::cli {

inline constexpr std::array preview_sweep_options{
    Option{"--sweep", "KEY=VALUES",
           "render a picture for each value: cct=2000K:8000K:7, radius=1cm:1m:5:log, roughness=0.1,0.4; NAME.KEY for "
           "one light or surface; a second one makes rows",
           "sweeps", true},
    Option{"-O,--output-dir", "DIR", "with --sweep: write each picture to a separate file (png, or --to)"},
    Option{"--overwrite", "", "with -O: replace existing files, as -o always does"},
};

// A labelled sheet (-o) or files (-O). Each picture is the same as that of a light or stage with the value written in
// it, at the exposure of the first picture unless the exposure itself varies. Here the method reference integrates by
// quadrature, without the noise of its passes. Returns the exit status.
Result<int> preview_sweep(const Arguments& arguments, Console& console);

} // namespace gonio::cli
