// A loop over independent pieces of work, spread over threads.
//
// Which thread runs which piece is not defined, so a piece must write only its own data: then the result is the same
// for any thread count.
#pragma once

#include <cstddef>
#include <functional>

namespace gonio {

// Number of processors that this process may run on, at least 1.
unsigned available_threads();

// Whether `count` more threads can run at once, beside those that loops are just starting: tested by starting as many,
// some 20 µs each. For libraries that start threads themselves and do not survive a failure to do so.
bool can_start_threads(unsigned count);

// Calls work(i) once for each i in [0, count). `threads` = 0 means available_threads(). Returns when all are done. With
// one thread or one piece, everything runs on the caller; if the system provides fewer threads, on the caller and those
// that it provides. An exception of a piece reaches the caller after the running pieces have ended; pieces not yet
// begun are dropped.
void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

} // namespace gonio
