// Doubles that are decimals of few digits, found by a product in place of an algorithm for all doubles. Internal.
#pragma once

#include <cstdint>
#include <optional>

namespace gonio {

// digits / 10^decimals
struct Decimal {
    std::int64_t digits = 0;
    int decimals = 0;

    // The nearest double: both numbers are exact, so the quotient is rounded once.
    [[nodiscard]] double value() const;
};

inline constexpr int most_digits_of_decimal = 14;

// The nearest number of so many significant digits, of which the last may be zeros; 1 to most_digits_of_decimal. None
// where a product does not find it: outside of [1e-7, 1e14), where it would have no decimals and more digits, and near
// the middle between two.
std::optional<Decimal> nearest_decimal(double magnitude, int digits);

} // namespace gonio
