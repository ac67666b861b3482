// The reference values that specular methods are measured against, and the measurements.
#include <gonio/measure/error_statistics.hpp>
#include <gonio/measure/specular_methods.hpp>
#include <gonio/measure/specular_truth.hpp>

#include "../shading/specular_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace gonio;
using Kind = shading::LightConstants::Kind;

Kind kind_of(const std::string& shape) {
    if (shape == "sphere") return Kind::sphere;
    if (shape == "disk") return Kind::disk;
    return shape == "rect" ? Kind::rectangle : Kind::tube;
}

shading::LightConstants constants(const specular::Row& row) {
    shading::LightConstants light;
    light.kind = kind_of(row.shape);
    light.radius = static_cast<float>(row.p);
    light.width = static_cast<float>(row.p);
    light.height = static_cast<float>(row.q);
    light.length = static_cast<float>(row.q);
    const double axis[3] = {row.axis.x, row.axis.y, row.axis.z};
    const double across[3] = {row.across.x, row.across.y, row.across.z};
    for (std::size_t k = 0; k < 3; ++k) {
        light.axis[k] = static_cast<float>(axis[k]);
        light.width_direction[k] = static_cast<float>(across[k]);
    }
    return light;
}

// The light's sizes and axes are rounded to float here: 1e-6 of the luminance, 4e-4 if the horizon leaves little of the
// light.
TEST(MeasureSpecular, QuadratureGivesTheStoredValues) {
    const auto rows = specular::rows();
    std::vector<double> errors;
    for (std::size_t i = 0; i < rows.size(); i += 3) {
        const specular::Row& row = rows[i];
        const double found =
            measure::specular_by_quadrature(constants(row), row.center, row.normal, row.view, row.alpha);
        errors.push_back(std::fabs(found / row.luminance - 1.0));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() / 2], 2e-7);
    EXPECT_LT(errors[errors.size() * 9 / 10], 5e-6);
    EXPECT_LT(errors.back(), 5e-4);
}

TEST(MeasureSpecular, CasesAreTheSameForTheSameSeedAndSeen) {
    const auto a = measure::specular_cases(Kind::tube, 600, 5);
    const auto b = measure::specular_cases(Kind::tube, 600, 5);
    ASSERT_EQ(a.size(), 600U);
    EXPECT_EQ(a.view, b.view);
    EXPECT_EQ(a.alpha, b.alpha);
    EXPECT_NE(a.view, measure::specular_cases(Kind::tube, 600, 6).view);
    for (const float alpha : a.alpha) {
        EXPECT_GE(alpha, 0.0099F);
        EXPECT_LE(alpha, 1.0F);
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        float seen = 0.0F;
        for (std::size_t k = 0; k < 3; ++k)
            seen += a.view[k][i] * a.area.normal[k][i];
        EXPECT_GT(seen, 0.0F) << i;
    }
}

// Rows of points are several times more accurate than a transformed cosine's share corrected by points, and that than
// any single direction (shading/MEASURED.md).
TEST(MeasureSpecular, LtcIsTheMostAccurateMethodOfEveryShape) {
    for (const Kind kind : {Kind::sphere, Kind::disk, Kind::ellipse, Kind::rectangle, Kind::tube}) {
        const auto cases = measure::specular_cases(kind, 60, 3);
        const auto truth = measure::specular_truth(cases);
        double best_of_others = HUGE_VAL;
        double of_ltc = 0.0;
        double of_share = 0.0;
        for (const auto& method : measure::specular_methods(kind)) {
            const auto values = measure::evaluated(method, cases);
            for (const double value : values)
                ASSERT_TRUE(std::isfinite(value) && value >= 0.0) << method.name << ' ' << method.precision;
            const double median = measure::compare(values, truth, 1e-3).relative.median;
            if (method.name == "ltc") {
                of_ltc = std::max(of_ltc, median);
            } else if (method.name == "ltc-share") {
                of_share = std::max(of_share, median);
            } else {
                best_of_others = std::min(best_of_others, median);
            }
        }
        EXPECT_LT(of_share, 0.06) << static_cast<int>(kind);
        EXPECT_LT(of_share, 0.25 * best_of_others) << static_cast<int>(kind);
        EXPECT_LT(of_ltc, 0.5 * of_share) << static_cast<int>(kind);
    }
}

// The rectangle that stands for a cylinder in highlights costs no more than that.
TEST(MeasureSpecular, ACylinderIsNearlyARectangle) {
    const auto cases = measure::specular_cases(Kind::cylinder, 120, 3);
    const auto truth = measure::specular_truth(cases);
    for (const auto& method : measure::specular_methods(Kind::cylinder)) {
        if (method.name != "ltc") continue;
        const auto values = measure::evaluated(method, cases);
        for (const double value : values)
            ASSERT_TRUE(std::isfinite(value) && value >= 0.0) << method.precision;
        const auto errors = measure::compare(values, truth, 1e-3);
        EXPECT_LT(errors.relative.median, 0.08) << method.precision;
        RecordProperty("median", std::to_string(errors.relative.median));
    }
}

} // namespace
