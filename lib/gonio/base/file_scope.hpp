// FileScope: which files a description may name, and which it has named.
//
// A rig or a record from somebody else must not make gonio read any file: it may name regular files under one folder
// (its own), with symbolic links resolved. Nothing is opened here, so a pipe that nobody writes into is
// refused without waiting.
#pragma once

#include <gonio/base/result.hpp>

#include <set>
#include <string>

namespace gonio {

class FileScope {
public:
    // Regular files under `folder` (empty: the current one). `hint` is what a refusal advises, as a command's option
    // that allows more; without it the advice is to put the file under the folder.
    static FileScope under(std::string folder, std::string hint = {});

    // Any file; relative names are looked up in `folder` (empty: the current one).
    static FileScope anywhere(std::string folder = {});

    // Where a file of that name is to be read: an absolute name as it is, a relative one behind the folder. Fails (io)
    // on what lies outside or is neither a regular file nor a folder. What does not exist is left to the reading to
    // fail.
    Result<std::string> path_of(const std::string& name);

    // All that path_of() answered, each once, sorted byte by byte.
    const std::set<std::string>& named() const { return named_; }

private:
    FileScope(std::string folder, bool bounded, std::string hint);

    std::string folder_;
    std::string real_folder_; // behind all links; empty where it cannot be found
    bool bounded_;
    std::string hint_;
    std::set<std::string> named_;
};

// The folder that holds `path`, as FileScope takes it: empty for a plain name, "-" included.
std::string folder_of_file(const std::string& path);

} // namespace gonio
