// The parsed words after a command's name.
#pragma once

#include <gonio/base/result.hpp>

#include "command.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

class Arguments {
public:
    // Fails (usage) on an unknown option (the error names the nearest one), on an option without its value and on one
    // that was given twice and is not repeatable.
    static Result<Arguments> parse(const Command& command, std::span<char* const> words);

    // Whether a switch or option was given, by its last spelling: "--json".
    bool has(std::string_view name) const;

    // Whether the command has the option.
    bool offers(std::string_view name) const;

    // The value of an option; the last one if it is repeatable and was repeated.
    std::optional<std::string> value(std::string_view name) const;

    // All values of an option, in their order.
    std::vector<std::string> values(std::string_view name) const;

    const std::vector<std::string>& positional() const { return positional_; }

private:
    struct Given {
        std::string_view name;
        std::vector<std::string> values;
        bool present = false;
    };

    const Given& find(std::string_view name) const;
    void take_rig();

    std::vector<Given> given_;
    std::vector<std::string> positional_;
};

// The spellings of an option: "-o", "--output".
std::vector<std::string_view> spellings(const Option& option);

} // namespace gonio::cli
