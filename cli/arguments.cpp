#include "arguments.hpp"

#include <gonio/base/nearest.hpp>
#include <gonio/base/text.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace gonio::cli {

namespace {

std::vector<const Option*> options_of(const Command& command) {
    std::vector<const Option*> all;
    for (const OptionGroup& group : command.groups)
        for (const Option& option : group.options)
            all.push_back(&option);
    return all;
}

// Whether its value is a list with commas ("TARGET,…"): given again, it is a longer list.
bool is_list(const Option& option) {
    return option.value.ends_with(",…");
}

// The message for what CLI11 refused.
Unexpected refused(const Command& command, const CLI::ParseError& error, const CLI::App& app) {
    const std::string see = fmt::format("see 'gonio {} --help'", command.name);
    for (const std::string& word : app.remaining()) {
        if (!word.starts_with("-")) continue;
        std::vector<std::string_view> known;
        for (const Option* option : options_of(command))
            for (const std::string_view name : spellings(*option))
                known.push_back(name);
        const std::string bare = word.substr(0, word.find('='));
        const std::string_view guess = bare.size() > 2 ? nearest(bare, known) : std::string_view();
        return fail("USE0102", fmt::format("unknown option '{}'", bare),
                    guess.empty() ? see : fmt::format("did you mean '{}'?", guess));
    }
    // The text by CLI11 is "--shape: 1 required TEXT missing".
    const std::string_view said = error.what();
    constexpr std::string_view override = " was given a disallowed flag override"; // --json=1
    if (said.ends_with(override))
        return fail("USE0105", fmt::format("'--{}' takes no value", said.substr(0, said.size() - override.size())),
                    see);
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
        return fail("USE0104", fmt::format("option '{}' needs a value", said.substr(0, said.find(':'))), see);
    return fail("USE0105", std::string(said), see);
}

} // namespace

std::vector<std::string_view> spellings(const Option& option) {
    std::vector<std::string_view> names;
    std::string_view rest = option.names;
    for (std::size_t comma = rest.find(','); comma != std::string_view::npos; comma = rest.find(',')) {
        names.push_back(rest.substr(0, comma));
        rest.remove_prefix(comma + 1);
    }
    names.push_back(rest);
    return names;
}

Result<Arguments> Arguments::parse(const Command& command, std::span<char* const> words) {
    Arguments arguments;
    const std::vector<const Option*> options = options_of(command);
    arguments.given_.resize(options.size());

    CLI::App app;
    app.set_help_flag();
    std::vector<CLI::Option*> handles;
    for (std::size_t i = 0; i < options.size(); ++i) {
        Given& given = arguments.given_[i];
        given.name = spellings(*options[i]).back();
        const std::string names(options[i]->names);
        if (options[i]->value.empty()) {
            handles.push_back(app.add_flag(names)->disable_flag_override());
        } else {
            handles.push_back(app.add_option(names, given.values)
                                  ->type_size(1)
                                  ->expected(1)
                                  ->allow_extra_args(false)
                                  ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
        }
    }
    app.add_option("words", arguments.positional_)->expected(-1);

    // CLI11 takes the words in reverse order.
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    try {
        app.parse(std::move(reversed));
    } catch (const CLI::ParseError& error) {
        return refused(command, error, app);
    }
    for (std::size_t i = 0; i < options.size(); ++i) {
        Given& given = arguments.given_[i];
        given.present = handles[i]->count() > 0;
        if (is_list(*options[i]) && given.values.size() > 1)
            given.values = {fmt::format("{}", fmt::join(given.values, ","))};
        if (given.values.size() > 1 && !options[i]->repeatable)
            return fail("USE0107",
                        fmt::format("{} is given {} times: '{}' and '{}'", given.name, given.values.size(),
                                    given.values[0], given.values[1]),
                        "give it once");
    }
    arguments.take_rig();
    return arguments;
}

// `gonio preview room.json` is `gonio preview --rig room.json`: no profile is JSON.
void Arguments::take_rig() {
    if (positional_.size() != 1 || !ends_with_any_case(positional_[0], ".json")) return;
    for (Given& given : given_) { // every option of the command
        if (given.name != "--rig" || given.present) continue;
        given.values = std::exchange(positional_, {});
        given.present = true;
        return;
    }
}

const Arguments::Given& Arguments::find(std::string_view name) const {
    static const Given nothing;
    const auto found =
        std::find_if(given_.begin(), given_.end(), [&](const Given& given) { return given.name == name; });
    return found == given_.end() ? nothing : *found;
}

bool Arguments::has(std::string_view name) const {
    return find(name).present;
}

bool Arguments::offers(std::string_view name) const {
    return std::any_of(given_.begin(), given_.end(), [&](const Given& given) { return given.name == name; });
}

std::optional<std::string> Arguments::value(std::string_view name) const {
    const Given& given = find(name);
    if (given.values.empty()) return std::nullopt;
    return given.values.back();
}

std::vector<std::string> Arguments::values(std::string_view name) const {
    return find(name).values;
}

} // namespace gonio::cli
