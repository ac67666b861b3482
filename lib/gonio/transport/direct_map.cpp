#include <gonio/base/parallel.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/transport/direct_map.hpp>
#include <gonio/transport/sample_shader.hpp>
#include <gonio/transport/sky_light.hpp>
#include <gonio/transport/soft_shadow.hpp>
#include <gonio/transport/surface_samples.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
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

constexpr int most_along = 8; // points along a side of a patch
constexpr int edge_along = 4; // where the edge of a shadow crosses it

// Points along a side of a patch at some distance from a light, so that its mean is within some 5e-4, which patches
// that bend the other way make up for. Shadows need two.
int points_along(double distance_m, double square_m, bool in_shadow) {
    if (distance_m > 25.0 * square_m && !in_shadow) return 1;
    if (distance_m > 8.0 * square_m) return 2;
    return distance_m > 3.0 * square_m ? 4 : most_along;
}

// One coordinate of a point of the grid in a patch, in steps: each row is shifted against the next, so that the edge of
// a shadow along a row or a column passes the points one by one.
double turned(int along_it, int across_it, int along) {
    return along_it + 0.5 + (across_it + 0.5 - 0.5 * along) / along;
}

class LitBlock {
public:
    LitBlock(const Patches& patches, const LitScene& scene, const Block& block, const SurfaceAlbedo& albedo)
        : patches_(patches), scene_(scene), block_(block), albedo_(albedo), shader_(scene), shadow_(scene) {}

    void add_to(DirectMap& map) {
        const SurfaceSamples& few = samples(2);
        if (few.size() == 0) return;
        if (scene_.sky != nullptr) add_sky(few, map);
        bounds_ = few.chunks.front().bounds;
        std::vector<std::uint32_t> near;
        scene_.reaches.meeting_box(bounds_.low, bounds_.high, near);
        std::sort(near.begin(), near.end());
        // The points of finer grids lie closer to the edges of their patches.
        for (const std::uint32_t patch : few.pixel)
            bounds_.radius = std::max(bounds_.radius, glm::distance(patches_.middle(patch), bounds_.center) +
                                                          patches_.half_diagonal(patch));
        for (const std::uint32_t index : near)
            if (!scene_.lights[index].light.is_emitted_by(few.surface) &&
                scene_.lights[index].reach.unlit(few.chunks.front().bounds) == Unlit::no)
                add(scene_.lights[index], map);
    }

private:
    // `along` by `along` points of each patch that are not covered, in proportion to their area; made when first
    // needed.
    const SurfaceSamples& samples(int along) {
        SurfaceSamples& made = samples_.at(static_cast<std::size_t>(along));
        if (made.size() > 0 || is_made_.at(static_cast<std::size_t>(along))) return made;
        is_made_.at(static_cast<std::size_t>(along)) = true;
        const Chart& chart = patches_.charts().all()[block_.chart];
        const PatchGrid& grid = patches_.grid(block_.chart);
        made.surface = chart.surface;
        made.reserve(static_cast<std::size_t>(along * along) * block_side * block_side);
        for (std::uint32_t row = block_.row; row < std::min(block_.row + block_side, grid.rows); ++row)
            for (std::uint32_t column = block_.column; column < std::min(block_.column + block_side, grid.columns);
                 ++column)
                add_points(made, chart, grid, {column, row}, along);
        made.finish_chunk();
        return made;
    }

    void add_points(SurfaceSamples& to, const Chart& chart, const PatchGrid& grid, const glm::uvec2& at,
                    int along) const {
        const std::uint32_t patch = grid.first_patch + at.y * grid.columns + at.x;
        if (!(patches_.area_m2(patch) > 0.0)) return;
        const double step = 1.0 / along;
        const std::size_t first = to.size();
        const double lift_m = Patches::lift(patches_.square_m());
        for (int v = 0; v < along; ++v)
            for (int u = 0; u < along; ++u) {
                const glm::dvec2 within(turned(u, v, along), turned(v, along - 1 - u, along));
                const glm::dvec2 middle = grid.corner(at.x + step * within.x, at.y + step * within.y);
                const SurfacePoint point{chart.position(middle), chart.normal(middle), {}};
                if (patches_.is_partial(patch) &&
                    Patches::is_covered(scene_.stage, chart.surface, point.position + lift_m * point.normal,
                                        point.normal, lift_m))
                    continue;
                to.add(point, patch, 0.0, -1);
            }
        // All points of a patch stand for the same area: zones of a sphere, for which this is not exact, are narrow.
        for (std::size_t i = first; i < to.size(); ++i)
            to.share[i] = 1.0F / static_cast<float>(to.size() - first);
    }

    // Points of patches, and the share of a light that reaches each.
    struct Seen {
        int along = 0; // a side of each patch
        SurfaceSamples own;
        const SurfaceSamples* points = nullptr; // `own`, or those of all patches of the block
        std::vector<double> visible;
    };

    void add(const LitLight& light, DirectMap& map) {
        shadow_.begin(light);
        std::vector<std::uint32_t>& bodies = shadow_.bodies(patches_.charts().all()[block_.chart].surface);
        if (scene_.options.shadows != Shadows::off)
            scene_.find_shadowing(patches_.charts().all()[block_.chart].surface, bounds_, light, bodies);
        const bool is_shadowed = !bodies.empty();
        std::vector<Seen> parts = parts_for(light, is_shadowed);
        for (Seen& part : parts)
            part.visible = visible_shares(light, *part.points, is_shadowed);
        std::vector<std::uint32_t> divided;
        if (is_shadowed) divided = on_edges(parts);
        for (const Seen& part : parts) {
            shader_.illuminate(light, *part.points);
            for (std::size_t i = 0; i < part.points->size(); ++i)
                if (!std::binary_search(divided.begin(), divided.end(), part.points->pixel[i]))
                    add_point(light, *part.points, i, part.visible[i], map);
        }
        if (divided.empty()) return;
        const SurfaceSamples finer = points_of(divided, edge_along);
        const std::vector<double> visible_of_finer = visible_shares(light, finer, true);
        shader_.illuminate(light, finer);
        for (std::size_t i = 0; i < finer.size(); ++i)
            add_point(light, finer, i, visible_of_finer[i], map);
    }

    // The points of all patches, as many of each as its distance from the light needs.
    std::vector<Seen> parts_for(const LitLight& light, bool is_shadowed) {
        const PatchGrid& grid = patches_.grid(block_.chart);
        std::array<std::vector<std::uint32_t>, most_along + 1> by_points;
        std::size_t all = 0;
        for (std::uint32_t row = block_.row; row < std::min(block_.row + block_side, grid.rows); ++row)
            for (std::uint32_t column = block_.column; column < std::min(block_.column + block_side, grid.columns);
                 ++column) {
                const std::uint32_t patch = grid.first_patch + row * grid.columns + column;
                if (!(patches_.area_m2(patch) > 0.0)) continue;
                const double half_m = patches_.half_diagonal(patch);
                const double distance_m =
                    light.reach.at_infinity
                        ? std::numeric_limits<double>::infinity()
                        : glm::distance(light.reach.center, patches_.middle(patch)) - half_m - light.reach.body_radius;
                const bool in_shadow = is_shadowed && has_shadow(light, patch);
                const int along = points_along(distance_m, std::numbers::sqrt2 * half_m, in_shadow);
                by_points.at(static_cast<std::size_t>(along)).push_back(patch);
                ++all;
            }
        std::vector<Seen> parts;
        for (std::size_t along = 1; along < by_points.size(); ++along) {
            if (by_points[along].empty()) continue;
            Seen& part = parts.emplace_back();
            part.along = static_cast<int>(along);
            if (by_points[along].size() < all)
                part.own = points_of(by_points[along], static_cast<int>(along));
            else
                part.points = &samples(static_cast<int>(along));
        }
        for (Seen& part : parts)
            if (part.points == nullptr) part.points = &part.own;
        return parts;
    }

    void add_point(const LitLight& light, const SurfaceSamples& of, std::size_t i, double visible,
                   DirectMap& map) const {
        const double lx = visible * shader_.lx()[i];
        if (!(lx > 0.0)) return;
        const glm::dvec3 of_patch = static_cast<double>(of.share[i]) * lx * light.light.color;
        const glm::dvec3 towards =
            light.reach.at_infinity ? light.light.frame.z : glm::normalize(light.reach.center - of.position_of(i));
        map.lx[of.pixel[i]] += of_patch;
        const double cosine = glm::dot(of.normal_of(i), towards);
        const glm::dvec3 whole = glm::min(albedo_.by_cosine(cosine), glm::dvec3(1.0));
        map.reflected_lx[of.pixel[i]] += of_patch * whole;
        if (!albedo_.lobe || map.throwing.empty()) return;
        ThrowingLight& throwing = map.throwing[static_cast<std::size_t>(&light - scene_.lights.data())];
        throwing.lx[of.pixel[i]] += glm::vec3(of_patch);
        throwing.thrown_lx[of.pixel[i]] += glm::vec3(of_patch * glm::min(albedo_.lobe->share(cosine), whole));
    }

    // The points of a patch come one after the other.
    std::vector<double> visible_shares(const LitLight& light, const SurfaceSamples& of, bool is_shadowed) {
        std::vector<double> shares(of.size(), 1.0);
        if (!is_shadowed) return shares;
        const bool is_soft = scene_.has_soft_shadow(light);
        std::vector<std::size_t> behind; // the samples that something may hide, if shadows are soft
        ShadowPoints points;
        bool may_be_hidden = false;
        for (std::size_t i = 0; i < of.size(); ++i) {
            if (i == 0 || of.pixel[i] != of.pixel[i - 1]) may_be_hidden = has_shadow(light, of.pixel[i]);
            if (!may_be_hidden) continue;
            if (!is_soft) {
                shares[i] = scene_.visible_center(light, of.surface, of.position_of(i));
                continue;
            }
            behind.push_back(i);
            points.add(of.position_of(i), of.normal_of(i));
        }
        if (behind.empty()) return shares;
        const std::span<const VisibleShare> visible = shadow_.visible(of.surface, points, false);
        for (std::size_t i = 0; i < behind.size(); ++i)
            shares[behind[i]] = visible[i].lx;
        return shares;
    }

    // Whether any of the bodies before the block may be before the patch.
    bool has_shadow(const LitLight& light, std::uint32_t patch) {
        if (light.reach.at_infinity) return true;
        const Ball points{patches_.middle(patch), patches_.half_diagonal(patch)};
        const Ball body{light.reach.center, light.reach.body_radius};
        const std::vector<std::uint32_t>& bodies = shadow_.bodies(patches_.surface_of(patch));
        return std::any_of(bodies.begin(), bodies.end(), [&](std::uint32_t i) {
            return may_stand_between(scene_.stage.surfaces[i].geometry, points, body);
        });
    }

    // The patches that the edge of a shadow may cross, in order: those with points of different shares, and those
    // beside them.
    std::vector<std::uint32_t> on_edges(const std::vector<Seen>& parts) const {
        const PatchGrid& grid = patches_.grid(block_.chart);
        std::array<std::array<float, block_side + 2>, block_side + 2> least{};
        std::array<std::array<float, block_side + 2>, block_side + 2> most{};
        std::array<std::array<bool, block_side + 2>, block_side + 2> is_finest{};
        for (auto& row : least)
            row.fill(2.0F);
        for (auto& row : most)
            row.fill(-1.0F);
        for (const Seen& part : parts)
            for (std::size_t i = 0; i < part.points->size(); ++i) {
                const std::uint32_t index = part.points->pixel[i] - grid.first_patch;
                const std::size_t row = index / grid.columns - block_.row + 1;
                const std::size_t column = index % grid.columns - block_.column + 1;
                is_finest.at(row).at(column) = part.along >= edge_along;
                least.at(row).at(column) = std::min(least.at(row).at(column), static_cast<float>(part.visible[i]));
                most.at(row).at(column) = std::max(most.at(row).at(column), static_cast<float>(part.visible[i]));
            }
        std::vector<std::uint32_t> found;
        for (std::size_t row = 1; row <= block_side; ++row)
            for (std::size_t column = 1; column <= block_side; ++column) {
                if (most[row][column] < 0.0F || is_finest[row][column]) continue;
                const float low = std::min({least[row][column], least[row - 1][column], least[row + 1][column],
                                            least[row][column - 1], least[row][column + 1]});
                const float high = std::max({most[row][column], most[row - 1][column], most[row + 1][column],
                                             most[row][column - 1], most[row][column + 1]});
                constexpr float jump = 0.3F; // a penumbra is smooth enough
                if (high - low > jump)
                    found.push_back(grid.first_patch +
                                    (block_.row + static_cast<std::uint32_t>(row) - 1) * grid.columns + block_.column +
                                    static_cast<std::uint32_t>(column) - 1);
            }
        return found;
    }

    SurfaceSamples points_of(const std::vector<std::uint32_t>& some, int along) const {
        const Chart& chart = patches_.charts().all()[block_.chart];
        const PatchGrid& grid = patches_.grid(block_.chart);
        SurfaceSamples made;
        made.surface = chart.surface;
        made.reserve(some.size() * static_cast<std::size_t>(along * along));
        for (const std::uint32_t patch : some) {
            const std::uint32_t index = patch - grid.first_patch;
            add_points(made, chart, grid, {index % grid.columns, index / grid.columns}, along);
        }
        return made;
    }

    void add_sky(const SurfaceSamples& samples, DirectMap& map) const {
        const int face = patches_.charts().all()[block_.chart].face;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const glm::dvec3 of_patch = static_cast<double>(samples.share[i]) *
                                        scene_.sky->on_surface(samples.surface, face, samples.position_of(i));
            map.lx[samples.pixel[i]] += of_patch;
            map.reflected_lx[samples.pixel[i]] += of_patch * albedo_.over_hemisphere;
        }
    }

    const Patches& patches_;
    const LitScene& scene_;
    const Block& block_;
    const SurfaceAlbedo& albedo_;
    SampleBounds bounds_;
    SampleShader shader_;
    SoftShadow shadow_;
    std::array<SurfaceSamples, most_along + 1> samples_; // by the points along a side
    std::array<bool, most_along + 1> is_made_{};
};

} // namespace

DirectMap direct_map(const Patches& patches, const LitScene& scene, std::span<const SurfaceAlbedo> albedo) {
    DirectMap map;
    map.lx.assign(patches.count(), glm::dvec3(0.0));
    map.reflected_lx.assign(patches.count(), glm::dvec3(0.0));
    const bool throws = std::any_of(albedo.begin(), albedo.end(), [](const auto& of) { return of.lobe.has_value(); });
    if (throws && scene.lights.size() <= most_throwing_lights) {
        map.throwing.resize(scene.lights.size());
        for (std::size_t i = 0; i < scene.lights.size(); ++i)
            if (!scene.lights[i].is_dark) {
                map.throwing[i].lx.assign(patches.count(), glm::vec3(0.0F));
                map.throwing[i].thrown_lx.assign(patches.count(), glm::vec3(0.0F));
            }
    }
    const std::vector<Block> blocks = blocks_of(patches);
    parallel_for(blocks.size(), scene.options.threads, [&](std::size_t i) {
        const std::size_t surface = patches.charts().all()[blocks[i].chart].surface;
        LitBlock(patches, scene, blocks[i], albedo[surface]).add_to(map);
    });
    return map;
}

} // namespace gonio::detail
