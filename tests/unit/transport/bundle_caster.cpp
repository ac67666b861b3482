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

#include <cstddef>
#include <cstdint>
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

TEST(BundleCaster, MeetsWhatRaysInDoubleMeet) {
    for (const char* name : {"street", "card", "room", "spheres"}) {
        Stage stage = make_stage(name).value();
        if (name == std::string_view("room")) add_figure(stage);
        const Patches patches(stage, interest_of(stage, {}), {}, 500.0, 1);
        const RayCaster caster(stage);
        const std::vector<glm::dvec3> directions = cosine_directions(1000);
        const DirectionArrays arrays(directions);
        for (const simd::InstructionSet set : simd::available_sets()) {
            BundleCaster bundle(stage, caster, patches, set);
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

} // namespace
} // namespace gonio::detail
