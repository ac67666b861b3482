#include "arguments.hpp"

#include <gonio/base/nearest.hpp>
#include <gonio/base/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

// An unknown option: the nearest known one is suggested.
Unexpected unknown_option(const Command& command, std::string_view word, const std::string& see) {
    std::vector<std::string_view> known;
    for (const Option* option : options_of(command))
        for (const std::string_view name : spellings(*option))
            known.push_back(name);
    const std::string_view bare = word.substr(0, word.find('='));
    const std::string_view guess = bare.size() > 2 ? nearest(bare, known) : std::string_view();
    return fail("USE0102", fmt::format("unknown option '{}'", bare),
                guess.empty() ? see : fmt::format("did you mean '{}'?", guess));
}

// The first long spelling, or else the first one.
std::string_view name_of(const Option& option) {
    const std::vector<std::string_view> names = spellings(option);
    const auto found =
        std::find_if(names.begin(), names.end(), [](std::string_view name) { return name.starts_with("--"); });
    return found == names.end() ? names.front() : *found;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// A word that begins with a dash: --name, --name=value, -n, -nVALUE, or flags in one word, -abc.
struct DashedWord {
    std::string_view name;                 // "--name", "-n"
    std::optional<std::string_view> value; // behind '='
    std::string_view rest;                 // behind the letter of a short option

    explicit DashedWord(std::string_view word) {
        if (word.starts_with("--")) {
            name = word.substr(0, word.find('='));
            if (name.size() < word.size()) value = word.substr(name.size() + 1);
        } else {
            name = word.substr(0, 2);
            rest = word.substr(2);
        }
    }
};

// The words of a command line, sorted by the options that they belong to.
class WordReader {
public:
    struct Given {
        std::vector<std::string> values;
        bool present = false;
    };
    std::vector<Given> given; // by option
    std::vector<std::string> positional;

    WordReader(const Command& command, std::span<const Option* const> options, std::span<char* const> words)
        : given(options.size()),
          command_(command),
          options_(options),
          words_(words),
          see_(fmt::format("see 'gonio {} --help'", command.name)) {}

    Result<void> read() {
        bool only_words = false;
        while (next_ < words_.size()) {
            const std::string_view word = words_[next_++];
            if (only_words || !is_option(word)) {
                positional.emplace_back(word);
            } else if (word == "--") {
                only_words = true;
            } else if (Result<void> taken = take(word); !taken && !unknown_) {
                return taken;
            }
        }
        if (unknown_) return unknown_option(command_, *unknown_, see_);
        return {};
    }

private:
    const Command& command_;
    std::span<const Option* const> options_;
    std::span<char* const> words_;
    std::string see_;
    std::size_t next_ = 0;
    std::optional<std::string_view> unknown_; // the first; it is said before anything else that is wrong

    // The number of options if there is none of that name.
    std::size_t index_of(std::string_view name) const {
        const auto has_name = [&](const Option* option) {
            const std::vector<std::string_view> names = spellings(*option);
            return std::find(names.begin(), names.end(), name) != names.end();
        };
        const auto found = std::find_if(options_.begin(), options_.end(), has_name);
        return static_cast<std::size_t>(found - options_.begin());
    }

    // "-" is standard input, "-1,2" numbers unless there is an option "-1".
    bool is_option(std::string_view word) const {
        if (word.size() < 2 || word.front() != '-') return false;
        return !is_digit(word[1]) || index_of(word.substr(0, 2)) < options_.size();
    }

    Result<void> take(std::string_view word) {
        std::string flags; // what is left of flags in one word
        for (DashedWord dashed(word);; dashed = DashedWord(flags)) {
            const std::size_t i = index_of(dashed.name);
            if (i == options_.size()) {
                if (!unknown_) unknown_ = word;
                return {};
            }
            given[i].present = true;
            if (!options_[i]->value.empty()) return take_value(i, dashed);
            if (dashed.value) return fail("USE0105", fmt::format("'{}' takes no value", dashed.name), see_);
            if (dashed.rest.empty()) return {};
            flags = "-" + std::string(dashed.rest);
        }
    }

    // A value may begin with a dash.
    Result<void> take_value(std::size_t i, const DashedWord& dashed) {
        std::vector<std::string>& values = given[i].values;
        if (dashed.value)
            values.emplace_back(*dashed.value);
        else if (!dashed.rest.empty())
            values.emplace_back(dashed.rest);
        else if (next_ < words_.size())
            values.emplace_back(words_[next_++]);
        else
            return fail("USE0104", fmt::format("option '{}' needs a value", name_of(*options_[i])), see_);
        return {};
    }
};

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

    WordReader reader(command, options, words);
    if (Result<void> read = reader.read(); !read) return pass_on(read);
    arguments.positional_ = std::move(reader.positional);
    for (std::size_t i = 0; i < options.size(); ++i) {
        Given& given = arguments.given_[i];
        given.name = spellings(*options[i]).back();
        given.present = reader.given[i].present;
        given.values = std::move(reader.given[i].values);
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
