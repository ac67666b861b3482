// Linearly transformed cosines: the share of a lobe that each shape covers against quadrature, and the specular results
// against stored values of the true BRDF.
#include <gonio/shading/specular_ltc.hpp>

#include "specular_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace gonio::shading;
using poses::Random;
using poses::Vec;

constexpr double pi = std::numbers::pi;

// A shape in front of the receiver at the origin, in the lobe's frame.
struct Shape {
    enum class Kind { sphere, disk, rectangle, tube } kind;
    Vec center, axis, across;
    double p, q;
};
constexpr Shape::Kind kinds[] = {Shape::Kind::sphere, Shape::Kind::disk, Shape::Kind::rectangle, Shape::Kind::tube};

double log_uniform(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

double bounding(const Shape& s) {
    switch (s.kind) {
    case Shape::Kind::rectangle:
        return 0.5 * std::hypot(s.p, s.q);
    case Shape::Kind::tube:
        return s.p + 0.5 * s.q;
    default:
        return s.p;
    }
}

// Facing the receiver, at a distance of `ratio` times its size; the horizon cuts every third one.
Shape random_shape(Shape::Kind kind, Random& random, unsigned index, double nearest, double farthest) {
    Shape s{kind, {}, poses::random_direction(random), {}, 1.0, 1.0};
    s.across = poses::unit(cross(s.axis, poses::random_direction(random)));
    s.p = log_uniform(random, 0.01, 100.0);
    s.q = s.p * log_uniform(random, 0.1, 10.0);
    const double distance = bounding(s) * log_uniform(random, nearest, farthest);
    Vec l = poses::random_direction(random);
    if (index % 3 == 0) l.z = random.uniform(-1.0, 1.0) * std::min(1.0, bounding(s) / distance);
    if (index % 3 == 1) l.z = std::fabs(l.z);
    s.center = poses::unit(l) * distance;
    if ((kind == Shape::Kind::disk || kind == Shape::Kind::rectangle) && dot(s.axis, s.center) > 0.0)
        s.axis = s.axis * -1.0;
    return s;
}

template<class S>
vec3<S> vec(Vec v) {
    return {static_cast<S>(v.x), static_cast<S>(v.y), static_cast<S>(v.z)};
}

template<class S>
S share(const LtcLobe<S>& lobe, const Shape& s) {
    const vec3<S> c = vec<S>(s.center);
    const vec3<S> a = vec<S>(s.axis);
    const auto p = static_cast<S>(s.p);
    const auto q = static_cast<S>(s.q);
    switch (s.kind) {
    case Shape::Kind::sphere:
        return ltc_sphere(lobe, c, p);
    case Shape::Kind::disk:
        return ltc_disk(lobe, c, a, p);
    case Shape::Kind::rectangle:
        return ltc_rectangle(lobe, c, a, vec<S>(s.across), p, q);
    default:
        return ltc_tube(lobe, c, a, p, q);
    }
}

// Whether the ray from the origin meets the shape.
bool meets(const Shape& s, Vec l) {
    const Vec c = s.center;
    if (s.kind == Shape::Kind::sphere) return dot(c, l) > 0.0 && dot(c, c) - dot(c, l) * dot(c, l) < s.p * s.p;
    if (s.kind == Shape::Kind::tube) {
        // The closest points of the ray and the axis segment: by golden section, since distance is convex.
        const auto distance2 = [&](double z) {
            const Vec at = c + s.axis * z;
            const double along = std::max(dot(at, l), 0.0);
            const Vec off = at - l * along;
            return dot(off, off);
        };
        double low = -0.5 * s.q;
        double high = 0.5 * s.q;
        for (int i = 0; i < 60; ++i) {
            const double a = low + 0.38196601125 * (high - low);
            const double b = high - 0.38196601125 * (high - low);
            (distance2(a) < distance2(b) ? high : low) = distance2(a) < distance2(b) ? b : a;
        }
        return distance2(0.5 * (low + high)) < s.p * s.p;
    }
    const double toward = dot(l, s.axis);
    if (toward >= 0.0) return false;
    const double t = dot(c, s.axis) / toward;
    if (t <= 0.0) return false;
    const Vec off = l * t - c;
    if (s.kind == Shape::Kind::disk) return dot(off, off) < s.p * s.p;
    return std::fabs(dot(off, s.across)) < 0.5 * s.p && std::fabs(dot(off, cross(s.axis, s.across))) < 0.5 * s.q;
}

// The share by directions drawn from the cosine and mapped through the lobe's forward matrix; uses no outline.
double share_by_directions(const LtcLobe<double>& lobe, const Shape& s, int side) {
    // Solves lobe(l) = q.
    const double determinant = lobe.m00 * lobe.m22 - lobe.m02 * lobe.m20;
    const auto back = [&](Vec q) {
        return Vec{(lobe.m22 * q.x - lobe.m02 * q.z) / determinant, q.y / lobe.m11,
                   (lobe.m00 * q.z - lobe.m20 * q.x) / determinant};
    };
    double sum = 0.0;
    // Over both sides of z' = 0: the lobe is positive on one and negative on the other.
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const double u = (i + 0.5) / side;
            const double phi = 2.0 * pi * (k + 0.5) / side;
            for (const double sign : {1.0, -1.0}) {
                const Vec q{std::sqrt(u) * std::cos(phi), std::sqrt(u) * std::sin(phi), sign * std::sqrt(1.0 - u)};
                const Vec l = poses::unit(back(q));
                if (l.z > 0.0 && meets(s, l)) sum += sign;
            }
        }
    return std::clamp(sum / (double{1} * side * side) / lobe.horizon_z, 0.0, 1.0);
}

LtcLobe<double> random_lobe(Random& random) {
    return ltc_ggx(log_uniform(random, 0.003, 1.0), random.uniform(0.02, 1.0));
}

// 40 000 directions on each side: the error of a lattice is about its boundary's length over its side, so 1/200.
TEST(SpecularLtc, EveryShapeTakesWhatDirectionsFind) {
    Random random(71);
    for (const Shape::Kind kind : kinds)
        for (unsigned i = 0; i < 45; ++i) {
            const LtcLobe<double> lobe = random_lobe(random);
            const Shape shape = random_shape(kind, random, i, kind == Shape::Kind::tube ? 0.6 : 1.01, 10.0);
            const double found = share_by_directions(lobe, shape, kind == Shape::Kind::tube ? 100 : 200);
            EXPECT_NEAR(share(lobe, shape), found, kind == Shape::Kind::tube ? 0.015 : 0.006)
                << "kind " << static_cast<int>(kind) << " case " << i;
        }
}

// The closed form of an arc against its integrand by Simpson's rule in the circle's own parameter.
TEST(SpecularLtc, ArcsOfConesAreTheirIntegrals) {
    Random random(72);
    for (int i = 0; i < 400; ++i) {
        const double size = log_uniform(random, 0.05, 20.0);
        const Vec a = poses::random_direction(random);
        Vec u = poses::random_direction(random) * size;
        const Vec v = poses::random_direction(random) * (size * log_uniform(random, 0.1, 1.0));
        if (dot(a, cross(u, v)) < 0.0) u = u * -1.0;
        if (dot(a, cross(u, v)) < 1e-2 * size * size) continue; // a flat cone needs a finer rule
        const auto at = [&](double t) { return a + u * std::cos(t) + v * std::sin(t); };
        const double from = random.uniform(-pi, pi);
        const double to = from + random.uniform(0.01, 2.0 * pi - 0.01);
        const auto integral = [&](double t0, double t1) {
            constexpr int steps = 4000;
            double sum = 0.0;
            for (int k = 0; k <= steps; ++k) {
                const double t = t0 + (t1 - t0) * k / steps;
                const Vec p = at(t);
                const Vec dp = v * std::cos(t) - u * std::sin(t);
                const double weight = k == 0 || k == steps ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
                sum += weight * cross(p, dp).z / dot(p, p);
            }
            return 0.5 * sum * (t1 - t0) / (3.0 * steps);
        };
        const detail::LtcCone<double> cone(a, u, v);
        EXPECT_NEAR(cone.arc(at(from), at(to), false), integral(from, to), 1e-9) << i;
        EXPECT_NEAR(cone.whole(), integral(0.0, 2.0 * pi), 1e-9) << i;
        const detail::LtcCone<float> in_float(vec<float>(a), vec<float>(u), vec<float>(v));
        EXPECT_NEAR(in_float.whole(), cone.whole(), 2e-6) << i;
    }
}

TEST(SpecularLtc, PartsMakeTheWhole) {
    Random random(73);
    for (unsigned i = 0; i < 300; ++i) {
        const LtcLobe<double> lobe = random_lobe(random);
        const Shape whole = random_shape(Shape::Kind::rectangle, random, i, 0.1, 1e3);
        Shape left = whole;
        left.p = 0.5 * whole.p;
        Shape right = left;
        left.center = whole.center - whole.across * (0.25 * whole.p);
        right.center = whole.center + whole.across * (0.25 * whole.p);
        const double all = share(lobe, whole);
        // The slightly negative side of a lobe counts as 0 for each light. Small lights are summed over points.
        if (share(lobe, left) == 0.0 || share(lobe, right) == 0.0) continue;
        EXPECT_NEAR(std::min(share(lobe, left) + share(lobe, right), 1.0), all, 1e-5 * all + 1e-12) << i;
    }
}

TEST(SpecularLtc, ATubeWithoutLengthIsASphereAndInsideIsAll) {
    Random random(74);
    for (unsigned i = 0; i < 300; ++i) {
        const LtcLobe<double> lobe = random_lobe(random);
        Shape tube = random_shape(Shape::Kind::tube, random, i, 1.01, 1e3);
        tube.q = 1e-9 * tube.p;
        const double sphere = ltc_sphere<double>(lobe, tube.center, tube.p);
        EXPECT_NEAR(share(lobe, tube), sphere, 1e-3 * sphere + 1e-9) << i;
        EXPECT_EQ(
            ltc_sphere<double>(lobe, tube.center * (0.9 * tube.p / std::sqrt(dot(tube.center, tube.center))), tube.p),
            1.0);
    }
    const LtcLobe<double> lobe = random_lobe(random);
    EXPECT_EQ(ltc_tube<double>(lobe, {0.1, 0.2, 3.0}, {0.0, 0.0, 1.0}, 0.5, 10.0), 1.0);
    EXPECT_EQ(ltc_sphere<double>(lobe, {0, 0, 1}, 0.0), 0.0);
    EXPECT_EQ(ltc_disk<double>(lobe, {0, 0, 1}, {0, 0, 1}, 0.5), 0.0); // from behind
    EXPECT_GT(ltc_disk<double>(lobe, {0, 0, 1}, {0, 0, 1}, 0.5, true), 0.0);
}

// A sphere that the horizon almost touches counts as whole, on either side of the rounding.
TEST(SpecularLtc, ASphereThatTouchesTheHorizonIsWhole) {
    Random random(79);
    for (int i = 0; i < 2000; ++i) {
        const LtcLobe<float> lobe = ltc_ggx(0.3F, static_cast<float>(random.uniform(0.01, 1.0)));
        const auto x = static_cast<float>(random.uniform(0.5, 2.0));
        const float touching = ltc_sphere<float>(lobe, {x, 0.3F * x, 1.0F}, 1.0F);
        const float below = ltc_sphere<float>(lobe, {x, 0.3F * x, 0.9999999F}, 1.0F);
        const float above = ltc_sphere<float>(lobe, {x, 0.3F * x, 1.00001F}, 1.0F);
        EXPECT_NEAR(touching, above, 1e-4F * above + 1e-6F) << i;
        EXPECT_NEAR(below, above, 1e-4F * above + 1e-6F) << i;
    }
}

// From 1e2 to 1e6 sizes away the share falls with the square of the distance: no digits cancel.
TEST(SpecularLtc, FarLightsFallWithTheSquareOfTheDistance) {
    Random random(75);
    for (const Shape::Kind kind : kinds)
        for (unsigned i = 0; i < 60; ++i) {
            const LtcLobe<float> lobe = ltc_ggx(static_cast<float>(log_uniform(random, 0.1, 1.0)),
                                                static_cast<float>(random.uniform(0.1, 1.0)));
            Shape shape = random_shape(kind, random, 1, 1e3, 1.001e3);
            if (shape.center.z < 0.02 * std::sqrt(dot(shape.center, shape.center))) continue;
            const float near = share(lobe, shape);
            shape.center = shape.center * 1e3;
            const float far = share(lobe, shape);
            if (near < 1e-12F) continue;
            EXPECT_NEAR(far / near, 1e-6F, 3e-9F) << "kind " << static_cast<int>(kind) << " case " << i;
        }
}

// Relative to double on the same numbers; absolute if the light is in the lobe's tail, where arcs cancel.
TEST(SpecularLtc, FloatFollowsDouble) {
    Random random(76);
    for (const Shape::Kind kind : kinds)
        for (unsigned i = 0; i < 3000; ++i) {
            const auto alpha = static_cast<float>(log_uniform(random, 0.01, 1.0));
            const auto mu = static_cast<float>(random.uniform(0.02, 1.0));
            const LtcLobe<float> lobe = ltc_ggx(alpha, mu);
            Shape s = random_shape(kind, random, i, kind == Shape::Kind::tube ? 0.1 : 1.01, 1e4);
            const auto rounded = [](Vec v) {
                const auto of = [](double x) { return static_cast<double>(static_cast<float>(x)); };
                return Vec{of(v.x), of(v.y), of(v.z)};
            };
            s.center = rounded(s.center);
            s.axis = rounded(s.axis);
            s.across = rounded(s.across);
            s.p = static_cast<double>(static_cast<float>(s.p));
            s.q = static_cast<double>(static_cast<float>(s.q));
            const LtcLobe<double> wide{static_cast<double>(lobe.m00),       static_cast<double>(lobe.m02),
                                       static_cast<double>(lobe.m11),       static_cast<double>(lobe.m20),
                                       static_cast<double>(lobe.m22),       static_cast<double>(lobe.horizon_x),
                                       static_cast<double>(lobe.horizon_z), static_cast<double>(lobe.albedo),
                                       static_cast<double>(lobe.grazing)};
            const double truth = share(wide, s);
            EXPECT_NEAR(static_cast<double>(share(lobe, s)), truth, 1e-3 * truth + 3e-6)
                << "kind " << static_cast<int>(kind) << " case " << i << " alpha " << alpha << " mu " << mu;
        }
}

// A disk seen edge-on and cut by the horizon: a cone so flat that floats could not locate the cut on it, which gave up
// to 9 % of its luminance where there is almost none. Heights above its plane are kept exact; the remaining errors are
// the roundings of the lobe's frame, 6e-8 of the distance, divided by the height.
TEST(SpecularLtc, FloatKnowsAFlatDiskThatTheHorizonCuts) {
    Random random(9);
    std::size_t cut = 0;
    for (int i = 0; i < 40'000; ++i) {
        const auto number = [](double x) { return static_cast<float>(x); };
        const float height = number(log_uniform(random, 3e-4, 1e-2));
        const float radius = number(random.uniform(0.1, 0.9));
        const vec3<float> center{1.0F, 0.0F, height};
        const vec3<float> axis{0.0F, 0.0F, -1.0F};
        const Vec to{1.0, 0.0, static_cast<double>(height)};
        const Vec n = poses::tilted(to, random.uniform(-1.0, 1.0) * static_cast<double>(radius), random);
        const Vec v = poses::random_direction(random);
        if (dot(n, v) < 0.05) continue;
        const auto narrow = [&](Vec a) { return vec3<float>{number(a.x), number(a.y), number(a.z)}; };
        const vec3<float> n_f = narrow(n);
        const vec3<float> v_f = narrow(v);
        const float alpha = number(log_uniform(random, 1e-3, 1.0));
        const DiskLight<float> disk{center, {1.0F, 1.0F, 1.0F}, axis, radius, 0.0F, false};
        const DiskLight<double> disk_d{widen(center), {1.0, 1.0, 1.0}, widen(axis), static_cast<double>(radius), 0.0,
                                       false};
        const float found = specular_ltc(disk, center, n_f, v_f, GgxLobe<float>{alpha}).scale;
        const double expected =
            specular_ltc(disk_d, widen(center), widen(n_f), widen(v_f), GgxLobe<double>{static_cast<double>(alpha)})
                .scale;
        EXPECT_NEAR(found, expected, 1.5e-3 + 1e-2 * expected)
            << "height " << height << " radius " << radius << " alpha " << alpha;
        if (std::fabs(dot(n, to)) < 0.9 * static_cast<double>(radius) * std::sqrt(1.0 - n.z * n.z)) ++cut;
    }
    EXPECT_GT(cut, 10'000U);
}

TEST(SpecularLtc, FiniteForHostileNumbers) {
    Random random(77);
    for (int i = 0; i < 60000; ++i) {
        const auto h = [&] { return static_cast<float>(poses::hostile(random)); };
        const vec3<float> normal = vec<float>(poses::random_direction(random));
        const vec3<float> view = i % 5 == 0 ? normal : vec<float>(poses::random_direction(random));
        const LtcFrame<float> frame = ltc_frame(normal, view);
        const LtcLobe<float> lobe = ltc_ggx(std::fabs(h()), dot(normal, view));
        const vec3<float> center{h(), h(), h()};
        const vec3<float> axis = vec<float>(poses::random_direction(random));
        const vec3<float> across = vec<float>(poses::unit(
            cross(Vec{static_cast<double>(axis.x), static_cast<double>(axis.y), static_cast<double>(axis.z)},
                  poses::random_direction(random))));
        const float p = h();
        const float q = h();
        const float values[] = {ltc_sphere(lobe, frame(center), p), ltc_disk(lobe, frame(center), frame(axis), p),
                                ltc_rectangle(lobe, frame(center), frame(axis), frame(across), p, q, i % 2 == 0),
                                ltc_tube(lobe, frame(center), frame(axis), p, q)};
        for (const float value : values)
            ASSERT_TRUE(value >= 0.0F && value <= 1.0F) << i << " " << value;
    }
}

TEST(SpecularLtc, StoredValuesOfTheTrueBrdf) {
    const auto rows = specular::rows();
    // Median and 95th percentile, measured plus a small margin. With the transformed cosine alone the medians are
    // 0.0320, 0.0152, 0.0305 and 0.0348.
    const std::map<std::string, std::pair<double, double>> bars = {
        {"sphere", {0.0001, 0.006}}, {"disk", {0.0013, 0.024}}, {"rect", {0.0034, 0.12}}, {"tube", {0.0009, 0.028}}};
    std::map<std::string, std::vector<double>> errors;
    for (const specular::Row& row : rows) {
        const double value = specular::with_light<double>(row, [&](const auto& light) {
            return specular_ltc(light, row.center, row.normal, row.view, GgxLobe<double>{row.alpha}).scale;
        });
        errors[row.shape].push_back(std::fabs(value / row.luminance - 1.0));
    }
    ASSERT_EQ(errors.size(), bars.size());
    for (auto& [shape, of_shape] : errors) {
        std::sort(of_shape.begin(), of_shape.end());
        ASSERT_EQ(of_shape.size(), 60U) << shape;
        EXPECT_LT(of_shape[30], bars.at(shape).first) << shape;
        EXPECT_LT(of_shape[57], bars.at(shape).second) << shape;
        RecordProperty(shape, std::to_string(of_shape[30]) + " " + std::to_string(of_shape[57]));
    }
}

// A light that is small against the lobe gives the true BRDF in its one direction times its exact irradiance, for every
// shape; there is no step across the sizes where rows of points take over.
TEST(SpecularLtc, SmallLightsAreTheBrdfItselfAndNoStepFollows) {
    Random random(80);
    for (const Shape::Kind kind : kinds)
        for (int i = 0; i < 40; ++i) {
            const GgxLobe<double> lobe{log_uniform(random, 0.1, 1.0)};
            const Vec n{0.0, 0.0, 1.0};
            const Vec v = poses::tilted(n, random.uniform(0.2, 1.0), random);
            const Vec l = poses::tilted(n, random.uniform(0.3, 1.0), random);
            // Turned more or less to the receiver; a tube lies across.
            const Vec facing = poses::tilted(l * -1.0, random.uniform(0.5, 1.0), random);
            const Vec across = poses::unit(cross(facing, poses::random_direction(random)));
            const auto value = [&](double size) {
                const Vec zero{0.0, 0.0, 0.0};
                switch (kind) {
                case Shape::Kind::sphere:
                    return specular_ltc(SphereLight<double>{l, zero, size, 0.0}, l, n, v, lobe).scale;
                case Shape::Kind::disk:
                    return specular_ltc(DiskLight<double>{l, zero, facing, size, 0.0, false}, l, n, v, lobe).scale;
                case Shape::Kind::rectangle:
                    return specular_ltc(RectangleLight<double>{l, zero, facing, across, size, 0.5 * size, 0.0, false},
                                        l, n, v, lobe)
                        .scale;
                default:
                    return specular_ltc(TubeLight<double>{l, zero, across, 0.3 * size, size, 0.0}, l, n, v, lobe).scale;
                }
            };
            const SurfacePoint<double> point{{0.0, 0.0, 0.0}, n, v};
            const double tiny = 1e-5;
            const Vec zero{0.0, 0.0, 0.0};
            const double lx =
                kind == Shape::Kind::sphere ? illuminance(point, SphereLight<double>{l, zero, tiny, 0.0})
                : kind == Shape::Kind::disk ? illuminance(point, DiskLight<double>{l, zero, facing, tiny, 0.0, false})
                : kind == Shape::Kind::rectangle
                    ? illuminance(point, RectangleLight<double>{l, zero, facing, across, tiny, 0.5 * tiny, 0.0, false})
                    : illuminance(point, TubeLight<double>{l, zero, across, 0.3 * tiny, tiny, 0.0});
            const double truth = specular_ggx(n, l, v, lobe.alpha, lobe.alpha).scale * lx;
            EXPECT_NEAR(value(tiny), truth, 1e-6 * truth) << "kind " << static_cast<int>(kind) << " case " << i;
            for (double size = 0.01; size < 0.5; size *= 1.003) {
                const double before = value(size);
                EXPECT_NEAR(value(1.003 * size), before, 0.04 * before)
                    << "kind " << static_cast<int>(kind) << ' ' << size;
            }
        }
}

// The table's albedo against a sum over the hemisphere, between the points it was fitted at.
TEST(SpecularLtc, AlbedosAreThoseOfTheBrdf) {
    Random random(78);
    for (int i = 0; i < 12; ++i) {
        const double alpha = log_uniform(random, 0.05, 1.0);
        const double mu = random.uniform(0.05, 1.0);
        const Vec v{-std::sqrt(1.0 - mu * mu), 0.0, mu};
        constexpr int count = 200000;
        double whole = 0.0;
        double grazing = 0.0;
        double diffuse = 0.0;
        for (int k = 0; k < count; ++k) {
            const double u = (k + 0.5) / count;
            const double phi = 2.0 * pi * std::fmod(k * 0.61803398874989485, 1.0);
            // Half vectors sampled by D·n·h for the two specular sums; the cosine for the diffuse one.
            const double t = alpha * std::sqrt(u / (1.0 - u));
            const Vec h = poses::unit({t * std::cos(phi), t * std::sin(phi), 1.0});
            const Vec l = h * (2.0 * dot(v, h)) - v;
            if (l.z > 0.0 && dot(v, h) > 0.0) {
                const double weight = visibility_ggx(l.z, mu, alpha) * l.z * 4.0 * dot(v, h) / h.z;
                whole += weight / count;
                grazing += weight * schlick_weight(dot(v, h)) / count;
            }
            const Vec even{std::sqrt(u) * std::cos(phi), std::sqrt(u) * std::sin(phi), std::sqrt(1.0 - u)};
            diffuse += pi * diffuse_frostbite(even.z, mu, dot(even, v), std::sqrt(alpha)) / count;
        }
        const LtcLobe<double> lobe = ltc_ggx(alpha, mu);
        EXPECT_NEAR(lobe.albedo, whole, 2e-3) << alpha << " " << mu;
        EXPECT_NEAR(lobe.grazing, grazing, 2e-3) << alpha << " " << mu;
        EXPECT_NEAR(ltc_diffuse(std::sqrt(alpha), mu).albedo, diffuse, 4e-3) << alpha << " " << mu;
    }
}

} // namespace
