// How a clear coat attenuates what is below it: coat.hpp has the formulas.
#pragma once

#include <cstdint>

#pragma GCC visibility push(default)
namespace gonio::shading {

// How a coat and what is below it share the light.
enum class CoatOrder : std::uint8_t { physical, ue4, filament };

} // namespace gonio::shading
#pragma GCC visibility pop
