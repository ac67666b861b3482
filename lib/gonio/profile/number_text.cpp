#include <gonio/base/charconv.hpp>
#include <gonio/base/decimal.hpp>
#include <gonio/profile/number_text.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace gonio::profile_detail {

namespace {

// The decimal with the fewest digits that reads back as `magnitude`, below 1e14, if that is easily found. A double is
// the nearest to one decimal of at most 15 significant digits, so any decimal of so many that reads back is it.
std::optional<Decimal> shortest_decimal(double magnitude) {
    double power = 1.0;
    for (int decimals = 0; decimals <= 3; ++decimals, power *= 10.0) {
        if (magnitude >= 1e14 / power) break;
        const auto digits = static_cast<std::int64_t>(nearest_integer(magnitude * power));
        if (static_cast<double>(digits) / power == magnitude) return Decimal{digits, decimals};
    }
    constexpr int few = 9; // as portable profiles have
    std::optional<Decimal> found = nearest_decimal(magnitude, few);
    if (!found || found->value() != magnitude) found = nearest_decimal(magnitude, most_digits_of_decimal);
    if (!found || found->value() != magnitude) return std::nullopt;
    while (found->digits % 10 == 0) {
        found->digits /= 10;
        --found->decimals;
    }
    return found;
}

// The same text as below, for numbers that files have: few digits.
bool append_decimal(std::string& text, double value) {
    const double magnitude = std::abs(value);
    if (!(magnitude < 1e14)) return false;
    const std::optional<Decimal> decimal = shortest_decimal(magnitude);
    if (!decimal) return false;
    std::array<char, 16> digits;
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), decimal->digits).ptr;
    const auto count = static_cast<std::size_t>(end - digits.data());
    const auto decimals = static_cast<std::size_t>(decimal->decimals);
    if (std::signbit(value)) text += '-';
    if (decimals == 0) {
        text.append(digits.data(), count);
    } else if (count > decimals) {
        text.append(digits.data(), count - decimals).push_back('.');
        text.append(digits.data() + count - decimals, decimals);
    } else {
        text.append("0.").append(decimals - count, '0').append(digits.data(), count);
    }
    return true;
}

} // namespace

void append_number(std::string& text, double value) {
    if (append_decimal(text, value)) return;
    const double magnitude = std::abs(value);
    const bool plain = magnitude == 0.0 || (magnitude >= 1e-30 && magnitude < 1e15);
    std::array<char, 64> buffer{}; // the longest: a sign, "0.", 29 zeros and 17 digits
    const auto [end, error] = to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                       plain ? std::chars_format::fixed : std::chars_format::scientific);
    text.append(buffer.data(), end);
}

} // namespace gonio::profile_detail
