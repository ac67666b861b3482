#include "convert.hpp"

#include <gonio/asset/environment_sidecar.hpp>
#include <gonio/asset/sidecar.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/path.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky_measures.hpp>

#include "../options/files_in_use.hpp"
#include "environment_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr int usual_latlong_side = 512; // of skies by formula

Result<EnvironmentGrid> target_grid(const LoadedSky& loaded, const Arguments& arguments) {
    const EnvironmentGrid* const source = loaded.image ? &loaded.image->map->grid() : nullptr;
    Result<EnvironmentLayout> layout =
        output_layout(arguments, source != nullptr ? source->layout() : EnvironmentLayout::latlong);
    if (!layout) return pass_on(layout);
    if (const auto size = arguments.value("--size")) return environment_size(*layout, *size);
    return environment_grid(*layout, source != nullptr
                                         ? side_like(source->layout(), source->side(), *layout)
                                         : side_like(EnvironmentLayout::latlong, usual_latlong_side, *layout));
}

// The sidecar's fields as attributes, but those that encode_environment() writes.
std::vector<media::ImageAttribute> attributes_of(const std::string& sidecar) {
    std::vector<media::ImageAttribute> attributes;
    for (SidecarField& field : sidecar_fields(sidecar)) {
        if (field.name == "layout" || field.name == "nits_per_unit") continue;
        std::string name = "gonio:" + field.name;
        if (const auto* const number = std::get_if<double>(&field.value))
            attributes.push_back({std::move(name), std::vector<float>{static_cast<float>(*number)}});
        else
            attributes.push_back({std::move(name), std::get<std::string>(field.value)});
    }
    return attributes;
}

} // namespace

Result<Json> convert_sky(const SkySource& source, const LoadedSky& loaded, const SkyRequest& request,
                         const Arguments& arguments) {
    const std::string output = arguments.value("--output").value_or("");
    Result<EnvironmentStorage> storage = environment_storage(arguments, output);
    if (!storage) return pass_on(storage);
    Result<std::optional<std::string>> sidecar =
        sidecar_file(arguments, output == "-" ? std::string() : output + ".json");
    if (!sidecar) return pass_on(sidecar);
    Result<EnvironmentGrid> grid = target_grid(loaded, arguments);
    if (!grid) return pass_on(grid);
    FilesInUse in_use(source.files);
    for (const std::string& file : {output, sidecar->value_or(std::string())})
        if (!file.empty())
            if (Result<void> free = in_use.take(file); !free) return pass_on(free);

    Result<bool> asked_for = with_sun_in_pixels(arguments, loaded, request);
    if (!asked_for) return pass_on(asked_for);
    const bool with_the_sun = *asked_for;
    EnvironmentMap image = environment_image(loaded, *grid, request.threads);
    if (with_the_sun) image = with_sun(image, *loaded.sun);
    const double scale = nits_per_unit(image, storage->pixel);
    // As the file will hold it, so that the sidecar's lux are those that are read from the file.
    const auto map =
        std::make_shared<const EnvironmentMap>(media::as_stored(image, scale, *storage->format, storage->pixel));
    Result<Sky> as_written = resolve_sky({ImageSkyKind{}, {}, glm::dvec3(1.0), {}, 0.0}, map);
    if (!as_written) return pass_on(as_written);
    EnvironmentDescription description;
    description.grid = *grid;
    description.nits_per_unit = scale;
    description.pixel = media::to_text(storage->pixel);
    description.measures = measure(*as_written);
    if (!with_the_sun) description.sun = loaded.sun;
    description.source = source.text;
    if (loaded.image) description.source_sha256 = loaded.image->sha256;
    Result<std::string> bytes = media::encode_environment(*map, *storage->format, storage->pixel,
                                                          attributes_of(environment_sidecar(description)));
    if (!bytes) return pass_on(bytes);
    std::vector<OutputFile> files;
    description.file = file_record(file_name(output), *bytes);
    files.push_back({output, std::move(*bytes)});
    const std::string sidecar_text = environment_sidecar(description);
    if (*sidecar) files.push_back({**sidecar, sidecar_text});
    if (Result<void> written = write_outputs(files); !written) return pass_on(written);
    return detail::parse_json(sidecar_text);
}

} // namespace gonio::cli
