#include <gonio/base/file_scope.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

namespace gonio {

namespace {

namespace fs = std::filesystem;

// The path with all links resolved as far as it exists, the rest as written. Empty if the system reports an error.
fs::path behind_links(const fs::path& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    if (error) return {};
    fs::path real = fs::weakly_canonical(absolute, error);
    return error ? fs::path() : real;
}

bool lies_under(const fs::path& path, const fs::path& folder) {
    if (path.empty() || folder.empty()) return false;
    // "/a/" has an empty last part.
    const auto end = folder.has_filename() ? folder.end() : std::prev(folder.end());
    return std::mismatch(folder.begin(), end, path.begin(), path.end()).first == end;
}

std::string shown(const std::string& folder) {
    return folder.empty() ? std::string("the current folder") : fmt::format("the folder '{}'", folder);
}

} // namespace

FileScope::FileScope(std::string folder, bool bounded, std::string hint)
    : folder_(std::move(folder)), bounded_(bounded), hint_(std::move(hint)) {
    if (bounded_) real_folder_ = behind_links(folder_.empty() ? fs::path(".") : fs::path(folder_)).string();
}

FileScope FileScope::under(std::string folder, std::string hint) {
    return {std::move(folder), true, std::move(hint)};
}

FileScope FileScope::anywhere(std::string folder) {
    return {std::move(folder), false, {}};
}

Result<std::string> FileScope::path_of(const std::string& name) {
    std::string path = name;
    if (!folder_.empty() && !name.starts_with('/'))
        path = folder_.ends_with('/') ? folder_ + name : folder_ + '/' + name;
    if (bounded_) {
        if (!lies_under(behind_links(path), real_folder_))
            return fail("FIL0105", fmt::format("the file '{}' is outside {}", name, shown(folder_)),
                        hint_.empty() ? "put it under that folder" : hint_);
        std::error_code error;
        const fs::file_status status = fs::status(path, error);
        if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
            return fail("FIL0105", fmt::format("'{}' in {} is not a regular file", name, shown(folder_)), hint_);
    }
    named_.insert(path);
    return path;
}

std::string folder_of_file(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? std::string() : path.substr(0, std::max<std::size_t>(slash, 1));
}

} // namespace gonio
