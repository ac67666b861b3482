#include <gonio/plot/axis.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace gonio {

std::vector<double> even_steps(double first, double last, double step) {
    std::vector<double> at;
    const double count = std::floor((last - first) / step + 1e-9);
    for (int i = 0; i <= static_cast<int>(count); ++i)
        at.push_back(first + i * step);
    return at;
}

std::vector<double> ticks(double low, double high, int count) {
    if (!(high > low) || !std::isfinite(high - low)) return {low};
    const double wanted = (high - low) / std::max(count, 1);
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    double step = 10.0 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= 0.8 * wanted) {
            step = factor * power;
            break;
        }
    // A very narrow span around a large number: all its multiples would be written with the same digits.
    constexpr double most_steps_from_zero = 1e9;
    if (!(step > 0.0) || std::fabs(low) > most_steps_from_zero * step || std::fabs(high) > most_steps_from_zero * step)
        return {low, high};
    // Multiples, not sums: adding 0.1 ten times does not give 1 exactly.
    std::vector<double> at = even_steps(std::floor(low / step + 1e-9), std::ceil(high / step - 1e-9), 1.0);
    for (double& tick : at)
        tick *= step;
    return at;
}

namespace {

constexpr std::array series_1_2_5{1.0, 2.0, 5.0};
constexpr std::array series_of_6{1.0, 1.5, 2.0, 3.0, 5.0, 7.0};
constexpr std::array series_of_13{1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0};

std::vector<double> levels_of(std::span<const double> series, double low, double high) {
    std::vector<double> levels;
    if (!std::isnormal(low) || low < 0.0 || !std::isfinite(high)) return levels;
    for (int decade = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, decade) <= high; ++decade)
        for (const double factor : series) {
            const double level = factor * std::pow(10.0, decade);
            if (level >= low && level <= high) levels.push_back(level);
        }
    return levels;
}

} // namespace

std::vector<double> levels_1_2_5(double low, double high) {
    return levels_of(series_1_2_5, low, high);
}

std::vector<double> fitting_levels(double low, double high, std::size_t wanted) {
    if (!std::isnormal(low) || low < 0.0 || !std::isfinite(high)) return {};
    for (const std::span<const double> series :
         {std::span<const double>(series_1_2_5), std::span<const double>(series_of_6),
          std::span<const double>(series_of_13)}) {
        std::vector<double> levels = levels_of(series, low, high);
        if (levels.size() >= wanted) return levels;
    }
    std::vector<double> levels = ticks(low, high, static_cast<int>(wanted) + 1);
    std::erase_if(levels, [&](double level) { return !(level > low && level < high); });
    return levels;
}

} // namespace gonio
