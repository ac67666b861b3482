#include "sweeper.hpp"

#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/plot/look.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/relit.hpp>
#include <gonio/scene/parameter.hpp>

#include "../progress.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string_view>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::size_t most_cells = limit("sweep-pictures").value;

// Sets the lights of the axis's target name, or all lights.
Result<bool> set_lights(const SweepAxis& axis, std::size_t value, std::vector<LightDescription>& lights,
                        Diagnostics& diagnostics) {
    if (lights.empty())
        return fail("USE0103", fmt::format("--sweep '{}': there is no light", axis.text),
                    "a sky, its sun and surfaces that emit cannot be swept: add a light");
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
    return fail("USE0103",
                alone ? fmt::format("--sweep '{}': the light has the shape {}, which has no {}", axis.text,
                                    kind_of(first->shape), axis.key)
                      : fmt::format("--sweep '{}': no light of the rig has {}", axis.text, axis.key),
                fmt::format("{} has {}", alone ? "it" : fmt::format("'{}'", first->name),
                            fmt::join(parameters_of(*first), ", ")));
}

// Sets the surfaces of the axis's target name, or the subjects of the stage.
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
    return fail("USE0103", fmt::format("--sweep '{}': the material of '{}' has no {}", axis.text, met->name, axis.key),
                fmt::format("it has {}; --material sets another one", fmt::join(parameters_of(met->material), ", ")));
}

Result<bool> set_view(const SweepAxis& axis, std::size_t value, PreviewRequest& request) {
    const std::string& text = axis.values[value];
    Result<void> set;
    if (axis.key == "exposure") {
        set = read_exposure_value(text, request.exposure);
    } else if (axis.key == "fov") {
        set = read_field_of_view(text, request.stage.camera);
    } else {
        Result<PictureMethod> method = parse_picture_method(text);
        if (method && has_local_probe(method->surroundings))
            method = fail("USE0107", fmt::format("the method {} is for one picture", text),
                          "--compare shows it beside others");
        if (method)
            if (Result<void> lit = check_sky({&*method, 1}, request.render.sky); !lit) method = pass_on(lit);
        if (!method) return refused_value(axis, value, method.error());
        set_method(request.render, *method);
    }
    if (!set) return refused_value(axis, value, set.error());
    return true;
}

template<class Names>
bool contains(const Names& names, std::string_view name) {
    return std::any_of(std::begin(names), std::end(names), [&](const auto& known) { return known.name == name; });
}

// The request that renders a cell.
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
            set = fail("USE0107",
                       fmt::format("--sweep '{}': {} does not belong to a light or a surface", axis.text, axis.key),
                       fmt::format("write {} alone", axis.key));
        if (!set) return pass_on(set);
    }
    return of_cell;
}

// A diagnostic that was already reported is not repeated for each cell.
void add_new(const Diagnostics& from, Diagnostics& to) {
    for (const Diagnostic& diagnostic : from) {
        const bool known = std::any_of(to.begin(), to.end(), [&](const Diagnostic& other) {
            return other.message == diagnostic.message && other.location.file == diagnostic.location.file;
        });
        if (!known) to.push_back(diagnostic);
    }
}

} // namespace

std::size_t Sweep::cells() const {
    std::size_t count = 1;
    for (const SweepAxis& axis : axes)
        count *= axis.values.size();
    return count;
}

std::size_t Sweep::value_of(std::size_t cell, std::size_t axis) const {
    return axis == 0 ? cell % axes[0].values.size() : cell / axes[0].values.size();
}

std::string Sweep::label(std::size_t cell) const {
    std::string text;
    for (std::size_t a = 0; a < axes.size(); ++a)
        text += (a > 0 ? ", " : "") + axes[a].label(value_of(cell, a));
    return text;
}

Result<Sweep> read_sweep(const Arguments& arguments) {
    Sweep sweep;
    for (const std::string& text : arguments.values("--sweep")) {
        Result<SweepAxis> axis = parse_sweep_axis(text);
        if (!axis) return pass_on(axis);
        for (const SweepAxis& other : sweep.axes)
            if (other.name() == axis->name())
                return fail("USE0107", fmt::format("--sweep {} is given twice", axis->name()));
        sweep.axes.push_back(std::move(*axis));
    }
    if (sweep.axes.size() > 2)
        return fail("USE0107", fmt::format("{} sweeps are given", sweep.axes.size()),
                    "one makes a row, two make rows and columns");
    if (sweep.cells() > most_cells)
        return fail(
            "USE0106",
            fmt::format("the sweeps make {} pictures, more than {}", sweep.cells(), to_text(limit("sweep-pictures"))),
            "ask for fewer values");
    return sweep;
}

double mean_nt(const Rendering& rendering) {
    const Image nt = quantity_image(rendering, PictureQuantity::luminance);
    return std::accumulate(nt.pixels.begin(), nt.pixels.end(), 0.0) / static_cast<double>(nt.pixels.size());
}

Sweeper::Sweeper(PreviewRequest request, Sweep sweep, Console& console)
    : request_(std::move(request)), sweep_(std::move(sweep)), console_(console) {
    exposure_changes_ = std::any_of(sweep_.axes.begin(), sweep_.axes.end(),
                                    [](const SweepAxis& axis) { return axis.key == "exposure"; });
}

Result<void> Sweeper::prepare() {
    diagnostics_ = std::move(request_.diagnostics);
    add_new(request_.lights.rig.diagnostics, diagnostics_);
    request_.lights.rig.diagnostics.clear();
    for (LightDescription& light : request_.lights.rig.lights)
        if (Result<void> loaded = load_profile(light.shape, diagnostics_); !loaded) return loaded;
    // Every cell is tried: a value does not depend on the other axis, except for the two angles of a spot.
    for (std::size_t cell = 0; cell < sweep_.cells(); ++cell) {
        Diagnostics noticed;
        const Result<PreviewRequest> tried = cell_request(request_, sweep_, cell, noticed);
        if (!tried) return Unexpected(tried.error());
        add_new(noticed, diagnostics_);
    }
    console_.say(diagnostics_);
    return {};
}

Result<void> Sweeper::render_all(int width, int height, const std::function<Result<void>(Cell, std::size_t)>& use) {
    Progress progress(sweep_.cells(), console_.shows_progress());
    for (std::size_t index = 0; index < sweep_.cells(); ++index) {
        progress.show(index, sweep_.label(index));
        Result<Cell> cell = render_cell(index, width, height);
        if (!cell) return pass_on(cell);
        const Ev100 exposure = cell->request.exposure.of(cell->rendering, cell->request.render.threads);
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

Result<Cell> Sweeper::render_cell(std::size_t index, int width, int height) {
    Diagnostics noticed;
    Result<PreviewRequest> of_cell = cell_request(request_, sweep_, index, noticed);
    if (!of_cell) return pass_on(of_cell);
    of_cell->render.width = width;
    of_cell->render.height = height;
    Result<std::vector<Light>> lights = resolve_input(std::move(of_cell->lights), noticed, of_cell->render.threads);
    if (!lights) return pass_on(lights);
    Result<Rendering> rendering = picture_of(index, *of_cell, *lights);
    if (!rendering) return pass_on(rendering);
    Diagnostics fresh = diagnostics_;
    add_new(noticed, fresh);
    console_.say(Diagnostics(fresh.begin() + static_cast<std::ptrdiff_t>(diagnostics_.size()), fresh.end()));
    diagnostics_ = std::move(fresh);
    return Cell{std::move(*of_cell), std::move(*lights), std::move(*rendering)};
}

// Rendered, unless it follows from the picture that was kept.
Result<Rendering> Sweeper::picture_of(std::size_t index, const PreviewRequest& request,
                                      const std::vector<Light>& lights) {
    if (kept_ && follows(index, kept_->cell))
        if (std::optional<Rendering> again = relit(kept_->rendering, kept_->lights, lights)) return *std::move(again);
    RenderOptions options = request.render;
    options.known = known_;
    Result<Rendering> rendering = render(request.stage, lights, request.stage.camera, options);
    if (!rendering) return rendering;
    known_ = rendering->indirect;
    kept_.reset();
    if (is_followed(index)) kept_ = Kept{index, lights, *rendering};
    return rendering;
}

// Whether two cells differ in what relit() can change, or in nothing that is rendered.
bool Sweeper::follows(std::size_t cell, std::size_t from) const {
    if (!request_.render.sky.is_dark()) return false;
    for (std::size_t a = 0; a < sweep_.axes.size(); ++a) {
        if (sweep_.value_of(cell, a) == sweep_.value_of(from, a)) continue;
        const std::string& key = sweep_.axes[a].key;
        const bool is_factor =
            std::any_of(light_parameters().begin(), light_parameters().end(),
                        [&](const ParameterName& parameter) { return parameter.is_factor && parameter.name == key; });
        if (!is_factor && key != "exposure") return false;
    }
    return true;
}

// Only such pictures are worth their memory.
bool Sweeper::is_followed(std::size_t cell) const {
    return cell + 1 < sweep_.cells() && follows(cell + 1, cell);
}

void Sweeper::note(const Cell& cell, std::size_t index, Ev100 exposure) {
    Json values = Json::object();
    for (std::size_t a = 0; a < sweep_.axes.size(); ++a)
        values[sweep_.axes[a].name()] = sweep_.axes[a].values[sweep_.value_of(index, a)];
    cells_.push_back(
        {{"values", std::move(values)}, {"mean_nt", mean_nt(cell.rendering)}, {"exposure_ev100", exposure.value}});
}

} // namespace gonio::cli
