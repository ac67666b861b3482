#include "sweep.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/glare.hpp>

#include "../json_text.hpp"
#include "../options/output.hpp"
#include "contact_sheet.hpp"
#include "request.hpp"
#include "sweep_files.hpp"
#include "sweeper.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr PixelSize usual_size{240, 180};

Result<void> make_sheet(Sweeper& sweeper, const SheetOptions& options, const Console& console) {
    std::vector<SheetTile> tiles(sweeper.sweep().cells());
    std::vector<TileScene> scenes(tiles.size());
    Result<void> made =
        sweeper.render_all(options.picture_width_px, options.picture_height_px, [&](Cell cell, std::size_t index) {
            SheetTile& tile = tiles[index];
            // With two axes each value gets its own line, because both do not fit on one.
            const Sweep& sweep = sweeper.sweep();
            tile.name = sweep.axes[0].label(sweep.value_of(index, 0));
            tile.facts = {sweep.axes.size() == 2 ? sweep.axes[1].label(sweep.value_of(index, 1))
                                                 : fmt::format("mean {} cd/m²", rounded(mean_nt(cell.rendering), 4))};
            const Ev100 exposure = cell.request.exposure.of(cell.rendering, cell.request.render.threads);
            tile.picture = std::move(cell.rendering.luminance_nt);
            if (cell.request.exposure.glare)
                show_points(tile.picture, cell.request.stage, cell.lights, cell.request.stage.camera);
            expose(tile.picture, exposure);
            scenes[index] = {std::move(cell.rendering.partial_lights), cell.request.stage.camera};
            expose(scenes[index].lights, exposure);
            return Result<void>();
        });
    if (made) made = develop_tiles(tiles, std::move(scenes), sweeper.request(), console);
    if (!made) return made;
    Result<std::string> bytes = encode_for_display(sheet(tiles, options), *sweeper.request().format, true);
    if (!bytes) return pass_on(bytes);
    return write_output(sweeper.request().output, *bytes);
}

Result<void> fits_sweep(const Arguments& arguments, bool as_files) {
    for (const std::string_view option : {"--sheet", "--compare"})
        if (arguments.has(option))
            return fail("USE0107", fmt::format("--sweep and {} are both given", option), "make a picture of each");
    for (const std::string_view option : {"--stats", "--ticks"})
        if (arguments.has(option))
            return fail("USE0107", fmt::format("{} does not apply to a sweep", option), "leave it out");
    if (as_files) return no_sheet_options(arguments);
    if (arguments.value("--look").value_or("beauty") != "beauty")
        return fail("USE0107", "a sheet uses the display mode beauty",
                    "use -O DIR for pictures of another display mode");
    return {};
}

Json sweep_json(Sweeper& sweeper, const SheetLayout& layout, int width, int height, bool as_files) {
    const PreviewRequest& request = sweeper.request();
    Json report{{"schema", "gonio.preview/1"}};
    if (!as_files) report["output"] = request.output;
    report["width"] = width;
    report["height"] = height;
    if (!as_files) {
        report["columns"] = layout.columns;
        report["rows"] = layout.rows;
    }
    report["stage"] = request.stage.name;
    if (sweeper.shared_exposure()) report["exposure_ev100"] = sweeper.shared_exposure()->value;
    report["sweeps"] = Json::array();
    for (const SweepAxis& axis : sweeper.sweep().axes)
        report["sweeps"].push_back({{"parameter", axis.name()}, {"values", axis.values}});
    report["cells"] = std::move(sweeper.cells_json());
    report["lights"] = request.lights.rig.lights.size();
    report["diagnostics"] = diagnostics_json(sweeper.diagnostics());
    return report;
}

} // namespace

Result<int> preview_sweep(const Arguments& arguments, Console& console) {
    const bool as_files = arguments.has("--output-dir");
    Result<void> fine = fits_sweep(arguments, as_files);
    if (!fine) return Unexpected(fine.error());
    Result<Sweep> sweep = read_sweep(arguments);
    if (!sweep) return pass_on(sweep);
    Result<PreviewRequest> request = parse_preview(arguments);
    if (!request) return pass_on(request);
    SheetOptions options;
    if (!as_files) {
        fine = holds_sheets(*request->format, "write .png or .jpg, or use -O DIR for a file of each");
        if (!fine) return Unexpected(fine.error());
        Result<SheetOptions> read = read_sheet_options(arguments, *request, usual_size);
        if (!read) return pass_on(read);
        options = std::move(*read);
        options.polar = false;
        if (sweep->axes.size() == 2) {
            if (arguments.has("--columns"))
                return fail("USE0107", "two sweeps set the number of columns", "leave --columns out");
            options.columns = static_cast<int>(sweep->axes[0].values.size());
        }
        fine = fits_sheet(sweep->cells(), options, "pictures");
        if (!fine) return Unexpected(fine.error());
    }
    Sweeper sweeper(std::move(*request), std::move(*sweep), console);
    fine = sweeper.prepare();
    if (!fine) return Unexpected(fine.error());
    std::vector<std::string> files;
    if (as_files) {
        Result<std::vector<std::string>> planned = plan_sweep_files(arguments, sweeper);
        if (!planned) return pass_on(planned);
        files = std::move(*planned);
    } else {
        files.push_back(sweeper.request().output);
    }
    if (arguments.has("--dry-run")) {
        for (const std::string& file : files)
            console.print(file + "\n");
        return 0;
    }
    fine = as_files ? make_sweep_files(sweeper, files, console) : make_sheet(sweeper, options, console);
    if (!fine) return Unexpected(fine.error());
    if (arguments.has("--json") || arguments.has("--jsonl")) {
        const RenderOptions& size = sweeper.request().render;
        console.print(dump(sweep_json(sweeper, layout_of(sweeper.sweep().cells(), options),
                                      as_files ? size.width : options.picture_width_px,
                                      as_files ? size.height : options.picture_height_px, as_files),
                           arguments.has("--jsonl") ? -1 : 2));
    }
    return 0;
}

} // namespace gonio::cli
