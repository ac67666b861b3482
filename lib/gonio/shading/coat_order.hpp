// How a clear coat attenuates what is below it: coat.hpp has the formulas.
#pragma once

#include <cstdint>

#pragma GCC visibility push(default)
namespace gonio::shading {

enum class CoatOrder : std::uint8_t { physical, ue4, filament };

} // namespace gonio::shading
#pragma GCC visibility pop
