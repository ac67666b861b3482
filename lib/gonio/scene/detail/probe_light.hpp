// One light and one receiver of the probe, in double.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/probe.hpp>

#include <cstdint>

namespace gonio::detail {

enum class ProbeRemark : std::uint8_t {
    none,
    at_light, // the receiver lies on a punctual light, which has no direction from there
    inside    // the receiver lies inside a sphere or tube
};

// A share of the illuminance, of any colour.
struct ProbeShare {
    double illuminance_lx = 0.0; // in [0, shading::illuminance_ceiling]
    ProbeRemark remark = ProbeRemark::none;
};

// `normal` is unit.
ProbeShare illuminance_of(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                          IrradianceMethod method);

// A material as the shading core takes it, and the view to it.
struct ProbeSurface {
    Material material;
    glm::dvec3 view; // unit
};

// Luminance by the exact method; `share` is the illuminance that it gives.
ProbeLuminance luminance_of(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                            const ProbeSurface& surface, const ProbeShare& share);

// Whether the specular part of luminance_of() is an approximation.
bool coarse_specular(const Shape& shape, const Material& material);

} // namespace gonio::detail
