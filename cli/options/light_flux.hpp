// The luminous flux of a resolved light.
#pragma once

#include <gonio/light/light.hpp>

#include <optional>

namespace gonio::cli {

// Lumens; empty where the shape has no such quantity.
std::optional<double> flux_lm(const Light& light);

} // namespace gonio::cli
