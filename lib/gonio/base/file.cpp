#include <gonio/base/detail/posix_file.hpp>
#include <gonio/base/file.hpp>

#include <climits>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gonio {

namespace {

using detail::Descriptor;
using detail::io_failure;

// The size of a regular file that is not empty, else 0: unknown.
std::size_t known_size(const struct stat& status) {
    return S_ISREG(status.st_mode) && status.st_size > 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

// Fails if it was not opened or is a folder; returns its known_size().
Result<std::size_t> check_readable(int fd, const std::string& path) {
    if (fd < 0) return io_failure("read", path, errno);
    struct stat status {};
    if (::fstat(fd, &status) != 0) return 0;
    if (S_ISDIR(status.st_mode)) return fail("FIL0101", "cannot read: it is a folder", "name a file in it", path);
    return known_size(status);
}

// `size` is the file's known_size().
Result<std::string> read_all(int fd, const std::string& name, const Limit& most, std::size_t size) {
    std::string bytes;
    std::size_t used = 0;
    // Reserved memory is not used until bytes are there, and nothing is copied. With room for a byte more the end is
    // seen without another step.
    if (size > 0) bytes.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(size, most.value)) + 1);
    constexpr std::size_t least_step = std::size_t{64} << 10;
    constexpr std::size_t greatest_step = std::size_t{1} << 20; // what resize() clears is still in the cache
    for (;;) {
        if (used == bytes.size()) {
            const std::size_t step = std::max(least_step, used);
            bytes.resize(size > 0 && used < bytes.capacity()
                             ? std::min(used + std::min(step, greatest_step), bytes.capacity())
                             : used + step);
        }
        const ssize_t got = ::read(fd, bytes.data() + used, bytes.size() - used);
        if (got < 0) {
            if (errno == EINTR) continue;
            return io_failure("read", name, errno);
        }
        if (got == 0) break;
        used += static_cast<std::size_t>(got);
        if (used > most.value)
            return fail("FIL0104", fmt::format("larger than {}", to_text(most)), std::string(limits_hint), name);
        if (size > 0 && used == size && used < bytes.size()) break; // there was room for a byte more
    }
    bytes.resize(used);
    return bytes;
}

} // namespace

Result<std::string> read_file(const std::string& path, const Limit& most) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
    Result<std::size_t> size = check_readable(file.get(), path);
    if (!size) return pass_on(size);
    return read_all(file.get(), path, most, *size);
}

std::size_t size_of_file(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 ? known_size(status) : 0;
}

Result<std::string> read_file_start(const std::string& path, std::size_t count) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
    if (Result<std::size_t> size = check_readable(file.get(), path); !size) return pass_on(size);
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
    struct stat status {};
    return read_all(STDIN_FILENO, "-", most, ::fstat(STDIN_FILENO, &status) == 0 ? known_size(status) : 0);
}

Result<void> write_standard_output(std::string_view bytes) {
    if (const int error = detail::write_all(STDOUT_FILENO, bytes); error != 0)
        return io_failure("write", "stdout", error);
    return {};
}

void hold_standard_descriptors() {
    for (const int wanted : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(wanted, F_GETFD) != -1 || errno != EBADF) continue;
        // Opened in the wrong direction: using it fails, as it would for a closed descriptor. open() returns the lowest
        // free number, which is this one. The root folder is the substitute if there is no /dev.
        const int way = wanted == STDIN_FILENO ? O_WRONLY : O_RDONLY;
        if (::open("/dev/null", way | O_NOCTTY) < 0) (void)::open("/", O_RDONLY | O_DIRECTORY);
    }
}

bool file_exists(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0;
}

std::string file_identity(const std::string& path) {
    struct stat status {};
    const auto number = [&] { return fmt::format("{}:{}", status.st_dev, status.st_ino); };
    if (::stat(path.c_str(), &status) == 0) return S_ISREG(status.st_mode) ? number() : std::string();
    const std::size_t slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    return ::stat(folder.c_str(), &status) == 0 ? number() + '/' + path.substr(slash + 1) : path;
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
