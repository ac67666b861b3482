// What `gonio sky info` says about a sky: in words and as JSON (schema gonio.sky/1).
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/sky/sky_measures.hpp>

#include "../json_text.hpp"
#include "request.hpp"

#include <optional>
#include <string>

namespace gonio::cli {

struct SkyReport {
    std::string input;
    std::string kind; // "cie"
    SkyMeasures measures;
    std::optional<Cct> cct; // nothing if the colour has no temperature
    std::optional<SunLight> sun;
    std::optional<LoadedImage> image;
};

// Measures the sky on `threads`, 0: all. A colour without a temperature is a warning.
SkyReport report_of(const std::string& input, const LoadedSky& loaded, unsigned threads, Diagnostics& diagnostics);

std::string to_text(const SkyReport& report);
Json to_json(const SkyReport& report, const Diagnostics& diagnostics);

} // namespace gonio::cli
