#include "interrupt.hpp"

#include <gonio/base/file_set.hpp>

#include <csignal>

namespace gonio::cli {

namespace {

volatile std::sig_atomic_t was_interrupted = 0;

extern "C" void end_cleanly(int signal) {
    remove_temporary_files();
    (void)std::signal(signal, SIG_DFL);
    (void)std::raise(signal); // blocked until this handler returns
}

extern "C" void note_interrupt(int /*signal*/) {
    was_interrupted = 1;
    (void)std::signal(SIGINT, end_cleanly);
}

// If the tool was started with the signal ignored (nohup, a shell's background job), it stays ignored.
void handle(int signal, void (*handler)(int)) {
    if (std::signal(signal, handler) == SIG_IGN) (void)std::signal(signal, SIG_IGN);
}

} // namespace

void clean_up_after_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU})
        handle(signal, end_cleanly);
}

void listen_for_interrupt() {
    handle(SIGINT, note_interrupt);
}

bool interrupted() {
    return was_interrupted != 0;
}

} // namespace gonio::cli
