#include <gonio/light/shape_traits.hpp>
#include <gonio/preview/reference_picture.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/capsule_overlap.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/light_lines.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/shadow_body.hpp>
#include <gonio/scene/shadow_line.hpp>
#include <gonio/scene/shadow_section.hpp>
#include <gonio/shading/sample_cylinder.hpp>
#include <gonio/shading/sample_disk.hpp>
#include <gonio/shading/sample_tube.hpp>
#include <gonio/sky/sky.hpp>

#include "../light/lights.hpp"
#include "numbers.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gonio {
namespace {

using Vec = glm::dvec3;

using test::Numbers;

Primitive any_body(Numbers& numbers, int kind) {
    const Vec center = numbers.in_box(3.0);
    const Vec axis = numbers.direction();
    if (kind == 0) return Plane{center, axis};
    if (kind == 1)
        return panel_facing(center, axis, numbers.direction(), numbers.between(0.2, 6), numbers.between(0.2, 6));
    if (kind == 2) return Ball{center, numbers.between(0.1, 3.0)};
    if (kind == 3)
        return Box{aimed_frame(center, axis, numbers.direction()),
                   {numbers.between(0.1, 2), numbers.between(0.1, 2), numbers.between(0.1, 2)}};
    return Capsule{center, axis, numbers.between(0.0, 3.0), numbers.between(0.05, 1.5)};
}

// Whether the ray meets any part of the body; planes and rectangles count from both sides.
bool meets(const Primitive& body, const Vec& from, const Vec& way) {
    const double length = glm::length(way);
    const Ray ray{from, way / length};
    const auto before = [&](const std::optional<double>& distance) { return distance && *distance <= length; };
    if (const auto* plane = std::get_if<Plane>(&body))
        return before(distance_to(*plane, ray)) || before(distance_to(Plane{plane->point, -plane->normal}, ray));
    if (const auto* panel = std::get_if<Panel>(&body)) {
        Panel back = *panel;
        back.frame.z = -back.frame.z;
        return before(distance_to(*panel, ray)) || before(distance_to(back, ray));
    }
    return std::visit([&](const auto& shape) { return before(distance_to(shape, ray)); }, body);
}

Vec vector(const double (&v)[3]) {
    return {v[0], v[1], v[2]};
}

shading::vec3<double> numbers_of(const Vec& v) {
    return {v.x, v.y, v.z};
}

TEST(ShadowLine, HiddenPiecesAreWhatRaysMeet) {
    Numbers numbers(5);
    std::array<int, 5> partly{};
    for (int i = 0; i < 6000; ++i) {
        const int kind = i % 5;
        const Primitive body = any_body(numbers, kind);
        const Vec receiver = numbers.in_box(6.0);
        if (kind > 1 && hides(body, receiver)) continue;
        const Vec from = numbers.in_box(6.0) - receiver;
        const Vec to = numbers.in_box(6.0) - receiver;
        const detail::LightLineSeen<double> line(numbers_of(from), numbers_of(to));
        const detail::ShadowBody solid = detail::shadow_body(body, detail::LinedLight());
        detail::with_hiding(solid, numbers_of(receiver), [&](const auto& hiding) {
            const detail::HiddenPiece<double> piece = hiding.hidden(line);
            for (int j = 0; j <= 40; ++j) {
                const double t = j / 40.0;
                if (piece.is_there() && std::min(std::abs(t - piece.low), std::abs(t - piece.high)) < 1e-7) continue;
                const bool within = piece.is_there() && t > piece.low && t < piece.high;
                const Vec way = from + t * (to - from);
                ASSERT_EQ(within, meets(body, receiver, way)) << kind << " in case " << i << " at " << t;
            }
            if (piece.is_there() && (piece.low > 0.0 || piece.high < 1.0)) ++partly[static_cast<std::size_t>(kind)];
        });
    }
    for (const int count : partly)
        EXPECT_GT(count, 50);
}

const std::array<Light, 7>& lights() {
    static const std::array made{light_of("sphere:r=30cm", "1000cd", {0.1, -0.2, 2.4}),
                                 light_of("disk:r=40cm", "1000cd", {0.1, -0.2, 2.4}, {0.2, 0.1, -1.0}),
                                 light_of("ellipse:w=1.2m,h=30cm", "1000cd", {0.1, -0.2, 2.4}, {0.2, 0.1, -1.0}),
                                 light_of("rect:w=1m,h=40cm", "1000cd", {0.1, -0.2, 2.4}, {0.2, 0.1, -1.0}),
                                 light_of("rect:w=20cm,h=2m", "1000cd", {0.1, -0.2, 2.4}),
                                 light_of("tube:r=8cm,l=1.2m", "1000cd", {0.1, -0.2, 2.4}, {0.0, 0.0, -1.0}),
                                 light_of("cylinder:r=20cm,l=60cm", "1000cd", {0.1, -0.2, 2.4}, {0.0, 0.0, -1.0})};
    return made;
}

// By many points of the light, on both sides of the plane.
TEST(ShadowBody, IsApartFromALightThatAPlaneParts) {
    Numbers numbers(6);
    std::array<int, 2> found{};
    for (int i = 0; i < 7000; ++i) {
        const Light& light = lights()[static_cast<std::size_t>(i) % lights().size()];
        const Ball around{light.frame.origin, 1.01};
        const Primitive body = any_body(numbers, i % 5);
        const detail::ShadowBody solid = detail::shadow_body(body, detail::lined_light(light, around));
        // The nearest that rays from anywhere meet the light, and through the body.
        bool is_met = false;
        for (int j = 0; j < 60 && !is_met; ++j) {
            const Vec from = light.frame.origin + numbers.in_box(3.0);
            const Vec way = light.frame.origin + numbers.in_box(1.0) - from;
            const std::optional<double> reach = distance_to(light, {from, glm::normalize(way)});
            if (!reach) continue;
            const Vec at = from + *reach * glm::normalize(way);
            if (solid.is_apart) {
                EXPECT_GT(glm::dot(at - vector(solid.between), vector(solid.to_light)), 0.0) << i;
            }
            is_met = !is_sheet(body) && hides(body, at);
        }
        EXPECT_FALSE(is_met && solid.is_apart) << i;
        ++found[solid.is_apart ? 1 : 0];
    }
    EXPECT_GT(found[0], 500);
    EXPECT_GT(found[1], 3000);
}

detail::LightLines<double> lines_of(const detail::LinedLight& light, const Vec& point, const Vec& hint) {
    detail::LightLines<double> lines;
    lines.frame = detail::light_frame(light, numbers_of(point), numbers_of(hint));
    detail::find_light_lines(light, lines);
    return lines;
}

// The solid angle times cosine, summed over all stripes, against the closed form.
TEST(LightLines, SumToTheLight) {
    Numbers numbers(7);
    for (const Light& light : lights())
        for (int i = 0; i < 200; ++i) {
            const Vec point = numbers.in_box(2.0) * Vec(1, 1, 0);
            const detail::LinedLight lined = detail::lined_light(light, Ball{});
            const detail::LightLines<double> lines = lines_of(lined, point, numbers.direction());
            ASSERT_TRUE(lines.frame.is_seen);
            double sum = 0.0;
            for (const detail::LightLine<double>& line : lines.lines)
                for (int cell = 0; cell < 16; ++cell) {
                    const double sine = line.low_sine + line.width * (cell + 0.5) / 16.0;
                    sum += line.solid_angle() / 16.0 * lines.direction(line, sine).z;
                }
            const Receiver receiver{point, {0, 0, 1}};
            const double lx = probe({&light, 1}, {&receiver, 1}).value().illuminance_lx.front();
            // Stripes that end at the corners of a rectangle are cut short there.
            const bool round = !std::holds_alternative<RectShape>(light.shape);
            EXPECT_NEAR(sum * light.luminance.value, lx, (round ? 0.007 : 0.08) * lx) << kind_of(light.shape);
        }
}

// The slopes that bodies hide of each line, apart from the light, from receivers on all sides of both.
TEST(ShadowSection, HiddenSlopesAreWhatRaysMeet) {
    Numbers numbers(8);
    std::array<int, 5> partly{};
    std::array<int, 5> behind{};
    for (int i = 0; i < 20000; ++i) {
        const auto kind = static_cast<std::size_t>(i % 5);
        const Light& light = lights()[static_cast<std::size_t>(i) % lights().size()];
        const Ball around{light.frame.origin, 1.01};
        const Primitive body = any_body(numbers, static_cast<int>(kind));
        const detail::LinedLight lined = detail::lined_light(light, around);
        const detail::ShadowBody solid = detail::shadow_body(body, lined);
        const Vec receiver = numbers.in_box(6.0);
        if (!solid.is_apart || (kind > 1 && hides(body, receiver))) continue;
        const detail::LightLines<double> lines = lines_of(lined, receiver, numbers.direction());
        if (!lines.frame.is_seen) continue;
        detail::with_section<double>(solid, [&]<class Section>(const Section* /*type*/) {
            double of_body[16] = {};
            const bool may_hide = Section::put(solid, numbers_of(receiver), lines.frame, of_body) &&
                                  detail::is_before_light(solid, numbers_of(receiver));
            const Section section(solid, of_body, lines.frame.rise);
            for (const detail::LightLine<double>& line : lines.lines) {
                const detail::HiddenSlopes<double> piece =
                    may_hide ? section.hidden(line) : detail::HiddenSlopes<double>();
                for (int j = 1; j < 20; ++j) {
                    const double x = line.low_x + (line.high_x - line.low_x) * j / 20.0;
                    const double y =
                        line.low_x * line.low + (line.high_x * line.high - line.low_x * line.low) * j / 20.0;
                    if (std::min(std::abs(y / x - piece.low), std::abs(y / x - piece.high)) < 1e-6) continue;
                    const bool within = piece.is_there() && y / x > piece.low && y / x < piece.high;
                    const shading::vec3<double> way = lines.position(line, x, y / x);
                    ASSERT_EQ(within, meets(body, receiver, Vec(way.x, way.y, way.z)))
                        << kind << " in case " << i << " at " << j;
                }
                const bool is_part = piece.low > line.low || piece.high < line.high;
                if (piece.is_there() && is_part) ++partly[kind];
            }
            if (!may_hide) ++behind[kind];
        });
    }
    for (std::size_t kind = 1; kind < partly.size(); ++kind) {
        EXPECT_GT(partly[kind], 200) << kind;
        EXPECT_GT(behind[kind], 100) << kind;
    }
    EXPECT_EQ(partly[0], 0); // a plane apart from the light hides all of it or nothing
}

// ∫ ⟨n·l⟩ V over the light by many stratified directions of its sampler, as a fraction of the unoccluded integral.
double counted_share(const Stage& stage, std::size_t own, const Light& light, const Vec& point, const Vec& normal,
                     int side) {
    const auto vec = [](const Vec& v) { return shading::vec3<double>{v.x, v.y, v.z}; };
    const auto count = [&](const auto& sampler) {
        double all = 0.0;
        double seen = 0.0;
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                const auto sample = sampler.sample((i + 0.5) / side, (j + 0.5) / side);
                const Vec l(sample.direction.x, sample.direction.y, sample.direction.z);
                const double weight = std::max(glm::dot(normal, l), 0.0) / sample.pdf;
                const std::optional<double> reach = distance_to(light, {point, l});
                if (!reach) continue; // misses by rounding
                all += weight;
                bool hidden = false;
                for (std::size_t s = 0; s < stage.surfaces.size() && !hidden; ++s)
                    hidden = s != own && meets(stage.surfaces[s].geometry, point, l * *reach);
                if (!hidden) seen += weight;
            }
        return all > 0.0 ? seen / all : 1.0;
    };
    const shading::vec3<double> center = vec(light.frame.origin - point);
    const shading::vec3<double> axis = vec(-light.frame.z);
    if (const auto* s = std::get_if<SphereShape>(&light.shape))
        return count(shading::SphereSampler<double>(center, s->radius.value));
    if (const auto* s = std::get_if<DiskShape>(&light.shape))
        return count(shading::DiskSampler<double>(center, axis, s->radius.value));
    if (const auto* s = std::get_if<EllipseShape>(&light.shape)) {
        const auto seen = ShapeTraits<EllipseShape>::core(*s, light.frame, light.color).seen_from(center);
        return count(shading::DiskSampler<double>(seen.to_center, seen.light.axis, seen.light.radius));
    }
    if (const auto* s = std::get_if<RectShape>(&light.shape))
        return count(
            shading::RectangleSampler<double>(center, axis, vec(light.frame.x), s->width.value, s->height.value));
    if (const auto* s = std::get_if<CylinderShape>(&light.shape))
        return count(shading::CylinderSampler<double>(center, vec(light.frame.x), s->radius.value, s->length.value));
    const auto& s = std::get<TubeShape>(light.shape);
    return count(shading::TubeSampler<double>(center, vec(light.frame.x), s.radius.value, s.length.value));
}

// A floor under bodies that hide parts of the light, seen from above.
Stage floor_under(std::initializer_list<Primitive> bodies) {
    Stage stage;
    stage.surfaces.push_back({"floor", Plane{}, LambertMaterial{}});
    for (const Primitive& body : bodies)
        stage.surfaces.push_back({"body", body, LambertMaterial{}});
    stage.camera = {{0, 0, 12}, {0, 0, 0}, {0, 1, 0}, 20.0};
    return stage;
}

Rendering lit(const Stage& stage, const Light& light, RenderOptions options) {
    options.illuminance = true;
    return render(stage, {&light, 1}, stage.camera, options).value();
}

// Soft shadows of all shapes behind all bodies, several of them overlapping each other, against counted rays: the
// remaining error of the stripes in the penumbrae.
TEST(ThreadsSoftShadows, PenumbraeAreThoseOfCountedRays) {
    const std::array stages{
        floor_under({Ball{{0.1, -0.1, 1.0}, 0.3}}), floor_under({Capsule{{0, 0, 1.0}, {0.6, 0.8, 0.0}, 0.5, 0.12}}),
        floor_under({Box{{{0.1, 0, 0.9}, {0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}}, {0.4, 0.2, 0.1}}}),
        floor_under({panel_facing({0, 0, 1.2}, {0.3, 0, 1}, {0, 1, 0}, 0.8, 0.5)}),
        floor_under(
            {Ball{{-0.1, 0.1, 1.0}, 0.25}, Ball{{0.1, 0.1, 1.4}, 0.2}, Capsule{{0, 0, 0.7}, {1, 0, 0}, 0.6, 0.05}})};
    RenderOptions options;
    options.width = 160;
    options.height = 160;
    double squares = 0.0;
    int count = 0;
    for (const Stage& stage : stages) {
        const CameraRays rays(stage.camera, options.width, options.height);
        for (const Light& light : lights()) {
            options.shadows = Shadows::soft;
            const Rendering soft = lit(stage, light, options);
            options.shadows = Shadows::off;
            const Rendering bare = lit(stage, light, options);
            for (int y = 3; y + 1 < options.height; y += 8)
                for (int x = 3; x + 1 < options.width; x += 8) {
                    const std::optional<Hit> hit = first_hit(stage, rays.ray(x + 0.5, y + 0.5));
                    const float all = *bare.illuminance_lx.at(x, y);
                    const double share = *soft.illuminance_lx.at(x, y) / all;
                    if (hit->surface != 0 || !(share > 0.0) || !(share < 1.0)) continue;
                    // Pixels on an outline average over points of other surfaces, so skip them.
                    const auto floor_at = [&](double dx, double dy) {
                        return first_hit(stage, rays.ray(x + 0.5 + dx, y + 0.5 + dy))->surface == 0;
                    };
                    if (!floor_at(1, 0) || !floor_at(-1, 0) || !floor_at(0, 1) || !floor_at(0, -1)) continue;
                    const double truth = counted_share(stage, 0, light, hit->position, hit->normal, 64);
                    squares += (share - truth) * (share - truth);
                    ++count;
                    EXPECT_NEAR(share, truth, 0.09) << kind_of(light.shape) << " at " << x << ", " << y;
                }
        }
    }
    EXPECT_GT(count, 500);
    EXPECT_LT(std::sqrt(squares / count), 0.011);
    RecordProperty("rms_percent", std::to_string(100.0 * std::sqrt(squares / count)));
}

// A half hidden light on brushed metal: the same picture when all is turned about the vertical, as tangents are level.
TEST(SoftShadows, TurnWithBrushedMetal) {
    const auto picture = [](double turn) {
        const auto turned = [&](const Vec& p) {
            return Vec(std::cos(turn) * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + std::cos(turn) * p.y, p.z);
        };
        Stage stage;
        const Material brushed = parse_material("ggx:f0=0.9,alpha=0.2,anisotropy=0.9,rotation=30").value();
        stage.surfaces = {{"wall", Plane{turned({0, 1, 0}), turned({0, -0.8, 0.6})}, brushed},
                          {"ball", Ball{turned({0.1, 0.0, 0.7}), 0.3}, LambertMaterial{}}};
        stage.camera = {turned({0.4, -3.0, 1.0}), turned({0, 1, 0.2}), {0, 0, 1}, 30.0};
        const Light light =
            light_of("rect:w=60cm,h=30cm", "1000lm", turned({0, -0.8, 1.8}), turned({0, 0.6, -0.8}), turned({1, 0, 0}));
        RenderOptions options;
        options.width = 64;
        options.height = 48;
        options.bounces = 0;
        options.shadows = Shadows::soft;
        return lit(stage, light, options).luminance_nt.pixels;
    };
    const auto straight = picture(0.0);
    for (const double turn : {0.6, 2.5, 4.0}) {
        const auto other = picture(turn);
        ASSERT_EQ(other.size(), straight.size());
        double apart = 0.0;
        double all = 0.0;
        for (std::size_t i = 0; i < other.size(); ++i) {
            apart += static_cast<double>(std::fabs(other[i] - straight[i]));
            all += static_cast<double>(straight[i]);
        }
        ASSERT_GT(all, 0.0);
        EXPECT_LT(apart, 1e-3 * all) << turn;
    }
}

// How much a sphere hides of a spherical light, including the cosine, against the integral over the cap in rings.
TEST(SoftShadows, CapsHideWhatTheirIntegralSays) {
    Numbers numbers(9);
    for (int i = 0; i < 60; ++i) {
        const Vec a_axis(0, 0, 1);
        const double a = std::exp(numbers.between(std::log(1e-3), std::log(0.6)));
        const double b = std::exp(numbers.between(std::log(0.2), std::log(3.0))) * a;
        const double apart = numbers.between(0.0, 1.1 * (a + b));
        const Vec b_axis(std::sin(apart), 0.0, std::cos(apart));
        const double tilt = numbers.between(0.0, 0.5 * std::numbers::pi - a);
        const double turn = numbers.between(0.0, 2.0 * std::numbers::pi);
        const Vec normal(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
        // In rings about the first axis; the other cap covers each of them about the azimuth 0.
        double sum = 0.0;
        constexpr int rings = 4000;
        for (int ring = 0; ring < rings; ++ring) {
            const double theta = a * (ring + 0.5) / rings;
            const double sine = std::sin(theta);
            const double cosine = std::cos(theta);
            const double x = (std::cos(b) - cosine * std::cos(apart)) / (sine * std::sin(apart));
            const double half = std::acos(std::clamp(x, -1.0, 1.0));
            sum += (2.0 * half * cosine * normal.z + 2.0 * std::sin(half) * sine * normal.x) * sine * (a / rings);
        }
        EXPECT_NEAR(projected_cap_overlap(a_axis, a, b_axis, b, normal), sum, 2e-4 * a * a) << i;
    }
}

// How much a capsule hides of a spherical light, against directions over the cap, each tested with a ray.
TEST(SoftShadows, CapsulesHideWhatRaysSay) {
    Numbers numbers(11);
    int cut = 0;
    for (int i = 0; i < 120; ++i) {
        const double a = std::exp(numbers.between(std::log(1e-2), std::log(0.6)));
        const double length = std::exp(numbers.between(std::log(0.3), std::log(30.0)));
        const double radius = std::exp(numbers.between(std::log(0.03), std::log(1.5))) * a;
        Capsule capsule{numbers.direction(), numbers.direction(), 0.5 * length * a, radius};
        capsule.center = Vec(1.5 * a * capsule.center.x, 1.5 * a * capsule.center.y, 1.0);
        if (hides(capsule, Vec(0.0))) continue;
        const double tilt = numbers.between(0.0, 0.5 * std::numbers::pi - a);
        const Vec normal(std::sin(tilt), 0.0, std::cos(tilt));
        // Uniform in height, on a lattice.
        constexpr int count = 40000;
        const double height = 1.0 - std::cos(a);
        double sum = 0.0;
        for (int k = 0; k < count; ++k) {
            const double z = 1.0 - height * (k + 0.5) / count;
            const double phi = 2.399963229728653 * k;
            const double across = std::sqrt((1.0 - z) * (1.0 + z));
            const Vec direction(across * std::cos(phi), across * std::sin(phi), z);
            if (distance_to(capsule, {Vec(0.0), direction})) sum += glm::dot(normal, direction);
        }
        sum *= 2.0 * std::numbers::pi * height / count;
        const double found = projected_capsule_overlap({0, 0, 1}, a, capsule, normal);
        EXPECT_NEAR(found, sum, 3e-3 * a * a) << i; // the lattice's own error at the edges
        if (sum > 0.0 && sum < 0.9 * std::numbers::pi * a * a * normal.z) ++cut;
    }
    EXPECT_GT(cut, 40);
}

// A short capsule is almost its end sphere.
TEST(SoftShadows, ACapsuleTurnsIntoItsBall) {
    const Vec normal = glm::normalize(Vec(0.3, -0.2, 1.0));
    for (const double off : {0.0, 0.05, 0.12, 0.2}) {
        const Vec center(off, 0.5 * off, 1.0);
        const double ball = projected_cap_overlap({0, 0, 1}, 0.15, glm::normalize(center),
                                                  std::asin(0.1 / glm::length(center)), normal);
        for (const double half : {1e-6, 1e-9, 0.0})
            EXPECT_NEAR(projected_capsule_overlap({0, 0, 1}, 0.15, {center, {1, 0, 0}, half, 0.1}, normal), ball,
                        2.0 * half + 1e-12);
    }
}

TEST(ThreadsSoftShadows, WhatIsLitIsUntouchedAndWhatIsDarkIsZero) {
    const Stage stage = floor_under({panel_facing({1, 1, 1}, {0, 0, 1}, {0, 1, 0}, 1.6, 1.6)});
    RenderOptions options;
    options.width = 64;
    options.height = 64;
    for (const Light& light : lights()) {
        options.shadows = Shadows::off;
        const Rendering bare = lit(stage, light, options);
        options.shadows = Shadows::soft;
        const Rendering soft = lit(stage, light, options);
        std::size_t same = 0;
        std::size_t dark = 0;
        for (std::size_t i = 0; i < bare.illuminance_lx.pixels.size(); ++i) {
            EXPECT_LE(soft.illuminance_lx.pixels[i], bare.illuminance_lx.pixels[i] * (1.0F + 1e-6F));
            if (soft.illuminance_lx.pixels[i] == bare.illuminance_lx.pixels[i]) ++same;
            if (soft.illuminance_lx.pixels[i] == 0.0F && bare.illuminance_lx.pixels[i] > 0.0F) ++dark;
        }
        EXPECT_GT(same, 1000U) << kind_of(light.shape);
        EXPECT_GT(dark, 0U) << kind_of(light.shape);
    }
    // A bare floor has no occluders.
    const Stage bare = floor_under({});
    for (const Light& light : lights()) {
        options.shadows = Shadows::off;
        const Rendering off = lit(bare, light, options);
        options.shadows = Shadows::soft;
        EXPECT_EQ(lit(bare, light, options).luminance_nt.pixels, off.luminance_nt.pixels);
    }
}

TEST(ThreadsSoftShadows, ThreadsAndSkippingChangeNothing) {
    const Stage stage = make_stage("spheres").value();
    RenderOptions options;
    options.width = 90;
    options.height = 70;
    for (const Light& light : lights()) {
        options.threads = 1;
        options.skip = true;
        const Rendering one = lit(stage, light, options);
        EXPECT_GT(one.stats.in_penumbra, 0U);
        for (const unsigned threads : {2U, 5U}) {
            options.threads = threads;
            EXPECT_EQ(lit(stage, light, options).luminance_nt.pixels, one.luminance_nt.pixels);
        }
        options.skip = false;
        EXPECT_EQ(lit(stage, light, options).luminance_nt.pixels, one.luminance_nt.pixels) << kind_of(light.shape);
    }
}

double mean_of(const Image& image) {
    double sum = 0.0;
    for (const float value : image.pixels)
        sum += value;
    return sum / static_cast<double>(image.pixels.size());
}

Rendering traced(const Stage& stage, std::span<const Light> lights, RenderOptions options, std::size_t passes) {
    options.illuminance = true;
    ReferencePicture picture = ReferencePicture::begin(stage, lights, stage.camera, options).value();
    while (picture.passes() < passes)
        picture.add_pass();
    return picture.picture();
}

// Closed forms and shadow ratios against path tracing, which uses neither: the total light agrees, and no pixel differs
// by more than the noise.
TEST(ThreadsReferencePicture, AgreesWithTheClosedForms) {
    Stage stage = floor_under({Ball{{0.1, -0.1, 1.0}, 0.3}, Box{{{-0.6, 0.4, 0.3}}, {0.3, 0.2, 0.3}}});
    stage.surfaces[0].material = parse_material("frostbite:smoothness=0.5").value();
    stage.surfaces[1].material = parse_material("ue4:base=rgb(0.8,0.3,0.1),roughness=0.5").value();
    stage.camera = {{0, -6, 5}, {0, 0, 0.2}, {0, 0, 1}, 22.0};
    std::vector<Light> all(lights().begin(), lights().end());
    all.push_back(light_of("point", "300cd", {0.5, 0.4, 2.0}));
    all.push_back(light_of("sun:angle=4deg", "300lx", {0, 0, 0}, {0.3, 0.5, -1.0}));
    for (Light& light : all)
        if (!std::holds_alternative<SunShape>(light.shape)) light.frame.origin.z += 1.0; // out of the picture
    RenderOptions options;
    options.width = 36;
    options.height = 28;
    for (const Light& light : all) {
        const Rendering exact = lit(stage, light, options);
        const Rendering truth = traced(stage, {&light, 1}, options, 96);
        const double mean = mean_of(truth.luminance_nt);
        EXPECT_NEAR(mean_of(exact.luminance_nt), mean, 0.004 * mean) << kind_of(light.shape);
        EXPECT_NEAR(mean_of(exact.illuminance_lx), mean_of(truth.illuminance_lx), 0.003 * mean_of(truth.illuminance_lx))
            << kind_of(light.shape);
        double apart = 0.0;
        for (std::size_t i = 0; i < truth.luminance_nt.pixels.size(); ++i)
            apart += std::abs(exact.luminance_nt.pixels[i] - truth.luminance_nt.pixels[i]);
        EXPECT_LT(apart / static_cast<double>(truth.luminance_nt.pixels.size()), 0.03 * mean) << kind_of(light.shape);
    }
}

TEST(ThreadsReferencePicture, KnowsItsError) {
    const Stage stage = floor_under({Ball{{0.1, -0.1, 1.0}, 0.3}});
    const Light& light = lights()[2];
    RenderOptions options;
    options.width = 32;
    options.height = 32;
    const Image truth = traced(stage, {&light, 1}, options, 1200).luminance_nt;
    const double mean = mean_of(truth);
    ReferencePicture picture = ReferencePicture::begin(stage, {&light, 1}, stage.camera, options).value();
    EXPECT_EQ(picture.error_estimate(), 1.0);
    for (const std::size_t passes : {8UL, 32UL, 128UL}) {
        while (picture.passes() < passes)
            picture.add_pass();
        const Image image = picture.picture().luminance_nt;
        double apart = 0.0;
        for (std::size_t i = 0; i < truth.pixels.size(); ++i)
            apart += std::abs(image.pixels[i] - truth.pixels[i]);
        const double error = apart / static_cast<double>(truth.pixels.size()) / mean;
        EXPECT_GT(picture.error_estimate(), 0.7 * error) << passes;
        EXPECT_LT(picture.error_estimate(), 3.0 * error) << passes;
    }
}

TEST(ThreadsReferencePicture, ThreadsChangeNothingAndRowsMayWait) {
    const Stage stage = make_stage("floor").value();
    RenderOptions options;
    options.width = 40;
    options.height = 30;
    options.threads = 1;
    const Image one = traced(stage, lights(), options, 3).luminance_nt;
    for (const unsigned threads : {2U, 5U}) {
        options.threads = threads;
        EXPECT_EQ(traced(stage, lights(), options, 3).luminance_nt.pixels, one.pixels);
    }
    // If a pass is stopped, its finished rows are kept; the next pass renders the rest.
    options.threads = 1;
    ReferencePicture picture = ReferencePicture::begin(stage, lights(), stage.camera, options).value();
    int rows = 0;
    picture.add_pass([&] { return ++rows > 11; });
    EXPECT_EQ(picture.passes(), 0U);
    picture.add_pass();
    EXPECT_EQ(picture.passes(), 1U);
    picture.add_pass();
    picture.add_pass();
    EXPECT_EQ(picture.picture().luminance_nt.pixels, one.pixels);
}

// For a single body the share is exact; compared with a cosine-weighted count of directions.
TEST(ThreadsSky, PicturesAgreeWithLightPaths) {
    Stage stage = floor_under({Ball{{0.1, -0.1, 0.3}, 0.3}});
    stage.surfaces[0].material = parse_material("frostbite:smoothness=0.5").value();
    stage.surfaces[1].material = parse_material("lambert:albedo=0.4").value();
    stage.camera = {{0, -6, 5}, {0, 0, 0.2}, {0, 0, 1}, 22.0};
    RenderOptions options;
    options.width = 36;
    options.height = 28;
    options.illuminance = true;
    for (const char* text : {"100nt", "cie:12,sun=200/30,horizontal=10klx"})
        for (const int bounces : {0, all_bounces}) {
            options.sky = resolve_sky(parse_sky_description(text).value()).value();
            options.bounces = bounces;
            const Rendering exact = render(stage, {}, stage.camera, options).value();
            const Rendering truth = traced(stage, {}, options, 128);
            EXPECT_NEAR(mean_of(exact.illuminance_lx), mean_of(truth.illuminance_lx),
                        0.004 * mean_of(truth.illuminance_lx));
            EXPECT_NEAR(mean_of(exact.luminance_nt), mean_of(truth.luminance_nt), 0.006 * mean_of(truth.luminance_nt));
        }
}

} // namespace
} // namespace gonio
