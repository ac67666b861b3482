// Luminaires defined by a formula: relative intensity by direction, converted to a web.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/web/web.hpp>

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace gonio {

// A light as a formula. `relative` is ≥ 0, on any scale, for C in [0°, 360°) and γ in [0°, 180°].
struct AuthoredShape {
    std::function<double(double c_deg, double gamma_deg)> relative;
    Symmetry symmetry = Symmetry::none; // symmetry of the formula
    double gamma_end_deg = 90.0;        // 90 or 180: dark above
};

struct AuthoredKind {
    std::string_view kind;    // "batwing"
    std::string_view grammar; // "batwing:reach=ANGLE,…"
    std::string_view summary; // the formula
};

std::span<const AuthoredKind> authored_kinds();

// "downlight:beam=30deg,spill=0.05". Angles and lengths need units. Fails (usage) on an unknown kind or key and on a
// value outside its range.
Result<AuthoredShape> parse_authored(std::string_view text);

struct AuthorOptions {
    Photometry photometry = Photometry::c;
    double horizontal_step_deg = 5.0; // of C or H; divides 90°
    double vertical_step_deg = 2.5;   // of γ or V; divides 90°
    Lumens flux{1000.0};              // > 0
};

// The shape's values at the angles of a uniform grid, with its mirrors, scaled to the flux and rounded to seven
// significant digits of cd/klm, which keeps a file of it short. The flux is met to 1e-7; values below 1e-9 cd/klm
// become 0. Fails (usage) on steps that do not divide 90° into at most 1800 parts, a flux that is not greater than 0,
// and a formula that gives no light or a number that is not finite or is below 0.
Result<Web> authored(const AuthoredShape& shape, const AuthorOptions& options);

} // namespace gonio
