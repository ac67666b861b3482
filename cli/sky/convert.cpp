#include "convert.hpp"

#include <gonio/asset/environment_sidecar.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/path.hpp>
#include <gonio/sky/environment_resample.hpp>

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
    EnvironmentMap image = environment_of(loaded.sky, *grid, request.threads);
    if (with_the_sun) image = with_sun(image, *loaded.sun);
    EnvironmentDescription description;
    if (!with_the_sun) description.sun = loaded.sun;
    description.source = source.text;
    if (loaded.image) description.source_sha256 = loaded.image->sha256;
    Result<EnvironmentFiles> made = environment_files(image, nits_per_unit(image, storage->pixel), *storage,
                                                      std::move(description), file_name(output), request.threads);
    if (!made) return pass_on(made);
    std::vector<OutputFile> files;
    files.push_back({output, std::move(made->image)});
    if (*sidecar) files.push_back({**sidecar, made->sidecar});
    if (Result<void> written = write_outputs(files); !written) return pass_on(written);
    return detail::parse_json(made->sidecar);
}

} // namespace gonio::cli
