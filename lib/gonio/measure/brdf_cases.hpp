// Materials, eyes and lights to measure reflectances on, from ordinary ones to the corners that formulas break in.
#pragma once

#include <gonio/measure/random.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/shading/brdf.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace gonio::measure {

// Directions are unit and point away from the surface; u is what a sampler is given. All numbers are floats.
struct BrdfPose {
    shading::vec3<float> n, l, v, u;
};

// Any normal; l and v evenly over the hemisphere above it.
BrdfPose ordinary_brdf_pose(Random& random);

// Directions even over the sphere, as close to the surface as floats are, near the mirror, near the eye and opposite to
// it, in the surface and below; u at the ends of its range too.
BrdfPose hostile_brdf_pose(Random& random);

// Eight numbers in [0, 1] that each material takes its parameters from.
struct BrdfParameters {
    std::array<double, 8> p{};

    // Even; or `hostile`: 0, 1e-4 or 1 as often as not.
    explicit BrdfParameters(Random& random, bool hostile = false);
};

namespace detail {

template<class S>
shading::vec3<S> color(const BrdfParameters& from, std::size_t first) {
    return {S(from.p[first]), S(from.p[first + 1]), S(from.p[first + 2])};
}

} // namespace detail

// The material of those parameters, as the shading core takes it.
template<class S>
void make(const BrdfParameters& from, shading::Lambert<S>& to) {
    to = {detail::color<S>(from, 0)};
}
template<class S>
void make(const BrdfParameters& from, shading::Eon<S>& to) {
    to = {detail::color<S>(from, 0), S(from.p[3])};
}
template<class S>
void make(const BrdfParameters& from, shading::Ggx<S>& to) {
    to = {detail::color<S>(from, 0), S(from.p[3])};
}
template<class S>
void make(const BrdfParameters& from, shading::KullaConty<S>& to) {
    to = shading::kulla_conty_material(detail::color<S>(from, 0), S(from.p[3]));
}
template<class S>
void make(const BrdfParameters& from, shading::Frostbite<S>& to) {
    to = shading::frostbite_material(detail::color<S>(from, 0), S(from.p[3]), S(from.p[4]), S(from.p[5]));
}
template<class S>
void make(const BrdfParameters& from, shading::Ue4<S>& to) {
    to = shading::ue4_material(detail::color<S>(from, 0), S(from.p[3]), S(from.p[4]), S(from.p[5]), S(from.p[6]));
}
template<class S>
void make(const BrdfParameters& from, shading::Blinn<S>& to) {
    to = shading::blinn_material(detail::color<S>(from, 0), detail::color<S>(from, 3), S(from.p[6]), S(from.p[7]));
}

// The same as a material of a scene; `kind` counts in the order of Material's alternatives.
Material scene_material(std::size_t kind, const BrdfParameters& parameters);

} // namespace gonio::measure
