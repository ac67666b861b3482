#include "../help.hpp"

#include <gonio/base/named.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"

#include <array>
#include <span>

namespace gonio::cli {

namespace {

constexpr std::array groups{common_group};

int run(const Arguments& arguments, Console& console) {
    if (arguments.positional().empty()) {
        console.print(overview());
        return 0;
    }
    const std::string& name = arguments.positional().front();
    const std::span<const Command* const> all = commands();
    const Result<const Command* const*> command = find_named("command", name, all);
    if (!command) return console.fail(command.error());
    console.print(help_text(**command.value()));
    return 0;
}

} // namespace

extern const Command help_command;
const Command help_command{"help", "show the commands, or the options and examples of one", "[COMMAND]", "", groups, {},
                           run};

} // namespace gonio::cli
