#include <gonio/base/nearest_double.hpp>

#include "../scaled.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace gonio {
namespace {

void expect_as_strtod(const std::string& text) {
    EXPECT_EQ(__builtin_bit_cast(std::uint64_t, nearest_double(text)),
              __builtin_bit_cast(std::uint64_t, std::strtod(text.c_str(), nullptr)))
        << text;
}

TEST(NearestDouble, IsThatOfStrtodForAnyDigits) {
    std::mt19937_64 random(1);
    for (int i = 0; i < test::scaled(50000); ++i) {
        std::string text = random() % 4 == 0 ? "-" : "";
        const auto digits = static_cast<std::size_t>(1 + random() % 24);
        for (std::size_t n = 0; n < digits; ++n)
            text += static_cast<char>('0' + random() % 10);
        if (random() % 2 == 0) text.insert(text.size() - random() % (digits + 1), ".");
        if (random() % 2 == 0) text += (random() % 2 == 0 ? "e-" : "E") + std::to_string(random() % 360);
        expect_as_strtod(text);
    }
}

TEST(NearestDouble, RoundsHalvesToEvenAndWhatIsNextToThemToTheirSide) {
    const std::string half = "9007199254740993"; // between 2^53 and 2^53 + 2
    EXPECT_EQ(nearest_double(half), 9007199254740992.0);
    EXPECT_EQ(nearest_double(half + "." + std::string(1000, '0')), 9007199254740992.0);
    EXPECT_EQ(nearest_double(half + "." + std::string(1000, '0') + "1"), 9007199254740994.0);
    EXPECT_EQ(nearest_double("9007199254740992." + std::string(1000, '9')), 9007199254740992.0);
    EXPECT_EQ(nearest_double("9007199254740995"), 9007199254740996.0);
    for (const char* const text :
         {"2.4703282292062327208e-324", "2.4703282292062328e-324", "7.4109846876186982e-324", "2.2250738585072011e-308",
          "1.7976931348623158e308", "1.7976931348623159e308"}) // about the least and the largest
        expect_as_strtod(text);
}

TEST(NearestDouble, TakesAnyNumberOfZerosAndAnyExponent) {
    EXPECT_EQ(nearest_double("0." + std::string(5000, '0') + "125e5001"), 1.25);
    EXPECT_EQ(nearest_double("1" + std::string(5000, '0') + "e-5000"), 1.0);
    EXPECT_EQ(nearest_double("1e99999999999"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(nearest_double("1e-99999999999"), 0.0);
    EXPECT_EQ(nearest_double("0e99999999999"), 0.0);
    EXPECT_EQ(nearest_double(".5"), 0.5);
    EXPECT_EQ(nearest_double("5."), 5.0);
    EXPECT_TRUE(std::signbit(nearest_double("-0")));
}

} // namespace
} // namespace gonio
