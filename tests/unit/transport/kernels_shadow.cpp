// The kernels of soft shadows against each other; tests/unit/preview/shadows.cpp compares them with counted rays.
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/shadow_body.hpp>
#include <gonio/transport/kernels_shadow.hpp>
#include <gonio/transport/kernels_shadow_impl.hpp>

#include "../light/lights.hpp"
#include "../preview/numbers.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace gonio::transport {
namespace {

using gonio::detail::ShadowBody;
using Vec = glm::dvec3;

constexpr std::size_t receiver_count = 37; // the last packet of every set is partly filled

const Vec coplanar(0.7, 0.1, 0.9); // a panel there faces −x

struct Receivers {
    std::array<std::vector<double>, 6> numbers;

    // Some of them on the axis of the light, on both sides of it and within, and some in the plane of a panel that
    // any_body() makes.
    Receivers(test::Numbers& random, const Light& light) {
        for (std::size_t i = 0; i < receiver_count; ++i) {
            Vec position = random.in_box(2.0) * Vec(1, 1, 0.1);
            Vec normal = glm::normalize(Vec(0, 0, 1) + random.in_box(0.5));
            if (i % 9 == 4) position = light.frame.origin + random.between(-2.0, 2.0) * light.frame.x;
            if (i % 9 == 7) position = light.frame.origin + random.between(-2.0, 2.0) * light.frame.z;
            if (i % 9 == 8) {
                position = coplanar + Vec(0.0, random.between(-2.0, 2.0), random.between(-1.0, 1.0));
                normal = Vec(-1, 0, 0);
            }
            for (int axis = 0; axis < 3; ++axis) {
                numbers[static_cast<std::size_t>(axis)].push_back(position[axis]);
                numbers[static_cast<std::size_t>(3 + axis)].push_back(normal[axis]);
            }
        }
    }
    Receivers in_order(const std::vector<std::size_t>& order) const {
        Receivers moved = *this;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            for (std::size_t j = 0; j < order.size(); ++j)
                moved.numbers[i][j] = numbers[i][order[j]];
        return moved;
    }
};

struct Shares {
    std::vector<double> visible = std::vector<double>(receiver_count);
    std::vector<double> hiding = std::vector<double>(receiver_count);
    std::array<std::vector<float>, 5> cells;

    bool is_in_penumbra(std::size_t i) const { return visible[i] > 0.0 && visible[i] < 1.0; }
};

template<class Kernel>
Shares shares_by(const Kernel& visible_shares, const gonio::detail::LinedLight& light,
                 const std::vector<ShadowBody>& bodies, const Receivers& at) {
    ShadowReceivers receivers;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        receivers.position[axis] = at.numbers[axis].data();
        receivers.normal[axis] = at.numbers[3 + axis].data();
    }
    receivers.count = receiver_count;
    Shares shares;
    for (std::vector<float>& cells : shares.cells)
        cells.resize(ShadowShares::cells * receiver_count);
    ShadowShares to;
    to.visible = shares.visible.data();
    to.hiding = shares.hiding.data();
    to.stride = receiver_count;
    to.seen = shares.cells[0].data();
    to.solid_angle = shares.cells[1].data();
    for (std::size_t axis = 0; axis < 3; ++axis)
        to.towards[axis] = shares.cells[2 + axis].data();
    std::vector<std::byte> scratch(bodies.size() * shadow_scratch_bytes);
    visible_shares(light, bodies.data(), bodies.size(), receivers, scratch.data(), to);
    return shares;
}

Shares shares_of(simd::InstructionSet set, const gonio::detail::LinedLight& light,
                 const std::vector<ShadowBody>& bodies, const Receivers& at) {
    return shares_by(shadow_kernels(set).visible_shares, light, bodies, at);
}

Primitive any_body(test::Numbers& random) {
    const Vec center = random.in_box(0.8) + Vec(0, 0, 1.2);
    const Vec axis = random.direction();
    switch (static_cast<int>(random.between(0.0, 6.0))) {
    case 5:
        return panel_facing(coplanar, {-1, 0, 0}, {0, 0, 1}, 0.6, 0.8);
    case 0:
        return Plane{center + Vec(0, 0, 1.2), axis};
    case 1:
        return panel_facing(center, axis, random.direction(), random.between(0.1, 1), random.between(0.1, 1));
    case 2:
        return Ball{center, random.between(0.05, 0.5)};
    case 3:
        return Box{aimed_frame(center, axis, random.direction()),
                   {random.between(0.05, 0.4), random.between(0.05, 0.4), random.between(0.05, 0.4)}};
    default:
        return Capsule{center, axis, random.between(0.05, 0.8), random.between(0.02, 0.3)};
    }
}

struct Case {
    gonio::detail::LinedLight light;
    std::vector<ShadowBody> bodies;
    Receivers receivers;
};

std::vector<Case> cases() {
    const Vec at(0.1, -0.2, 2.4);
    const Vec beside(0.1, -0.2, 0.9);
    const Vec down(0.2, 0.1, -1.0);
    const std::array lights{std::pair{light_of("sphere:r=30cm", "1000cd", at), 0.3},
                            std::pair{light_of("disk:r=40cm", "1000cd", at, down), 0.4},
                            std::pair{light_of("ellipse:w=1.2m,h=30cm", "1000cd", at, down), 0.6},
                            std::pair{light_of("rect:w=1m,h=40cm", "1000cd", at, down), 0.54},
                            std::pair{light_of("rect:w=3m,h=4m", "1000cd", beside, {1.0, 0.1, -0.4}), 2.5},
                            std::pair{light_of("tube:r=8cm,l=1.2m", "1000cd", beside, {0.0, 0.0, -1.0}), 0.68},
                            std::pair{light_of("cylinder:r=20cm,l=60cm", "1000cd", at, {0.0, 0.0, -1.0}), 0.37}};
    test::Numbers random(31);
    std::vector<Case> made;
    for (const auto& [light, radius] : lights)
        for (std::size_t i = 0; i < 40; ++i) {
            const Ball around{light.frame.origin, radius};
            const gonio::detail::LinedLight lined = gonio::detail::lined_light(light, around);
            std::vector<ShadowBody> bodies;
            for (std::size_t body = 0; body <= i % 5; ++body)
                bodies.push_back(gonio::detail::shadow_body(any_body(random), lined));
            made.push_back({lined, bodies, Receivers(random, light)});
        }
    return made;
}

TEST(ShadowKernels, GiveTheSameBitsOnAllSets) {
    std::size_t in_penumbra = 0;
    for (const Case& of : cases()) {
        const Shares plain = shares_of(simd::InstructionSet::scalar, of.light, of.bodies, of.receivers);
        for (const simd::InstructionSet set : simd::available_sets()) {
            const Shares packed = shares_of(set, of.light, of.bodies, of.receivers);
            EXPECT_EQ(packed.visible, plain.visible) << simd::to_text(set);
            EXPECT_EQ(packed.hiding, plain.hiding) << simd::to_text(set);
            for (std::size_t i = 0; i < receiver_count; ++i) {
                if (!plain.is_in_penumbra(i)) continue;
                ++in_penumbra;
                for (std::size_t cell = 0; cell < ShadowShares::cells; ++cell)
                    for (std::size_t number = 0; number < plain.cells.size(); ++number)
                        ASSERT_EQ(packed.cells[number][cell * receiver_count + i],
                                  plain.cells[number][cell * receiver_count + i])
                            << simd::to_text(set);
            }
        }
    }
    EXPECT_GT(in_penumbra, 2000U);
}

Shares exact_shares_of(const gonio::detail::LinedLight& light, const std::vector<ShadowBody>& bodies,
                       const Receivers& at) {
    return shares_by(detail::visible_shares<double>, light, bodies, at);
}

// The same kernel in double. Where two edges are seen equally far from the middle of the light, rounding decides which
// of them gives the direction of the lines; those shares differ by the error of the lines.
TEST(ShadowKernels, AgreeWithDouble) {
    std::size_t in_penumbra = 0;
    std::size_t by_other_lines = 0;
    for (const Case& of : cases()) {
        const Shares single = shares_of(simd::InstructionSet::scalar, of.light, of.bodies, of.receivers);
        const Shares exact = exact_shares_of(of.light, of.bodies, of.receivers);
        for (std::size_t i = 0; i < receiver_count; ++i) {
            if (!exact.is_in_penumbra(i)) continue;
            ++in_penumbra;
            const double difference = std::abs(single.visible[i] - exact.visible[i]);
            if (difference > 2e-5) ++by_other_lines;
            EXPECT_LT(difference, 0.02);
        }
    }
    EXPECT_GT(in_penumbra, 3000U);
    EXPECT_LE(by_other_lines, 5U);
}

// A light that is seen at a ten-thousandth of a radian, behind bodies of 1 m whose edges cross it, at the origin and 5
// km from it: floats would have two digits of it, if they were not of numbers that are relative to it.
TEST(ShadowKernels, NarrowLightsKeepTheirDigits) {
    constexpr double height = 50.0;
    test::Numbers random(32);
    std::size_t in_penumbra = 0;
    for (const char* const shape : {"sphere:r=5mm", "disk:r=5mm", "rect:w=1cm,h=8mm", "tube:r=2mm,l=1cm"})
        for (int i = 0; i < 12; ++i) {
            const Vec origin = i % 2 == 0 ? Vec(0.0) : Vec(3000.0, -4000.0, 20.0);
            const Vec middle = origin + Vec(0, 0, 0.5 * height);
            const Light light = light_of(shape, "1000cd", origin + Vec(0, 0, height), {0, 0, -1});
            const Ball around{light.frame.origin, 0.01};
            std::vector<Primitive> bodies{Ball{middle, 0.5}};
            if (i % 4 == 1) bodies = {Capsule{middle, {0, 1, 0}, 3.0, 0.5}};
            if (i % 4 == 2) bodies = {panel_facing(middle, {0, 0, -1}, {0, 1, 0}, 1.0, 6.0)};
            if (i % 4 == 3) bodies = {Box{{middle, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0.5, 3.0, 0.2}}};
            const gonio::detail::LinedLight lined = gonio::detail::lined_light(light, around);
            std::vector<ShadowBody> solids;
            for (const Primitive& body : bodies)
                solids.push_back(gonio::detail::shadow_body(body, lined));
            // Around where rays from the light's middle pass the edge.
            double edge = 1.0;
            if (i % 4 < 2) edge = height * std::tan(std::asin(0.5 / (0.5 * height)));
            if (i % 4 == 3) edge = height * 0.5 / (0.5 * height - 0.2);
            Receivers at(random, light);
            for (std::size_t j = 0; j < receiver_count; ++j) {
                const double x = edge + random.between(-0.006, 0.006);
                const Vec position = origin + Vec(x, random.between(-0.01, 0.01), 0.0);
                for (int axis = 0; axis < 3; ++axis) {
                    at.numbers[static_cast<std::size_t>(axis)][j] = position[axis];
                    at.numbers[static_cast<std::size_t>(3 + axis)][j] = axis == 2 ? 1.0 : 0.0;
                }
            }
            const Shares single = shares_of(simd::InstructionSet::scalar, lined, solids, at);
            const Shares exact = exact_shares_of(lined, solids, at);
            for (std::size_t j = 0; j < receiver_count; ++j) {
                EXPECT_NEAR(single.visible[j], exact.visible[j], 1e-4) << shape << ' ' << i;
                if (exact.is_in_penumbra(j)) ++in_penumbra;
            }
        }
    EXPECT_GT(in_penumbra, 600U);
}

TEST(ShadowKernels, ShareDoesNotDependOnOtherReceivers) {
    std::vector<std::size_t> order(receiver_count);
    for (std::size_t i = 0; i < receiver_count; ++i)
        order[i] = (i * 11 + 5) % receiver_count;
    for (const Case& of : cases())
        for (const simd::InstructionSet set : simd::available_sets()) {
            const Shares shares = shares_of(set, of.light, of.bodies, of.receivers);
            const Shares moved = shares_of(set, of.light, of.bodies, of.receivers.in_order(order));
            for (std::size_t i = 0; i < receiver_count; ++i)
                EXPECT_EQ(moved.visible[i], shares.visible[order[i]]) << simd::to_text(set);
        }
}

// Points before a sphere light and a ball between, of any size, from outlines that touch to ones inside each other:
// against projected_cap_overlap(), which has all digits. Three in ten have no closed form.
TEST(ShadowKernels, ShareBehindABallIsTheOverlapOfCaps) {
    constexpr std::size_t count = 400;
    constexpr double light_radius = 0.3;
    test::Numbers random(33);
    const Light light = light_of("sphere:r=30cm", "1000cd", {0.4, -0.3, 0.2});
    const gonio::detail::LinedLight lined = gonio::detail::lined_light(light, {light.frame.origin, light_radius});
    std::array<std::vector<double>, 10> numbers; // position, normal, ball and its radius
    std::vector<double> expected;
    std::size_t in_part = 0;
    std::size_t without = 0;
    while (expected.size() < count) {
        const double a = random.log_between(1e-5, 1.2);
        const double b = std::min(a * random.log_between(1e-3, 1e3), 1.5);
        const double distance = light_radius / std::sin(a);
        const double most = (distance - light_radius) / (1.0 + std::sin(b)); // of the ball's distance
        const double ball_distance = most * random.between(0.01, 0.999);
        const double apart = std::abs(b - a) + random.between(-0.1, 1.05) * 2.0 * std::min(a, b);
        const double tilt = random.between(0.0, 1.5);
        const Vec to_light = random.direction();
        const Vec aside = glm::normalize(glm::cross(to_light, random.direction()));
        const Vec to_ball = std::cos(apart) * to_light + std::sin(apart) * aside;
        Vec normal = glm::normalize(to_light + tilt * random.direction());
        const Vec point = light.frame.origin - distance * to_light;
        Vec middle = point + ball_distance * to_ball;
        const double radius = ball_distance * std::sin(b);
        const std::size_t kind = expected.size() % 10;
        if (kind == 3) normal = -to_light;                                 // unlit
        if (kind == 6) middle = point + 2.0 * distance * to_ball;          // behind the light
        if (kind == 9) middle = point + 0.5 * radius * random.direction(); // around the point
        const bool has_form = kind != 3 && kind != 6 && kind != 9;
        // The kernel starts from these rounded numbers.
        const Vec light_seen = light.frame.origin - point;
        const Vec ball_seen = middle - point;
        const double sine = light_radius / glm::length(light_seen);
        const double cosine = glm::dot(normal, glm::normalize(light_seen));
        if (has_form && cosine < sine) continue;
        double share = -1.0;
        if (has_form) {
            const double hidden =
                projected_cap_overlap(glm::normalize(light_seen), std::asin(sine), glm::normalize(ball_seen),
                                      std::asin(std::min(radius / glm::length(ball_seen), 1.0)), normal);
            share = std::clamp(1.0 - hidden / (std::numbers::pi * sine * sine * cosine), 0.0, 1.0);
            if (share > 0.0 && share < 1.0) ++in_part;
        } else {
            ++without;
        }
        expected.push_back(share);
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            numbers[at].push_back(point[axis]);
            numbers[3 + at].push_back(normal[axis]);
            numbers[6 + at].push_back(middle[axis]);
        }
        numbers[9].push_back(radius);
    }
    EXPECT_GT(in_part, 200U);
    EXPECT_GT(without, 100U);
    ReceiversBehindBalls of;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        of.receivers.position[axis] = numbers[axis].data();
        of.receivers.normal[axis] = numbers[3 + axis].data();
        of.middle[axis] = numbers[6 + axis].data();
    }
    of.receivers.count = count;
    of.radius = numbers[9].data();
    std::vector<double> plain(count);
    shadow_kernels(simd::InstructionSet::scalar).share_past_balls(lined, of, plain.data());
    for (std::size_t i = 0; i < count; ++i) {
        const Vec to_light = light.frame.origin - Vec(numbers[0][i], numbers[1][i], numbers[2][i]);
        // Directions have the last digit of a number near 1, which is more of a narrow light.
        const double tolerance = 1e-12 + 2e-15 * glm::length(to_light) / light_radius;
        EXPECT_NEAR(plain[i], expected[i], tolerance) << i;
    }
    for (const simd::InstructionSet set : simd::available_sets()) {
        std::vector<double> packed(count);
        shadow_kernels(set).share_past_balls(lined, of, packed.data());
        EXPECT_EQ(packed, plain) << simd::to_text(set);
    }
}

// Of the bodies that are not near no line is hidden, so that the only one that is near hides as much as all.
TEST(ShadowKernels, OnlyBodiesThatAreNearHide) {
    std::size_t by_none = 0;
    std::size_t by_one = 0;
    for (const Case& of : cases()) {
        const Shares all = shares_of(simd::InstructionSet::scalar, of.light, of.bodies, of.receivers);
        ShadowReceivers receivers;
        for (std::size_t axis = 0; axis < 3; ++axis)
            receivers.position[axis] = of.receivers.numbers[axis].data();
        receivers.count = receiver_count;
        std::vector<double> near(receiver_count);
        shadow_kernels(simd::InstructionSet::scalar)
            .near_bodies(of.light, of.bodies.data(), of.bodies.size(), receivers, near.data());
        for (const simd::InstructionSet set : simd::available_sets()) {
            std::vector<double> packed(receiver_count);
            shadow_kernels(set).near_bodies(of.light, of.bodies.data(), of.bodies.size(), receivers, packed.data());
            EXPECT_EQ(packed, near) << simd::to_text(set);
        }
        for (std::size_t body = 0; body < of.bodies.size(); ++body) {
            const Shares alone = shares_of(simd::InstructionSet::scalar, of.light, {of.bodies[body]}, of.receivers);
            for (std::size_t i = 0; i < receiver_count; ++i) {
                if (near[i] != static_cast<double>(body)) continue;
                EXPECT_EQ(alone.visible[i], all.visible[i]);
                if (all.is_in_penumbra(i)) ++by_one;
            }
        }
        for (std::size_t i = 0; i < receiver_count; ++i) {
            if (near[i] != NearBodies::none) continue;
            EXPECT_EQ(all.visible[i], 1.0);
            ++by_none;
        }
    }
    EXPECT_GT(by_none, 500U);
    EXPECT_GT(by_one, 500U);
}

Vec any_point_of(const gonio::detail::LinedLight& light, test::Numbers& random) {
    const auto vector = [](const double(&v)[3]) { return Vec(v[0], v[1], v[2]); };
    const Vec along = vector(light.center) + random.between(-1.0, 1.0) * light.half_size[0] * vector(light.x);
    if (light.kind == gonio::detail::LinedLight::Kind::rectangle)
        return along + random.between(-1.0, 1.0) * light.half_size[1] * vector(light.y);
    return along + light.radius * random.direction(); // a cylinder is within this
}

// No ray from the light to the receiver meets a body that is beside all ways; of the others, which may be behind the
// receiver, many are met.
TEST(ShadowKernels, NoRayMeetsABodyBesideAllWays) {
    const Vec at(0.1, -0.2, 2.4);
    test::Numbers random(32);
    for (const Light& light :
         {light_of("rect:w=1m,h=40cm", "1000cd", at, {0.2, 0.1, -1.0}), light_of("rect:w=3m,h=10cm", "1000cd", at),
          light_of("tube:r=2cm,l=2m", "1000cd", at), light_of("cylinder:r=20cm,l=60cm", "1000cd", at)}) {
        const gonio::detail::LinedLight lined = gonio::detail::lined_light(light, {light.frame.origin, 1.6});
        std::size_t beside = 0;
        std::size_t met = 0;
        std::size_t others = 0;
        for (int i = 0; i < 4000; ++i) {
            const Primitive body = any_body(random);
            const ShadowBody numbers = gonio::detail::shadow_body(body, lined);
            if (!gonio::detail::SidesOfWays<double>::may_be_beside(lined, numbers)) continue;
            Vec point = random.in_box(3.0);
            if (i % 9 == 4) point = light.frame.origin + random.between(-2.0, 2.0) * light.frame.x;
            if (i % 9 == 7) point = light.frame.origin + random.between(-2.0, 2.0) * light.frame.y;
            const bool may_meet =
                gonio::detail::SidesOfWays<double>(lined, {point.x, point.y, point.z}).may_meet(numbers);
            bool is_met = false;
            for (int ray = 0; ray < 60 && !is_met; ++ray) {
                const Vec way = any_point_of(lined, random) - point;
                is_met = stops(body, {point, glm::normalize(way)}, glm::length(way));
            }
            ++(may_meet ? others : beside);
            if (is_met) ++met;
            EXPECT_TRUE(may_meet || !is_met) << i;
        }
        EXPECT_GT(beside, 1000U);
        EXPECT_GT(3 * met, others);
    }
}

TEST(ShadowKernels, TheSameBodyTwiceHidesAsMuch) {
    std::size_t by_one = 0;
    for (const Case& of : cases()) {
        std::vector<ShadowBody> twice = of.bodies;
        twice.insert(twice.end(), of.bodies.begin(), of.bodies.end());
        const Shares once = shares_of(simd::InstructionSet::scalar, of.light, of.bodies, of.receivers);
        const Shares both = shares_of(simd::InstructionSet::scalar, of.light, twice, of.receivers);
        EXPECT_EQ(both.visible, once.visible);
        for (std::size_t i = 0; i < receiver_count; ++i) {
            if (once.hiding[i] != ShadowShares::several) ++by_one;
            EXPECT_EQ(both.hiding[i], ShadowShares::several);
        }
    }
    EXPECT_GT(by_one, 500U);
}

} // namespace
} // namespace gonio::transport
