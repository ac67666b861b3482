// Definitions that both modules' contracts share. A function that can fail returns a Status; for every status other
// than `done` it writes a sentence of at most message_bytes.
#pragma once

#include <cstddef>

namespace gonio::media::abi {

inline constexpr std::size_t message_bytes = 512;

// The first ones are values of gonio::Failure; the header of that belongs to the core.
enum Status : int {
    done = 0,
    io = 3,
    malformed = 4,
    unsupported = 5,
    out_of_memory = 6,
    no_threads = 7, // the system refused to start a thread
    internal = 70
};

} // namespace gonio::media::abi
