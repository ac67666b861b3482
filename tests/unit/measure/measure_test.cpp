#include <gonio/measure/error_statistics.hpp>
#include <gonio/measure/sphere_cases.hpp>
#include <gonio/measure/sphere_methods.hpp>
#include <gonio/measure/sphere_truth.hpp>
#include <gonio/measure/timing.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

namespace {

using namespace gonio::measure;

TEST(ErrorStatistics, NearestRank) {
    std::vector<double> errors;
    for (int i = 100; i >= 1; --i)
        errors.push_back(i);
    const Spread spread = spread_of(errors);
    EXPECT_EQ(spread.median, 50.0);
    EXPECT_EQ(spread.p95, 95.0);
    EXPECT_EQ(spread.max, 100.0);
    EXPECT_EQ(spread.count, 100U);
    EXPECT_EQ(spread_of(std::vector<double>{3.0}).p95, 3.0);
    EXPECT_EQ(spread_of({}).count, 0U);
    errors.push_back(std::nan(""));
    EXPECT_EQ(spread_of(errors).max, std::numeric_limits<double>::infinity());
}

TEST(ErrorStatistics, RelativeErrorsNeedATruthAboveTheFloor) {
    const ErrorStatistics statistics =
        compare(std::vector<double>{1.1, 0.5, 3.0}, std::vector<double>{1.0, 0.0, 2.0}, 1e-3);
    EXPECT_EQ(statistics.absolute.count, 3U);
    EXPECT_EQ(statistics.relative.count, 2U);
    EXPECT_NEAR(statistics.absolute.max, 1.0, 1e-15);
    EXPECT_NEAR(statistics.relative.max, 0.5, 1e-15);
}

// A clock that the work itself moves: what is reported is then known.
TEST(Timing, ReportsWhatTheClockSays) {
    double now = 0.0;
    const Clock clock = [&] { return now += 1e-9; };
    const auto timing = time_work([&] { now += 3e-6; }, 100, {5, 0.001, 1U << 20U}, clock);
    ASSERT_TRUE(timing.has_value());
    EXPECT_NEAR(timing->ns_per_item, 30.0, 0.01);
    EXPECT_EQ(timing->samples, 5U);
    EXPECT_GE(timing->calls_per_sample, 300U);
}

TEST(Timing, RefusesWhatTheClockCannotResolve) {
    double now = 0.0;
    int asked = 0;
    const Clock coarse = [&] { return ++asked % 8 == 0 ? now += 1.0 : now; };
    const auto timing = time_work([] {}, 1, {3, 1e-3, 64}, coarse);
    ASSERT_FALSE(timing.has_value());
    EXPECT_EQ(timing.error().failure, gonio::Failure::unsupported);
    EXPECT_FALSE(time_work([] {}, 1, {}, [] { return 5.0; }).has_value()) << "a clock that stands still";
    const auto none = time_work([] {}, 0);
    ASSERT_FALSE(none.has_value());
    EXPECT_EQ(none.error().failure, gonio::Failure::usage);
}

TEST(SphereTruth, KnownValues) {
    const double up[3] = {0, 0, 1};
    const double frontal[3] = {0, 0, 4};
    EXPECT_NEAR(sphere_irradiance_by_quadrature(frontal, 1.0, up), std::numbers::pi / 16.0, 1e-16);
    const double side[3] = {4, 0, 0};
    const double sigma = std::asin(0.25);
    EXPECT_NEAR(sphere_irradiance_by_quadrature(side, 1.0, up), sigma - std::sin(sigma) * std::cos(sigma), 1e-16);
    const double below[3] = {0.5, 0, -4};
    EXPECT_EQ(sphere_irradiance_by_quadrature(below, 1.0, up), 0.0);
    const double doubled[3] = {0, 0, 2};
    EXPECT_EQ(sphere_irradiance_by_quadrature(side, 1.0, doubled), sphere_irradiance_by_quadrature(side, 1.0, up));
}

TEST(SphereCases, AreInTheirStrataAndTheSameEachTime) {
    const SphereCases cases = sphere_cases(5000, 7);
    ASSERT_EQ(cases.size(), 5000U);
    std::set<Stratum> seen;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        double d2 = 0.0;
        double n2 = 0.0;
        double cosine = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double p = static_cast<double>(cases.position[k][i]);
            const double n = static_cast<double>(cases.normal[k][i]);
            d2 += p * p;
            n2 += n * n;
            cosine -= p * n;
        }
        const double d = std::sqrt(d2);
        cosine /= d;
        ASSERT_NEAR(n2, 1.0, 3e-7);
        ASSERT_GT(d, 1.0);
        seen.insert(cases.stratum[i]);
        switch (cases.stratum[i]) {
        case Stratum::above:
            EXPECT_GE(cosine, 1.0 / d - 1e-6);
            break;
        case Stratum::straddling:
            EXPECT_LE(std::fabs(cosine), 1.0 / d + 1e-6);
            break;
        case Stratum::below:
            EXPECT_LE(cosine, -1.0 / d + 1e-6);
            break;
        case Stratum::near:
            EXPECT_LE(d, 1.11);
            break;
        case Stratum::far:
            EXPECT_GE(d, 29.9);
            break;
        }
    }
    EXPECT_EQ(seen.size(), stratum_count);
    EXPECT_EQ(cases.position, sphere_cases(5000, 7).position);
    EXPECT_NE(cases.position, sphere_cases(5000, 8).position);
}

// The harness on its first subject: what is known of the three methods must come out of it.
TEST(SphereMethods, ExactFrostbiteAndPoint) {
    ComparisonOptions options;
    options.cases = 2000;
    options.timing.samples = 3;
    options.timing.sample_seconds = 1e-3;
    const auto result = compare_sphere_methods(options);
    ASSERT_TRUE(result.has_value());
    int exact_methods = 0;
    for (const MethodMeasurement& m : *result) {
        SCOPED_TRACE(m.name + " " + m.precision);
        EXPECT_GT(m.timing.ns_per_item, 0.0);
        EXPECT_EQ(m.error.absolute.count, options.cases);
        const auto straddling = m.error_by_stratum[static_cast<std::size_t>(Stratum::straddling)];
        const auto above = m.error_by_stratum[static_cast<std::size_t>(Stratum::above)];
        EXPECT_LE(above.relative.median, 1e-6) << "all three are exact above the horizon";
        if (m.name == "exact") {
            ++exact_methods;
            EXPECT_LE(m.error.absolute.max, 1e-5);
            EXPECT_LE(straddling.relative.p95, 1e-4);
        } else if (m.name == "point") {
            EXPECT_GE(straddling.relative.median, 0.1) << "a point knows no horizon";
        }
    }
    EXPECT_GE(exact_methods, 3) << "double, float and at least one instruction set";
}

} // namespace
