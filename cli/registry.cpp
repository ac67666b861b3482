#include "command.hpp"

#include <array>

namespace gonio::cli {

extern const Command units_command;
extern const Command cct_command;
extern const Command info_command;
extern const Command check_command;
extern const Command convert_command;
extern const Command make_command;
extern const Command edit_command;
extern const Command sample_command;
extern const Command compare_command;
extern const Command plot_command;
extern const Command report_command;
extern const Command shader_command;
extern const Command sheet_command;
extern const Command bake_command;
extern const Command import_command;
extern const Command lights_command;
extern const Command rig_command;
extern const Command probe_command;
extern const Command road_command;
extern const Command room_command;
extern const Command preview_command;
extern const Command sky_command;
extern const Command bench_command;
extern const Command explain_command;
extern const Command list_command;
extern const Command help_command;
extern const Command completion_command;
extern const Command version_command;

// One per line, so that two changes to the list do not touch the same line. With GONIO_PAGE_COMMANDS, these are those
// that the page calls (page/), and nothing else is linked.
// clang-format off
static constexpr std::array all{
    &units_command,
    &cct_command,
    &info_command,
    &check_command,
    &convert_command,
#ifndef GONIO_PAGE_COMMANDS
    &make_command,
    &edit_command,
    &sample_command,
#endif
    &compare_command,
    &plot_command,
#ifndef GONIO_PAGE_COMMANDS
    &report_command,
    &sheet_command,
#endif
    &bake_command,
    &import_command,
#ifndef GONIO_PAGE_COMMANDS
    &lights_command,
#endif
    &rig_command,
#ifndef GONIO_PAGE_COMMANDS
    &probe_command,
    &room_command,
    &road_command,
#endif
    &preview_command,
#ifndef GONIO_PAGE_COMMANDS
    &sky_command,
    &shader_command,
#endif
#ifndef GONIO_NO_BENCH
    &bench_command,
#endif
    &explain_command,
    &list_command,
#ifndef GONIO_PAGE_COMMANDS
    &help_command,
    &completion_command,
    &version_command,
#endif
};
// clang-format on

std::span<const Command* const> commands() {
    return all;
}

const Command* find_command(std::string_view name) {
    for (const Command* command : commands())
        if (command->name == name) return command;
    return nullptr;
}

} // namespace gonio::cli
