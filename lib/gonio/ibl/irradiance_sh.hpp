// The light of an environment in real spherical harmonics, and the illuminance of a plane from it.
//
// Y(l, m) are orthonormal over the sphere, without the phase of Condon and Shortley, in the frame of skies (x east, y
// north, z up), stored at l(l + 1) + m: Y(0,0) = 0.282095, Y(1,−1..1) = 0.488603 (y, z, x), Y(2,−2..2) = 1.092548 xy,
// 1.092548 yz, 0.315392(3z² − 1), 1.092548 xz, 0.546274(x² − y²), and so on to l = 3. "Order 2" has the bands l ≤ 2, 9
// coefficients for each channel; "order 3" l ≤ 3, 16. The illuminance of an open plane is Σ A(l) L(l,m) Y(l,m)(n) with
// A = π, 2π/3, π/4, 0 (R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for Irradiance Environment Maps",
// 2001): band 3 adds nothing to it.
#pragma once

#include <gonio/sky/environment_map.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// The greatest order of the harmonics.
inline constexpr int most_sh_order = 3;

// Y(l, m) at a unit direction, l ≤ 3.
std::array<double, 16> spherical_harmonics(const glm::dvec3& direction);

// π, 2π/3, π/4, 0.
double cosine_factor(int band);

// The irradiance of an environment by spherical harmonics.
class IrradianceSh {
public:
    // (order + 1)² radiance coefficients L(l,m), RGB [cd/m²·sr^½]; order 0 … 3.
    explicit IrradianceSh(std::vector<glm::dvec3> radiance);

    [[nodiscard]] int order() const { return order_; }
    [[nodiscard]] std::span<const glm::dvec3> radiance() const { return radiance_; }
    // A(l) L(l,m), RGB [lx·sr^½].
    [[nodiscard]] std::vector<glm::dvec3> irradiance_coefficients() const;

    // Illuminance of an open plane with this unit normal, RGB [lx]. It may be negative: least().
    [[nodiscard]] glm::dvec3 irradiance(const glm::dvec3& normal) const;

    // The least of each channel over 16384 normals, RGB [lx]: below 0 where light comes from few directions.
    [[nodiscard]] glm::dvec3 least() const;

private:
    int order_ = 0;
    std::vector<glm::dvec3> radiance_;
};

// Of the texels, uniform over the directions that they cover: integrals of Y along their outlines by Gauss nodes, exact
// to rounding. Order 0 … 3. About 1 µs a texel.
IrradianceSh irradiance_sh(const EnvironmentMap& map, int order, unsigned threads = 0);

} // namespace gonio
#pragma GCC visibility pop
