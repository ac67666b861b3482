#include <gonio/base/named.hpp>
#include <gonio/figures/road_plan.hpp>

#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/grid_drawing.hpp"
#include "../options/output.hpp"
#include "../road/request.hpp"
#include "../road/road_report.hpp"
#include "../stopwatch.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array output_options{
    Option{"-o,--output", "FILE", "write the road: .json a rig for the other commands, .svg or .png its plan"},
    Option{"--quantity", "NAME", "of the plan: luminance or illuminance (what the task is about, else luminance)"},
    Option{"-s,--size", "WxH", "of the plan in pixels (as the numbers need)"},
    Option{"--title", "TEXT", "of the plan"},
    Option{"--to", "FORMAT", "of the plan: svg or an 8-bit picture format, if the file name does not show it",
           "images"},
};
constexpr std::array groups{OptionGroup{"road", road_options},
                            OptionGroup{"luminaires", road_luminaire_options},
                            task_group,
                            OptionGroup{"output", output_options},
                            json_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio road 7m --luminaire street.ldt --height 8m --spacing 30m",
            "luminance, uniformity and glare for the drivers of both lanes"},
    Example{"gonio road 7m --luminaire street.ldt --height 10m --task road.m3",
            "how far apart the luminaires may be for a class of road"},
    Example{"gonio road 10.5m --lanes 3 --luminaire street.ies --height 12m --arrangement staggered --overhang 1m "
            "--tilt 5deg --spacing 40m -o road.svg",
            "a wider road, its luminance drawn"},
    Example{"gonio road 7m --luminaire street.ldt --spacing 30m --surface r2.csv --q0 0.08", "another road surface"},
};

Result<bool> draws_luminance(const Arguments& arguments, const RoadRequest& request) {
    const auto name = arguments.value("--quantity");
    if (!name) return !request.task || request.task->task.mean_nt.has_value();
    constexpr std::array quantities{Named{"luminance", true}, Named{"illuminance", false}};
    return find_value("quantity", *name, quantities);
}

Result<void> write(const Arguments& arguments, const RoadRequest& request, const RoadPlan& plan,
                   Diagnostics& diagnostics) {
    const std::string output = arguments.value("--output").value_or("");
    if (output.ends_with(".json")) {
        for (const std::string_view option : {"--size", "--title", "--to", "--quantity"})
            if (arguments.has(option))
                return fail("USE0107", fmt::format("{} is for a plan, but -o writes a rig", option));
        Result<std::string> name = name_beside(request.luminaire.file, output);
        if (!name) return pass_on(name);
        return write_output(output, road_rig(request, plan, *name));
    }
    Result<bool> luminance = draws_luminance(arguments, request);
    if (!luminance) return pass_on(luminance);
    Result<GridDrawing> drawing = grid_drawing(arguments);
    if (!drawing) return pass_on(drawing);
    GridPlot plot = road_plot(request, plan, *luminance);
    if (!drawing->title.empty()) plot.title = drawing->title;
    return write_grid_drawing(*drawing, std::move(plot), diagnostics);
}

Result<int> run_road(const Arguments& arguments, Console& console) {
    Diagnostics diagnostics;
    for (const std::string_view option : {"--size", "--title", "--to", "--quantity"})
        if (arguments.has(option) && !arguments.has("--output"))
            return fail("USE0104", fmt::format("{} needs -o", option), "it is for the drawing of the plan");
    Result<RoadRequest> request = parse_road(arguments, diagnostics);
    if (!request) return pass_on(request);
    const Stopwatch watch;
    Diagnostics again; // of reading the luminaire, which parse_road() has said
    Result<RoadPlan> plan = request->has_spacing
                                ? plan_road(request->luminaire.light, request->plan, again)
                                : plan_road(request->luminaire.light, request->plan, request->task->task, again);
    if (!plan) return pass_on(plan);
    console.remark(fmt::format("planned in {:.1f} ms", watch.milliseconds()));
    if (request->task) request->task->verdicts = verdicts(request->task->task, plan->reached(), request->task->raised);
    if (arguments.has("--output"))
        if (Result<void> written = write(arguments, *request, *plan, diagnostics); !written) return pass_on(written);
    const ReportKind kind = report_kind(arguments);
    if (kind == ReportKind::words)
        console.print(road_text(*request, *plan));
    else
        console.print(dump(road_json(*request, *plan, diagnostics), kind == ReportKind::json ? 2 : -1));
    console.say(diagnostics);
    return request->task && request->task->has_failed() ? 1 : 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = run_road(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command road_command;
const Command road_command{
    "road",
    "plan the luminaires of a road: luminance, uniformity, glare for drivers, illuminance",
    "WIDTH --luminaire FILE (--spacing LENGTH | --task TASK) [options]",
    "Places rows of luminaires along a straight road and computes what EN 13201-3 asks for: the luminance\n"
    "that the driver of each lane sees, threshold increment, illuminance and that beside the road. Without a\n"
    "spacing it finds the widest one that passes the task. Figures are maintained ones; the luminaire's street\n"
    "side is C90 in EULUMDAT and C0 in LM-63, as `gonio info` takes it.",
    groups,
    examples,
    run};

} // namespace gonio::cli
