// The temporary files that this process has at the moment, so that a signal handler can remove them.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>

namespace gonio::detail {

inline constexpr std::size_t temporary_name_bytes = 48; // of ".gonio-PID-NUMBER.tmp"

// One temporary file. Entries are never freed but reused, so that a handler may walk them at any time.
struct Temporary {
    enum State : int { free, opening, there };

    std::atomic<int> state{free};
    std::atomic<int> folder{-1}; // descriptor of the folder that contains it
    std::array<char, temporary_name_bytes> name{};
    std::atomic<Temporary*> next{nullptr};
};

// Makes a new file in the folder under an unused name; the name is short, so that it fits wherever the target's name
// does. `make` gets the name and returns whether it made the file, otherwise sets errno (EEXIST: the name is in use).
// Returns nullptr and sets errno if that fails, or if remove_temporary_files() was called.
Temporary* make_temporary(int folder, const std::function<bool(const char* name)>& make);

// Frees the entry of a file that was renamed.
void forget(Temporary& temporary);

// Removes the file and frees its entry.
void discard(Temporary& temporary);

} // namespace gonio::detail
