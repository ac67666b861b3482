// Folders and their files.
#pragma once

#include <gonio/base/result.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

// Whether `path` is a folder (links followed).
bool is_folder(const std::string& path);

// The absolute name, without "." and "..". Links are not followed; the file need not exist.
std::string absolute_name(const std::string& path);

// Creates the folder if it does not exist; its parent must exist. Fails (io) with the system's reason, and if
// a file has the name.
Result<void> make_folder(const std::string& path);

// Creates the folders of `path` below `folder`, which must exist: "a" and "a/b" for "a/b/c". Fails as make_folder().
Result<void> make_folders_of(const std::string& folder, std::string_view path);

// The regular files below `folder`, at any depth, with names that end in one of `extensions` ("ies": without the dot,
// in lower case; the case of the names does not matter), sorted by name byte by byte. Names that begin with a dot are
// left out (version control, the `._x.ies` that a copy from another system leaves behind), links to folders are not
// followed. Fails (io) when the folder or one below it cannot be read.
Result<std::vector<std::string>> files_in(const std::string& folder, std::span<const std::string_view> extensions);

} // namespace gonio
