// The lamp that measurements light a stage with.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/stage.hpp>

namespace gonio::measure {

// A disk of 15 cm radius and 1000 lm, where the stage has its light.
Light lamp_over(const Stage& stage);

} // namespace gonio::measure
