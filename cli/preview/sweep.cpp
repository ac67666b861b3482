#include "sweep.hpp"

#include <gonio/base/atomic_file.hpp>
#include <gonio/base/folder.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/plot/look.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/scene/parameter.hpp>

#include "../json_text.hpp"
#include "../options/output.hpp"
#include "../progress.hpp"
#include "contact_sheet.hpp"
#include "picture.hpp"
#include "request.hpp"
#include "sweep_axis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr PixelSize usual_size{240, 180};
constexpr std::size_t most_cells = 1024;

struct Sweep {
    std::vector<SweepAxis> axes; // the first runs across, the second down

    std::size_t cells() const {
        std::size_t count = 1;
        for (const SweepAxis& axis : axes)
            count *= axis.values.size();
        return count;
    }
    // Which value of an axis a cell has.
    std::size_t value_of(std::size_t cell, std::size_t axis) const {
        return axis == 0 ? cell % axes[0].values.size() : cell / axes[0].values.size();
    }
    std::string label(std::size_t cell) const {
        std::string text;
        for (std::size_t a = 0; a < axes.size(); ++a)
            text += (a > 0 ? ", " : "") + axes[a].label(value_of(cell, a));
        return text;
    }
};

Result<Sweep> read_sweep(const Arguments& arguments) {
    Sweep sweep;
    for (const std::string& text : arguments.values("--sweep")) {
        Result<SweepAxis> axis = parse_sweep_axis(text);
        if (!axis) return pass_on(axis);
        for (const SweepAxis& other : sweep.axes)
            if (other.name() == axis->name())
                return fail(Failure::usage, fmt::format("--sweep {} is given twice", axis->name()));
        sweep.axes.push_back(std::move(*axis));
    }
    if (sweep.axes.size() > 2)
        return fail(Failure::usage, fmt::format("{} sweeps are given", sweep.axes.size()),
                    "one makes a row, two make rows and columns");
    if (sweep.cells() > most_cells)
        return fail(Failure::usage, fmt::format("the sweeps make {} pictures, more than {}", sweep.cells(), most_cells),
                    "ask for fewer values");
    return sweep;
}

// The lights whose name is asked for, or all.
Result<bool> set_lights(const SweepAxis& axis, std::size_t value, std::vector<LightDescription>& lights,
                        Diagnostics& diagnostics) {
    bool has_name = axis.target.empty();
    bool was_set = false;
    for (LightDescription& light : lights) {
        if (!axis.target.empty() && light.name != axis.target) continue;
        has_name = true;
        Result<bool> set = set_parameter(light, axis.key, axis.values[value], diagnostics);
        if (!set) return refused_value(axis, value, set.error());
        was_set |= *set;
    }
    if (was_set) return true;
    if (!has_name) {
        std::vector<std::string_view> names;
        for (const LightDescription& light : lights)
            if (names.size() < 32) names.push_back(light.name);
        return unknown_name("light", axis.target, names, "--sweep " + axis.text);
    }
    const auto of_name = [&](const LightDescription& light) {
        return axis.target.empty() || light.name == axis.target;
    };
    const auto first = std::find_if(lights.begin(), lights.end(), of_name);
    const bool alone = lights.size() == 1 || !axis.target.empty();
    return fail(Failure::usage,
                alone ? fmt::format("--sweep '{}': the light is of the shape {}, which has no {}", axis.text,
                                    kind_of(first->shape), axis.key)
                      : fmt::format("--sweep '{}': no light of the rig has {}", axis.text, axis.key),
                fmt::format("{} has {}", alone ? "it" : fmt::format("'{}'", first->name),
                            fmt::join(parameters_of(*first), ", ")));
}

// The surfaces that are asked for, or what the stage is there to show.
Result<bool> set_materials(const SweepAxis& axis, std::size_t value, Stage& stage) {
    bool was_set = false;
    const Surface* met = nullptr;
    for (Surface& surface : stage.surfaces) {
        if (axis.target.empty() ? !surface.subject : surface.name != axis.target) continue;
        met = &surface;
        Result<bool> set = set_parameter(surface.material, axis.key, axis.values[value]);
        if (!set) return refused_value(axis, value, set.error());
        was_set |= *set;
    }
    if (was_set) return true;
    if (met == nullptr) return unknown_name("surface", axis.target, surface_names(stage), "--sweep " + axis.text);
    return fail(Failure::usage,
                fmt::format("--sweep '{}': the material of '{}' has no {}", axis.text, met->name, axis.key),
                fmt::format("it has {}; --material gives another one", fmt::join(parameters_of(met->material), ", ")));
}

Result<bool> set_view(const SweepAxis& axis, std::size_t value, PreviewRequest& request) {
    const std::string& text = axis.values[value];
    Result<void> set;
    if (axis.key == "exposure") {
        set = read_exposure_value(text, request.exposure);
    } else if (axis.key == "fov") {
        set = read_field_of_view(text, request.stage.camera);
    } else {
        Result<IrradianceMethod> method = parse_irradiance_method(text);
        if (!method) return refused_value(axis, value, method.error());
        request.render.method = *method;
    }
    if (!set) return refused_value(axis, value, set.error());
    return true;
}

template<class Names>
bool contains(const Names& names, std::string_view name) {
    return std::any_of(std::begin(names), std::end(names), [&](const auto& known) { return known.name == name; });
}

// What a cell is rendered from.
Result<PreviewRequest> cell_request(const PreviewRequest& request, const Sweep& sweep, std::size_t cell,
                                    Diagnostics& diagnostics) {
    PreviewRequest of_cell = request;
    for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
        const SweepAxis& axis = sweep.axes[a];
        const std::size_t value = sweep.value_of(cell, a);
        Result<bool> set = false;
        if (contains(light_parameters(), axis.key))
            set = set_lights(axis, value, of_cell.lights.rig.lights, diagnostics);
        else if (contains(material_parameters(), axis.key))
            set = set_materials(axis, value, of_cell.stage);
        else if (axis.target.empty())
            set = set_view(axis, value, of_cell);
        else
            set =
                fail(Failure::usage, fmt::format("--sweep '{}': {} is of no light and no surface", axis.text, axis.key),
                     fmt::format("write {} alone", axis.key));
        if (!set) return pass_on(set);
    }
    return of_cell;
}

// What was said already is not said again for each cell.
void add_new(const Diagnostics& from, Diagnostics& to) {
    for (const Diagnostic& diagnostic : from) {
        const bool known = std::any_of(to.begin(), to.end(), [&](const Diagnostic& other) {
            return other.message == diagnostic.message && other.location.file == diagnostic.location.file;
        });
        if (!known) to.push_back(diagnostic);
    }
}

struct Cell {
    PreviewRequest request;
    std::vector<Light> lights;
    Rendering rendering;
};

class Sweeper {
public:
    Sweeper(PreviewRequest request, Sweep sweep, Console& console)
        : request_(std::move(request)), sweep_(std::move(sweep)), console_(console) {
        exposure_changes_ = std::any_of(sweep_.axes.begin(), sweep_.axes.end(),
                                        [](const SweepAxis& axis) { return axis.key == "exposure"; });
    }

    // Reads every profile once, and tries every value, so that a mistake is told before anything is rendered.
    Result<void> prepare() {
        diagnostics_ = std::move(request_.diagnostics);
        add_new(request_.lights.rig.diagnostics, diagnostics_);
        request_.lights.rig.diagnostics.clear();
        for (LightDescription& light : request_.lights.rig.lights)
            if (Result<void> loaded = load_profile(light.shape, diagnostics_); !loaded) return loaded;
        // A value does not depend on those of the other axis, but for one spot's two angles.
        for (std::size_t cell = 0; cell < sweep_.cells(); ++cell) {
            Diagnostics noticed;
            const Result<PreviewRequest> tried = cell_request(request_, sweep_, cell, noticed);
            if (!tried) return Unexpected(tried.error());
            add_new(noticed, diagnostics_);
        }
        console_.say(diagnostics_);
        return {};
    }

    // Hands over the cells one by one, the shared exposure being that of the first.
    template<class Use>
    Result<void> render_all(int width, int height, Use use) {
        Progress progress(sweep_.cells(), console_.shows_progress());
        for (std::size_t index = 0; index < sweep_.cells(); ++index) {
            progress.show(index, sweep_.label(index));
            Result<Cell> cell = render_cell(index, width, height);
            if (!cell) return pass_on(cell);
            const Ev100 exposure = cell->request.exposure.of(cell->rendering);
            if (!exposure_changes_ && !shared_exposure_) shared_exposure_ = exposure;
            const bool shared = shared_exposure_ && cell->request.exposure.mode == ExposureMode::automatic;
            if (shared) {
                cell->request.exposure.mode = ExposureMode::ev;
                cell->request.exposure.ev = *shared_exposure_;
            }
            note(*cell, index, shared ? *shared_exposure_ : exposure);
            if (Result<void> used = use(std::move(*cell), index); !used) return used;
        }
        progress.clear();
        return {};
    }

    const PreviewRequest& request() const { return request_; }
    const Sweep& sweep() const { return sweep_; }
    Json& cells_json() { return cells_; }
    std::optional<Ev100> shared_exposure() const { return shared_exposure_; }
    const Diagnostics& diagnostics() const { return diagnostics_; }

private:
    Result<Cell> render_cell(std::size_t index, int width, int height) {
        Diagnostics noticed;
        Result<PreviewRequest> of_cell = cell_request(request_, sweep_, index, noticed);
        if (!of_cell) return pass_on(of_cell);
        of_cell->render.width = width;
        of_cell->render.height = height;
        Result<std::vector<Light>> lights = resolve_input(std::move(of_cell->lights), noticed, of_cell->render.threads);
        if (!lights) return pass_on(lights);
        Result<Rendering> rendering = render(of_cell->stage, *lights, of_cell->stage.camera, of_cell->render);
        if (!rendering) return pass_on(rendering);
        Diagnostics fresh = diagnostics_;
        add_new(noticed, fresh);
        console_.say(Diagnostics(fresh.begin() + static_cast<std::ptrdiff_t>(diagnostics_.size()), fresh.end()));
        diagnostics_ = std::move(fresh);
        return Cell{std::move(*of_cell), std::move(*lights), std::move(*rendering)};
    }

    void note(const Cell& cell, std::size_t index, Ev100 exposure) {
        Json values = Json::object();
        for (std::size_t a = 0; a < sweep_.axes.size(); ++a)
            values[sweep_.axes[a].name()] = sweep_.axes[a].values[sweep_.value_of(index, a)];
        cells_.push_back(
            {{"values", std::move(values)}, {"mean_nt", mean_nt(cell.rendering)}, {"exposure_ev100", exposure.value}});
    }

public:
    static double mean_nt(const Rendering& rendering) {
        const Image nt = quantity_image(rendering, PictureQuantity::luminance);
        return std::accumulate(nt.pixels.begin(), nt.pixels.end(), 0.0) / static_cast<double>(nt.pixels.size());
    }

private:
    PreviewRequest request_;
    Sweep sweep_;
    Console& console_;
    bool exposure_changes_ = false;
    std::optional<Ev100> shared_exposure_;
    Json cells_ = Json::array();
    Diagnostics diagnostics_;
};

Result<void> make_sheet(Sweeper& sweeper, const SheetOptions& options, const Console& console) {
    std::vector<SheetTile> tiles(sweeper.sweep().cells());
    Result<void> made =
        sweeper.render_all(options.picture_width_px, options.picture_height_px, [&](Cell cell, std::size_t index) {
            SheetTile& tile = tiles[index];
            // A line for each of two values, which one line has no room for.
            const Sweep& sweep = sweeper.sweep();
            tile.name = sweep.axes[0].label(sweep.value_of(index, 0));
            tile.facts = {sweep.axes.size() == 2
                              ? sweep.axes[1].label(sweep.value_of(index, 1))
                              : fmt::format("mean {} cd/m²", rounded(Sweeper::mean_nt(cell.rendering), 4))};
            const Ev100 exposure = cell.request.exposure.of(cell.rendering);
            tile.picture = std::move(cell.rendering.luminance_nt);
            expose(tile.picture, exposure);
            return Result<void>();
        });
    if (made) made = develop_tiles(tiles, sweeper.request(), console);
    if (!made) return made;
    Result<std::string> bytes = encode_for_display(sheet(tiles, options), *sweeper.request().format);
    if (!bytes) return pass_on(bytes);
    return write_output(sweeper.request().output, *bytes);
}

// "03-cct-2000K.png": in their order by name, and plain enough for every file system.
std::string file_of(const Sweep& sweep, std::size_t cell, const std::string& folder, std::string_view extension) {
    std::string name;
    for (std::size_t a = 0; a < sweep.axes.size(); ++a)
        name += (a > 0 ? "_" : "") + sweep.axes[a].label(sweep.value_of(cell, a));
    for (char& c : name) {
        const bool plain =
            (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '.' || c == '_';
        if (!plain) c = '-';
    }
    const std::size_t digits = std::to_string(sweep.cells() - 1).size();
    return fmt::format("{}/{:0{}}-{}.{}", folder, cell, digits, name.substr(0, 120), extension);
}

Result<std::vector<std::string>> plan_files(const Arguments& arguments, const Sweeper& sweeper) {
    const std::string folder = arguments.value("--output-dir").value_or("");
    if (!is_folder(folder)) return fail(Failure::io, "is no folder", "make it first", folder);
    std::vector<std::string> files;
    for (std::size_t cell = 0; cell < sweeper.sweep().cells(); ++cell) {
        files.push_back(file_of(sweeper.sweep(), cell, folder, sweeper.request().format->extensions.front()));
        if (!arguments.has("--overwrite") && file_exists(files.back()))
            return fail(Failure::usage, "exists already", "add --overwrite to replace it", files.back());
    }
    return files;
}

Result<void> make_files(Sweeper& sweeper, const std::vector<std::string>& files, const Console& console) {
    const RenderOptions& size = sweeper.request().render;
    return sweeper.render_all(size.width, size.height, [&](Cell cell, std::size_t index) -> Result<void> {
        Result<EncodedPicture> picture = encode_picture(std::move(cell.rendering), cell.request, cell.lights, console);
        if (!picture) return pass_on(picture);
        sweeper.cells_json().back()["file"] = files[index];
        return write_output(files[index], picture->bytes);
    });
}

Result<void> fits_sweep(const Arguments& arguments, bool as_files) {
    for (const std::string_view option : {"--sheet", "--compare"})
        if (arguments.has(option))
            return fail(Failure::usage, fmt::format("--sweep and {} are both given", option), "make a picture of each");
    for (const std::string_view option : {"--stats", "--ticks"})
        if (arguments.has(option))
            return fail(Failure::usage, fmt::format("a sweep has no use for {}", option), "leave it out");
    if (as_files) return no_sheet_options(arguments);
    if (arguments.has("--overwrite")) return fail(Failure::usage, "--overwrite is of -O", "name a folder with -O");
    if (arguments.value("--look").value_or("beauty") != "beauty")
        return fail(Failure::usage, "a sheet shows the look beauty", "use -O DIR for pictures of another look");
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
                return fail(Failure::usage, "two sweeps say how many columns there are", "leave --columns out");
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
        Result<std::vector<std::string>> planned = plan_files(arguments, sweeper);
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
    fine = as_files ? make_files(sweeper, files, console) : make_sheet(sweeper, options, console);
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
