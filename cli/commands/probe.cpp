#include <gonio/transport/receiver_light.hpp>

#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/light_input.hpp"
#include "../options/rig_input.hpp"
#include "../probe/probe_report.hpp"
#include "../probe/request.hpp"
#include "../stopwatch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array groups{OptionGroup{"lights", rig_options},
                            light_group,
                            OptionGroup{"profiles", probe_profile_options},
                            points_group,
                            OptionGroup{"evaluation", probe_options},
                            OptionGroup{"surroundings", probe_stage_options},
                            task_group,
                            OptionGroup{"report", probe_report_options},
                            light_common_group};
constexpr std::array examples{
    Example{"gonio probe --rig room.json --at 0,0,0.8 --normal 0,0,1", "lux on a table, in total and from each light"},
    Example{"gonio probe lamp.ies --stage room --indirect --at 0.8,0.6,0.75",
            "lux on the box of a room, with what walls and ceiling reflect"},
    Example{"gonio probe --sky daylight:place=52.52/13.405,time=2026-06-21T12:00+02:00 --at 0,0,0 --normal 0,-1,0",
            "the sun and the sky on a facade to the south"},
    Example{"gonio probe lamp.ies --position 0,0,2.5 --grid -2,-2,0:4,0,0:0,4,0:21x21",
            "min, mean, max and uniformity on a floor"},
    Example{"gonio probe --rig room.json --workplane 75cm --indirect -o plan.svg",
            "the working plane of the rig's room, with a number in each cell of its plan"},
    Example{"gonio probe --rig room.json --workplane 75cm --indirect --task office.writing",
            "whether it is bright and uniform enough for a task"},
    Example{"gonio probe --rig room.json --workplane 1.2m --quantity cylindrical --indirect",
            "how well faces are lit there"},
    Example{"gonio probe --rig room.json --indirect --at 0,-2,1.2 --normal 0,1,0 --glare",
            "UGR of an observer who looks along Y, and the share of each luminaire"},
    Example{"gonio probe --shape rect:w=60cm,h=30cm --intensity 4000lm --position 0,0,1 --at 0.5,0,0 "
            "--compare exact,frostbite",
            "the error of an approximation"},
    Example{"gonio probe --shape tube:r=2cm,l=1.2m --intensity 2500lm --position 0,0,2 --at 0,0,0 "
            "--view 1,0,1 --material frostbite:smoothness=0.7 --method reference --error 1e-8",
            "the luminance of a glossy floor, with an error estimate"},
    Example{"gonio probe --shape sphere:r=20cm --intensity 800lm --position 0,1,1 --at 0,0,0 "
            "--view 0,-1,1 --material frostbite:smoothness=0.8 --compare representative-point",
            "the error of an approximate highlight"},
};

constexpr std::size_t numbers_at_once = std::size_t{1} << 22; // shares of lights held at a time

// The stage's shadows on the share of each light, the light of the sky, and what the stage reflects.
void add_stage_light(const ReceiverLight& on_stage, const ProbeRequest& request, ProbeStretch& stretch) {
    ProbeResult& result = stretch.by_method.front();
    const ReceiverLight::Shares shares = on_stage.at(stretch.receivers);
    const std::size_t lights = stretch.receivers.empty() ? 0 : shares.visible.size() / stretch.receivers.size();
    for (std::size_t i = 0; i < stretch.receivers.size(); ++i) {
        double direct_lx = 0.0;
        for (std::size_t part = i * lights; part < (i + 1) * lights; ++part) {
            result.parts_lx[part] *= shares.visible[part];
            direct_lx += result.parts_lx[part];
        }
        stretch.direct_lx.push_back(direct_lx);
        result.illuminance_lx[i] = direct_lx + shares.sky_lx[i] + shares.indirect_lx[i];
    }
    stretch.sky_lx = shares.sky_lx;
    stretch.indirect_lx = shares.indirect_lx;
    if (!request.glare) return;
    for (std::size_t i = 0; i < stretch.receivers.size(); ++i)
        stretch.glare.push_back(glare_rating(
            request.lights, {stretch.receivers[i].position, stretch.receivers[i].normal},
            std::span(shares.visible).subspan(i * lights, lights), shares.sky_lx[i] + shares.indirect_lx[i]));
}

// The same for an illuminance that is not of a flat surface, from the surfaces that stand for it. A light is hidden as
// much as it is for those, each weighted by its illuminance.
Result<void> add_spatial_stage_light(const ReceiverLight& on_stage, const ProbeRequest& request, IlluminanceKind kind,
                                     ProbeStretch& stretch) {
    ProbeResult& result = stretch.by_method.front();
    const std::size_t lights = request.lights.size();
    std::vector<Receiver> receivers;
    std::vector<double> weights;
    for (const Receiver& receiver : stretch.receivers)
        for (const WeightedNormal& surface :
             surfaces_of(kind, unit_vector(receiver.normal).value_or(Receiver().normal))) {
            receivers.push_back({receiver.position, surface.normal});
            weights.push_back(surface.weight);
        }
    const std::size_t each = stretch.receivers.empty() ? 0 : receivers.size() / stretch.receivers.size();
    ProbeOptions options = request.options;
    options.parts = true;
    options.method = IrradianceMethod::point; // only weights
    Result<ProbeResult> flat = probe(request.lights, receivers, options);
    if (!flat) return pass_on(flat);
    const ReceiverLight::Shares shares = on_stage.at(receivers);
    for (std::size_t i = 0; i < stretch.receivers.size(); ++i) {
        double direct_lx = 0.0;
        for (std::size_t l = 0; l < lights; ++l) {
            double all = 0.0;
            double visible = 0.0;
            for (std::size_t s = i * each; s < (i + 1) * each; ++s) {
                const double lx = std::abs(weights[s]) * flat->parts_lx[s * lights + l];
                all += lx;
                visible += lx * shares.visible[s * lights + l];
            }
            if (all > 0.0) result.parts_lx[i * lights + l] *= visible / all;
            direct_lx += result.parts_lx[i * lights + l];
        }
        double sky_lx = 0.0;
        double indirect_lx = 0.0;
        for (std::size_t s = i * each; s < (i + 1) * each; ++s) {
            sky_lx += weights[s] * shares.sky_lx[s];
            indirect_lx += weights[s] * shares.indirect_lx[s];
        }
        stretch.direct_lx.push_back(direct_lx);
        stretch.sky_lx.push_back(std::max(sky_lx, 0.0));
        stretch.indirect_lx.push_back(std::max(indirect_lx, 0.0));
        result.illuminance_lx[i] = direct_lx + stretch.sky_lx.back() + stretch.indirect_lx.back();
    }
    return {};
}

// The values of one kind of illuminance, by the first method; remarks are those of a flat surface.
Result<void> evaluate(const ProbeRequest& request, const std::optional<ReceiverLight>& on_stage, IlluminanceKind kind,
                      ProbeStretch& stretch) {
    const bool is_planar = kind <= IlluminanceKind::vertical;
    for (std::size_t m = 0; m < request.methods.size(); ++m) {
        ProbeOptions options = request.options;
        options.method = request.methods[m];
        options.parts = options.parts && m == 0;
        Result<ProbeResult> result = probe(request.lights, stretch.receivers, options);
        if (!result) return pass_on(result);
        stretch.by_method.push_back(std::move(*result));
    }
    if (is_planar) {
        if (on_stage) add_stage_light(*on_stage, request, stretch);
        return {};
    }
    ProbeResult& result = stretch.by_method.front();
    result.parts_lx = illuminance_parts(kind, request.lights, stretch.receivers, request.options.threads);
    const std::size_t lights = request.lights.size();
    for (std::size_t i = 0; i < stretch.receivers.size(); ++i) {
        double lx = 0.0;
        for (std::size_t l = 0; l < lights; ++l)
            lx += result.parts_lx[i * lights + l];
        result.illuminance_lx[i] = lx;
    }
    return on_stage ? add_spatial_stage_light(*on_stage, request, kind, stretch) : Result<void>();
}

// The values of lights that were summed up while they were read.
ProbeStretch summed_stretch(const ProbeRequest& request) {
    ProbeStretch stretch;
    stretch.receivers = request.points.receivers;
    stretch.by_method.push_back(request.summed->result);
    return stretch;
}

// How many surfaces stand for one point.
std::size_t surfaces_per_point(const ProbeRequest& request) {
    return request.is_planar() ? 1 : surfaces_of(request.kind, {1.0, 0.0, 0.0}).size();
}

Result<int> run_probe(const Arguments& arguments, Console& console) {
    Result<ProbeRequest> request = parse_probe(arguments);
    if (!request) return pass_on(request);

    ProbeReport report(*request, console);
    const Stopwatch evaluation;
    std::optional<ReceiverLight> on_stage;
    LightingOptions lighting;
    lighting.threads = request->options.threads;
    lighting.bounces = request->indirect ? all_bounces : 0;
    lighting.sky = request->sky;
    if (request->stage) {
        Result<ReceiverLight> solved = ReceiverLight::on(*request->stage, request->lights, lighting);
        if (!solved) return pass_on(solved);
        on_stage = std::move(*solved);
    }
    request->options.parts = report.wants_parts() || on_stage || !request->is_planar();
    const std::size_t numbers =
        request->options.parts ? request->lights.size() * (on_stage ? surfaces_per_point(*request) : 1) : 1;
    const std::size_t at_once =
        std::clamp<std::size_t>(numbers_at_once / std::max<std::size_t>(numbers, 1), 1, points_at_once);
    const std::span<const Receiver> receivers = request->points.receivers;
    if (request->summed) {
        report.begin();
        report.add(summed_stretch(*request));
    }
    for (std::size_t first = 0; first < receivers.size() && !request->summed; first += at_once) {
        ProbeStretch stretch;
        stretch.first = first;
        stretch.receivers = receivers.subspan(first, std::min(at_once, receivers.size() - first));
        const bool is_index = request->kind == IlluminanceKind::modelling;
        Result<void> done =
            evaluate(*request, on_stage, is_index ? IlluminanceKind::cylindrical : request->kind, stretch);
        if (!done) return pass_on(done);
        if (is_index) {
            ProbeStretch flat;
            flat.receivers = stretch.receivers;
            if (done = evaluate(*request, on_stage, IlluminanceKind::horizontal, flat); !done) return pass_on(done);
            stretch.horizontal_lx = std::move(flat.by_method.front().illuminance_lx);
        }
        if (first == 0) report.begin();
        report.add(stretch);
    }
    report.end(request->diagnostics);
    if (request->drawing)
        if (Result<void> drawn = report.draw(request->diagnostics); !drawn) return pass_on(drawn);
    console.remark(fmt::format("{} points under {} lights in {:.1f} ms", receivers.size(), request->light_count(),
                               request->summed ? request->summed->milliseconds : evaluation.milliseconds()));
    console.say(request->diagnostics);
    return report.has_failed() ? 1 : 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = run_probe(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command probe_command;
const Command probe_command{
    "probe",
    "compute illuminance and luminance at points, from a rig or one light",
    "--rig RIG | FILE | --shape SHAPE … --at X,Y,Z",
    "FILE is an IES, EULUMDAT or TM-33 profile. A rig is a JSON file of schema gonio.rig/1.\n"
    "Prints lux in double precision. With --view and --material it also prints the luminance\n"
    "towards the eye in nits. Lights neither occlude nor reflect each other. --indirect adds the light\n"
    "that a stage reflects; --sky adds a sky and the sun of daylight. With either, what stands on a stage\n"
    "hides lights. Surfaces that emit (--emits, or those of a rig) are lights.",
    groups,
    examples,
    run,
    true};

} // namespace gonio::cli
