#include "interrupt.hpp"

#include <csignal>

namespace gonio::cli {

namespace {

volatile std::sig_atomic_t was_interrupted = 0;

extern "C" void note_interrupt(int /*signal*/) {
    was_interrupted = 1;
    (void)std::signal(SIGINT, SIG_DFL);
}

} // namespace

void listen_for_interrupt() {
    // Who started the tool with the signal ignored (nohup, a shell's background job) wants it ignored.
    if (std::signal(SIGINT, note_interrupt) == SIG_IGN) (void)std::signal(SIGINT, SIG_IGN);
}

bool interrupted() {
    return was_interrupted != 0;
}

} // namespace gonio::cli
