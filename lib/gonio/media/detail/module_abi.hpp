// What the contracts of both modules share. A function that can fail returns a Status, and writes a sentence of at most
// message_bytes for every other than `done`.
#pragma once

#include <cstddef>

namespace gonio::media::abi {

inline constexpr std::size_t message_bytes = 512;

// The first ones are values of gonio::Failure, whose header is the core's.
enum Status : int {
    done = 0,
    io = 3,
    malformed = 4,
    unsupported = 5,
    out_of_memory = 6,
    no_threads = 7, // the system did not let a thread be started
    internal = 70
};

} // namespace gonio::media::abi
