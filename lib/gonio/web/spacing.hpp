// The greatest distance at which luminaires may be mounted: the spacing criterion of the IES.
#pragma once

#include <gonio/web/web.hpp>

#include <optional>

#pragma GCC visibility push(default)
namespace gonio {

// Greatest ratio of spacing to mounting height at which a horizontal plane below is as bright between luminaires as
// below one of them (IES Lighting Handbook, after Levin): along a row, where two luminaires with I(γ)cos³γ = ½ I(0)
// replace one, 2 tanγ in the planes C0–C180 and C90–C270; in a square, where four with I(γ)cos³γ = ¼ I(0) replace one,
// √2 tanγ in the diagonals. I is the mean of the plane's two halves (of all four diagonals). γ is the first such angle
// from the nadir; empty for a web that is dark at its nadir or never falls that low below 90°.
struct SpacingCriterion {
    std::optional<double> along_c0;
    std::optional<double> along_c90;
    std::optional<double> diagonal;
};

// That of a web.
SpacingCriterion spacing_criterion(const Web& web);

} // namespace gonio
#pragma GCC visibility pop
