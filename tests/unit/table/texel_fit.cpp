#include <gonio/table/texel_fit.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gonio {
namespace {

template<class F>
std::vector<double> fit(TableAxes axes, int count, const F& f) {
    const std::vector<FitPlace> places = fit_places(axes, count);
    std::vector<double> values;
    for (const FitPlace& place : places)
        values.push_back(f(place.at));
    return fitted_texels(axes, count, places, values);
}

double looked_up(TableAxes axes, const std::vector<double>& texels, double at) {
    const auto [first, second, share] = between(axes, at, static_cast<int>(texels.size()));
    return (1.0 - share) * texels[first] + share * texels[second];
}

TEST(TexelFit, PlacesCoverTheAxis) {
    for (const int count : {2, 3, 17}) {
        for (const TableAxes axes : {TableAxes::linear, TableAxes::root}) {
            const std::vector<FitPlace> places = fit_places(axes, count);
            EXPECT_TRUE(std::is_sorted(places.begin(), places.end(),
                                       [](const FitPlace& a, const FitPlace& b) { return a.at < b.at; }));
            EXPECT_GT(places.front().at, 0.0);
            EXPECT_LT(places.back().at, 1.0);
            const double sum =
                std::accumulate(places.begin(), places.end(), 0.0,
                                [](double before, const FitPlace& place) { return before + place.weight; });
            // The two halves of a texel beyond the outermost middles count a tenth.
            EXPECT_NEAR(sum, axes == TableAxes::linear ? 1.0 - 0.9 / count : 1.0, 1e-14);
        }
    }
}

TEST(TexelFit, OfWhatALookupCanBeIsExact) {
    const std::vector<double> texels = fit(TableAxes::root, 9, [](double x) { return 3.0 - 2.0 * x; });
    for (std::size_t k = 0; k < 9; ++k)
        EXPECT_NEAR(texels[k], 3.0 - 2.0 * static_cast<double>(k) / 8.0, 1e-13);
    for (const double texel : fit(TableAxes::linear, 9, [](double) { return 0.25; }))
        EXPECT_NEAR(texel, 0.25, 1e-14);
}

// x² between texels h apart, far from the ends: exact texels err by t (1 − t) h², h²/6 in the mean. Without that mean
// h²/12 remains in the middle, and −h²/6 at texels.
TEST(TexelFit, SharesTheErrorOfACurve) {
    const std::vector<double> texels = fit(TableAxes::root, 41, [](double x) { return x * x; });
    const double h = 1.0 / 40.0;
    EXPECT_NEAR(texels[20] - 0.25, -h * h / 6.0, 1e-3 * h * h);
    const double middle = 20.5 * h;
    EXPECT_NEAR(looked_up(TableAxes::root, texels, middle) - middle * middle, h * h / 12.0, 1e-3 * h * h);
}

// Nothing near the solution has a smaller sum of squares.
TEST(TexelFit, HasTheLeastSquares) {
    const auto f = [](double x) { return std::exp(-9.0 * x); };
    for (const TableAxes axes : {TableAxes::linear, TableAxes::root}) {
        const std::vector<FitPlace> places = fit_places(axes, 6);
        const auto squares = [&](const std::vector<double>& texels) {
            double sum = 0.0;
            for (const FitPlace& place : places)
                sum += place.weight * std::pow(looked_up(axes, texels, place.at) - f(place.at), 2);
            return sum;
        };
        const std::vector<double> texels = fit(axes, 6, f);
        for (std::size_t k = 0; k < texels.size(); ++k)
            for (const double step : {-1e-4, 1e-4}) {
                std::vector<double> moved = texels;
                moved[k] += step;
                EXPECT_GT(squares(moved), squares(texels)) << k;
            }
    }
}

} // namespace
} // namespace gonio
