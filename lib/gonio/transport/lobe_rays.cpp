#include <gonio/scene/core_vector.hpp>
#include <gonio/transport/lobe_rays.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <variant>

namespace gonio::detail {

namespace {

using Vec = shading::vec3<double>;

constexpr std::size_t nodes = 24; // over the cosine of the view
constexpr double widest = 1.0;    // [rad]
constexpr std::size_t many = 512; // samples of the albedo

double fraction_of(std::size_t i, double step) {
    const double x = 0.5 + static_cast<double>(i) * step;
    return x - std::floor(x);
}

// Point i of `count` in the unit square. Eight are a lattice of Fibonacci numbers, which is the most even one; other
// numbers use that of the two-dimensional golden ratio (M. Roberts, 2018).
std::pair<double, double> point_of(std::size_t i, std::size_t count) {
    constexpr double g = 1.3247179572447460;
    if (count == 8) return {(static_cast<double>(i) + 0.5) / 8.0, fraction_of(i, 5.0 / 8.0)};
    return {fraction_of(i, 1.0 / g), fraction_of(i, 1.0 / (g * g))};
}

constexpr double least_of_metal = 0.15; // of what a lobe reflects at normal incidence

bool is_of_metal(const glm::dvec3& reflectance) {
    return std::max({reflectance.x, reflectance.y, reflectance.z}) > least_of_metal;
}

// More for wide lobes, which see more of the stage, and for metals, which show little else.
std::size_t rays_for(double alpha, bool is_metal, std::size_t more) {
    std::size_t rays = alpha <= 0.003 ? 1 : alpha <= 0.02 ? 4 : 8;
    if (is_metal) rays *= alpha > 0.02 ? 4 : 2;
    if (alpha > 0.003) rays *= more;
    // Where more are needed, dark and bright meet inside wide lobes, and a metal has no diffuse part to hide it.
    if (is_metal && alpha > 0.02 && more > 1) rays *= 3;
    return rays;
}

struct Sampled {
    std::vector<LobeRay> facets; // `direction` is the facet's normal
    glm::dvec3 sum{0.0};
};

Vec turned(const Vec& v, double cosine, double sine) {
    return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
}

// A view at an azimuth from the tangent; `direction` of the facets is in the frame of the view, which leans to x.
template<class Value>
Sampled sampled(const Value& value, const LobeFacets& facets, double cosine, double azimuth, std::size_t count) {
    const Vec n{0.0, 0.0, 1.0};
    const Vec in_own{std::sqrt((1.0 - cosine) * (1.0 + cosine)), 0.0, cosine};
    const double c = std::cos(azimuth);
    const double s = std::sin(azimuth);
    const bool is_even = !facets.grain;
    const Vec v = is_even ? in_own : turned(in_own, c, s); // from the tangent
    Sampled result;
    for (std::size_t i = 0; i < count; ++i) {
        const auto [u0, u1] = point_of(i, count);
        const Vec h = is_even ? shading::visible_normal_ggx(v, facets.alphas.x, u0, u1)
                              : shading::visible_normal_ggx(v, facets.alphas, u0, u1);
        const Vec l = shading::normalized(h * (2.0 * dot(v, h)) - v);
        LobeRay facet;
        facet.direction = glm::vec3(vec(is_even ? h : turned(h, c, -s)));
        const double pdf = is_even ? shading::pdf_reflected_ggx(n, v, l, facets.alphas.x)
                                   : shading::pdf_reflected_ggx(shading::FacetPose<double>(l, v), facets.alphas);
        facet.width =
            static_cast<float>(std::min(std::sqrt(1.0 / (std::max(pdf, 1e-3) * static_cast<double>(count))), widest));
        if (l.z > 0.0 && pdf > 0.0) {
            // The tangent of this normal is turned from x.
            const auto in_scene = [&](const Vec& way) {
                return is_even ? way : turned(way, facets.grain->cosine, facets.grain->sine);
            };
            const glm::dvec3 weight =
                l.z / (pdf * static_cast<double>(count)) * vec(value(n, in_scene(l), in_scene(v)));
            facet.weight = glm::vec3(weight);
            result.sum += weight;
        }
        result.facets.push_back(facet);
    }
    return result;
}

double cosine_of(std::size_t node) {
    const double root = std::max(static_cast<double>(node) / (nodes - 1.0), 1e-3);
    return root * root;
}

struct Place {
    std::size_t node;
    double share; // of the next
};

Place place_of(double cosine) {
    const double at = std::sqrt(std::clamp(cosine, 0.0, 1.0)) * (nodes - 1.0);
    const auto node = std::min(static_cast<std::size_t>(at), nodes - 2);
    return {node, at - static_cast<double>(node)};
}

template<class Core>
LobeFacets facets_of(const Core& core) {
    if constexpr (Core::lobe == shading::LobeKind::anisotropic_ggx) {
        const auto lobe = shading::gloss(core).lobe;
        return {lobe.alphas, lobe.grain};
    } else {
        const double alpha = shading::lobe_alpha(core);
        return {{alpha, alpha}, {}};
    }
}

// Calls `lobe(facets, value)` for each glossy one.
template<class Lobe>
void for_each_lobe(const CoreMaterial& material, const Lobe& lobe) {
    std::visit(
        [&]<class Core>(const Core& core) {
            if constexpr (std::is_same_v<Core, shading::Coated>) {
                const double alpha = shading::coat_alpha(core.coat);
                lobe(LobeFacets{{alpha, alpha}, {}},
                     [&](const Vec& n, const Vec& l, const Vec& v) { return shading::coat_part(core, n, l, v); });
                lobe(std::visit([](const auto& base) { return facets_of(base); }, core.base),
                     [&](const Vec& n, const Vec& l, const Vec& v) {
                         return shading::base_specular_part(core, n, l, v);
                     });
            } else if constexpr (Core::lobe != shading::LobeKind::none) {
                lobe(facets_of(core), [&](const Vec& n, const Vec& l, const Vec& v) {
                    return shading::specular_part(core, n, l, v, 0.0);
                });
            }
        },
        material);
}

constexpr std::size_t most_azimuths = 16;

std::size_t azimuths_of(bool has_grain) {
    return has_grain ? most_azimuths : 1;
}

} // namespace

template<class Value>
LobeRays::LobeRays(const LobeFacets& facets, const Value& value, std::size_t more)
    : grain_(facets.grain), alpha_(facets.alphas.mean()) {
    const glm::dvec3 reflectance = sampled(value, facets, 1.0, 0.0, many).sum;
    const double most = std::max({reflectance.x, reflectance.y, reflectance.z});
    if (!(sampled(value, facets, 0.1, 0.0, many).sum.x > 0.0) && !(most > 0.0)) return;
    is_metal_ = is_of_metal(reflectance);
    rays_ = rays_for(std::max(facets.alphas.x, facets.alphas.y), is_metal_, more);
    const std::size_t azimuths = azimuths_of(grain_.has_value());
    albedo_.assign(nodes, glm::dvec3(0.0));
    for (std::size_t turn = 0; turn < azimuths; ++turn) {
        const double azimuth = std::numbers::pi * static_cast<double>(turn) / static_cast<double>(azimuths);
        for (std::size_t node = 0; node < nodes; ++node) {
            const glm::dvec3 albedo = sampled(value, facets, cosine_of(node), azimuth, many).sum;
            Sampled few = sampled(value, facets, cosine_of(node), azimuth, rays_);
            for (LobeRay& facet : few.facets)
                for (int channel = 0; channel < 3; ++channel)
                    if (few.sum[channel] > 0.0)
                        facet.weight[channel] *= static_cast<float>(albedo[channel] / few.sum[channel]);
            table_.insert(table_.end(), few.facets.begin(), few.facets.end());
            albedo_[node] += albedo / static_cast<double>(azimuths);
        }
    }
}

std::vector<LobeRays> lobe_rays(const CoreMaterial& material, std::size_t more) {
    std::vector<LobeRays> lobes;
    for_each_lobe(material, [&](const LobeFacets& facets, const auto& value) {
        LobeRays lobe(facets, value, more);
        if (!lobe.empty()) lobes.push_back(std::move(lobe));
    });
    return lobes;
}

bool has_metal_lobe(const CoreMaterial& material) {
    bool found = false;
    for_each_lobe(material, [&](const LobeFacets& facets, const auto& value) {
        found = found || is_of_metal(sampled(value, facets, 1.0, 0.0, many).sum);
    });
    return found;
}

LobeRays::View LobeRays::view(double cosine, const glm::dvec3& normal, const glm::dvec3& aside) const {
    const Place place = place_of(cosine);
    const auto z = static_cast<float>(std::clamp(cosine, 0.0, 1.0));
    View view;
    view.first = view.beside = place.node * rays_;
    view.share = static_cast<float>(place.share);
    view.direction = {std::sqrt((1.0F - z) * (1.0F + z)), 0.0F, z};
    if (grain_) {
        const shading::TangentFrame<double> frame = grain_->frame(vec(normal));
        const Vec leaning = frame.to_local(vec(aside));
        const double turns = std::atan2(leaning.y, leaning.x) / std::numbers::pi;
        const double at = (turns - std::floor(turns)) * static_cast<double>(most_azimuths);
        const auto turn = std::min(static_cast<std::size_t>(at), most_azimuths - 1);
        view.beside += (turn + 1) % most_azimuths * nodes * rays_;
        view.first += turn * nodes * rays_;
        view.share_beside = static_cast<float>(at - static_cast<double>(turn));
    }
    return view;
}

namespace {

LobeRay blend(const LobeRay& a, const LobeRay& b, float share) {
    return {(1.0F - share) * a.direction + share * b.direction, (1.0F - share) * a.weight + share * b.weight,
            (1.0F - share) * a.width + share * b.width};
}

} // namespace

LobeRay LobeRays::between(std::size_t first, float share, std::size_t index) const {
    return blend(table_[first + index], table_[first + rays_ + index], share);
}

LobeRay LobeRays::ray(const View& view, std::size_t index) const {
    LobeRay ray = between(view.first, view.share, index); // with the facet's normal
    if (grain_) ray = blend(ray, between(view.beside, view.share, index), view.share_beside);
    const glm::vec3 facet = ray.direction;
    ray.direction = 2.0F * glm::dot(view.direction, facet) / glm::dot(facet, facet) * facet - view.direction;
    if (!(ray.direction.z > 0.0F)) ray.weight = glm::vec3(0.0F);
    return ray;
}

glm::dvec3 LobeRays::albedo(double cosine) const {
    if (empty()) return glm::dvec3(0.0);
    const Place place = place_of(cosine);
    return (1.0 - place.share) * albedo_[place.node] + place.share * albedo_[place.node + 1];
}

glm::dvec3 LobeRays::albedo() const {
    glm::dvec3 sum(0.0);
    constexpr int steps = 64; // over the squares of cosines, in which the hemisphere is even
    for (int i = 0; i < steps; ++i)
        sum += albedo(std::sqrt((i + 0.5) / steps));
    return sum / static_cast<double>(steps);
}

} // namespace gonio::detail
