#include <gonio/figures/room_plan.hpp>

#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/grid_drawing.hpp"
#include "../options/output.hpp"
#include "../room/request.hpp"
#include "../room/room_report.hpp"
#include "../stopwatch.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array output_options{
    Option{"-o,--output", "FILE", "write the room: .json a rig for the other commands, .svg or .png its plan with lux"},
    Option{"-s,--size", "WxH", "of the plan in pixels (as the numbers need)"},
    Option{"--title", "TEXT", "of the plan"},
    Option{"--to", "FORMAT", "of the plan: svg or an 8-bit picture format, if the file name does not show it",
           "images"},
};
constexpr std::array groups{OptionGroup{"room", room_options},
                            task_group,
                            OptionGroup{"output", output_options},
                            json_group,
                            threads_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio room 6x4x2.8 --luminaire office.ldt --for 500lx", "how many luminaires an office needs"},
    Example{"gonio room 6x4x2.8 --luminaire office.ldt --task office.writing",
            "the same for a task, with a verdict for each requirement of the standard"},
    Example{"gonio room 6x4x2.8 --luminaire office.ldt --count 3x2 --reflectances 80/50/30 -o plan.svg",
            "the lux of a layout, drawn"},
    Example{"gonio room 12x8x3 --luminaire office.ldt --for 300lx -o room.json && gonio preview --rig room.json -o "
            "room.png",
            "what it looks like"},
};

Result<void> write(const Arguments& arguments, const RoomRequest& request, const RoomPlan& plan,
                   Diagnostics& diagnostics) {
    const std::string output = arguments.value("--output").value_or("");
    if (output.ends_with(".json")) {
        for (const std::string_view option : {"--size", "--title", "--to"})
            if (arguments.has(option))
                return fail("USE0107", fmt::format("{} is for a plan, but -o writes a rig", option));
        Result<std::string> name = name_beside(request.luminaire.file, output);
        if (!name) return pass_on(name);
        return write_output(output, room_rig(request, plan, *name));
    }
    Result<GridDrawing> drawing = grid_drawing(arguments);
    if (!drawing) return pass_on(drawing);
    GridPlot plot = room_plot(request, plan);
    if (!drawing->title.empty()) plot.title = drawing->title;
    return write_grid_drawing(*drawing, std::move(plot), diagnostics);
}

Result<int> run_room(const Arguments& arguments, Console& console) {
    Diagnostics diagnostics;
    for (const std::string_view option : {"--size", "--title", "--to"})
        if (arguments.has(option) && !arguments.has("--output"))
            return fail("USE0104", fmt::format("{} needs -o", option), "it is for the drawing of the plan");
    Result<RoomRequest> request = parse_room(arguments, diagnostics);
    if (!request) return pass_on(request);
    const Stopwatch watch;
    Diagnostics again; // of reading the luminaire, which parse_room() has said
    Result<RoomPlan> plan = plan_room(request->luminaire.light, request->plan, again);
    if (!plan) return pass_on(plan);
    console.remark(fmt::format("planned in {:.1f} ms", watch.milliseconds()));
    judge(*request, *plan);
    add_remarks(*plan, diagnostics);
    if (arguments.has("--output"))
        if (Result<void> written = write(arguments, *request, *plan, diagnostics); !written) return pass_on(written);
    const ReportKind kind = report_kind(arguments);
    if (kind == ReportKind::words)
        console.print(room_text(*request, *plan));
    else
        console.print(dump(room_json(*request, *plan, diagnostics), kind == ReportKind::json ? 2 : -1));
    console.say(diagnostics);
    return request->task && request->task->has_failed() ? 1 : 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = run_room(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command room_command;
const Command room_command{
    "room",
    "plan the luminaires of a room: how many, lux, uniformity, UGR and power",
    "LENGTHxWIDTHxHEIGHT --luminaire FILE --for LUX [options]",
    "Places luminaires in a regular layout on the ceiling of an empty room and finds the smallest one that\n"
    "reaches the mean illuminance. Lux are maintained ones and include all light that ceiling, walls and floor\n"
    "reflect; points are spaced as EN 12464-1 has it; UGR is that of observers at the middles of the walls.",
    groups,
    examples,
    run};

} // namespace gonio::cli
