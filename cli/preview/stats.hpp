// How much of a rendering was skipped and how much that saved, for people and for programs.
#pragma once

#include <gonio/preview/render_stats.hpp>

#include "../json_text.hpp"

#include <string>

namespace gonio::cli {

// `milliseconds`: how long the rendering took.
std::string stats_text(const RenderStats& stats, double milliseconds);
Json stats_json(const RenderStats& stats, double milliseconds);

} // namespace gonio::cli
