// The sidecar of a prefiltered environment: a JSON object of schema gonio.prefilter/1 that states what its images and
// its table mean, and how exact they are (described by prefilter.schema.json).
#pragma once

#include <gonio/asset/file_record.hpp>
#include <gonio/ibl/irradiance_sh.hpp>
#include <gonio/ibl/prefilter_error.hpp>
#include <gonio/ibl/prefilter_variant.hpp>
#include <gonio/ibl/split_sum_table.hpp>
#include <gonio/sky/environment_layout.hpp>
#include <gonio/sky/sun_light.hpp>

#include <optional>
#include <string>
#include <vector>

namespace gonio {

struct PrefilterImage {
    double roughness = 0.0; // linear
    EnvironmentGrid grid;
    PrefilterError error; // as stored
    FileRecord file;
};

struct PrefilterDescription {
    const PrefilterVariant* variant = nullptr; // required
    double nits_per_unit = 1.0;                // cd/m² = Y of a pixel of an image × this
    std::string pixel;                         // what the files store per channel: "float"
    std::vector<PrefilterImage> levels;        // the sharpest first
    PrefilterImage irradiance;                 // roughness 1: the illuminance over π
    FileRecord table_file;
    double table_error = 0.0; // SplitSumTable::lookup_error()
    IrradianceSh harmonics{{glm::dvec3(0.0)}};
    EnvironmentGrid source_grid; // of the image that was filtered
    std::optional<SunLight> sun; // beside the images, not in them
    std::string source;          // the sky or the file, as the user named it
    std::string source_sha256;   // of the file's bytes; empty for a sky by formula
};

// Keys in a fixed order, two spaces of indentation, a newline at the end; numbers read back as the same doubles.
std::string prefilter_sidecar(const PrefilterDescription& description, const SplitSumTable& table);

} // namespace gonio
