// Whole files and the standard streams. Every POSIX file call of gonio is behind this header and
// file_set.hpp, which writes.
#pragma once

#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio {

// For files without a specific limit. (clang 14 does not accept a consteval call as a default argument.)
inline constexpr const Limit& largest_file = limit("file-bytes");

// The bytes of a file (or of a pipe or device, to its end). Fails (io) on a folder, if it cannot be opened or read, and
// on more bytes than the limit. Memory is used only for bytes that have been read; for those of a regular file it is
// reserved, up to the limit.
Result<std::string> read_file(const std::string& path, const Limit& most = largest_file);

// The first `count` bytes of a file, or as many as it has. Fails as read_file does.
Result<std::string> read_file_start(const std::string& path, std::size_t count);

// As read_file, from stdin.
Result<std::string> read_standard_input(const Limit& most = largest_file);

// Writes everything to stdout, or fails. SIGPIPE keeps its default action unless the program changed it.
Result<void> write_standard_output(std::string_view bytes);

// If the process was started without descriptor 0, 1 or 2, opens something harmless there. Otherwise a file opened
// later would get that number, and with it the data meant for the standard stream. Reading and writing these
// descriptors fails, as for closed ones. Call it first in main().
void hold_standard_descriptors();

// Whether something exists at `path` (links followed).
bool file_exists(const std::string& path);

// The bytes that the system states for a regular file; 0 for anything else.
std::size_t size_of_file(const std::string& path);

// The same text for two paths if and only if they name the same regular file, or would once it exists: hard and
// symbolic links, "a" and "./a". Empty for a folder, a device or a pipe.
std::string file_identity(const std::string& path);

// Whether `path` was changed after `other`; true if either time cannot be read.
bool is_newer(const std::string& path, const std::string& other);

// The folder of the running executable; empty if the system does not provide it.
std::string executable_folder();

} // namespace gonio
