// A table on a finer grid, by a cubic that keeps it monotone.
//
// Tables with steps of 5° or 10° are linear between their angles, and the edges of the facets show on a wall. What the
// luminaire emits between them is not known; a smooth curve is the more likely guess.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/web/web.hpp>

#include <string>

namespace gonio {

// The web with every cell wider than `step_deg` divided evenly into cells that are not. Along the vertical angle of
// every plane, then along the horizontal angle of every new row, the values between two table values lie on a cubic
// whose slopes are those of parabolas, limited to three times the smaller secant (F. N. Fritsch and R. E. Carlson,
// "Monotone piecewise cubic interpolation", SIAM J. Numer. Anal. 17, 1980; J. M. Hyman, "Accurate monotonicity
// preserving cubic interpolation", SIAM J. Sci. Stat. Comput. 4, 1983): every value of the table is kept, and between
// two of them the result lies between them. It is not negative, continues smoothly through the axis of type C, through
// mirrors, and over C = 0° of a full turn, and ends where the table ends. Its flux differs, as the curve does. Fails
// (usage) unless 0.05° ≤ step ≤ 90°, and on more than 2 million intensities.
Result<Web> smoothed(const Web& web, double step_deg);

// The same for the table of `file`, with a note of its flux before and after.
Result<Web> smoothed(const Web& web, double step_deg, const std::string& file, Diagnostics& diagnostics);

} // namespace gonio
