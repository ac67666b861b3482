// gonio: the command-line tool.
#include <gonio/base/file.hpp>

#include "interrupt.hpp"
#include "memory.hpp"
#include "run_tool.hpp"

#include <csignal>
#include <span>

int main(int argc, char** argv) {
    gonio::hold_standard_descriptors();
    gonio::cli::keep_freed_memory();
    gonio::cli::clean_up_after_signals();
    // A file size limit must come back as an error of write(), so that the half-written file can be removed.
    (void)std::signal(SIGXFSZ, SIG_IGN);
    gonio::cli::Console console;
    const std::span<char* const> words(argv, static_cast<std::size_t>(argc));
    return gonio::cli::run_tool(words.empty() ? words : words.subspan(1), console);
}
