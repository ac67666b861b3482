// FileScope: which files a description may name, and which files it has named.
//
// A rig or a record from an untrusted source must not make gonio read arbitrary files: it may name regular files under
// one folder (its own), with symbolic links resolved. Nothing is opened here, so a pipe without a writer is rejected
// without waiting.
#pragma once

#include <gonio/base/result.hpp>

#include <set>
#include <string>

namespace gonio {

class FileScope {
public:
    // Regular files under `folder` (empty: the current one). `hint` is the advice when a file is rejected, for example
    // a command's option that allows more; without it the advice is to put the file under the folder.
    static FileScope under(std::string folder, std::string hint = {});

    // Any file; relative names are looked up in `folder` (empty: the current one).
    static FileScope anywhere(std::string folder = {});

    // Where to read a file of that name: an absolute name as it is, a relative one in the folder. Fails (io) on a path
    // outside the folder and on anything that is neither a regular file nor a folder. A path that does not exist is
    // returned; reading it fails.
    Result<std::string> path_of(const std::string& name);

    // All paths that path_of() returned, each once, sorted byte by byte.
    const std::set<std::string>& named() const { return named_; }

private:
    FileScope(std::string folder, bool bounded, std::string hint);

    std::string folder_;
    std::string real_folder_; // with all links resolved; empty where it cannot be found
    bool bounded_;
    std::string hint_;
    std::set<std::string> named_;
};

// The folder that holds `path`, as FileScope takes it: empty for a plain name, "-" included.
std::string folder_of_file(const std::string& path);

} // namespace gonio
