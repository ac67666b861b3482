// The first hits of many rays at once, against RayCaster's in double.
#include <gonio/scene/figure.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/bundle_caster.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/ray_bundle.hpp>
#include <gonio/transport/ray_caster.hpp>

#include "seen_places.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace gonio::detail {
namespace {

using test::Place;
using test::places_in;

// A stage with solids of every kind, if there are any on it or beside it.
Stage crowded(const char* name) {
    Stage stage = make_stage(name).value();
    if (name == std::string_view("room")) add_figure(stage);
    return stage;
}

TEST(BundleCaster, MeetsWhatRaysInDoubleMeet) {
    for (const char* name : {"street", "card", "room", "spheres"}) {
        const Stage stage = crowded(name);
        const Patches patches(stage, interest_of(stage, {}), {}, 500.0, 1);
        const RayCaster caster(stage);
        const std::vector<glm::dvec3> directions = cosine_directions(1000);
        const DirectionArrays arrays(directions);
        for (const simd::InstructionSet set : simd::available_sets()) {
            BundleCaster bundle(stage, patches, set);
            std::vector<PatchPoint> ends(directions.size());
            std::vector<std::uint32_t> charts(directions.size());
            std::size_t rays = 0;
            std::size_t others = 0;
            std::size_t capsules = 0;
            for (const Place& place : places_in(stage)) {
                bundle.begin(place.frame, place.own);
                bundle.cast(arrays, ends, charts);
                for (std::size_t i = 0; i < directions.size(); ++i) {
                    const RayEnd end = caster.cast({place.frame.origin, place.frame.to_world(arrays.of(i))}, place.own);
                    const auto expected =
                        end.surface == RayEnd::nothing
                            ? no_patch
                            : static_cast<std::uint32_t>(patches.charts().index_of(end.surface, end.face));
                    ++rays;
                    if (charts[i] != expected) ++others;
                    if (end.surface != RayEnd::nothing &&
                        std::holds_alternative<Capsule>(stage.surfaces[end.surface].geometry))
                        ++capsules;
                }
            }
            EXPECT_GT(rays, 10000U) << name;
            EXPECT_EQ(capsules == 0, name == std::string_view("spheres")) << name;
            // Floats and doubles differ at edges.
            EXPECT_LE(static_cast<double>(others), 2e-4 * static_cast<double>(rays))
                << name << ' ' << simd::to_text(set) << ' ' << others << " of " << rays;
        }
    }
}

// Rays to the patches of a chart that are turned to the place: the same with all surfaces, and with those that may
// stand between, or with none.
TEST(BundleCaster, MeetsNothingElseTowardsAChart) {
    for (const char* name : {"street", "card", "room", "spheres"}) {
        const Stage stage = crowded(name);
        const Patches patches(stage, interest_of(stage, {}), {}, 2000.0, 1);
        BundleCaster bundle(stage, patches, simd::best_available());
        std::size_t rays = 0;
        std::size_t hidden = 0;
        std::size_t others = 0;
        for (const Place& place : places_in(stage)) {
            bundle.begin(place.frame, place.own);
            for (std::uint32_t chart = 0; chart < patches.charts().all().size(); ++chart) {
                if (patches.charts().all()[chart].surface == place.own) continue;
                DirectionArrays directions;
                for (std::uint32_t patch = 0; patch < patches.count(); ++patch) {
                    const glm::dvec3 to = patches.middle(patch) - place.frame.origin;
                    const double distance = glm::length(to);
                    if (patches.chart_of(patch) == chart && patches.area_m2(patch) > 0.0 &&
                        glm::dot(to, place.frame.z) > 0.0 && glm::dot(patches.normal(patch), to) < -0.05 * distance)
                        directions.add(place.frame.to_local(to / distance));
                }
                std::vector<std::uint32_t> expected(directions.size());
                std::vector<std::uint32_t> found(directions.size(), 12345U);
                std::vector<PatchPoint> ends(directions.size());
                bundle.cast(directions, ends, expected);
                if (bundle.find_nearer(chart))
                    bundle.cast_toward(directions, found);
                else
                    std::fill(found.begin(), found.end(), chart);
                rays += found.size();
                for (std::size_t i = 0; i < found.size(); ++i) {
                    if (expected[i] != chart) ++hidden;
                    if ((expected[i] == chart) != (found[i] == chart)) ++others;
                }
            }
        }
        EXPECT_GT(rays, 500U) << name;
        EXPECT_GT(hidden, rays / 100) << name;
        // Patches whose middle is at the very edge of what covers them.
        EXPECT_LE(static_cast<double>(others), 2e-4 * static_cast<double>(rays)) << name << ' ' << others;
    }
}

// Rays with origins of their own, from one surface.
TEST(ScatteredCaster, MeetsWhatRaysInDoubleMeet) {
    for (const char* name : {"street", "card", "room", "spheres"}) {
        const Stage stage = crowded(name);
        const Patches patches(stage, interest_of(stage, {}), {}, 500.0, 1);
        const RayCaster caster(stage);
        const std::vector<Place> places = places_in(stage);
        for (const simd::InstructionSet set : simd::available_sets()) {
            ScatteredCaster scattered(stage, patches, set);
            std::size_t rays = 0;
            std::size_t others = 0;
            for (const Place& place : places) {
                std::array<std::vector<float>, 3> origins;
                std::array<std::vector<float>, 3> directions;
                std::vector<Ray> expected;
                for (const glm::dvec3& local : cosine_directions(200)) {
                    const glm::dvec3 direction = place.frame.to_world(local);
                    const glm::dvec3 from = 1e-3 * static_cast<double>(expected.size() % 7) * place.frame.z;
                    for (int axis = 0; axis < 3; ++axis) {
                        origins.at(static_cast<std::size_t>(axis)).push_back(static_cast<float>(from[axis]));
                        directions.at(static_cast<std::size_t>(axis)).push_back(static_cast<float>(direction[axis]));
                    }
                    expected.push_back({place.frame.origin + from, direction});
                }
                std::vector<PatchPlace> ends;
                scattered.cast(place.frame.origin, place.own, origins, directions, expected.size(), ends);
                for (std::size_t i = 0; i < expected.size(); ++i) {
                    const RayEnd end = caster.cast(expected[i], place.own);
                    ++rays;
                    if (end.surface == RayEnd::nothing) {
                        others += ends[i].chart == (end.leaves() ? no_patch : back_side) ? 0U : 1U;
                        continue;
                    }
                    const std::size_t chart = patches.charts().index_of(end.surface, end.face);
                    const double away = std::abs(static_cast<double>(ends[i].distance_m) - end.distance);
                    others += ends[i].chart == chart && away <= 1e-4 * (1.0 + end.distance) ? 0U : 1U;
                }
            }
            EXPECT_LE(static_cast<double>(others), 5e-4 * static_cast<double>(rays))
                << name << ' ' << simd::to_text(set) << ' ' << others << " of " << rays;
        }
    }
}

} // namespace
} // namespace gonio::detail
