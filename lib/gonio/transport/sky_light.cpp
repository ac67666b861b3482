#include <gonio/base/parallel.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/transport/exchange_geometry.hpp>
#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/sky_light.hpp>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <utility>

namespace gonio::detail {

namespace {

constexpr double pi = std::numbers::pi;
constexpr glm::dvec3 up{0.0, 0.0, 1.0};

std::vector<glm::dvec3> luminance_along(const BlurredSky& sky, std::span<const glm::dvec3> directions,
                                        const glm::dvec3& normal) {
    const Frame frame = frame_about(glm::dvec3(0.0), normal);
    // Rays with the density cos θ/π see the same share of the plane's illuminance each.
    const double width = std::sqrt(pi / static_cast<double>(directions.size()));
    std::vector<glm::dvec3> nt;
    nt.reserve(directions.size());
    for (const glm::dvec3& direction : directions)
        nt.push_back(sky.radiance(frame.to_world(direction), width));
    return nt;
}

glm::dvec3 mean_of(std::span<const glm::dvec3> values) {
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

// What a bundle with these directions makes of an open plane with the illuminance `open_lx`: exactly that.
void correct(std::vector<glm::dvec3>& nt, const glm::dvec3& open_lx) {
    const glm::dvec3 missing = open_lx * std::numbers::inv_pi - mean_of(nt);
    for (glm::dvec3& value : nt)
        value += missing;
}

} // namespace

SkyLight::SkyLight(const LightingOptions& options, std::shared_ptr<const ExchangeGeometry> geometry)
    : geometry_(std::move(geometry)), sky_(options.sky, options.threads) {
    const Bundles& bundles = geometry_->from_nodes();
    const Charts& charts = geometry_->patches().charts();

    // All rays about a flat chart's normal are the same everywhere on it.
    std::vector<glm::dvec3> normals;
    for (const Chart& chart : charts.all())
        normals.push_back(chart.kind == Chart::Kind::flat ? chart.frame.z : up);
    const std::vector<glm::dvec3> open_lx = options.sky.irradiance(normals, options.threads);
    std::vector<std::vector<glm::dvec3>> of_charts(normals.size());
    parallel_for(of_charts.size(), options.threads, [&](std::size_t i) {
        if (charts.all()[i].kind != Chart::Kind::flat) return;
        of_charts[i] = luminance_along(sky_, cosine_directions(geometry_->node_rays(i)), normals[i]);
        correct(of_charts[i], open_lx[i]);
    });

    const std::vector<Node>& nodes = geometry_->nodes();
    // About normals of round charts, by the factor on the number of rays.
    std::map<std::size_t, std::vector<glm::dvec3>> about_round;
    for (std::size_t i = 0; i < charts.all().size(); ++i)
        if (charts.all()[i].kind == Chart::Kind::round && about_round.count(geometry_->node_rays(i)) == 0)
            about_round[geometry_->node_rays(i)] = cosine_directions(geometry_->node_rays(i));
    std::vector<glm::dvec3> lx(nodes.size(), glm::dvec3(0.0));
    constexpr std::size_t together = 64;
    parallel_for((nodes.size() + together - 1) / together, options.threads, [&](std::size_t block) {
        for (std::size_t i = block * together; i < std::min((block + 1) * together, nodes.size()); ++i) {
            const Node& node = nodes[i];
            if (!node.gathers()) continue;
            const int face = face_at(geometry_->stage().surfaces[node.surface].geometry, node.position);
            const std::size_t chart = charts.index_of(node.surface, face);
            const std::vector<glm::dvec3>& flat = of_charts[chart];
            const std::vector<glm::dvec3> round =
                flat.empty() ? luminance_along(sky_, about_round.at(geometry_->node_rays(chart)), node.normal)
                             : std::vector<glm::dvec3>();
            const std::vector<glm::dvec3>& nt = flat.empty() ? round : flat;
            lx[i] = pi * (options.shadows == Shadows::off ? mean_of(nt) : bundles.leaving(i, nt));
        }
    });
    lx_ = geometry_->field_of(lx);
}

std::shared_ptr<const SkyLight> SkyLight::on(const Stage& stage, std::span<const Light> lights,
                                             const LightingOptions& options, const Interreflection* indirect) {
    if (options.sky.is_dark()) return nullptr;
    if (indirect != nullptr) return indirect->sky();
    ExchangeQuality quality;
    quality.cell_rays = 0;
    quality.node_rays = quality.sky_rays;
    return std::make_shared<const SkyLight>(
        options,
        std::make_shared<const ExchangeGeometry>(stage, lights, quality, options.threads, options.instruction_set));
}

glm::dvec3 SkyLight::on_surface(std::size_t surface, int face, const glm::dvec3& position) const {
    return geometry_->around(geometry_->patches().charts().index_of(surface, face), position)(lx_);
}

glm::dvec3 sky_light_at(const BlurredSky& sky, const LightingOptions& options, const ExchangeGeometry& geometry,
                        const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& open_lx,
                        std::size_t rays) {
    if (options.shadows == Shadows::off) return open_lx;
    std::vector<glm::dvec3> nt = luminance_along(sky, cosine_directions(rays), normal);
    correct(nt, open_lx);
    const Receivers::Place place{position + Patches::lift(geometry.patches().square_m()) * normal, normal};
    const Bundles bundle(geometry.stage(), geometry.patches(), {&place, 1}, rays, 1, options.instruction_set);
    return glm::max(pi * bundle.leaving(0, nt), glm::dvec3(0.0));
}

} // namespace gonio::detail
