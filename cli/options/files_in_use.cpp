#include "files_in_use.hpp"

#include <gonio/base/file.hpp>

#include <fmt/format.h>

namespace gonio::cli {

FilesInUse::FilesInUse(std::span<const std::string> inputs) {
    for (const std::string& input : inputs) {
        if (input == "-") continue;
        if (std::string identity = file_identity(input); !identity.empty()) inputs_.emplace(std::move(identity), input);
    }
}

Result<void> FilesInUse::check(const std::string& output) const {
    return output == "-" ? Result<void>() : check(output, file_identity(output));
}

Result<void> FilesInUse::check(const std::string& output, const std::string& identity) const {
    const auto input = inputs_.find(identity);
    if (input == inputs_.end()) return {};
    return fail("USE0108",
                input->second == output
                    ? fmt::format("the output '{}' is an input and would be replaced", output)
                    : fmt::format("the output '{}' is the same file as the input '{}' and would be replaced", output,
                                  input->second),
                "give the output another name or folder");
}

Result<void> FilesInUse::take(const std::string& output) {
    std::string identity = output == "-" ? output : file_identity(output);
    if (Result<void> free = check(output, identity); !free) return free;
    if (identity.empty()) return {};
    const auto [other, is_new] = outputs_.emplace(std::move(identity), output);
    if (is_new) return {};
    if (output == "-") return fail("USE0108", "two outputs would go to stdout", "write one of them to a file");
    return fail("USE0108",
                other->second == output
                    ? fmt::format("two outputs would be written to '{}'", output)
                    : fmt::format("the outputs '{}' and '{}' are the same file", other->second, output),
                "give them different names");
}

Result<void> check_outputs(std::span<const std::string> inputs, std::span<const std::string> outputs) {
    FilesInUse files(inputs);
    for (const std::string& output : outputs)
        if (Result<void> free = files.take(output); !free) return free;
    return {};
}

} // namespace gonio::cli
