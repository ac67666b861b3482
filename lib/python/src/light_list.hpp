// Lights from what a caller has: one, a list of them, or anything with a list `lights`.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/probe.hpp>

#include "binding.hpp"

#include <vector>

namespace gonio::python {

std::vector<Light> lights_of(const py::object& lights);

// Positions and normals in one shape.
std::vector<Receiver> receivers_of(const Doubles& positions, const Doubles& normals);

} // namespace gonio::python
