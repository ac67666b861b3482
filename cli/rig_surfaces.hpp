// Surfaces of a planned stage, as a rig has them.
#pragma once

#include <gonio/scene/stage.hpp>

#include "json_text.hpp"

namespace gonio::cli {

// Of a stage that consists of matte grey panels: {"name", "panel": {…}, "material": "lambert:albedo=…"} for each.
Json panels_json(const Stage& stage);

} // namespace gonio::cli
