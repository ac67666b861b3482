// Distance ticks: a thin dark line on every whole metre of the world's axes.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/stage.hpp>

#include <span>

namespace gonio {

inline constexpr double tick_width = 0.012; // [m]

// The share of an interval of the coordinate, `width` metres long around `at`, that is on lines. Closed form, so that
// lines thinner than a pixel are grey and never broken.
double tick_coverage(double at, double width);

// Darkens the planes and rectangles that the camera sees, as if the lines were painted on them, to a quarter of their
// luminance; solids and lights are not changed. Three channels; the picture must be of this camera.
void draw_ticks(Image& luminance_nt, const Stage& stage, std::span<const Light> lights, const Camera& camera,
                unsigned threads = 0);

} // namespace gonio
