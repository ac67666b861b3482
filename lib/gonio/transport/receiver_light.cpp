#include <gonio/base/codes/result.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/transport/exchange_geometry.hpp>
#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/receiver_light.hpp>
#include <gonio/transport/sky_light.hpp>
#include <gonio/transport/soft_shadow.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cstddef>
#include <numeric>
#include <string>
#include <utility>

namespace gonio {

namespace {

// Above a surface that the receiver may lie on [m].
constexpr double lift_m = 1e-6;

double visible_share_of(const detail::LitScene& scene, const detail::LitLight& light, detail::SoftShadow& shadow,
                        const glm::dvec3& position, const glm::dvec3& normal) {
    if (!scene.has_soft_shadow(light)) return scene.visible_center(light, no_surface, position);
    shadow.begin(light);
    std::vector<std::uint32_t>& bodies = shadow.bodies(0);
    bodies.resize(scene.stage.surfaces.size());
    std::iota(bodies.begin(), bodies.end(), 0U);
    if (light.light.emitted_by) std::erase(bodies, static_cast<std::uint32_t>(light.light.emitted_by->surface));
    detail::ShadowPoints point;
    point.add(position, normal);
    return shadow.visible(0, point, false).front().lx;
}

// The mean over the faces of a luminaire, weighted by their illuminance.
double visible_share_of(const detail::LitScene& scene, std::span<const detail::LitLight> faces,
                        detail::SoftShadow& shadow, const glm::dvec3& position, const glm::dvec3& normal) {
    if (faces.size() == 1) return visible_share_of(scene, faces.front(), shadow, position, normal);
    constexpr double fine_enough = 1e-3; // of a weight
    double all = 0.0;
    double seen = 0.0;
    for (const detail::LitLight& face : faces) {
        const double lx = detail::illuminance_of(face.light, position, normal,
                                                 {IrradianceMethod::reference, ReferenceGoal{fine_enough}})
                              .illuminance_lx;
        if (!(lx > 0.0)) continue;
        all += lx;
        seen += lx * visible_share_of(scene, face, shadow, position, normal);
    }
    return all > 0.0 ? seen / all : 1.0;
}

constexpr glm::dvec3 up{0.0, 0.0, 1.0};

// Where a receiver looks from: one on a floor under a box lies in the box, one on the box does not.
glm::dvec3 lifted(const Receiver& receiver) {
    return receiver.position + lift_m * unit_vector(receiver.normal).value_or(up);
}

// Not by the rounding of a point on its surface.
bool lies_in(const Primitive& primitive, const glm::dvec3& position) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double aside_m : {-0.5 * lift_m, 0.5 * lift_m}) {
            glm::dvec3 beside = position;
            beside[axis] += aside_m;
            if (!hides(primitive, beside)) return false;
        }
    return true;
}

} // namespace

ReceiverLight::ReceiverLight(std::unique_ptr<detail::LitScene> scene, std::unique_ptr<Interreflection> indirect,
                             std::shared_ptr<const detail::ExchangeGeometry> geometry)
    : scene_(std::move(scene)),
      indirect_(std::move(indirect)),
      geometry_(std::move(geometry)),
      sky_(geometry_ != nullptr ? scene_->options.sky : Sky(), scene_->options.threads) {}
ReceiverLight::ReceiverLight(ReceiverLight&& other) noexcept = default;
ReceiverLight& ReceiverLight::operator=(ReceiverLight&& other) noexcept = default;
ReceiverLight::~ReceiverLight() = default;

Result<ReceiverLight> ReceiverLight::on(const Stage& stage, std::span<const Light> lights,
                                        const LightingOptions& options) {
    std::unique_ptr<Interreflection> indirect;
    if (options.bounces > 0) {
        Result<Interreflection> solved = Interreflection::of(stage, lights, options);
        if (!solved) return pass_on(solved);
        indirect = std::make_unique<Interreflection>(std::move(*solved));
    }
    std::shared_ptr<const detail::ExchangeGeometry> geometry;
    if (indirect != nullptr) {
        geometry = indirect->geometry();
    } else if (!options.sky.is_dark() && !stage.surfaces.empty()) {
        ExchangeQuality quality;
        quality.cell_rays = quality.node_rays = 0;
        geometry = std::make_shared<const detail::ExchangeGeometry>(stage, lights, quality, options.threads,
                                                                    options.instruction_set);
    }
    ReceiverLight made(std::make_unique<detail::LitScene>(stage, lights, options), std::move(indirect),
                       std::move(geometry));
    for (const Light& light : lights)
        made.faces_.push_back(light.parts != nullptr ? light.parts->size() : 1);
    return made;
}

ReceiverLight::Shares ReceiverLight::at(std::span<const Receiver> receivers) const {
    const std::size_t lights = faces_.size();
    Shares shares;
    shares.visible.assign(receivers.size() * lights, 1.0);
    shares.sky_lx.assign(receivers.size(), 0.0);
    shares.indirect_lx.assign(receivers.size(), 0.0);
    const bool has_sky = !scene_->options.sky.is_dark();
    std::vector<glm::dvec3> open_lx; // of planes that nothing stands before
    if (has_sky) {
        for (const Receiver& receiver : receivers)
            open_lx.push_back(unit_vector(receiver.normal).value_or(up));
        open_lx = scene_->options.sky.irradiance(open_lx, scene_->options.threads);
    }
    const bool shadows = scene_->options.shadows != Shadows::off && !scene_->stage.surfaces.empty();
    parallel_for(receivers.size(), scene_->options.threads, [&](std::size_t i) {
        const glm::dvec3 normal = unit_vector(receivers[i].normal).value_or(up);
        const glm::dvec3 position = lifted(receivers[i]);
        detail::SoftShadow shadow(*scene_);
        std::size_t first = 0;
        for (std::size_t light = 0; shadows && light < lights; ++light) {
            const std::span<const detail::LitLight> faces(scene_->lights.data() + first, faces_[light]);
            first += faces_[light];
            shares.visible[i * lights + light] = visible_share_of(*scene_, faces, shadow, position, normal);
        }
        if (has_sky) {
            const glm::dvec3 lx = geometry_ == nullptr
                                      ? open_lx[i]
                                      : detail::sky_light_at(sky_, scene_->options, *geometry_, receivers[i].position,
                                                             normal, open_lx[i], ExchangeQuality().receiver_rays);
            shares.sky_lx[i] = glm::dot(lx, rec709_luminance);
        }
        if (indirect_ != nullptr)
            shares.indirect_lx[i] = glm::dot(indirect_->at(receivers[i].position, normal), rec709_luminance);
    });
    return shares;
}

Diagnostics check_receivers(const Stage& stage, std::span<const Receiver> receivers) {
    Diagnostics diagnostics;
    for (const Surface& surface : stage.surfaces) {
        std::size_t count = 0;
        std::size_t first = 0;
        for (std::size_t i = receivers.size(); i-- > 0;) {
            if (!lies_in(surface.geometry, lifted(receivers[i]))) continue;
            ++count;
            first = i;
        }
        if (count == 0) continue;
        const bool is_plane = is_sheet(surface.geometry);
        diagnostics.push_back(result_diagnostic(
            "RES0408",
            fmt::format("point {} lies {} '{}', where no light reaches it: its value has no meaning{}", first + 1,
                        is_plane ? "behind" : "in", surface.name,
                        count > 1 ? fmt::format("; {} such points in total", count) : std::string()),
            is_plane ? "move it to the lit side" : "move it out of the solid"));
    }
    return diagnostics;
}

} // namespace gonio
