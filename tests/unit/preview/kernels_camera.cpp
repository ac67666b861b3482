#include <gonio/measure/random.hpp>
#include <gonio/preview/detail/seen_rays.hpp>
#include <gonio/preview/kernels_camera.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/primitives.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <variant>
#include <vector>

namespace gonio {
namespace {

// What the pixels of a picture and those around it meet, by every set of instructions, to the last bit as ray by ray.
TEST(CameraKernels, SeeWhatSingleRaysSee) {
    constexpr std::size_t columns = 37;
    constexpr std::size_t rows = 21;
    const Camera camera{{0.3, -4.0, 1.7}, {0.1, 0.2, 0.6}, {0.0, 0.1, 1.0}, 55.0};
    Stage stage;
    const auto add = [&](const Primitive& geometry) { stage.surfaces.push_back({"", geometry, {}}); };
    measure::Random random(3);
    const auto vector = [&](double size) {
        return glm::dvec3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
    };
    add(Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}});
    add(Plane{{0.0, 6.0, 0.0}, {0.0, 1.0, 0.0}}); // from behind
    for (int i = 0; i < 5; ++i) {
        const Frame frame = aimed_frame(vector(1.5), vector(1.0), {0.0, 0.0, 1.0});
        add(Panel{frame, random.uniform(0.3, 2.0), random.uniform(0.3, 2.0)});
        add(Ball{vector(1.5), random.uniform(0.05, 0.8)});
        add(Box{frame, {0.2, 0.3, 0.4}});
        add(Capsule{vector(1.5), glm::normalize(vector(1.0)), 0.5, 0.1});
    }
    const CameraRays rays(camera, static_cast<int>(columns) - 2, static_cast<int>(rows) - 2);
    const detail::LightTree no_bodies({});
    const EmittedLights no_emitted;
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < stage.surfaces.size(); ++i)
        all.push_back(i);
    for (const simd::InstructionSet set : simd::available_sets()) {
        const detail::RayScene scene{stage,      {},          rays,     no_bodies,
                                     no_emitted, columns - 2, rows - 2, preview::camera_kernels(set)};
        detail::SeenRays seen(scene);
        seen.begin_grid(-0.5, -0.5, columns, rows);
        seen.cast(all, {});
        std::size_t met = 0;
        std::array<std::size_t, std::variant_size_v<Primitive>> of_kind{};
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Ray ray = rays.ray(static_cast<double>(i % columns) - 0.5, static_cast<double>(i / columns) - 0.5);
            ASSERT_EQ(seen.view_of(i), -ray.direction) << simd::to_text(set) << ' ' << i;
            const std::optional<Hit> hit = first_hit(stage, ray);
            ASSERT_EQ(seen.is_surface(i), hit.has_value()) << simd::to_text(set) << ' ' << i;
            if (!hit) continue;
            ++met;
            of_kind.at(stage.surfaces[hit->surface].geometry.index()) += 1;
            ASSERT_EQ(seen.surface_of(i), hit->surface) << simd::to_text(set) << ' ' << i;
            ASSERT_EQ(seen.position_of(i), hit->position) << simd::to_text(set) << ' ' << i;
            ASSERT_EQ(seen.at(i).hit.face, hit->face) << simd::to_text(set) << ' ' << i;
        }
        EXPECT_GT(met, seen.size() / 3);
        for (const std::size_t count : of_kind)
            EXPECT_GT(count, 0U);

        // What the samples of a tile hold: floats of the same doubles.
        const glm::dvec3 anchor(0.25, -1.0, 3.0);
        constexpr std::size_t first = 5;
        const std::size_t count = seen.size() - 9;
        std::array<std::vector<float>, 6> numbers;
        for (std::vector<float>& axis : numbers)
            axis.resize(count);
        float* const positions[3] = {numbers[0].data(), numbers[1].data(), numbers[2].data()};
        float* const views[3] = {numbers[3].data(), numbers[4].data(), numbers[5].data()};
        seen.put_positions(first, count, anchor, positions);
        seen.put_views(first, count, views);
        for (std::size_t i = 0; i < count; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                if (seen.is_surface(first + i)) {
                    ASSERT_EQ(positions[axis][i], static_cast<float>((seen.position_of(first + i) - anchor)[axis]));
                }
                ASSERT_EQ(views[axis][i], static_cast<float>(seen.view_of(first + i)[axis]));
            }

        std::vector<std::uint8_t> changes(seen.size());
        seen.put_changes(columns, changes);
        std::size_t outlines = 0;
        for (std::size_t row = 1; row + 1 < rows; ++row)
            for (std::size_t column = 1; column + 1 < columns; ++column) {
                const std::size_t at = row * columns + column;
                const bool is_inside = seen.show_the_same(at, at - 1) && seen.show_the_same(at, at + 1) &&
                                       seen.show_the_same(at, at - columns) && seen.show_the_same(at, at + columns);
                ASSERT_EQ(changes[at], is_inside ? 0 : 1) << at;
                outlines += changes[at];
            }
        EXPECT_GT(outlines, 50U);
    }
}

// Rays along faces and axes, where nothing may be divided by.
TEST(CameraKernels, MeetWhatTheyRunAlong) {
    const Camera camera{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, 55.0};
    const Frame upright{{0.0, 0.0, 3.0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Frame beside = upright;
    beside.origin = {1.0, 0.0, 0.5}; // the eye is in the plane of one of its faces
    Stage stage;
    for (const Primitive& geometry : std::initializer_list<Primitive>{
             Box{upright, {1.0, 1.0, 1.0}}, Box{beside, {1.0, 0.2, 0.2}},
             Capsule{{0.0, 0.0, -5.0}, {0, 0, 1}, 1.0, 0.3}, Capsule{{0.2, 0.0, -9.0}, {0, 0, -1}, 1.0, 0.3},
             Capsule{{-4.0, 0.0, 0.0}, {1, 0, 0}, 1.0, 0.3}})
        stage.surfaces.push_back({"", geometry, {}});
    std::vector<glm::dvec3> directions;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec3 direction(0.0);
            direction[axis] = sign;
            directions.push_back(direction);
        }
    for (const glm::dvec3& way : {glm::dvec3(0.0, 0.6, 0.8), glm::dvec3(-1.0, 0.0, 1e-11), glm::dvec3(0.02, 0.0, -1.0)})
        directions.push_back(glm::normalize(way));
    const CameraRays rays(camera, 3, 3);
    const detail::LightTree no_bodies({});
    const EmittedLights no_emitted;
    const std::vector<std::uint32_t> all{0, 1, 2, 3, 4};
    for (const simd::InstructionSet set : simd::available_sets()) {
        const detail::RayScene scene{stage, {}, rays, no_bodies, no_emitted, 3, 3, preview::camera_kernels(set)};
        detail::SeenRays seen(scene);
        detail::RaysFrom& cast = seen.begin(directions.size());
        for (std::size_t i = 0; i < directions.size(); ++i)
            cast.set(i, {{0.0, 0.0, 0.0}, directions[i]});
        seen.cast(all, {});
        std::size_t met = 0;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const std::optional<Hit> hit = first_hit(stage, {{0.0, 0.0, 0.0}, directions[i]});
            ASSERT_EQ(seen.is_surface(i), hit.has_value()) << simd::to_text(set) << ' ' << i;
            if (!hit) continue;
            ++met;
            EXPECT_EQ(seen.surface_of(i), hit->surface) << simd::to_text(set) << ' ' << i;
            EXPECT_EQ(seen.position_of(i), hit->position) << simd::to_text(set) << ' ' << i;
        }
        EXPECT_GT(met, 4U);
    }
}

} // namespace
} // namespace gonio
