// The first hits of many rays at once, against RayCaster's in double.
#include <gonio/scene/figure.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/bundle_caster.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/ray_bundle.hpp>
#include <gonio/transport/ray_caster.hpp>

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

struct Place {
    Frame frame;
    std::size_t own;
};

// On the stage's surfaces, wherever rays from its camera end.
std::vector<Place> places_in(const Stage& stage) {
    const RayCaster caster(stage);
    std::vector<Place> places;
    const glm::dvec3 forward = glm::normalize(stage.camera.target - stage.camera.position);
    for (const glm::dvec3& local : cosine_directions(40)) {
        const glm::dvec3 direction = frame_about(glm::dvec3(0.0), forward).to_world(local);
        const std::optional<Hit> hit = first_hit(stage, {stage.camera.position, direction});
        if (!hit) continue;
        const bool is_solid = !is_sheet(stage.surfaces[hit->surface].geometry);
        places.push_back(
            {frame_about(hit->position + 1e-4 * hit->normal, hit->normal), is_solid ? hit->surface : RayEnd::nothing});
    }
    return places;
}

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

// What kernels say of the cells of small solids and of their patches, against the same in double.
TEST(LinkedCells, AreLinkedAsTheirFormFactorSays) {
    for (const char* name : {"street", "room", "spheres"}) {
        const Stage stage = make_stage(name).value();
        const Patches patches(stage, interest_of(stage, {}), {}, 2000.0, 1);
        const LinkedCells& linked = patches.linked();
        ASSERT_FALSE(linked.empty());
        for (const simd::InstructionSet set : simd::available_sets()) {
            std::size_t whole = 0;
            std::size_t divided = 0;
            CellLinks links;
            for (const Place& place : places_in(stage))
                for (const LinkedCells::OfChart& chart : linked.by_chart()) {
                    const bool is_flat = patches.charts().all()[chart.chart].kind == Chart::Kind::flat;
                    linked.find_links(transport::ray_kernels(set), place.frame, chart, chart.cells, links);
                    for (std::size_t i = chart.cells.first; i < chart.cells.last; ++i) {
                        const std::uint32_t number = linked.part(i).number;
                        const Cell& cell = patches.cells()[number];
                        const float share = links.share[i - chart.cells.first];
                        const glm::dvec3 to = cell.position - place.frame.origin;
                        const double distance = glm::length(to);
                        const double here = glm::dot(place.frame.z, to) / distance;
                        const double there = -glm::dot(cell.normal, to) / distance;
                        // Away from where floats decide otherwise, and from cells that are turned away in part.
                        if (here < 0.01 || there < cell.spread + 0.01 || cell.covered) continue;
                        const double least = (is_flat ? 8.0 : 24.0) * cell.half_diagonal_m;
                        if (cell.is_uneven() || cell.spread > 0.4 || distance < 0.999 * least) {
                            ++divided;
                            EXPECT_EQ(share, transport::RayLinks::divided);
                        } else if (distance > 1.001 * least) {
                            ++whole;
                            const double factor =
                                here * there * patches.cell_area_m2(number) / (std::numbers::pi * distance * distance);
                            EXPECT_NEAR(share, factor, 2e-5 * factor);
                            const glm::dvec3 towards(links.towards[0][i - chart.cells.first],
                                                     links.towards[1][i - chart.cells.first],
                                                     links.towards[2][i - chart.cells.first]);
                            EXPECT_LE(glm::length(towards - place.frame.to_local(to / distance)), 2e-6);
                        }
                    }
                }
            EXPECT_GT(whole, 50U) << name;
            EXPECT_GT(divided, 50U) << name;
        }
    }
}

} // namespace
} // namespace gonio::detail
