// Shared by reading and writing files: a descriptor that closes itself, and messages for failures.
#pragma once

#include <gonio/base/result.hpp>

#include <string>
#include <string_view>

namespace gonio::detail {

class Descriptor {
public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    ~Descriptor();

    int get() const { return fd_; }

    // Closes now and returns the errno of the failure, or 0: errors of delayed writes (NFS, quota) are reported here.
    int close();

private:
    int fd_;
};

// "cannot write: No space left on device", with a hint where one helps. `error` is an errno.
Unexpected io_failure(const char* verb, const std::string& path, int error);

// Writes all bytes. Returns 0, or the errno of the failure.
int write_all(int fd, std::string_view bytes);

} // namespace gonio::detail
