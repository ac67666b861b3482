// Receivers in front of a luminaire's luminous opening or a flat area light, for measuring methods of its near field.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/transport/kernels_luminance.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gonio::measure {

// Distances in multiples of the longer side; below 1 they are from a point of the opening, else from its middle.
inline constexpr std::array opening_distances{0.25, 0.5, 1.0, 2.0, 4.0, 8.0};

struct OpeningCases {
    std::shared_ptr<const Light> luminaire; // with a body of one face, or a flat light itself
    std::array<std::vector<float>, 3> position;
    std::array<std::vector<float>, 3> normal;

    std::size_t size() const { return position[0].size(); }
    const Light& face() const { return luminaire->body != nullptr ? luminaire->parts->front() : *luminaire; }
    transport::Receivers receivers() const;
    shading::Surfaces surfaces() const; // without views
};

// At the origin, aimed down; of a light with faces the first is taken. Half of the receivers face the
// light, the others have normals of any direction in which they see some of it. The same seed gives the same poses.
OpeningCases opening_cases(const Light& luminaire, double distance_in_sides, std::size_t count, std::uint64_t seed);

// Illuminance [lx] by adaptive quadrature.
std::vector<double> opening_truth(const OpeningCases& cases, unsigned threads, double relative_error = 1e-6);

} // namespace gonio::measure
