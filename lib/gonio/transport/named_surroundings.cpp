#include <gonio/ibl/environment_tree.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/transport/local_probe.hpp>
#include <gonio/transport/named_surroundings.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <variant>

namespace gonio::detail {

namespace {

constexpr int cube_side = 128; // as engines keep a sky
constexpr int irradiance_side = 32;
constexpr int table_size = 64;
constexpr double tolerance = 1e-3; // of the map's mean, far below what the methods themselves are off

EnvironmentMap cube_of(const Sky& sky, unsigned threads) {
    const EnvironmentGrid grid = environment_grid(EnvironmentLayout::cube_strip, cube_side).value();
    if (!sky.image()) return rendered(sky, grid, threads);
    EnvironmentMap map = resampled(*sky.image(), grid, sky.rotation(), threads);
    map.set_nits_per_unit(map.nits_per_unit() * sky.image_scale());
    return map;
}

} // namespace

std::shared_ptr<const NamedSurroundings> NamedSurroundings::of(const LightingOptions& options,
                                                               std::span<const CoreMaterial> materials) {
    const SurroundingsMethod method = options.surroundings;
    if (method == SurroundingsMethod::exact) return nullptr;
    auto named = std::make_shared<NamedSurroundings>();
    named->method_ = method;
    if (has_local_probe(method)) {
        named->probe_ = options.probe;
        return named->probe_ != nullptr ? named : nullptr;
    }
    if (options.sky.is_dark()) return nullptr;
    const EnvironmentMap cube = cube_of(options.sky, options.threads);
    if (method == SurroundingsMethod::spherical_harmonics) {
        named->harmonics_ = irradiance_sh(cube, 2, options.threads);
        return named;
    }
    const EnvironmentTree tree(cube, options.threads);
    const EnvironmentGrid small = environment_grid(EnvironmentLayout::cube_strip, irradiance_side).value();
    named->irradiance_ = irradiance_map(tree, small, tolerance, options.threads);
    PrefilterOptions prefiltering;
    prefiltering.side = cube_side;
    prefiltering.levels = 6;
    prefiltering.tolerance = tolerance;
    prefiltering.threads = options.threads;
    named->sky_levels_ = prefilter(cube, tree, prefiltering).value();
    if (method == SurroundingsMethod::prefiltered) return named;
    const SplitSumModel model = method == SurroundingsMethod::split_sum ? SplitSumModel::ue4 : SplitSumModel::frostbite;
    named->table_ = SplitSumTable::create(table_size, model, options.threads).value();
    for (const CoreMaterial& material : materials)
        named->reflectances_.push_back(std::visit(
            [](const auto& core) -> std::optional<Reflectance> {
                if constexpr (requires { gloss(core).f90; }) {
                    const auto lobe = gloss(core);
                    return Reflectance{lobe.factor * vec(lobe.f0), lobe.factor * lobe.f90};
                } else {
                    return std::nullopt;
                }
            },
            material));
    return named;
}

glm::dvec3 NamedSurroundings::sky_lx(const glm::dvec3& normal) const {
    if (harmonics_) return glm::max(harmonics_->irradiance(normal), glm::dvec3(0.0));
    return std::numbers::pi * irradiance_->radiance(normal);
}

glm::dvec3 NamedSurroundings::glossy(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& view,
                                     const Lobe& lobe) const {
    const double cosine = glm::dot(normal, view);
    if (!(cosine > 0.0)) return glm::dvec3(0.0);
    const glm::dvec3 mirrored = 2.0 * cosine * normal - view;
    const double roughness = std::sqrt(lobe.alpha);
    if (probe_ != nullptr) {
        const glm::dvec3 seen = method_ == SurroundingsMethod::parallax_box
                                    ? parallax_corrected(probe_->box, probe_->position, position, mirrored)
                                    : parallax_corrected(probe_->sphere, probe_->position, position, mirrored);
        return lobe.albedo * probe_->light.radiance(seen, roughness);
    }
    glm::dvec3 way = mirrored;
    if (method_ == SurroundingsMethod::dominant_direction) {
        const double smoothness = 1.0 - lobe.alpha;
        way = glm::mix(normal, mirrored, smoothness * (std::sqrt(smoothness) + lobe.alpha));
    }
    glm::dvec3 reflectance = lobe.albedo;
    if (table_ && reflectances_[lobe.surface]) {
        const SplitSum sum = table_->lookup(cosine, roughness);
        const Reflectance& schlick = *reflectances_[lobe.surface];
        reflectance = sum.scale * schlick.f0 + sum.bias * schlick.f90;
    }
    return reflectance * sky_levels_->radiance(way, roughness);
}

} // namespace gonio::detail
