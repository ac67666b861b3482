#include <gonio/base/folder.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace gonio {

namespace {

namespace fs = std::filesystem;

Unexpected unreadable(const std::string& folder, const std::error_code& error) {
    return fail("FIL0102", "cannot read the folder: " + error.message(), {}, folder);
}

bool ends_in(std::string_view name, std::span<const std::string_view> extensions) {
    const std::string extension = to_lower(extension_of(name));
    return !extension.empty() && std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

} // namespace

bool is_folder(const std::string& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

std::string absolute_name(const std::string& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    return (error ? fs::path(path) : absolute).lexically_normal().string();
}

Result<void> make_folder(const std::string& path) {
    std::error_code error;
    fs::create_directory(path, error);
    if (error) return fail("FIL0103", "cannot create the folder: " + error.message(), {}, path);
    if (!is_folder(path)) return fail(Failure::io, "this is a file, not a folder", {}, path);
    return {};
}

Result<void> make_folders_of(const std::string& folder, std::string_view path) {
    for (std::size_t slash = path.find('/'); slash != std::string_view::npos; slash = path.find('/', slash + 1))
        if (Result<void> made = make_folder(folder + "/" + std::string(path.substr(0, slash))); !made) return made;
    return {};
}

Result<std::vector<std::string>> files_in(const std::string& folder, std::span<const std::string_view> extensions) {
    std::vector<std::string> files;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, error);
    if (error) return unreadable(folder, error);
    while (entry != fs::recursive_directory_iterator()) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.'))
            entry.disable_recursion_pending();
        else if (ends_in(name, extensions) && entry->is_regular_file(error) && !error)
            files.push_back(entry->path().string());
        const std::string at = entry->path().string();
        entry.increment(error);
        if (error) return unreadable(at, error);
    }
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace gonio
