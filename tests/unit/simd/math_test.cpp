// The bounds stated in simd/math.hpp, on every instruction set of this machine, against the C library in double.
#include <gonio/simd/array_math.hpp>
#include <gonio/simd/doubles_math.hpp>
#include <gonio/simd/math.hpp>

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

namespace {

using gonio::simd::array_math;
using gonio::simd::ArrayMath;
using gonio::simd::InstructionSet;

// By instruction set, and whether packs come in pairs.
class PackMath : public testing::TestWithParam<std::tuple<InstructionSet, bool>> {
protected:
    const ArrayMath& math = std::get<1>(GetParam()) ? gonio::simd::array_math_of_twins(std::get<0>(GetParam()))
                                                    : array_math(std::get<0>(GetParam()));
};

std::string set_name(const testing::TestParamInfo<std::tuple<InstructionSet, bool>>& info) {
    return std::string(gonio::simd::to_text(std::get<0>(info.param))) + (std::get<1>(info.param) ? "_twins" : "");
}

INSTANTIATE_TEST_SUITE_P(Sets, PackMath,
                         testing::Combine(testing::ValuesIn(gonio::simd::available_sets().begin(),
                                                            gonio::simd::available_sets().end()),
                                          testing::Bool()),
                         set_name);

// One unit in the last place of the float nearest to x.
double ulp(double x) {
    const auto magnitude = static_cast<float>(std::fabs(x));
    if (magnitude < std::numeric_limits<float>::min()) return std::numeric_limits<float>::denorm_min();
    return static_cast<double>(std::nextafterf(magnitude, std::numeric_limits<float>::infinity())) -
           static_cast<double>(magnitude);
}

// `count` floats spread uniformly over the bit patterns (so over the exponents) of [low, high], 0 < low < high.
std::vector<float> by_exponent(float low, float high, std::size_t count) {
    std::int32_t a = 0;
    std::int32_t b = 0;
    std::memcpy(&a, &low, sizeof a);
    std::memcpy(&b, &high, sizeof b);
    std::vector<float> x(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto bits = static_cast<std::int32_t>(
            a + static_cast<std::int64_t>(b - a) * static_cast<std::int64_t>(i) / static_cast<std::int64_t>(count - 1));
        std::memcpy(&x[i], &bits, sizeof bits);
    }
    return x;
}

std::vector<float> evenly(double low, double high, std::size_t count) {
    std::vector<float> x(count);
    for (std::size_t i = 0; i < count; ++i)
        x[i] = static_cast<float>(low + (high - low) * static_cast<double>(i) / static_cast<double>(count - 1));
    return x;
}

std::vector<float> with_negatives(std::vector<float> x) {
    const std::size_t n = x.size();
    for (std::size_t i = 0; i < n; ++i)
        x.push_back(-x[i]);
    return x;
}

void expect_within(const char* name, double bound_ulp, ArrayMath::Unary function, const std::vector<float>& x,
                   const std::function<double(double)>& truth) {
    std::vector<float> result(x.size());
    function(x.data(), result.data(), x.size());
    double worst = 0.0;
    float worst_x = 0.0F;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double exact = truth(static_cast<double>(x[i]));
        const double error = std::fabs(static_cast<double>(result[i]) - exact) / ulp(exact);
        if (!(error <= worst)) {
            worst = error;
            worst_x = x[i];
        }
    }
    EXPECT_LE(worst, bound_ulp) << name << " at " << worst_x;
    testing::Test::RecordProperty(std::string(name) + "_ulp", std::to_string(worst));
}

constexpr std::size_t many = 400'001;

TEST_P(PackMath, ArcFunctions) {
    const auto unit = with_negatives(by_exponent(1e-20F, 1.0F, many));
    expect_within("asin", 3.0, math.asin, unit, [](double x) { return std::asin(x); });
    expect_within("acos", 3.0, math.acos, unit, [](double x) { return std::acos(x); });
    expect_within("acos", 3.0, math.acos, evenly(0.99, 1.0, many), [](double x) { return std::acos(x); });
    expect_within("atan", 3.0, math.atan, with_negatives(by_exponent(1e-30F, 1e30F, many)),
                  [](double x) { return std::atan(x); });
    expect_within("atan_excess", 6.0, math.atan_excess, by_exponent(1e-8F, 1.0F, many), [](double x) {
        if (x > 0.01) return std::atan(x) - x;
        const double t = x * x;
        return -x * t * (1.0 / 3.0 - t * (1.0 / 5.0 - t * (1.0 / 7.0 - t * (1.0 / 9.0))));
    });
}

// The purpose of these functions: no digit is lost where √t, its arctangent and their quotient are close to 1.
TEST_P(PackMath, RatiosOfArcFunctions) {
    const auto series = [](long double t, long double sign) { // of (atan or atanh of √t)/√t − 1, t ≤ 1e-3
        long double sum = 0.0L;
        for (int k = 9; k >= 1; --k)
            sum = sign * t * (1.0L / (2 * k + 1) + sum);
        return sum;
    };
    expect_within("atan_ratio_excess", 4.0, math.atan_ratio_excess, by_exponent(1e-35F, 1.0F, many), [&](double t) {
        const long double root = std::sqrt(static_cast<long double>(t));
        return static_cast<double>(t < 1e-3 ? series(t, -1.0L) : std::atan(root) / root - 1.0L);
    });
    expect_within("atanh_ratio", 2.0, math.atanh_ratio, by_exponent(1e-38F, 0.25F, many), [&](double t) {
        const long double root = std::sqrt(static_cast<long double>(t));
        return static_cast<double>(t < 1e-3 ? 1.0L + series(t, 1.0L) : std::atanh(root) / root);
    });
    const std::vector<float> ends{0.0F, 1e-45F, 1e-38F};
    std::vector<float> result(ends.size());
    math.atan_ratio_excess(ends.data(), result.data(), ends.size());
    EXPECT_EQ(result[0], 0.0F);
    for (const float each : result)
        EXPECT_NEAR(each, 0.0F, 1e-38F);
    math.atanh_ratio(ends.data(), result.data(), ends.size());
    for (const float each : result)
        EXPECT_EQ(each, 1.0F);
}

TEST_P(PackMath, Atan2Above) {
    const auto magnitudes = by_exponent(1e-30F, 1e30F, 601);
    std::vector<float> y;
    std::vector<float> x;
    for (const float a : magnitudes)
        for (const float b : with_negatives(magnitudes)) {
            y.push_back(a);
            x.push_back(b);
        }
    std::vector<float> result(x.size());
    math.atan2_above(y.data(), x.data(), result.data(), x.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const long double exact = std::atan2(static_cast<long double>(y[i]), static_cast<long double>(x[i]));
        ASSERT_GE(result[i], 0.0F);
        // A denormal quotient has an additional error.
        worst = std::fmax(worst, static_cast<double>(std::fabs(static_cast<long double>(result[i]) - exact)) /
                                     std::fmax(ulp(static_cast<double>(exact)), 1e-44));
    }
    EXPECT_LE(worst, 4.0);
    RecordProperty("atan2_above_ulp", std::to_string(worst));

    // −0, NaN and values that count as 0.
    const float nan = std::nanf("");
    const std::vector<float> odd_y{0.0F, -0.0F, -0.0F, 1e-40F, 0.0F, 3e38F, 0.0F, 1.0F, nan};
    const std::vector<float> odd_x{0.0F, 1.0F, -1.0F, 1e-40F, 1e38F, -3e38F, -0.0F, -0.0F, 1.0F};
    result.assign(odd_x.size(), -1.0F);
    math.atan2_above(odd_y.data(), odd_x.data(), result.data(), odd_y.size());
    const float pi = std::numbers::pi_v<float>;
    EXPECT_TRUE(std::isnan(result.back()));
    result.pop_back();
    for (const float each : result)
        EXPECT_TRUE(each >= 0.0F && each <= pi) << each;
    EXPECT_EQ(result[0], 0.0F);
    EXPECT_EQ(result[1], 0.0F);
    EXPECT_FLOAT_EQ(result[2], pi);
    EXPECT_FLOAT_EQ(result[5], 0.75F * pi);
    EXPECT_FLOAT_EQ(result[7], 0.5F * pi);
}

// b is widened, multiplied, subtracted and narrowed with a single rounding, where plain float loses all digits.
TEST_P(PackMath, DoublesOfAPackRoundOnce) {
    std::vector<float> a;
    std::vector<float> b;
    for (const float each : with_negatives(by_exponent(1e-20F, 1e20F, many / 4))) {
        a.push_back(1.0F + 0x1p-23F * static_cast<float>(a.size() % 5));
        b.push_back(each);
    }
    std::vector<float> result(a.size());
    math.wide_product_less(a.data(), b.data(), result.data(), a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        // Exact: the product of two floats is a double, and so is its difference from one of them.
        const double exact = static_cast<double>(a[i]) * static_cast<double>(b[i]) - static_cast<double>(b[i]);
        ASSERT_EQ(result[i], static_cast<float>(exact)) << a[i] << ' ' << b[i];
    }
}

TEST_P(PackMath, ChosenLanesStandSideBySide) {
    const std::size_t lanes = math.lanes;
    std::vector<float> a;
    std::vector<float> b;
    std::uint32_t state = 1;
    for (std::size_t packet = 0; packet < 4096; ++packet)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            state = state * 1664525U + 1013904223U;
            a.push_back(static_cast<float>(a.size() + 1));
            // Every selection of eight lanes, then random ones.
            const bool chosen = packet < 256 && lanes <= 8 ? (packet >> lane & 1U) != 0 : (state >> 30) != 0;
            b.push_back(chosen ? 0.0F : 1e9F);
        }
    std::vector<float> result(a.size());
    math.choose_greater(a.data(), b.data(), result.data(), a.size());
    for (std::size_t first = 0; first < a.size(); first += lanes) {
        std::vector<float> wanted;
        for (std::size_t lane = 0; lane < lanes; ++lane)
            if (a[first + lane] > b[first + lane]) wanted.push_back(a[first + lane]);
        wanted.resize(lanes, 0.0F);
        ASSERT_EQ(std::vector<float>(result.begin() + static_cast<std::ptrdiff_t>(first),
                                     result.begin() + static_cast<std::ptrdiff_t>(first + lanes)),
                  wanted)
            << first;
    }
}

TEST_P(PackMath, ArcFunctionsOutsideTheirDomain) {
    const std::vector<float> x{1.5F, -1.5F, 1e30F, -1e30F};
    std::vector<float> result(x.size());
    math.asin(x.data(), result.data(), x.size());
    EXPECT_FLOAT_EQ(result[0], static_cast<float>(std::numbers::pi / 2));
    EXPECT_FLOAT_EQ(result[3], static_cast<float>(-std::numbers::pi / 2));
    math.acos(x.data(), result.data(), x.size());
    EXPECT_EQ(result[0], 0.0F);
    EXPECT_FLOAT_EQ(result[3], std::numbers::pi_v<float>);
}

TEST_P(PackMath, Atan2) {
    const auto magnitudes = with_negatives(by_exponent(1e-15F, 1e15F, 601));
    std::vector<float> y;
    std::vector<float> x;
    for (const float a : magnitudes)
        for (const float b : magnitudes) {
            y.push_back(a);
            x.push_back(b);
        }
    std::vector<float> result(x.size());
    math.atan2(y.data(), x.data(), result.data(), x.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double exact = std::atan2(static_cast<double>(y[i]), static_cast<double>(x[i]));
        worst = std::fmax(worst, std::fabs(static_cast<double>(result[i]) - exact) / ulp(exact));
    }
    EXPECT_LE(worst, 4.0);
    RecordProperty("atan2_ulp", std::to_string(worst));

    const std::vector<float> zero_y{0.0F, 0.0F, 0.0F, 1.0F, -1.0F, 0.0F};
    const std::vector<float> zero_x{0.0F, 1.0F, -1.0F, 0.0F, 0.0F, -0.0F};
    math.atan2(zero_y.data(), zero_x.data(), result.data(), zero_y.size());
    EXPECT_EQ(result[0], 0.0F);
    EXPECT_EQ(result[1], 0.0F);
    EXPECT_FLOAT_EQ(result[2], std::numbers::pi_v<float>);
    EXPECT_FLOAT_EQ(result[3], std::numbers::pi_v<float> / 2);
    EXPECT_FLOAT_EQ(result[4], -std::numbers::pi_v<float> / 2);
    EXPECT_EQ(result[5], 0.0F) << "a zero x counts as positive";
}

TEST_P(PackMath, SineAndCosine) {
    const auto small = with_negatives(by_exponent(1e-20F, 0.785398F, many));
    expect_within("sin", 3.0, math.sin, small, [](double x) { return std::sin(x); });
    expect_within("cos", 2.0, math.cos, small, [](double x) { return std::cos(x); });
    const auto wide = evenly(-8192.0, 8192.0, many);
    std::vector<float> sine(wide.size());
    std::vector<float> cosine(wide.size());
    math.sin(wide.data(), sine.data(), wide.size());
    math.cos(wide.data(), cosine.data(), wide.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < wide.size(); ++i) {
        const double x = static_cast<double>(wide[i]);
        worst = std::fmax(worst, std::fabs(static_cast<double>(sine[i]) - std::sin(x)));
        worst = std::fmax(worst, std::fabs(static_cast<double>(cosine[i]) - std::cos(x)));
    }
    EXPECT_LE(worst, 1.2e-7);
    RecordProperty("sin_cos_absolute", std::to_string(worst * 1e7) + "e-7");
}

TEST_P(PackMath, PowersAndLogarithms) {
    expect_within("exp2", 2.0, math.exp2, evenly(-126.0, 127.999, many), [](double x) { return std::exp2(x); });
    expect_within("exp2", 2.0, math.exp2, with_negatives(by_exponent(1e-10F, 1.0F, many)),
                  [](double x) { return std::exp2(x); });
    expect_within("log2", 3.0, math.log2, by_exponent(1e-45F, 3.4e38F, many), [](double x) { return std::log2(x); });
    expect_within("log2", 3.0, math.log2, evenly(0.9, 1.1, many), [](double x) { return std::log2(x); });

    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> x{-200.0F, 128.0F, 1000.0F, std::nanf(""), -150.0F, -140.0F};
    std::vector<float> result(x.size());
    math.exp2(x.data(), result.data(), x.size());
    EXPECT_EQ(result[0], 0.0F);
    EXPECT_EQ(result[1], infinity);
    EXPECT_EQ(result[2], infinity);
    EXPECT_TRUE(std::isnan(result[3]));
    EXPECT_EQ(result[5], std::exp2(-140.0F)) << "denormal results are not flushed";
    const std::vector<float> y{0.0F, -1.0F, 1.0F, std::nanf("")};
    math.log2(y.data(), result.data(), y.size());
    EXPECT_EQ(result[0], -infinity);
    EXPECT_TRUE(std::isnan(result[1]));
    EXPECT_EQ(result[2], 0.0F);
    EXPECT_TRUE(std::isnan(result[3]));
}

TEST_P(PackMath, Pow) {
    std::vector<float> x;
    std::vector<float> y;
    for (const float base : by_exponent(1e-12F, 1e12F, 801))
        for (const float exponent : evenly(-6.0, 6.0, 401)) {
            const double log = std::log2(static_cast<double>(base)) * static_cast<double>(exponent);
            if (log < -126.0 || log > 127.9) continue;
            x.push_back(base);
            y.push_back(exponent);
        }
    std::vector<float> result(x.size());
    math.pow(x.data(), y.data(), result.data(), x.size());
    double worst = 0.0; // as a share of the bound
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double base = static_cast<double>(x[i]);
        const double exponent = static_cast<double>(y[i]);
        const double exact = std::pow(base, exponent);
        const double bound = 4.0 + 3.0 * std::fabs(exponent * std::log2(base));
        worst = std::fmax(worst, std::fabs(static_cast<double>(result[i]) - exact) / ulp(exact) / bound);
    }
    EXPECT_LE(worst, 1.0);
    RecordProperty("pow_share_of_bound", std::to_string(worst));

    const std::vector<float> base{0.0F, 0.0F, 5.0F, -2.0F};
    const std::vector<float> exponent{2.0F, 0.0F, 0.0F, 0.5F};
    math.pow(base.data(), exponent.data(), result.data(), base.size());
    EXPECT_EQ(result[0], 0.0F);
    EXPECT_EQ(result[1], 1.0F);
    EXPECT_EQ(result[2], 1.0F);
    EXPECT_TRUE(std::isnan(result[3]));
}

TEST_P(PackMath, MinimumAndMaximumHandTheSecondOnNan) {
    const float nan = std::nanf("");
    const std::vector<float> a{1.0F, 2.0F, nan, 3.0F, -0.0F};
    const std::vector<float> b{2.0F, 1.0F, 7.0F, nan, 5.0F};
    std::vector<float> low(a.size());
    std::vector<float> high(a.size());
    math.min(a.data(), b.data(), low.data(), a.size());
    math.max(a.data(), b.data(), high.data(), a.size());
    EXPECT_EQ(low[0], 1.0F);
    EXPECT_EQ(high[0], 2.0F);
    EXPECT_EQ(low[1], 1.0F);
    EXPECT_EQ(high[1], 2.0F);
    EXPECT_EQ(low[2], 7.0F);
    EXPECT_EQ(high[2], 7.0F);
    EXPECT_TRUE(std::isnan(low[3]));
    EXPECT_TRUE(std::isnan(high[3]));
}

TEST_P(PackMath, SquareRootIsCorrectlyRounded) {
    const auto x = by_exponent(1e-44F, 3.4e38F, many);
    std::vector<float> result(x.size());
    math.sqrt(x.data(), result.data(), x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        ASSERT_EQ(result[i], static_cast<float>(std::sqrt(static_cast<double>(x[i])))) << x[i];
}

TEST_P(PackMath, ReciprocalPowerOfTwo) {
    const auto x = by_exponent(1.2e-38F, 3.4e38F, many);
    std::vector<float> result(x.size());
    math.reciprocal_power_of_two(x.data(), result.data(), x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        int exponent = 0;
        ASSERT_EQ(std::frexp(result[i], &exponent), 0.5F) << x[i];
        const float scaled = x[i] * result[i];
        ASSERT_GE(scaled, 1.0F) << x[i];
        ASSERT_LT(scaled, x[i] < 0x1p127F ? 2.0F : 4.0F) << x[i];
    }
    const std::vector<float> tiny{0.0F, 1e-45F};
    math.reciprocal_power_of_two(tiny.data(), result.data(), tiny.size());
    EXPECT_EQ(result[0], 0x1p127F);
    EXPECT_EQ(result[1], 0x1p127F);
}

TEST_P(PackMath, DifferenceOfSquaresDoesNotCancel) {
    std::vector<float> x;
    std::vector<float> r;
    for (const float each : evenly(0.1, 3.0, 100'001)) {
        x.push_back(each);
        // The float nearest to the root: the remaining difference is only the rounding of r.
        r.push_back(static_cast<float>(std::sqrt(static_cast<double>(each) * static_cast<double>(each) + 0.3125)));
    }
    std::vector<float> result(x.size());
    math.difference_of_squares(x.data(), r.data(), result.data(), x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const long double a = x[i];
        const long double b = r[i];
        const auto exact = static_cast<double>(a * a + 0.3125L - b * b);
        ASSERT_NEAR(static_cast<double>(result[i]), exact,
                    std::fabs(exact) * 1.2e-7 + 0x1p-52 * static_cast<double>(b * b))
            << x[i];
    }
}

// A tail of any length gives what the full packs give, and writes nothing beyond it.
TEST_P(PackMath, TailsOfEveryLength) {
    const auto x = evenly(-1.0, 1.0, 40);
    std::vector<float> whole(x.size());
    math.asin(x.data(), whole.data(), x.size());
    for (std::size_t count = 0; count <= 33; ++count) {
        std::vector<float> result(x.size(), 99.0F);
        math.asin(x.data(), result.data(), count);
        for (std::size_t i = 0; i < count; ++i)
            EXPECT_EQ(result[i], whole[i]) << count;
        for (std::size_t i = count; i < result.size(); ++i)
            EXPECT_EQ(result[i], 99.0F) << count;
    }
}

TEST(DoubleMath, DifferenceOfSquaresIsExactToTheLastDigits) {
    // d² − r² with d = r(1 + 2⁻⁵⁰): in plain double the result is lost.
    const double r = 1.2345678901234567;
    const double d = r * (1.0 + 0x1p-50);
    const long double exact = (static_cast<long double>(d) - r) * (static_cast<long double>(d) + r);
    EXPECT_NEAR(gonio::simd::difference_of_squares(d, 0.0, 0.0, r), static_cast<double>(exact),
                1e-15 * static_cast<double>(exact));
}

TEST(DoubleMath, AtanExcessKeepsItsDigits) {
    for (const double x : {1e-8, 1e-4, 0.01, 0.2, 0.249999, 0.250001, 0.5, 1.0}) {
        const long double l = x;
        long double exact = std::atan(l) - l;
        if (x < 0.02)
            exact = -l * l * l * (1 / 3.0L - l * l * (1 / 5.0L - l * l * (1 / 7.0L - l * l * (1 / 9.0L - l * l / 11))));
        EXPECT_NEAR(gonio::simd::atan_excess(x), static_cast<double>(exact),
                    1e-13 * std::fabs(static_cast<double>(exact)));
    }
}

#if defined(FE_UNDERFLOW) // WebAssembly has no flags

// A product below the smallest normal number takes a hundred cycles on some processors; without FMA each product inside
// is a separate number.
TEST(FloatMath, ArcsOfSmallAnglesStayAmongTheNormalNumbers) {
    for (float x = 1.0F; x > 1e-12F; x *= 0.93F) {
        volatile const float y = x;
        std::feclearexcept(FE_ALL_EXCEPT);
        volatile const float angle = gonio::simd::atan2_above(y, 1.0F);
        EXPECT_FALSE(std::fetestexcept(FE_UNDERFLOW)) << x;
        EXPECT_NEAR(angle, std::atan(x), 3e-7F * x);
    }
}

#endif

// The bound stated in simd/doubles_math.hpp; that sets give the same bits is tested with the kernels that use it.
TEST(DoublesMath, ArcSine) {
    for (int i = -4000; i <= 4000; ++i)
        for (const double x : {i / 4000.0, i / 4000.0 * 1e-9, std::copysign(1.0 - std::abs(i) * 1e-13, i)}) {
            const double truth = std::asin(x);
            const double unit = std::nextafter(std::abs(truth), 2.0) - std::abs(truth);
            EXPECT_NEAR(gonio::simd::arc_sine(x), truth, 2.0 * unit) << x;
        }
    EXPECT_EQ(gonio::simd::arc_sine(0.0), 0.0);
    EXPECT_EQ(gonio::simd::arc_sine(1.0), 0.5 * std::numbers::pi);
}

} // namespace
