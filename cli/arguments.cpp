#include "arguments.hpp"

#include <gonio/base/nearest.hpp>
#include <gonio/base/text.hpp>

#include "read_words.hpp"

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

std::string see_help(const Command& command) {
    return fmt::format("see 'gonio {} --help'", command.name);
}

Unexpected unknown_option(const Command& command, std::span<const Option* const> options, std::string_view word) {
    std::vector<std::string_view> known;
    for (const Option* option : options)
        for (const std::string_view name : spellings(*option))
            known.push_back(name);
    const std::string_view bare = word.substr(0, word.find('='));
    const std::string_view guess = bare.size() > 2 ? nearest(bare, known) : std::string_view();
    return fail("USE0102", fmt::format("unknown option '{}'", bare),
                guess.empty() ? see_help(command) : fmt::format("did you mean '{}'?", guess));
}

Unexpected needs_value(const Command& command, std::string_view option) {
    return fail("USE0104", fmt::format("option '{}' needs a value", option), see_help(command));
}

Unexpected takes_no_value(const Command& command, std::string_view option) {
    return fail("USE0105", fmt::format("'{}' takes no value", option), see_help(command));
}

Result<Arguments> Arguments::parse(const Command& command, std::span<char* const> words) {
    const std::vector<const Option*> options = options_of(command);
    Result<ReadWords> read = read_words(command, options, words);
    if (!read) return pass_on(read);
    Arguments arguments;
    arguments.positional_ = std::move(read->positional);
    for (std::size_t i = 0; i < options.size(); ++i) {
        Given given{spellings(*options[i]).back(), std::move(read->options[i].values), read->options[i].present};
        if (is_list(*options[i]) && given.values.size() > 1)
            given.values = {fmt::format("{}", fmt::join(given.values, ","))};
        if (given.values.size() > 1 && !options[i]->repeatable)
            return fail("USE0107",
                        fmt::format("{} is given {} times: '{}' and '{}'", given.name, given.values.size(),
                                    given.values[0], given.values[1]),
                        "give it once");
        arguments.given_.push_back(std::move(given));
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
