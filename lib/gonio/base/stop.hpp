// Ending loops early: what a program with a person in front of it needs for Ctrl-C in a call of seconds.
//
// The library's long work runs in loops of gonio/base/parallel.hpp. On a thread that listens, such a loop ends once the
// flag is set: no piece is begun any more, and it throws LoopsStopped. Only a caller that listens meets that exception,
// which is the one that passes the library's interface; what the call was making is dropped.
#pragma once

#include <atomic>

namespace gonio {

struct LoopsStopped {};

// While it lives, loops that this thread begins end when `flag` is true. Restores what was listened to before.
class StopLoops {
public:
    explicit StopLoops(const std::atomic<bool>& flag);
    ~StopLoops();
    StopLoops(const StopLoops&) = delete;
    StopLoops& operator=(const StopLoops&) = delete;

private:
    const std::atomic<bool>* before_;
};

} // namespace gonio
