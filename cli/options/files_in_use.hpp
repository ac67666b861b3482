// The files of a command, so that no output destroys an input or another output.
//
// Files are compared by device and inode, not by name: "a", "./a", a hard link and a symbolic link to it are the same
// file. Devices and pipes may be read and written several times.
#pragma once

#include <gonio/base/result.hpp>

#include <map>
#include <span>
#include <string>

namespace gonio::cli {

class FilesInUse {
public:
    // "-" is stdin.
    explicit FilesInUse(std::span<const std::string> inputs);

    // Fails (usage) if the output is an input.
    Result<void> check(const std::string& output) const;

    // As check(), and also fails if the output was taken before, stdout ("-") included; then takes it.
    Result<void> take(const std::string& output);

private:
    Result<void> check(const std::string& output, const std::string& identity) const;

    std::map<std::string, std::string> inputs_;  // names by identity
    std::map<std::string, std::string> outputs_; // names by identity
};

// For all outputs of a command at once.
Result<void> check_outputs(std::span<const std::string> inputs, std::span<const std::string> outputs);

} // namespace gonio::cli
