// A stroke font: letters as lines with a width, so that numbers and text in pictures are available on any machine.
//
// Drawn for this project: upright, open, all digits with the same width. Latin-1 letters, the signs used in photometry
// (° ² ³ µ · × γ Φ π α – − ≤ ≥ ± →) and typographic quotes; a missing character shows as a box. Nothing fails.
#pragma once

#include <gonio/plot/drawing.hpp>

#include <string_view>
#include <vector>

namespace gonio {

// The width of a line of UTF-8 text at that font size, from the left of its first letter to the right side bearing of
// its last. A line end counts as a space.
double text_width_px(std::string_view text, double size_px);

// The height of capitals, as a share of the font size.
inline constexpr double capital_height = 0.72;

// The width of the lines, as a share of the font size.
inline constexpr double stroke_weight = 0.088;
inline constexpr double bold_stroke_weight = 0.135;

using Polyline = std::vector<PagePoint>; // a single point is a dot

// The lines of a text; its baseline begins at `at`. `hinted` moves the baseline and the tops of small letters and
// capitals to the middles of pixels, which keeps small text sharp.
std::vector<Polyline> text_lines(std::string_view text, PagePoint at, double size_px, bool hinted);

} // namespace gonio
