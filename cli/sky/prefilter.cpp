#include "prefilter.hpp"

#include <gonio/asset/prefilter_sidecar.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/path.hpp>
#include <gonio/ibl/environment_tree.hpp>
#include <gonio/ibl/prefilter.hpp>
#include <gonio/media/environment_file.hpp>
#include <gonio/sky/environment_resample.hpp>

#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/values.hpp"
#include "environment_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr int usual_irradiance_side = 32;
constexpr int usual_table_size = 128;

struct Wanted {
    const PrefilterVariant* variant = nullptr;
    EnvironmentStorage storage{};
    PrefilterOptions levels;
    EnvironmentGrid irradiance;
    int table_size = usual_table_size;
    std::string stem; // of the files' names
    std::string ending;
    std::optional<std::string> sidecar;

    [[nodiscard]] std::string file(const std::string& part) const { return stem + "." + part + ending; }
    [[nodiscard]] std::string level_file(std::size_t level) const { return file(fmt::format("specular-{}", level)); }
    [[nodiscard]] std::string irradiance_file() const { return file("irradiance"); }
    [[nodiscard]] std::string table_file() const { return file("split-sum"); }
};

Result<int> count_of(const Arguments& arguments, std::string_view option, int otherwise) {
    const auto text = arguments.value(option);
    if (!text) return otherwise;
    Result<std::uint64_t> count = whole_number(*text, option);
    if (!count) return pass_on(count);
    constexpr std::uint64_t most = 1U << 30U; // what it counts has its own limit
    return static_cast<int>(std::min(*count, most));
}

Result<Wanted> wanted(const Arguments& arguments, unsigned threads) {
    Wanted want;
    Result<const PrefilterVariant*> variant = parse_prefilter_variant(arguments.value("--for").value_or("linear"));
    if (!variant) return pass_on(variant);
    want.variant = *variant;

    const std::string output = arguments.value("--output").value_or("");
    if (output == "-")
        return fail("USE0107", "a prefiltered environment is several files, and stdout is one",
                    "for example -o sky.exr");
    Result<EnvironmentStorage> storage = environment_storage(arguments, output);
    if (!storage) return pass_on(storage);
    want.storage = *storage;
    const std::size_t point = output.rfind('.');
    const bool has_ending = point != std::string::npos && output.find('/', point) == std::string::npos;
    want.stem = has_ending ? output.substr(0, point) : output;
    want.ending = has_ending ? output.substr(point) : "." + std::string(storage->format->extensions.front());
    Result<std::optional<std::string>> sidecar = sidecar_file(arguments, want.stem + ".json");
    if (!sidecar) return pass_on(sidecar);
    want.sidecar = std::move(*sidecar);

    Result<EnvironmentLayout> named = output_layout(arguments, EnvironmentLayout::cube_strip);
    if (!named) return pass_on(named);
    const EnvironmentLayout layout = *named;
    Result<EnvironmentGrid> sharpest =
        arguments.has("--size")
            ? environment_size(layout, *arguments.value("--size"))
            : environment_grid(layout, side_like(EnvironmentLayout::cube_strip, want.variant->side, layout));
    if (!sharpest) return pass_on(sharpest);
    const bool is_cube = layout != EnvironmentLayout::latlong && layout != EnvironmentLayout::octahedral;
    Result<int> levels = count_of(arguments, "--levels", levels_of(*want.variant, sharpest->side(), is_cube ? 1 : 2));
    if (!levels) return pass_on(levels);
    want.levels.layout = layout;
    want.levels.side = sharpest->side();
    want.levels.levels = *levels;
    want.levels.mapping = want.variant->mapping;
    want.levels.threads = threads;

    Result<int> side = count_of(arguments, "--irradiance", usual_irradiance_side);
    if (!side) return pass_on(side);
    Result<EnvironmentGrid> irradiance = environment_of_side(layout, *side, fmt::format("--irradiance {}", *side));
    if (!irradiance) return pass_on(irradiance);
    want.irradiance = *irradiance;
    Result<int> table = count_of(arguments, "--table", usual_table_size);
    if (!table) return pass_on(table);
    want.table_size = *table;
    return want;
}

Result<void> take_files(const SkySource& source, const Wanted& want) {
    FilesInUse in_use(source.files);
    std::vector<std::string> files{want.irradiance_file(), want.table_file()};
    for (int level = 0; level < want.levels.levels; ++level)
        files.push_back(want.level_file(static_cast<std::size_t>(level)));
    if (want.sidecar) files.push_back(*want.sidecar);
    for (const std::string& file : files)
        if (Result<void> free = in_use.take(file); !free) return free;
    return {};
}

// What is filtered: an image as it is, a formula in cubes as fine as the sharpest level.
Result<EnvironmentMap> source_of(const LoadedSky& loaded, const Wanted& want, bool with_the_sun, unsigned threads) {
    constexpr int least_side = 64;
    Result<EnvironmentGrid> grid =
        loaded.image ? Result<EnvironmentGrid>(loaded.image->map->grid())
                     : environment_grid(EnvironmentLayout::cube_strip,
                                        std::max(least_side, side_like(want.levels.layout, want.levels.side,
                                                                       EnvironmentLayout::cube_strip)));
    if (!grid) return pass_on(grid);
    EnvironmentMap source = environment_of(loaded.sky, *grid, threads);
    return with_the_sun ? with_sun(source, *loaded.sun) : source;
}

// Fewer of a large source: the quadrature is over all of its texels.
int texels_to_check(const EnvironmentGrid& source, int levels) {
    constexpr double work = 3e7;
    const double texels = static_cast<double>(source.width()) * source.height();
    return static_cast<int>(std::clamp(work / (texels * levels), 4.0, 24.0));
}

} // namespace

Result<Json> prefilter_sky(const SkySource& from, const LoadedSky& loaded, const SkyRequest& request,
                           const Arguments& arguments) {
    Result<Wanted> want = wanted(arguments, request.threads);
    if (!want) return pass_on(want);
    Result<bool> asked_for = with_sun_in_pixels(arguments, loaded, request);
    if (!asked_for) return pass_on(asked_for);
    const bool with_the_sun = *asked_for;
    const bool is_black =
        loaded.sky.is_dark() || (loaded.image && loaded.image->map->light(request.threads) == glm::dvec3(0.0));
    if (is_black && !with_the_sun)
        return fail("USE0106", "the sky is dark: there is nothing to prefilter",
                    "give it an amount, for example 500lx");
    // What can be refused is, before the work.
    if (Result<void> possible = check_levels(want->levels); !possible) return pass_on(possible);
    if (Result<void> free = take_files(from, *want); !free) return pass_on(free);
    Result<SplitSumTable> table = SplitSumTable::create(want->table_size, want->variant->split_sum, request.threads);
    if (!table) return pass_on(table);

    Result<EnvironmentMap> source = source_of(loaded, *want, with_the_sun, request.threads);
    if (!source) return pass_on(source);
    const EnvironmentTree tree(*source, request.threads);
    Result<PrefilteredEnvironment> found = prefilter(*source, tree, want->levels);
    if (!found) return pass_on(found);

    PrefilterDescription description;
    description.variant = want->variant;
    description.pixel = media::to_text(want->storage.pixel);
    description.table_error = table->lookup_error(std::max(1, want->table_size / 16), request.threads);
    description.harmonics = irradiance_sh(*source, most_sh_order, request.threads);
    description.source_grid = source->grid();
    if (!with_the_sun) description.sun = loaded.sun;
    description.source = from.text;
    if (loaded.image) description.source_sha256 = loaded.image->sha256;

    // As the files will hold them, so that the errors are those of the files. The irradiance is the last one.
    std::vector<PrefilteredLevel> images(found->levels().begin(), found->levels().end());
    images.push_back({1.0, irradiance_map(tree, want->irradiance, want->levels.tolerance, request.threads)});
    for (const PrefilteredLevel& image : images)
        description.nits_per_unit = std::max(description.nits_per_unit, nits_per_unit(image.map, want->storage.pixel));
    for (PrefilteredLevel& image : images)
        image.map = media::as_stored(image.map, description.nits_per_unit, *want->storage.format, want->storage.pixel);
    const std::vector<PrefilterError> errors = prefilter_errors(
        *source, images, texels_to_check(source->grid(), static_cast<int>(images.size())), request.threads);

    std::vector<OutputFile> files;
    const auto add = [&](const std::string& name, std::string bytes) {
        FileRecord record = file_record(file_name(name), bytes);
        files.push_back({name, std::move(bytes)});
        return record;
    };
    for (std::size_t i = 0; i < images.size(); ++i) {
        const bool is_level = i + 1 < images.size();
        Result<std::string> bytes = media::encode_environment(
            images[i].map, *want->storage.format, want->storage.pixel,
            {{"gonio:prefilter", std::string(want->variant->name)},
             {"gonio:roughness", std::vector<float>{static_cast<float>(images[i].roughness)}}},
            request.threads);
        if (!bytes) return pass_on(bytes);
        PrefilterImage image{images[i].roughness, images[i].map.grid(), errors[i],
                             add(is_level ? want->level_file(i) : want->irradiance_file(), std::move(*bytes))};
        if (is_level)
            description.levels.push_back(std::move(image));
        else
            description.irradiance = std::move(image);
    }
    media::ImageWriteOptions write;
    write.pixel = want->storage.pixel;
    write.threads = request.threads;
    Result<std::string> bytes = media::encode_image(table->image(), *want->storage.format, write);
    if (!bytes) return pass_on(bytes);
    description.table_file = add(want->table_file(), std::move(*bytes));
    const std::string sidecar = prefilter_sidecar(description, *table);
    if (want->sidecar) files.push_back({*want->sidecar, sidecar});
    if (Result<void> written = write_outputs(files); !written) return pass_on(written);
    return detail::parse_json(sidecar);
}

} // namespace gonio::cli
