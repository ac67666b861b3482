#include <gonio/base/file.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/media/detail/open_module.hpp>
#include <gonio/media/module.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>
#include <dlfcn.h>
#include <link.h>
#include <mutex>
#include <string_view>
#include <utility>

namespace gonio::media {

namespace {

struct State {
    std::mutex mutex;
    std::vector<std::string> folders;
    const void* image = nullptr;
    const void* writers = nullptr;
    const void* color = nullptr;
    const void* pdf = nullptr;
};

State& state() {
    static State instance;
    return instance;
}

// The folder of the shared object that contains this code; empty if a program contains it.
std::string shared_object_folder() {
    Dl_info info{};
    link_map* object = nullptr; // its name is empty for the program
    if (::dladdr1(reinterpret_cast<const void*>(&shared_object_folder), &info, reinterpret_cast<void**>(&object),
                  RTLD_DL_LINKMAP) == 0 ||
        object == nullptr)
        return {};
    const std::string_view path = object->l_name;
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? std::string() : std::string(path.substr(0, slash));
}

std::vector<std::string> search_path(const std::vector<std::string>& first) {
    std::vector<std::string> folders = first;
    if (const std::string own = executable_folder(); !own.empty()) {
        folders.push_back(own);
        folders.push_back(own + "/" GONIO_MODULES_FROM_EXECUTABLE);
    }
    if (const std::string object = shared_object_folder(); !object.empty()) folders.push_back(object + "/gonio");
    return folders;
}

// Modules are never closed: their libraries keep threads and tables that outlive each use.
Result<const void*> open_once(const void* State::*slot, const detail::ModuleName& name) {
    State& shared = state();
    const std::scoped_lock lock(shared.mutex);
    if (shared.*slot == nullptr) {
        Result<const void*> table = detail::open_module(name, search_path(shared.folders));
        if (!table) return table;
        shared.*slot = *table;
    }
    return shared.*slot;
}

} // namespace

void set_module_folders(std::vector<std::string> folders) {
    State& shared = state();
    const std::scoped_lock lock(shared.mutex);
    shared.folders = std::move(folders);
}

std::vector<std::string> module_folders() {
    State& shared = state();
    const std::scoped_lock lock(shared.mutex);
    return search_path(shared.folders);
}

std::vector<std::string> opened_modules() {
    State& shared = state();
    const std::scoped_lock lock(shared.mutex);
    std::vector<std::string> files;
    if (shared.image != nullptr) files.emplace_back(detail::image_module_name.file);
    if (shared.writers != nullptr) files.emplace_back(detail::writers_module_name.file);
    if (shared.color != nullptr) files.emplace_back(detail::color_module_name.file);
    return files;
}

namespace detail {

Result<const void*> open_module(const ModuleName& name, const std::vector<std::string>& folders) {
    std::string path;
    for (const std::string& folder : folders) {
        std::string candidate = folder + '/' + name.file;
        if (!file_exists(candidate)) continue;
        path = std::move(candidate);
        break;
    }
    if (path.empty())
        return fail(
            "UNS0102",
            fmt::format("the module {} ({}) is missing; looked in {}", name.file, name.library,
                        folders.empty() ? std::string("no folder") : fmt::format("{}", fmt::join(folders, ", "))),
            "install the package gonio-media, or put the module beside the tool or into lib/gonio");

    // A library that OpenImageIO depends on starts threads while it is loaded, and aborts the process, or waits for
    // ever, if they cannot be started. Two threads more than that are required, for another process of the user.
    if (name.threads > 0 && !can_start_threads(name.threads + 2))
        return fail(
            "FIL0106",
            fmt::format("no threads can be started, and {} needs {} to be loaded", name.library, name.threads),
            "raise the limit on processes (ulimit -u) or of the container (pids.max of its cgroup), or add -j 1");

    // RTLD_LOCAL: hides the libraries behind the module from other code. No RTLD_DEEPBIND: the sanitizers forbid it,
    // and a host with its own static libstdc++ does not export a symbol that could conflict.
    void* const handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) {
        const char* const reason = ::dlerror();
        return fail("UNS0102",
                    fmt::format("the module {} cannot be loaded: {}", name.file, reason ? reason : "no reason given"),
                    fmt::format("it needs {} (Debian package {})", name.library, name.package), path);
    }
    using Entry = const void* (*)();
    const auto entry = reinterpret_cast<Entry>(::dlsym(handle, name.entry));
    const void* const table = entry ? entry() : nullptr;
    if (table == nullptr) {
        ::dlclose(handle);
        return fail("UNS0102", fmt::format("{} is not a module of gonio: it has no {}", name.file, name.entry),
                    "install gonio again", path);
    }
    std::uint32_t version = 0;
    std::memcpy(&version, table, sizeof version); // every table begins with its version
    if (version != name.version) {
        ::dlclose(handle);
        return fail(
            "UNS0102",
            fmt::format("the module {} belongs to another version of gonio: its interface has version {}, not {}",
                        name.file, version, name.version),
            "install the tool and its modules from one build", path);
    }
    return table;
}

Result<const abi::ImageModule*> image_module() {
    return open_once(&State::image, image_module_name).map([](const void* table) {
        return static_cast<const abi::ImageModule*>(table);
    });
}

Result<const abi::ImageModule*> writers_module() {
    return open_once(&State::writers, writers_module_name).map([](const void* table) {
        return static_cast<const abi::ImageModule*>(table);
    });
}

Result<const abi::ColorModule*> color_module() {
    return open_once(&State::color, color_module_name).map([](const void* table) {
        return static_cast<const abi::ColorModule*>(table);
    });
}

Result<const abi::PdfModule*> pdf_module() {
    return open_once(&State::pdf, pdf_module_name).map([](const void* table) {
        return static_cast<const abi::PdfModule*>(table);
    });
}

} // namespace detail

} // namespace gonio::media
