#include <gonio/scene/stage.hpp>
#include <gonio/transport/exchange_geometry.hpp>
#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/lobe_rays.hpp>
#include <gonio/transport/reflected_view.hpp>

#include "../light/lights.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gonio::detail {
namespace {

// Points of the floor before the box of `room`, 1 cm from each other, in squares of four.
struct Floor {
    static constexpr int side = 41;

    explicit Floor(const glm::dvec3& eye) {
        const auto add = [&](SurfaceSamples& to, int i, int j) {
            const glm::dvec3 at(-0.3 + 0.01 * i, -0.2 + 0.01 * j, 0.0);
            to.add({at, {0.0, 0.0, 1.0}, glm::normalize(eye - at)}, 0, 1.0, 0);
        };
        for (int j = 0; j < side; j += 4)
            for (int i = 0; i < side; i += 4)
                add(squares.corners, i, j);
        constexpr std::uint32_t across = side / 4;
        for (std::uint32_t row = 0; row < across; ++row)
            for (std::uint32_t column = 0; column < across; ++column) {
                const std::uint32_t corner = row * (across + 1) + column;
                squares.squares.push_back({corner, corner + 1, corner + across + 1, corner + across + 2});
            }
        for (int j = 0; j < side - 1; ++j)
            for (int i = 0; i < side - 1; ++i) {
                add(samples, i, j);
                squares.of_sample.push_back(
                    {static_cast<std::uint32_t>(j / 4) * across + static_cast<std::uint32_t>(i / 4),
                     0.25F * static_cast<float>(i % 4), 0.25F * static_cast<float>(j % 4)});
            }
    }

    SurfaceSamples samples;
    SampleSquares squares;
};

// Beside a box, whose image has an edge.
TEST(ReflectedView, InterpolatesWhatChangesLittle) {
    const Stage stage = make_stage("room").value();
    const std::vector<Light> lights{light_of("rect:w=60cm,h=30cm", "3000lm", stage.light.position)};
    LightingOptions options;
    options.bounces = all_bounces;
    const Interreflection indirect = Interreflection::of(stage, lights, options).value();
    const Floor floor(stage.camera.position);
    for (const LobeRays& lobe : lobe_rays(core_material(stage.surfaces.front().material))) {
        ReflectedView view(*indirect.geometry(), &indirect, nullptr, options.instruction_set);
        const std::vector<glm::vec3> exact = view.luminance(floor.samples, {}, lobe);
        const std::vector<glm::vec3> found = view.luminance(floor.samples, floor.squares, lobe);
        double mean = 0.0;
        double worst = 0.0;
        double square = 0.0;
        for (std::size_t i = 0; i < exact.size(); ++i) {
            const double off = static_cast<double>(found[i].y) - static_cast<double>(exact[i].y);
            mean += static_cast<double>(exact[i].y) / static_cast<double>(exact.size());
            square += off * off / static_cast<double>(exact.size());
            worst = std::max(worst, std::abs(off));
        }
        ASSERT_GT(mean, 0.0);
        EXPECT_LT(std::sqrt(square), 2e-3 * mean);
        EXPECT_LT(worst, 3e-2 * mean);
        EXPECT_GT(worst, 0.0);                                      // some are interpolated
        EXPECT_NEAR(found.front().y, exact.front().y, 1e-5 * mean); // a corner
    }
}

} // namespace
} // namespace gonio::detail
