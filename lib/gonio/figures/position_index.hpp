// Guth's position index p: how much more luminance a source may have off the line of sight than on it, to glare as
// much.
//
// A source lies at (T, R, H) from the eye: R along the line of sight, which is level, T to the side, H up. At H = T = 0
// the index is 1.
#pragma once

#include <optional>

#pragma GCC visibility push(default)
namespace gonio {

// By the table of CIE 117:1995, bilinear in T/R and H/R: what tables of UGR are made with. `t_over_r` in [0, 3] and
// `h_over_r` in [0, 1.6], the part of the table that has its standard rooms; empty elsewhere.
std::optional<double> table_position_index(double t_over_r, double h_over_r);

// In closed form, for any direction ahead: Guth's ln p = (35.2 − 0.31889 τ − 1.22 e^(−2τ/9)) 10⁻³ σ + (21 + 0.26667 τ −
// 0.002963 τ²) 10⁻⁵ σ² above the line of sight, with the angle σ from that line and τ from the vertical, in degrees;
// below it Iwata's and Tokura's 1 + 0.8 r/R for r < 0.6 R, else 1 + 1.2 r/R, with r = √(T² + H²). Within −10 to +11 %
// of the table. R > 0.
double closed_position_index(double t, double r, double h);

} // namespace gonio
#pragma GCC visibility pop
