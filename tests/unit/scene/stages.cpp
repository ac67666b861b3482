// Primitives against marching along the ray, their shadows against counted rays, and the stages by name.
#include <gonio/measure/random.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/stage.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio {
namespace {

using Vec = glm::dvec3;
using measure::Random;

Vec unit(Random& random) {
    for (;;) {
        const Vec v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const double length = glm::length(v);
        if (length > 0.1 && length < 1.0) return v / length;
    }
}

Vec within(Random& random, double half) {
    return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
}

Frame frame(Random& random) {
    return aimed_frame(within(random, 2.0), unit(random), unit(random));
}

// Signed distances, positive outside.
struct SignedDistance {
    Vec point;

    double operator()(const Plane& plane) const { return glm::dot(point - plane.point, plane.normal); }
    double operator()(const Panel& panel) const {
        return (*this)(Box{panel.frame, {0.5 * panel.width, 0.5 * panel.height, 0.0}});
    }
    double operator()(const Ball& ball) const { return glm::length(point - ball.center) - ball.radius; }
    double operator()(const Box& box) const {
        const Vec q = glm::abs(box.frame.to_local(point - box.frame.origin)) - box.half_size;
        return glm::length(glm::max(q, Vec(0.0))) + std::min(std::max({q.x, q.y, q.z}), 0.0);
    }
    double operator()(const Capsule& capsule) const {
        const Vec from = capsule.center - capsule.half_length * capsule.axis;
        const double along = glm::dot(point - from, capsule.axis) / (2.0 * capsule.half_length);
        return glm::length(point - from - std::clamp(along, 0.0, 1.0) * 2.0 * capsule.half_length * capsule.axis) -
               capsule.radius;
    }
};

double signed_distance(const Primitive& primitive, const Vec& point) {
    return std::visit(SignedDistance{point}, primitive);
}

std::optional<double> ray_distance(const Primitive& primitive, const Ray& ray) {
    return std::visit([&](const auto& shape) { return distance_to(shape, ray); }, primitive);
}

Primitive any_primitive(Random& random, int kind) {
    switch (kind) {
    case 0:
        return Plane{within(random, 2.0), unit(random)};
    case 1:
        return Panel{frame(random), random.uniform(0.2, 3.0), random.uniform(0.2, 3.0)};
    case 2:
        return Ball{within(random, 2.0), random.uniform(0.1, 1.5)};
    case 3:
        return Box{frame(random), {random.uniform(0.05, 1.5), random.uniform(0.05, 1.5), random.uniform(0.05, 1.5)}};
    default:
        return Capsule{within(random, 2.0), unit(random), random.uniform(0.05, 2.0), random.uniform(0.05, 0.8)};
    }
}

TEST(Primitives, RaysMeetThemWhereMarchingDoes) {
    Random random(1);
    for (int kind = 0; kind < 5; ++kind) {
        int met = 0;
        for (int i = 0; i < 4000; ++i) {
            const Primitive primitive = any_primitive(random, kind);
            const Vec origin = within(random, 4.0);
            const Ray ray{origin, glm::normalize(within(random, 2.0) - origin)};
            const auto t = ray_distance(primitive, ray);
            // A step as long as the distance never passes the surface. From inside there is nothing to meet.
            const bool is_sheet = kind < 2;
            double marched = 0.0;
            double least = signed_distance(primitive, ray.origin);
            const bool from_lit_side = glm::dot(normal_at(primitive, ray.origin), ray.direction) < 0.0;
            if (is_sheet) least = std::abs(least);
            if (!is_sheet && least <= 0.0) {
                EXPECT_FALSE(t) << kind;
                continue;
            }
            for (int step = 0; step < 400 && marched < 50.0; ++step) {
                const double distance = std::abs(signed_distance(primitive, ray.origin + marched * ray.direction));
                least = std::min(least, distance);
                if (distance < 1e-11) break;
                marched += distance;
            }
            if (marched >= 50.0) {
                EXPECT_TRUE(!t || *t > 49.0) << kind;
                continue;
            }
            // Rays that graze are either.
            if (least > 1e-11) continue;
            ASSERT_EQ(t.has_value(), !is_sheet || from_lit_side) << kind << ' ' << i;
            if (!t) continue;
            ++met;
            EXPECT_NEAR(*t, marched, 1e-7) << kind; // marching stops 1e-11 before a surface that may slant by 1e-4
            const Vec on = ray.origin + *t * ray.direction;
            EXPECT_NEAR(signed_distance(primitive, on), 0.0, 1e-13);
            const Vec normal = normal_at(primitive, on);
            EXPECT_NEAR(glm::length(normal), 1.0, 1e-14);
            EXPECT_LT(glm::dot(normal, ray.direction), 1e-7);
            EXPECT_TRUE(is_sheet || std::abs(signed_distance(primitive, on + 1e-3 * normal) - 1e-3) < 1e-12) << kind;
        }
        EXPECT_GT(met, 100) << kind;
    }
}

TEST(Primitives, FarAndThinBodiesKeepTheirOutline) {
    // A ball, a capsule and a box of 1 mm, 1 km away: 1e-6 of the distance.
    const Vec far(600.0, 0.0, 800.0);
    const Vec towards = far / 1000.0;
    const Vec side(0.0, 1.0, 0.0);
    for (const Primitive& primitive :
         {Primitive(Ball{far, 1e-3}), Primitive(Capsule{far, Vec(0.8, 0.0, -0.6), 1e-2, 1e-3}),
          Primitive(Box{{far, Vec(0.8, 0.0, -0.6), side, -towards}, Vec(1e-3)})}) {
        const auto t = ray_distance(primitive, {Vec(0.0), towards});
        ASSERT_TRUE(t);
        EXPECT_NEAR(*t, 1000.0 - 1e-3, 1e-9);
        const auto at = [&](double off) {
            return ray_distance(primitive, {Vec(0.0), glm::normalize(far + off * side)});
        };
        EXPECT_TRUE(at(0.9999e-3));
        EXPECT_FALSE(at(1.0001e-3));
    }
}

TEST(Primitives, RaysAlongAFaceOrAnAxis) {
    const Box box{{}, Vec(1.0, 2.0, 3.0)};
    EXPECT_FALSE(distance_to(box, {{1.0, -5.0, 0.0}, {0.0, 1.0, 0.0}})); // in a face
    EXPECT_EQ(distance_to(box, {{0.999, -5.0, 0.0}, {0.0, 1.0, 0.0}}), 3.0);
    EXPECT_FALSE(distance_to(box, {{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}})); // from inside
    EXPECT_FALSE(distance_to(box, {{0.0, 5.0, 0.0}, {0.0, 1.0, 0.0}})); // behind
    const Capsule capsule{{}, {0.0, 0.0, 1.0}, 2.0, 0.5};
    EXPECT_EQ(distance_to(capsule, {{0.0, 0.0, 5.0}, {0.0, 0.0, -1.0}}), 2.5);
    EXPECT_EQ(distance_to(capsule, {{0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}}), 2.5);
    EXPECT_FALSE(distance_to(capsule, {{0.51, 0.0, -5.0}, {0.0, 0.0, 1.0}}));
    EXPECT_FALSE(distance_to(capsule, {{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}));
    EXPECT_TRUE(hides(capsule, {0.0, 0.4, 1.9}));
    EXPECT_FALSE(hides(capsule, {0.0, 0.51, 0.0}));
    for (int i = 0; i < 6; ++i) {
        const Panel side = face(box, i);
        EXPECT_EQ(face_at(box, side.frame.origin), i);
        EXPECT_EQ(side.frame.z, normal_at(box, side.frame.origin));
        EXPECT_EQ(glm::cross(side.frame.x, side.frame.y), side.frame.z);
        for (const Vec& corner : corners(side))
            EXPECT_NEAR(std::abs(signed_distance(box, corner)), 0.0, 1e-15);
    }
}

// Rays from a receiver, evenly over the solid angle of a light's cap.
double counted_share(const Primitive& primitive, const Vec& point, const Vec& light, double angle) {
    const Frame frame = aimed_frame(point, point - light, {0.3, 0.5, 0.7});
    const int rings = 160;
    const int around = 320;
    long free = 0;
    for (int i = 0; i < rings; ++i) {
        const double s2 = std::pow(std::sin(0.5 * angle), 2) * (i + 0.5) / rings; // sin²(θ/2)
        const double sine = 2.0 * std::sqrt(s2 * (1.0 - s2));
        for (int k = 0; k < around; ++k) {
            const double phi = 2.0 * std::numbers::pi * (k + 0.5 * (i % 2)) / around;
            const Vec local(sine * std::cos(phi), sine * std::sin(phi), 1.0 - 2.0 * s2);
            free += ray_distance(primitive, {point, frame.to_world(local)}) ? 0 : 1;
        }
    }
    return static_cast<double>(free) / (double(rings) * around);
}

Stage with(const Primitive& primitive) {
    Stage stage;
    stage.surfaces.push_back({"floor", Plane{{0, 0, -100}, {0, 0, 1}}, LambertMaterial{}});
    stage.surfaces.push_back({"body", primitive, LambertMaterial{}});
    return stage;
}

TEST(Occlusion, SharesAgreeWithCountedRays) {
    Random random(2);
    for (int kind = 1; kind < 5; ++kind) {
        int partial = 0;
        while (partial < 8) {
            Primitive primitive = any_primitive(random, kind);
            // Between the receiver at (0, 0, -8) and the light at (0, 0, 8).
            const Vec point(0.0, 0.0, -8.0);
            const Vec light(0.0, 0.0, 8.0);
            const double radius = random.uniform(0.5, 5.0);
            const double angle = std::asin(radius / 16.0);
            // Counted rays see panels from their lit side only; shadows are cast by both.
            if (auto* panel = std::get_if<Panel>(&primitive); panel != nullptr) {
                if (glm::dot(point - panel->frame.origin, panel->frame.z) < 0.0) continue;
            }
            const double share = visible_share(with(primitive), 0, point, light, radius);
            const double counted = counted_share(primitive, point, light, angle);
            // 51 200 rays leave about 1e-3; the chords of a capsule's ends leave less.
            ASSERT_NEAR(share, counted, 3e-3) << kind;
            const double of_sun = visible_share_of_sun(with(primitive), 0, point, glm::normalize(light - point), angle);
            ASSERT_NEAR(of_sun, counted, 3e-3) << kind;
            if (counted > 0.02 && counted < 0.98) ++partial;
        }
    }
}

TEST(Occlusion, MovedTurnedAndScaledStagesHaveTheSameShadows) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const Vec point(0.0, 0.0, -5.0);
        const Vec light(0.0, 0.0, 5.0);
        const Primitive primitive = any_primitive(random, 1 + i % 4);
        const double radius = i % 3 == 0 ? 0.0 : random.uniform(0.001, 3.0);
        const double share = visible_share(with(primitive), 0, point, light, radius);
        const Frame to = frame(random);
        const double scale = std::exp(random.uniform(-5.0, 5.0));
        const auto moved = [&](const Vec& p) { return scale * (to.origin + to.to_world(p)); };
        const auto moved_frame = [&](const Frame& f) {
            return Frame{moved(f.origin), to.to_world(f.x), to.to_world(f.y), to.to_world(f.z)};
        };
        Primitive other = primitive;
        if (auto* panel = std::get_if<Panel>(&other))
            *panel = {moved_frame(panel->frame), scale * panel->width, scale * panel->height};
        if (auto* ball = std::get_if<Ball>(&other)) *ball = {moved(ball->center), scale * ball->radius};
        if (auto* box = std::get_if<Box>(&other)) *box = {moved_frame(box->frame), scale * box->half_size};
        if (auto* capsule = std::get_if<Capsule>(&other))
            *capsule = {moved(capsule->center), to.to_world(capsule->axis), scale * capsule->half_length,
                        scale * capsule->radius};
        EXPECT_NEAR(visible_share(with(other), 0, moved(point), moved(light), scale * radius), share,
                    radius > 0.0 ? 1e-6 : 0.0)
            << i;
    }
}

TEST(Occlusion, PolygonsHaveTheirLimits) {
    const double a = 0.3;
    const double cap = 2.0 * std::numbers::pi * (1.0 - std::cos(a));
    const std::vector<glm::dvec2> around{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    EXPECT_NEAR(polygon_overlap(a, around), cap, 1e-15);
    EXPECT_NEAR(polygon_overlap(1.5, around), 2.0 * std::numbers::pi / 3.0, 1e-14); // a face of the cube: 4π/6
    const std::vector<glm::dvec2> half{{0, -1}, {1, -1}, {1, 1}, {0, 1}};
    EXPECT_NEAR(polygon_overlap(a, half), 0.5 * cap, 1e-15); // an edge through the axis
    const std::vector<glm::dvec2> beside{{0.4, -1}, {1, -1}, {1, 1}, {0.4, 1}};
    EXPECT_EQ(polygon_overlap(a, beside), 0.0);
    EXPECT_EQ(polygon_overlap(a, {}), 0.0);
    // A small cap is a plane's disk: a quarter of it, with all its digits.
    const double small = 1e-7;
    const std::vector<glm::dvec2> quarter{{0, 0}, {1, 0}, {0, 1}};
    EXPECT_NEAR(polygon_overlap(small, quarter), 0.25 * std::numbers::pi * small * small, 1e-13 * small * small);
}

TEST(Occlusion, OnlyWhatIsBetweenCovers) {
    const Vec point(0.0);
    const Vec light(0.0, 0.0, 3.0);
    const Panel sheet = panel_facing({0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}, {0, 1, 0}, 1.0, 1.0);
    Panel back = sheet;
    back.frame.z = -sheet.frame.z;
    for (const double radius : {0.0, 0.1}) {
        EXPECT_EQ(visible_share(with(sheet), 0, point, light, radius), 0.0);
        EXPECT_EQ(visible_share(with(back), 0, point, light, radius), 0.0); // sheets cover from both sides
        EXPECT_EQ(visible_share(with(sheet), 1, point, light, radius), 1.0);
        EXPECT_EQ(visible_share(with(sheet), 0, point, {0.0, 0.0, 0.5}, radius), 1.0);
        EXPECT_EQ(visible_share(with(Plane{{0, 0, 1}, {0, 0, 1}}), 0, point, light, radius), 0.0);
        EXPECT_EQ(visible_share(with(Plane{{0, 0, 4}, {0, 0, -1}}), 0, point, light, radius), 1.0);
        EXPECT_EQ(visible_share(with(Box{{{0, 0, 1}}, Vec(0.2)}), 0, point, light, radius), 0.0);
        EXPECT_EQ(visible_share(with(Box{{{0, 0, 4}}, Vec(0.2)}), 0, point, light, radius), 1.0);
        EXPECT_EQ(visible_share(with(Capsule{{0, 0, 1}, {1, 0, 0}, 0.5, 0.3}), 0, point, light, radius), 0.0);
        EXPECT_EQ(visible_share(with(Capsule{{0, 0, 1}, {0, 0, 1}, 0.5, 0.3}), 0, point, light, radius), 0.0);
    }
    EXPECT_EQ(visible_share_of_sun(with(sheet), 0, point, {0, 0, 1}, 0.0), 0.0);
    EXPECT_EQ(visible_share_of_sun(with(sheet), 0, point, {0, 0.8, 0.6}, 0.1), 1.0);
    EXPECT_EQ(visible_share_of_sun(with(Plane{{0, 0, 1e6}, {0, 0, -1}}), 0, point, {0, 0, 1}, 0.1), 0.0);
    // A light half sunk into a wall is half seen along it.
    EXPECT_NEAR(visible_share(with(Plane{{0, 0, 0}, {0, -1, 0}}), 0, {0, -1e-3, 0}, {0, 0, 3}, 0.5), 0.5, 1e-3);
    // A ball behind whose horizon the light stands: its share grows steadily as the light comes before the limb.
    double last = 0.0;
    for (double z = 2.0; z > 0.7; z -= 0.01) {
        const double share = visible_share(with(Ball{{0, 0.8, 1.5}, 0.8}), 0, point, {0, 0, z}, 0.05);
        EXPECT_LT(std::abs(share - last), z == 2.0 ? 1.0 : 0.2) << z;
        last = share;
    }
    EXPECT_EQ(last, 1.0);
}

// Whether the camera sees a point in a picture of this size, nothing between them.
bool in_picture(const Camera& camera, const Vec& point, int width, int height) {
    const CameraRays rays(camera, width, height);
    const Vec a = rays.ray(0, 0).direction;
    const Vec b = rays.ray(width, 0).direction;
    const Vec c = rays.ray(width, height).direction;
    const Vec d = rays.ray(0, height).direction;
    const Vec to = point - camera.position;
    const auto inside = [&](const Vec& p, const Vec& q) { return glm::dot(glm::cross(p, q), to) > 0.0; };
    return inside(a, b) && inside(b, c) && inside(c, d) && inside(d, a);
}

TEST(Stages, AreFramedLitAndStandOnTheGround) {
    for (const StageKind& kind : stage_kinds()) {
        SCOPED_TRACE(kind.name);
        const Stage stage = make_stage(kind.name).value();
        EXPECT_EQ(stage.name, kind.name);
        EXPECT_TRUE(check_camera(stage, stage.camera));
        EXPECT_EQ(std::count_if(stage.surfaces.begin(), stage.surfaces.end(),
                                [&](const Surface& s) { return hides(s.geometry, stage.light.position); }),
                  0);
        const auto ground = first_hit(stage, {stage.figure_position + Vec(0, 0, 1e-3), {0, 0, -1}});
        ASSERT_TRUE(ground);
        EXPECT_NEAR(ground->distance, 1e-3, 1e-12);
        for (const auto& [width, height] : {std::pair(512, 512), std::pair(1600, 400), std::pair(300, 900)}) {
            EXPECT_TRUE(in_picture(stage.camera, stage.figure_position + Vec(0, 0, 0.9), width, height));
            // Every solid that the stage shows is in the picture, and of what is seen of its subjects much is lit.
            int seen = 0;
            int lit = 0;
            const CameraRays rays(stage.camera, width, height);
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 40; ++x) {
                    const auto hit = first_hit(stage, rays.ray((x + 0.5) * width / 40, (y + 0.5) * height / 40));
                    if (!hit || !stage.surfaces[hit->surface].subject) continue;
                    const Vec to_light = stage.light.position - hit->position;
                    ++seen;
                    lit += glm::dot(hit->normal, to_light) > 0.0 &&
                                   visible_share(stage, hit->surface, hit->position, stage.light.position, 0.0) > 0.5
                               ? 1
                               : 0;
                }
            EXPECT_GE(seen, 10);
            EXPECT_GT(lit, 0.3 * seen);
        }
        for (const Surface& surface : stage.surfaces) {
            const auto around = bounds(surface.geometry);
            if (!surface.subject || !around || around->radius > 3.0) continue;
            EXPECT_TRUE(in_picture(stage.camera, around->center, 512, 512)) << surface.name;
        }
    }
    EXPECT_EQ(make_stage("corridr").error().diagnostics.front().hint.substr(0, 25), "did you mean 'corridor'? ");
}

TEST(Stages, CamerasThatSeeNothingAreRefused) {
    const Stage stage = make_stage("street").value();
    const auto refusal = [&](const Camera& camera) {
        const Result<void> checked = check_camera(stage, camera);
        return checked ? std::string("fine") : checked.error().diagnostics.front().message;
    };
    EXPECT_EQ(refusal({{0, 3, -1}, {0, 0, 0}}), "the camera at 0,3,-1 stands behind 'road'");
    EXPECT_EQ(refusal({{0, 3, 0}, {0, 9, 2}}), "the camera at 0,3,0 stands behind 'road'");
    EXPECT_EQ(refusal({{0, -0.6, 4}, {0, 0, 0}}), "the camera at 0,-0.6,4 stands in 'pole'");
    EXPECT_EQ(refusal({{1, 2, 3}, {1, 2, 3}}), "the camera must not stand at its own target");
    EXPECT_EQ(refusal({{1, 2, 3}, {1, 2, 0}, {0, 0.2, 1}}), "fine");
    EXPECT_EQ(refusal({{1, 2, 3}, {1, 4, 3}, {0, -1, 0}}), "the camera looks along its own up direction");
    EXPECT_EQ(refusal({{0, 3, 30}, {0, 3, 0}}), "fine"); // a plan: the default up direction gives way
}

} // namespace
} // namespace gonio
