// Intensities of many directions at once, against the web's own.
#include <gonio/base/frame.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/kernels_angles.hpp>
#include <gonio/web/quick_web.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace gonio {
namespace {

using test::random_web;
using test::steps;

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

TEST(AngleKernels, AreThoseOfTheCLibraryOnEverySet) {
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> exponent(-40.0, 40.0);
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i < 20'001; ++i) { // odd: a rest behind whole registers
        const auto number = [&] { return (generator() % 2 == 0 ? 1.0 : -1.0) * std::exp2(exponent(generator)); };
        x.push_back(i % 4 == 0 ? number() : std::cos(0.001 * i));
        y.push_back(i % 4 == 0 ? number() : std::sin(0.001 * i));
    }
    for (const double other : {0.0, 1.0, -1.0}) { // the axes
        x.push_back(other);
        y.push_back(other == 0.0 ? 1.0 : 0.0);
    }
    std::vector<double> plain(x.size());
    web_detail::angle_kernels(simd::InstructionSet::scalar).angles_deg(x.size(), y.data(), x.data(), plain.data());
    for (std::size_t i = 0; i < x.size(); ++i)
        ASSERT_NEAR(plain[i], std::atan2(y[i], x[i]) * degrees_per_radian, 1e-13) << y[i] << ' ' << x[i];
    for (const simd::InstructionSet set : simd::available_sets()) {
        std::vector<double> wide(x.size());
        web_detail::angle_kernels(set).angles_deg(x.size(), y.data(), x.data(), wide.data());
        EXPECT_EQ(wide, plain) << simd::to_text(set);
    }
    double nan = 0.0;
    const double zero = 0.0;
    web_detail::angle_kernels(simd::best_available()).angles_deg(1, &zero, &zero, &nan);
    EXPECT_TRUE(std::isnan(nan));
}

struct Case {
    const char* name;
    Web web;
};

// Uniform and other grids, every goniometer and mirror, tables that end at light, and narrow steps.
std::vector<Case> cases() {
    std::vector<Case> all;
    all.push_back({"axial", random_web(Symmetry::axial, {0}, steps(0, 90, 19), 1)});
    all.push_back({"quadrant", random_web(Symmetry::quadrant, {0, 20, 50, 90}, steps(0, 180, 37), 2)});
    all.push_back({"bilateral", random_web(Symmetry::bilateral_0_180, steps(0, 180, 13), {0, 1, 7, 60, 75}, 3)});
    all.push_back({"across", random_web(Symmetry::bilateral_90_270, {90, 91, 200, 270}, {20, 30, 180}, 4)});
    all.push_back({"none", random_web(Symmetry::none, steps(0, 360, 25), steps(0, 180, 19), 5)});
    all.push_back({"open", random_web(Symmetry::none, {10, 20, 345}, {0, 30, 60}, 6)});
    all.push_back({"turned", random_web(Symmetry::none, steps(-90, 270, 13), steps(0, 180, 19), 7)});
    all.push_back({"one plane", random_web(Symmetry::none, {0, 360}, {0, 0.001, 90, 90.0001, 180}, 8)});
    all.push_back({"one gamma", random_web(Symmetry::none, {0, 90, 200, 360}, {45}, 9)});
    const auto native = [](Photometry type, Symmetry stored, std::vector<double> h, std::vector<double> v) {
        std::vector<double> candela;
        std::mt19937 generator(static_cast<unsigned>(h.size()));
        for (std::size_t i = 0; i < h.size() * v.size(); ++i)
            candela.push_back(i % 5 == 0 ? 0.0 : static_cast<double>(generator() % 1000));
        return *Web::create(type, stored, std::move(h), std::move(v), std::move(candela));
    };
    all.push_back({"A", native(Photometry::a, Symmetry::none, steps(-180, 180, 37), steps(-90, 90, 19))});
    all.push_back({"A, mirrored", native(Photometry::a, Symmetry::quadrant, {0, 3, 40, 80}, {0, 10, 11, 70})});
    all.push_back({"B", native(Photometry::b, Symmetry::none, steps(-90, 90, 25), steps(-180, 180, 25))});
    all.push_back({"B, mirrored", native(Photometry::b, Symmetry::bilateral_0_180, steps(-60, 60, 14), {0, 5, 90})});
    all.push_back({"B, one H", native(Photometry::b, Symmetry::none, {5}, {-10, 0, 10})});
    return all;
}

void expect_same(const Case& tested, const std::vector<glm::dvec3>& directions) {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
    for (const glm::dvec3& direction : directions) {
        x.push_back(direction.x);
        y.push_back(direction.y);
        z.push_back(direction.z);
    }
    std::vector<double> found(x.size());
    std::vector<char> is_exact(x.size());
    const QuickWeb quick(tested.web);
    EXPECT_LE(quick.margin_cd(), 1e-4) << tested.name; // of 1000 cd
    quick.candela(x, y, z, found, is_exact);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double expected = tested.web.candela(directions[i]);
        const double margin = is_exact[i] != 0 ? 0.0 : quick.margin_cd();
        ASSERT_LE(std::abs(found[i] - expected), margin) << tested.name << ' ' << x[i] << ' ' << y[i] << ' ' << z[i];
    }
}

TEST(QuickWeb, IsTheWebInAnyDirection) {
    std::mt19937_64 generator(2);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 20'001; ++i)
        directions.emplace_back(normal(generator), normal(generator), normal(generator));
    for (const Case& tested : cases())
        expect_same(tested, directions);
}

TEST(QuickWeb, IsTheWebAtAnglesOfTheTableAndBesideThem) {
    for (const Case& tested : cases()) {
        std::vector<glm::dvec3> directions{{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
        const Photometry type = tested.web.photometry();
        for (const double h : tested.web.horizontal_deg())
            for (const double v : tested.web.vertical_deg())
                for (const double off_deg : {0.0, 1e-13, -1e-13, 1e-11, -1e-11, 5e-10, -5e-10, 1.5e-9, 3e-9, 1e-5, 0.1})
                    for (const double sign : {1.0, -1.0}) {
                        directions.push_back(direction_of(type, {sign * h + off_deg, v + off_deg}));
                        directions.push_back(direction_of(type, {h - off_deg, sign * v + off_deg}));
                    }
        expect_same(tested, directions);
    }
}

} // namespace
} // namespace gonio
