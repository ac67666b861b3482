// Primitives against marching along the ray, their shadows against counted rays, and the named stages.
#include <gonio/measure/random.hpp>
#include <gonio/preview/ticks.hpp>
#include <gonio/scene/figure.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/web/integrate.hpp>

#include "../folders.hpp"
#include "../scaled.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
            // A step as long as the distance never goes past the surface. From inside nothing is hit.
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
            // Rays that graze may hit or miss.
            if (least > 1e-11) continue;
            ASSERT_EQ(t.has_value(), !is_sheet || from_lit_side) << kind << ' ' << i;
            if (!t) continue;
            ++met;
            EXPECT_NEAR(*t, marched, 1e-7) << kind; // marching stops 1e-11 before a surface that may be tilted by 1e-4
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
    // A sphere, a capsule and a box of 1 mm, 1 km away: 1e-6 of the distance.
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
    EXPECT_FALSE(distance_to(box, {{1.0, -5.0, 0.0}, {0.0, 1.0, 0.0}})); // in the plane of a face
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

// Rays from a receiver, uniform over the solid angle of a light's cap.
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
            // Counted rays see rectangles from their lit side only; both sides cast shadows.
            if (auto* panel = std::get_if<Panel>(&primitive); panel != nullptr) {
                if (glm::dot(point - panel->frame.origin, panel->frame.z) < 0.0) continue;
            }
            const double share = visible_share(with(primitive), 0, point, light, radius);
            const double counted = counted_share(primitive, point, light, angle);
            // 51 200 rays have an error of about 1e-3; approximating a capsule's ends by chords adds less.
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
    // A small cap is a plane disk: a quarter of it, with all digits.
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
        EXPECT_EQ(visible_share(with(back), 0, point, light, radius), 0.0); // both sides cast shadows
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
    // Half of a light that is half sunk into a wall is visible along the wall.
    EXPECT_NEAR(visible_share(with(Plane{{0, 0, 0}, {0, -1, 0}}), 0, {0, -1e-3, 0}, {0, 0, 3}, 0.5), 0.5, 1e-3);
    // A sphere with the light behind its horizon: the visible share grows steadily as the light comes in front of the
    // limb.
    double last = 0.0;
    for (double z = 2.0; z > 0.7; z -= 0.01) {
        const double share = visible_share(with(Ball{{0, 0.8, 1.5}, 0.8}), 0, point, {0, 0, z}, 0.05);
        EXPECT_LT(std::abs(share - last), z == 2.0 ? 1.0 : 0.2) << z;
        last = share;
    }
    EXPECT_EQ(last, 1.0);
}

Light hung_on(const Stage& stage, const char* shape) {
    LightDescription description;
    description.shape = parse_shape(shape).value();
    description.intensity = parse_photometric_value("800lm").value();
    hang(description, stage.light);
    Diagnostics diagnostics;
    return resolve_light(std::move(description), diagnostics).value();
}

// The outermost points of the light, in its frame.
std::vector<Vec> outline(const Shape& shape) {
    Vec half(0.0);
    double round = 0.0; // added in every direction
    if (const auto* const rect = std::get_if<RectShape>(&shape))
        half = {0.5 * rect->width.value, 0.5 * rect->height.value, 0.0};
    if (const auto* const disk = std::get_if<DiskShape>(&shape)) half = {disk->radius.value, disk->radius.value, 0.0};
    if (const auto* const sphere = std::get_if<SphereShape>(&shape)) round = sphere->radius.value;
    if (const auto* const tube = std::get_if<TubeShape>(&shape)) {
        half.x = 0.5 * tube->length.value;
        round = tube->radius.value;
    }
    std::vector<Vec> points;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                points.push_back(Vec(x, y, z) * half + round * Vec(x, y, z) / std::max(1.0, glm::length(Vec(x, y, z))));
    return points;
}

TEST(Stages, HangLightsOfOrdinarySizeClearOfEverything) {
    for (const StageKind& kind : stage_kinds())
        for (const char* const shape :
             {"tube:r=2cm,l=1.2m", "tube:r=13mm,l=60cm", "rect:w=60cm,h=60cm", "rect:w=1.2m,h=30cm",
              "rect:w=30cm,h=1.2m", "disk:r=30cm", "ellipse:w=1.2m,h=20cm", "sphere:r=12cm"}) {
            SCOPED_TRACE(std::string(kind.name) + " " + shape);
            const Stage stage = make_stage(kind.name).value();
            const Light light = hung_on(stage, shape);
            EXPECT_EQ(light.frame.origin, stage.light.position);
            for (const Vec& point : outline(light.shape)) {
                const Vec way = light.frame.to_world(point);
                const double length = glm::length(way);
                if (length == 0.0) continue;
                const auto hit = first_hit(stage, {light.frame.origin, way / length});
                EXPECT_TRUE(!hit || hit->distance > length) << "in " << stage.surfaces[hit->surface].name << " at "
                                                            << point.x << " " << point.y << " " << point.z;
            }
        }
}

// For all other lights C0 points at the wall, as it does for a profile.
TEST(Stages, TurnOnlyLightsThatWouldReachTheWall) {
    const Stage wall = make_stage("wall").value();
    for (const char* const shape : {"point", "disk:r=40cm", "ellipse:w=90cm,h=30cm", "rect:w=60cm,h=30cm",
                                    "tube:r=2cm,l=90cm", "spot:outer=20deg"})
        EXPECT_EQ(hung_on(wall, shape).frame.x, Vec(0, 1, 0)) << shape;
    for (const char* const shape : {"tube:r=2cm,l=1.2m", "tube:r=2cm,l=96cm", "rect:w=1m,h=30cm"})
        EXPECT_EQ(glm::abs(hung_on(wall, shape).frame.x), Vec(1, 0, 0)) << shape;
}

// Whether the camera sees a point in a picture of this size, with nothing between them.
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
            // Every solid that the stage shows is in the picture, and much of the visible part of its subjects is lit.
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

TEST(Stages, AFigureStandsOnThem) {
    for (const StageKind& kind : stage_kinds()) {
        Stage stage = make_stage(kind.name).value();
        const std::size_t own = stage.surfaces.size();
        add_figure(stage);
        double top = -100.0;
        double bottom = 100.0;
        for (std::size_t i = own; i < stage.surfaces.size(); ++i) {
            // Rays down from above and up from below through each part.
            const Ball around = bounds(stage.surfaces[i].geometry).value();
            for (int k = -20; k <= 20; ++k) {
                const Vec off(0.0, around.radius * k / 20.0, 10.0);
                const auto down = ray_distance(stage.surfaces[i].geometry, {around.center + off, {0, 0, -1}});
                const auto rise = ray_distance(stage.surfaces[i].geometry, {around.center - off, {0, 0, 1}});
                if (down) top = std::max(top, around.center.z + 10.0 - *down);
                if (rise) bottom = std::min(bottom, around.center.z - 10.0 + *rise);
            }
        }
        EXPECT_NEAR(top, stage.figure_position.z + figure_height, 1e-12) << kind.name;
        EXPECT_NEAR(bottom, stage.figure_position.z, 1e-4) << kind.name;
        EXPECT_TRUE(check_camera(stage, stage.camera)) << kind.name;
    }
}

TEST(Stages, CamerasThatSeeNothingAreRefused) {
    const Stage stage = make_stage("street").value();
    const auto refusal = [&](const Camera& camera) {
        const Result<void> checked = check_camera(stage, camera);
        return checked ? std::string("fine") : checked.error().diagnostics.front().message;
    };
    EXPECT_EQ(refusal({{0, 3, -1}, {0, 0, 0}}), "the camera at 0,3,-1 is behind 'road'");
    EXPECT_EQ(refusal({{0, 3, 0}, {0, 9, 2}}), "the camera at 0,3,0 is behind 'road'");
    EXPECT_EQ(refusal({{0, -0.6, 4}, {0, 0, 0}}), "the camera at 0,-0.6,4 is in 'pole'");
    EXPECT_EQ(refusal({{1, 2, 3}, {1, 2, 3}}), "the camera must not be at its own target");
    EXPECT_EQ(refusal({{1, 2, 3}, {1, 2, 0}, {0, 0.2, 1}}), "fine");
    EXPECT_EQ(refusal({{1, 2, 3}, {1, 4, 3}, {0, -1, 0}}), "the camera looks along its own up direction");
    EXPECT_EQ(refusal({{0, 3, 30}, {0, 3, 0}}), "fine"); // a plan view: the default up direction is replaced
}

TEST(Ticks, CoverWhatAveragesOfLinesDo) {
    EXPECT_EQ(tick_coverage(3.0, 0.0), 1.0);
    EXPECT_EQ(tick_coverage(-2.0, 0.0), 1.0);
    EXPECT_EQ(tick_coverage(3.1, 0.0), 0.0);
    EXPECT_NEAR(tick_coverage(0.0, 2.0 * tick_width), 0.5, 1e-12);
    EXPECT_NEAR(tick_coverage(0.37, 1e5), tick_width, 1e-7);
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const double at = random.uniform(-20.0, 20.0);
        const double width = std::exp(random.uniform(-6.0, 2.0));
        int inside = 0;
        for (int k = 0; k < 20000; ++k) {
            const double x = at + width * ((k + 0.5) / 20000 - 0.5);
            inside += std::abs(x - std::round(x)) <= 0.5 * tick_width ? 1 : 0;
        }
        EXPECT_NEAR(tick_coverage(at, width), inside / 20000.0, 1e-3);
    }
}

TEST(Ticks, LieOnSheetsAloneAndOnWholeMetres) {
    const Stage stage = make_stage("floor").value();
    Image image(96, 96, 3);
    std::fill(image.pixels.begin(), image.pixels.end(), 1.0F);
    draw_ticks(image, stage, {}, stage.camera, 2);
    const CameraRays rays(stage.camera, 96, 96);
    int dark = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            const Hit hit = first_hit(stage, rays.ray(x + 0.5, y + 0.5)).value();
            const float left = image.at(x, y)[0];
            EXPECT_TRUE(left >= 0.0624F && left <= 1.0F);
            const bool is_solid = stage.surfaces[hit.surface].name == "sphere";
            dark += left < 0.9F ? 1 : 0;
            // A pixel covers at most about 8 cm here.
            const auto off = [](double v) { return std::abs(v - std::round(v)); };
            const double side = hit.normal.z > 0.5 ? hit.position.y : hit.position.z;
            const bool between = off(hit.position.x) > 0.2 && off(side) > 0.2;
            EXPECT_TRUE(left == 1.0F || !(is_solid || between)) << x << ' ' << y;
        }
    EXPECT_GT(dark, 100);
}

// The lumens that arrive on the walls of the closed room: 3×3 Gauss-Legendre nodes in each of `cells`² rectangles of
// every wall, split at the lines where the light ends abruptly.
double arriving_flux(const Light& light, int cells, const Vec& cuts) {
    constexpr std::array node{-0.7745966692414834, 0.0, 0.7745966692414834};
    constexpr std::array weight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    double flux_lm = 0.0;
    const Stage room = make_stage("room").value();
    for (const Surface& surface : room.surfaces) {
        const auto* const panel = std::get_if<Panel>(&surface.geometry);
        if (panel == nullptr) continue;
        // Along an axis of the wall: nodes and their weights as lengths.
        const auto along = [&](const Vec& axis, double size) {
            std::vector<double> ends{-0.5 * size, 0.5 * size};
            for (int i = 0; i < 3; ++i)
                for (const double side : {-1.0, 1.0}) {
                    const double at = light.frame.origin[i] + side * cuts[i] - panel->frame.origin[i];
                    if (std::abs(axis[i]) == 1.0 && std::abs(at) < 0.5 * size) ends.push_back(axis[i] * at);
                }
            std::sort(ends.begin(), ends.end());
            std::vector<std::pair<double, double>> nodes;
            for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
                const double step = (ends[piece + 1] - ends[piece]) / cells;
                for (int cell = 0; cell < cells; ++cell)
                    for (std::size_t k = 0; k < 3; ++k)
                        nodes.emplace_back(ends[piece] + step * (cell + 0.5 + 0.5 * node[k]), 0.5 * step * weight[k]);
            }
            return nodes;
        };
        const auto across = along(panel->frame.x, panel->width);
        const auto upwards = along(panel->frame.y, panel->height);
        std::vector<Receiver> row(across.size());
        for (const auto& [y, height] : upwards) {
            for (std::size_t i = 0; i < row.size(); ++i)
                row[i] = {panel->frame.origin + across[i].first * panel->frame.x + y * panel->frame.y, panel->frame.z};
            const ProbeResult result = probe({&light, 1}, row).value();
            for (std::size_t i = 0; i < row.size(); ++i)
                flux_lm += result.illuminance_lx[i] * across[i].second * height;
        }
    }
    return flux_lm;
}

TEST(Stages, TheRoomReceivesTheFluxOfEveryLight) {
    struct Case {
        const char* shape;
        int cells;
        Vec cuts; // from the light's centre
    };
    const double none = 100.0;
    const double h = 2.3 * std::tan(30.0 * std::numbers::pi / 180.0); // half size of the frustum on the floor
    const double v = 2.3 * std::tan(20.0 * std::numbers::pi / 180.0);
    for (const Case& c :
         {Case{"point", 40, Vec(none)}, Case{"spot:outer=50deg,inner=20deg", 90, Vec(none)},
          Case{"frustum:h=60deg,v=40deg", 20, {h, v, none}}, Case{"sphere:r=10cm", 40, Vec(none)},
          Case{"disk:r=15cm", 40, {none, none, 0.0}}, Case{"rect:w=60cm,h=30cm", 40, {none, none, 0.0}},
          Case{"rect:w=60cm,h=30cm,two-sided", 40, {none, none, 0.0}}, Case{"tube:r=1.3cm,l=1.2m", 40, Vec(none)}}) {
        LightDescription description;
        description.shape = parse_shape(c.shape).value();
        description.intensity = parse_photometric_value("800lm").value();
        description.position = make_stage("room").value().light.position;
        Diagnostics diagnostics;
        const Light light = resolve_light(description, diagnostics).value();
        EXPECT_NEAR(arriving_flux(light, c.cells, c.cuts), 800.0, 800.0 * 1e-6) << c.shape;
    }
}

// A web bends at every angle of its table, so many cells are needed. Rotated, so that no bend runs along a wall.
TEST(Stages, TheRoomReceivesTheFluxOfEveryWeb) {
    constexpr std::array profiles{"street",    "accent", "bare-tube", "batwing",
                                  "downlight", "flood",  "pendant",   "wall-washer"};
    for (const char* name : test::scaled(profiles)) {
        LightDescription description;
        description.shape = ProfileShape{std::string(test::source_folder) + "/profiles/" + name + ".ies", nullptr};
        description.position = make_stage("room").value().light.position;
        description.rotation = degrees(17.0);
        Diagnostics diagnostics;
        const Light light = resolve_light(description, diagnostics).value();
        const double flux_lm = flux(*std::get<ProfileShape>(light.shape).web).value;
        EXPECT_NEAR(arriving_flux(light, 150, {100.0, 100.0, 0.0}), flux_lm, flux_lm * 1e-6) << name;
    }
}

} // namespace
} // namespace gonio
