// Where diagrams put their samples, their axes' numbers and their contour levels.
#pragma once

#include <vector>

namespace gonio {

// first, first + step, … up to `last`, which is hit when it is a whole number of steps away. step > 0.
std::vector<double> even_steps(double first, double last, double step);

// Multiples of 1, 2 or 5 times a power of ten that cover [low, high], about `count` of them: the first is at or below
// `low`, the last at or above `high`. A span far smaller than its distance from 0 has its two ends. A span that is
// empty or not finite has one tick at `low`.
std::vector<double> ticks(double low, double high, int count);

// 1, 2 and 5 times the powers of ten within [low, high]; none unless low is normal and above 0, and high finite.
std::vector<double> levels_1_2_5(double low, double high);

} // namespace gonio
