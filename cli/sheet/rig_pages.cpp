#include "rig_pages.hpp"

#include <gonio/base/path.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/figures/glare.hpp>
#include <gonio/figures/room_plan.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/receiver_grid.hpp>
#include <gonio/transport/receiver_light.hpp>
#include <gonio/web/profile_header.hpp>

#include "../facts_text.hpp"
#include "../options/glare_text.hpp"
#include "../options/light_flux.hpp"
#include "../options/points_input.hpp"
#include "../options/profile_input.hpp"
#include "../options/profile_size.hpp"
#include "../options/rig_input.hpp"
#include "../preview/stage_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <variant>

namespace gonio::cli {

namespace {

constexpr std::array<std::string_view, 4> views{"+X", "-X", "+Y", "-Y"};

struct LitRoom {
    Stage stage;
    std::vector<Light> lights;
    Points points;
    FloorArea area;
    std::vector<double> illuminance_lx;
    std::array<GlareRating, 4> glare; // of observers at the walls −X, +X, −Y, +Y
};

Result<void> light_up(LitRoom& room, const RigPageOptions& options) {
    LightingOptions lighting;
    lighting.bounces = all_bounces;
    lighting.threads = options.threads;
    ProbeOptions exact;
    exact.parts = true;
    exact.threads = options.threads;
    Result<ReceiverLight> on_stage = ReceiverLight::on(room.stage, room.lights, lighting);
    if (!on_stage) return pass_on(on_stage);
    const std::vector<Receiver>& receivers = room.points.receivers;
    Result<ProbeResult> alone = probe(room.lights, receivers, exact);
    if (!alone) return pass_on(alone);
    const ReceiverLight::Shares shares = on_stage->at(receivers);
    const std::size_t lights = room.lights.size();
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        double lux = shares.sky_lx[i] + shares.indirect_lx[i];
        for (std::size_t part = i * lights; part < (i + 1) * lights; ++part)
            lux += alone->parts_lx[part] * shares.visible[part];
        room.illuminance_lx.push_back(lux);
    }
    const std::array<Observer, 4> observers = wall_observers(room.area, options.eye_height_m);
    std::vector<Receiver> eyes;
    for (const Observer& observer : observers)
        eyes.push_back({observer.eye, observer.view});
    const ReceiverLight::Shares seen = on_stage->at(eyes);
    for (std::size_t i = 0; i < observers.size(); ++i)
        room.glare.at(i) =
            glare_rating(room.lights, observers.at(i), std::span(seen.visible).subspan(i * lights, lights),
                         seen.sky_lx[i] + seen.indirect_lx[i]);
    return {};
}

// Watts and name of a luminaire, from its profile.
void add_profile(const std::string& file, RoomSheetLuminaire& luminaire) {
    const Result<Profile> profile = read_profile_file(file);
    if (!profile) return;
    const ProfileHeader header = header_of(*profile);
    if (header.input_watts > 0.0) luminaire.input_w = header.input_watts;
    const std::string_view name = luminaire_name(header);
    if (!name.empty()) luminaire.name = fmt::format("{} ({})", name, luminaire.name);
}

// "A", "B", …, "Z", "27"
std::string letter_of(std::size_t kind) {
    return kind < 26 ? std::string(1, static_cast<char>('A' + kind)) : fmt::format("{}", kind + 1);
}

// Lights of one shape, amount and height are of one kind.
void add_luminaires(const LitRoom& room, RoomSheetContent& content) {
    std::map<std::string, std::size_t> kinds;
    std::vector<std::string> files;
    for (const Light& light : room.lights) {
        const auto* const profile = std::get_if<ProfileShape>(&light.shape);
        const std::string shape = profile != nullptr ? profile->file : std::string(kind_of(light.shape));
        const std::string mounting = std::holds_alternative<SunShape>(light.shape)
                                         ? std::string("sun")
                                         : fmt::format("at {} m", rounded(light.frame.origin.z, 3));
        const std::optional<double> lumens = flux_lm(light);
        const auto [kind, is_new] =
            kinds.emplace(fmt::format("{}\n{}\n{}", shape, mounting, rounded(lumens.value_or(0.0), 6)), files.size());
        if (is_new) {
            RoomSheetLuminaire luminaire;
            luminaire.name = profile != nullptr ? file_name(profile->file) : shape;
            luminaire.mounting = mounting;
            luminaire.flux_lm = lumens;
            if (profile != nullptr) add_profile(profile->file, luminaire);
            content.luminaires.push_back(std::move(luminaire));
            files.push_back(shape);
        }
        RoomSheetLuminaire& luminaire = content.luminaires[kind->second];
        ++luminaire.count;
        if (std::holds_alternative<SunShape>(light.shape)) continue;
        content.plot.marks.push_back({light.frame.origin.x, light.frame.origin.y});
        content.plot.mark_letters.push_back(letter_of(kind->second));
    }
    if (content.luminaires.size() < 2)
        content.plot.mark_letters.clear();
    else
        for (std::size_t i = 0; i < content.luminaires.size(); ++i)
            content.luminaires[i].letter = letter_of(i);
}

// What the list states of all, where every luminaire has it.
std::optional<double> watts_of(const std::vector<RoomSheetLuminaire>& luminaires) {
    double watts = 0.0;
    for (const RoomSheetLuminaire& each : luminaires) {
        if (!each.input_w) return std::nullopt;
        watts += *each.input_w * static_cast<double>(each.count);
    }
    return watts;
}

void judge(TaskInput& task, const LitRoom& room, const Spread& lux, const RigPageOptions& options) {
    ReachedLight reached;
    reached.mean_lx = lux.mean;
    reached.least_lx = lux.least;
    reached.uniformity = lux.uniformity();
    double worst = -std::numeric_limits<double>::infinity();
    bool is_rated = true;
    for (const GlareRating& rating : room.glare) {
        is_rated = is_rated && rating.ugr;
        worst = std::max(worst, rating.ugr.value_or(worst));
    }
    if (is_rated) reached.ugr = worst;
    task.verdicts = verdicts(task.task, reached, options.task->raised);
}

RoomSheetContent content_of(const std::string& file, const LitRoom& room, const RigPageOptions& options,
                            std::optional<TaskInput>& task) {
    RoomSheetContent content;
    content.title = room.stage.name.empty() ? file_name(file) : room.stage.name;
    content.flux_head = "flux in use"; // dimmed and maintained
    content.glare_rule = "CIE 117:1995, of the light in use";
    content.source = file == "-" ? "stdin" : file_name(file);
    const ReceiverGrid& grid = *room.points.grid;
    add_luminaires(room, content);
    const Spread lux = spread(room.illuminance_lx);
    const glm::dvec3 size = room.area.high - room.area.low;
    const double area_m2 = size.x * size.y;
    auto& facts = content.facts;
    facts.emplace_back("Room", fmt::format("{} m × {} m between the walls", rounded(size.x, 4), rounded(size.y, 4)));
    facts.emplace_back("Luminaires", fmt::format("{}", room.lights.size()));
    facts.emplace_back("Mean illuminance", fmt::format("{} lx, reflected light included", amount_text(lux.mean)));
    facts.emplace_back("Range", fmt::format("{} to {} lx", amount_text(lux.least), amount_text(lux.greatest)));
    facts.emplace_back("Uniformity",
                       fmt::format("U0 {}, Ud {}", rounded(lux.uniformity(), 2), rounded(lux.diversity(), 2)));
    facts.emplace_back("Working plane",
                       fmt::format("{} m high, {} m off the walls, {} × {} points", rounded(options.plane_height_m, 4),
                                   rounded(options.wall_zone_m, 4), grid.columns, grid.rows));
    if (const std::optional<double> watts = watts_of(content.luminaires))
        facts.emplace_back("Power",
                           fmt::format("{} W, {} W/m², {} W/m² per 100 lx", rounded(*watts, 4),
                                       rounded(*watts / area_m2, 3), rounded(100.0 * *watts / area_m2 / lux.mean, 3)));
    for (std::size_t i = 0; i < views.size(); ++i)
        content.glare.emplace_back(fmt::format("Towards {}", views.at(i)), ugr_text(room.glare.at(i)));
    if (task) {
        judge(*task, room, lux, options);
        content.task = fmt::format("{}, {}", task->task.name, task->task.rule);
        content.verdicts = task->verdicts;
    }
    GridPlot& plot = content.plot;
    plot.left_m = grid.corner.x;
    plot.low_m = grid.corner.y;
    plot.width_m = grid.u.x;
    plot.height_m = grid.v.y;
    plot.columns = grid.columns;
    plot.rows = grid.rows;
    plot.values = room.illuminance_lx;
    plot.margin_m = options.wall_zone_m;
    plot.outline = {{room.area.low.x, room.area.low.y},
                    {room.area.high.x, room.area.low.y},
                    {room.area.high.x, room.area.high.y},
                    {room.area.low.x, room.area.high.y}};
    plot.title = fmt::format("Illuminance at {} m in lx", rounded(options.plane_height_m, 4));
    return content;
}

} // namespace

Result<RigPageOptions> rig_page_options_of(const Arguments& arguments) {
    RigPageOptions options;
    struct Length {
        std::string_view option;
        double RigPageOptions::*to;
    };
    constexpr std::array lengths{Length{"--plane", &RigPageOptions::plane_height_m},
                                 Length{"--wall-zone", &RigPageOptions::wall_zone_m},
                                 Length{"--eye", &RigPageOptions::eye_height_m}};
    for (const Length& length : lengths)
        if (const auto text = arguments.value(length.option)) {
            Result<double> meters = parse_amount(*text, Dimension::length, length.option);
            if (!meters) return pass_on(meters);
            if (!(*meters >= 0.0)) return fail("USE0106", fmt::format("{} takes a length of 0 or more", length.option));
            options.*length.to = *meters;
        }
    Result<std::optional<TaskInput>> task = task_input(arguments);
    if (!task) return pass_on(task);
    options.task = std::move(*task);
    return options;
}

Result<RigPage> rig_page(const std::string& file, const Arguments& arguments, const RigPageOptions& options,
                         PaperSize paper, Diagnostics& diagnostics) {
    Result<LightsInput> input = rig_input(file, arguments);
    if (!input) return pass_on(input);
    diagnostics = input->rig.diagnostics;
    RigPage page;
    page.files = input->files;
    if (!input->rig.stage)
        return fail(Failure::usage, "the rig has no stage, so there is no room to draw",
                    "'gonio room … -o room.json' writes a rig with its room", file);
    if (Result<void> sized = set_profile_sizes(arguments, ProfileSize::declared, input->rig.lights); !sized)
        return pass_on(sized);
    LitRoom room;
    Result<Stage> stage = named_stage(arguments);
    if (stage) stage = stage_input(arguments, input->rig, *stage, diagnostics);
    if (!stage) return pass_on(stage);
    room.stage = std::move(*stage);
    room.points.workplane = Workplane{options.plane_height_m, options.wall_zone_m, {}};
    room.points.receivers.emplace_back();
    if (Result<void> placed = place_on(room.stage, room.points); !placed) {
        error_hint(placed.error(), "a sheet is of a room: 'gonio room … -o room.json' writes a rig with one");
        return pass_on(placed);
    }
    room.area = area_between_walls(room.stage, options.plane_height_m).value_or(FloorArea());
    Result<std::vector<Light>> lights = resolve_input(std::move(*input), diagnostics, options.threads);
    if (!lights) return pass_on(lights);
    room.lights = std::move(*lights);
    if (room.lights.empty()) return fail(Failure::usage, "the rig has no lights", {}, file);
    if (Result<void> lit = light_up(room, options); !lit) return pass_on(lit);
    std::optional<TaskInput> task = options.task;
    const RoomSheetContent content = content_of(file, room, options, task);
    Result<RoomSheet> sheet = room_sheet(content, paper);
    if (!sheet) return pass_on(sheet);
    page.title = content.title;
    page.sheet = std::move(*sheet);
    page.has_failed = task && task->has_failed();
    return page;
}

} // namespace gonio::cli
