#include "help.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonio::cli {

namespace {

std::string with_spaces(std::string_view names) {
    std::string text;
    for (const char c : names)
        text += c == ',' ? std::string(", ") : std::string(1, c);
    return text;
}

} // namespace

std::string overview() {
    std::string text = "gonio — photometric lights: units, measured profiles, textures, previews\n\n"
                       "usage: gonio COMMAND [arguments]\n\ncommands\n";
    for (const Command* command : commands())
        text += fmt::format("  {:<12}{}\n", command->name, command->summary);
    text += "\n'gonio help COMMAND' or 'gonio COMMAND --help' shows a command's options and examples.\n";
    return text;
}

std::string help_text(const Command& command) {
    std::string text = fmt::format("gonio {} — {}\n\nusage: gonio {} {}\n", command.name, command.summary, command.name,
                                   command.usage);
    if (!command.arguments.empty()) text += fmt::format("\n{}\n", command.arguments);
    std::size_t width = 0;
    for (const OptionGroup& group : command.groups)
        for (const Option& option : group.options)
            width = std::max(width, with_spaces(option.names).size() + 1 + option.value.size());
    width = std::min<std::size_t>(width, 28);
    for (const OptionGroup& group : command.groups) {
        text += fmt::format("\n{}\n", group.title);
        for (const Option& option : group.options) {
            std::string left = with_spaces(option.names);
            if (!option.value.empty()) left += fmt::format(" {}", option.value);
            const std::string_view suffix = option.repeatable ? "; repeatable" : "";
            if (left.size() > width) {
                text += fmt::format("  {}\n  {:<{}}  {}{}\n", left, "", width, option.help, suffix);
            } else {
                text += fmt::format("  {:<{}}  {}{}\n", left, width, option.help, suffix);
            }
        }
    }
    if (!command.examples.empty()) text += "\nexamples\n";
    for (const Example& example : command.examples)
        text += fmt::format("  {}\n      {}\n", example.command, example.says);
    return text;
}

} // namespace gonio::cli
