// White balance: which light a picture shows as white.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/color/chromaticity.hpp>

#include <glm/mat3x3.hpp>

#include <span>

namespace gonio {

// Linear Rec.709 → linear Rec.709: makes `white` neutral and keeps its luminance, by Bradford's adaptation to D65.
// Other colours may change their luminance and leave the space. Needs a chromaticity with y > 0.
glm::dmat3 white_balance(Xy white);

// The white of an exposed picture of linear Rec.709, 1 being the display's white: the chromaticity of its mean ("grey
// world"), where no pixel counts for more than the display's white, so that lamps that are visible do not decide alone.
// D65 for a black picture.
Xy gray_world_white(const Image& exposed);
Xy gray_world_white(std::span<const Image* const> exposed); // of all together

// Multiplies every pixel of three channels by the matrix; what becomes negative is 0.
void balance(Image& image, const glm::dmat3& matrix);

} // namespace gonio
