// Files that belong together, written all or none.
//
// Every file is first written in full to a temporary file in the target's folder; commit() then gives all of them their
// names. A reader of one file sees the old one or the new one. If anything fails, every file that existed before is
// unchanged, and no temporary file is left. A target that exists and is not a regular file (a device, a pipe, a
// terminal) is written directly, before anything is renamed, and never replaced. A symbolic link is followed. The
// permissions of an existing file are kept.
//
// One thing is impossible on a file system: the names change one after the other, so a process that is killed between
// two renames leaves some files new and some old.
#pragma once

#include <gonio/base/result.hpp>

#include <memory>
#include <string>
#include <string_view>

namespace gonio {

struct FileSetOptions {
    // The files are flushed to the disk before the names change, and the folders after that: after a power cut there
    // are the old files or the new ones.
    bool durable = false;
};

class FileSet {
public:
    explicit FileSet(FileSetOptions options = {});
    FileSet(FileSet&&) noexcept;
    FileSet& operator=(FileSet&&) noexcept;
    // Removes the temporary files that were not committed.
    ~FileSet();

    // Writes the bytes to a temporary file beside the target `path`. Fails (io) with the system's reason, and on a
    // folder.
    Result<void> add(const std::string& path, std::string_view bytes);

    // Gives every file its name. Fails (io) with the system's reason, and leaves every file as it was before (but if
    // the file system supports neither hard links nor an exchange of names, files that are already renamed stay new).
    // The flush of the folders comes last: if that fails, the new files are in place. The set is empty afterwards.
    Result<void> commit();

private:
    struct State;
    std::unique_ptr<State> state_;
};

// A set of one file.
Result<void> write_file(const std::string& path, std::string_view bytes, FileSetOptions options = {});

// Whether the file can be written, for work that is too long to find out at the end: makes and removes a temporary file
// beside it. An existing file stays untouched. Fails as write_file does.
Result<void> check_writable(const std::string& path);

// Removes the temporary files that this process has at the moment; nothing can be written afterwards. For the handler
// of a signal that ends the process: async-signal-safe.
void remove_temporary_files() noexcept;

} // namespace gonio
