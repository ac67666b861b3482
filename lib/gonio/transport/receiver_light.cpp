#include <gonio/base/parallel.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/transport/exchange_geometry.hpp>
#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/receiver_light.hpp>
#include <gonio/transport/sky_light.hpp>
#include <gonio/transport/soft_shadow.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace gonio {

namespace {

// Above a surface that the receiver may lie on [m].
constexpr double lift_m = 1e-6;

double visible_share_of(const detail::LitScene& scene, const detail::LitLight& light, detail::SoftShadow& shadow,
                        const glm::dvec3& position, const glm::dvec3& normal) {
    const std::size_t no_surface = scene.stage.surfaces.size();
    if (!scene.has_soft_shadow(light)) return scene.visible_center(light, no_surface, position);
    shadow.begin(light);
    std::vector<std::uint32_t>& bodies = shadow.bodies(0);
    bodies.resize(scene.stage.surfaces.size());
    std::iota(bodies.begin(), bodies.end(), 0U);
    return shadow.visible(0, position, normal);
}

constexpr glm::dvec3 up{0.0, 0.0, 1.0};

// Of planes that nothing stands before [lx].
std::vector<glm::dvec3> open_to_the_sky(const LightingOptions& options, std::span<const Receiver> receivers) {
    std::vector<glm::dvec3> normals;
    for (const Receiver& receiver : receivers)
        normals.push_back(unit_vector(receiver.normal).value_or(up));
    const auto before = [&](std::size_t a, std::size_t b) {
        return std::tie(normals[a].x, normals[a].y, normals[a].z) < std::tie(normals[b].x, normals[b].y, normals[b].z);
    };
    std::vector<std::size_t> order(normals.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), before);
    std::vector<glm::dvec3> different;
    std::vector<std::size_t> which(normals.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || normals[order[i]] != different.back()) different.push_back(normals[order[i]]);
        which[order[i]] = different.size() - 1;
    }
    different = options.sky.irradiance(different);
    std::vector<glm::dvec3> lx;
    for (const std::size_t index : which)
        lx.push_back(different[index]);
    return lx;
}

} // namespace

ReceiverLight::ReceiverLight(std::unique_ptr<detail::LitScene> scene, std::unique_ptr<Interreflection> indirect,
                             std::unique_ptr<detail::SkyLight> sky)
    : scene_(std::move(scene)), indirect_(std::move(indirect)), sky_(std::move(sky)) {}
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
    std::unique_ptr<detail::SkyLight> sky;
    if (!options.sky.is_dark() && !stage.surfaces.empty()) {
        auto geometry =
            indirect != nullptr
                ? indirect->geometry()
                : std::make_shared<const detail::ExchangeGeometry>(stage, lights, ExchangeQuality{.cell_rays = 0},
                                                                   options.threads, options.instruction_set);
        sky = std::make_unique<detail::SkyLight>(options, std::move(geometry));
    }
    return ReceiverLight(std::make_unique<detail::LitScene>(stage, lights, options), std::move(indirect),
                         std::move(sky));
}

ReceiverLight::Shares ReceiverLight::at(std::span<const Receiver> receivers) const {
    const std::size_t lights = scene_->lights.size();
    Shares shares;
    shares.visible.assign(receivers.size() * lights, 1.0);
    shares.sky_lx.assign(receivers.size(), 0.0);
    shares.indirect_lx.assign(receivers.size(), 0.0);
    const bool has_sky = !scene_->options.sky.is_dark();
    // Many receivers, as those of a grid, face the same way, and the light of an image takes long to sum up.
    const std::vector<glm::dvec3> open_lx =
        has_sky ? open_to_the_sky(scene_->options, receivers) : std::vector<glm::dvec3>();
    const bool shadows = scene_->options.shadows != Shadows::off && !scene_->stage.surfaces.empty();
    parallel_for(receivers.size(), scene_->options.threads, [&](std::size_t i) {
        const glm::dvec3 normal = unit_vector(receivers[i].normal).value_or(up);
        const glm::dvec3 position = receivers[i].position + lift_m * normal;
        detail::SoftShadow shadow(*scene_);
        for (std::size_t light = 0; shadows && light < lights; ++light)
            shares.visible[i * lights + light] =
                visible_share_of(*scene_, scene_->lights[light], shadow, position, normal);
        if (has_sky) {
            const glm::dvec3 lx = sky_ == nullptr
                                      ? open_lx[i]
                                      : sky_->at(receivers[i].position, normal, open_lx[i],
                                                 ExchangeQuality().receiver_rays, scene_->options.instruction_set);
            shares.sky_lx[i] = glm::dot(lx, rec709_luminance);
        }
        if (indirect_ != nullptr)
            shares.indirect_lx[i] = glm::dot(indirect_->at(receivers[i].position, normal), rec709_luminance);
    });
    return shares;
}

} // namespace gonio
