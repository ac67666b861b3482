#include "read_words.hpp"

#include <CLI/CLI.hpp>

#include <utility>

namespace gonio::cli {

namespace {

// The message for what CLI11 refused.
Unexpected refused(const Command& command, std::span<const Option* const> options, const CLI::ParseError& error,
                   const CLI::App& app) {
    for (const std::string& word : app.remaining())
        if (word.starts_with("-")) return unknown_option(command, options, word);
    // The text by CLI11 is "--shape: 1 required TEXT missing".
    const std::string_view said = error.what();
    constexpr std::string_view override = " was given a disallowed flag override"; // --json=1
    if (said.ends_with(override))
        return takes_no_value(command, "--" + std::string(said.substr(0, said.size() - override.size())));
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
        return needs_value(command, said.substr(0, said.find(':')));
    return fail("USE0105", std::string(said), see_help(command));
}

} // namespace

Result<ReadWords> read_words(const Command& command, std::span<const Option* const> options,
                             std::span<char* const> words) {
    ReadWords read;
    read.options.resize(options.size());
    CLI::App app;
    app.set_help_flag();
    std::vector<CLI::Option*> handles;
    for (std::size_t i = 0; i < options.size(); ++i) {
        const std::string names(options[i]->names);
        if (options[i]->value.empty()) {
            handles.push_back(app.add_flag(names)->disable_flag_override());
        } else {
            handles.push_back(app.add_option(names, read.options[i].values)
                                  ->type_size(1)
                                  ->expected(1)
                                  ->allow_extra_args(false)
                                  ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
        }
    }
    app.add_option("words", read.positional)->expected(-1);

    // CLI11 takes the words in reverse order.
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    try {
        app.parse(std::move(reversed));
    } catch (const CLI::ParseError& error) {
        return refused(command, options, error, app);
    }
    for (std::size_t i = 0; i < options.size(); ++i)
        read.options[i].present = handles[i]->count() > 0;
    return read;
}

} // namespace gonio::cli
