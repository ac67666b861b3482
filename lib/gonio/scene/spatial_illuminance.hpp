// Illuminances that are not of a flat surface: cylindrical, semi-cylindrical and hemispherical, and the modelling
// index. Z is up.
//
//   cylindrical       Ez  = 1/π ∫ L sin ε dω             mean over all vertical surfaces (EN 12464-1)
//   semi-cylindrical  Esc = 1/π ∫ L (1 + cos α) sin ε dω  (EN 13201-3)
//   hemispherical     Ehs = 1/4 ∫ L (1 + cos ε) dω        (EN 13201-3)
//   modelling         Ez/Eh, Eh that of a horizontal surface (EN 12464-1: 0.30 to 0.60 models well)
//
// ε is measured from the zenith, α is the horizontal angle between the light and the direction that the half cylinder
// faces. For a light of intensity I at the distance d, L dω is I/d².
//
// Lights without a size and the sun are exact sums. Under a light with a size the horizontal illuminance is the closed
// form of probe(), and so is the vector part of the others: ∫ L l·n dω is the illuminance of a surface that faces n
// less that of its back. What is left, Ez and the scalar ∫ L dω, is the mean of closed forms over the direction of a
// surface: exact where the light is wholly above its horizon, by Gauss–Legendre quadrature where it crosses it.
// Together within 2e-5 of the value where the light's bounding sphere does not contain the point, else within 1e-3
// (measured). Flat lights whose luminance is not uniform, such as the faces of a luminous opening and lights with a
// mask, are sums over their elements, within 3e-4.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/probe.hpp>

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace gonio {

enum class IlluminanceKind { planar, horizontal, vertical, cylindrical, semi_cylindrical, hemispherical, modelling };

// A kind by its name in text.
struct IlluminanceKindName {
    IlluminanceKind kind;
    std::string_view name;
    std::string_view summary;
};

// All of them, planar first.
std::span<const IlluminanceKindName> illuminance_kinds();

// Fails (usage) on any name other than those.
Result<IlluminanceKind> parse_illuminance_kind(std::string_view name);

// Whether the kind needs a horizontal direction, the normal of the receiver.
bool needs_direction(IlluminanceKind kind);

// Ez, Esc or Ehs of one light at a point. `normal` is unit; of Esc it is the horizontal direction that the half
// cylinder faces, the others ignore it. Planar kinds: the illuminance of a surface with that normal.
double illuminance_of_kind(IlluminanceKind kind, const Light& light, const glm::dvec3& position,
                           const glm::dvec3& normal);

// The share of each light, [receiver][light], for any kind but modelling. Sets no limits of its own: `receivers` are
// those that probe() accepts.
std::vector<double> illuminance_parts(IlluminanceKind kind, std::span<const Light> lights,
                                      std::span<const Receiver> receivers, unsigned threads = 0);

// The surfaces whose illuminances, times these weights, give a kind of what arrives from everywhere at a point, such as
// the light of a sky and of the stage: the trapezoidal rule on `turns` vertical directions, beside straight up and
// down.
struct WeightedNormal {
    glm::dvec3 normal{0.0, 0.0, 1.0};
    double weight = 1.0;
};
std::vector<WeightedNormal> surfaces_of(IlluminanceKind kind, const glm::dvec3& normal);

} // namespace gonio
