#include <gonio/base/atomic_file.hpp>

#include <climits>
#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace gonio {

namespace {

// strerror's text depends on the locale only where a program calls setlocale, which gonio never does.
std::string reason(int error) {
    std::array<char, 256> buffer{};
    return strerror_r(error, buffer.data(), buffer.size());
}

std::string hint_for(int error, const std::string& path) {
    switch (error) {
    case ENOENT: {
        const std::size_t slash = path.rfind('/');
        if (slash != std::string::npos && slash > 0 && !file_exists(path.substr(0, slash)))
            return fmt::format("the folder '{}' does not exist", path.substr(0, slash));
        return {};
    }
    case EFBIG:
        return "the file size limit of this process was reached (ulimit -f)";
    case ENOSPC:
        return "free some space, or write elsewhere";
    case EACCES:
        return "check the permissions of the file and of its folder";
    default:
        return {};
    }
}

Unexpected io_failure(const char* verb, const std::string& path, int error) {
    return fail(Failure::io, fmt::format("cannot {}: {}", verb, reason(error)), hint_for(error, path), path);
}

class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    int get() const { return fd_; }
    // Closes now; errors of delayed writes (NFS, quota) show up here.
    int close() {
        const int result = ::close(std::exchange(fd_, -1));
        return result == 0 ? 0 : errno;
    }

private:
    int fd_;
};

Result<void> check_readable(int fd, const std::string& path) {
    if (fd < 0) return io_failure("read", path, errno);
    struct stat status {};
    if (::fstat(fd, &status) == 0 && S_ISDIR(status.st_mode))
        return fail(Failure::io, "cannot read: it is a folder", "name a file in it", path);
    return {};
}

Result<std::string> read_all(int fd, const std::string& name, const Limit& most) {
    std::string bytes;
    std::size_t used = 0;
    std::size_t step = std::size_t{64} << 10;
    struct stat status {};
    if (::fstat(fd, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0)
        step = std::min(static_cast<std::size_t>(status.st_size) + 1, std::size_t{16} << 20);
    for (;;) {
        if (used == bytes.size()) bytes.resize(used + std::max(step, used));
        const ssize_t got = ::read(fd, bytes.data() + used, bytes.size() - used);
        if (got < 0) {
            if (errno == EINTR) continue;
            return io_failure("read", name, errno);
        }
        if (got == 0) break;
        used += static_cast<std::size_t>(got);
        if (used > most.value)
            return fail(Failure::io, fmt::format("larger than {}", to_text(most)), std::string(limits_hint), name);
    }
    bytes.resize(used);
    return bytes;
}

// 0, or the errno of the failure.
int write_all(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(fd, bytes.data(), std::min(bytes.size(), std::size_t{1} << 30));
        if (put < 0) {
            if (errno == EINTR) continue;
            return errno;
        }
        bytes.remove_prefix(static_cast<std::size_t>(put));
    }
    return 0;
}

Result<void> write_in_place(const std::string& path, std::string_view bytes) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    if (file.get() < 0) return io_failure("write", path, errno);
    if (const int error = write_all(file.get(), bytes); error != 0) return io_failure("write", path, error);
    if (const int error = file.close(); error != 0) return io_failure("write", path, error);
    return {};
}

// The file behind symbolic links, so that a rename replaces the file and not the link.
std::string behind_links(const std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> resolved(::realpath(path.c_str(), nullptr), &std::free);
    return resolved ? std::string(resolved.get()) : path;
}

} // namespace

Result<std::string> read_file(const std::string& path, const Limit& most) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
    if (Result<void> readable = check_readable(file.get(), path); !readable) return pass_on(readable);
    return read_all(file.get(), path, most);
}

Result<std::string> read_file_start(const std::string& path, std::size_t count) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
    if (Result<void> readable = check_readable(file.get(), path); !readable) return pass_on(readable);
    std::string bytes(count, '\0');
    std::size_t used = 0;
    while (used < count) {
        const ssize_t got = ::read(file.get(), bytes.data() + used, count - used);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return io_failure("read", path, errno);
        if (got == 0) break;
        used += static_cast<std::size_t>(got);
    }
    bytes.resize(used);
    return bytes;
}

Result<std::string> read_standard_input(const Limit& most) {
    return read_all(STDIN_FILENO, "-", most);
}

Result<void> write_file(const std::string& path, std::string_view bytes) {
    if (path.empty()) return fail(Failure::io, "cannot write: the file name is empty");
    struct stat status {};
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode))
        return fail(Failure::io, "cannot write: it is a folder", "name a file in it", path);
    if (exists && !S_ISREG(status.st_mode)) return write_in_place(path, bytes);
    if (exists && ::access(path.c_str(), W_OK) != 0) return io_failure("write", path, errno);

    const std::string target = behind_links(path);
    const mode_t mode = exists ? status.st_mode & 07777 : 0666;
    std::string temporary;
    int fd = -1;
    // O_EXCL makes the name ours; a left-over of a killed run with the same process id is stepped over.
    for (int attempt = 0; attempt < 100 && fd < 0; ++attempt) {
        temporary = fmt::format("{}.{}-{}.tmp", target, ::getpid(), attempt);
        fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (fd < 0 && errno != EEXIST) break;
    }
    if (fd < 0) return io_failure("write", path, errno);

    Descriptor file(fd);
    int error = write_all(fd, bytes);
    if (error == 0 && exists && ::fchmod(fd, mode) != 0) error = errno;
    if (const int closing = file.close(); error == 0) error = closing;
    if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
    if (error != 0) {
        ::unlink(temporary.c_str());
        return io_failure("write", path, error);
    }
    return {};
}

Result<void> write_standard_output(std::string_view bytes) {
    if (const int error = write_all(STDOUT_FILENO, bytes); error != 0)
        return io_failure("write", "standard output", error);
    return {};
}

bool file_exists(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0;
}

bool is_newer(const std::string& path, const std::string& other) {
    struct stat a {};
    struct stat b {};
    if (::stat(path.c_str(), &a) != 0 || ::stat(other.c_str(), &b) != 0) return true;
    if (a.st_mtim.tv_sec != b.st_mtim.tv_sec) return a.st_mtim.tv_sec > b.st_mtim.tv_sec;
    return a.st_mtim.tv_nsec > b.st_mtim.tv_nsec;
}

std::string executable_folder() {
    std::array<char, PATH_MAX> buffer{};
    const ssize_t length = ::readlink("/proc/self/exe", buffer.data(), buffer.size());
    if (length <= 0 || static_cast<std::size_t>(length) >= buffer.size()) return {};
    const std::string path(buffer.data(), static_cast<std::size_t>(length));
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

} // namespace gonio
