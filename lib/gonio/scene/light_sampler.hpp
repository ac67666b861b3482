// Directions towards an area light of any shape, and the light from them.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/shading/sample_cylinder.hpp>
#include <gonio/shading/sample_disk.hpp>
#include <gonio/shading/sample_tube.hpp>

#include <glm/vec3.hpp>

#include <variant>

namespace gonio::detail {

struct LightDirection {
    double luminance_nt = 0.0; // towards the receiver; includes mask or pattern and range
    double distance = 0.0;     // to the light's surface [m], infinite to the sun
};

class LightSampler {
public:
    // The light must be an area light or a sun and must outlive this object.
    LightSampler(const Light& light, const glm::dvec3& receiver);

    // For two numbers in [0, 1): a direction in which the light is visible, and its density [1/sr]; 0 on its dark side.
    shading::LightSample<double> sample(double u0, double u1) const;
    double pdf(shading::vec3<double> direction) const;

    // In a direction that sample() returned or for which the density is above 0.
    LightDirection at(const glm::dvec3& direction) const;

private:
    using Sampler =
        std::variant<shading::SphereSampler<double>, shading::DiskSampler<double>, shading::RectangleSampler<double>,
                     shading::TubeSampler<double>, shading::CylinderSampler<double>>;

    struct Seen {
        Sampler sampler;
        bool shines; // the receiver is not on the dark side
    };

    static Seen seen_from(const Light& light, const glm::dvec3& to_center);

    const Light& light_;
    glm::dvec3 receiver_;
    double luminance_nt_ = 0.0; // Light::luminance in range, 0 on the dark side
    Seen seen_;
};

} // namespace gonio::detail
