// A clear coat over every base: its albedo from both sides, and what it leaves of what is below.
#include <gonio/shading/brdf.hpp>
#include <gonio/shading/coat.hpp>
#include <gonio/shading/coated.hpp>
#include <gonio/shading/furnace.hpp>

#include "../scaled.hpp"
#include "brdf_cases.hpp"
#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace {

using namespace gonio::shading;
using brdf_cases::coated;
using gonio::shading::directional_albedo;
using Vec = vec3<double>;

constexpr double cosines[] = {1e-3, 0.01, 0.05, 0.1, 0.3, 0.6, 1.0};
constexpr double smoothnesses[] = {1.0, 0.9, 0.7, 0.5, 0.2, 0.0};
constexpr double quadrature = 6e-5;
constexpr double polynomial = 1.3e-3; // of the coat's albedo: ggx_mean_cosine_coefficients.hpp
constexpr Vec white{1.0, 1.0, 1.0};

template<class Material>
double albedo(const Material& material, double mu) {
    return directional_albedo(material, mu, lobe_alpha(material)).x;
}

TEST(GgxAlbedo, IsTheIntegral) {
    for (const double root : {0.01, 0.03, 0.1, 0.25, 0.5, 0.75, 1.0}) {
        const double alpha = root * root;
        const GgxAlbedo<double> table = ggx_albedo(alpha);
        for (const double f0 : {0.0, 0.04, 0.5, 1.0})
            for (const double mu : cosines)
                EXPECT_NEAR(table(mu, f0, 1.0), albedo(Ggx<double>{{f0, f0, f0}, alpha}, mu), polynomial + quadrature)
                    << root << ' ' << f0 << ' ' << mu;
    }
}

// A = ∫ (1 − Fc) and B = ∫ Fc, Fc = (1 − v·h)⁵, integrated over h in polar coordinates by adaptive quadrature in
// Python.
TEST(GgxAlbedo, OfTheDfgTable) {
    struct Row {
        double r, mu, a, b;
    };
    for (const Row& row : {Row{0.1, 0.05, 0.242548, 0.733660},
                           {0.1, 0.5, 0.968339, 0.031403},
                           {0.25, 0.2, 0.681494, 0.264780},
                           {0.5, 0.2, 0.749895, 0.098265},
                           {0.75, 0.05, 0.839807, 0.065119},
                           {1.0, 0.5, 0.447705, 0.002989}}) {
        const GgxAlbedo<double> table = ggx_albedo(row.r * row.r);
        EXPECT_NEAR(table(row.mu, 0.0, 1.0), row.b, polynomial) << row.r << ' ' << row.mu;
        EXPECT_NEAR(table(row.mu, 1.0, 1.0), row.a + row.b, 6e-5) << row.r << ' ' << row.mu;
    }
    EXPECT_NEAR(ggx_albedo(0.01).mean(0.04, 1.0), 0.085166, 5e-4);
    EXPECT_NEAR(ggx_albedo(0.25).mean(0.04, 1.0), 0.053224, 5e-4);
}

// Against E/(A + B) over r and n·v in steps of 0.05: the errors that the published formula has.
TEST(GgxAlbedo, RememberMeFresnelIsNearTheIntegral) {
    double squares = 0.0;
    double largest = 0.0;
    double schlick = 0.0;
    int count = 0;
    for (int i = 2; i <= 20; ++i) {
        const double r = 0.05 * i;
        const GgxAlbedo<double> table = ggx_albedo(r * r);
        for (int k = 1; k <= 20; ++k) {
            const double mu = 0.05 * k;
            const double error = glossy_fresnel_remember_me(0.04, r, mu) - glossy_fresnel(table, 0.04, mu);
            squares += error * error;
            largest = std::max(largest, std::fabs(error));
            const double plain = 0.04 + 0.96 * schlick_weight(mu) - glossy_fresnel(table, 0.04, mu);
            schlick += plain * plain;
            ++count;
        }
    }
    EXPECT_NEAR(std::sqrt(squares / count), 0.034, 0.003);
    EXPECT_NEAR(largest, 0.19, 0.01);
    EXPECT_GT(std::sqrt(schlick / count), 3.0 * std::sqrt(squares / count));
    EXPECT_DOUBLE_EQ(glossy_fresnel_remember_me(0.5, 0.8, 0.0), 0.5); // never below F0
}

TEST(Coat, OverWhiteLambertGivesBackAll) {
    for (const double smoothness : smoothnesses)
        for (const double amount : {0.25, 1.0})
            for (const double mu : cosines)
                EXPECT_NEAR(albedo(coated(Lambert<double>{white}, amount, smoothness), mu), 1.0, polynomial)
                    << smoothness << ' ' << amount << ' ' << mu;
}

// The closed form for a black to white matte base: E(v) + (1 − E(v)) ρ (1 − Ē)/(1 − Ē ρ).
TEST(Coat, OverGreyLambert) {
    for (const double rho : {0.0, 0.2, 0.8}) {
        const auto material = coated(Lambert<double>{{rho, rho, rho}}, 1.0, 0.9);
        const double mean = material.coat.albedo.mean(0.04, 1.0);
        for (const double mu : cosines) {
            const double e = coat_albedo(material.coat, mu);
            EXPECT_NEAR(albedo(material, mu), e + (1.0 - e) * rho * (1.0 - mean) / (1.0 - mean * rho), polynomial)
                << rho << ' ' << mu;
        }
    }
}

// A mirror below a mirror: E + (1 − E)² F/(1 − E F).
TEST(Coat, OverAMirror) {
    for (const double f0 : {0.2, 0.6, 1.0}) {
        const auto material = coated(Ggx<double>{{f0, f0, f0}, 1e-4}, 1.0, 1.0);
        for (const double mu : {0.1, 0.3, 0.6, 1.0}) {
            const double e = coat_albedo(material.coat, mu);
            const double f = f0 + (1.0 - f0) * schlick_weight(mu);
            EXPECT_NEAR(albedo(material, mu), e + (1.0 - e) * (1.0 - e) * f / (1.0 - e * f), 2e-3) << f0 << ' ' << mu;
        }
    }
}

template<class Visit>
void each_white_base(const Visit& visit) {
    for (const double r : {0.0, 0.5, 1.0}) {
        const auto name = [r](const char* kind) { return fmt::format("{} {}", kind, r); };
        visit(name("lambert"), Lambert<double>{white});
        visit(name("eon"), Eon<double>{white, r});
        visit(name("ggx"), Ggx<double>{white, r * r});
        visit(name("kulla-conty"), kulla_conty_material(white, r * r));
        visit(name("frostbite"), frostbite_material(white, 1.0 - r, 0.0, 0.5));
        visit(name("frostbite metal"), frostbite_material(white, 1.0 - r, 1.0, 0.5));
        visit(name("ue4"), ue4_material(white, 0.0, r, 0.5, 1.0));
        visit(name("ue4 metal"), ue4_material(white, 1.0, r, 0.5, 1.0));
        visit(name("gltf"), gltf_material(white, 0.0, r));
        visit(name("blinn"), blinn_material(white, Vec{0.04, 0.04, 0.04}, 1.0 - r, 0.0));
    }
}

// The base's own albedo A ≤ 1: not above 1 below any coat. A > 1: above 1 by no more than before.
TEST(Coat, GainsNothingOverAnyBase) {
    each_white_base([](const std::string& name, const auto& base) {
        for (const double mu : {0.01, 0.1, 0.3, 0.6, 1.0}) {
            if (gonio::test::is_sanitized && mu > 0.1) break;
            const double alone = albedo(base, mu);
            for (const double smoothness : {1.0, 0.5}) {
                const auto material = coated(base, 1.0, smoothness);
                const double e = coat_albedo(material.coat, mu);
                EXPECT_LE(albedo(material, mu), 1.0 + (1.0 - e) * std::max(alone - 1.0, 0.0) + 2e-3)
                    << name << ", " << smoothness << ", " << mu;
            }
        }
    });
}

// What a base that gives back all light loses below the coat, at most.
TEST(Coat, LosesLittleOverBasesThatKeepAll) {
    const double fewest[] = {0.975, 0.95};
    for (const double r : {0.1, 0.5, 1.0})
        for (const double smoothness : smoothnesses)
            for (const double mu : cosines) {
                EXPECT_GT(albedo(coated(Eon<double>{white, r}, 1.0, smoothness), mu), fewest[0])
                    << r << ' ' << smoothness << ' ' << mu;
                EXPECT_GT(albedo(coated(kulla_conty_material(white, r * r), 1.0, smoothness), mu), fewest[1])
                    << r << ' ' << smoothness << ' ' << mu;
            }
}

// Over white Lambert with a smooth coat at n·v = 1, 0.5 and 0.1, by an independent quadrature in Python.
TEST(Coat, OrdersOfOneFacetGainEnergy) {
    struct Row {
        CoatOrder order;
        double expected[3];
    };
    for (const Row& row :
         {Row{CoatOrder::filament, {0.999917, 1.025378, 1.534820}}, {CoatOrder::ue4, {0.961445, 0.982827, 1.481031}}}) {
        const auto material = coated(Lambert<double>{white}, 1.0, 0.9, row.order);
        EXPECT_NEAR(albedo(material, 1.0), row.expected[0], 1e-4);
        EXPECT_NEAR(albedo(material, 0.5), row.expected[1], 1e-4);
        EXPECT_NEAR(albedo(material, 0.1), row.expected[2], 1e-4);
    }
}

TEST(Coat, OfAmountZeroIsTheBase) {
    const Vec n{0.0, 0.0, 1.0};
    poses::Random random(7);
    each_white_base([&](const std::string& name, const auto& base) {
        const auto material = coated(base, 0.0, 0.9);
        for (int i = 0; i < 50; ++i) {
            const Vec l = poses::tilted(n, random.uniform(), random);
            const Vec v = poses::tilted(n, random.uniform(), random);
            const double expected = brdf(base, n, l, v).x;
            EXPECT_NEAR(brdf(material, n, l, v).x, expected, 1e-12 * expected) << name;
        }
    });
}

// The type for bases named at run time is the same material.
TEST(Coat, CoatedFollowsItsBase) {
    const Vec n{0.0, 0.0, 1.0};
    poses::Random random(8);
    each_white_base([&](const std::string& name, const auto& base) {
        const auto typed = coated(base, 0.7, 0.6);
        const Coated named = coated_material(base, 0.7, 0.6, CoatOrder::physical);
        EXPECT_EQ(lobe_alpha(named), lobe_alpha(typed)) << name;
        for (int i = 0; i < 20; ++i) {
            const Vec l = poses::tilted(n, random.uniform(), random);
            const Vec v = poses::tilted(n, random.uniform(), random);
            const Vec u{random.uniform(), random.uniform(), random.uniform()};
            EXPECT_EQ(brdf(named, n, l, v).y, brdf(typed, n, l, v).y) << name;
            EXPECT_EQ(pdf_brdf(named, n, v, l), pdf_brdf(typed, n, v, l)) << name;
            EXPECT_EQ(sample_brdf(named, n, v, u).l.x, sample_brdf(typed, n, v, u).l.x) << name;
            const double parts = coat_part(named, n, l, v).y + base_specular_part(named, n, l, v).y;
            const double whole = specular_part(named, n, l, v, 0.0).y;
            EXPECT_NEAR(parts, whole, 1e-12 * whole) << name;
            EXPECT_EQ(brdf(diffuse_alone(named), n, l, v).y, diffuse_part(named, n, l, v).y) << name;
        }
    });
}

} // namespace
