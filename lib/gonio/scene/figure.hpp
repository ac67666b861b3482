// A scale figure: somebody of 1.75 m, standing, to tell sizes by.
#pragma once

#include <gonio/scene/stage.hpp>

namespace gonio {

inline constexpr double figure_height = 1.75; // [m]

// Adds surfaces called "figure", of balls and capsules in matte grey, with the feet at the stage's figure_position, Z
// up and facing −Y. It is no subject of the stage.
void add_figure(Stage& stage);

} // namespace gonio
