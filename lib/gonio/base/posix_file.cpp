#include <gonio/base/detail/posix_file.hpp>
#include <gonio/base/file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <unistd.h>
#include <utility>

namespace gonio::detail {

namespace {

// What strerror_r returns: the text in glibc, a status in other C libraries, which write the text into the buffer.
[[maybe_unused]] const char* text_of(const char* text, const char* /*buffer*/) {
    return text;
}
[[maybe_unused]] const char* text_of(int /*status*/, const char* buffer) {
    return buffer;
}

// strerror's text depends on the locale only where a program calls setlocale, which gonio never does.
std::string reason(int error) {
    std::array<char, 256> buffer{};
    return text_of(strerror_r(error, buffer.data(), buffer.size()), buffer.data());
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
    case EMFILE:
        return "the limit of open files of this process was reached (ulimit -n)";
    case ENOSPC:
        return "free some space, or write elsewhere";
    case EACCES:
        return "check the permissions of the file and of its folder";
    default:
        return {};
    }
}

} // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
}

Descriptor::~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
}

int Descriptor::close() {
    const int result = ::close(std::exchange(fd_, -1));
    return result == 0 ? 0 : errno;
}

Unexpected io_failure(const char* verb, const std::string& path, int error) {
    const Cause code = verb == std::string_view("read") ? Cause("FIL0102") : Cause("FIL0103");
    return fail(code, fmt::format("cannot {}: {}", verb, reason(error)), hint_for(error, path), path);
}

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

} // namespace gonio::detail
