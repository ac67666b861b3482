#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/directional_albedo.hpp>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>

namespace gonio {

namespace {

using Vec = shading::vec3<double>;

} // namespace

DirectionalAlbedo::DirectionalAlbedo(const CoreMaterial& material, Fineness fineness) {
    if (const auto* lambert = std::get_if<shading::Lambert<double>>(&material)) {
        albedo_.emplace_back(lambert->albedo.x, lambert->albedo.y, lambert->albedo.z);
        return;
    }
    const int nodes = fineness == Fineness::fine ? 48 : 16;
    const int per_view = fineness == Fineness::fine ? 1024 : 256;
    // The lattice of the three-dimensional golden ratio (M. Roberts, 2018).
    constexpr double g = 1.2207440846057596;
    const auto fraction = [](double x) { return x - std::floor(x); };
    std::visit(
        [&](const auto& core) {
            const bool turns = is_anisotropic(material);
            const int directions = turns ? 4 * per_view : per_view;
            for (int node = 0; node < nodes; ++node) {
                const double root = std::max(node / (nodes - 1.0), 1e-3);
                const double cosine = root * root;
                const Vec n{0.0, 0.0, 1.0};
                const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
                Vec v{sine, 0.0, cosine};
                glm::dvec3 sum(0.0);
                for (int i = 0; i < directions; ++i) {
                    if (turns) {
                        const double azimuth = 2.0 * std::numbers::pi * (i + 0.5) / directions;
                        v = {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
                    }
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

glm::dvec3 DirectionalAlbedo::operator()(double cosine) const {
    if (albedo_.size() == 1) return albedo_.front();
    const double at = std::sqrt(std::clamp(cosine, 0.0, 1.0)) * static_cast<double>(albedo_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), albedo_.size() - 2);
    const double share = at - static_cast<double>(i);
    return (1.0 - share) * albedo_[i] + share * albedo_[i + 1];
}

glm::dvec3 DirectionalAlbedo::over_hemisphere() const {
    if (albedo_.size() == 1) return albedo_.front();
    // With µ = √s it is the mean of A over s.
    constexpr int steps = 32;
    glm::dvec3 sum(0.0);
    for (int i = 0; i < steps; ++i)
        sum += (*this)(std::sqrt((i + 0.5) / steps));
    return glm::clamp(sum / static_cast<double>(steps), 0.0, 1.0);
}

} // namespace gonio
