// Files, read whole and written whole. Every POSIX file call of gonio stands behind this header.
//
// Writing is atomic: the bytes go to a temporary name in the target's folder, are flushed, and take the target's place
// by rename, so that a reader sees the old file or the new one and a failure leaves the old one untouched. A target
// that exists and is no regular file (a device, a pipe, a terminal) is written directly and never replaced. A symbolic
// link is followed. An existing file's permissions are kept.
#pragma once

#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio {

// The bytes of a file (or of a pipe or device, to its end). Fails (io) on a folder, on what cannot be opened or read,
// and on more bytes than the limit: never allocates what a size announces before it has been read.
Result<std::string> read_file(const std::string& path, const Limit& most = limit("file-bytes"));

// The first `count` bytes of a file, or as many as it has. Fails as read_file does.
Result<std::string> read_file_start(const std::string& path, std::size_t count);

// As read_file, from standard input.
Result<std::string> read_standard_input(const Limit& most = limit("file-bytes"));

// Fails (io) with the system's reason; nothing half-written is left at `path`, nor a temporary file.
Result<void> write_file(const std::string& path, std::string_view bytes);

// Writes to standard output, all or an error. SIGPIPE keeps its default action unless the program changed it.
Result<void> write_standard_output(std::string_view bytes);

// Whether something exists at `path` (links followed).
bool file_exists(const std::string& path);

// Whether `path` was changed after `other`; true when either cannot be asked.
bool is_newer(const std::string& path, const std::string& other);

// The folder that holds the running executable; empty when the system does not tell.
std::string executable_folder();

} // namespace gonio
