// A command of the tool: its description, from which help, completion and the option parser are made, and the function
// that runs it. The description and code of a command are in commands/<name>.cpp.
#pragma once

#include <span>
#include <string_view>

namespace gonio::cli {

class Arguments;
class Console;

// The page (page/) shows no help and calls only a part of the tool. Files compiled with GONIO_PAGE_COMMANDS leave out
// what it does not call.
#ifdef GONIO_PAGE_COMMANDS
constexpr bool is_for_page = true;
#else
constexpr bool is_for_page = false;
#endif

// Text for readers of help.
struct HelpText {
    std::string_view text;

    constexpr HelpText() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): stands for its text
    consteval HelpText(const char* says) : text(is_for_page ? "" : says) {}
    [[nodiscard]] constexpr bool empty() const { return text.empty(); }
    // NOLINTNEXTLINE(google-explicit-constructor): as above
    constexpr operator std::string_view() const { return text; }
};

struct Option {
    std::string_view names; // "-o,--output"; the last one is its name in Arguments
    std::string_view value; // "FILE"; empty for a switch
    HelpText help;
    std::string_view list = {}; // the list of `gonio list` with the possible values, for completion
    bool repeatable = false;    // else a second value is refused, unless the value is a list ("TARGET,…")
};

struct OptionGroup {
    std::string_view title;
    std::span<const Option> options;
};

struct Example {
    HelpText command;
    HelpText says;
};

struct Command {
    std::string_view name;
    HelpText summary;   // one line, no full stop
    HelpText usage;     // the text after the name: "FILE… [options]"
    HelpText arguments; // lines about the positional arguments; may be empty
    std::span<const OptionGroup> groups;
    std::span<const Example> examples;
    int (*run)(const Arguments&, Console&); // returns the exit status
    bool color_is_of_light = false;         // --color takes a light's colour as well as auto, always and never
};

// Every command, in the order of the overview.
std::span<const Command* const> commands();

// nullptr if there is no command of that name.
const Command* find_command(std::string_view name);

} // namespace gonio::cli
