// The picture of `gonio cct -o`: colours side by side, and below them the colours by other methods.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>

#include "../options/values.hpp"
#include "question.hpp"

#include <span>

namespace gonio::cli {

// Columns in the order of the answers, equally wide to within a pixel. The upper part is the colour; below it there is
// one row for each method of --versus. Linear: RGB of the requested space, as reported. Otherwise linear Rec.709 for a
// display: clipped to its gamut, with the greatest component 1. Fails (usage) on a size with fewer pixels than colours
// or methods.
Result<Image> strip(std::span<const CctAnswer> answers, const CctRequest& request, PixelSize size, bool for_display);

// The height of the scale below a strip of that size; 0 if there is no room for numbers.
int strip_scale_px(PixelSize size);

// A strip as a display shows it, with a scale below it (temperatures, or the names of the inputs) and the names of the
// methods on their rows.
Image with_scale(const Image& strip, std::span<const CctAnswer> answers, int scale_px);

} // namespace gonio::cli
