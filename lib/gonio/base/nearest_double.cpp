#include <gonio/base/nearest_double.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

namespace gonio {

namespace {

// Digits that decide: half of the distance of two doubles has fewer, and one more digit tells whether more follow.
constexpr int most_digits = 780;
constexpr int most_exact_power = 22; // 10^23 is no double
constexpr int least_power = -324;    // what is below 10^-325 is nearer to 0 than to the least double
constexpr int far_power = 200'000'000;

// A whole number of any size, by words of 32 bits, the least first; the last is not 0.
class Natural {
public:
    explicit Natural(std::uint32_t value) {
        if (value != 0) words_.push_back(value);
    }
    [[nodiscard]] bool is_zero() const { return words_.empty(); }
    [[nodiscard]] int bits() const {
        int count = 32 * (static_cast<int>(words_.size()) - 1);
        for (std::uint32_t last = words_.back(); last != 0; last >>= 1U)
            ++count;
        return count;
    }
    void multiply_add(std::uint32_t factor, std::uint32_t summand) {
        std::uint64_t carry = summand;
        for (std::uint32_t& word : words_) {
            carry += std::uint64_t(word) * factor;
            word = static_cast<std::uint32_t>(carry);
            carry >>= 32U;
        }
        if (carry != 0) words_.push_back(static_cast<std::uint32_t>(carry));
    }
    void multiply_by_power_of_ten(int power) {
        for (; power >= 9; power -= 9)
            multiply_add(1'000'000'000, 0);
        for (; power > 0; --power)
            multiply_add(10, 0);
    }
    void shift_left(int bits) {
        words_.insert(words_.begin(), static_cast<std::size_t>(bits / 32), 0);
        multiply_add(1U << static_cast<unsigned>(bits % 32), 0);
    }
    [[nodiscard]] bool less_than(const Natural& other) const {
        if (words_.size() != other.words_.size()) return words_.size() < other.words_.size();
        return std::lexicographical_compare(words_.rbegin(), words_.rend(), other.words_.rbegin(), other.words_.rend());
    }
    void subtract(const Natural& other) { // which must not be larger
        std::uint64_t borrow = 0;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            const std::uint64_t difference =
                std::uint64_t(words_[i]) - (i < other.words_.size() ? other.words_[i] : 0) - borrow;
            words_[i] = static_cast<std::uint32_t>(difference);
            borrow = difference >> 63U;
        }
        while (!words_.empty() && words_.back() == 0)
            words_.pop_back();
    }

private:
    std::vector<std::uint32_t> words_;
};

// mantissa · 2^exponent, rounded to what a double holds; `inexact` where the number is a bit larger than that.
double rounded(std::uint64_t mantissa, int exponent, bool inexact) {
    int length = 64;
    while (mantissa >> static_cast<unsigned>(length - 1) == 0)
        --length;
    const int least_exponent = std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits;
    const int drop = std::max(length - std::numeric_limits<double>::digits, least_exponent - exponent);
    if (drop <= 0) return std::ldexp(static_cast<double>(mantissa), exponent);
    if (drop > length) return 0.0;
    const std::uint64_t half = std::uint64_t(1) << static_cast<unsigned>(drop - 1);
    const std::uint64_t rest = mantissa & (half | (half - 1));
    const std::uint64_t kept = (mantissa - rest) >> static_cast<unsigned>(drop - 1) >> 1U; // by up to 64
    const bool up = rest > half || (rest == half && (inexact || kept % 2 == 1));
    return std::ldexp(static_cast<double>(kept + (up ? 1 : 0)), exponent + drop);
}

// digits · 10^power. Both are made whole numbers whose quotient is between a half and 2, and 64 bits of it are
// computed.
double quotient(Natural digits, int power) {
    Natural divisor(1);
    (power < 0 ? divisor : digits).multiply_by_power_of_ten(std::abs(power));
    const int shift = divisor.bits() - digits.bits();
    (shift < 0 ? divisor : digits).shift_left(std::abs(shift));
    std::uint64_t bits = 0;
    for (int i = 0; i < 64; ++i) {
        bits <<= 1U;
        if (!digits.less_than(divisor)) {
            digits.subtract(divisor);
            bits |= 1U;
        }
        if (!digits.is_zero()) digits.shift_left(1);
    }
    return rounded(bits, -63 - shift, !digits.is_zero());
}

// The number behind the "e", cut where it is far beyond what text could make up for.
int exponent(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    int value = 0;
    for (const char c : text)
        value = std::min(10 * value + (c - '0'), far_power);
    return negative ? -value : value;
}

// The number of all digits of a mantissa, cut behind most_digits. `power` grows by what is cut.
Natural whole_number(std::string_view mantissa, int& power) {
    Natural number(0);
    int count = 0;
    bool more = false; // whether a digit that is cut is not 0
    for (const char c : mantissa) {
        if (c == '.' || (c == '0' && number.is_zero())) continue;
        if (count++ < most_digits) {
            number.multiply_add(10, static_cast<std::uint32_t>(c - '0'));
        } else {
            more = more || c != '0';
            ++power;
        }
    }
    if (more) { // one digit stands for all of them
        number.multiply_add(10, 1);
        --power;
    }
    return number;
}

double magnitude(std::string_view text) {
    const std::size_t end = std::min(text.find_first_of("eE"), text.size());
    const std::string_view mantissa = text.substr(0, end);
    int power = exponent(text.substr(std::min(end + 1, text.size())));
    std::uint64_t digits = 0; // right where they are few
    int count = 0;            // of digits behind zeros in front
    bool behind_point = false;
    for (const char c : mantissa) {
        if (c == '.') {
            behind_point = true;
            continue;
        }
        if (behind_point) --power;
        digits = 10 * digits + static_cast<std::uint64_t>(c - '0');
        if (count > 0 || c != '0') ++count;
    }
    if (count == 0) return 0.0;
    if (count + power > std::numeric_limits<double>::max_exponent10 + 1) return std::numeric_limits<double>::infinity();
    if (count + power < least_power) return 0.0;
    if (count <= std::numeric_limits<double>::digits10 && std::abs(power) <= most_exact_power) {
        double scale = 1.0; // exact, as both numbers are, so that one operation rounds
        for (int n = std::abs(power); n > 0; --n)
            scale *= 10.0;
        const auto whole = static_cast<double>(digits);
        return power < 0 ? whole / scale : whole * scale;
    }
    Natural number = whole_number(mantissa, power);
    return quotient(std::move(number), power);
}

} // namespace

double nearest_double(std::string_view text) {
    const bool negative = text.starts_with('-');
    const double value = magnitude(text.substr(negative ? 1 : 0));
    return negative ? -value : value;
}

} // namespace gonio
