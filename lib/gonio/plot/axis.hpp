// The samples, axis numbers and contour levels of diagrams.
#pragma once

#include <cstddef>
#include <vector>

namespace gonio {

// first, first + step, … up to `last`, which is included if it is a whole number of steps away. step > 0.
std::vector<double> even_steps(double first, double last, double step);

// Multiples of 1, 2 or 5 times a power of ten that cover [low, high], about `count` of them: the first is at or below
// `low`, the last at or above `high`. For a span far smaller than its distance from 0, just its two ends. For a span
// that is empty or not finite, one tick at `low`.
std::vector<double> ticks(double low, double high, int count);

// 1, 2 and 5 times the powers of ten within [low, high]; none unless `low` is a normal number above 0 and `high` is
// finite.
std::vector<double> levels_1_2_5(double low, double high);

// The same, or, if those are fewer than `wanted`, more levels of each power of ten; where even the finest series has
// too few, ticks strictly between `low` and `high`. In ascending order.
std::vector<double> fitting_levels(double low, double high, std::size_t wanted);

} // namespace gonio
