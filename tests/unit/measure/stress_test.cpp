// Stress testing finds planted defects, reports the input, and does so alike with any number of threads.
#include <gonio/measure/stress.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace gonio::measure;

std::string hexadecimal(double x) {
    char text[64];
    (void)std::snprintf(text, sizeof text, "%a", x);
    return text;
}

// A logarithm that is NaN for one input in a thousand, and slightly wrong for others.
double planted(double x) {
    return x < 0.001 ? std::nan("") : std::log(x) * (1.0 + 1e-15 * x);
}

constexpr StressSubject with_a_fault{
    "planted", "1e-14", 1.0, [](Random& random, std::uint64_t count, StressTally& tally) {
        for (std::uint64_t i = 0; i < count; ++i) {
            const double x = random.uniform();
            tally.hold(std::fabs(planted(x) / std::log(x) - 1.0) / 1e-14, [&] { return hexadecimal(x); });
        }
    }};

TEST(Stress, FindsAPlantedNaNAndTheInputThatGivesIt) {
    StressOptions options;
    options.count = 100'000;
    const StressTally tally = stress(with_a_fault, 1.0, options);
    EXPECT_GE(tally.evaluations(), options.count);
    EXPECT_NEAR(static_cast<double>(tally.broken()), 100.0, 50.0);
    ASSERT_EQ(tally.findings().size(), 3U);
    for (const std::string& finding : tally.findings()) {
        const double input = std::strtod(finding.substr(finding.find("0x")).c_str(), nullptr);
        EXPECT_TRUE(std::isnan(planted(input))) << finding;
    }
    EXPECT_GT(tally.worst(), 0.0);
    EXPECT_LT(tally.worst(), 0.2) << "of what has a share";
    EXPECT_FALSE(std::isnan(planted(std::strtod(tally.worst_input().c_str(), nullptr))));
}

TEST(Stress, WhatIsBeyondTheBarIsBrokenEachTime) {
    StressTally tally;
    for (const double share : {0.5, 3.0, 2.0, 1.0})
        tally.hold(share, [&] { return std::to_string(share); });
    tally.require(false, [] { return std::string("negative"); });
    tally.require(true, [] { return std::string("fine"); });
    EXPECT_EQ(tally.evaluations(), 4U);
    EXPECT_EQ(tally.broken(), 3U);
    EXPECT_EQ(tally.worst(), 3.0);
    ASSERT_EQ(tally.findings().size(), 3U);
    EXPECT_EQ(tally.findings()[2], "negative");
}

TEST(Stress, ThreadsDoNotChangeWhatIsFound) {
    StressOptions options;
    options.count = 200'000;
    options.threads = 1;
    const StressTally one = stress(with_a_fault, 1.0, options);
    options.threads = 3;
    const StressTally three = stress(with_a_fault, 1.0, options);
    EXPECT_EQ(one.broken(), three.broken());
    EXPECT_EQ(one.worst_input(), three.worst_input());
    EXPECT_EQ(one.findings(), three.findings());
    options.seed = 2;
    EXPECT_NE(one.worst_input(), stress(with_a_fault, 1.0, options).worst_input());
}

TEST(Stress, IsStoppedBetweenBlocks) {
    StressOptions options;
    options.count = 1'000'000'000'000;
    options.threads = 1;
    int asked = 0;
    options.stop = [&] { return ++asked > 2; };
    EXPECT_LT(stress(with_a_fault, 1.0, options).evaluations(), 100'000U);
}

// Every subject evaluates something, and a short run of each finds no defect.
TEST(Stress, EverySubjectIsCleanOnAFewEvaluations) {
    StressOptions options;
    options.count = 20'000;
    options.threads = 1;
    options.seed = 11;
    for (const StressSubject& subject : stress_subjects()) {
        const StressTally tally = stress(subject, subject.weight / 20.0, options);
        EXPECT_GT(tally.evaluations(), 0U) << subject.name;
        EXPECT_EQ(tally.broken(), 0U) << subject.name << ": "
                                      << (tally.findings().empty() ? std::string() : tally.findings().front());
        EXPECT_LE(tally.worst(), 1.0) << subject.name;
    }
}

} // namespace
