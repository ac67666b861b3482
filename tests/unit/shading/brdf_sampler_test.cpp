// The samplers of the materials against their stated densities.
#include <gonio/shading/brdf.hpp>
#include <gonio/shading/furnace.hpp>

#include "brdf_cases.hpp"
#include "chi_square.hpp"
#include "facet_rule.hpp"
#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace gonio::shading;
using brdf_cases::to;
using poses::Random;
using poses::Vec;

constexpr std::size_t samples = 60'000;

struct Tested {
    std::string name;
    chi_square::Outcome outcome;
};

// Samples in S, evaluates the density in double.
template<class S, class Drawn, class Stated>
Tested sampled(const std::string& name, const Drawn& drawn, const Stated& stated, double narrow, double mu,
               std::uint64_t seed) {
    Random random(seed);
    const Vec n = poses::random_direction(random);
    const Vec v = poses::tilted(n, mu, random);
    const chi_square::Cells cells(n * (2.0 * dot(n, v)) - v, n, std::min(narrow, 1.0));
    const auto sample = [&] {
        const vec3<S> u = to<S>({random.uniform(), random.uniform(), random.uniform()});
        const vec3<S> l = sample_brdf(drawn, to<S>(n), to<S>(v), u).l;
        return Vec{l.x, l.y, l.z};
    };
    const auto density = [&](Vec l) { return pdf_brdf(stated, n, v, l); };
    const std::size_t points = mu < 0.1 ? 24 : 12; // squared, per cell: the lobes of shallow views are thin
    return {fmt::format("{} at n·v {}", name, mu), chi_square::test(cells, sample, density, samples, points)};
}

template<class S>
void all_samplers(std::vector<Tested>& tested) {
    std::uint64_t seed = 100;
    brdf_cases::each([&](const std::string& name, const auto& make) {
        const auto drawn = make(S());
        const auto stated = make(double());
        const double alpha = lobe_alpha(stated);
        // A single lobe gets cells of its own width; next to a wide lobe the cells must be wide enough for both.
        const bool alone = std::is_same_v<decltype(make(double())), Ggx<double>>;
        if (!alone && alpha < 0.03) return;
        for (const double mu : {0.04, 0.4, 1.0}) {
            if (std::is_same_v<S, float> && mu != 0.4) continue;
            if (mu < 0.1 && alpha < 0.1) continue; // too long and thin for the quadrature of the cells
            tested.push_back(sampled<S>(name, drawn, stated, 2.0 * alpha, mu, ++seed));
        }
    });
}

// All together have a false alarm rate of one in a hundred, over the choice of seeds.
TEST(BrdfSampler, DirectionsFallWhereTheDensitySays) {
    std::vector<Tested> tested;
    all_samplers<double>(tested);
    all_samplers<float>(tested);
    ASSERT_GE(tested.size(), 90U);
    RecordProperty("cases", std::to_string(tested.size()));
    const double least = chi_square::sidak(0.01, tested.size());
    for (const Tested& test : tested) {
        EXPECT_GT(test.outcome.probability, least)
            << test.name << ": χ² " << test.outcome.statistic << " of " << test.outcome.degrees;
        EXPECT_NEAR(test.outcome.integral, 1.0, 5e-4) << test.name;
        EXPECT_GT(test.outcome.degrees, 60U) << test.name;
    }
}

// The albedo towards v, of the third channel.
template<class M>
double albedo_by_quadrature(const M& material, const Vec& /*n*/, const Vec& /*v*/, double mu) {
    return gonio::shading::directional_albedo(material, mu, lobe_alpha(material)).z;
}
// By facets for the lobe.
double albedo_by_quadrature(const gonio::shading::Anisotropic<double>& material, const Vec& n, const Vec& v,
                            double mu) {
    const auto frame = material.grain.frame(n);
    const Vec view = frame.to_local(v);
    double sum = 0.0;
    facet_rule::each(material.alphas, 600, [&](const Vec& h, double dh) {
        const double v_dot_h = dot(view, h);
        const Vec l = h * (2.0 * v_dot_h) - view;
        if (l.z > 0.0 && v_dot_h > 0.0)
            sum += specular_part(material, n, frame.to_world(l), v, 0.0).z * l.z * 4.0 * v_dot_h * dh;
    });
    const auto matte = diffuse_alone(material);
    return sum + gonio::shading::directional_albedo(matte, mu, lobe_alpha(matte)).z;
}

// Its error. Seen at a grazing angle, the midpoints lose some of the slopes of a lobe of α = 1e-4 that the eye sees: it
// is 1e-2, and half of that with twice the steps.
template<class M>
double error_of_quadrature(const M& /*material*/) {
    return 1e-4;
}
double error_of_quadrature(const gonio::shading::Anisotropic<double>& material) {
    return brdf_cases::least_alpha(material) < 1e-3 ? 0.015 : 1e-4;
}

// E[f n·l/pdf] is the albedo that quadrature gives, including very shallow views and very narrow lobes.
TEST(BrdfSampler, WeightsMeanTheAlbedo) {
    std::vector<std::pair<std::string, double>> scores;
    brdf_cases::each([&](const std::string& name, const auto& make) {
        const auto material = make(double());
        for (const double mu : {0.02, 0.3, 1.0}) {
            Random random(17);
            const Vec n{0.0, 0.0, 1.0};
            const Vec v = poses::tilted(n, mu, random);
            double sum = 0.0;
            double squares = 0.0;
            constexpr int count = 20'000;
            for (int i = 0; i < count; ++i) {
                const auto sample = sample_brdf(material, n, v, {random.uniform(), random.uniform(), random.uniform()});
                if (!(sample.l.z > 0.0)) continue;
                const double weight = brdf(material, n, sample.l, v).z * sample.l.z / sample.pdf;
                sum += weight;
                squares += weight * weight;
            }
            const double mean = sum / count;
            const double truth = albedo_by_quadrature(material, n, v, mu);
            const double deviation = std::sqrt(std::max(squares / count - mean * mean, 0.0) / count);
            EXPECT_LE(std::fabs(mean - truth), 4.5 * deviation + error_of_quadrature(material))
                << name << " at n·v " << mu;
            scores.emplace_back(name, deviation);
        }
    });
    ASSERT_GE(scores.size(), 80U);
    // One sample is accurate enough: the mean of 20 000 is known to better than 1 %, at grazing too.
    for (const auto& [name, deviation] : scores)
        EXPECT_LT(deviation, 0.01) << name;
}

// Shows that the test detects a slightly wrong density.
TEST(BrdfSampler, TheTestSeesAWrongDensity) {
    Random random(3);
    const Vec n{0, 0, 1};
    const Vec v = poses::tilted(n, 0.4, random);
    const Ggx<double> material{{1, 1, 1}, 0.3};
    const Ggx<double> other{{1, 1, 1}, 0.306};
    const chi_square::Cells cells(n * (2.0 * dot(n, v)) - v, n, 0.6);
    const auto sample = [&] {
        return sample_brdf(material, n, v, {random.uniform(), random.uniform(), random.uniform()}).l;
    };
    const auto right = [&](Vec l) { return pdf_brdf(material, n, v, l); };
    const auto wrong = [&](Vec l) { return pdf_brdf(other, n, v, l); };
    EXPECT_GT(chi_square::test(cells, sample, right, 8 * samples, 8).probability, 1e-3);
    EXPECT_LT(chi_square::test(cells, sample, wrong, 8 * samples, 8).probability, 1e-6);
}

// Reference values: Q(1/2, x) = erfc(√x), Q(1, x) = exp(−x).
TEST(ChiSquare, UpperGamma) {
    for (const double x : {0.01, 0.5, 1.0, 1.7, 3.0, 20.0}) {
        EXPECT_NEAR(chi_square::upper_gamma(0.5, x), std::erfc(std::sqrt(x)), 1e-13) << x;
        EXPECT_NEAR(chi_square::upper_gamma(1.0, x), std::exp(-x), 1e-13) << x;
    }
    EXPECT_NEAR(chi_square::upper_gamma(300.0, 300.0), 0.4923, 1e-3);
    EXPECT_NEAR(chi_square::sidak(0.01, 2), 1.0 - std::sqrt(0.99), 1e-15);
}

} // namespace
