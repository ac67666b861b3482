#include <gonio/light/luminaire.hpp>
#include <gonio/light/luminances.hpp>
#include <gonio/light/shape.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gonio {

void projected_areas(const LuminousBody& body, std::span<const double> x, std::span<const double> y,
                     std::span<const double> z, std::span<const double> length, std::span<double> to) {
    std::fill(to.begin(), to.end(), 0.0);
    for (const LuminousFace& face : body.faces()) {
        const double area_m2 = face.area_m2;
        const glm::dvec3 normal = face.normal;
        if (face.is_flat)
            for (std::size_t i = 0; i < to.size(); ++i)
                to[i] += area_m2 * std::max(normal.x * x[i] + normal.y * y[i] + normal.z * z[i], 0.0);
        else
            for (std::size_t i = 0; i < to.size(); ++i)
                to[i] += 0.25 * area_m2 * length[i];
    }
}

const Web* luminance_web(const Light& light) {
    return light.emission != nullptr ? light.emission->web.get() : mask_of(light.shape).web;
}

const Frame& luminance_frame(const Light& light) {
    return light.emission != nullptr ? light.emission->luminaire : light.frame;
}

LuminanceShares::LuminanceShares(const Light& light)
    : body_(light.emission != nullptr ? light.emission->body.get() : nullptr),
      scale_(light.web_scale),
      frame_(luminance_frame(light)),
      web_(*luminance_web(light)) {}

void LuminanceShares::along(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                            std::span<double> to) {
    web_.candela(x, y, z, to);
    if (body_ == nullptr) {
        for (double& share : to)
            share = std::fmax(scale_ * share, 0.0);
        return;
    }
    length_.assign(to.size(), 1.0);
    projected_m2_.resize(to.size());
    projected_areas(*body_, x, y, z, length_, projected_m2_);
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = projected_m2_[i] > 0.0 ? std::fmax(scale_ * to[i] / projected_m2_[i], 0.0) : 0.0;
}

} // namespace gonio
