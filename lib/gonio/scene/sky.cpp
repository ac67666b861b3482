#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/detail/touching.hpp>
#include <gonio/scene/sky.hpp>
#include <gonio/shading/irradiance_rectangle.hpp>
#include <gonio/shading/occlusion.hpp>
#include <gonio/sky/sky_description.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace gonio {

namespace {

using detail::vec;
using Vec = shading::vec3<double>;

// The share of a sky that a primitive covers.
struct CoveredSky {
    const glm::dvec3& point;
    const glm::dvec3& normal;

    double operator()(const Plane& plane) const {
        const double height = glm::dot(point - plane.point, plane.normal);
        if (std::abs(height) <= detail::touching(point)) return 0.0;
        // The half space of directions towards the plane, above the receiver's horizon.
        return 0.5 * (1.0 - std::copysign(1.0, height) * glm::dot(normal, plane.normal));
    }
    double operator()(const Panel& panel) const {
        if (std::abs(glm::dot(point - panel.frame.origin, panel.frame.z)) <= detail::touching(point)) return 0.0;
        return std::numbers::inv_pi * shading::irradiance_rectangle(vec(panel.frame.origin - point), vec(panel.frame.z),
                                                                    vec(panel.frame.x), panel.width, panel.height,
                                                                    vec(normal), true);
    }
    double operator()(const Ball& ball) const {
        return 1.0 - shading::sky_visibility_sphere(vec(ball.center - point), ball.radius, vec(normal));
    }
    double operator()(const Capsule& capsule) const {
        return 1.0 - shading::sky_visibility_tube(vec(capsule.center - point), vec(capsule.axis), capsule.radius,
                                                  2.0 * capsule.half_length, vec(normal));
    }
    double operator()(const Box& box) const {
        double covered = 0.0;
        for (int i = 0; i < 6; ++i) {
            const Panel side = face(box, i);
            if (glm::dot(point - side.frame.origin, side.frame.z) > 0.0) covered += (*this)(side);
        }
        return covered;
    }
};

} // namespace

Result<Nits> parse_sky(std::string_view text) {
    return parse_uniform_sky(text);
}

double sky_share(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& normal) {
    double share = 1.0;
    double panels = 0.0;
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
        if (i == own) continue;
        const Primitive& primitive = stage.surfaces[i].geometry;
        const double covered = std::clamp(std::visit(CoveredSky{point, normal}, primitive), 0.0, 1.0);
        if (std::holds_alternative<Panel>(primitive))
            panels += covered;
        else
            share *= 1.0 - covered;
    }
    return share * std::max(1.0 - panels, 0.0);
}

SkyAlbedo::SkyAlbedo(const CoreMaterial& material, Fineness fineness) {
    if (const auto* lambert = std::get_if<shading::Lambert<double>>(&material)) {
        albedo_.emplace_back(lambert->albedo.x, lambert->albedo.y, lambert->albedo.z);
        return;
    }
    const int nodes = fineness == Fineness::fine ? 48 : 16;
    const int directions = fineness == Fineness::fine ? 1024 : 256;
    // The lattice of the three-dimensional golden ratio (M. Roberts, 2018).
    constexpr double g = 1.2207440846057596;
    const auto fraction = [](double x) { return x - std::floor(x); };
    std::visit(
        [&](const auto& core) {
            for (int node = 0; node < nodes; ++node) {
                const double root = std::max(node / (nodes - 1.0), 1e-3);
                const double cosine = root * root;
                const Vec n{0.0, 0.0, 1.0};
                const Vec v{std::sqrt((1.0 - cosine) * (1.0 + cosine)), 0.0, cosine};
                glm::dvec3 sum(0.0);
                for (int i = 0; i < directions; ++i) {
                    const auto sample = shading::sample_brdf(
                        core, n, v,
                        {fraction(0.5 + i / g), fraction(0.5 + i / (g * g)), fraction(0.5 + i / (g * g * g))});
                    if (!(sample.pdf > 0.0) || !(sample.l.z > 0.0)) continue;
                    const Vec f = shading::brdf(core, n, sample.l, v) * (sample.l.z / sample.pdf);
                    sum += glm::dvec3(f.x, f.y, f.z);
                }
                albedo_.push_back(sum / static_cast<double>(directions));
            }
        },
        material);
}

glm::dvec3 SkyAlbedo::operator()(double cosine) const {
    if (albedo_.size() == 1) return albedo_.front();
    const double at = std::sqrt(std::clamp(cosine, 0.0, 1.0)) * static_cast<double>(albedo_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), albedo_.size() - 2);
    const double share = at - static_cast<double>(i);
    return (1.0 - share) * albedo_[i] + share * albedo_[i + 1];
}

} // namespace gonio
