// A scale of values: from the darkest value to the brightest, in equal steps or equal ratios.
#pragma once

#include <gonio/base/image.hpp>

#include <cstddef>
#include <vector>

namespace gonio {

struct ValueScale {
    bool logarithmic = true;
    double low = 0.0;  // > 0 where logarithmic
    double high = 1.0; // > low

    // 0 at `low`, 1 at `high`, beyond them beyond; −∞ for 0 on a logarithmic scale. NaN stays NaN.
    double share(double value) const;
    // The value at a share.
    double value(double share) const;
};

// A scale with round ends (1, 2 or 5 times a power of ten) for one channel of values: up to the value that 999 of 1000
// of the lit pixels (> 0) do not exceed; logarithmic: down to the darkest hundredth of them, at most three decades.
// 0.1 to 1 (linear 0 to 1) for a picture without light. `unit` is what one unit of the legend is in the values' unit:
// the ends are round in it.
ValueScale round_scale(const Image& values, bool logarithmic, double unit = 1.0);

// About `count` numbers within the scale, ascending, round in `unit`; both ends are among them where they are round.
std::vector<double> scale_numbers(const ValueScale& scale, double unit, int count);

// Of the lit pixels those that lie beyond the ends of a scale, and the greatest value.
struct ScaleUse {
    double below_share = 0.0; // of all that are > 0
    double above_share = 0.0;
    double greatest = 0.0;
};

ScaleUse use_of(const Image& values, const ValueScale& scale);

} // namespace gonio
