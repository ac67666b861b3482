// The rational functions against the sum, in every scalar type, and the kernels of every instruction set.
#include <gonio/color/cct.hpp>
#include <gonio/color/kernels.hpp>
#include <gonio/color/locus.hpp>
#include <gonio/color/planckian.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace gonio {
namespace {

// 800 K to 1e6 K, uniform in mired, which is close to what the eye distinguishes.
std::vector<float> temperatures(int count) {
    std::vector<float> kelvin;
    for (int i = 0; i < count; ++i)
        kelvin.push_back(static_cast<float>(1e6 / (1.0 + 1248.9 * i / (count - 1))));
    return kelvin;
}

TEST(Locus, TheFitsHoldTheirErrors) {
    double worst_double = 0.0;
    double worst_float = 0.0;
    for (int i = 0; i <= 3000; ++i) {
        const double t = i == 0 ? 1e-9 : color::greatest_t * i / 3000;
        const auto of_double = color::locus_jet<0>(t);
        worst_double = std::fmax(worst_double, delta_uv_prime({of_double.u, of_double.v / 1.5}, planckian_sum(t).at));
        const auto single = static_cast<float>(t);
        const auto of_float = color::locus_jet<0>(single);
        worst_float = std::fmax(worst_float,
                                delta_uv_prime({static_cast<double>(of_float.u), static_cast<double>(of_float.v) / 1.5},
                                               planckian_sum(static_cast<double>(single)).at));
    }
    EXPECT_LT(worst_double, 1.5e-12); // required: 1e-8
    EXPECT_LT(worst_float, 3e-7);     // required: 1e-6
}

TEST(Locus, DerivativesAreThoseOfTheSum) {
    for (const double t : {0.001, 0.1, 0.4, 0.8, 1.249}) {
        const auto jet = color::locus_jet<2>(t);
        const LocusPoint sum = planckian_sum(t);
        EXPECT_NEAR(jet.du, sum.first.u, 1e-9) << t;
        EXPECT_NEAR(jet.dv / 1.5, sum.first.v, 1e-9) << t;
        EXPECT_NEAR(jet.ddu, sum.second.u, 1e-6) << t;
        EXPECT_NEAR(jet.ddv / 1.5, sum.second.v, 1e-6) << t;
    }
}

class ColorKernels : public ::testing::TestWithParam<simd::InstructionSet> {
protected:
    const color::Kernels& kernels = color::kernels(GetParam());
};

TEST_P(ColorKernels, AreTheSumWithLuminanceOne) {
    const std::vector<float> kelvin = temperatures(4001);
    std::vector<float> duv(kelvin.size());
    for (std::size_t i = 0; i < duv.size(); ++i)
        duv[i] = static_cast<float>(static_cast<int>(i % 21) - 10) * 0.002F;
    for (const RgbSpaceName& name : rgb_spaces()) {
        const RgbSpace& space = *find_rgb_space(name.name);
        const color::RgbConstants constants = color::rgb_constants(space);
        std::array<std::vector<float>, 3> on, off;
        float* on_out[3];
        float* off_out[3];
        for (std::size_t c = 0; c < 3; ++c) {
            on[c].resize(kelvin.size());
            off[c].resize(kelvin.size());
            on_out[c] = on[c].data();
            off_out[c] = off[c].data();
        }
        kernels.planckian_rgb(kelvin.data(), kelvin.size(), constants, on_out);
        kernels.cct_rgb(kelvin.data(), duv.data(), kelvin.size(), constants, off_out);
        double worst_on = 0.0, worst_off = 0.0, worst_y = 0.0;
        for (std::size_t i = 0; i < kelvin.size(); ++i) {
            const Kelvin T(static_cast<double>(kelvin[i]));
            const glm::dvec3 xyz = space.to_xyz * glm::dvec3(on[0][i], on[1][i], on[2][i]);
            worst_on = std::fmax(worst_on, delta_uv_prime(to_uv(xyz), fast_uv({T, 0.0})));
            worst_y = std::fmax(worst_y, std::abs(xyz.y - 1.0));
            const glm::dvec3 shifted = space.to_xyz * glm::dvec3(off[0][i], off[1][i], off[2][i]);
            worst_off = std::fmax(worst_off, delta_uv_prime(to_uv(shifted), fast_uv({T, static_cast<double>(duv[i])})));
            worst_y = std::fmax(worst_y, std::abs(shifted.y - 1.0));
        }
        EXPECT_LT(worst_on, 1e-6) << name.name;
        EXPECT_LT(worst_off, 1e-6) << name.name;
        EXPECT_LT(worst_y, 1e-6) << name.name;
    }
}

TEST_P(ColorKernels, AnswerEveryCountAsTheWhole) {
    const std::vector<float> kelvin = temperatures(67);
    const color::RgbConstants space = color::rgb_constants(*find_rgb_space("rec709"));
    std::array<std::vector<float>, 3> whole;
    float* out[3];
    for (std::size_t c = 0; c < 3; ++c) {
        whole[c].resize(kelvin.size());
        out[c] = whole[c].data();
    }
    kernels.planckian_rgb(kelvin.data(), kelvin.size(), space, out);
    for (std::size_t count = 0; count < kelvin.size(); ++count) {
        std::array<std::vector<float>, 3> part;
        for (std::size_t c = 0; c < 3; ++c) {
            part[c].assign(count + 1, -7.0F);
            out[c] = part[c].data();
        }
        kernels.planckian_rgb(kelvin.data(), count, space, out);
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t i = 0; i < count; ++i)
                EXPECT_EQ(part[c][i], whole[c][i]);
            EXPECT_EQ(part[c][count], -7.0F) << "written beyond the end";
        }
    }
}

TEST_P(ColorKernels, GiveNanForWhatTheyDoNotKnow) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> kelvin{799.9F, 0.0F, -2700.0F, nan, infinity, -infinity, 2e6F, 2700.0F};
    std::vector<float> duv(kelvin.size(), 0.0F);
    std::vector<float> u(kelvin.size()), v(kelvin.size()), b(kelvin.size());
    float* const uv[2] = {u.data(), v.data()};
    float* const rgb[3] = {u.data(), v.data(), b.data()};
    const color::RgbConstants space = color::rgb_constants(*find_rgb_space("rec709"));
    const auto only_the_last = [&](const char* what) {
        for (std::size_t i = 0; i < kelvin.size(); ++i)
            EXPECT_EQ(std::isnan(u[i]) && std::isnan(v[i]), i + 1 < kelvin.size()) << what << ' ' << kelvin[i];
    };
    kernels.planckian_uv_prime(kelvin.data(), kelvin.size(), uv);
    only_the_last("uv");
    kernels.planckian_rgb(kelvin.data(), kelvin.size(), space, rgb);
    only_the_last("rgb");
    kernels.cct_rgb(kelvin.data(), duv.data(), kelvin.size(), space, rgb);
    only_the_last("cct");
    for (const float bad : {0.11F, -0.11F, nan, infinity}) {
        duv.back() = bad;
        kernels.cct_rgb(kelvin.data(), duv.data(), kelvin.size(), space, rgb);
        EXPECT_TRUE(std::isnan(u.back()) && std::isnan(v.back()) && std::isnan(b.back())) << bad;
    }
}

// Instruction sets differ only by fused multiplication: a few ulp of numbers near 1.
TEST_P(ColorKernels, AgreeWithPlainFloat) {
    const std::vector<float> kelvin = temperatures(1000);
    const color::RgbConstants space = color::rgb_constants(*find_rgb_space("acescg"));
    std::array<std::vector<float>, 6> values;
    float* mine[3];
    float* plain[3];
    for (std::size_t c = 0; c < 3; ++c) {
        values[c].resize(kelvin.size());
        values[c + 3].resize(kelvin.size());
        mine[c] = values[c].data();
        plain[c] = values[c + 3].data();
    }
    kernels.planckian_rgb(kelvin.data(), kelvin.size(), space, mine);
    color::kernels(simd::InstructionSet::scalar).planckian_rgb(kelvin.data(), kelvin.size(), space, plain);
    for (std::size_t i = 0; i < kelvin.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(mine[c][i], plain[c][i], 4e-6F) << kernels.name << ' ' << kelvin[i];
}

INSTANTIATE_TEST_SUITE_P(Sets, ColorKernels,
                         ::testing::ValuesIn(simd::available_sets().begin(), simd::available_sets().end()),
                         [](const auto& tested) { return std::string(simd::to_text(tested.param)); });

} // namespace
} // namespace gonio
