// Probe: the illuminance that lights give to points, and the luminance that a material makes of it, in double.
//
// Everything that a light is leaves its exact closed form here (shading/), and what has none its quadrature
// (reference.hpp), unless another method is asked for. Lights do not occlude each other and nothing else does. Results
// are finite and not negative: what would exceed shading::illuminance_ceiling (1e30 lx) ends there, and is told.
// Sums run over fixed blocks of lights, so they are the same at any number of threads.
// Cost on one core of a 2.5 GHz Xeon: 20 ns (point) to 400 ns (disk on the horizon) a light and point; luminance under
// lights with a size 0.1 to 1 ms.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/reference.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace gonio {

// How the irradiance of a light is computed, and what a surface makes of it. Punctual lights: I⟨n·l⟩/d² with the
// distance guard of the method; a sun: E⟨n·l⟩ by the last three.
enum class IrradianceMethod {
    exact,                // closed forms with horizon clipping, no guard; luminance by quadrature to 1e-6
    reference,            // everything by quadrature to ProbeOptions::goal, with its error estimate
    ltc,                  // illuminance as `exact`; lobes under lights with a size by linearly transformed cosines
    representative_point, // the same, lobes by one direction: shading/specular_named.hpp says how
    dominant_direction,
    specular_d,
    spherical_hack,
    sun_disk,
    frostbite, // Lagarde and de Rousiers 2014, d² guarded as max(d², 1 cm²)
    ue4,       // Karis 2013, d² + 1 cm²; shapes it has not: as `point`
    point      // every light as a point with the intensity that it sends to the receiver
};

struct IrradianceMethodName {
    IrradianceMethod method;
    std::string_view name;
    std::string_view summary;
};

std::span<const IrradianceMethodName> irradiance_methods();

std::string_view to_text(IrradianceMethod method);

// Fails (usage) on any other name than those of irradiance_methods().
Result<IrradianceMethod> parse_irradiance_method(std::string_view name);

struct Receiver {
    glm::dvec3 position{0.0, 0.0, 0.0}; // [m], components up to 1e100
    glm::dvec3 normal{0.0, 0.0, 1.0};   // any length > 0
};

struct ProbeView {
    glm::dvec3 direction{0.0, 0.0, 1.0}; // from the point to the eye, any length > 0
    Material material;
    std::optional<glm::dvec3> eye = {}; // [m] the eye's place, in the direction's stead
};

struct ProbeOptions {
    IrradianceMethod method = IrradianceMethod::exact;
    ReferenceGoal goal;            // of `reference`, for each light's share by itself
    std::optional<ProbeView> view; // asks for luminance
    bool parts = false;            // asks for the share of each light
    unsigned threads = 0;          // 0 = as many as there are
};

// Luminance of the surface, as Y of its colour.
struct ProbeLuminance {
    Nits diffuse;
    Nits specular;
    Nits error_estimate; // of both, by quadrature; 0 else

    Nits total() const { return diffuse + specular; }
};

// Something about pairs of a receiver and a light: how many, and the first in the order of receivers.
struct ProbeOccurrence {
    std::size_t count = 0;
    std::size_t receiver = 0;
    std::size_t light = 0;

    // `others` counts its receivers from `offset`.
    void add(const ProbeOccurrence& others, std::size_t offset = 0);
};

struct ProbeRemarks {
    ProbeOccurrence on_light;      // the receiver lies on a light without size, which has no direction from there: 0
    ProbeOccurrence inside;        // the receiver lies inside a sphere or tube: E = π L
    ProbeOccurrence unseen;        // the view is not above the surface: the luminance is 0; counted once a receiver
    ProbeOccurrence at_ceiling;    // what would exceed shading::illuminance_ceiling, which ends there
    ProbeOccurrence not_converged; // the quadrature ended before the error that was asked for

    void add(const ProbeRemarks& others, std::size_t offset = 0);
};

struct ProbeResult {
    std::vector<double> illuminance_lx;       // one a receiver
    std::vector<double> illuminance_error_lx; // its estimate by `reference`; empty by other methods
    std::vector<double> parts_lx;             // [receiver][light]; empty unless asked for
    std::vector<ProbeLuminance> luminance;    // one a receiver; empty unless asked for
    std::vector<ProbeLuminance> parts_nt;     // [receiver][light]; empty unless both are asked for
    ProbeRemarks remarks;
};

// Luminance: Lambert by any method (E·albedo/π), other materials by `exact` and `reference`; those whose lobe is GGX
// alone or that have none (Frostbite, UE4, GGX, EON) also by `ltc` and the methods after it that share its illuminance.
// Fails: usage on a normal or view that is zero or not finite (an eye on a point too), on a position out of range and
// on a light whose luminance or intensity is not finite, unsupported on the luminance of a material by a method that
// has it not.
Result<ProbeResult> probe(std::span<const Light> lights, std::span<const Receiver> receivers,
                          const ProbeOptions& options = {});

// Warnings for receivers on a light, for values at the ceiling and for errors that were not reached, notes for
// receivers inside a light and for views from below the surface; points count from 1.
Diagnostics to_diagnostics(const ProbeRemarks& remarks, std::span<const Light> lights);

// The least, mean and greatest of values; all 0 for none.
struct Spread {
    double least = 0.0;
    double mean = 0.0;
    double greatest = 0.0;

    // least/mean and least/greatest, the uniformities U0 and Ud of lighting practice; 0 in the dark.
    double uniformity() const { return mean > 0.0 ? least / mean : 0.0; }
    double diversity() const { return greatest > 0.0 ? least / greatest : 0.0; }
};

Spread spread(std::span<const double> values);

// Of any vector whose length is greater than 0 and finite components, without overflow; nothing of others.
std::optional<glm::dvec3> unit_vector(const glm::dvec3& vector);

} // namespace gonio
