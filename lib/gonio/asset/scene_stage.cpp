#include <gonio/asset/detail/scene_stage.hpp>
#include <gonio/base/gauss_legendre.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/shading/gloss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <variant>

namespace gonio::asset_detail {

namespace {

using std::numbers::pi;
using Vec = shading::vec3<double>;

glm::dvec3 color(const Vec& v) {
    return {v.x, v.y, v.z};
}

// The share of uniform light from all sides that the diffuse part reflects: (1/π) ∬ f ⟨n·l⟩⟨n·v⟩ dl dv over both
// hemispheres, for f that depends on azimuths only through the angle between those of l and v. Accurate to 1e-5 or
// better.
template<class Core>
glm::dvec3 mean_albedo(const Core& core) {
    constexpr auto rule = gauss_legendre<12>();
    constexpr int turns = 16; // over half the azimuth; the other half mirrors it
    const Vec n{0.0, 0.0, 1.0};
    Vec sum{0.0, 0.0, 0.0};
    for (const QuadratureNode& eye : rule)
        for (const QuadratureNode& light : rule) {
            const double mu_v = 0.5 + 0.5 * eye.at;
            const double mu_l = 0.5 + 0.5 * light.at;
            const Vec v{std::sqrt(1.0 - mu_v * mu_v), 0.0, mu_v};
            const double across = std::sqrt(1.0 - mu_l * mu_l);
            const double weight = 0.25 * eye.weight * light.weight * mu_v * mu_l * 4.0 * pi / turns;
            for (int i = 0; i < turns; ++i) {
                const double phi = pi * (i + 0.5) / turns;
                const Vec l{across * std::cos(phi), across * std::sin(phi), mu_l};
                sum = sum + diffuse_part(core, n, l, v) * weight;
            }
        }
    return color(sum);
}

template<class Core>
void take_lobe(const Core& core, SceneMaterial& made, std::vector<std::string>& losses) {
    const auto gloss = shading::gloss(core);
    made.f0 = color(gloss.f0 * gloss.factor);
    made.alpha = gloss.lobe.alpha;
    if (made.has_lobe() && gloss.f90 * gloss.factor < 1.0)
        losses.emplace_back("its reduced reflection at grazing angles is written as full reflection");
}

// Whether the diffuse part depends on the directions.
template<class Core>
bool is_rough(const Core& core) {
    const Vec n{0.0, 0.0, 1.0};
    const Vec low{0.8, 0.0, 0.6};
    const Vec opposite{-0.8, 0.0, 0.6};
    const glm::dvec3 along = color(diffuse_part(core, n, n, n));
    return color(diffuse_part(core, n, low, low)) != along || color(diffuse_part(core, n, low, opposite)) != along;
}

template<class M>
SceneMaterial reduced(const M& material, std::vector<std::string>& losses) {
    SceneMaterial made;
    if constexpr (std::is_same_v<M, GltfMaterial>) made.gltf = material;
    const auto core = core_material(material);
    const auto matte = shading::diffuse_alone(core);
    if constexpr (std::is_same_v<decltype(matte), const shading::Lambert<double>>) {
        made.diffuse = color(matte.albedo);
    } else {
        made.diffuse = mean_albedo(core);
        if (is_rough(core))
            losses.emplace_back(
                made.gltf ? "its diffuse part, which its lobe dims, is written as Lambert's of the same albedo"
                          : "its rough diffuse part is written as Lambert with the same albedo");
    }
    constexpr shading::LobeKind lobe = decltype(core)::lobe;
    if constexpr (lobe != shading::LobeKind::none) take_lobe(core, made, losses);
    switch (lobe) {
    case shading::LobeKind::none:
    case shading::LobeKind::ggx:
        break;
    case shading::LobeKind::anisotropic_ggx:
        if constexpr (lobe == shading::LobeKind::anisotropic_ggx)
            made.is_anisotropic = made.has_lobe() && core.alphas.x != core.alphas.y;
        break;
    case shading::LobeKind::ggx_and_more:
        losses.emplace_back("multiple scattering between its facets is left out");
        break;
    case shading::LobeKind::cosine_power:
        if (made.has_lobe()) losses.emplace_back("its cosine lobe is written as a GGX lobe of the same width");
        break;
    }
    return made;
}

} // namespace

SceneMaterial scene_material(const Material& material, std::vector<std::string>& losses) {
    SceneMaterial made = std::visit([&](const auto& kind) { return reduced(kind, losses); }, base_of(material));
    if (const auto* coated = std::get_if<CoatedMaterial>(&material)) made.coat = coated->coat;
    return made;
}

MixedMaterial mixed(const SceneMaterial& material) {
    const double least = std::min({material.f0.x, material.f0.y, material.f0.z});
    const double most = std::max({material.f0.x, material.f0.y, material.f0.z});
    if (!material.has_diffuse()) return {1.0, material.f0, {}, 0.0};
    if (most - least <= 1e-9) return {0.0, {}, material.diffuse, most};
    // As little metal as possible, so its greatest channel is 1; the dielectric takes what all channels share.
    MixedMaterial made;
    made.f0 = std::min(least, 0.04);
    made.metal = (most - made.f0) / (1.0 - made.f0);
    made.metal_f0 = (material.f0 - (1.0 - made.metal) * glm::dvec3(made.f0)) / made.metal;
    made.diffuse = material.diffuse / (1.0 - made.metal);
    return made;
}

double refractive_index(double f0) {
    const double root = std::sqrt(f0);
    return (1.0 + root) / (1.0 - root);
}

Frame frame_of(const Ball& ball) {
    Frame frame;
    frame.origin = ball.center;
    return frame;
}

Frame frame_of(const Capsule& capsule) {
    return aimed_frame(capsule.center, -capsule.axis, {0.0, 1.0, 0.0});
}

std::string unique_name(std::string_view name, TakenNames& taken) {
    std::string plain;
    for (const char c : name)
        plain += (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ? c : '_';
    if (plain.empty()) plain = "light";
    std::string free = plain;
    int& number = taken.last_number[plain];
    while (!taken.names.insert(free).second) {
        number = std::max(number + 1, 2);
        free = plain + "_" + std::to_string(number);
    }
    return free;
}

} // namespace gonio::asset_detail
