// The illuminance of a rectangle with an image, by its pixels.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/reference.hpp>

#include <glm/vec3.hpp>

namespace gonio::detail {

// Of a light whose shape is a RectShape with an image; `normal` is unit. A pixel is a uniform rectangle, whose
// illuminance has a closed form, so the sum over all pixels is exact. Tiles of pixels whose four quarters together
// differ from a uniform tile by less than their part of the goal are not divided further. Without the window of a
// range. Cost: some 0.3 µs for each tile.
ReferenceValue image_illuminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                                 const ReferenceGoal& goal);

} // namespace gonio::detail
