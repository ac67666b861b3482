// Decimals as photometric files write them, to the nearest double, in a few nanoseconds. Internal.
//
// There are three methods, each exact: up to seven digits and a point are converted within one 64-bit word; up to 19
// digits with a value below 2^53 by one division with two operands that are exact doubles (W. Clinger, How to read
// floating point numbers accurately, 1990); up to 19 digits beyond that by an integer division, where the remainder
// decides the rounding. All other numbers (an exponent, a leading plus, the last bytes of a file) are left to
// scan_number. None of these methods allocates or reads outside the text.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace gonio::profile_detail {

// The bytes that end a number: space, comma, and the bytes from tab to carriage return.
constexpr bool ends_number(char c) {
    return c == ' ' || c == ',' || (c >= '\t' && c <= '\r');
}

// How many bytes must follow the first byte of a number for read_decimal to try it. The longest text it looks at is a
// sign, 19 digits, a point, and three words of digits after it: 45 bytes.
inline constexpr std::ptrdiff_t decimal_lookahead = 48;

// All powers of ten that a double holds exactly. Kernels name theirs after their instruction set: no two share a
// symbol.
template<class Tag = void>
inline constexpr double decimal_powers[23] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                              1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// Eight bytes of text as a word, the first in its lowest byte, each digit converted to its value.
inline std::uint64_t digits_at(const char* p) {
    std::uint64_t word = 0;
    std::memcpy(&word, p, sizeof word);
    return word ^ 0x3030303030303030U;
}

// The number of bits, counted from the lowest, that belong to whole bytes that are digits. Only the first byte that is
// not a digit is found reliably; nothing else is needed.
inline int digit_bits(std::uint64_t digits) {
    const std::uint64_t others = ((digits + 0x7676767676767676U) | digits) & 0x8080808080808080U;
    return others == 0 ? 64 : std::countr_zero(others) - 7;
}

// The number written by eight digits, the first in the lowest byte: pairs, fours, all eight.
inline std::uint64_t number_of_digits(std::uint64_t digits) {
    digits = digits * 10 + (digits >> 8U);
    constexpr std::uint64_t pairs = 0x000000FF000000FFU;
    return (((digits & pairs) * 0x000F424000000064U) + (((digits >> 16U) & pairs) * 0x0000271000000001U)) >> 32U;
}

// w / 10^k, rounded to nearest even, for w ≥ 2^53 and k ≤ 19: 10^k = 5^k 2^k; the quotient of w and 5^k to 63 bits and
// its remainder determine the nearest double.
inline double divide_exactly(std::uint64_t w, int k) {
    __extension__ using Wide = unsigned __int128;
    // 5^k shifted up to 64 bits, and its reciprocal ⌊(2^128 − 1) / divisor⌋ − 2^64, so that nothing is divided here.
    struct Divisor {
        std::uint64_t divisor = 0;
        std::uint64_t reciprocal = 0;
        int up = 0;
    };
    static constexpr std::array<Divisor, 20> divisors = [] {
        std::array<Divisor, 20> all{};
        std::uint64_t five = 1;
        for (Divisor& one : all) {
            one.up = std::countl_zero(five);
            one.divisor = five << static_cast<unsigned>(one.up);
            one.reciprocal = static_cast<std::uint64_t>(~Wide{0} / one.divisor - (Wide{1} << 64U));
            five *= 5;
        }
        return all;
    }();
    const auto [divisor, reciprocal, divisor_up] = divisors[static_cast<std::size_t>(k)];
    const int up = std::countl_zero(w);
    // The dividend's upper word is below 2^63, so that the quotient fits (N. Möller, T. Granlund, Improved division by
    // invariant integers, 2011).
    const std::uint64_t upper = w << static_cast<unsigned>(up) >> 1U;
    const std::uint64_t lower = w << static_cast<unsigned>(up) << 63U;
    const Wide estimate = Wide{reciprocal} * upper + (Wide{upper} << 64U) + lower;
    std::uint64_t quotient = static_cast<std::uint64_t>(estimate >> 64U) + 1;
    std::uint64_t remainder = lower - quotient * divisor;
    if (remainder > static_cast<std::uint64_t>(estimate)) {
        --quotient;
        remainder += divisor;
    }
    if (remainder >= divisor) {
        ++quotient;
        remainder -= divisor;
    }
    const bool rest = remainder != 0;
    // quotient 2^(divisor_up − up − 63 − k) is the number; its 62 to 64 bits are cut to 53.
    const int drop = 11 - std::countl_zero(quotient);
    // 9 ≤ drop ≤ 11; the analyzer does not see this.
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult)
    const std::uint64_t half = std::uint64_t{1} << static_cast<unsigned>(drop - 1);
    const std::uint64_t tail = quotient & (2 * half - 1);
    quotient >>= static_cast<unsigned>(drop);
    if (tail > half || (tail == half && (rest || (quotient & 1U) != 0))) ++quotient;
    // An exponent between −63 − 19 − 63 and 64: never a subnormal, and the product with a power of two is exact.
    const int exponent = divisor_up - up - 63 - k + drop;
    return static_cast<double>(quotient) *
           __builtin_bit_cast(double, static_cast<std::uint64_t>(1023 + exponent) << 52U);
}

// Up to 19 digits and a point, from `p` on, where digits may begin; nullptr for anything else.
[[gnu::noinline]] inline const char* read_long_decimal(const char* p, double& magnitude) {
    static constexpr std::array<std::uint64_t, 9> tens{1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
    std::uint64_t w = 0;
    const auto read_digits = [&](int most) {
        int count = 0;
        for (;;) {
            const std::uint64_t digits = digits_at(p);
            const int bits = digit_bits(digits);
            if (bits != 0)
                w = w * tens[static_cast<std::size_t>(bits / 8)] +
                    number_of_digits(digits << (64U - static_cast<unsigned>(bits)));
            p += bits / 8;
            count += bits / 8;
            if (bits != 64 || count > most) return count;
        }
    };
    constexpr int most = 19;
    const int whole = read_digits(most);
    const int significant = w == 0 ? 0 : whole; // a zero before the point is not a significant digit
    int decimals = 0;
    if (whole > most) return nullptr;
    if (*p == '.') {
        ++p;
        decimals = read_digits(most);
    }
    if (whole + decimals == 0 || significant + decimals > most || !ends_number(*p)) return nullptr;
    constexpr std::uint64_t exact = std::uint64_t{1} << 53U;
    magnitude = w < exact ? static_cast<double>(w) / decimal_powers<>[static_cast<std::size_t>(decimals)]
                          : divide_exactly(w, decimals);
    return p;
}

// Reads the number at `p` and returns the position after it: a byte that ends_number. nullptr, with `value` unchanged,
// if the number needs another method, or is not a number.
inline const char* read_decimal(const char* p, const char* end, double& value) {
    if constexpr (std::endian::native != std::endian::little) return nullptr;
    if (end - p < decimal_lookahead) return nullptr;
    const bool negative = *p == '-';
    p += negative ? 1 : 0;
    const std::uint64_t digits = digits_at(p);
    const int whole_bits = digit_bits(digits);
    double magnitude = 0.0;
    if (whole_bits != 64) {
        const bool point = p[whole_bits / 8] == '.';
        // The digits after the point move down by one byte, over the point; the freed byte is not a digit.
        const std::uint64_t below = (std::uint64_t{1} << static_cast<unsigned>(whole_bits)) - 1;
        const std::uint64_t joined = (digits & below) | ((digits >> 8U) & ~below) | 0xFF00000000000000U;
        const int bits = point ? digit_bits(joined) : whole_bits;
        const char* const behind = p + bits / 8 + (point ? 1 : 0);
        if (bits != 0 && ends_number(*behind)) {
            const std::uint64_t w = number_of_digits(joined << (64U - static_cast<unsigned>(bits)));
            magnitude = static_cast<double>(w) / decimal_powers<>[static_cast<std::size_t>((bits - whole_bits) / 8)];
            value = negative ? -magnitude : magnitude;
            return behind;
        }
    }
    const char* const behind = read_long_decimal(p, magnitude);
    if (behind != nullptr) value = negative ? -magnitude : magnitude;
    return behind;
}

} // namespace gonio::profile_detail
