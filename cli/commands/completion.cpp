#include <gonio/base/kind_text.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../lists.hpp"
#include "../options/common.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array<std::string_view, 3> shells{"bash", "zsh", "fish"};
constexpr std::array groups{common_group};
constexpr std::array examples{
    Example{"source <(gonio completion bash)", "completion in this shell"},
    Example{"gonio completion fish > ~/.config/fish/completions/gonio.fish", "completion in every new fish"},
};

// The names of a list in the form that can be typed: "point", and "sphere:" for "sphere:r=LENGTH".
std::string words_of(std::string_view list_name) {
    std::string words;
    const NamedList* list = find_list(list_name);
    if (list == nullptr) return words;
    for (const ListEntry& entry : list->entries()) {
        const std::size_t end = entry.name.find_first_of(":[");
        if (!words.empty()) words += ' ';
        words += end == std::string::npos ? entry.name : entry.name.substr(0, entry.name[end] == ':' ? end + 1 : end);
    }
    return words;
}

std::string command_names() {
    std::string names;
    for (const Command* command : commands())
        names += fmt::format("{}{}", names.empty() ? "" : " ", command->name);
    return names;
}

std::string list_names() {
    std::string names;
    for (const NamedList& list : named_lists())
        names += fmt::format("{}{}", names.empty() ? "" : " ", list.name);
    return names;
}

std::string bash_script() {
    std::string options;
    std::string values;
    for (const Command* command : commands()) {
        std::string all;
        for (const OptionGroup& group : command->groups)
            for (const Option& option : group.options) {
                for (const std::string_view name : spellings(option))
                    all += fmt::format("{}{}", all.empty() ? "" : " ", name);
                if (!option.list.empty())
                    values += fmt::format("        {}:{}) words=\"{}\" ;;\n", command->name, spellings(option).back(),
                                          words_of(option.list));
            }
        options += fmt::format("        {}) words=\"{}\" ;;\n", command->name, all);
    }
    return fmt::format(R"(# bash completion of gonio
_gonio() {{
    local current="${{COMP_WORDS[COMP_CWORD]}}" previous="${{COMP_WORDS[COMP_CWORD-1]}}" command="${{COMP_WORDS[1]}}" words=""
    if (( COMP_CWORD == 1 )); then
        COMPREPLY=($(compgen -W "{0}" -- "$current"))
        return
    fi
    case "$command:$previous" in
        help:help) words="{0}" ;;
        list:list) words="{1}" ;;
        completion:completion) words="bash zsh fish" ;;
{2}    esac
    if [[ -n $words ]]; then
        # The last name of a list: unreal,u<TAB>.
        local before=""
        [[ $current == *,* ]] && before="${{current%,*}},"
        COMPREPLY=($(compgen -P "$before" -W "$words" -- "${{current##*,}}"))
        return
    fi
    if [[ $current == -* ]]; then
        case "$command" in
{3}        esac
        COMPREPLY=($(compgen -W "$words" -- "$current"))
        return
    fi
    COMPREPLY=($(compgen -f -- "$current"))
}}
complete -o filenames -F _gonio gonio
)",
                       command_names(), list_names(), values, options);
}

// Escapes text for single quotes in zsh and fish.
std::string in_single_quotes(std::string_view text) {
    std::string out;
    for (const char c : text)
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out;
}

std::string fish_script() {
    std::string script = "# fish completion of gonio\ncomplete -c gonio -n __fish_use_subcommand -f\n";
    for (const auto& [command, names] : {std::pair<std::string_view, std::string>{"help", command_names()},
                                         {"list", list_names()},
                                         {"completion", "bash zsh fish"}})
        script += fmt::format("complete -c gonio -n '__fish_seen_subcommand_from {}' -f -a '{}'\n", command, names);
    for (const Command* command : commands()) {
        script += fmt::format("complete -c gonio -n __fish_use_subcommand -a {} -d '{}'\n", command->name,
                              in_single_quotes(command->summary));
        for (const OptionGroup& group : command->groups)
            for (const Option& option : group.options) {
                script += fmt::format("complete -c gonio -n '__fish_seen_subcommand_from {}'", command->name);
                for (const std::string_view name : spellings(option))
                    script += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2))
                                                     : fmt::format(" -s {}", name.substr(1));
                if (!option.value.empty()) script += " -r";
                if (!option.list.empty()) script += fmt::format(" -f -a '{}'", in_single_quotes(words_of(option.list)));
                script += fmt::format(" -d '{}'\n", in_single_quotes(option.help));
            }
    }
    return script;
}

// zsh runs the bash function through its emulation of bash completion. Where zsh has loaded this script as the function
// _gonio, from a folder of completions, it is in the middle of the first completion, which is still to be answered.
std::string zsh_script() {
    return "#compdef gonio\nautoload -U +X bashcompinit && bashcompinit\n" + bash_script() +
           "[[ ${funcstack[1]} != _gonio ]] || _bash_complete -o filenames -F _gonio\n";
}

int run(const Arguments& arguments, Console& console) {
    if (arguments.positional().size() != 1)
        return console.fail(fail("USE0104", "name one shell", "bash, zsh or fish").value());
    const std::string& shell = arguments.positional().front();
    if (shell == "bash")
        console.print(bash_script());
    else if (shell == "zsh")
        console.print(zsh_script());
    else if (shell == "fish")
        console.print(fish_script());
    else
        return console.fail(unknown_name("shell", shell, shells).value());
    return 0;
}

} // namespace

extern const Command completion_command;
const Command completion_command{
    "completion", "print a completion script for a shell", "bash|zsh|fish", "", groups, examples, run};

} // namespace gonio::cli
