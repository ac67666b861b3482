// A luminaire's figures in words and tables: what `gonio info --figures` prints.
#pragma once

#include <gonio/figures/luminaire_figures.hpp>

#include <string>

namespace gonio::cli {

// With a newline at the end of each line.
std::string figures_text(const LuminaireFigures& figures);

} // namespace gonio::cli
