// What `gonio lights` prints: a table, or JSON.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/interchange/audit.hpp>
#include <gonio/interchange/found_light.hpp>

#include "../console.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

// What a light emits, in every quantity that its shape has.
struct LightMeasures {
    std::optional<double> flux_lm;
    std::optional<double> intensity_cd;
    std::optional<double> luminance_nt;
    std::optional<double> illuminance_lx; // of a sun
    std::optional<double> cct_k;          // stated, else of the colour if that is near the locus
};

// In the order of the lights. Profiles must be loaded.
std::vector<LightMeasures> measures_of(const FoundScene& scene);

void print_lights(const FoundScene& scene, const std::vector<LightMeasures>& measures, Console& console);

// The findings as text, a line each and its hint.
std::string audit_text(const FoundScene& scene, const std::vector<SceneFinding>& findings);

void print_lights_json(const FoundScene& scene, const std::vector<LightMeasures>& measures,
                       const std::optional<std::vector<SceneFinding>>& findings, const Diagnostics& diagnostics,
                       bool pretty, Console& console);

} // namespace gonio::cli
