// The tool as a function of JavaScript: run(words, files) of files.js calls it in a folder of its own.
#include "../console.hpp"
#include "../run_tool.hpp"
#include "words.hpp"

#include <cstdio>
#include <emscripten/bind.h>
#include <fcntl.h>
#include <string>
#include <unistd.h>
#include <vector>

namespace gonio::cli {

namespace {

// A standard stream that is a file of the memory, until the end of the scope.
class Redirected {
public:
    Redirected(int stream, const char* path, int flags) : stream_(stream), kept_(::dup(stream)) {
        const int file = ::open(path, flags, 0600);
        if (file < 0) return;
        ::dup2(file, stream_);
        ::close(file);
    }
    Redirected(const Redirected&) = delete;
    Redirected& operator=(const Redirected&) = delete;
    ~Redirected() {
        (void)std::fflush(nullptr);
        ::dup2(kept_, stream_);
        ::close(kept_);
    }

private:
    int stream_;
    int kept_;
};

// Returns the exit status; what is written is in the files /stdout and /stderr.
int run(const emscripten::val& list) {
    Words words(list);
    const Redirected in(STDIN_FILENO, "/stdin", O_RDONLY);
    const Redirected out(STDOUT_FILENO, "/stdout", O_WRONLY | O_CREAT | O_TRUNC);
    const Redirected errors(STDERR_FILENO, "/stderr", O_WRONLY | O_CREAT | O_TRUNC);
    Console console;
    return run_tool(words.pointers(), console);
}

} // namespace

EMSCRIPTEN_BINDINGS(gonio_tool) {
    emscripten::function("runWords", &run);
}

} // namespace gonio::cli
