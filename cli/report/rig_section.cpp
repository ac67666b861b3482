#include "rig_section.hpp"

#include <gonio/base/file.hpp>
#include <gonio/base/file_scope.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/transport/receiver_light.hpp>

#include "../facts_text.hpp"
#include "../options/emits_input.hpp"
#include "../options/light_flux.hpp"
#include "../options/profile_input.hpp"
#include "../options/profile_size.hpp"
#include "../options/rig_input.hpp"
#include "../options/sky_input.hpp"
#include "../preview/stage_input.hpp"
#include "diagnostics_list.hpp"
#include "html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <variant>

namespace gonio::cli {

namespace {

constexpr std::size_t most_lights = 200; // rows of the table
constexpr std::size_t longest_name = 200;
constexpr std::size_t most_lights_of_grid = 4096;
constexpr std::size_t grid_side = 9;
constexpr double grid_margin_m = 1.5; // around the lights
constexpr double grid_gap_m = 0.1;    // to a wall

std::string vector_text(const glm::dvec3& vector) {
    return fmt::format("{}, {}, {}", rounded(vector.x, 4), rounded(vector.y, 4), rounded(vector.z, 4));
}

// "sphere", "lamp.ies".
std::string shape_text(const Shape& shape) {
    const auto* const profile = std::get_if<ProfileShape>(&shape);
    return profile != nullptr ? file_name(profile->file) : kind_of(shape);
}

// Nothing where the shape has no such quantity.
std::string flux_text(const Light& light) {
    const std::optional<double> flux = flux_lm(light);
    return flux ? fmt::format("{} lm", amount_text(*flux)) : std::string();
}

std::string intensity_text(const Light& light) {
    if (light.illuminance.value > 0.0) return fmt::format("{} lx", amount_text(light.illuminance.value));
    return fmt::format("{} cd", amount_text(light.intensity.value));
}

std::string lights_table(std::span<const Light> lights) {
    std::string table = "<div class=\"scroll\" role=\"region\" aria-label=\"Lights of the rig\" tabindex=\"0\">\n"
                        "<table><caption>Lights</caption><thead><tr><th scope=\"col\">Name</th>"
                        "<th scope=\"col\">Shape</th><th scope=\"col\">Flux</th><th scope=\"col\">Intensity</th>"
                        "<th scope=\"col\">Position [m]</th><th scope=\"col\">Direction</th>"
                        "<th scope=\"col\">Colour (Rec.709)</th></tr></thead><tbody>\n";
    const std::size_t shown = std::min(lights.size(), most_lights);
    for (const Light& light : lights.first(shown)) {
        const bool is_sun = std::holds_alternative<SunShape>(light.shape);
        const std::string flux = flux_text(light);
        table += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td>"
                             "<td class=\"number\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                             html_start(light.name, longest_name), html_start(shape_text(light.shape), longest_name),
                             flux.empty() ? "–" : flux, intensity_text(light),
                             is_sun ? "–" : vector_text(light.frame.origin), vector_text(-light.frame.z),
                             vector_text(light.color));
    }
    table += "</tbody></table>\n</div>\n";
    if (shown < lights.size()) table += fmt::format("<p>and {} more lights</p>\n", lights.size() - shown);
    return table;
}

// How far it is from a point to what stands there, at most `most_m`.
double room_along(const Stage& stage, const glm::dvec3& from, const glm::dvec3& direction, double most_m) {
    const std::optional<Hit> hit = first_hit(stage, {from, direction});
    return hit ? std::clamp(hit->distance - grid_gap_m, 0.0, most_m) : most_m;
}

// From the first to the last, in equal steps.
std::array<double, grid_side> steps_between(double first, double last) {
    std::array<double, grid_side> steps{};
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = first + static_cast<double>(i) / (grid_side - 1) * (last - first);
    return steps;
}

struct FloorGrid {
    std::array<double, grid_side> x{};
    std::array<double, grid_side> y{};
};

// Below the lights and around them, at z = 0, up to the walls of a room; nothing if no light has a place.
std::optional<FloorGrid> floor_grid(std::span<const Light> lights, const Stage& stage) {
    constexpr double far = std::numeric_limits<double>::infinity();
    glm::dvec3 low(far);
    glm::dvec3 high(-far);
    for (const Light& light : lights) {
        if (std::holds_alternative<SunShape>(light.shape)) continue;
        low = glm::min(low, light.frame.origin);
        high = glm::max(high, light.frame.origin);
    }
    if (!(low.x <= high.x)) return std::nullopt;
    const glm::dvec3 middle = 0.5 * (low + high);
    const auto reach = [&](const glm::dvec3& direction, double half) {
        return room_along(stage, middle, direction, half + grid_margin_m);
    };
    const double half_x = 0.5 * (high.x - low.x);
    const double half_y = 0.5 * (high.y - low.y);
    FloorGrid grid;
    grid.x = steps_between(middle.x - reach({-1.0, 0.0, 0.0}, half_x), middle.x + reach({1.0, 0.0, 0.0}, half_x));
    grid.y = steps_between(middle.y + reach({0.0, 1.0, 0.0}, half_y), middle.y - reach({0.0, -1.0, 0.0}, half_y));
    return grid;
}

// As `gonio probe --indirect` has it: with shadows, the sky and what the stage reflects.
Result<std::vector<double>> illuminance_at(std::span<const Receiver> points, std::span<const Light> lights,
                                           const PreviewRequest& request) {
    ProbeOptions options;
    options.parts = true;
    options.threads = request.render.threads;
    Result<ProbeResult> alone = probe(lights, points, options);
    if (!alone) return pass_on(alone);
    Result<ReceiverLight> on_stage = ReceiverLight::on(request.stage, lights, request.render);
    if (!on_stage) return pass_on(on_stage);
    const ReceiverLight::Shares shares = on_stage->at(points);
    std::vector<double> lux(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        lux[i] = shares.sky_lx[i] + shares.indirect_lx[i];
        for (std::size_t part = i * lights.size(); part < (i + 1) * lights.size(); ++part)
            lux[i] += alone->parts_lx[part] * shares.visible[part];
    }
    return lux;
}

// Points in a solid of the stage, or behind a wall, have no value. Empty where the stage has no such floor.
std::string floor_table(std::span<const Light> lights, const PreviewRequest& request) {
    if (lights.empty() || lights.size() > most_lights_of_grid) return {};
    const std::optional<FloorGrid> grid = floor_grid(lights, request.stage);
    if (!grid) return {};
    std::vector<Receiver> points;
    for (const double y : grid->y)
        for (const double x : grid->x)
            points.push_back({{x, y, 0.0}, {0.0, 0.0, 1.0}});
    const Result<std::vector<double>> lux = illuminance_at(points, lights, request);
    if (!lux) return {};
    std::vector<double> inside;
    std::string rows;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % grid_side == 0)
            rows += fmt::format("<tr><th scope=\"row\">y {}</th>", rounded(grid->y[i / grid_side], 3));
        if (check_receivers(request.stage, {&points[i], 1}).empty()) {
            inside.push_back((*lux)[i]);
            rows += fmt::format("<td class=\"number\">{}</td>", amount_text((*lux)[i]));
        } else {
            rows += "<td class=\"number\">–</td>";
        }
        if (i % grid_side == grid_side - 1) rows += "</tr>\n";
    }
    if (inside.empty()) return {};
    const Spread all = spread(inside);
    std::string table = fmt::format(
        "<div class=\"scroll\" role=\"region\" aria-label=\"Illuminance of the floor\" tabindex=\"0\">\n"
        "<table><caption>Illuminance of the floor in lx, with shadows and reflected light: least {}, mean {}, "
        "greatest {}, least/mean {}</caption><thead><tr><th scope=\"col\">m</th>",
        amount_text(all.least), amount_text(all.mean), amount_text(all.greatest), rounded(all.uniformity(), 2));
    for (const double column : grid->x)
        table += fmt::format("<th scope=\"col\">x {}</th>", rounded(column, 3));
    return table + "</tr></thead><tbody>\n" + rows + "</tbody></table>\n</div>\n";
}

struct LitRig {
    std::vector<Light> lights;
    PreviewRequest request;
};

Result<LitRig> resolve(const std::string& rig_file, LightsInput input, const Arguments& arguments,
                       const PreviewRequest& request, RigPart& part) {
    LitRig lit{{}, request};
    if (Result<void> sized = set_profile_sizes(arguments, ProfileSize::declared, input.rig.lights); !sized)
        return pass_on(sized);
    Result<Stage> stage = named_stage(arguments);
    if (!stage) return pass_on(stage);
    stage = stage_input(arguments, input.rig, *stage, part.diagnostics);
    if (!stage) return pass_on(stage);
    Result<SkyInput> sky = sky_input(arguments, input.rig, part.diagnostics);
    if (!sky) return pass_on(sky);
    if (sky->sun) input.others.push_back(*sky->sun);
    lit.request.render.sky = std::move(sky->sky);
    if (Result<void> emits = read_emits(arguments, *stage, input, part.diagnostics); !emits) return pass_on(emits);
    if (Result<void> any = require_any_light(input, *stage, sky->is_given); !any) return pass_on(any);
    part.files = input.files;
    part.files.push_back(rig_file);
    Result<std::vector<Light>> lights = resolve_input(std::move(input), part.diagnostics, request.render.threads);
    if (!lights) return pass_on(lights);
    lit.lights = std::move(*lights);
    lit.request.stage = std::move(*stage);
    return lit;
}

bool is_profile(const std::string& file) {
    return std::any_of(profile_extensions.begin(), profile_extensions.end(), [&](std::string_view extension) {
        return ends_with_any_case(file, fmt::format(".{}", extension));
    });
}

// The profiles that the rig names, as it names them: relative to its folder.
void keep_profiles(const std::string& folder, std::span<const std::string> files, RigPart& part) {
    for (const std::string& file : files) {
        if (!is_profile(file)) continue;
        Result<std::string> bytes = read_file(file, limit_of_profile(file));
        if (!bytes) continue;
        const bool is_inside = !folder.empty() && file.starts_with(folder + "/");
        part.profiles.emplace_back(is_inside ? file.substr(folder.size() + 1) : file, std::move(*bytes));
    }
}

std::string begin_section(const std::string& rig) {
    return fmt::format("<section class=\"rig\" id=\"rig\" aria-labelledby=\"rig-title\">\n"
                       "<h2 id=\"rig-title\">Rig {}</h2>\n",
                       html(rig));
}

RigPart failed_rig(const std::string& rig, RigPart part, Error error) {
    part.section = begin_section(rig) + "<p>This rig could not be read.</p>\n" +
                   diagnostics_list(error.diagnostics, rig, part.text) + "</section>\n";
    part.report = {{"file", rig}, {"read", false}, {"diagnostics", diagnostics_json(error.diagnostics)}};
    part.error = std::move(error);
    return part;
}

} // namespace

RigPart rig_part(const std::string& rig, const Arguments& arguments, const PreviewRequest& request,
                 const RigPartOptions& options, const Console& console) {
    RigPart part;
    part.files = {rig};
    Result<std::string> text =
        rig == "-" ? read_standard_input(limit("rig-bytes")) : read_file(rig, limit("rig-bytes"));
    if (!text) return failed_rig(rig, std::move(part), std::move(text.error()));
    part.text = std::move(*text);
    const std::string folder = folder_of_file(rig);
    Result<Rig> read = read_rig(part.text, rig, folder, rig_read_options(arguments));
    if (!read) return failed_rig(rig, std::move(part), std::move(read.error()));
    part.diagnostics = read->diagnostics;
    LightsInput input;
    input.rig_file = rig;
    input.rig = std::move(*read);
    input.files = input.rig.files;
    const std::vector<std::string> named = input.files;
    Result<LitRig> lit = resolve(rig, std::move(input), arguments, request, part);
    if (!lit) return failed_rig(rig, std::move(part), std::move(lit.error()));
    if (options.keeps_bytes) keep_profiles(folder, named, part);

    part.section = begin_section(rig);
    if (options.has_picture) {
        const Result<std::string> image = rig_picture(rig, lit->lights, lit->request, console);
        part.section += image ? fmt::format("<figure class=\"picture\">{}<figcaption>On the stage {}</figcaption>"
                                            "</figure>\n",
                                            *image, html(lit->request.stage.name))
                              : fmt::format("<p>No picture: {}</p>\n", html(image.error().diagnostics.back().message));
        part.has_picture = image.has_value();
    }
    part.section += lights_table(lit->lights) + floor_table(lit->lights, lit->request);
    if (!part.diagnostics.empty())
        part.section += "<h3>Diagnostics</h3>\n" + diagnostics_list(part.diagnostics, rig, part.text);
    part.section += "</section>\n";
    part.report = {{"file", rig},
                   {"read", true},
                   {"lights", lit->lights.size()},
                   {"diagnostics", diagnostics_json(part.diagnostics)}};
    return part;
}

} // namespace gonio::cli
