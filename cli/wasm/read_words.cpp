#include "../read_words.hpp"

#include "../arguments.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

// As of CLI11: "-5" is a word, since no option is a digit, and so are "-" and "- ".
bool begins_option(std::string_view word, std::size_t dashes) {
    constexpr std::string_view no_names = "-! \n";
    return word.size() > dashes && word.substr(0, dashes).find_first_not_of('-') == std::string_view::npos &&
           no_names.find(word[dashes]) == std::string_view::npos && (dashes > 1 || word[1] < '0' || word[1] > '9');
}

// The name by which CLI11 speaks of an option: its first long one.
std::string_view spoken_name(const Option& option) {
    const std::vector<std::string_view> names = spellings(option);
    const auto found = std::find_if(names.begin(), names.end(), [](auto name) { return name.starts_with("--"); });
    return found == names.end() ? names.front() : *found;
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
    bool words_alone = false;        // after "--"
    std::optional<std::string> rest; // of a group of switches: a word of its own
    for (std::size_t next = 0; rest || next < words.size();) {
        const std::string whole = rest ? *std::exchange(rest, {}) : std::string(words[next++]);
        const bool is_long = begins_option(whole, 2);
        if (words_alone || (!is_long && !begins_option(whole, 1))) {
            if (!words_alone && whole == "--")
                words_alone = true;
            else
                read.positional.emplace_back(whole);
            continue;
        }
        // "--name=value"; "-abc" are switches, of which the last may be an option with its value.
        const std::size_t end = is_long ? std::min(whole.find('='), whole.size()) : 2;
        const std::string name = whole.substr(0, end);
        std::string value = is_long ? whole.substr(std::min(end + 1, whole.size())) : whole.substr(end);
        const auto found = std::find_if(options.begin(), options.end(), [&](const Option* option) {
            const std::vector<std::string_view> names = spellings(*option);
            return std::find(names.begin(), names.end(), name) != names.end();
        });
        if (found == options.end()) {
            if (!unknown) unknown = whole;
            continue;
        }
        ReadWords::Given& to = read.options[static_cast<std::size_t>(found - options.begin())];
        to.present = true;
        if ((*found)->value.empty()) {
            // CLI11 takes both for the switch itself.
            const bool is_switch = value.empty() || value == "true" || value == "{}";
            if (is_long && !is_switch) return refuse(takes_no_value(command, name));
            if (!is_long && !value.empty()) rest = "-" + value;
            continue;
        }
        if (value.empty()) {
            if (next == words.size()) return refuse(needs_value(command, spoken_name(**found)));
            value = words[next++];
        }
        to.values.push_back(std::move(value));
    }
    if (unknown) return unknown_option(command, options, *unknown);
    return read;
}

} // namespace gonio::cli
