// Numbers rounded to decimal digits, against their text.
#include <gonio/base/charconv.hpp>
#include <gonio/web/make_profile.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace gonio {
namespace {

double by_text(double value, int digits) {
    std::string text(64, '\0');
    const auto written =
        to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
    double rounded = 0.0;
    from_chars(text.data(), written.ptr, rounded);
    return rounded;
}

TEST(RoundedTo, IsTheNumberOfItsDigits) {
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> exponent(-12.0, 18.0);
    std::vector<double> values{
        0.0,  -0.0, 1.0,  10.0,        0.1,          999999999.5, 9.9999999995,       99999.99999, 0.000123456789012345,
        1e22, 1e-7, 1e14, 123456789.5, 1234567890.5, 2.5,         0.30000000000000004};
    for (int i = 0; i < 200'000; ++i) {
        const double value = std::pow(10.0, exponent(generator)) * (i % 3 == 0 ? -1.0 : 1.0);
        values.push_back(value);
        const double short_one = by_text(value, 1 + i % 7); // as files have them
        values.push_back(short_one);
        values.push_back(0.5 * (short_one + std::nextafter(short_one, 1e300)));
        values.push_back(short_one * 0.87);
        values.push_back(std::nextafter(std::pow(10.0, i % 20 - 6), i % 2 == 0 ? 0.0 : 1e300));
        // The middle between two of nine digits.
        values.push_back((std::floor(1e8 + 9e8 * (i / 200'000.0)) + 0.5) * std::pow(10.0, i % 11 - 8));
    }
    for (const int digits : {1, 7, 9, 10, 14, 16})
        for (const double value : values)
            ASSERT_EQ(web_detail::rounded_to(value, digits), by_text(value, digits)) << value << ' ' << digits;
}

} // namespace
} // namespace gonio
