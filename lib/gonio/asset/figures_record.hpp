// A luminaire's figures as members of a JSON record: what `gonio info --json` prints after the facts.
#pragma once

#include <gonio/base/json.hpp>
#include <gonio/figures/luminaire_figures.hpp>

namespace gonio::detail {

// Each figure under its name, null where there is none; `figure_rules` has the rule of each, `missing_figures` the
// reason for each that is null.
Json figures_json(const LuminaireFigures& figures);

} // namespace gonio::detail
