// The anisotropic GGX lobe: against the isotropic one, its own definition, and quadrature under lights with a size.
#include <gonio/base/parallel.hpp>
#include <gonio/measure/specular_cases.hpp>
#include <gonio/measure/specular_truth.hpp>
#include <gonio/shading/anisotropic_lobe.hpp>
#include <gonio/shading/brdf.hpp>
#include <gonio/shading/kernels_specular.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/specular_in_double.hpp>
#include <gonio/shading/specular_ltc.hpp>
#include <gonio/simd/dispatch.hpp>

#include "../scaled.hpp"
#include "facet_rule.hpp"
#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace gonio::shading;
using gonio::measure::SpecularCases;
using poses::Random;
using poses::Vec;
using Kind = LightConstants::Kind;

constexpr double pi = std::numbers::pi;

double log_uniform(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

Anisotropic<double> material_of(AnisotropicAlpha<double> alphas, double turn = 0.0) {
    return {{0.0, 0.0, 0.0}, {0.9, 0.5, 0.1}, 1.0, alphas, {{0.0, 0.0, 1.0}, std::cos(turn), std::sin(turn)}};
}

Vec above(const Vec& n, Random& random) {
    return poses::tilted(n, random.uniform(0.02, 1.0), random);
}

TEST(Anisotropic, EvenLobeIsThatOfGgx) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const double alpha = log_uniform(random, 1e-3, 1.0);
        const Anisotropic<double> one = material_of({alpha, alpha}, random.uniform(0.0, 2.0 * pi));
        const Ggx<double> even{one.f0, alpha};
        const Vec n = poses::random_direction(random);
        const Vec v = above(n, random);
        const Vec l = sample_brdf(even, n, v, {random.uniform(), random.uniform(), random.uniform()}).l;
        const double value = brdf(even, n, l, v).x;
        EXPECT_NEAR(brdf(one, n, l, v).x, value, 1e-9 * value + 1e-13) << i;
        const double pdf = pdf_brdf(even, n, v, l);
        EXPECT_NEAR(pdf_brdf(one, n, v, l), pdf, 1e-9 * pdf) << i;
    }
}

// The facets' projected area is that of the surface: ∫ D n·h dh = 1.
TEST(Anisotropic, DistributionIsNormalised) {
    for (const AnisotropicAlpha<double> alphas : {AnisotropicAlpha<double>{0.3, 0.3}, {0.9, 0.1}, {0.05, 1.2}}) {
        double sum = 0.0;
        facet_rule::each(alphas, 400,
                         [&](const Vec& h, double dh) { sum += distribution_ggx(h, 1.0, alphas, alphas) * h.z * dh; });
        EXPECT_NEAR(sum, 1.0, 1e-9) << alphas.x << ' ' << alphas.y;
    }
}

TEST(Anisotropic, QuarterTurnSwapsTheAxes) {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const AnisotropicAlpha<double> alphas{log_uniform(random, 0.01, 1.0), log_uniform(random, 0.01, 1.0)};
        const double turn = random.uniform(0.0, 2.0 * pi);
        const Anisotropic<double> one = material_of(alphas, turn);
        const Anisotropic<double> other = material_of({alphas.y, alphas.x}, turn + 0.5 * pi);
        const Vec n = poses::random_direction(random);
        const Vec v = above(n, random);
        const Vec l = above(n, random);
        const double value = brdf(one, n, l, v).x;
        EXPECT_NEAR(brdf(other, n, l, v).x, value, 1e-9 * value) << i;
    }
}

TEST(Anisotropic, TangentIsLevelAndXOnLevelSurfaces) {
    const Grain<double> grain{{0.0, 0.0, 1.0}, 1.0, 0.0};
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const Vec n = poses::random_direction(random);
        const Vec t = grain.along(n);
        EXPECT_NEAR(length(t), 1.0, 1e-14);
        EXPECT_NEAR(dot(t, n), 0.0, 1e-14);
        EXPECT_NEAR(t.z, 0.0, 1e-14);
    }
    for (const double z : {-1.0, 1.0}) {
        const Vec t = grain.along({0.0, 0.0, z});
        EXPECT_NEAR(std::fabs(t.x), 1.0, 1e-14) << z;
    }
    EXPECT_NEAR(grain.along({0.0, -1.0, 0.0}).x, 1.0, 1e-14); // a wall that faces −Y
    const Grain<double> turned{{0.0, 0.0, 1.0}, 0.0, 1.0};
    EXPECT_NEAR(turned.along({0.0, -1.0, 0.0}).z, 1.0, 1e-14); // by 90°: upright
}

TEST(Anisotropic, ParametersAreThoseOfOpenPbrAndGltf) {
    for (const double alpha : {0.04, 0.3, 1.0})
        for (const double anisotropy : {0.0, 0.3, 0.9}) {
            const AnisotropicAlpha<double> open = openpbr_alpha(alpha, anisotropy);
            EXPECT_NEAR(open.x * open.x + open.y * open.y, 2.0 * alpha * alpha, 1e-14);
            EXPECT_NEAR(open.y, (1.0 - anisotropy) * open.x, 1e-15);
            const AnisotropicAlpha<double> gltf = gltf_alpha(alpha, anisotropy);
            EXPECT_EQ(gltf.y, alpha);
            EXPECT_NEAR(gltf.x, alpha + anisotropy * anisotropy * (1.0 - alpha), 1e-15);
        }
    EXPECT_EQ(openpbr_alpha(0.3, 1.0).y, minimum_alpha);
}

SpecularCases cases_of(Kind kind) {
    return gonio::measure::specular_cases(kind, 1024, 11);
}
Vec at(const std::array<std::vector<float>, 3>& v, std::size_t i) {
    return {static_cast<double>(v[0][i]), static_cast<double>(v[1][i]), static_cast<double>(v[2][i])};
}
const LightConstants& light_of(const SpecularCases& cases, std::size_t i) {
    return cases.area.lights[i / SpecularCases::group_size];
}
AnisotropicGgxLobe<double> random_lobe(Random& random) {
    const AnisotropicAlpha<double> alphas{log_uniform(random, 0.1, 1.0), log_uniform(random, 0.1, 1.0)};
    const double turn = random.uniform(0.0, 2.0 * pi);
    return {alphas, {{0.0, 0.0, 1.0}, std::cos(turn), std::sin(turn)}, alphas.mean()};
}
double in_double(const SpecularCases& cases, std::size_t i, const AnisotropicGgxLobe<double>& lobe) {
    double found = 0.0;
    gonio::shading::detail::with_light<double>(light_of(cases, i), [&](const auto& light) {
        if constexpr (requires { light.center; })
            found = specular_in_double(SpecularMethod::ltc, light, at(cases.area.position, i) * -1.0,
                                       poses::unit(at(cases.area.normal, i)), poses::unit(at(cases.view, i)), lobe)
                        .scale;
    });
    return found;
}

// Bounds of the median and the 95th percentile of the relative error, a third above what these poses have.
TEST(Anisotropic, HighlightIsThatOfQuadrature) {
    if (gonio::test::is_sanitized) GTEST_SKIP() << "KernelsAreThatOfDouble";
    struct Bound {
        Kind kind;
        double median, most;
    };
    for (const Bound& bound : {Bound{Kind::sphere, 0.004, 0.07}, Bound{Kind::disk, 0.006, 0.16},
                               Bound{Kind::rectangle, 0.01, 0.18}, Bound{Kind::tube, 0.005, 0.1}}) {
        const SpecularCases cases = cases_of(bound.kind);
        Random random(4);
        std::vector<AnisotropicGgxLobe<double>> lobes;
        for (std::size_t i = 0; i < cases.size(); ++i)
            lobes.push_back(random_lobe(random));
        std::vector<double> errors(cases.size(), -1.0);
        constexpr std::size_t every = 4; // which leaves some of each light
        gonio::parallel_for(cases.size() / every, 0, [&](std::size_t k) {
            const std::size_t i = every * k;
            const Vec n = poses::unit(at(cases.area.normal, i));
            const Vec v = poses::unit(at(cases.view, i));
            const double truth =
                gonio::measure::specular_by_quadrature(light_of(cases, i), at(cases.area.position, i) * -1.0, n, v,
                                                       [&](Vec l) { return lobes[i](n, l, v, lobes[i].alpha).scale; });
            const double found = in_double(cases, i, lobes[i]);
            if (truth > 1e-3 || found > 1e-3) errors[i] = std::fabs(found - truth) / std::fmax(truth, 1e-3);
        });
        std::erase(errors, -1.0);
        std::sort(errors.begin(), errors.end());
        ASSERT_GT(errors.size(), 60U);
        EXPECT_LT(errors[errors.size() / 2], bound.median) << static_cast<int>(bound.kind);
        EXPECT_LT(errors[errors.size() * 19 / 20], bound.most) << static_cast<int>(bound.kind);
    }
}

// A pose at which rows of a tube's points almost meet their axis: in float a sum was a hundred times too large.
template<class S>
S highlight_of_far_rows() {
    const vec3<S> to_center{S(0.10698013), S(0.0180444978), S(0.0765057728)};
    const vec3<S> axis{S(-0.197969511), S(-0.874449492), S(0.442883909)};
    const vec3<S> n{S(-0.572107017), S(-0.611397028), S(-0.546705782)};
    const vec3<S> v{S(-0.566693485), S(-0.444977164), S(0.693436265)};
    const vec3<S> tangent{S(0.0201078113), S(0.655912936), S(-0.754568636)};
    const AnisotropicAlpha<S> alphas{S(0.994460464), S(0.932963848)};
    const LtcFrame<S> frame = ltc_frame(n, v);
    const AnisotropicGgxInFrame<S> lobe{alphas, {dot(frame.x, tangent), dot(frame.y, tangent)}, alphas.mean()};
    const TubeLight<S> tube{to_center, {S(1), S(1), S(1)}, axis, S(0.0431570895), S(2.89189434), S(0)};
    return specular_ltc(tube, to_center, n, v, lobe, [&](S n_dot_v, S sine) { return lobe.cosine(n_dot_v, sine); })
        .scale;
}
TEST(Anisotropic, FarRowsKeepTheirPointsInFloat) {
    const double expected = highlight_of_far_rows<double>();
    EXPECT_NEAR(expected, 0.0038, 0.0002) << "3.76e-3 by Monte Carlo";
    EXPECT_NEAR(static_cast<double>(highlight_of_far_rows<float>()), expected, 1e-4 * expected);
}

TEST(Anisotropic, KernelsAreThatOfDouble) {
    for (const Kind kind : {Kind::sphere, Kind::disk, Kind::ellipse, Kind::rectangle, Kind::tube}) {
        const SpecularCases cases = cases_of(kind);
        for (const gonio::simd::InstructionSet set : gonio::simd::available_sets()) {
            Random random(5);
            std::vector<double> errors;
            for (std::size_t group = 0; group < cases.area.lights.size(); ++group) {
                const AnisotropicGgxLobe<double> lobe = random_lobe(random);
                const auto lobe_constants = constants_of(lobe);
                const Surfaces surfaces = cases.surfaces(group);
                std::vector<float> scale(surfaces.count);
                std::vector<float> grazing(surfaces.count);
                specular_kernels(set).specular_anisotropic(surfaces, cases.area.lights[group], lobe_constants,
                                                           SpecularMethod::ltc, scale.data(), grazing.data());
                for (std::size_t k = 0; k < surfaces.count; ++k) {
                    const double wanted =
                        in_double(cases, group * SpecularCases::group_size + k, lobe_of<double>(lobe_constants));
                    ASSERT_TRUE(scale[k] >= 0.0F && scale[k] <= 1.0F && grazing[k] >= 0.0F && grazing[k] <= 1.0F);
                    errors.push_back(std::fabs(static_cast<double>(scale[k]) - wanted) / std::fmax(wanted, 1e-2));
                }
            }
            std::sort(errors.begin(), errors.end());
            // Lights that are seen edge-on have rows that rounding moves.
            EXPECT_LT(errors[errors.size() * 98 / 100], 2e-3) << static_cast<int>(kind) << ' ' << static_cast<int>(set);
        }
    }
}

} // namespace
