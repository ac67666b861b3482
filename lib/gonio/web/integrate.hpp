// Luminous flux of a Web: the exact integral of its interpolant, and the industry's zonal rule.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/web/web.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// Φ = ∬ I dω of the interpolant (linear in the table's own angles between them, 0 outside), cell by cell in closed form
// for every goniometer: dω is sinγ dγ dC, or cos(latitude) dH dV. Accurate to a few ulp of the sum of |contributions|
// for any cell size.
Lumens flux(const Web& web);

// Σ mean(I₁, I₂)·(cosγ₁ − cosγ₂)·ΔC, with the trapezoid rule in C: the value that photometric software prints (IES
// LM-46, LM-79). For types A and B it uses the sines of the latitudes. Differs from flux() by the curvature of cosγ
// within a cell.
Lumens zonal_flux(const Web& web);

// ∫ of w(γ) sinγ over [gamma_low, gamma_high], for w linear from w_low to w_high over that interval [radians].
// Free of cancellation for narrow intervals; the building block of flux() and of texture means.
double integrate_linear_sin(double gamma_low, double gamma_high, double w_low, double w_high);

} // namespace gonio
#pragma GCC visibility pop
