// The temporary files that this process has at the moment, so that a signal's handler can remove them.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>

namespace gonio::detail {

inline constexpr std::size_t temporary_name_bytes = 48; // of ".gonio-PID-NUMBER.tmp"

// One temporary file. Entries are never freed but used again, so that a handler may walk them at any time.
struct Temporary {
    enum State : int { free, opening, there };

    std::atomic<int> state{free};
    std::atomic<int> folder{-1}; // descriptor of the folder that it lies in
    std::array<char, temporary_name_bytes> name{};
    std::atomic<Temporary*> next{nullptr};
};

// Makes a new file in the folder under a name that nothing has yet; the name is short, so that it fits wherever that of
// the target does. `make` gets the name and returns whether it made the file, else sets errno (EEXIST: the name is
// taken). Returns nullptr and sets errno where that fails, or where remove_temporary_files() was called.
Temporary* make_temporary(int folder, const std::function<bool(const char* name)>& make);

// Frees the entry of a file that was renamed.
void forget(Temporary& temporary);

// Removes the file and frees its entry.
void discard(Temporary& temporary);

} // namespace gonio::detail
