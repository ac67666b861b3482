// A scale of values: from the darkest to the brightest, in equal steps or equal ratios.
#pragma once

#include <gonio/base/image.hpp>

#include <cstddef>
#include <vector>

namespace gonio {

struct ValueScale {
    bool logarithmic = true;
    double low = 0.0;  // > 0 if logarithmic
    double high = 1.0; // > low

    // 0 at `low`, 1 at `high`, not clamped outside; −∞ for 0 on a logarithmic scale. NaN stays NaN.
    double share(double value) const;
    // The value at a share.
    double value(double share) const;
};

// A scale with round ends (1, 2 or 5 times a power of ten) for one channel of values: up to the value that 99.9 % of
// the lit pixels (> 0) do not exceed; if logarithmic, down to the darkest hundredth of them, over at most three
// decades. 0.1 to 1 (linear: 0 to 1) for a picture without light. `unit` is one unit of the legend in the unit of the
// values: the ends are round in legend units.
ValueScale round_scale(const Image& values, bool logarithmic, double unit = 1.0);

// About `count` numbers within the scale, ascending, round in `unit`; includes each end that is round.
std::vector<double> scale_numbers(const ValueScale& scale, double unit, int count);

// The shares of the lit pixels beyond the ends of a scale, and the greatest value.
struct ScaleUse {
    double below_share = 0.0; // of all pixels > 0
    double above_share = 0.0;
    double greatest = 0.0;
    double least = 0.0; // above 0
};

ScaleUse use_of(const Image& values, const ValueScale& scale);

} // namespace gonio
