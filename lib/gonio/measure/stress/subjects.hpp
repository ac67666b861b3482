// The stress subjects of the library's rooms, each in its own file. Internal to this room.
#pragma once

#include <gonio/measure/stress.hpp>

#include <cmath>
#include <span>

namespace gonio::measure::detail {

std::span<const StressSubject> irradiance_stress();
std::span<const StressSubject> specular_stress();
std::span<const StressSubject> brdf_stress();
std::span<const StressSubject> falloff_stress();
std::span<const StressSubject> geometry_stress();
std::span<const StressSubject> math_stress();
std::span<const StressSubject> color_stress();
std::span<const StressSubject> light_stress();
std::span<const StressSubject> web_stress();

// A finite number that is not negative.
inline bool is_amount(double value) {
    return std::isfinite(value) && value >= 0.0;
}

} // namespace gonio::measure::detail
