// Indirect light on the cells of a stage: the fixed point of what the cells send each other, by Jacobi's iteration. Its
// slow mode is the mean level, which each step corrects by what is left of it.
//
// Everything is linear in the direct light, so the lights' shares add up.
#pragma once

#include <gonio/transport/exchange_geometry.hpp>

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace gonio::detail {

// The illuminance of each cell by indirect light [lx] after `bounces` of them; `albedo` by surface, `reflected_lx` of
// direct light by patch.
std::vector<glm::dvec3> solve_indirect(const ExchangeGeometry& geometry, std::span<const glm::dvec3> albedo,
                                       std::span<const glm::dvec3> reflected_lx, int bounces, unsigned threads);

} // namespace gonio::detail
