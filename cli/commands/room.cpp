#include <gonio/figures/room_plan.hpp>

#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/grid_drawing.hpp"
#include "../options/output.hpp"
#include "../room/request.hpp"
#include "../room/room_report.hpp"
#include "../sheet/sheet_output.hpp"
#include "../stopwatch.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array output_options{
    Option{"-o,--output", "FILE",
           "write the room: .json a rig for the other commands, .svg or .png its plan with lux, .pdf or .html a sheet"},
    Option{"-s,--size", "WxH", "of the plan in pixels (as the numbers need)"},
    Option{"--title", "TEXT", "of the plan or the sheet"},
    Option{"--to", "FORMAT", "of the plan: svg or an 8-bit picture format, if the file name does not show it",
           "images"},
    paper_option,
    fonts_option,
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
    Example{"gonio room 6x4x2.8 --luminaire office.ldt --task office.writing -o office.pdf",
            "a sheet of the room: plan, luminaires, verdicts"},
    Example{"gonio room 12x8x3 --luminaire office.ldt --for 300lx -o room.json && gonio preview --rig room.json -o "
            "room.png",
            "what it looks like"},
};

// Empty if the output is none. Before the room is planned, since a PDF may lack its fonts.
Result<std::optional<SheetOutput>> sheet_of(const Arguments& arguments) {
    const std::string output = arguments.value("--output").value_or("");
    const bool is_sheet = names_sheet(output);
    for (const std::string_view option : {"--size", "--to"})
        if (is_sheet && arguments.has(option))
            return fail("USE0107", fmt::format("{} is for a plan, but -o writes a sheet", option));
    for (const std::string_view option : {"--paper", "--fonts"})
        if (!is_sheet && arguments.has(option))
            return fail("USE0107", fmt::format("{} is for a sheet", option), "write -o room.pdf");
    if (!is_sheet) return std::optional<SheetOutput>();
    return sheet_output(arguments).map([](SheetOutput sheet) { return std::optional(std::move(sheet)); });
}

Result<void> write_room_sheet(const Arguments& arguments, const RoomRequest& request, const RoomPlan& plan,
                              const SheetOutput& output, Diagnostics& diagnostics) {
    if (Result<void> free = check_outputs({&request.luminaire.file, 1}, {&output.file, 1}); !free) return free;
    const RoomSheetContent content =
        room_sheet_content(request, plan, arguments.value("--title").value_or(std::string()));
    Result<RoomSheet> sheet = room_sheet(content, output.paper);
    if (!sheet) return pass_on(sheet);
    add_letters_note(sheet->replaced, request.luminaire.file, diagnostics);
    return write_sheet(output, sheet->pages, {content.title, {}});
}

Result<void> write(const Arguments& arguments, const RoomRequest& request, const RoomPlan& plan,
                   const std::optional<SheetOutput>& sheet, Diagnostics& diagnostics) {
    const std::string output = arguments.value("--output").value_or("");
    if (sheet) return write_room_sheet(arguments, request, plan, *sheet, diagnostics);
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
    Result<std::optional<SheetOutput>> sheet = sheet_of(arguments);
    if (!sheet) return pass_on(sheet);
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
        if (Result<void> written = write(arguments, *request, *plan, *sheet, diagnostics); !written)
            return pass_on(written);
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
