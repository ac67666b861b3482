#include "console.hpp"

#include <gonio/base/file.hpp>
#include <gonio/base/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace gonio::cli {

namespace {

void write_error_line(const std::string& text) {
    // If writing to stderr fails, there is nowhere left to report it.
    (void)std::fputs((text + "\n").c_str(), stderr);
}

// A message may quote what a file or a name holds: its control characters are shown, not followed.
std::string shown(std::string_view text) {
    if (!has_control_characters(text)) return std::string(text);
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view one = text.substr(i, text[i] == '\xc2' ? 2 : 1);
        if (text[i] == '\n' || text[i] == '\t' || !has_control_characters(one)) {
            plain += text[i];
            continue;
        }
        for (const char byte : one)
            plain += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
        i += one.size() - 1;
    }
    return plain;
}

// Colours the severity word, as compilers do.
std::string colored(std::string text, Severity severity) {
    const char* const code = severity == Severity::error ? "1;31" : severity == Severity::warning ? "1;35" : "1;36";
    const std::string word = to_text(severity);
    const std::size_t at = text.find(word);
    if (at != std::string::npos) text.replace(at, word.size(), fmt::format("\x1b[{}m{}\x1b[0m", code, word));
    return text;
}

} // namespace

void Console::say(const Diagnostic& diagnostic) const {
    if (record_ != nullptr) record_->push_back(diagnostic);
    if (quiet_ && diagnostic.severity != Severity::error) return;
    const std::string text = shown(to_text(diagnostic));
    write_error_line(color_ ? colored(text, diagnostic.severity) : text);
}

void Console::say(const Diagnostics& diagnostics) const {
    for (const Diagnostic& diagnostic : diagnostics)
        say(diagnostic);
}

void Console::note(std::string_view text) const {
    if (!quiet_) write_error_line(shown(text));
}

void Console::remark(std::string_view text) const {
    if (verbose_) write_error_line(shown(text));
}

int Console::fail(const Error& error) const {
    // For a refused input only the errors are printed; reports in JSON carry all diagnostics.
    for (const Diagnostic& diagnostic : error.diagnostics)
        if (diagnostic.severity == Severity::error) say(diagnostic);
    return static_cast<int>(error.failure);
}

int Console::flush(int status) {
    if (output_failed_) output_.clear();
    if (output_.empty()) return status;
    const Result<void> written = write_standard_output(output_);
    output_.clear();
    if (written) return status;
    output_failed_ = true;
    return worse(status, fail(written.error()));
}

bool Console::output_is_terminal() {
    return ::isatty(STDOUT_FILENO) == 1;
}
bool Console::errors_are_terminal() {
    return ::isatty(STDERR_FILENO) == 1;
}

int worse(int status, int other) {
    return std::max(status, other);
}

} // namespace gonio::cli
