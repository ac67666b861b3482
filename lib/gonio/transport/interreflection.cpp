#include <gonio/base/parallel.hpp>
#include <gonio/light/light_change.hpp>
#include <gonio/light/light_parts.hpp>
#include <gonio/scene/directional_albedo.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/transport/direct_map.hpp>
#include <gonio/transport/exchange_geometry.hpp>
#include <gonio/transport/indirect_solution.hpp>
#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/sky_light.hpp>
#include <gonio/transport/thrown_light.hpp>

#include <glm/common.hpp>

#include <algorithm>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

using detail::by_sender;
using detail::ExchangeGeometry;
using detail::Patches;

Result<void> has_solution(const ExchangeGeometry& geometry, std::span<const glm::dvec3> albedo) {
    const Patches& patches = geometry.patches();
    glm::dvec3 lost(0.0); // of light that is spread over all cells
    double area_m2 = 0.0;
    for (std::uint32_t cell = 0; cell < patches.cells().size(); ++cell) {
        const glm::dvec3& of = albedo[patches.charts().all()[patches.cells()[cell].chart].surface];
        lost += patches.cell_area_m2(cell) * (1.0 - of * (1.0 - geometry.escaping(cell)));
        area_m2 += patches.cell_area_m2(cell);
    }
    constexpr double least = 1e-4;
    if (std::min({lost.x, lost.y, lost.z}) >= least * area_m2) return {};
    return fail("USE0106", "the stage is closed and its surfaces reflect all light, so light cannot leave it",
                "give a surface an albedo below 1, or ask for a number of bounces");
}

} // namespace

glm::dvec3 hemispherical_albedo(const Material& material, bool specular) {
    CoreMaterial core = core_material(material);
    if (!specular) core = std::visit([](const auto& of) { return CoreMaterial(shading::diffuse_alone(of)); }, core);
    return DirectionalAlbedo(core, DirectionalAlbedo::Fineness::coarse).over_hemisphere();
}

Interreflection::Interreflection() = default;
Interreflection::Interreflection(const Interreflection& other) = default;
Interreflection::Interreflection(Interreflection&& other) noexcept = default;
Interreflection& Interreflection::operator=(const Interreflection& other) = default;
Interreflection& Interreflection::operator=(Interreflection&& other) noexcept = default;
Interreflection::~Interreflection() = default;

Result<Interreflection> Interreflection::of(const Stage& stage, std::span<const Light> lights,
                                            const LightingOptions& options, const ExchangeQuality& quality,
                                            const Interreflection* known) {
    ExchangeQuality used = quality;
    if (!options.sky.is_dark() && used.node_rays > 0) used.node_rays = std::max(used.node_rays, used.sky_rays);
    if (known != nullptr)
        if (const std::optional<glm::dvec3> change = known->change_to(stage, lights, options, used)) {
            Interreflection changed = known->times(*change);
            changed.lights_.assign(lights.begin(), lights.end());
            return changed;
        }
    Interreflection exchange;
    exchange.receiver_rays_ = quality.receiver_rays;
    exchange.instruction_set_ = options.instruction_set;
    exchange.lights_.assign(lights.begin(), lights.end());
    for (const Surface& surface : stage.surfaces)
        exchange.materials_.push_back(surface.material);
    exchange.bounces_ = options.bounces;
    exchange.shadows_ = options.shadows;
    exchange.geometry_ =
        known != nullptr && known->geometry_->fits(stage, lights, used)
            ? known->geometry_
            : std::make_shared<ExchangeGeometry>(stage, lights, used, options.threads, options.instruction_set);
    const ExchangeGeometry& geometry = *exchange.geometry_;
    const Patches& patches = geometry.patches();
    exchange.albedo_.resize(stage.surfaces.size());
    const ShiningLights shining(lights);
    std::vector<detail::SurfaceAlbedo> albedo(stage.surfaces.size());
    parallel_for(stage.surfaces.size(), options.threads, [&](std::size_t i) {
        const CoreMaterial material = core_material(stage.surfaces[i].material);
        albedo[i].by_cosine = DirectionalAlbedo(material, DirectionalAlbedo::Fineness::coarse);
        albedo[i].over_hemisphere = exchange.albedo_[i] = albedo[i].by_cosine.over_hemisphere();
        if (shining.all().size() <= detail::most_throwing_lights)
            albedo[i].lobe = detail::throwing_lobe(material, albedo[i].by_cosine);
    });
    if (options.bounces == all_bounces)
        if (Result<void> solvable = has_solution(geometry, exchange.albedo_); !solvable) return pass_on(solvable);
    LightingOptions exact = options;
    exact.method = IrradianceMethod::exact;
    exact.specular = false;
    exact.bounces = 0;
    {
        detail::LitScene scene(stage, lights, exact);
        if (!options.sky.is_dark())
            exchange.sky_ = std::make_shared<const detail::SkyLight>(options, exchange.geometry_);
        scene.sky = exchange.sky_.get();
        detail::DirectMap direct = direct_map(patches, scene, albedo);
        exchange.direct_lx_ = std::move(direct.lx);
        exchange.direct_reflected_lx_ = std::move(direct.reflected_lx);
        exchange.direct_spread_lx_ = exchange.direct_reflected_lx_;
        for (const detail::ThrowingLight& light : direct.throwing)
            for (std::size_t i = 0; i < light.thrown_lx.size(); ++i)
                exchange.direct_spread_lx_[i] -= glm::dvec3(light.thrown_lx[i]);
        std::vector<std::optional<detail::ThrowingLobe>> lobes;
        for (detail::SurfaceAlbedo& of_surface : albedo)
            lobes.push_back(std::move(of_surface.lobe));
        exchange.thrown_ =
            std::make_shared<const detail::ThrownLight>(patches, scene.all_lights, direct.throwing, lobes);
    }
    exchange.slopes_ = std::make_shared<const detail::SentSlopes>(slopes_of(patches, exchange.direct_spread_lx_));
    exchange.direct_to_nodes_lx_ = exchange.finely_to_nodes(options.threads);
    // Cells are coarse, so what they solve is gathered twice: at nodes, and from what patches then receive at nodes
    // again.
    const bool to_the_end = options.bounces == all_bounces;
    const bool twice = options.bounces > 1;
    const int on_cells = to_the_end ? all_bounces : options.bounces - (twice ? 2 : 1);
    const std::vector<glm::dvec3> cells_lx =
        solve_indirect(geometry, exchange.albedo_, exchange.direct_reflected_lx_, on_cells, options.threads);
    std::vector<glm::dvec3> indirect_lx(patches.count());
    for (std::uint32_t i = 0; i < indirect_lx.size(); ++i)
        indirect_lx[i] = cells_lx[patches.cell_of(i)];
    exchange.sent_ = exchange.seen_from_nodes(indirect_lx);
    // What is gathered again needs fewer rays.
    exchange.nodes_lx_ = exchange.gathered(exchange.sent_, twice ? 3 : 1, options.threads);
    if (twice) {
        exchange.sent_ = exchange.seen_from_nodes(exchange.on_patches(exchange.nodes_lx_, options.threads));
        exchange.nodes_lx_ = exchange.gathered(exchange.sent_, 1, options.threads);
    }
    exchange.sum_up(to_the_end, options.threads);
    exchange.shown_lx_.resize(patches.count());
    exchange.bounced_shown_lx_.resize(patches.count());
    for (std::uint32_t i = 0; i < exchange.shown_lx_.size(); ++i) {
        // A covered patch is dark, and no ray meets its covered part.
        if (!(patches.area_m2(i) > 0.0)) continue;
        exchange.shown_lx_[i] = detail::Sent(exchange.sent_[i].rgb() / static_cast<double>(patches.by_rays(i)));
        exchange.shown_lx_[i].value[3] = 1.0F;
        const double factor = to_the_end ? 1.0 : geometry.node_factor(patches.chart_of(i));
        exchange.bounced_shown_lx_[i] = detail::Sent(glm::max(
            exchange.sent_[i].rgb() / static_cast<double>(patches.by_rays(i)) - factor * exchange.direct_spread_lx_[i],
            glm::dvec3(0.0)));
    }
    return exchange;
}

// The factor, per channel, that makes this the light of other lights; none if more than that changed.
std::optional<glm::dvec3> Interreflection::change_to(const Stage& stage, std::span<const Light> lights,
                                                     const LightingOptions& options,
                                                     const ExchangeQuality& quality) const {
    const bool same_options = options.sky.is_dark() && sky_ == nullptr && options.bounces == bounces_ &&
                              options.shadows == shadows_ && options.instruction_set == instruction_set_ &&
                              quality.receiver_rays == receiver_rays_;
    if (!same_options || !geometry_->fits(stage, lights, quality)) return std::nullopt;
    for (std::size_t i = 0; i < materials_.size(); ++i)
        if (!are_same(materials_[i], stage.surfaces[i].material)) return std::nullopt;
    if (!differ_in_amount_alone(lights_, lights)) return std::nullopt;
    const std::optional<LightChange> change = common_change(lights_, lights);
    return change ? std::optional(change->rgb) : std::nullopt;
}

Interreflection Interreflection::times(const glm::dvec3& rgb) const {
    Interreflection changed = *this;
    if (rgb == glm::dvec3(1.0)) return changed;
    const auto multiply = [&](detail::Sent& sent) {
        for (int channel = 0; channel < 3; ++channel)
            sent.value[channel] = static_cast<float>(rgb[channel] * static_cast<double>(sent.value[channel]));
    };
    for (std::vector<glm::dvec3>* const of :
         {&changed.direct_lx_, &changed.direct_reflected_lx_, &changed.direct_spread_lx_, &changed.direct_to_nodes_lx_})
        for (glm::dvec3& lx : *of)
            lx *= rgb;
    changed.thrown_ = std::make_shared<const detail::ThrownLight>(thrown_->times(glm::vec3(rgb)));
    detail::SentSlopes slopes = *slopes_;
    for (std::vector<detail::SentSlope>* const of : {&slopes.by_rays, &slopes.by_links})
        for (detail::SentSlope& slope : *of) {
            multiply(slope.along_u);
            multiply(slope.along_v);
        }
    changed.slopes_ = std::make_shared<const detail::SentSlopes>(std::move(slopes));
    for (detail::NodeValue& node : changed.nodes_lx_) {
        node.value *= rgb;
        for (glm::dvec3& slope : node.slope)
            slope *= rgb;
    }
    for (std::vector<detail::Sent>* const of : {&changed.sent_, &changed.shown_lx_, &changed.bounced_shown_lx_})
        for (detail::Sent& sent : *of)
            multiply(sent);
    for (glm::dvec3* const lm : {&changed.balance_.direct_lm, &changed.balance_.indirect_lm,
                                 &changed.balance_.absorbed_lm, &changed.balance_.escaped_lm})
        *lm *= rgb;
    return changed;
}

// Without what lobes throw.
glm::dvec3 Interreflection::reflected_lx(std::uint32_t patch, const glm::dvec3& indirect_lx) const {
    return direct_spread_lx_[patch] + albedo_[geometry_->patches().surface_of(patch)] * indirect_lx;
}

// What nodes gather of the direct light that means over patches do not have: of its slopes, and of what glossy lobes
// throw.
std::vector<glm::dvec3> Interreflection::finely_to_nodes(unsigned threads) const {
    const std::vector<detail::Node>& nodes = geometry_->nodes();
    const detail::Bundles& bundles = geometry_->from_nodes();
    std::vector<glm::dvec3> lx(nodes.size(), glm::dvec3(0.0));
    constexpr std::size_t together = 64;
    parallel_for((nodes.size() + together - 1) / together, threads, [&](std::size_t block) {
        for (std::size_t i = block * together; i < std::min((block + 1) * together, nodes.size()); ++i) {
            if (!nodes[i].gathers()) continue;
            lx[i] = bundles.gathered(i, *slopes_);
            if (!thrown_->empty()) lx[i] += thrown_->gathered(bundles, i, {nodes[i].position, nodes[i].normal});
        }
    });
    return lx;
}

// What patches and their cells send, with the factors of what nodes see of them.
std::vector<detail::Sent> Interreflection::seen_from_nodes(std::span<const glm::dvec3> indirect_lx) const {
    const Patches& patches = geometry_->patches();
    std::vector<glm::dvec3> sent(indirect_lx.size());
    for (std::uint32_t i = 0; i < sent.size(); ++i)
        sent[i] = geometry_->node_factor(patches.chart_of(i)) * reflected_lx(i, indirect_lx[i]);
    return by_sender(patches, sent);
}

std::vector<detail::NodeValue> Interreflection::gathered(std::span<const detail::Sent> sent, std::size_t step,
                                                         unsigned threads) const {
    const std::vector<detail::Node>& nodes = geometry_->nodes();
    std::vector<glm::dvec3> lx(nodes.size(), glm::dvec3(0.0));
    constexpr std::size_t together = 64;
    parallel_for((nodes.size() + together - 1) / together, threads, [&](std::size_t block) {
        for (std::size_t i = block * together; i < std::min((block + 1) * together, nodes.size()); ++i)
            if (nodes[i].gathers()) lx[i] = geometry_->from_nodes().gathered(i, sent, step) + direct_to_nodes_lx_[i];
    });
    return geometry_->field_of(lx);
}

// What nodes gather of 1 lx on all patches.
std::vector<detail::NodeValue> Interreflection::gathered_of_uniform() const {
    const std::vector<detail::Node>& nodes = geometry_->nodes();
    const std::vector<detail::Chart>& charts = geometry_->patches().charts().all();
    std::vector<glm::dvec3> lx(nodes.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t chart = 0; nodes[i].gathers() && chart < charts.size(); ++chart)
            lx[i] += geometry_->from_nodes().of_chart(i, chart) * geometry_->node_factor(chart) *
                     albedo_[charts[chart].surface];
    return geometry_->field_of(lx);
}

std::vector<glm::dvec3> Interreflection::on_patches(std::span<const detail::NodeValue> nodes_lx,
                                                    unsigned threads) const {
    std::vector<glm::dvec3> lx(geometry_->patches().count(), glm::dvec3(0.0));
    constexpr std::size_t together = 1024;
    parallel_for((lx.size() + together - 1) / together, threads, [&](std::size_t block) {
        for (std::size_t i = block * together; i < std::min((block + 1) * together, lx.size()); ++i)
            lx[i] = geometry_->around(static_cast<std::uint32_t>(i))(nodes_lx);
    });
    return lx;
}

// What receivers gather is finer by one step than what nodes gathered, where that is not another bounce.
void Interreflection::sum_up(bool to_the_end, unsigned threads) {
    const Patches& patches = geometry_->patches();
    std::vector<glm::dvec3> on_patch = on_patches(nodes_lx_, threads);
    const auto sum = [&](const auto& of_patch) {
        glm::dvec3 total(0.0);
        for (std::uint32_t i = 0; i < on_patch.size(); ++i)
            total += patches.area_m2(i) * of_patch(i);
        return total;
    };
    const auto albedo = [&](std::uint32_t i) { return albedo_[patches.surface_of(i)]; };
    const auto stays = [&](std::uint32_t i) { return 1.0 - geometry_->escaping(patches.cell_of(i)); };
    // Flux that the rays lost or gained arrives like what uniform light leaves after a bounce.
    if (to_the_end && !patches.charts().endless()) {
        const glm::dvec3 sent_lm = sum([&](std::uint32_t i) { return direct_reflected_lx_[i]; });
        const glm::dvec3 returned_lm = sum([&](std::uint32_t i) { return direct_reflected_lx_[i] * stays(i); });
        if (returned_lm.x >= 0.5 * sent_lm.x && returned_lm.y >= 0.5 * sent_lm.y && returned_lm.z >= 0.5 * sent_lm.z) {
            const std::vector<detail::NodeValue> shape = gathered_of_uniform();
            const std::vector<glm::dvec3> shape_on_patch = on_patches(shape, threads);
            const glm::dvec3 missing_lm =
                returned_lm - sum([&](std::uint32_t i) { return on_patch[i] * (1.0 - albedo(i) * stays(i)); });
            const glm::dvec3 of_shape_lm =
                sum([&](std::uint32_t i) { return shape_on_patch[i] * (1.0 - albedo(i) * stays(i)); });
            glm::dvec3 level(0.0);
            for (int channel = 0; channel < 3; ++channel)
                if (of_shape_lm[channel] > 0.0) level[channel] = missing_lm[channel] / of_shape_lm[channel];
            for (std::size_t i = 0; i < nodes_lx_.size(); ++i) {
                nodes_lx_[i].value += level * shape[i].value;
                for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
                    nodes_lx_[i].slope[axis] += level * shape[i].slope[axis];
            }
            for (std::size_t i = 0; i < on_patch.size(); ++i)
                on_patch[i] += level * shape_on_patch[i];
        }
    }
    const auto reflected = [&](std::uint32_t i) { return reflected_lx(i, on_patch[i]); };
    balance_.direct_lm = sum([&](std::uint32_t i) { return direct_lx_[i]; });
    balance_.indirect_lm = sum([&](std::uint32_t i) { return on_patch[i]; });
    const auto leaves = [&](std::uint32_t i) { return direct_reflected_lx_[i] + albedo(i) * on_patch[i]; };
    balance_.absorbed_lm = sum([&](std::uint32_t i) { return direct_lx_[i] + on_patch[i] - leaves(i); });
    if (to_the_end) {
        std::vector<glm::dvec3> sent(patches.count());
        for (std::uint32_t i = 0; i < sent.size(); ++i)
            sent[i] = reflected(i);
        sent_ = by_sender(patches, sent);
    }
    balance_.escaped_lm = sum([&](std::uint32_t i) { return leaves(i) * (1.0 - stays(i)); });
}

glm::dvec3 Interreflection::on_surface(std::size_t surface, int face, const glm::dvec3& position) const {
    return geometry_->around(geometry_->patches().charts().index_of(surface, face), position)(nodes_lx_);
}

glm::vec3 Interreflection::luminance_at(const detail::PatchPlace& place, float fine_m, const glm::vec3& towards,
                                        const glm::vec3& left_out) const {
    const Patches& patches = geometry_->patches();
    const float between_rays = fine_m / std::max(place.distance_m, 1e-6F);
    const detail::PatchMean around = patches.around(place.chart, place.u, place.v);
    detail::SentSum sum;
    for (std::size_t i = 0; i < around.patch.size(); ++i)
        sum.add(around.weight[i], shown_lx_[around.patch[i]]);
    if (sum.is_empty()) return glm::vec3(0.0F);
    glm::vec3 sent = sum.mean();
    if (thrown_->comes_from(patches.charts().all()[place.chart].surface))
        sent += thrown_->along(around, towards, between_rays) / sum.weight();
    if (left_out != glm::vec3(0.0F)) {
        detail::SentSum bounced;
        for (std::size_t i = 0; i < around.patch.size(); ++i)
            bounced.add(around.weight[i], bounced_shown_lx_[around.patch[i]]);
        sent -= left_out * glm::vec3(bounced.rgb()) / sum.weight();
    }
    return std::numbers::inv_pi_v<float> * sent;
}

glm::dvec3 Interreflection::at(const glm::dvec3& position, const glm::dvec3& normal) const {
    detail::Receivers::Place place{position + Patches::lift(geometry_->patches().square_m()) * normal, normal};
    place.is_fine = true;
    const detail::Bundles bundle(geometry_->stage(), geometry_->patches(), {&place, 1}, receiver_rays_, 1,
                                 instruction_set_);
    glm::dvec3 lx = bundle.gathered(0, sent_) + bundle.gathered(0, *slopes_);
    if (!thrown_->empty()) lx += thrown_->gathered(bundle, 0, place);
    return lx;
}

std::span<const detail::NodeValue> Interreflection::nodes_lx() const {
    return nodes_lx_;
}

std::size_t Interreflection::node_count() const {
    return geometry_->nodes().size();
}
std::size_t Interreflection::patch_count() const {
    return geometry_->patches().count();
}
std::size_t Interreflection::memory() const {
    return geometry_->memory() +
           (direct_lx_.size() + direct_reflected_lx_.size() + direct_spread_lx_.size() + direct_to_nodes_lx_.size()) *
               sizeof(glm::dvec3) +
           nodes_lx_.size() * sizeof(detail::NodeValue) +
           (sent_.size() + shown_lx_.size() + bounced_shown_lx_.size() +
            2 * (slopes_->by_rays.size() + slopes_->by_links.size())) *
               sizeof(detail::Sent) +
           thrown_->memory();
}

} // namespace gonio
