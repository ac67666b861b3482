#include <gonio/measure/contest.hpp>
#include <gonio/measure/error_statistics.hpp>
#include <gonio/measure/pareto.hpp>
#include <gonio/measure/picture_error.hpp>
#include <gonio/measure/scaling.hpp>
#include <gonio/measure/sphere_cases.hpp>
#include <gonio/measure/sphere_methods.hpp>
#include <gonio/measure/sphere_truth.hpp>
#include <gonio/measure/suite.hpp>
#include <gonio/measure/timing.hpp>
#include <gonio/measure/verdict.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
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

TEST(PictureError, IsThatOfThePixelsThatCount) {
    gonio::Image truth(4, 2, 1);
    truth.pixels = {1.0F, 2.0F, 4.0F, 8.0F, 0.0F, 0.0004F, 10.0F, 5.0F};
    gonio::Image values = truth;
    values.pixels = {1.5F, 2.0F, 3.0F, 8.0F, 1.0F, 0.0F, 10.0F, 500.0F};
    const std::vector<std::uint8_t> lamp{0, 0, 0, 0, 0, 0, 0, 1};
    const PictureError error = picture_error(values, truth, lamp);
    EXPECT_EQ(error.pixels, 7U);
    EXPECT_DOUBLE_EQ(error.greatest, 10.0);
    EXPECT_NEAR(error.mean, 25.0004 / 7.0, 1e-8);
    EXPECT_NEAR(error.bias, (0.5 - 1.0 + 1.0 - 0.0004) / 7.0, 1e-8);
    EXPECT_NEAR(error.mean_absolute, (0.5 + 1.0 + 1.0 + 0.0004) / 7.0, 1e-8);
    EXPECT_NEAR(error.rms, std::sqrt((0.25 + 1.0 + 1.0) / 7.0), 1e-7);
    EXPECT_NEAR(error.psnr_db.value(), 20.0 * std::log10(10.0 / error.rms), 1e-12);
    // 0 and 0.0004 are below 1e-4 of the largest value.
    EXPECT_EQ(error.of_pixels.relative.count, 5U);
    EXPECT_DOUBLE_EQ(error.of_pixels.relative.max, 0.5);
    EXPECT_DOUBLE_EQ(error.mean_relative, (0.5 + 0.25) / 5.0);
    EXPECT_EQ(error.worst.column, 2);
    EXPECT_EQ(error.worst.row, 0);
    EXPECT_DOUBLE_EQ(error.worst.value, 3.0);

    const PictureError none = picture_error(truth, truth);
    EXPECT_FALSE(none.psnr_db.has_value());
    EXPECT_EQ(none.rms, 0.0);
    EXPECT_EQ(none.pixels, 8U);
    EXPECT_EQ(picture_error(values, truth, std::vector<std::uint8_t>(8, 1)).pixels, 0U);
}

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

// The known properties of the three methods must come out.
TEST(SphereMethods, ExactFrostbiteAndPoint) {
    const SphereCases above = sphere_cases_of(Stratum::above, 400, 1);
    const SphereCases straddling = sphere_cases_of(Stratum::straddling, 400, 1);
    const std::vector<double> above_truth = sphere_truth(above);
    const std::vector<double> straddling_truth = sphere_truth(straddling);
    int exact_methods = 0;
    for (const SphereMethod& m : sphere_methods()) {
        SCOPED_TRACE(m.name + " " + m.precision);
        const ErrorStatistics seen = compare(evaluated(m, above), above_truth, 1e-6);
        const ErrorStatistics cut = compare(evaluated(m, straddling), straddling_truth, 1e-6);
        EXPECT_EQ(seen.absolute.count, 400U);
        EXPECT_LE(seen.relative.median, 1e-6) << "all three are exact above the horizon";
        if (m.name == "exact") {
            ++exact_methods;
            EXPECT_LE(cut.absolute.max, 1e-5);
            // In double too: the length of a float normal, which only the quadrature takes as it is.
            EXPECT_LE(cut.relative.p95, m.precision == "double" ? 1e-6 : 1e-4);
        } else if (m.name == "point") {
            EXPECT_GE(cut.relative.median, 0.1) << "a point knows no horizon";
        }
    }
    EXPECT_GE(exact_methods, 3) << "double, float and at least one instruction set";
}

// Two works on a clock that they move themselves; the machine is ten times slower in one round of three.
TEST(Timing, RatiosHoldOnAMachineThatIsNowFastNowSlow) {
    double now = 0.0;
    int asked = 0;
    const Clock clock = [&] {
        ++asked;
        return now += 1e-9;
    };
    const auto slow = [&] { return asked / 600 % 3 == 1 ? 10.0 : 1.0; };
    const TimedWork works[] = {{[&] { now += 2e-3 * slow(); }, 10}, {[&] { now += 6e-3 * slow(); }, 10}};
    const auto timings = time_in_turn(works, 0, {31, 0.001, 1U << 20U}, clock);
    ASSERT_TRUE(timings.has_value());
    ASSERT_TRUE((*timings)[0] && (*timings)[1]);
    EXPECT_EQ((*timings)[0]->ratio, 1.0);
    EXPECT_NEAR((*timings)[1]->ratio, 3.0, 1e-3);
    EXPECT_NEAR((*timings)[1]->timing.lowest_ns, 6e5, 1.0);
}

// One of the works takes no time: only that one has no result.
TEST(Timing, OnlyWhatTheClockCannotResolveIsLeftOut) {
    double now = 0.0;
    const auto step = [&] { now += 1e-3; };
    int asked = 0;
    const Clock coarse = [&] { return ++asked % 4 == 0 ? now += 1e-6 : now; };
    const TimedWork works[] = {{step, 1}, {[] {}, 1}};
    const auto timings = time_in_turn(works, 0, {3, 1e-3, 4}, coarse);
    ASSERT_TRUE(timings.has_value());
    EXPECT_TRUE((*timings)[0].has_value());
    EXPECT_FALSE((*timings)[1].has_value());
    const auto without_baseline = time_in_turn(works, 1, {3, 1e-3, 4}, coarse);
    ASSERT_TRUE(without_baseline.has_value());
    EXPECT_FALSE((*without_baseline)[0].has_value()) << "a ratio to nothing";
}

TEST(Timing, IsStopped) {
    double now = 0.0;
    int called = 0;
    const TimedWork work{[&] {
                             ++called;
                             now += 1.0;
                         },
                         1};
    const auto timings = time_in_turn(
        {&work, 1}, 0, {1000, 0.5, 64}, [&] { return now += 1e-9; }, [&] { return called >= 5; });
    ASSERT_FALSE(timings.has_value());
    EXPECT_EQ(called, 5);
}

TEST(ParetoFront, HasNoPointThatAnotherBeats) {
    const double nan = std::nan("");
    const double infinite = std::numeric_limits<double>::infinity();
    const ErrorAndTime points[] = {{0.1, 10.0}, {0.2, 5.0},      {0.2, 6.0}, {0.1, 10.0},
                                   {nan, 1.0},  {infinite, 1.0}, {1.0, nan}, {0.0, infinite}};
    EXPECT_EQ(pareto_front(points), (std::vector<bool>{true, true, false, true, false, false, false, false}));
    EXPECT_TRUE(pareto_front({}).empty());
}

// A comparison on a clock of its own, so that errors, times, ratios and front are known.
Contest made_up_contest(double& now) {
    const auto takes = [&now](double ms) { return TimedWork{[&now, ms] { now += 1e-3 * ms; }, 1}; };
    const auto off = [](double error) { return [error] { return std::vector<double>{error, error, error}; }; };
    return {{"suite", "cases", "all", "relative", "item", "truth"},
            1,
            {{"exact", "double", takes(4), off(0.0)},
             {"exact", "float", takes(2), off(1e-6)},
             {"rough", "float", takes(1), off(0.5)},
             {"bad", "float", takes(3), off(std::nan(""))}}};
}

TEST(Contest, ErrorsTimesRatiosAndFront) {
    double now = 0.0;
    const auto standings = hold(made_up_contest(now), {5, 1e-3, 64}, [&] { return now += 1e-12; });
    ASSERT_TRUE(standings.has_value());
    ASSERT_EQ(standings->rows.size(), 4U);
    const bool front[] = {true, true, true, false};
    const double ratios[] = {2.0, 1.0, 0.5, 1.5};
    const double errors[] = {0.0, 1e-6, 0.5, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(standings->rows[i].on_front, front[i]) << i;
        EXPECT_EQ(standings->rows[i].error.median, errors[i]) << i;
        ASSERT_TRUE(standings->rows[i].time.has_value());
        EXPECT_NEAR(standings->rows[i].time->ratio, ratios[i], 1e-6) << i;
    }
}

TEST(Verdict, OfTheMethodThatIsUsedUnasked) {
    const auto row = [](const char* method, const char* code, double error, double ns, bool on_front) {
        RelativeTiming time{};
        time.timing.lowest_ns = ns;
        return Standing{method, code, {error, 2.0 * error, 3.0 * error, 10}, time, on_front};
    };
    Standings standings;
    standings.rows = {row("exact", "double", 1e-9, 40.0, true),    row("exact", "float", 1e-7, 20.0, true),
                      row("rough", "float", 1e-2, 30.0, false),    row("rough", "pack", 1e-1, 5.0, true),
                      row("long", "double", 1e-12, 80.0, true),    row("late", "float", 1e-2, 19.8, true),
                      row("none", "float", std::nan(""), 1, false)};
    EXPECT_FALSE(verdict_of(standings)) << "no standard";
    standings.title.standard = "missing";
    EXPECT_FALSE(verdict_of(standings));
    standings.title.standard = "exact";
    const auto verdict = verdict_of(standings);
    ASSERT_TRUE(verdict);
    EXPECT_TRUE(verdict->on_front);
    ASSERT_EQ(verdict->rivals.size(), 3U);
    EXPECT_EQ(verdict->rivals[0].standing, Rival::Standing::cheaper);
    EXPECT_EQ(verdict->rivals[0].times_as_fast, 4.0);
    EXPECT_EQ(verdict->rivals[0].error_median, 1e-1);
    EXPECT_EQ(verdict->rivals[0].error_p95, 2e-1);
    EXPECT_EQ(verdict->rivals[1].standing, Rival::Standing::closer);
    EXPECT_EQ(verdict->rivals[1].error_median, 1e-12);
    EXPECT_EQ(verdict->rivals[2].standing, Rival::Standing::dominated) << "a clock does not tell 1 %";
}

TEST(Contest, KeepsTheNamedMethodsAndTheBaseline) {
    double now = 0.0;
    Contest contest = made_up_contest(now);
    keep_only(contest, {"rough"});
    ASSERT_EQ(contest.contestants.size(), 2U);
    EXPECT_EQ(contest.contestants[contest.baseline].code, "float");
    EXPECT_EQ(contest.contestants[contest.baseline].method, "exact");
    EXPECT_EQ(contest.contestants[1].method, "rough");
}

TEST(Scalings, NamesAreFoundAndOthersRefused) {
    const auto all = parse_scalings("threads,all");
    ASSERT_TRUE(all.has_value());
    EXPECT_EQ(all->size(), scalings().size());
    EXPECT_FALSE(parse_scalings("pixel").has_value());
    EXPECT_FALSE(parse_scalings("").has_value());
}

// Sizes ascend, and a stopped run keeps the points it has.
TEST(Scalings, CurvesAscendAndCanBeStopped) {
    const auto found = parse_scalings("file-size");
    ASSERT_TRUE(found.has_value());
    ScalingOptions options;
    options.quick = true;
    int asked = 0;
    options.stop = [&] { return ++asked > 20; };
    const auto curves = found->front()->measure(options);
    ASSERT_TRUE(curves.has_value());
    ASSERT_FALSE(curves->empty());
    const auto& points = curves->front().points;
    ASSERT_GE(points.size(), 2U);
    for (std::size_t i = 1; i < points.size(); ++i)
        EXPECT_GT(points[i].size, points[i - 1].size);
    EXPECT_LT(curves->size(), 3U) << "stopped before the last curve";
}

TEST(Suites, NamesAreFoundAndOthersRefused) {
    const auto all = parse_suites("all");
    ASSERT_TRUE(all.has_value());
    EXPECT_EQ(all->size(), suites().size());
    const auto two = parse_suites("colour,irradiance,colour");
    ASSERT_TRUE(two.has_value());
    EXPECT_EQ(two->size(), 2U);
    const auto none = parse_suites("irradiance,light");
    ASSERT_FALSE(none.has_value());
    EXPECT_NE(none.error().diagnostics.back().hint.find("specular"), std::string::npos);
    EXPECT_TRUE(parse_methods("exact,ue4", *two).has_value());
    EXPECT_FALSE(parse_methods("ltc", *two).has_value()) << "of another suite";
}

// Each comparison can be made and has a baseline and names that its suite knows; the default method is among the best.
// Without times.
TEST(Suites, EveryContestHasErrorsAndAKnownBaseline) {
    SuiteOptions options;
    options.quick = true;
    for (const Suite& suite : suites()) {
        const std::vector<std::string> names = suite.methods();
        for (const ContestMaker& maker : suite.contests(options)) {
            SCOPED_TRACE(std::string(suite.name) + " " + maker.cases + " " + maker.subset);
            if (suite.name == "specular") continue; // its quadrature takes long
            const auto contest = maker.make();
            ASSERT_TRUE(contest.has_value());
            EXPECT_EQ(contest->title.suite, suite.name);
            EXPECT_EQ(contest->title.cases, maker.cases);
            EXPECT_EQ(contest->title.subset, maker.subset);
            ASSERT_LT(contest->baseline, contest->contestants.size());
            for (const Contestant& c : contest->contestants) {
                EXPECT_NE(std::find(names.begin(), names.end(), c.method), names.end()) << c.method;
                EXPECT_GT(c.timed.items, 0U);
                if (maker.cases == "disk" || maker.cases == "kulla-conty") {
                    c.timed.work();
                    EXPECT_GT(c.errors().size(), 20U) << c.method << ' ' << c.code;
                }
            }
        }
    }
}

} // namespace
