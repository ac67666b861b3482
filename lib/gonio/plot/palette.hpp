// Colours of diagrams.
#pragma once

#include <cstddef>
#include <string>

namespace gonio {

// Of the i-th curve, "#rrggbb"; told apart with the common kinds of colour blindness too (Okabe and Ito, Color
// Universal Design, 2008, without its yellow, which paper swallows). Repeats after seven.
std::string series_color(std::size_t index);

// From dark (0) to light (1), even steps looking even: viridis (van der Walt and Smith, 2015, public domain) between
// nine of its colours. Values outside are clamped, NaN is dark.
std::string ramp_color(double value);

} // namespace gonio
