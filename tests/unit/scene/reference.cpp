// The reference integrator against stored values of another program, quadrature over the light's surface, closed forms,
// and its own result at higher convergence.
#include <gonio/measure/random.hpp>
#include <gonio/scene/detail/polar_cubature.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/reference.hpp>
#include <gonio/shading/brdf_ggx.hpp>
#include <gonio/web/web.hpp>

#include "../reference_rows.hpp"
#include "reference_cases.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace gonio {
namespace {

constexpr double pi = std::numbers::pi;
const glm::dvec3 origin{0.0};

// GGX with roughness α and a reflectance of 1.
Material mirror(double alpha) {
    FrostbiteMaterial material;
    material.base = glm::dvec3(1.0);
    material.metal = 1.0;
    material.smoothness = 1.0 - std::sqrt(alpha);
    return material;
}

struct Row {
    std::string kind;
    glm::dvec3 center, axis, across, normal, view;
    double p = 0.0, q = 0.0, alpha = 0.0, luminance = 0.0;
};

std::vector<Row> stored_rows() {
    std::vector<Row> rows;
    for (const auto& [kind, v] : test::specular_rows())
        rows.push_back({kind,
                        {v[0], v[1], v[2]},
                        {v[3], v[4], v[5]},
                        {v[6], v[7], v[8]},
                        {v[11], v[12], v[13]},
                        {v[14], v[15], v[16]},
                        v[9],
                        v[10],
                        v[17],
                        v[18]});
    return rows;
}

Light light_of(const Row& row) {
    Light light;
    light.color = {1.0, 1.0, 1.0};
    light.luminance = Nits(1.0);
    if (row.kind == "sphere") {
        light.shape = SphereShape{Meters(row.p)};
    } else if (row.kind == "disk") {
        light.shape = DiskShape{Meters(row.p)};
        light.frame = aimed_frame({}, row.axis, {0.0, 1.0, 0.0});
    } else if (row.kind == "rect") {
        light.shape = RectShape{Meters(row.p), Meters(row.q)};
        light.frame.z = -row.axis;
        light.frame.x = row.across;
        light.frame.y = glm::cross(light.frame.z, light.frame.x);
    } else {
        light.shape = TubeShape{Meters(row.p), Meters(row.q)};
        light.frame.x = row.axis;
    }
    light.frame.origin = row.center;
    return light;
}

double specular(const Row& row, double error) {
    return reference_luminance(light_of(row), origin, row.normal, row.view, mirror(row.alpha), {error, 4'000'000})
        .specular.value;
}

TEST(Reference, StoredSpeculars) {
    const std::vector<Row> rows = stored_rows();
    ASSERT_EQ(rows.size(), 240U);
    std::size_t off = 0;
    double worst = 0.0;
    for (const Row& row : rows) {
        const double value = specular(row, 1e-8);
        // One row, a short capsule of which only the nearer sphere is visible, is stored 1.1e-4 too low: both the value
        // for that sphere and rays counted over the sky (0.852436(1)) confirm it.
        if (row.kind == "tube" && std::abs(row.luminance - 0.85234028) < 1e-12) {
            const double along = -glm::dot(row.center, row.axis);
            Row nearer = row;
            nearer.kind = "sphere";
            nearer.center = row.center + row.axis * std::copysign(0.5 * row.q, along);
            EXPECT_NEAR(value, specular(nearer, 1e-8), 1e-9);
            EXPECT_NEAR(value, 0.852436, 2e-6);
            continue;
        }
        EXPECT_NEAR(value, row.luminance, 1e-5) << row.kind;
        const double relative = std::abs(value / row.luminance - 1.0);
        off += relative > 1e-5 ? 1 : 0;
        worst = std::max(worst, relative);
    }
    RecordProperty("worst_relative", std::to_string(worst));
    // Two more rows are off by 1.1e-5 and 1.9e-5 of their value. For one of them, and for three others in the file that
    // are off by more than 1e-6, AgreesWithTheSurface checks the surface integral.
    EXPECT_LE(off, 2U);
    EXPECT_LT(worst, 2e-5);
}

// Gauss–Legendre rules of 16 nodes on `pieces` pieces.
template<class F>
double gauss(double low, double high, int pieces, F&& f) {
    constexpr std::array<double, 8> node{0.0950125098376374401, 0.2816035507792589132, 0.4580167776572273863,
                                         0.6178762444026437484, 0.7554044083550030339, 0.8656312023878317439,
                                         0.9445750230732325761, 0.9894009349916499326};
    constexpr std::array<double, 8> weight{0.1894506104550684963, 0.1826034150449235889, 0.1691565193950025382,
                                           0.1495959888165767321, 0.1246289712555338720, 0.0951585116824927848,
                                           0.0622535239386478929, 0.0271524594117540949};
    const double half = 0.5 * (high - low) / pieces;
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
        const double middle = low + (2 * i + 1) * half;
        for (std::size_t k = 0; k < 8; ++k)
            sum += weight[k] * (f(middle - half * node[k]) + f(middle + half * node[k]));
    }
    return sum * half;
}

// Over the surface of a disk or rectangle, with each strip clipped by the receiver's plane: uses no polar coordinates
// and no outline.
double over_surface(const Row& row) {
    using shading::vec3;
    const bool rect = row.kind == "rect";
    const glm::dvec3 b = rect ? row.across : glm::normalize(glm::cross(row.axis, glm::dvec3(0.31, 0.62, -0.72)));
    const glm::dvec3 d = glm::cross(row.axis, b);
    const vec3<double> n{row.normal.x, row.normal.y, row.normal.z};
    const vec3<double> v{row.view.x, row.view.y, row.view.z};
    const auto strip = [&](double x) {
        const double half = rect ? 0.5 * row.q : std::sqrt(std::max(row.p * row.p - x * x, 0.0));
        const double crossing = -glm::dot(row.normal, row.center + b * x) / glm::dot(row.normal, d);
        const bool rising = glm::dot(row.normal, d) > 0.0;
        const double low = rising ? std::max(-half, crossing) : -half;
        const double high = rising ? half : std::min(half, crossing);
        if (!(low < high)) return 0.0;
        return gauss(low, high, 40, [&](double y) {
            const glm::dvec3 p = row.center + b * x + d * y;
            const double distance2 = glm::dot(p, p);
            const glm::dvec3 l = p / std::sqrt(distance2);
            const double d_v = shading::specular_ggx(n, {l.x, l.y, l.z}, v, row.alpha, row.alpha).scale;
            return d_v * glm::dot(row.normal, l) * std::max(-glm::dot(l, row.axis), 0.0) / distance2;
        });
    };
    if (rect) return gauss(-0.5 * row.p, 0.5 * row.p, 200, strip);
    return gauss(-0.5 * pi, 0.5 * pi, 100, [&](double t) { return strip(row.p * std::sin(t)) * row.p * std::cos(t); });
}

TEST(Reference, AgreesWithTheSurface) {
    std::size_t compared = 0;
    for (const Row& row : stored_rows()) {
        if (row.kind != "disk" && row.kind != "rect") continue;
        const double value = specular(row, 1e-9);
        // Every fortieth row, and rows with a stored value further off than its stated error.
        if (compared++ % 40 != 0 && std::abs(value - row.luminance) < 1e-6 * row.luminance) continue;
        const double truth = over_surface(row);
        EXPECT_NEAR(value, truth, 2e-7 * truth) << row.kind << ' ' << row.luminance;
    }
    EXPECT_GT(compared, 0U);
}

// The closed forms of the irradiance, for outlines that are above, straddle or touch the horizon.
TEST(Reference, IlluminanceIsTheClosedForm) {
    ProbeOptions exact;
    for (unsigned i = 0; i < 600; ++i) {
        const test::ReferenceCase c = test::reference_case(i, 7);
        const Receiver receiver{origin, c.normal};
        const double closed = probe({&c.light, 1}, {&receiver, 1}, exact).value().illuminance_lx.at(0);
        const ReferenceValue e = reference_illuminance(c.light, origin, c.normal, {1e-9, 4'000'000});
        EXPECT_TRUE(e.converged);
        // Slivers of light that almost graze the horizon are ill-conditioned for both.
        EXPECT_NEAR(e.value, closed, 2e-9 * closed + 1e-14) << i << ' ' << kind_of(c.light.shape);
    }
}

// |value − value at much higher convergence| ≤ estimate. tests/bench/reference_honesty.cpp checks all 1000 cases.
TEST(Reference, EstimateHolds) {
    std::size_t asked = 0;
    std::size_t broken = 0;
    for (unsigned i = 0; i < 120; ++i) {
        const test::ReferenceCase c = test::reference_case(i, 3);
        const auto at = [&](double error) {
            return reference_luminance(c.light, origin, c.normal, c.view, c.material, {error, 4'000'000});
        };
        const ReferenceLuminance truth = at(1e-11);
        for (const double goal : {1e-2, 1e-4, 1e-6}) {
            const ReferenceLuminance got = at(goal);
            const auto check = [&](const ReferenceValue& value, const ReferenceValue& converged) {
                ++asked;
                const double slack = 1e-11 * converged.value;
                if (std::abs(value.value - converged.value) > value.error_estimate + slack) ++broken;
                EXPECT_TRUE(value.converged) << i;
                EXPECT_LE(value.error_estimate, goal * value.value) << i;
                EXPECT_LE(std::abs(value.value - converged.value), 2.0 * goal * converged.value) << i;
            };
            check(got.diffuse, truth.diffuse);
            check(got.specular, truth.specular);
        }
    }
    EXPECT_LE(broken, asked / 200) << "of " << asked;
}

Light placed(const Shape& shape, const glm::dvec3& position, const glm::dvec3& direction = {0.0, 0.0, -1.0}) {
    Light light;
    light.shape = shape;
    light.color = {1.0, 1.0, 1.0};
    light.luminance = Nits(1.0);
    light.frame = aimed_frame(position, direction, {0.0, 1.0, 0.0});
    return light;
}

const glm::dvec3 up{0.0, 0.0, 1.0};

// An almost perfect mirror shows the light's luminance where the light is, and nothing beside it.
TEST(Reference, NarrowLobesShowTheLight) {
    const glm::dvec3 view = glm::normalize(glm::dvec3(-1.0, 0.0, 1.0));
    const Material surface = mirror(1e-4);
    for (const Shape& shape :
         {Shape(SphereShape{Meters(0.3)}), Shape(DiskShape{Meters(0.3)}), Shape(RectShape{Meters(0.5), Meters(0.7)}),
          Shape(TubeShape{Meters(0.2), Meters(0.5)})}) {
        Light facing = placed(shape, {1.0, 0.0, 1.0}, glm::dvec3(-1.0, 0.0, -1.0));
        const ReferenceValue shown = reference_luminance(facing, origin, up, view, surface).specular;
        EXPECT_NEAR(shown.value, 1.0, 2e-5) << kind_of(shape);
        EXPECT_TRUE(shown.converged);
        facing.frame.origin = {1.0, 1.5, 1.0};
        const ReferenceValue beside = reference_luminance(facing, origin, up, view, surface).specular;
        EXPECT_LT(beside.value, 1e-6) << kind_of(shape);
        EXPECT_GT(beside.value, 0.0) << kind_of(shape);
    }
}

// Inside a light, and on its face, the whole hemisphere emits: the result is the directional albedo.
TEST(Reference, InsideAndTouching) {
    for (const double alpha : {0.1, 0.25, 0.5, 1.0}) {
        const Material surface = mirror(alpha);
        const auto value = [&](const Light& light) {
            return reference_luminance(light, origin, up, up, surface, {1e-9, 4'000'000}).specular.value;
        };
        const double inside = value(placed(SphereShape{Meters(1.0)}, {0.3, 0.0, 0.2}));
        EXPECT_NEAR(value(placed(TubeShape{Meters(1.0), Meters(2.0)}, {0.3, 0.0, 0.2})), inside, 1e-8);
        EXPECT_NEAR(value(placed(DiskShape{Meters(1.0)}, {0.2, 0.1, 0.0})), inside, 1e-8);
        EXPECT_NEAR(value(placed(RectShape{Meters(1.0), Meters(1.0)}, {0.2, 0.1, 0.0})), inside, 1e-8);
        EXPECT_NEAR(value(placed(SphereShape{Meters(1.0)}, {0.0, 0.0, 1.0})), inside, 1e-8);
        // Published to three digits; for α = 0.1 it is .988.
        const double known = alpha == 0.1 ? 0.988 : alpha == 0.25 ? 0.916 : alpha == 0.5 ? 0.688 : 0.307;
        EXPECT_NEAR(inside, known, 6e-4) << alpha;
    }
    // In the plane of a face, beside it: zero.
    EXPECT_EQ(reference_luminance(placed(DiskShape{Meters(1.0)}, {2.0, 0.0, 0.0}), origin, up, up, mirror(0.5))
                  .specular.value,
              0.0);
}

TEST(Reference, SeenFromBelowIsDark) {
    const Light light = placed(SphereShape{Meters(0.5)}, {0.0, 0.0, 1.0});
    for (const glm::dvec3& view : {glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(1.0, 0.0, 0.0)}) {
        const ReferenceLuminance nt = reference_luminance(light, origin, up, view, FrostbiteMaterial{});
        EXPECT_EQ(nt.diffuse.value + nt.specular.value, 0.0);
    }
}

TEST(Reference, EndsWhereItMust) {
    const Light light = placed(RectShape{Meters(1.0), Meters(1.0)}, {0.0, 0.0, 1.0});
    const ReferenceValue few = reference_luminance(light, origin, up, up, mirror(0.01), {1e-13, 8000}).specular;
    EXPECT_FALSE(few.converged);
    EXPECT_LE(few.evaluations, 8500U);
    EXPECT_GT(few.error_estimate, 0.0);
}

TEST(Reference, ParallelProbesAreTheSameBits) {
    std::vector<Light> lights;
    for (unsigned i = 0; i < 12; ++i)
        lights.push_back(test::reference_case(i, 5).light);
    std::vector<Receiver> receivers;
    for (int i = 0; i < 8; ++i)
        receivers.push_back({{0.1 * i, -0.05 * i, 0.0}, {0.1, 0.2, 1.0}});
    ProbeOptions options;
    options.method = IrradianceMethod::reference;
    options.goal.relative_error = 1e-4;
    options.view = ProbeView{{0.3, 0.4, 1.0}, FrostbiteMaterial{}};
    options.threads = 1;
    const ProbeResult one = probe(lights, receivers, options).value();
    options.threads = 4;
    const ProbeResult four = probe(lights, receivers, options).value();
    EXPECT_EQ(one.illuminance_lx, four.illuminance_lx);
    EXPECT_EQ(one.illuminance_error_lx, four.illuminance_error_lx);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        EXPECT_EQ(one.luminance[i].diffuse.value, four.luminance[i].diffuse.value);
        EXPECT_EQ(one.luminance[i].specular.value, four.luminance[i].specular.value);
        EXPECT_EQ(one.luminance[i].error_estimate.value, four.luminance[i].error_estimate.value);
        EXPECT_LE(one.luminance[i].error_estimate.value, 1e-4 * one.luminance[i].total().value);
    }
}

// For a mask: a web relative to its peak, in the light's frame.
std::shared_ptr<const Web> web_of(const std::vector<double>& planes, const std::vector<double>& gammas,
                                  const std::vector<double>& candela) {
    return std::make_shared<const Web>(
        Web::create(planes.size() == 1 ? Symmetry::axial : Symmetry::none, planes, gammas, candela).value());
}

Light masked(Light light, const std::shared_ptr<const Web>& mask, double peak_cd) {
    std::visit(
        [&](auto& shape) {
            if constexpr (requires { shape.mask; }) shape.mask = mask;
        },
        light.shape);
    light.web_scale = 1.0 / peak_cd;
    return light;
}

TEST(Reference, AConstantMaskChangesNothing) {
    const auto mask = web_of({0.0}, {0.0, 180.0}, {5.0, 5.0});
    for (unsigned i = 0; i < 40; ++i) {
        const test::ReferenceCase c = test::reference_case(i, 9);
        const Light behind = masked(c.light, mask, 5.0);
        EXPECT_NEAR(reference_illuminance(behind, origin, c.normal).value,
                    reference_illuminance(c.light, origin, c.normal).value, 1e-12);
        const auto bare = reference_luminance(c.light, origin, c.normal, c.view, c.material).specular.value;
        EXPECT_NEAR(reference_luminance(behind, origin, c.normal, c.view, c.material).specular.value, bare,
                    1e-12 * bare + 1e-300);
    }
}

// Over the area of a rectangle, each point's luminance scaled by the mask towards the receiver: midpoints, no solid
// angle.
TEST(Reference, AMaskModulatesEveryPoint) {
    const auto mask =
        web_of({0.0, 90.0, 200.0, 300.0, 360.0}, {0.0, 20.0, 70.0, 90.0},
               {8.0, 9.0, 3.0, 1.0, 8.0, 10.0, 5.0, 2.0, 8.0, 6.0, 2.0, 0.0, 8.0, 7.0, 7.0, 1.0, 8.0, 9.0, 3.0, 1.0});
    const Light light =
        masked(placed(RectShape{Meters(1.2), Meters(0.7)}, {0.3, -0.2, 0.8}, {0.2, 0.3, -1.0}), mask, 10.0);
    const glm::dvec3 n = glm::normalize(glm::dvec3(0.2, 0.1, 1.0));
    constexpr int steps = 600;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const glm::dvec3 p = light.frame.origin + light.frame.x * (1.2 * ((i + 0.5) / steps - 0.5)) +
                                 light.frame.y * (0.7 * ((k + 0.5) / steps - 0.5));
            const double d2 = glm::dot(p, p);
            const glm::dvec3 l = p / std::sqrt(d2);
            sum += std::max(glm::dot(n, l), 0.0) * std::max(glm::dot(l, light.frame.z), 0.0) / d2 * light.web_scale *
                   mask->candela(light.frame.to_local(-l));
        }
    sum *= 1.2 * 0.7 / (double{steps} * steps);
    const ReferenceValue e = reference_illuminance(light, origin, n, {1e-6, 4'000'000});
    EXPECT_TRUE(e.converged);
    EXPECT_NEAR(e.value, sum, 3e-6 * sum);
    // For a fine goal the mask is looked up direction by direction, and not many at once.
    const ReferenceValue fine = reference_illuminance(light, origin, n, {1e-11, 40'000'000});
    EXPECT_TRUE(fine.converged);
    EXPECT_NEAR(e.value, fine.value, 1e-6 * fine.value);
    EXPECT_NEAR(reference_illuminance(light, origin, n, {1e-10, 40'000'000}).value, fine.value, 1e-10 * fine.value);
    // `exact` has no closed form here and integrates too; the other methods take the mask from the centre.
    const Receiver receiver{origin, n};
    ProbeOptions options;
    EXPECT_NEAR(probe({&light, 1}, {&receiver, 1}, options).value().illuminance_lx[0], sum, 4e-6 * sum);
    options.method = IrradianceMethod::ltc;
    EXPECT_NEAR(probe({&light, 1}, {&receiver, 1}, options).value().illuminance_lx[0], sum, 0.2 * sum);
}

// In the plane of a flat light rounding alone says on which side a receiver lies.
TEST(Reference, InThePlaneOfALightIsDark) {
    const auto mask = web_of({0.0}, {0.0, 180.0}, {5.0, 4.0});
    const glm::dvec3 direction{0.9, 0.1, -1.0};
    const glm::dvec3 center{-0.6, 0.4, 0.8};
    const std::array lights{
        masked(placed(RectShape{Meters(0.6), Meters(0.3), true}, center, direction), mask, 5.0),
        masked(placed(DiskShape{Meters(0.4), true}, center, direction), mask, 5.0),
    };
    for (const Light& light : lights)
        for (unsigned i = 0; i < 400; ++i) {
            const double angle = 0.31 * i;
            const double away = 1.0 + 0.01 * i;
            const glm::dvec3 position =
                center + away * (std::cos(angle) * light.frame.x + std::sin(angle) * light.frame.y);
            const glm::dvec3 normal = glm::normalize(center - position + 0.2 * light.frame.z);
            // Within 1e-12 of their distance beside it they see 1e-12 of it.
            const double near_plane = i % 40 == 0 ? 1e-12 : 0.0;
            const ReferenceValue lux = reference_illuminance(light, position + near_plane * light.frame.z, normal);
            EXPECT_LE(lux.value, 1e-11 * light.luminance.value) << "point " << i;
        }
}

// From far away a masked light is a point with its intensity.
TEST(Reference, AMaskedLightIsItsIntensityFromFar) {
    const auto mask = web_of({0.0}, {0.0, 40.0, 120.0, 180.0}, {4.0, 10.0, 2.0, 0.0});
    for (const Shape& shape :
         {Shape(SphereShape{Meters(0.3)}), Shape(DiskShape{Meters(0.3)}), Shape(RectShape{Meters(0.5), Meters(0.7)}),
          Shape(TubeShape{Meters(0.05), Meters(0.5)})}) {
        Light light = masked(placed(shape, {0.0, 0.0, 0.0}), mask, 10.0);
        const glm::dvec3 away = glm::normalize(glm::dvec3(0.5, 0.3, -1.0));
        const double shown = std::visit(
            [&](const auto& s) {
                if constexpr (requires { s.width; })
                    return s.width.value * s.height.value;
                else if constexpr (requires { s.length; })
                    return s.radius.value * (2.0 * s.length.value + pi * s.radius.value);
                else if constexpr (requires { s.radius; })
                    return pi * s.radius.value * s.radius.value;
                else
                    return 0.0;
            },
            shape);
        light.intensity = Candelas(shown);
        const double d = 2000.0;
        const double lx = reference_illuminance(light, away * d, -away).value;
        EXPECT_NEAR(lx * d * d / light.intensity_towards(away).value, 1.0, 1e-6) << kind_of(shape);
    }
}

// A grid of `planes` by `gammas` cells over all directions, with random intensities up to 10 cd.
std::shared_ptr<const Web> random_web(unsigned planes, unsigned gammas, std::uint64_t seed) {
    measure::Random random(seed);
    std::vector<double> c;
    std::vector<double> gamma;
    std::vector<double> candela;
    for (unsigned i = 0; i <= planes; ++i)
        c.push_back(360.0 * i / planes);
    for (unsigned i = 0; i <= gammas; ++i)
        gamma.push_back(180.0 * i / gammas);
    for (unsigned i = 0; i < planes * (gammas + 1); ++i)
        candela.push_back(random.uniform(0.0, 10.0));
    for (unsigned i = 0; i <= gammas; ++i) // C360 is C0
        candela.push_back(candela[i]);
    return web_of(c, gamma, candela);
}

// Each cell divided into n by n: the same light.
std::shared_ptr<const Web> divided(const Web& web, int n) {
    const auto finer = [n](std::span<const double> angles) {
        std::vector<double> found{angles.front()};
        for (std::size_t i = 1; i < angles.size(); ++i)
            for (int k = 1; k <= n; ++k)
                found.push_back(angles[i - 1] + (angles[i] - angles[i - 1]) * k / n);
        return found;
    };
    const std::vector<double> planes = finer(web.planes_deg());
    const std::vector<double> gammas = finer(web.gammas_deg());
    std::vector<double> candela;
    for (const double c : planes)
        for (const double gamma : gammas)
            candela.push_back(web.candela_at(c, gamma));
    return web_of(planes, gammas, candela);
}

// A grid with more cells than the evaluations can resolve is integrated about another pole, without its lines.
TEST(Reference, AMaskDividedFinerIsTheSame) {
    const ReferenceGoal goal{1e-6, 500'000};
    for (unsigned i = 0; i < 24; ++i) {
        const test::ReferenceCase c = test::reference_case(i, 10);
        const auto mask = random_web(3 + i % 5, 2 + i % 4, i);
        const auto fine = divided(*mask, 32);
        ASSERT_GT(fine->planes_deg().size() * fine->gammas_deg().size(), goal.most_evaluations / (2 * 49));
        const ReferenceValue by_grid = reference_illuminance(masked(c.light, mask, 10.0), origin, c.normal, goal);
        const ReferenceValue other = reference_illuminance(masked(c.light, fine, 10.0), origin, c.normal, goal);
        EXPECT_TRUE(by_grid.converged) << i;
        EXPECT_NEAR(by_grid.value, other.value, by_grid.error_estimate + other.error_estimate + 1e-12 * other.value)
            << i;
        const ReferenceLuminance lit =
            reference_luminance(masked(c.light, mask, 10.0), origin, c.normal, c.view, c.material, goal);
        const ReferenceLuminance also =
            reference_luminance(masked(c.light, fine, 10.0), origin, c.normal, c.view, c.material, goal);
        EXPECT_NEAR(lit.diffuse.value, also.diffuse.value,
                    lit.diffuse.error_estimate + also.diffuse.error_estimate + 1e-12 * also.diffuse.value)
            << i;
    }
}

// On the light itself it fills the hemisphere: E/L = ∫ I cos γ dω, here cell by cell in (C, γ).
TEST(Reference, AMaskOverTheWholeHemisphere) {
    const auto mask = random_web(36, 36, 3);
    const Light light = masked(placed(DiskShape{Meters(0.3)}, {0.1, 0.2, 0.0}, {0.3, 0.4, -1.0}), mask, 10.0);
    constexpr const auto& rule = detail::kronrod_15;
    double sum = 0.0;
    for (int c = 0; c < 36; ++c)
        for (int g = 0; g < 18; ++g)
            for (std::size_t i = 0; i < rule.count; ++i)
                for (std::size_t k = 0; k < rule.count; ++k) {
                    const double c_deg = 10.0 * c + 5.0 + 5.0 * rule.node[i];
                    const double gamma_deg = 5.0 * g + 2.5 + 2.5 * rule.node[k];
                    const double gamma = gamma_deg * pi / 180.0;
                    sum += rule.kronrod[i] * rule.kronrod[k] * mask->candela(c_deg, gamma_deg) * std::sin(gamma) *
                           std::cos(gamma) * (5.0 * pi / 180.0) * (2.5 * pi / 180.0);
                }
    sum *= light.web_scale * light.luminance.value;
    const ReferenceValue e = reference_illuminance(light, light.frame.origin, light.frame.z, {1e-9, 4'000'000});
    EXPECT_TRUE(e.converged);
    EXPECT_NEAR(e.value, sum, 1e-11 * sum);
    EXPECT_LE(e.evaluations, 49U * 36U * 18U * 4U);
}

template<std::size_t count>
void expect_exact(const detail::GaussKronrod<count>& rule, int kronrod_degree, int gauss_degree) {
    for (int k = 0; k <= kronrod_degree; ++k) {
        double kronrod = 0.0;
        double gauss_sum = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            kronrod += rule.kronrod[i] * std::pow(rule.node[i], k);
            gauss_sum += rule.gauss[i] * std::pow(rule.node[i], k);
        }
        const double truth = k % 2 == 0 ? 2.0 / (k + 1) : 0.0;
        EXPECT_NEAR(kronrod, truth, 1e-15) << count << ' ' << k;
        if (k <= gauss_degree) {
            EXPECT_NEAR(gauss_sum, truth, 1e-15) << count << ' ' << k;
        }
    }
}

// ∫ x^k over [−1, 1]: with 2n + 1 nodes Kronrod's rule is exact to degree 3n + 1, Gauss's with n to 2n − 1.
TEST(Reference, GaussKronrodIsExactForItsDegrees) {
    expect_exact(detail::kronrod_15, 22, 13);
    expect_exact(detail::kronrod_7, 10, 5);
}

} // namespace
} // namespace gonio
