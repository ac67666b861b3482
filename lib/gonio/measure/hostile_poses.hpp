// Receivers in front of lights of every shape, in the strata that break formulas, in doubles. The same seed gives the
// same poses everywhere.
//
// A light is at the origin; `receiver` places one of its receivers. Sizes are round or arbitrary numbers of metres,
// axes aligned or not, and a quarter of the lights are needles and plates.
#pragma once

#include <gonio/measure/random.hpp>
#include <gonio/shading/irradiance_disk.hpp>
#include <gonio/shading/irradiance_rectangle.hpp>
#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/irradiance_tube.hpp>
#include <gonio/shading/kernels.hpp>

#include <array>
#include <cstddef>
#include <string>

namespace gonio::measure::hostile {

using Vec = shading::vec3<double>;

enum class Shape { disk, rectangle, tube, sphere };

struct Pose {
    Shape shape = Shape::disk;
    Vec center, axis, across; // `across`: width direction
    double p = 1.0;           // radius, or width
    double q = 1.0;           // height, or length
    Vec normal;
};

template<class S>
S exact(const Pose& pose) {
    using shading::vec3;
    const auto of = [](Vec v) { return vec3<S>{static_cast<S>(v.x), static_cast<S>(v.y), static_cast<S>(v.z)}; };
    const auto p = static_cast<S>(pose.p);
    const auto q = static_cast<S>(pose.q);
    switch (pose.shape) {
    case Shape::disk:
        return shading::irradiance_disk(of(pose.center), of(pose.axis), p, of(pose.normal));
    case Shape::rectangle:
        return shading::irradiance_rectangle(of(pose.center), of(pose.axis), of(pose.across), p, q, of(pose.normal));
    case Shape::tube:
        return shading::irradiance_tube(of(pose.center), of(pose.axis), p, q, of(pose.normal));
    case Shape::sphere:
        return shading::irradiance_sphere(of(pose.center), p, of(pose.normal));
    }
    return S(0);
}

// Radius of the bounding sphere about the light's centre, and the angle that this sphere subtends at the receiver
// [rad].
double bounding_radius(const Pose& pose);
double subtended(const Pose& pose);

enum class Stratum : unsigned { above, straddling, below, grazing, near, on, inside, far, axial };
inline constexpr std::size_t stratum_count = 9;
inline constexpr std::array<const char*, stratum_count> stratum_names{"above", "straddling", "below", "grazing", "near",
                                                                      "on",    "inside",     "far",   "axial"};

// center and normal are left for `receiver` to set.
Pose random_light(Shape shape, Random& random);

// Distances from 1e-4 to 1e6 of the light's bounding radius.
Pose receiver(Pose pose, Stratum stratum, Random& random);

// The same pose with every number rounded to float.
Pose as_float(Pose pose);

// The light of a pose, at the origin, as the kernels take it.
shading::LightConstants light_constants(const Pose& pose);

// The numbers of a pose in hexadecimal, for a report.
std::string to_text(const Pose& pose);

Vec random_direction(Random& random);

// A unit direction whose cosine with `to` is `cosine`.
Vec tilted(Vec to, double cosine, Random& random);

// Numbers that break formulas in float, among ordinary ones: zeros, the smallest and the greatest floats, neighbours of
// 1.
double number(Random& random);

} // namespace gonio::measure::hostile
