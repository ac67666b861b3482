#include <gonio/base/charconv.hpp>

#include "../scaled.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {
namespace {

// What the text gives: the number, how much of it was read, and whether that is a failure.
struct Read {
    double value;
    std::ptrdiff_t length;
    std::errc error;
};
constexpr double untouched = -123.0;

Read read(std::string_view text) {
    double value = untouched;
    const auto [end, error] = portable_from_chars(text.data(), text.data() + text.size(), value);
    return {value, end - text.data(), error};
}

std::string written(double value, std::chars_format format) {
    std::array<char, 400> text{};
    return {text.data(), portable_to_chars(text.data(), text.data() + text.size(), value, format).ptr};
}

std::string written(double value, std::chars_format format, int precision) {
    std::array<char, 400> text{};
    return {text.data(), portable_to_chars(text.data(), text.data() + text.size(), value, format, precision).ptr};
}

std::vector<double> many_numbers() {
    std::vector<double> numbers{0.0,
                                1.0,
                                0.1,
                                0.3,
                                1e15,
                                1e16,
                                1e21,
                                1e22,
                                1e23,
                                9007199254740991.0,
                                9007199254740992.0,
                                9007199254740994.0,
                                5e-324,
                                2.2250738585072009e-308,
                                2.2250738585072014e-308,
                                std::numeric_limits<double>::max(),
                                123456789.125,
                                1e-5,
                                1e-4,
                                9.5367431640625e-7};
    std::mt19937_64 random(1);
    for (int i = 0; i < test::scaled(20000); ++i) {
        const auto any = std::uint64_t{random()};
        double number = 0.0;
        switch (i % 5) {
        case 0: // any of them
            number = __builtin_bit_cast(double, any);
            break;
        case 1: // as files have them
            number = static_cast<double>(any % 100'000'000) / 1e4;
            break;
        case 2: // subnormal
            number = __builtin_bit_cast(double, any >> 12U);
            break;
        case 3: // whole
            number = static_cast<double>(any >> (any % 64));
            break;
        default:
            number = std::pow(10.0, static_cast<double>(any % 600) - 300.0);
        }
        if (std::isfinite(number)) numbers.push_back(number);
    }
    return numbers;
}

TEST(CharConv, ReadsTheNumberAtTheFront) {
    EXPECT_EQ(read("800lm").value, 800.0);
    EXPECT_EQ(read("800lm").length, 3);
    EXPECT_EQ(read("-2.5").value, -2.5);
    EXPECT_EQ(read(".5").value, 0.5);
    EXPECT_EQ(read("5.").length, 2);
    EXPECT_EQ(read("1e3").value, 1000.0);
    EXPECT_EQ(read("5ev").length, 1); // not an exponent
    EXPECT_EQ(read("5e+").length, 1);
    EXPECT_EQ(read("0x10").length, 1); // no hexadecimal numbers
    EXPECT_EQ(read("5e-324").value, 5e-324);
    EXPECT_EQ(read("1,5").length, 1);
    EXPECT_TRUE(std::signbit(read("-0").value));
    EXPECT_EQ(read(std::string(500, '9') + "e-499").value, 10.0);
}

TEST(CharConv, RefusesWhatIsNoNumber) {
    for (const std::string_view text :
         {"", "-", "+", "+5", " 5", "\t5", ".", "e5", "-.e5", "--5", "+-5", "lm", "in", "na", "-i"}) {
        EXPECT_EQ(read(text).error, std::errc::invalid_argument) << text;
        EXPECT_EQ(read(text).length, 0) << text;
        EXPECT_EQ(read(text).value, untouched) << text;
    }
    for (const std::string_view text : {"1e999", "-1e999", "1e-999", "1.8e308", "1e-400", "2e-324"}) {
        EXPECT_EQ(read(text).error, std::errc::result_out_of_range) << text;
        EXPECT_EQ(read(text).length, static_cast<std::ptrdiff_t>(text.size())) << text;
        EXPECT_EQ(read(text).value, untouched) << text;
    }
}

TEST(CharConv, WritesAsStdDoes) {
    const auto fixed = std::chars_format::fixed;
    const auto scientific = std::chars_format::scientific;
    EXPECT_EQ(written(0.1, fixed), "0.1");
    EXPECT_EQ(written(1e22, fixed), "10000000000000000000000");
    EXPECT_EQ(written(1e23, fixed), "99999999999999991611392");
    EXPECT_EQ(written(1200.0, fixed), "1200");
    EXPECT_EQ(written(1e-7, fixed), "0.0000001");
    EXPECT_EQ(written(-0.0, fixed), "-0");
    EXPECT_EQ(written(1.0, scientific), "1e+00");
    EXPECT_EQ(written(-1234.5, scientific), "-1.2345e+03");
    EXPECT_EQ(written(5e-324, scientific), "5e-324");
    EXPECT_EQ(written(0.0, scientific), "0e+00");
    EXPECT_EQ(written(2.0 / 3.0, scientific, 3), "6.667e-01");
    EXPECT_EQ(written(2.5, scientific, 0), "2e+00");
    EXPECT_EQ(written(-1.0 / 3.0, fixed, 2), "-0.33");

    std::array<char, 3> little{};
    const auto [end, error] = portable_to_chars(little.data(), little.data() + little.size(), 1.234, fixed);
    EXPECT_EQ(error, std::errc::value_too_large);
    EXPECT_EQ(end, little.data() + little.size());
}

TEST(CharConv, WhatWasWrittenReadsBack) {
    for (const double number : many_numbers())
        for (const auto format : {std::chars_format::fixed, std::chars_format::scientific}) {
            const std::string text = written(number, format);
            if (text.size() >= 400) continue;
            EXPECT_EQ(read(text).value, number) << text;
            EXPECT_EQ(read(text).length, static_cast<std::ptrdiff_t>(text.size())) << text;
        }
}

// libc++ has neither function for double, or not both.
#if !defined(_LIBCPP_VERSION) || _LIBCPP_VERSION >= 200000

void expect_read_as_by_std(const std::string& text) {
    double value = untouched;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const Read found = read(text);
    EXPECT_EQ(found.error, error) << text;
    EXPECT_EQ(found.length, end - text.data()) << text;
    EXPECT_EQ(std::isnan(found.value), std::isnan(value)) << text;
    if (!std::isnan(value)) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(found.value), std::bit_cast<std::uint64_t>(value)) << text;
    }
}

TEST(CharConv, ReadsWhatStdReads) {
    for (const char* text : {"inf",
                             "-inf",
                             "INF",
                             "Infinity",
                             "infinit",
                             "-INFINITYx",
                             "nan",
                             "-NaN",
                             "nan(",
                             "nan()",
                             "nan(1_a)",
                             "nan(1-a)",
                             "+inf",
                             "0x1p3",
                             "0X",
                             "-0",
                             "-0e5",
                             "0e999",
                             "000.000e-999",
                             "1.5.5",
                             "1e",
                             "1e-",
                             "1e5e5",
                             "1E5",
                             "1E+05",
                             "1d5",
                             "2.4703282292062327e-324",
                             "2.4703282292062328e-324",
                             "1.7976931348623158e308",
                             "1.7976931348623159e308",
                             "9007199254740993",
                             "1e99999999999999999999",
                             "1e-99999999999999999999",
                             "0.000000000000000000000000000000000000000000000000000000000001e60"})
        expect_read_as_by_std(text);
    // Any arrangement of the characters that matter.
    std::mt19937 random(2);
    constexpr std::string_view characters = "0159.eE+-xinfa ";
    for (int i = 0; i < 200000; ++i) {
        std::string text;
        for (auto length = random() % 9; length > 0; --length)
            text += characters[random() % characters.size()];
        expect_read_as_by_std(text);
    }
    for (const double number : many_numbers()) {
        std::array<char, 400> text{};
        const auto [end, error] =
            std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::scientific, 20);
        ASSERT_EQ(error, std::errc());
        expect_read_as_by_std({text.data(), end});
    }
}

TEST(CharConv, WritesWhatStdWrites) {
    const auto by_std = [](double number, std::chars_format format, auto... precision) {
        std::array<char, 400> text{};
        return std::string(text.data(),
                           std::to_chars(text.data(), text.data() + text.size(), number, format, precision...).ptr);
    };
    std::vector<double> numbers = many_numbers();
    numbers.push_back(std::numeric_limits<double>::infinity());
    for (const double magnitude : numbers)
        for (const double number : {magnitude, -magnitude})
            for (const auto format : {std::chars_format::fixed, std::chars_format::scientific}) {
                EXPECT_EQ(written(number, format), by_std(number, format));
                for (const int precision : {0, 5, 8, 16})
                    EXPECT_EQ(written(number, format, precision), by_std(number, format, precision));
            }
}

#endif

} // namespace
} // namespace gonio
