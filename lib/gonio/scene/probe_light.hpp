// One light and one receiver of the probe, in double.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/shading/specular_method.hpp>

#include <cstdint>

namespace gonio::detail {

enum class ProbeRemark : std::uint8_t {
    none,
    at_light, // the receiver lies on a punctual light, so there is no direction
    inside    // the receiver lies inside a sphere or tube
};

// How to compute it: a method and, for `reference`, its goal.
struct ProbeWay {
    IrradianceMethod method = IrradianceMethod::exact;
    ReferenceGoal goal;
};

// Whether these methods take a profile as a point though it has an opening.
bool takes_points(IrradianceMethod method);

// Whether the light is the sum of its parts by that method.
bool consists_of_parts(const Light& light, IrradianceMethod method);

// Whether the light or one of its parts is integrated: there is no closed form for a luminance that depends on the
// direction.
bool is_integrated(const Light& light, IrradianceMethod method);

// A share of the illuminance, of any colour.
struct ProbeShare {
    double illuminance_lx = 0.0; // in [0, shading::illuminance_ceiling]
    double error_lx = 0.0;       // as estimated by `reference`
    ProbeRemark remark = ProbeRemark::none;
    bool converged = true;
};

// `normal` is unit.
ProbeShare illuminance_of(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                          const ProbeWay& way);

// The luminance of an area light towards the receiver over its mean, as if all of it were in its centre: the
// approximation of engines.
double share_from_center(const Light& light, const glm::dvec3& position);

// A material in the form that the shading core uses, and the view of it.
struct ProbeSurface {
    const Material& material;
    glm::dvec3 view; // unit
};

struct ProbeShine {
    ProbeLuminance luminance;
    bool converged = true;
};

// `share` is the illuminance that the light gives in the same way.
ProbeShine luminance_of(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                        const ProbeSurface& surface, const ProbeShare& share, const ProbeWay& way);

// The methods named after their treatment of the lobe: ltc and the methods after it that share its illuminance.
bool is_specular_method(IrradianceMethod method);

// The treatment of the lobe by any method: one of these, or what goes with an irradiance.
shading::SpecularMethod specular_method(IrradianceMethod method);

// Whether these methods support the material's lobe: GGX alone, or none.
bool has_named_lobe(const Material& material);

struct NamedLuminance {
    double diffuse_nt = 0.0;
    double specular_nt = 0.0;
};

// By one of these methods, under an area light. Diffuse parts use the exact irradiance towards one direction; with ltc,
// Frostbite's uses a separate transformed cosine. The view is above the surface.
NamedLuminance named_luminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                               const ProbeSurface& surface, IrradianceMethod method);

// Whether luminance_of() supports the material by this method.
bool has_luminance(const Material& material, IrradianceMethod method);

} // namespace gonio::detail
