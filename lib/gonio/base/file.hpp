// Files, read whole, and the standard streams. Every POSIX file call of gonio stands behind this header and
// file_set.hpp, which writes.
#pragma once

#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio {

// Of files that have no limit of their own. (clang 14 takes no consteval call as a default argument.)
inline constexpr const Limit& largest_file = limit("file-bytes");

// The bytes of a file (or of a pipe or device, to its end). Fails (io) on a folder, on what cannot be opened or read,
// and on more bytes than the limit: never allocates what a size announces before it has been read.
Result<std::string> read_file(const std::string& path, const Limit& most = largest_file);

// The first `count` bytes of a file, or as many as it has. Fails as read_file does.
Result<std::string> read_file_start(const std::string& path, std::size_t count);

// As read_file, from standard input.
Result<std::string> read_standard_input(const Limit& most = largest_file);

// Writes to standard output, all or an error. SIGPIPE keeps its default action unless the program changed it.
Result<void> write_standard_output(std::string_view bytes);

// Gives descriptors 0, 1 and 2 that the process was started without something harmless, so that no file that is opened
// later gets their numbers and with them what is meant for the standard streams. Reading and writing them fails, as it
// does with what is closed. Call it first in main().
void hold_standard_descriptors();

// Whether something exists at `path` (links followed).
bool file_exists(const std::string& path);

// The same text for two paths exactly where they name the same regular file, or would once it is there: hard and
// symbolic links, "a" and "./a". Empty for a folder, a device or a pipe.
std::string file_identity(const std::string& path);

// Whether `path` was changed after `other`; true when either cannot be asked.
bool is_newer(const std::string& path, const std::string& other);

// The folder that holds the running executable; empty when the system does not tell.
std::string executable_folder();

} // namespace gonio
