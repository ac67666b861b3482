#include "../read_words.hpp"

#include "../arguments.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace gonio::cli {

namespace {

// As of CLI11: "-5" is an option, "-" and "- " are words.
bool begins_option(std::string_view word, std::size_t dashes) {
    constexpr std::string_view no_names = "-! \n";
    return word.size() > dashes && word.substr(0, dashes).find_first_not_of('-') == std::string_view::npos &&
           no_names.find(word[dashes]) == std::string_view::npos;
}

} // namespace

Result<ReadWords> read_words(const Command& command, std::span<const Option* const> options,
                             std::span<char* const> words) {
    ReadWords read;
    read.options.resize(options.size());
    std::optional<std::string> unknown; // the first one; other errors count only without it
    const auto refuse = [&](Unexpected error) {
        return unknown ? unknown_option(command, options, *unknown) : std::move(error);
    };
    bool words_alone = false; // after "--"
    for (std::size_t next = 0; next < words.size();) {
        const std::string_view whole = words[next++];
        const bool is_long = begins_option(whole, 2);
        if (words_alone || (!is_long && !begins_option(whole, 1))) {
            if (!words_alone && whole == "--")
                words_alone = true;
            else
                read.positional.emplace_back(whole);
            continue;
        }
        // "--name=value"; "-abc" are switches, of which the last may be an option with its value.
        for (std::string word(whole); !word.empty();) {
            const std::size_t end = is_long ? std::min(word.find('='), word.size()) : 2;
            const std::string name = word.substr(0, end);
            std::string value = is_long ? word.substr(std::min(end + 1, word.size())) : word.substr(end);
            const std::string given = std::exchange(word, {});
            const auto found = std::find_if(options.begin(), options.end(), [&](const Option* option) {
                const std::vector<std::string_view> names = spellings(*option);
                return std::find(names.begin(), names.end(), name) != names.end();
            });
            if (found == options.end()) {
                if (!unknown) unknown = given;
                break;
            }
            ReadWords::Given& to = read.options[static_cast<std::size_t>(found - options.begin())];
            to.present = true;
            if ((*found)->value.empty()) {
                if (is_long && !value.empty()) return refuse(takes_no_value(command, name));
                if (!is_long && !value.empty()) word = "-" + value;
                continue;
            }
            if (value.empty()) {
                if (next == words.size()) return refuse(needs_value(command, spellings(**found).back()));
                value = words[next++];
            }
            to.values.push_back(std::move(value));
        }
    }
    if (unknown) return unknown_option(command, options, *unknown);
    return read;
}

} // namespace gonio::cli
