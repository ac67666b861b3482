#include <gonio/base/charconv.hpp>
#include <gonio/base/decimal.hpp>
#include <gonio/profile/number_text.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace gonio::profile_detail {

namespace {

// The last digit of the result is not 0, unless it has no decimals.
void drop_zeros(Decimal& decimal) {
    while (decimal.decimals > 0 && decimal.digits % 10 == 0) {
        decimal.digits /= 10;
        --decimal.decimals;
    }
}

// `magnitude`, below 1e14, if it has at most so many decimals.
std::optional<Decimal> with_decimals(double magnitude, int decimals) {
    const double power = Decimal::powers[static_cast<std::size_t>(decimals)];
    const double scaled = magnitude * power;
    if (!(scaled < 1e14)) return std::nullopt;
    const Decimal decimal{static_cast<std::int64_t>(nearest_integer(scaled)), decimals};
    if (decimal.value() != magnitude) return std::nullopt;
    return decimal;
}

// The decimal with the fewest digits that reads back as `magnitude`, below 1e14, if that is easily found; `first`: how
// many decimals to try first. A double is the nearest to one decimal of at most 15 significant digits, so any decimal
// of so many that reads back is it.
std::optional<Decimal> shortest_decimal(double magnitude, int first) {
    std::optional<Decimal> found = with_decimals(magnitude, first);
    for (int decimals = 0; !found && decimals <= 3; ++decimals)
        if (decimals != first) found = with_decimals(magnitude, decimals);
    if (!found) {
        constexpr int few = 9; // as portable profiles have
        found = nearest_decimal(magnitude, few);
        if (!found || found->value() != magnitude) found = nearest_decimal(magnitude, most_digits_of_decimal);
        if (!found || found->value() != magnitude) return std::nullopt;
    }
    drop_zeros(*found);
    return found;
}

// The same text as below, for numbers that files have: few digits.
bool append_decimal(std::string& text, double value, int& first) {
    const double magnitude = std::abs(value);
    if (!(magnitude < 1e14)) return false;
    const std::optional<Decimal> decimal = shortest_decimal(magnitude, first);
    if (!decimal) return false;
    // Many more would make zeros to be dropped.
    constexpr int many = 2;
    if (decimal->decimals > first || decimal->decimals + many < first)
        first = std::min(decimal->decimals, most_digits_of_decimal);
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
    NumberText().append(text, value);
}

void NumberText::append(std::string& text, double value) {
    if (append_decimal(text, value, decimals_)) return;
    const double magnitude = std::abs(value);
    const bool plain = magnitude == 0.0 || (magnitude >= 1e-30 && magnitude < 1e15);
    std::array<char, 64> buffer{}; // the longest: a sign, "0.", 29 zeros and 17 digits
    const auto [end, error] = to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                       plain ? std::chars_format::fixed : std::chars_format::scientific);
    text.append(buffer.data(), end);
}

} // namespace gonio::profile_detail
