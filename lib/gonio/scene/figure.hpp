// A scale figure: a standing person of 1.75 m, to show the scale.
#pragma once

#include <gonio/scene/stage.hpp>

namespace gonio {

inline constexpr double figure_height = 1.75; // [m]

// Adds surfaces called "figure", made of spheres and capsules in matte grey, with the feet at the stage's
// figure_position, Z up and facing −Y. The figure is not a subject of the stage.
void add_figure(Stage& stage);

// Whether a surface of a stage is a part of its scale figure.
bool is_of_figure(const Surface& surface);

} // namespace gonio
