// The tool as a function of JavaScript: run(words, files) of files.js calls it in a folder of its own.
#include "../console.hpp"
#include "../run_tool.hpp"
#include "to_js.hpp"
#include "words.hpp"

#include <cstdio>
#include <emscripten/bind.h>
#include <fcntl.h>
#include <unistd.h>

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

// {status, diagnostics}; what is written is in the files /stdout and /stderr.
emscripten::val run(const emscripten::val& list) {
    Words words(list);
    const Redirected in(STDIN_FILENO, "/stdin", O_RDONLY);
    const Redirected out(STDOUT_FILENO, "/stdout", O_WRONLY | O_CREAT | O_TRUNC);
    const Redirected errors(STDERR_FILENO, "/stderr", O_WRONLY | O_CREAT | O_TRUNC);
    Diagnostics diagnostics;
    Console console;
    console.record(&diagnostics);
    emscripten::val result = emscripten::val::object();
    result.set("status", run_tool(words.pointers(), console));
    result.set("diagnostics", wasm::to_js(diagnostics));
    return result;
}

} // namespace

EMSCRIPTEN_BINDINGS(gonio_tool) {
    emscripten::function("runWords", &run);
}

} // namespace gonio::cli
