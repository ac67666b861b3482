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
#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr int usual_latlong_side = 512; // of skies by formula

// "1024" as the side of the layout, or "1024x512".
Result<EnvironmentGrid> grid_of(EnvironmentLayout layout, const std::string& size) {
    const EnvironmentLayoutInfo& info = info_of(layout);
    if (size.find('x') != std::string::npos) {
        Result<PixelSize> whole = parse_size(size);
        if (!whole) return pass_on(whole);
        Result<EnvironmentGrid> grid = EnvironmentGrid::create(layout, whole->width, whole->height);
        if (!grid)
            return fail("USE0106", fmt::format("the layout {} has no images of {} pixels", info.name, size),
                        fmt::format("it is {}:{}, for example {}x{}", info.across, info.down, 256 * info.across,
                                    256 * info.down));
        return environment_grid(layout, grid->side());
    }
    Result<std::uint64_t> number = whole_number(size, "--size");
    if (!number) return pass_on(number);
    const auto most = std::uint64_t{limit("environment-values").value};
    const std::uint64_t sides = layout == EnvironmentLayout::latlong ? 2 : 1;
    if (*number % sides != 0) return fail("USE0106", fmt::format("the width of a latlong is even, not {}", *number));
    return environment_grid(layout, static_cast<int>(std::min(*number / sides, most)));
}

Result<EnvironmentGrid> target_grid(const LoadedSky& loaded, const Arguments& arguments) {
    const EnvironmentGrid* const source = loaded.image ? &loaded.image->map->grid() : nullptr;
    EnvironmentLayout layout = source != nullptr ? source->layout() : EnvironmentLayout::latlong;
    if (const auto named = arguments.value("--layout")) {
        Result<EnvironmentLayout> known = parse_environment_layout(*named);
        if (!known) return pass_on(known);
        layout = *known;
    }
    if (const auto size = arguments.value("--size")) return grid_of(layout, *size);
    return environment_grid(layout, source != nullptr
                                        ? side_like(source->layout(), source->side(), layout)
                                        : side_like(EnvironmentLayout::latlong, usual_latlong_side, layout));
}

struct Storage {
    const media::ImageFormat* format;
    media::Pixel pixel;
};

Result<Storage> storage_of(const Arguments& arguments, const std::string& output) {
    Result<const media::ImageFormat*> format = picture_format(arguments.value("--to"), output);
    if (!format) return pass_on(format);
    if (!has_pixel(**format, media::Pixel::float32))
        return fail("USE0107", fmt::format("{} holds values for a display, not light", (*format)->title),
                    "write .exr, .hdr or .tif");
    constexpr std::array kinds{Named{"float", media::Pixel::float32}, Named{"half", media::Pixel::half}};
    Result<media::Pixel> pixel = find_value("pixel type", arguments.value("--pixel").value_or("float"), kinds);
    if (!pixel) return pass_on(pixel);
    if (!has_pixel(**format, *pixel))
        return fail("USE0107", fmt::format("{} cannot store {} pixels", (*format)->title, media::to_text(*pixel)),
                    "write .exr for half");
    return Storage{*format, *pixel};
}

EnvironmentMap image_of(const LoadedSky& loaded, const EnvironmentGrid& grid, unsigned threads) {
    if (!loaded.image) return rendered(loaded.sky, grid, threads);
    const EnvironmentMap& map = *loaded.image->map;
    const Radians rotation = loaded.sky.rotation();
    const bool same = map.grid().layout() == grid.layout() && map.grid().side() == grid.side();
    return same && rotation.value == 0.0 ? map : resampled(map, grid, rotation, threads);
}

// cd/m² of a pixel of 1 in the file: 1, or for half floats the power of two that makes all pixels fit.
double nits_per_unit(const EnvironmentMap& map, media::Pixel pixel) {
    if (pixel != media::Pixel::half) return 1.0;
    constexpr double largest_half = 65504.0;
    const std::vector<float>& values = map.image().pixels;
    const double most = static_cast<double>(*std::max_element(values.begin(), values.end())) * map.nits_per_unit();
    return most > largest_half ? std::exp2(std::ceil(std::log2(most / largest_half))) : 1.0;
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

Result<std::optional<std::string>> sidecar_name(const Arguments& arguments, const std::string& output) {
    const auto named = arguments.value("--sidecar");
    if (named && arguments.has("--no-sidecar"))
        return fail("USE0107", "--sidecar and --no-sidecar contradict each other", "leave one of them out");
    if (named) return named;
    if (output == "-" || arguments.has("--no-sidecar")) return std::optional<std::string>();
    return std::optional(output + ".json");
}

} // namespace

Result<Json> convert_sky(const std::string& text, const LoadedSky& loaded, const SkyRequest& request,
                         const Arguments& arguments) {
    const std::string output = arguments.value("--output").value_or("");
    Result<Storage> storage = storage_of(arguments, output);
    if (!storage) return pass_on(storage);
    Result<std::optional<std::string>> sidecar = sidecar_name(arguments, output);
    if (!sidecar) return pass_on(sidecar);
    Result<EnvironmentGrid> grid = target_grid(loaded, arguments);
    if (!grid) return pass_on(grid);
    FilesInUse in_use(std::vector<std::string>{file_of_sky(text)});
    for (const std::string& file : {output, sidecar->value_or(std::string())})
        if (!file.empty())
            if (Result<void> free = in_use.take(file); !free) return pass_on(free);

    const bool with_the_sun = arguments.has("--with-sun");
    if (with_the_sun && (request.cut_sun || !loaded.sun))
        return fail("USE0107",
                    request.cut_sun ? std::string("--cut-sun and --with-sun contradict each other")
                                    : fmt::format("'{}' has no sun beside it", loaded.kind),
                    "--with-sun is for daylight that is not overcast");
    EnvironmentMap image = image_of(loaded, *grid, request.threads);
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
    description.source = text;
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
