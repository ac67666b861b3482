// The reference sum against values that were computed independently (numpy in double, spot-checked with 40 digits).
#include <gonio/color/detail/cie_tables.hpp>
#include <gonio/color/planckian.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gonio {
namespace {

struct Reference {
    double kelvin, x, y, u, v, lm_per_w, nits;
};
// Printed with nine decimals; efficacies with Km = 683.002, to three or four digits.
constexpr Reference references[] = {
    {500, 0.721385535, 0.278568109, 0.588880594, 0.341100588, 4.16e-13, 4.70e-10},
    {800, 0.681334274, 0.317931397, 0.499831819, 0.349855205, 1.09e-6, 8.09e-3},
    {1000, 0.652750698, 0.344461655, 0.448007131, 0.354625307, 1.49e-4, 2.687},
    {1500, 0.585717944, 0.393121309, 0.357907834, 0.360330081, 0.0847, 7740},
    {2000, 0.526677487, 0.413297000, 0.305045784, 0.359065587, 1.606, 4.638e5},
    {2700, 0.459859027, 0.410599038, 0.262496451, 0.351566840, 12.36, 1.185e7},
    {4000, 0.380439532, 0.376746824, 0.225109392, 0.334386575, 54.71, 2.528e8},
    {5000, 0.345101174, 0.351608042, 0.211423616, 0.323114999, 81.39, 9.181e8},
    {6500, 0.313525880, 0.323628305, 0.200448485, 0.310360998, 95.36, 3.073e9},
    {10000, 0.280633572, 0.288287841, 0.190318533, 0.293264195, 73.47, 1.326e10},
    {25000, 0.252520696, 0.252220546, 0.182932817, 0.274073070, 12.98, 9.149e10},
    {40000, 0.247203134, 0.244720328, 0.181692274, 0.269801147, 3.971, 1.835e11},
};

TEST(Planckian, TheSumIsTheReference) {
    for (const Reference& r : references) {
        const Uv at = planckian_sum(1e3 / r.kelvin).at;
        EXPECT_NEAR(at.u, r.u, 6e-10) << r.kelvin;
        EXPECT_NEAR(at.v, r.v, 6e-10) << r.kelvin;
        const Xy xy = to_xy(at);
        EXPECT_NEAR(xy.x, r.x, 6e-10) << r.kelvin;
        EXPECT_NEAR(xy.y, r.y, 6e-10) << r.kelvin;
        const Xy of_xyz = to_xy(planckian_xyz(Kelvin(r.kelvin)));
        EXPECT_NEAR(of_xyz.x, xy.x, 1e-14) << r.kelvin;
        EXPECT_NEAR(blackbody_efficacy(Kelvin(r.kelvin)).total_lm_per_w / r.lm_per_w, 1.0, 4e-3) << r.kelvin;
        const Nits luminance = blackbody_luminance(Kelvin(r.kelvin));
        EXPECT_NEAR(luminance.value / r.nits, 1.0, 4e-3) << r.kelvin;
        const Nits at_once = blackbody_luminance(Kelvin(r.kelvin), blackbody_efficacy(Kelvin(r.kelvin)));
        EXPECT_NEAR(at_once.value / luminance.value, 1.0, 1e-15) << r.kelvin;
    }
    const Uv infinite = to_uv(planckian_xyz(Kelvin(std::numeric_limits<double>::infinity())));
    EXPECT_NEAR(infinite.u, 0.180064, 6e-7);
    EXPECT_NEAR(infinite.v, 0.263521, 6e-7);
}

TEST(Planckian, EfficacyPeaksAt6628K) {
    EXPECT_NEAR(blackbody_efficacy(Kelvin(6628)).total_lm_per_w, 95.43, 0.01);
    for (const double kelvin : {6500.0, 6750.0})
        EXPECT_LT(blackbody_efficacy(Kelvin(kelvin)).total_lm_per_w, blackbody_efficacy(Kelvin(6628)).total_lm_per_w);
    // 360–830 nm.
    EXPECT_NEAR(blackbody_efficacy(Kelvin(2700)).band_lm_per_w, 113.8, 0.1);
    EXPECT_NEAR(blackbody_efficacy(Kelvin(6500)).band_lm_per_w, 172.5, 0.1);
}

TEST(Planckian, DerivativesAreThoseOfTheCurve) {
    for (const double t : {0.01, 0.1, 0.25, 0.5, 1.0, 1.9}) {
        constexpr double h = 1e-4;
        const LocusPoint a = planckian_sum(t - h);
        const LocusPoint p = planckian_sum(t);
        const LocusPoint b = planckian_sum(t + h);
        // Central differences: h²/6 of the third derivative, which is below 100.
        EXPECT_NEAR(p.first.u, (b.at.u - a.at.u) / (2 * h), 2e-7) << t;
        EXPECT_NEAR(p.first.v, (b.at.v - a.at.v) / (2 * h), 2e-7) << t;
        EXPECT_NEAR(p.second.u, (b.first.u - a.first.u) / (2 * h), 2e-6) << t;
        EXPECT_NEAR(p.second.v, (b.first.v - a.first.v) / (2 * h), 2e-6) << t;
    }
}

TEST(Planckian, C2MovesItAsCieSays) {
    const double its90 =
        delta_uv_prime(to_uv(planckian_xyz(Kelvin(1000), c2_its90_meter_kelvin)), to_uv(planckian_xyz(Kelvin(1000))));
    EXPECT_NEAR(its90, 3.8e-6, 1e-7);
}

TEST(Planckian, TheObserverSumsToItsArea) {
    double x = 0.0, y = 0.0, z = 0.0;
    for (const auto& row : detail::observer) {
        x += row[0];
        y += row[1];
        z += row[2];
    }
    EXPECT_NEAR(x, 106.8655, 5e-5);
    EXPECT_NEAR(y, 106.856917, 5e-7);
    EXPECT_NEAR(z, 106.8923, 5e-5);
}

} // namespace
} // namespace gonio
