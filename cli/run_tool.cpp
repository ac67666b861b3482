#include "run_tool.hpp"

#include <gonio/base/kind_text.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/media/light_image_file.hpp>

#include "arguments.hpp"
#include "command.hpp"
#include "console.hpp"
#include "help.hpp"
#include "options/output.hpp"
#include "unexpected.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

namespace gonio::cli {

namespace {

int unknown_command(std::string_view name, Console& console) {
    const std::string_view guess = nearest(name, names_of(commands()));
    return console.fail(
        fail("USE0103", fmt::format("unknown command '{}'", name),
             guess.empty() ? "'gonio help' lists the commands" : fmt::format("did you mean '{}'?", guess))
            .value());
}

// Whether diagnostics are coloured: if requested, or if stderr is a terminal and NO_COLOR is not set (no-color.org).
// Commands that place a light use the same option for the light's colour, so they accept other words too.
Result<bool> colored(const Command& command, const Arguments& arguments) {
    const std::string when = arguments.value("--color").value_or("auto");
    if (when == "always") return true;
    if (when == "never") return false;
    if (when != "auto" && !command.color_is_of_light)
        return unknown_name("colour setting", when, std::array<std::string_view, 3>{"auto", "always", "never"});
    const char* const no_color = std::getenv("NO_COLOR");
    const bool automatic = Console::errors_are_terminal() && (no_color == nullptr || *no_color == '\0');
    return automatic;
}

int run(std::span<char* const> words, Console& console) {
    media::enable_light_images();
    if (words.empty()) {
        console.note(overview());
        return static_cast<int>(Failure::usage);
    }
    const std::string_view name = words.front();
    if (name == "--help" || name == "-h") {
        console.print(overview());
        return 0;
    }
    const Command* command = find_command(name == "--version" || name == "-V" ? "version" : name);
    if (command == nullptr) {
        if (name.starts_with("-"))
            return console.fail(fail("USE0102", fmt::format("unknown option '{}'", name),
                                     "put the command first; 'gonio help' lists the commands")
                                    .value());
        return unknown_command(name, console);
    }
    Result<Arguments> arguments = Arguments::parse(*command, words.subspan(1));
    if (!arguments) return console.fail(arguments.error());
    if (arguments->has("--help")) {
        console.print(help_text(*command));
        return 0;
    }
    const Result<bool> color = colored(*command, *arguments);
    if (!color) return console.fail(color.error());
    console.set_color(*color);
    console.set_quiet(arguments->has("--quiet"));
    console.set_verbose(arguments->has("--verbose"));
    set_durable_outputs(arguments->has("--durable"));
    return command->run(*arguments, console);
}

} // namespace

int run_tool(std::span<char* const> words, Console& console) {
    int status = static_cast<int>(Failure::internal);
    try {
        status = run(words, console);
    } catch (...) {
        status = console.fail(unexpected_error());
    }
    return console.flush(status);
}

} // namespace gonio::cli
