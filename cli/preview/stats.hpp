// How much of a rendering was skipped and how much that saved, for people and for programs.
#pragma once

#include <gonio/preview/render_stats.hpp>

#include "../json_text.hpp"

#include <string>
#include <vector>

namespace gonio::cli {

// `milliseconds`: how long the rendering took; `modules`: what was opened to write the picture.
std::string stats_text(const RenderStats& stats, double milliseconds, const std::vector<std::string>& modules);
Json stats_json(const RenderStats& stats, double milliseconds, const std::vector<std::string>& modules);

} // namespace gonio::cli
