#include "profile_sheet.hpp"

#include <gonio/base/path.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/plot/sheet.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include "../batch.hpp"
#include "../facts_text.hpp"
#include "../options/files_in_use.hpp"
#include "../options/light_input.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "contact_sheet.hpp"
#include "profile_stages.hpp"
#include "request.hpp"
#include "stage_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gonio::cli {

namespace {

constexpr PixelSize usual_size{176, 132};

// The contents of a profile's tile. The picture is exposed and linear until all tiles go through the display transform
// together.
struct Thumbnail {
    SheetTile tile;
    Ev100 exposure;
};

Result<void> only_of_sheets(const Arguments& arguments) {
    std::string_view other = given_light_option(arguments);
    if (arguments.has("--rig")) other = "--rig";
    for (const std::string_view option : {"--output-dir", "--glare"})
        if (arguments.has(option)) other = option;
    if (!other.empty())
        return fail("USE0107", fmt::format("a sheet shows profiles as measured: {} does not apply", other),
                    "leave it out, or render one light without --sheet");
    if (arguments.has("--compare"))
        return fail("USE0107", "--sheet and --compare are both given", "make a picture of each");
    if (arguments.value("--look").value_or("beauty") != "beauty")
        return fail("USE0107", "a sheet uses the display mode beauty", "render one light without --sheet");
    return {};
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

// Renders one profile, of the size that `size` says, at the position of the stage's light.
Result<Thumbnail> thumbnail_of(const std::string& file, const ProfileShape& size, const PreviewRequest& request,
                               const SheetOptions& options, ProfileStages& stages, Outcome& outcome) {
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
    ProfileShape shape{file, web, size.size, size.given, std::make_shared<const Opening>(opening_of(loaded->profile))};
    RenderOptions render_options = request.render;
    render_options.width = options.picture_width_px;
    render_options.height = options.picture_height_px;
    render_options.threads = 1;
    Result<ProfileStages::Shown> shown = stages.show(file, std::move(shape), render_options, outcome.diagnostics);
    if (!shown) return pass_on(shown);
    Rendering& rendering = shown->rendering;
    thumbnail.exposure = request.exposure.of(rendering, render_options.threads);
    thumbnail.tile.picture = std::move(rendering.luminance_nt);
    expose(thumbnail.tile.picture, thumbnail.exposure);
    return thumbnail;
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
    fine = holds_sheets(*request->format);
    if (!fine) return Unexpected(fine.error());
    Result<SheetOptions> options = read_sheet_options(arguments, *request, usual_size);
    if (!options) return pass_on(options);
    Result<std::vector<std::string>> files = input_files(arguments);
    if (!files) return pass_on(files);
    fine = check_outputs(*files, {&request->output, 1});
    if (!fine) return Unexpected(fine.error());
    fine = fits_sheet(files->size(), *options, "profiles");
    if (!fine) return Unexpected(fine.error());
    if (arguments.has("--dry-run")) {
        console.print(fmt::format("{}\n", request->output));
        return 0;
    }
    const bool stage_is_chosen = std::any_of(preview_stage_options.begin(), preview_stage_options.end(),
                                             [&](const Option& option) { return arguments.has(option.names); });
    LightDescription sized;
    sized.shape = ProfileShape{};
    fine = set_profile_sizes(arguments, ProfileSize::declared, {&sized, 1});
    if (!fine) return Unexpected(fine.error());
    ProfileStages stages(request->stage, stage_is_chosen);
    std::vector<SheetTile> tiles(files->size());
    const ReportKind kind = report_kind(arguments);
    const int status =
        run_batch({*files, "gonio.preview/1", "shown", request->render.threads}, kind, console, [&](std::size_t index) {
            const std::string& file = (*files)[index];
            Outcome outcome;
            tiles[index].fault = "not shown"; // kept if thumbnail_of throws
            Result<Thumbnail> thumbnail =
                thumbnail_of(file, std::get<ProfileShape>(sized.shape), *request, *options, stages, outcome);
            if (thumbnail) {
                tiles[index] = std::move(thumbnail->tile);
            } else {
                tiles[index].fault = reason_of(thumbnail.error());
                outcome.error = std::move(thumbnail.error());
            }
            tiles[index].name = file == "-" ? "stdin" : file_name(file);
            if (kind == ReportKind::words)
                outcome.report = nullptr;
            else if (!outcome.error)
                outcome.report["tile"] = index;
            return outcome;
        });
    // Profiles are points, which no pixel shows.
    fine = develop_tiles(tiles, std::vector<TileScene>(tiles.size()), *request, console);
    if (!fine) return Unexpected(fine.error());
    Result<std::string> bytes = encode_for_display(sheet(tiles, *options), *request->format, true);
    if (!bytes) return pass_on(bytes);
    const Result<void> written = write_output(request->output, *bytes);
    if (!written) return Unexpected(written.error());
    return status;
}

} // namespace gonio::cli
