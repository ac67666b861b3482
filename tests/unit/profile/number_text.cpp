// Numbers in photometric files against the standard library's shortest text.
#include <gonio/base/charconv.hpp>
#include <gonio/profile/number_text.hpp>

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace {

using namespace gonio;

std::string shortest_fixed(double value) {
    std::array<char, 400> buffer{};
    return {buffer.data(), to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed).ptr};
}

void expect_shortest(double value) {
    std::string text = "before ";
    profile_detail::append_number(text, value);
    ASSERT_EQ(text, "before " + shortest_fixed(value));
}

TEST(NumberText, IsTheShortestOfDecimals) {
    std::mt19937_64 generator(1);
    for (int digits = 1; digits <= 17; ++digits)
        for (int i = 0; i < 5000; ++i) {
            const double whole = std::floor(std::pow(10.0, digits) * std::generate_canonical<double, 53>(generator));
            const double value = whole / std::pow(10.0, static_cast<double>(generator() % 24) - 2.0);
            if (!(value >= 1e-30 && value < 1e15)) continue;
            expect_shortest(value);
            expect_shortest(-value);
            expect_shortest(std::nextafter(value, 0.0));
            expect_shortest(std::nextafter(value, std::numeric_limits<double>::infinity()));
        }
}

TEST(NumberText, IsTheShortestOfAnyDouble) {
    std::mt19937_64 generator(2);
    std::uniform_real_distribution<double> exponent(-30.0, 15.0);
    for (int i = 0; i < 100'000; ++i)
        expect_shortest(std::pow(10.0, exponent(generator)));
    for (const double value :
         {0.0, -0.0, 1e-7, 9.99999999e-8, 1e14, 99999999999999.5, 99999999999999.0, 0.1, 0.3, 0.1 + 0.2, 1.0 / 3.0})
        expect_shortest(value);
}

// Whatever came before.
TEST(NumberText, OfATableIsThatOfEachNumber) {
    std::mt19937_64 generator(3);
    profile_detail::NumberText table;
    for (int i = 0; i < 200'000; ++i) {
        const int decimals = static_cast<int>((i / 50 + static_cast<int>(generator() % 2)) % 16);
        const double value = std::floor(std::pow(10.0, static_cast<double>(generator() % 15)) *
                                        std::generate_canonical<double, 53>(generator)) /
                             std::pow(10.0, decimals);
        std::string text;
        std::string alone;
        table.append(text, generator() % 2 == 0 ? value : -value / 3.0);
        profile_detail::append_number(alone, std::strtod(text.c_str(), nullptr));
        ASSERT_EQ(text, alone);
        if (!text.empty() && text[0] != '-') {
            ASSERT_EQ(text, shortest_fixed(value));
        }
    }
}

} // namespace
