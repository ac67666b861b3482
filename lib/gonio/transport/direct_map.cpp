#include <gonio/base/parallel.hpp>
#include <gonio/scene/sky.hpp>
#include <gonio/transport/direct_map.hpp>
#include <gonio/transport/sample_shader.hpp>
#include <gonio/transport/soft_shadow.hpp>
#include <gonio/transport/surface_samples.hpp>

#include <algorithm>
#include <cstdint>
#include <numbers>

namespace gonio::detail {

namespace {

constexpr std::uint32_t block_side = 8; // patches

struct Block {
    std::size_t chart;
    std::uint32_t column;
    std::uint32_t row;
};

std::vector<Block> blocks_of(const Patches& patches) {
    std::vector<Block> blocks;
    for (std::size_t chart = 0; chart < patches.charts().all().size(); ++chart)
        for (std::uint32_t row = 0; row < patches.grid(chart).rows; row += block_side)
            for (std::uint32_t column = 0; column < patches.grid(chart).columns; column += block_side)
                blocks.push_back({chart, column, row});
    return blocks;
}

class LitBlock {
public:
    LitBlock(const Patches& patches, const LitScene& scene, const Block& block) : scene_(scene) {
        const Chart& chart = patches.charts().all()[block.chart];
        const PatchGrid& grid = patches.grid(block.chart);
        samples_.surface = chart.surface;
        samples_.reserve(std::size_t{4} * block_side * block_side);
        for (std::uint32_t row = block.row; row < std::min(block.row + block_side, grid.rows); ++row)
            for (std::uint32_t column = block.column; column < std::min(block.column + block_side, grid.columns);
                 ++column) {
                const std::uint32_t patch = grid.first_patch + row * grid.columns + column;
                for (std::size_t quarter = 0; quarter < 4; ++quarter) {
                    const double area_m2 = patches.quarter_m2(patch, quarter);
                    if (!(area_m2 > 0.0)) continue;
                    const glm::dvec2 at = grid.corner(chart, column + 0.25 + 0.5 * static_cast<double>(quarter % 2),
                                                      row + (quarter < 2 ? 0.25 : 0.75));
                    samples_.add({chart.position(at), chart.normal(at), {}}, patch, area_m2 / patches.area_m2(patch),
                                 -1);
                }
            }
        samples_.finish_chunk();
    }

    void add_to(std::vector<glm::dvec3>& map) {
        if (samples_.size() == 0) return;
        if (scene_.options.sky.value > 0.0) add_sky(map);
        SampleShader shader(scene_);
        SoftShadow shadow(scene_);
        const SampleBounds bounds = samples_.chunks.front().bounds;
        std::vector<std::uint32_t> near;
        scene_.reaches.meeting_box(bounds.low, bounds.high, near);
        std::sort(near.begin(), near.end());
        for (const std::uint32_t index : near) {
            const LitLight& light = scene_.lights[index];
            if (light.reach.unlit(bounds) != Unlit::no) continue;
            shader.illuminate(light, samples_);
            shadow.begin(light);
            std::vector<std::uint32_t>& bodies = shadow.bodies(samples_.surface);
            if (scene_.options.shadows != Shadows::off) scene_.find_shadowing(samples_.surface, bounds, light, bodies);
            for (std::size_t i = 0; i < samples_.size(); ++i) {
                double lx = shader.lx()[i];
                if (!(lx > 0.0)) continue;
                if (!bodies.empty())
                    lx *= scene_.has_soft_shadow(light)
                              ? shadow.visible(samples_.surface, samples_.position_of(i), samples_.normal_of(i))
                              : scene_.visible_center(light, samples_.surface, samples_.position_of(i));
                map[samples_.pixel[i]] += static_cast<double>(samples_.share[i]) * lx * light.light.color;
            }
        }
    }

private:
    void add_sky(std::vector<glm::dvec3>& map) const {
        const double lx = std::numbers::pi * scene_.options.sky.value;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const double free =
                scene_.options.shadows == Shadows::off
                    ? 1.0
                    : sky_share(scene_.stage, samples_.surface, samples_.position_of(i), samples_.normal_of(i));
            map[samples_.pixel[i]] += glm::dvec3(static_cast<double>(samples_.share[i]) * free * lx);
        }
    }

    const LitScene& scene_;
    SurfaceSamples samples_;
};

} // namespace

std::vector<glm::dvec3> direct_map(const Patches& patches, const LitScene& scene) {
    std::vector<glm::dvec3> map(patches.count(), glm::dvec3(0.0));
    const std::vector<Block> blocks = blocks_of(patches);
    parallel_for(blocks.size(), scene.options.threads,
                 [&](std::size_t i) { LitBlock(patches, scene, blocks[i]).add_to(map); });
    return map;
}

} // namespace gonio::detail
