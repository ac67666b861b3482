#include "sheet.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/plot/raster.hpp>
#include <gonio/plot/sheet.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include "../batch.hpp"
#include "../options/light_input.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "picture.hpp"
#include "request.hpp"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr int most_side_px = 16384;
constexpr std::int64_t most_pixels = std::int64_t{1} << 26;

// What a profile's tile is made of. The picture is exposed and linear until all of them go through the display
// transform together.
struct Thumbnail {
    SheetTile tile;
    Ev100 exposure;
};

Result<void> only_of_sheets(const Arguments& arguments) {
    std::string_view other = given_light_option(arguments);
    if (arguments.has("--rig")) other = "--rig";
    for (const std::string_view option : {"--output-dir", "--export"})
        if (arguments.has(option)) other = option;
    if (!other.empty())
        return fail(Failure::usage, fmt::format("a sheet shows profiles as measured: it has no use for {}", other),
                    "leave it out, or render one light without --sheet");
    if (arguments.value("--look").value_or("beauty") != "beauty")
        return fail(Failure::usage, "a sheet shows the look beauty", "render one light without --sheet");
    return {};
}

Result<SheetOptions> read_options(const Arguments& arguments, const PreviewRequest& request) {
    SheetOptions options;
    options.title = arguments.value("--title").value_or("");
    if (arguments.has("--size")) {
        options.picture_width_px = request.render.width;
        options.picture_height_px = request.render.height;
    }
    if (options.picture_width_px < 32 || options.picture_height_px < 32 || options.picture_width_px > 2048 ||
        options.picture_height_px > 2048)
        return fail(Failure::usage, "the picture of a tile has 32 to 2048 pixels a side",
                    "-s is the size of each tile's picture: for example 176x132");
    if (const auto text = arguments.value("--columns")) {
        const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), options.columns);
        if (error != std::errc() || end != text->data() + text->size() || options.columns < 1)
            return fail(Failure::usage, fmt::format("--columns takes a number from 1 up, not '{}'", *text));
    }
    return options;
}

Result<void> fits(std::size_t tiles, const SheetOptions& options) {
    const SheetLayout layout = layout_of(tiles, options);
    if (layout.width_px <= most_side_px && layout.height_px <= most_side_px &&
        std::int64_t{layout.width_px} * layout.height_px <= most_pixels)
        return {};
    return fail(Failure::usage,
                fmt::format("{} profiles make a sheet of {}x{} pixels, which is too large", tiles, layout.width_px,
                            layout.height_px),
                "use a smaller -s, or make several sheets");
}

// Three digits or the whole number, never an exponent below a million.
std::string amount_text(double value) {
    return value >= 100.0 ? rounded(std::round(value)) : rounded(value, 3);
}

std::string beam_text(const Web& web) {
    const auto degrees = [&](double c_deg) -> std::string {
        const std::optional<Radians> beam = spread_angle(web, c_deg, 0.5);
        return beam ? fmt::format("{:.0f}°", to_degrees(*beam)) : std::string("–");
    };
    const std::string across = degrees(90.0);
    const std::string along = degrees(0.0);
    if (along == "–" && across == "–") return "no beam";
    if (across == "–") return fmt::format("beam {} in C0", along);
    if (along == "–") return fmt::format("beam {} in C90", across);
    return along == across ? "beam " + along : fmt::format("beam {} × {}", along, across);
}

// Renders one profile where the stage hangs its light.
Result<Thumbnail> thumbnail_of(const std::string& file, const PreviewRequest& request, const SheetOptions& options,
                               Outcome& outcome) {
    Result<LoadedProfile> loaded = load(file, {});
    if (!loaded) return pass_on(loaded);
    outcome.diagnostics = std::move(loaded->diagnostics);
    const auto web = std::make_shared<const Web>(std::move(loaded->web));
    Thumbnail thumbnail;
    const double flux_lm = flux(*web).value;
    const double peak_cd = peak(*web).intensity.value;
    thumbnail.tile.facts = {
        fmt::format("{} lm   {} cd   {}", amount_text(flux_lm), amount_text(peak_cd), beam_text(*web))};
    thumbnail.tile.polar = polar_thumbnail(*web);
    outcome.report = {{"schema", "gonio.preview/1"}, {"file", file}, {"flux_lm", flux_lm}, {"peak_cd", peak_cd}};
    LightDescription description;
    description.name = file;
    description.shape = ProfileShape{file, web};
    description.position = request.stage.light.position;
    description.direction = request.stage.light.direction;
    description.up = request.stage.light.up;
    Result<Light> light = resolve_light(std::move(description), outcome.diagnostics);
    if (!light) return pass_on(light);
    RenderOptions render_options = request.render;
    render_options.width = options.picture_width_px;
    render_options.height = options.picture_height_px;
    render_options.threads = 1;
    Result<Rendering> rendering = render(request.stage, {&*light, 1}, request.stage.camera, render_options);
    if (!rendering) return pass_on(rendering);
    thumbnail.exposure = request.exposure.of(*rendering);
    thumbnail.tile.picture = std::move(rendering->luminance_nt);
    expose(thumbnail.tile.picture, thumbnail.exposure);
    return thumbnail;
}

// One display transform for all pictures: to set one up costs as much as to apply it.
Result<void> develop_together(std::vector<SheetTile>& tiles, const SheetOptions& options, const PreviewRequest& request,
                              const Console& console) {
    const int height = options.picture_height_px;
    Image all(options.picture_width_px, height * static_cast<int>(tiles.size()), 3);
    for (std::size_t i = 0; i < tiles.size(); ++i)
        paste(tiles[i].picture, all, 0, height * static_cast<int>(i));
    Result<void> shown = show_exposed(all, request, console);
    if (!shown) return shown;
    for (std::size_t i = 0; i < tiles.size(); ++i)
        if (!tiles[i].picture.pixels.empty()) paste(all, tiles[i].picture, 0, -height * static_cast<int>(i));
    return {};
}

std::string reason_of(const Error& error) {
    return error.diagnostics.empty() ? std::string("cannot be shown") : error.diagnostics.back().message;
}

} // namespace

Result<int> preview_sheet(const Arguments& arguments, Console& console) {
    Result<void> fine = only_of_sheets(arguments);
    if (!fine) return Unexpected(fine.error());
    Result<PreviewRequest> request = parse_without_lights(arguments);
    if (!request) return pass_on(request);
    if (!has_pixel(*request->format, media::Pixel::uint8) || has_pixel(*request->format, media::Pixel::float32))
        return fail(Failure::usage, fmt::format("{} holds light, not sheets", request->format->title),
                    "write .png or .jpg");
    Result<SheetOptions> options = read_options(arguments, *request);
    if (!options) return pass_on(options);
    Result<std::vector<std::string>> files = input_files(arguments);
    if (!files) return pass_on(files);
    fine = fits(files->size(), *options);
    if (!fine) return Unexpected(fine.error());
    if (arguments.has("--dry-run")) {
        console.print(fmt::format("{}\n", request->output));
        return 0;
    }
    std::vector<SheetTile> tiles(files->size());
    const ReportKind kind = report_kind(arguments);
    const int status =
        run_batch({*files, "gonio.preview/1", "shown", request->render.threads}, kind, console, [&](std::size_t index) {
            const std::string& file = (*files)[index];
            Outcome outcome;
            Result<Thumbnail> thumbnail = thumbnail_of(file, *request, *options, outcome);
            if (thumbnail) {
                tiles[index] = std::move(thumbnail->tile);
            } else {
                tiles[index].fault = reason_of(thumbnail.error());
                outcome.error = std::move(thumbnail.error());
            }
            tiles[index].name = file == "-" ? "standard input" : file.substr(file.rfind('/') + 1);
            if (kind == ReportKind::words)
                outcome.report = nullptr;
            else if (!outcome.error)
                outcome.report["tile"] = index;
            return outcome;
        });
    fine = develop_together(tiles, *options, *request, console);
    if (!fine) return Unexpected(fine.error());
    Result<std::string> bytes = encode_for_display(sheet(tiles, *options), *request->format);
    if (!bytes) return pass_on(bytes);
    const Result<void> written = write_output(request->output, *bytes);
    if (!written) return Unexpected(written.error());
    return status;
}

} // namespace gonio::cli
