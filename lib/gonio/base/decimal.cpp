#include <gonio/base/decimal.hpp>

#include <cmath>
#include <cstddef>
#include <cstring>

namespace gonio {

std::optional<Decimal> nearest_decimal(double magnitude, int digits) {
    if (!(magnitude >= 1e-7 && magnitude < 1e14) || digits < 1 || digits > most_digits_of_decimal) return std::nullopt;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &magnitude, sizeof(bits));
    const int exponent = static_cast<int>(bits >> 52U) - 1023;
    // The decimal exponent or one less: log₁₀ 2 is 78913/2¹⁸.
    constexpr auto& powers = Decimal::powers;
    int decimals = digits - 1 - ((exponent * 78913) >> 18);
    const double above = powers.at(static_cast<std::size_t>(digits));
    if (decimals < 0 || decimals >= static_cast<int>(powers.size())) return std::nullopt;
    if (magnitude * powers.at(static_cast<std::size_t>(decimals)) >= above) --decimals;
    if (decimals < 0) return std::nullopt;
    const double scaled = magnitude * powers.at(static_cast<std::size_t>(decimals));
    const double whole = nearest_integer(scaled);
    const double least = powers.at(static_cast<std::size_t>(digits) - 1);
    // The product is off by 1e-16 of up to 1e14.
    if (!(scaled >= least && scaled < above) || std::abs(scaled - whole) > 0.45) return std::nullopt;
    return Decimal{static_cast<std::int64_t>(whole), decimals};
}

} // namespace gonio
