// A small polar plot of a web in text, for terminals.
#pragma once

#include <gonio/web/web.hpp>

#include <string>

namespace gonio::cli {

// Braille dots: the C0–C180 section (C0 to the right), nadir down, the radius reaching the peak. Ends with a newline.
std::string polar_text(const Web& web, int columns = 36, int rows = 18);

} // namespace gonio::cli
