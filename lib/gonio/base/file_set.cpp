#include <gonio/base/detail/posix_file.hpp>
#include <gonio/base/detail/temporary_files.hpp>
#include <gonio/base/file_set.hpp>
#include <gonio/base/path.hpp>

#include <climits>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <fcntl.h>
#include <map>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using detail::Descriptor;
using detail::io_failure;
using detail::Temporary;

// The target of a symbolic link, so that a rename replaces the file and not the link; it need not exist.
std::string behind_links(std::string path) {
    const std::unique_ptr<char, decltype(&std::free)> resolved(::realpath(path.c_str(), nullptr), &std::free);
    if (resolved) return resolved.get();
    constexpr int most_links = 40; // as many as Linux follows
    for (int i = 0; i < most_links; ++i) {
        std::string target(PATH_MAX, '\0');
        const ssize_t length = ::readlink(path.c_str(), target.data(), target.size());
        if (length <= 0) break;
        target.resize(static_cast<std::size_t>(length));
        if (!target.starts_with('/')) target.insert(0, path, 0, path.rfind('/') + 1);
        path = std::move(target);
    }
    return path;
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

// A file waiting for its final name.
struct Staged {
    std::string path; // as it was named, for messages
    std::string name; // of the target in its folder
    int folder = -1;
    Temporary* temporary = nullptr;
    Temporary* old = nullptr; // the previous file, to undo with
    bool replaces = false;    // the target existed
};

// A device, a pipe, a terminal.
struct Direct {
    std::string path;
    std::string bytes;
};

// In place of RENAME_EXCHANGE and RENAME_NOREPLACE, which not every system has.
enum class RenameWay { exchange, to_new };

// Fails where the file system cannot do it, without a file of the other name to exchange with, or with one to_new.
int rename_by([[maybe_unused]] RenameWay way, [[maybe_unused]] int folder, [[maybe_unused]] const char* from,
              [[maybe_unused]] const char* to) {
#if defined(RENAME_EXCHANGE) && defined(RENAME_NOREPLACE)
    return ::renameat2(folder, from, folder, to, way == RenameWay::exchange ? RENAME_EXCHANGE : RENAME_NOREPLACE);
#else
    errno = ENOSYS;
    return -1;
#endif
}

bool is_folder_at(int folder, const char* name) {
    struct stat status {};
    return ::fstatat(folder, name, &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISDIR(status.st_mode);
}

// Gives a file its name and keeps the previous file of that name. Returns 0 or the errno of the failure.
int take_name(Staged& file, bool undoable) {
    const char* const temporary = file.temporary->name.data();
    const char* const name = file.name.c_str();
    if (undoable && !file.replaces && rename_by(RenameWay::to_new, file.folder, temporary, name) == 0) {
        detail::forget(*std::exchange(file.temporary, nullptr));
        return 0;
    }
    if (undoable && rename_by(RenameWay::exchange, file.folder, temporary, name) == 0) {
        if (is_folder_at(file.folder, temporary)) { // a folder was created while the file was written
            (void)rename_by(RenameWay::exchange, file.folder, temporary, name);
            return EISDIR;
        }
        file.old = std::exchange(file.temporary, nullptr);
        return 0;
    }
    // The file system does not support an exchange (NFS), or there is nothing to exchange with.
    if (undoable)
        file.old = detail::make_temporary(
            file.folder, [&](const char* backup) { return ::linkat(file.folder, name, file.folder, backup, 0) == 0; });
    if (::renameat(file.folder, temporary, file.folder, name) != 0) return errno;
    detail::forget(*std::exchange(file.temporary, nullptr));
    return 0;
}

void give_name_back(Staged& file) {
    if (file.old != nullptr) {
        // If even that fails, the previous file keeps its temporary name: it is never removed.
        (void)::renameat(file.folder, file.old->name.data(), file.folder, file.name.c_str());
        detail::forget(*std::exchange(file.old, nullptr));
    } else if (!file.replaces) {
        ::unlinkat(file.folder, file.name.c_str(), 0);
    }
}

} // namespace

struct FileSet::State {
    FileSetOptions options;
    std::map<std::string, Descriptor> folders;
    std::deque<Staged> staged;
    std::vector<Direct> direct;

    explicit State(FileSetOptions chosen) : options(chosen) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() { clear(); }

    void clear() {
        for (Staged& file : staged)
            for (Temporary* const left : {std::exchange(file.temporary, nullptr), std::exchange(file.old, nullptr)})
                if (left != nullptr) detail::discard(*left);
        staged.clear();
        direct.clear();
        folders.clear();
    }

    // A descriptor, so that the temporary name fits wherever the target's path does; -1 sets errno.
    int open_folder(const std::string& path) {
        const auto found = folders.find(path);
        if (found != folders.end()) return found->second.get();
        // O_PATH needs no permission to read the folder; flushing needs the folder to be opened for reading.
        Descriptor folder(::open(path.c_str(), (options.durable ? O_RDONLY : O_PATH) | O_DIRECTORY | O_CLOEXEC));
        if (folder.get() < 0) return -1;
        return folders.emplace(path, std::move(folder)).first->second.get();
    }

    Result<void> stage(const std::string& path, const std::string& target, const struct stat* existing,
                       std::string_view bytes) {
        Staged file;
        file.path = path;
        file.name = file_name(target);
        if (file.name.empty() || file.name == "." || file.name == "..")
            return fail("FIL0103", "cannot write: it is not the name of a file", {}, path);
        file.replaces = existing != nullptr;
        file.folder = open_folder(folder_of(target));
        if (file.folder < 0) return io_failure("write", path, errno);
        const mode_t mode = existing != nullptr ? existing->st_mode & 07777U : 0666U;
        int fd = -1;
        file.temporary = detail::make_temporary(file.folder, [&](const char* name) {
            fd = ::openat(file.folder, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOCTTY, mode);
            return fd >= 0;
        });
        if (file.temporary == nullptr) return io_failure("write", path, errno);
        Descriptor opened(fd);
        int error = detail::write_all(fd, bytes);
        if (error == 0 && existing != nullptr && ::fchmod(fd, mode) != 0) error = errno;
        if (error == 0 && options.durable && ::fsync(fd) != 0) error = errno;
        if (const int closing = opened.close(); error == 0) error = closing;
        if (error != 0) {
            detail::discard(*file.temporary);
            return io_failure("write", path, error);
        }
        staged.push_back(std::move(file));
        return {};
    }

    Result<void> commit() {
        for (const Direct& file : direct) {
            Descriptor opened(::open(file.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
            if (opened.get() < 0) return io_failure("write", file.path, errno);
            int error = detail::write_all(opened.get(), file.bytes);
            if (const int closing = opened.close(); error == 0) error = closing;
            if (error != 0) return io_failure("write", file.path, error);
        }
        for (std::size_t i = 0; i < staged.size(); ++i) {
            const int error = take_name(staged[i], i + 1 < staged.size());
            if (error == 0) continue;
            while (i-- > 0)
                give_name_back(staged[i]);
            return io_failure("write", failing_path(), error);
        }
        if (options.durable)
            for (const auto& [path, folder] : folders)
                if (::fsync(folder.get()) != 0 && errno != EINVAL) return io_failure("flush the folder", path, errno);
        return {};
    }

    // The path of the first file that did not get its name.
    std::string failing_path() const {
        for (const Staged& file : staged)
            if (file.temporary != nullptr) return file.path;
        return {};
    }
};

FileSet::FileSet(FileSetOptions options) : state_(std::make_unique<State>(options)) {}
FileSet::FileSet(FileSet&&) noexcept = default;
FileSet& FileSet::operator=(FileSet&&) noexcept = default;
FileSet::~FileSet() = default;

Result<void> FileSet::add(const std::string& path, std::string_view bytes) {
    if (path.empty()) return fail("FIL0103", "cannot write: the file name is empty");
    struct stat status {};
    bool exists = ::lstat(path.c_str(), &status) == 0;
    const bool is_link = exists && S_ISLNK(status.st_mode);
    if (is_link) exists = ::stat(path.c_str(), &status) == 0;
    if (!exists && errno != ENOENT) return io_failure("write", path, errno);
    if (exists && S_ISDIR(status.st_mode))
        return fail("FIL0101", "cannot write: it is a folder", "name a file in it", path);
    if (exists && ::access(path.c_str(), W_OK) != 0) return io_failure("write", path, errno);
    if (exists && !S_ISREG(status.st_mode)) {
        state_->direct.push_back({path, std::string(bytes)});
        return {};
    }
    return state_->stage(path, is_link ? behind_links(path) : path, exists ? &status : nullptr, bytes);
}

Result<void> FileSet::commit() {
    Result<void> done = state_->commit();
    state_->clear();
    return done;
}

Result<void> write_file(const std::string& path, std::string_view bytes, FileSetOptions options) {
    FileSet set(options);
    Result<void> added = set.add(path, bytes);
    return added ? set.commit() : added;
}

Result<void> check_writable(const std::string& path) {
    FileSet set;
    return set.add(path, {});
}

} // namespace gonio
