#include "../help.hpp"

#include <gonio/base/named.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../man_page.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"

#include <array>
#include <span>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array page_options{
    Option{"--man", "", "print a manual page, for man -l"},
    Option{"-O,--output-dir", "DIR", "with --man: write all manual pages into an existing folder"},
    Option{"--overwrite", "", "with -O: replace existing files"},
};
constexpr std::array groups{OptionGroup{"manual pages", page_options}, common_group};
constexpr std::array examples{
    Example{"gonio help bake", "the options and examples of bake"},
    Example{"gonio help bake --man | man -l -", "the same as a manual page"},
};

// gonio.1, gonio-units.1, …
Result<void> write_man_pages(const Arguments& arguments) {
    std::vector<std::string> names{"gonio"};
    std::vector<std::string> pages{man_page()};
    for (const Command* command : commands()) {
        names.push_back(man_page_name(*command));
        pages.push_back(man_page(*command));
    }
    Result<std::vector<Job>> jobs = plan_outputs(arguments, names, "1");
    if (!jobs) return pass_on(jobs);
    std::vector<OutputFile> files;
    for (std::size_t i = 0; i < pages.size(); ++i)
        files.push_back({(*jobs)[i].output, std::move(pages[i])});
    return write_outputs(files);
}

Result<void> help(const Arguments& arguments, Console& console) {
    const bool man = arguments.has("--man");
    if (arguments.has("--output-dir")) {
        if (!man) return fail("USE0104", "-O needs --man", "gonio help --man -O DIR");
        if (!arguments.positional().empty())
            return fail("USE0107", "-O writes the pages of all commands", "leave out the command, or -O");
        return write_man_pages(arguments);
    }
    if (arguments.positional().empty()) {
        console.print(man ? man_page() : overview());
        return {};
    }
    const std::span<const Command* const> all = commands();
    Result<const Command* const*> command = find_named("command", arguments.positional().front(), all);
    if (!command) return pass_on(command);
    console.print(man ? man_page(***command) : help_text(***command));
    return {};
}

int run(const Arguments& arguments, Console& console) {
    const Result<void> done = help(arguments, console);
    return done ? 0 : console.fail(done.error());
}

} // namespace

extern const Command help_command;
const Command help_command{
    "help", "show the commands, or the options and examples of one", "[COMMAND] [options]", "", groups, examples, run};

} // namespace gonio::cli
