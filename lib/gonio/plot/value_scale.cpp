#include <gonio/plot/axis.hpp>
#include <gonio/plot/value_scale.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gonio {

namespace {

constexpr double decades = 3.0;

// 1, 2 or 5 times a power of ten: the least that is not below `value` > 0 or, if not `up`, the greatest that is not
// above it.
double round_125(double value, bool up) {
    constexpr double hair = 1e-9;
    const double power = std::pow(10.0, std::floor(std::log10(value) + hair));
    double below = power;
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        const double at = factor * power;
        if (up && at >= value * (1.0 - hair)) return at;
        if (at <= value * (1.0 + hair)) below = at;
    }
    return below;
}

} // namespace

double ValueScale::share(double value) const {
    if (!logarithmic) return (value - low) / (high - low);
    return std::log(std::fmax(value, 0.0) / low) / std::log(high / low);
}

double ValueScale::value(double share) const {
    if (!logarithmic) return low + share * (high - low);
    return low * std::pow(high / low, share);
}

ValueScale round_scale(const Image& values, bool logarithmic, double unit) {
    std::vector<float> lit;
    std::copy_if(values.pixels.begin(), values.pixels.end(), std::back_inserter(lit),
                 [](float value) { return value > 0.0F && std::isfinite(value); });
    const double floor = logarithmic ? 0.1 : 0.0;
    if (lit.empty()) return {logarithmic, floor * unit, unit};
    const auto ranked = [&](std::size_t of_1000) {
        const auto at = lit.begin() + static_cast<std::ptrdiff_t>((lit.size() - 1) * of_1000 / 1000);
        std::nth_element(lit.begin(), at, lit.end());
        return static_cast<double>(*at);
    };
    const double high = round_125(ranked(999) / unit, true);
    if (!logarithmic) return {false, 0.0, high * unit};
    double low = std::fmax(round_125(ranked(10) / unit, false), high * std::pow(10.0, -decades));
    if (!(low < 0.5 * high)) low = 0.1 * high; // all values are about the same
    return {true, low * unit, high * unit};
}

std::vector<double> scale_numbers(const ValueScale& scale, double unit, int count) {
    constexpr double hair = 1e-9;
    const double low = scale.low / unit;
    const double high = scale.high / unit;
    std::vector<double> numbers =
        scale.logarithmic ? levels_1_2_5(low * (1.0 - hair), high * (1.0 + hair)) : ticks(low, high, count);
    if (scale.logarithmic && numbers.size() > static_cast<std::size_t>(std::max(count, 2))) {
        // Only powers of ten, and only every n-th of them.
        std::vector<double> tens;
        const double first = std::ceil(std::log10(low) - hair);
        const double last = std::floor(std::log10(high) + hair);
        const double every = std::fmax(1.0, std::ceil((last - first + 1.0) / std::max(count, 1)));
        for (const double power : even_steps(first, last, every))
            tens.push_back(std::pow(10.0, power));
        numbers = std::move(tens);
    }
    std::erase_if(numbers, [&](double at) { return at < low - hair * high || at > high * (1.0 + hair); });
    // If less than one step of 1, 2, 5 fits, show the ends.
    if (numbers.size() < 2) numbers = {low, high};
    for (double& number : numbers)
        number *= unit;
    return numbers;
}

ScaleUse use_of(const Image& values, const ValueScale& scale) {
    ScaleUse use;
    std::size_t lit = 0;
    std::size_t below = 0;
    std::size_t above = 0;
    for (const float stored : values.pixels) {
        const auto value = static_cast<double>(stored);
        if (!(value > 0.0)) continue;
        ++lit;
        below += value < scale.low ? 1 : 0;
        above += value > scale.high ? 1 : 0;
        use.greatest = std::fmax(use.greatest, value);
        use.least = lit == 1 ? value : std::fmin(use.least, value);
    }
    if (lit == 0) return use;
    use.below_share = static_cast<double>(below) / static_cast<double>(lit);
    use.above_share = static_cast<double>(above) / static_cast<double>(lit);
    return use;
}

} // namespace gonio
