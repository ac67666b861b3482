// Temperatures of chromaticities: known lights, round trips, and chromaticities without a temperature.
#include <gonio/color/cct.hpp>
#include <gonio/color/planckian.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace gonio {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Computed by Newton's method on the sum, in another program (numpy).
TEST(CctTest, KnownWhites) {
    struct Known {
        Xy xy;
        double kelvin, duv;
    };
    for (const Known& k : {Known{{0.31272, 0.32903}, 6502.93, 0.00321}, Known{{0.3127, 0.3290}, 6504.24, 0.00321},
                           Known{aces_white, 5999.97, 0.00324}, Known{{1.0 / 3, 1.0 / 3}, 5455.40, -0.00442},
                           Known{{0.314, 0.351}, 6302.7, 0.0134}}) {
        const Result<Cct> exact = exact_cct(to_uv(k.xy));
        ASSERT_TRUE(exact);
        EXPECT_NEAR(exact->temperature.value, k.kelvin, 0.1) << k.kelvin;
        EXPECT_NEAR(exact->duv, k.duv, 6e-5) << k.kelvin;
        const Cct fast = fast_cct(to_uv(k.xy));
        EXPECT_NEAR(fast.temperature.value, exact->temperature.value, 1e-6) << k.kelvin;
        EXPECT_NEAR(fast.duv, exact->duv, 1e-11) << k.kelvin;
    }
}

// Illuminant A is a black body by definition: 2848 K with the c2 of 1931, 1.4350e-2.
TEST(CctTest, IlluminantAIsABlackBody) {
    const double kelvin = 2848.0 * c2_meter_kelvin / 1.4350e-2;
    const Cct found = exact_cct(to_uv(Xy{0.447574, 0.407439})).value(); // as summed in another program, six digits
    EXPECT_NEAR(found.temperature.value, kelvin, 0.02);
    EXPECT_NEAR(found.duv, 0.0, 1e-6);
}

// Points off the locus of the sum, along its own normal: made without either method under test.
Uv off_the_sum(double kelvin, double duv) {
    const LocusPoint p = planckian_sum(1e3 / kelvin);
    const double length = std::hypot(p.first.u, p.first.v);
    return {p.at.u - duv * p.first.v / length, p.at.v + duv * p.first.u / length};
}

TEST(CctTest, InvertsAGridTo1e3OfAKelvin) {
    double worst_fast = 0.0, worst_exact = 0.0, worst_duv = 0.0;
    for (int i = 0; i <= 200; ++i) {
        const double kelvin = 1e6 / (25.0 + (1e6 / 1500.0 - 25.0) * i / 200); // 40000 K to 1500 K
        for (int j = -10; j <= 10; ++j) {
            const double duv = 0.005 * j;
            const Uv at = off_the_sum(kelvin, duv);
            const Cct fast = fast_cct(at);
            worst_fast = std::fmax(worst_fast, std::abs(fast.temperature.value - kelvin));
            worst_duv = std::fmax(worst_duv, std::abs(fast.duv - duv));
            ASSERT_FALSE(std::isnan(fast.duv)) << kelvin << ' ' << duv;
            if (i % 20 != 0) continue;
            const Result<Cct> exact = exact_cct(at);
            ASSERT_TRUE(exact) << kelvin << ' ' << duv;
            worst_exact = std::fmax(worst_exact, std::abs(exact->temperature.value - kelvin));
            worst_duv = std::fmax(worst_duv, std::abs(exact->duv - duv));
        }
    }
    EXPECT_LT(worst_fast, 1e-4); // required: 1e-3
    EXPECT_LT(worst_exact, 1e-6);
    EXPECT_LT(worst_duv, 1e-11);
}

TEST(CctTest, RoundTripsToItself) {
    for (const double kelvin : {800.0, 1000.0, 1850.0, 2700.0, 5191.0, 6500.0, 20000.0, 100000.0, 1e6})
        for (const double duv : {-0.05, -0.003, 0.0, 0.003}) {
            const Cct back = fast_cct(fast_uv({Kelvin(kelvin), duv}));
            EXPECT_NEAR(back.temperature.value / kelvin, 1.0, kelvin > 20000.0 ? 1e-9 : 5e-11) << kelvin << ' ' << duv;
            EXPECT_NEAR(back.duv, duv, 1e-13) << kelvin;
        }
    for (const double kelvin : {500.0, 650.0, 799.0, 2700.0, 1e6}) {
        const Result<Uv> at = exact_uv({Kelvin(kelvin), -0.001});
        ASSERT_TRUE(at);
        const Result<Cct> back = exact_cct(*at);
        ASSERT_TRUE(back) << kelvin << ' ' << back.error().diagnostics.back().message;
        EXPECT_NEAR(back->temperature.value / kelvin, 1.0, 1e-9);
        EXPECT_NEAR(back->duv, -0.001, 1e-13);
    }
}

TEST(CctTest, TheFitAndTheSumSayTheSame) {
    for (const double kelvin : {800.0, 2700.0, 6500.0, 40000.0})
        for (const double duv : {-0.04, -0.01, 0.0}) {
            const Uv exact = exact_uv({Kelvin(kelvin), duv}).value();
            EXPECT_LT(delta_uv_prime(exact, fast_uv({Kelvin(kelvin), duv})), 3e-11);
            EXPECT_LT(delta_uv_prime(exact, uv_of({Kelvin(kelvin), duv}).value()), 3e-11);
        }
    EXPECT_LT(delta_uv_prime(uv_of({Kelvin(600), 0.0}).value(), planckian_sum(1e3 / 600).at), 1e-15);
}

TEST(CctTest, RefusesWhatHasNoTemperature) {
    for (const Cct bad :
         {Cct{Kelvin(499.9), 0.0}, Cct{Kelvin(1.0001e6), 0.0}, Cct{Kelvin(-5), 0.0}, Cct{Kelvin(nan), 0.0},
          Cct{Kelvin(2700), 0.101}, Cct{Kelvin(2700), nan}, Cct{Kelvin(1000), 0.05}}) {
        const Result<Uv> uv = exact_uv(bad);
        ASSERT_FALSE(uv) << bad.temperature.value << ' ' << bad.duv;
        EXPECT_EQ(uv.error().failure, Failure::usage);
        EXPECT_FALSE(uv_of(bad));
    }
    for (const Cct bad : {Cct{Kelvin(799), 0.0}, Cct{Kelvin(nan), 0.0}, Cct{Kelvin(2700), 0.11}, Cct{Kelvin(-1), 0.0}})
        EXPECT_TRUE(std::isnan(fast_uv(bad).u));
    // Too far from the locus on either side, beyond both ends, and values that are not numbers.
    for (const Xy bad : {Xy{0.2, 0.7}, Xy{0.35, 0.1}, Xy{0.17, 0.01}, Xy{0.15, 0.15}}) {
        EXPECT_FALSE(exact_cct(to_uv(bad))) << bad.x;
        EXPECT_TRUE(std::isnan(fast_cct(to_uv(bad)).temperature.value)) << bad.x;
    }
    for (const Uv bad : {Uv{nan, 0.3}, Uv{0.2, std::numeric_limits<double>::infinity()}}) {
        EXPECT_FALSE(exact_cct(bad));
        EXPECT_TRUE(std::isnan(fast_cct(bad).temperature.value));
    }
    const Uv below = planckian_sum(1e3 / 700).at;
    EXPECT_TRUE(std::isnan(fast_cct(below).temperature.value));
    EXPECT_NEAR(exact_cct(below)->temperature.value, 700.0, 1e-6);
}

TEST(CctTest, DaylightIsTheCieFormula) {
    // CIE 015: D65 is 6500 K with the constant of its time; with today's constant 1.4388/1.4380 times as much.
    const Xy d65 = daylight_xy(Kelvin(6500.0 * 1.4388 / 1.4380));
    EXPECT_NEAR(d65.x, 0.31271, 2e-5);
    EXPECT_NEAR(d65.y, 0.32912, 2e-5);
    const Xy d50 = daylight_xy(Kelvin(5000.0 * 1.4388 / 1.4380));
    EXPECT_NEAR(d50.x, 0.34567, 5e-5);
    EXPECT_NEAR(d50.y, 0.35862, 5e-5);
    EXPECT_FALSE(exact_uv({Kelvin(3999), 0.0}, Locus::daylight));
    EXPECT_FALSE(exact_uv({Kelvin(25001), 0.0}, Locus::daylight));
    EXPECT_FALSE(exact_uv({Kelvin(6500), 0.01}, Locus::daylight));
}

TEST(CctTest, TheBlendIsContinuous) {
    const auto at = [](double kelvin) { return exact_uv({Kelvin(kelvin), 0.0}, Locus::blend).value(); };
    EXPECT_LT(delta_uv_prime(at(4000), exact_uv({Kelvin(4000), 0.0}).value()), 1e-15);
    EXPECT_LT(delta_uv_prime(at(4000), at(4000.001)), 1e-7);
    EXPECT_LT(delta_uv_prime(at(4999.999), at(5000)), 1e-7);
    EXPECT_LT(delta_uv_prime(at(5000), exact_uv({Kelvin(5000), 0.0}, Locus::daylight).value()), 1e-15);
    // Half of each luminance at the midpoint: XYZ with Y = 1 are averaged.
    const glm::dvec3 mean = 0.5 * (to_xyz(exact_uv({Kelvin(4500), 0.0}).value()) +
                                   to_xyz(exact_uv({Kelvin(4500), 0.0}, Locus::daylight).value()));
    EXPECT_LT(delta_uv_prime(at(4500), to_uv(mean)), 1e-15);
}

TEST(CctTest, TintNamesItsConvention) {
    EXPECT_NEAR(parse_tint("10@dng").value(), 10.0 / 3000.0, 1e-18);
    EXPECT_NEAR(parse_tint("-3@milliduv").value(), -0.003, 1e-18);
    EXPECT_FALSE(parse_tint("10"));
    EXPECT_FALSE(parse_tint("10@photoshop"));
    EXPECT_FALSE(parse_tint("green@dng"));
}

TEST(CctTest, ReadsTemperatures) {
    EXPECT_EQ(parse_cct("2700K")->temperature.value, 2700.0);
    EXPECT_EQ(parse_cct("2700K/-0.003")->duv, -0.003);
    for (const char* bad : {"", "2700", "K", "nanK", "2700K/", "2700K/x", "2700K/0.1/0.2", "27 00K", "2700lm"})
        EXPECT_FALSE(parse_cct(bad)) << bad;
}

TEST(CctTest, RealColoursLieInsideTheSpectralLocus) {
    for (const Xy real : {Xy{0.3127, 0.329}, Xy{0.64, 0.33}, Xy{0.3, 0.6}, Xy{0.15, 0.06}, Xy{0.16, 0.02}})
        EXPECT_TRUE(is_real(real)) << real.x;
    for (const Xy not_real : {Xy{0.8, 0.3}, Xy{0.0, 0.0}, Xy{0.0, 1.0}, Xy{0.5, 0.1}, Xy{-0.1, 0.3}, Xy{nan, 0.3}})
        EXPECT_FALSE(is_real(not_real)) << not_real.x;
}

} // namespace
} // namespace gonio
