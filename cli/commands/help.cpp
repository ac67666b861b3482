#include "../help.hpp"

#include <gonio/base/kind_text.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"

#include <array>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array groups{common_group};

int run(const Arguments& arguments, Console& console) {
    if (arguments.positional().empty()) {
        console.print(overview());
        return 0;
    }
    const std::string& name = arguments.positional().front();
    if (const Command* command = find_command(name)) {
        console.print(help_text(*command));
        return 0;
    }
    std::vector<std::string_view> names;
    for (const Command* command : commands())
        names.push_back(command->name);
    return console.fail(unknown_name("command", name, names).value());
}

} // namespace

extern const Command help_command;
const Command help_command{"help", "show the commands, or the options and examples of one", "[COMMAND]", "", groups, {},
                           run};

} // namespace gonio::cli
