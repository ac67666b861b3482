// A luminaire rotated, mirrored, cropped, symmetrised or scaled.
//
// Exact unless stated otherwise: the interpolant of the result is the transformed interpolant of the web, at all
// angles. A result that has to be resampled is returned as a ResampledWeb (gonio/web/resample.hpp) with its error.
// Symmetry is kept if the transformed light has it. Dark sectors, where planes end before the range of their symmetry
// does, stay dark: a jump there that cannot be the end of a table becomes a ramp 0.0001° wide about it, which keeps the
// flux to 1e-8 of its cell's.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/web.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// Rotated about the axis: the light towards C goes to C + angle. Exact at any angle for type C, and at multiples of 90°
// for types A and B, where a quarter turn of one type is a web of the other; otherwise they are resampled to type C, to
// `resampling_tolerance` of the peak. A mirrored web with dark sectors is written out for any but quarter turns.
ResampledWeb rotated(const Web& web, double angle_deg);

// The plane of a mirror through the axis.
enum class MirrorPlane { c0_180, c90_270 };

// Mirrored in a plane through the axis: the light towards C goes to −C, or 180° − C.
Web mirrored(const Web& web, MirrorPlane plane);

// The axis tilted by `angle_deg` towards C = `towards_c_deg`: the light along the nadir goes to γ = angle there.
// Resampled as resampled_to_c() does, to `tolerance` of the peak. An angle of 0 changes nothing.
ResampledWeb tilted(const Web& web, double angle_deg, double towards_c_deg, double tolerance = resampling_tolerance);

// The mean of the light and its images under the mirrors of `symmetry`; axial is the mean over C. The flux stays the
// same. Webs of types A and B cannot be axial: fails (unsupported).
Result<Web> symmetrized(const Web& web, Symmetry symmetry);

// Dark outside gamma_low ≤ γ ≤ gamma_high, unchanged within: the table ends there. Fails (usage) unless 0° ≤ low < high
// ≤ 180°, (unsupported) for types A and B, and (usage) if nothing of the table remains.
Result<Web> cropped(const Web& web, double gamma_low_deg, double gamma_high_deg);

// Every intensity scaled so that flux() is `flux`. Fails (usage) unless both fluxes are greater than 0, and as
// scaled_by() does.
Result<Web> scaled_to(const Web& web, Lumens flux);

// Every intensity multiplied by `factor`. Fails (usage) unless the factor is finite and greater than 0, and if an
// intensity would be above greatest_amount.
Result<Web> scaled_by(const Web& web, double factor);

} // namespace gonio
#pragma GCC visibility pop
