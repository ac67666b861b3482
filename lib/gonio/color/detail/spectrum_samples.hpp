// What sums over a spectrum share: where it is sampled, and the observer there.
#pragma once

#include <gonio/color/spectrum.hpp>

#include <glm/vec3.hpp>

#include <vector>

namespace gonio::detail {

// The CIE 1931 observer at any wavelength, linear between its rows, 0 outside.
glm::dvec3 observer_at(double nm);

// Samples, and the width in nm that each one represents.
struct Samples {
    std::vector<double> nm;
    std::vector<double> power;
    double width_nm = 1.0;
};

// Unchanged if the steps are uniform and at most 5 nm, else interpolated to steps of 1 nm or of its finest step.
Samples samples_of(const Spectrum& spectrum);

} // namespace gonio::detail
