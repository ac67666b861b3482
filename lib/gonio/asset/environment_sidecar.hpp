// The sidecar of an environment image: a JSON object of schema gonio.environment/1 that states the meaning of its
// pixels (described by environment.schema.json).
#pragma once

#include <gonio/asset/file_record.hpp>
#include <gonio/sky/environment_layout.hpp>
#include <gonio/sky/sky_measures.hpp>
#include <gonio/sky/sun_light.hpp>

#include <optional>
#include <string>

namespace gonio {

struct EnvironmentDescription {
    EnvironmentGrid grid;
    double nits_per_unit = 1.0;     // cd/m² = Y of a pixel × this
    std::string pixel;              // what the file stores per channel: "float"
    SkyMeasures measures;           // of the image
    std::optional<SunLight> sun;    // beside the image, not in it
    std::string source;             // the sky or the file that it was made from, as the user named it
    std::string source_sha256;      // of the file's bytes; empty for a sky by formula
    std::optional<FileRecord> file; // the image as it was written
};

// Keys in a fixed order, two spaces of indentation, a newline at the end; numbers read back as the same doubles.
std::string environment_sidecar(const EnvironmentDescription& environment);

} // namespace gonio
