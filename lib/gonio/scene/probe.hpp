// Probe: the illuminance of lights at points, and the resulting luminance of a material, in double.
//
// Each light uses its exact closed form (shading/), or quadrature if there is none (reference.hpp), unless another
// method is selected. Lights do not occlude each other and there are no other occluders. Results are finite and not
// negative: values above shading::illuminance_ceiling (1e30 lx) are limited to it, and this is reported. Sums run over
// fixed blocks of lights, so they are the same for any number of threads. Cost on one core of a 2.5 GHz Xeon: 20 ns
// (point) to 400 ns (disk on the horizon) per light and point; luminance under area lights 0.1 to 1 ms.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/reference.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// How the irradiance of a light and the resulting luminance of a surface are computed. Punctual lights: I⟨n·l⟩/d² with
// the distance guard of the method; a sun: E⟨n·l⟩ by the last three.
enum class IrradianceMethod {
    exact,                // closed forms with horizon clipping, no guard; luminance by quadrature to 1e-6
    reference,            // everything by quadrature to ProbeOptions::goal, with its error estimate
    ltc,                  // illuminance as `exact`; lobes under area lights as specular_ltc.hpp has them
    representative_point, // the same, lobes by one direction: see shading/specular_named.hpp
    dominant_direction,
    specular_d,
    spherical_hack,
    sun_disk,
    frostbite, // Lagarde and de Rousiers 2014, d² guarded as max(d², 1 cm²)
    ue4,       // Karis 2013, d² + 1 cm²; shapes it does not define: as `point`
    point      // every light as a point with the intensity that it emits towards the receiver
};

// A method by its name in text.
struct IrradianceMethodName {
    IrradianceMethod method;
    std::string_view name;
    std::string_view summary;
};

// All of them.
std::span<const IrradianceMethodName> irradiance_methods();

// Its name in text.
std::string_view to_text(IrradianceMethod method);

// Fails (usage) on any name other than those of irradiance_methods().
Result<IrradianceMethod> parse_irradiance_method(std::string_view name);

// A point with the direction in which its surface faces.
struct Receiver {
    glm::dvec3 position{0.0, 0.0, 0.0}; // [m], components up to 1e100
    glm::dvec3 normal{0.0, 0.0, 1.0};   // any length > 0
};

// What looks at the receivers, and what they are made of.
struct ProbeView {
    glm::dvec3 direction{0.0, 0.0, 1.0}; // from the point to the eye, any length > 0
    Material material;
    std::optional<glm::dvec3> eye = {}; // [m] position of the eye, instead of the direction
};

// How probe() computes.
struct ProbeOptions {
    IrradianceMethod method = IrradianceMethod::exact;
    ReferenceGoal goal;            // for `reference`, for each light's share separately
    std::optional<ProbeView> view; // requests luminance
    bool parts = false;            // requests the share of each light
    unsigned threads = 0;          // 0 = all hardware threads
};

// Luminance of the surface, as the Y of its colour.
struct ProbeLuminance {
    Nits diffuse;
    Nits specular;
    Nits error_estimate; // of both, by quadrature; otherwise 0

    Nits total() const { return diffuse + specular; }
};

// A condition that holds for pairs of a receiver and a light: how often, and the first pair in the order of receivers.
struct ProbeOccurrence {
    std::size_t count = 0;
    std::size_t receiver = 0;
    std::size_t light = 0;

    // The receivers of `others` are numbered from `offset`.
    void add(const ProbeOccurrence& others, std::size_t offset = 0);
};

// What a caller should report about the values.
struct ProbeRemarks {
    ProbeOccurrence on_light;      // the receiver lies on a light without size, so there is no direction: 0
    ProbeOccurrence inside;        // the receiver lies inside a sphere or tube: E = π L
    ProbeOccurrence unseen;        // the view is not above the surface: the luminance is 0; counted once per receiver
    ProbeOccurrence near_point;    // the receiver is nearer to a profile without size than five times its opening
    ProbeOccurrence at_ceiling;    // the value would exceed shading::illuminance_ceiling and is limited to it
    ProbeOccurrence not_converged; // the quadrature ended before the requested error was reached

    void add(const ProbeRemarks& others, std::size_t offset = 0);
};

// The values at one receiver.
struct ProbeResult {
    std::vector<double> illuminance_lx;       // one per receiver
    std::vector<double> illuminance_error_lx; // its estimate by `reference`; empty for other methods
    std::vector<double> parts_lx;             // [receiver][light]; empty unless requested
    std::vector<ProbeLuminance> luminance;    // one per receiver; empty unless requested
    std::vector<ProbeLuminance> parts_nt;     // [receiver][light]; empty unless both are requested
    ProbeRemarks remarks;
};

// Luminance: Lambert by any method (E·albedo/π), other materials by `exact` and `reference`. Materials with GGX as the
// only lobe or without a lobe (Frostbite, UE4, GGX, EON) also by `ltc` and the methods after it that share its
// illuminance. Fails: usage on a normal or view that is zero or not finite (also an eye on a point), on a position out
// of range and on a light with a luminance or intensity that is not finite; unsupported on the luminance of a material
// by a method that does not support it.
Result<ProbeResult> probe(std::span<const Light> lights, std::span<const Receiver> receivers,
                          const ProbeOptions& options = {});

// probe() of lights that come a part at a time, and are not kept: the same values to the last bit.
class ProbeSum {
public:
    // Without parts. Fails as probe() does on receivers and options.
    static Result<ProbeSum> of(std::span<const Receiver> receivers, const ProbeOptions& options = {});

    // The next lights, any number of them. Fails as probe() does on lights; what was added before still counts.
    Result<void> add(std::span<const Light> lights);

    std::size_t lights() const; // how many were added

    // Of all lights so far. The remarks count lights among those that they remark upon: remarked().
    ProbeResult result() const;
    std::vector<Light> remarked() const;

    ProbeSum(ProbeSum&& other) noexcept;
    ProbeSum& operator=(ProbeSum&& other) noexcept;
    ~ProbeSum();

private:
    friend Result<ProbeResult> probe(std::span<const Light> lights, std::span<const Receiver> receivers,
                                     const ProbeOptions& options);

    class Implementation;
    explicit ProbeSum(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

// Warnings for receivers on a light, for values at the ceiling and for errors that were not reached; notes for
// receivers inside a light and for views from below the surface. Points are numbered from 1.
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

// The spread of values; of none, zeros.
Spread spread(std::span<const double> values);

// The unit vector of any vector with finite components and a length greater than 0, without overflow; nothing for
// others.
std::optional<glm::dvec3> unit_vector(const glm::dvec3& vector);

} // namespace gonio
#pragma GCC visibility pop
