// Glare: the veil that the eye's own scattering lays over a scene, around what is brighter than a display can show.
//
// What a display does show scatters in the eye of the person who looks at it. What it cannot show is missing there: the
// excess above the display's white. So the excess alone is spread over the picture, by the point spread function of the
// eye, over the angles at the camera. Sources outside the picture do not count. A light without size does: the eye sees
// it, though a picture does not show it.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/light/light.hpp>
#include <gonio/preview/partial_light.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/stage.hpp>

#include <span>

namespace gonio {

struct Eye {
    double age_years = 25.0; // [0, 100]
    double pigment = 0.5;    // [0, 1.2]: 0 very dark brown eyes, 0.5 brown, 1 green, 1.2 light blue
};

// The glare function of the CIE from the centre of vision to 100°, in cd/m² of veil per lx at the eye, which is sr⁻¹
// (J. J. Vos and T. J. T. P. van den Berg, "Report on disability glare", CIE 135/1, 1999, complete equation; also J. J.
// Vos, "On the cause of disability glare and its dependence on glare angle, age and ocular pigmentation", 2003).
// Divided by its integral, so that the eye loses no light.
class GlareFunction {
public:
    explicit GlareFunction(Eye eye = {});

    // At an angle of 0 or more from the source.
    double per_sr(double angle_rad) const;

    // The share of the light that stays within this angle of its source, at most 2°; in closed form, on the plane.
    double share_within(double angle_rad) const;

    // The integral of the published equation over the half-space, for light that falls on the pupil: 1 but for the
    // rounding of its constants (1.04 for the default eye).
    double published_integral() const { return integral_; }

private:
    double published_per_sr(double angle_deg) const;

    double narrow_ = 0.0;  // weight of the terms of the image of a point
    double wide_ = 0.0;    // weight of the terms of scattered light, which grow with age
    double pigment_ = 0.0; // weight of the light through the wall of the eye
    double integral_ = 1.0;
};

struct GlareOptions {
    Eye eye;
    unsigned threads = 0; // 0: all
    // The greatest radius of a group of sources over its distance: groups are summed as one source. 0 sums every pixel
    // by itself.
    double group_size = 0.3;
};

// Adds each light without size that the camera sees to the pixel in which it is: as a luminance that gives the same
// illuminance at the eye, I/d² times the window of its range. A picture in cd/m², of this camera.
void show_points(Image& luminance_nt, const Stage& stage, std::span<const Light> lights, const Camera& camera);

// Adds glare to an exposed picture of linear Rec.709, 1 being the display's white, and to the lights that its pixels
// show in part. The share 1 − 1/Y of a pixel with a luminance Y above 1 is spread: a pixel in the direction of u
// receives ∫ f(θ) cosθ L dω over the pixels, and a source keeps what falls into its own pixel. Groups of pixels that
// are small against their distance count as one, with their spread to second order: within 0.5 % of the sum over all
// pixels, 0.1 % RMS. The same bytes at any number of threads. A picture with few sources costs little; where every
// pixel is one, some 15 µs for each on one core.
void add_glare(Image& exposed, std::span<PartialLight> lights, const Camera& camera, const GlareOptions& options = {});

} // namespace gonio
