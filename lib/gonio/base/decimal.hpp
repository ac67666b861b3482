// Doubles that are decimals of few digits, found by a product in place of an algorithm for all doubles. Internal.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace gonio {

// The nearest integer, of two the even one; `value` in [0, 2⁵¹).
inline double nearest_integer(double value) {
    constexpr double ones = 0x1.8p52; // the last digit of such numbers is 1
    return (value + ones) - ones;
}

// digits / 10^decimals
struct Decimal {
    std::int64_t digits = 0;
    int decimals = 0;

    // Of ten; exact.
    static constexpr std::array powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                       1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

    // The nearest double: both numbers are exact, so the quotient is rounded once.
    [[nodiscard]] double value() const {
        return static_cast<double>(digits) / powers[static_cast<std::size_t>(decimals)];
    }
};

inline constexpr int most_digits_of_decimal = 14;

// The nearest number of so many significant digits, of which the last may be zeros; 1 to most_digits_of_decimal. None
// where a product does not find it: outside of [1e-7, 1e14), with fewer digits than `magnitude` has before its point,
// and near the middle between two.
std::optional<Decimal> nearest_decimal(double magnitude, int digits);

} // namespace gonio
