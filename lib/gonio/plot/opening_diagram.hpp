// The luminous opening of a luminaire with its dimensions: from above, and from the side if it has a height.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/plot/drawing.hpp>

namespace gonio {

// C0 points to the right and C90 upwards. Fails (usage) on an opening without a size.
Result<Drawing> opening_diagram(const Opening& opening, int width_px, int height_px);

} // namespace gonio
