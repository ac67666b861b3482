// A stroke font: letters as lines with a width, so that pictures carry numbers and words on any machine.
//
// Drawn for this project: upright, open, figures of one width. Latin-1 letters, the signs that photometry writes
// (° ² ³ µ · × γ Φ π α – − ≤ ≥ ± →) and typographic quotes; what is not there shows as a box. Nothing fails.
#pragma once

#include <gonio/plot/drawing.hpp>

#include <string_view>
#include <vector>

namespace gonio {

// Of a line of UTF-8 text at that font size, from its first letter's left to its last one's right side bearing. A line
// end counts as a space.
double text_width_px(std::string_view text, double size_px);

// Capitals are so much of the font size high.
inline constexpr double capital_height = 0.72;

// The width of the lines, as a share of the font size.
inline constexpr double stroke_weight = 0.088;
inline constexpr double bold_stroke_weight = 0.135;

using Polyline = std::vector<PagePoint>; // one point alone is a dot

// The lines of a text whose baseline begins at `at`. `hinted` moves the baseline, the tops of small letters and those
// of capitals to the middles of pixels, which keeps small text sharp.
std::vector<Polyline> text_lines(std::string_view text, PagePoint at, double size_px, bool hinted);

} // namespace gonio
