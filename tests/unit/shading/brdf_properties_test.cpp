// Properties of every material, for all parameters and directions.
#include <gonio/shading/brdf.hpp>
#include <gonio/simd/baseline.hpp>

#include "brdf_cases.hpp"
#include "poses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace {

using namespace gonio::shading;
using brdf_cases::to;
using poses::Random;
using poses::Vec;

double largest(Vec f) {
    return std::fmax(f.x, std::fmax(f.y, f.z));
}

TEST(Brdf, IsReciprocal) {
    brdf_cases::each([](const std::string& name, const auto& make) {
        const auto material = make(double());
        Random random(41);
        for (int i = 0; i < 2'000; ++i) {
            const Vec n = poses::random_direction(random);
            const Vec l = poses::tilted(n, std::pow(random.uniform(), 4.0), random);
            const Vec v = poses::tilted(n, std::pow(random.uniform(), 4.0), random);
            const Vec a = brdf(material, n, l, v);
            const Vec b = brdf(material, n, v, l);
            ASSERT_NEAR(a.x, b.x, 1e-12 * a.x) << name;
            ASSERT_NEAR(a.y, b.y, 1e-12 * a.y) << name;
            ASSERT_NEAR(a.z, b.z, 1e-12 * a.z) << name;
        }
    });
}

TEST(Brdf, IsZeroBelowTheSurfaceAndInIt) {
    const Vec n{0, 0, 1};
    const Vec above{0.6, 0.0, 0.8};
    brdf_cases::each([&](const std::string& name, const auto& make) {
        const auto material = make(double());
        for (const Vec below :
             {Vec{0.6, 0.0, -0.8}, Vec{1.0, 0.0, 0.0}, Vec{0.0, 0.0, -1.0}, Vec{-0.6, 0.0, -0.8}, Vec{0, 1, -1e-30}}) {
            EXPECT_EQ(largest(brdf(material, n, above, below)), 0.0) << name;
            EXPECT_EQ(largest(brdf(material, n, below, above)), 0.0) << name;
            EXPECT_EQ(largest(brdf(material, n, below, below)), 0.0) << name;
            EXPECT_EQ(pdf_brdf(material, n, below, above), 0.0) << name;
            const auto sample = sample_brdf(material, n, below, {0.3, 0.6, 0.9});
            EXPECT_EQ(sample.pdf, 0.0) << name;
            EXPECT_TRUE(std::isfinite(dot(sample.l, sample.l))) << name;
        }
    });
}

// Directions at all distances from the surface, from each other and from the mirror direction; in S.
template<class S>
void stays_finite() {
    const S shallow[] = {S(0), S(1e-45), S(1e-38), S(1e-30), S(2e-18), S(1e-10), S(1e-6), S(1e-3), S(0.5), S(1)};
    const S numbers[] = {S(0), S(1e-20), S(0.3), S(1) - std::numeric_limits<S>::epsilon(), S(1)};
    const auto direction = [](S cosine, S phi) {
        const S sine = std::sqrt((S(1) - cosine) * (S(1) + cosine));
        return vec3<S>{sine * std::cos(phi), sine * std::sin(phi), cosine};
    };
    const vec3<S> n{S(0), S(0), S(1)};
    brdf_cases::each([&](const std::string& name, const auto& make) {
        const auto material = make(S());
        const auto good = [](S x) { return x >= S(0) && x <= std::numeric_limits<S>::max(); };
        for (const S c : shallow)
            for (const S d : shallow)
                for (const S phi : {S(0), S(1e-4), S(1.5), S(3.14159265358979323846)}) {
                    const vec3<S> v = direction(c, S(0));
                    const vec3<S> l = direction(d, phi);
                    const vec3<S> f = brdf(material, n, l, v);
                    ASSERT_TRUE(good(f.x) && good(f.y) && good(f.z)) << name << ' ' << c << ' ' << d << ' ' << phi;
                    ASSERT_TRUE(good(pdf_brdf(material, n, v, l))) << name << ' ' << c << ' ' << d << ' ' << phi;
                    ASSERT_TRUE(good(pdf_brdf(material, n, v, l * S(-1)))) << name << ' ' << c << ' ' << d;
                }
        for (const S c : shallow)
            for (const S u0 : numbers)
                for (const S u1 : numbers)
                    for (const S u2 : {S(0), S(0.95)}) {
                        const auto sample = sample_brdf(material, n, direction(c, S(0)), {u0, u1, u2});
                        ASSERT_TRUE(good(sample.pdf)) << name << ' ' << c << ' ' << u0 << ' ' << u1;
                        ASSERT_NEAR(dot(sample.l, sample.l), S(1), S(1e-5))
                            << name << ' ' << c << ' ' << u0 << ' ' << u1;
                    }
    });
}
TEST(Brdf, IsFiniteAndNotNegativeInFloat) {
    stays_finite<float>();
}
TEST(Brdf, IsFiniteAndNotNegativeInDouble) {
    stays_finite<double>();
}

// Rounding directions to float turns a half vector by 1e-7, which does not matter for a wide lobe but changes a narrow
// one by its slope; both precisions use the same float directions.
TEST(Brdf, FloatFollowsDouble) {
    brdf_cases::each([](const std::string& name, const auto& make) {
        const auto precise = make(double());
        const auto fast = make(float());
        Random random(43);
        const Vec n{0, 0, 1};
        double worst = 0.0;
        for (int i = 0; i < 2'000; ++i) {
            const Vec v = poses::tilted(n, random.uniform(0.02, 1.0), random);
            const auto u = to<float>({random.uniform(), random.uniform(), random.uniform()});
            const auto view = to<float>(v);
            const auto l = sample_brdf(fast, to<float>(n), view, u).l;
            const Vec exact_view{view.x, view.y, view.z};
            const Vec exact_l{l.x, l.y, l.z};
            if (!(exact_l.z > 1e-3)) continue;
            const Vec truth = brdf(precise, n, exact_l, exact_view);
            const auto value = brdf(fast, to<float>(n), l, view);
            const double pdf = pdf_brdf(precise, n, exact_view, exact_l);
            worst = std::fmax(worst, std::fabs(value.z - truth.z) / (truth.z + 1e-6));
            worst = std::fmax(worst, std::fabs(pdf_brdf(fast, to<float>(n), view, l) - pdf) / (pdf + 1e-6));
        }
        EXPECT_LT(worst, 2e-5 + 1.5e-6 / brdf_cases::least_alpha(precise)) << name;
        EXPECT_GT(worst, 0.0) << name;
    });
}

using Pack = gonio::simd::Baseline;

// Lane by lane, a pack equals the float, up to the rounding of operations that may be fused.
TEST(Brdf, PackFollowsFloat) {
    brdf_cases::each([](const std::string& name, const auto& make) {
        const auto wide = make(Pack());
        const auto narrow = make(float());
        const double bar = 2e-5 + 1e-6 / static_cast<double>(lobe_alpha(narrow));
        Random random(47);
        for (int i = 0; i < 300; ++i) {
            float in[9][Pack::lanes];
            vec3<float> v[Pack::lanes];
            vec3<float> u[Pack::lanes];
            for (std::size_t k = 0; k < Pack::lanes; ++k) {
                v[k] = to<float>(poses::tilted({0, 0, 1}, random.uniform(-0.1, 1.0), random));
                u[k] = to<float>({random.uniform(), random.uniform(), random.uniform()});
                const float values[] = {v[k].x, v[k].y, v[k].z, u[k].x, u[k].y, u[k].z};
                for (std::size_t j = 0; j < 6; ++j)
                    in[j][k] = values[j];
            }
            Pack loaded[6];
            for (std::size_t j = 0; j < 6; ++j)
                gonio::simd::load(&in[j][0], loaded[j]);
            const vec3<Pack> n{Pack(0), Pack(0), Pack(1)};
            const vec3<Pack> views{loaded[0], loaded[1], loaded[2]};
            const auto sample = sample_brdf(wide, n, views, {loaded[3], loaded[4], loaded[5]});
            const vec3<Pack> f = brdf(wide, n, sample.l, views);
            const Pack out[] = {sample.l.x, sample.l.y, sample.l.z, sample.pdf, f.x, f.z};
            for (std::size_t j = 0; j < 6; ++j)
                gonio::simd::store(out[j], &in[j][0]);
            for (std::size_t k = 0; k < Pack::lanes; ++k) {
                const vec3<float> up{0, 0, 1};
                const vec3<float> l{in[0][k], in[1][k], in[2][k]};
                const auto one = sample_brdf(narrow, up, v[k], u[k]);
                ASSERT_NEAR(l.x, one.l.x, 1e-5F) << name;
                ASSERT_NEAR(l.y, one.l.y, 1e-5F) << name;
                ASSERT_NEAR(l.z, one.l.z, 1e-5F) << name;
                // At the pack's own direction, since the last digit of a direction matters to a narrow lobe.
                const float pdf = pdf_brdf(narrow, up, v[k], l);
                const vec3<float> value = brdf(narrow, up, l, v[k]);
                ASSERT_NEAR(in[3][k], pdf, bar * pdf + 1e-9) << name;
                ASSERT_NEAR(in[4][k], value.x, bar * value.x + 1e-9) << name;
                ASSERT_NEAR(in[5][k], value.z, bar * value.z + 1e-9) << name;
            }
        }
    });
}

TEST(Blinn, WaterDarkensPoresAndSmoothsAll) {
    const Vec albedo{0.5, 0.4, 0.3};
    const Vec stone{0.04, 0.04, 0.04};
    const auto power = [](const Blinn<double>& m) { return (std::log2(m.power) - 1.0) / 10.0; };
    const auto dry = blinn_material<double>(albedo, stone, 0.0, 0.0);
    EXPECT_DOUBLE_EQ(dry.albedo.x, 0.5);
    EXPECT_DOUBLE_EQ(dry.power, 2.0);
    const auto wet = blinn_material<double>(albedo, stone, 0.0, 1.0); // the pores are full: a fifth of the albedo
    EXPECT_DOUBLE_EQ(wet.albedo.x, 0.1);
    EXPECT_NEAR(power(wet), 0.4, 1e-12);                               // 1 + (0 − 1)·(1 − 0.5·0.8)
    const auto half = blinn_material<double>(albedo, stone, 0.3, 0.5); // porosity ½, factor 0.6
    EXPECT_NEAR(half.albedo.y, 0.4 * 0.8, 1e-12);
    EXPECT_NEAR(power(half), 1.0 - 0.7 * 0.9, 1e-12);
    const auto smooth = blinn_material<double>(albedo, stone, 0.5, 1.0); // no pores for smoothness ½ and above
    EXPECT_DOUBLE_EQ(smooth.albedo.x, 0.5);
    EXPECT_NEAR(power(smooth), 0.5, 1e-12);
    const auto metal = blinn_material<double>(albedo, {0.9, 0.9, 0.9}, 0.0, 1.0);
    EXPECT_DOUBLE_EQ(metal.albedo.x, 0.5);
}

TEST(Ue4, MapsItsParameters) {
    const auto plastic = ue4_material<double>({0.5, 0.25, 0.125}, 0.0, 0.4, 0.5, 1.0);
    EXPECT_DOUBLE_EQ(plastic.f0.y, 0.04);
    EXPECT_DOUBLE_EQ(plastic.albedo.y, 0.25);
    EXPECT_DOUBLE_EQ(plastic.alpha, 0.16);
    const auto gold = ue4_material<double>({1.0, 0.77, 0.34}, 1.0, 0.0, 0.5, 0.5);
    EXPECT_DOUBLE_EQ(gold.f0.y, 0.77);
    EXPECT_EQ(gold.albedo.x, 0.0);
    EXPECT_EQ(gold.alpha, minimum_alpha);
    // A cavity reduces both parts.
    const Vec n{0, 0, 1};
    const auto open = ue4_material<double>({0.5, 0.5, 0.5}, 0.0, 0.4, 0.5, 1.0);
    const auto hollow = ue4_material<double>({0.5, 0.5, 0.5}, 0.0, 0.4, 0.5, 0.25);
    EXPECT_DOUBLE_EQ(brdf(hollow, n, n, n).x, 0.25 * brdf(open, n, n, n).x);
    EXPECT_DOUBLE_EQ(brdf(hollow, n, {0.6, 0, 0.8}, n).x, 0.25 * brdf(open, n, {0.6, 0, 0.8}, n).x);
}

// The code of the specification's appendix B, verbatim, next to ours.
TEST(Gltf, IsTheMixOfItsSpecification) {
    Random random(57);
    const Vec n{0, 0, 1};
    const auto mix = [](double a, double b, double share) { return a * (1.0 - share) + b * share; };
    for (int i = 0; i < 5'000; ++i) {
        const Vec l = poses::tilted(n, random.uniform(0.01, 1.0), random);
        const Vec v = poses::tilted(n, random.uniform(0.01, 1.0), random);
        const double base = random.uniform();
        const double metallic = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 1.0 : random.uniform();
        const double roughness = random.uniform(0.3, 1.0); // the appendix' D cancels for less
        const Vec h = poses::unit(l + v);
        const double a2 = std::pow(roughness, 4.0);
        const double n_dot_l = dot(n, l);
        const double n_dot_v = dot(n, v);
        const double d = a2 / (std::acos(-1.0) * std::pow(dot(n, h) * dot(n, h) * (a2 - 1.0) + 1.0, 2.0));
        const double visible = 0.5 / (n_dot_v * std::sqrt(a2 + (1.0 - a2) * n_dot_l * n_dot_l) +
                                      n_dot_l * std::sqrt(a2 + (1.0 - a2) * n_dot_v * n_dot_v));
        const double fresnel_w = std::pow(1.0 - std::fabs(dot(v, h)), 5.0);
        const double diffuse_brdf = base / std::acos(-1.0);
        const double specular_brdf = visible * d;
        const double dielectric_brdf = mix(diffuse_brdf, specular_brdf, 0.04 + (1.0 - 0.04) * fresnel_w);
        const double metal_brdf = (base + (1.0 - base) * fresnel_w) * specular_brdf;
        const double expected = mix(dielectric_brdf, metal_brdf, metallic);
        const auto material = gltf_material<double>({base, 1.0, 0.0}, metallic, roughness);
        EXPECT_NEAR(brdf(material, n, l, v).x, expected, 1e-12 * expected) << i;
    }
}

TEST(Gltf, MapsItsParameters) {
    const auto plastic = gltf_material<double>({0.5, 0.25, 0.125}, 0.0, 0.4);
    EXPECT_DOUBLE_EQ(plastic.f0.y, 0.04);
    EXPECT_DOUBLE_EQ(plastic.albedo.y, 0.25);
    EXPECT_DOUBLE_EQ(plastic.alpha, 0.16);
    const auto gold = gltf_material<double>({1.0, 0.77, 0.34}, 1.0, 0.0);
    EXPECT_DOUBLE_EQ(gold.f0.y, 0.77);
    EXPECT_EQ(gold.albedo.x, 0.0);
    EXPECT_EQ(gold.alpha, minimum_alpha);
    // Without its lobe, the input is unchanged.
    const Vec n{0, 0, 1};
    const Vec v{0.6, 0, 0.8};
    EXPECT_EQ(brdf(diffuse_alone(plastic), n, v, n).x, diffuse_part(plastic, n, v, n).x);
}

// Hand-worked values: along the normal, where every angle is 0.
TEST(Brdf, AlongTheNormal) {
    const Vec n{0, 0, 1};
    const double inv_pi = 1.0 / std::acos(-1.0);
    EXPECT_NEAR(brdf(Ggx<double>{{0.5, 1, 0}, 0.5}, n, n, n).x, 0.5 * inv_pi / 0.25 / 4.0, 1e-14); // f0 D/4
    const auto shiny = blinn_material<double>({0, 0, 0}, {1, 1, 1}, 0.5, 0.0);                     // p = 64
    EXPECT_NEAR(brdf(shiny, n, n, n).y, 66.0 * inv_pi / 8.0, 1e-12);
    EXPECT_NEAR(brdf(Eon<double>{{0.5, 0.5, 0.5}, 0.0}, n, n, n).x, 0.5 * inv_pi, 1e-15);
    // r = 1: A = 1/(1 + 1/2 − 2/3π); the light lost along the normal scatters again, with half of it returned at each
    // bounce.
    const double a = 1.0 / (1.5 - 2.0 * inv_pi / 3.0);
    const double mean = a * (1.0 + 2.0 / 3.0 - 28.0 * inv_pi / 15.0);
    const double multiple = 0.5 * mean / (1.0 - 0.5 * (1.0 - mean)) * (1.0 - a) * (1.0 - a) / (1.0 - mean);
    EXPECT_NEAR(brdf(Eon<double>{{0.5, 0.5, 0.5}, 1.0}, n, n, n).x, 0.5 * inv_pi * (a + multiple), 1e-14);
}

} // namespace
