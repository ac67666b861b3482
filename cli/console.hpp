// The output of a command: results to stdout, collected and written in one piece (in a batch: one piece for each
// input), diagnostics to stderr.
#pragma once

#include <gonio/base/result.hpp>

#include <string>
#include <string_view>

namespace gonio::cli {

class Console {
public:
    // Adds to the result.
    void print(std::string_view text) { output_ += text; }

    // Writes a diagnostic to stderr; notes and warnings only if not quiet.
    void say(const Diagnostic& diagnostic) const;
    void say(const Diagnostics& diagnostics) const;

    // One line to stderr, unless quiet.
    void note(std::string_view text) const;

    // One line to stderr if verbose.
    void remark(std::string_view text) const;

    // Prints the error, and returns the exit status of the failure.
    int fail(const Error& error) const;

    // Writes out everything printed since the last call. Returns `status`, or 3 if that is higher and the result could
    // not be written; this failure is reported once.
    int flush(int status);

    // Appends to `list` what is said from now on, as well as the errors; nullptr: no longer.
    void record(Diagnostics* list) { record_ = list; }

    void set_quiet(bool quiet) { quiet_ = quiet; }
    void set_verbose(bool verbose) { verbose_ = verbose; }
    void set_color(bool color) { color_ = color; }

    // Whether stdout is a terminal.
    static bool output_is_terminal();
    static bool errors_are_terminal();

    // Whether a progress bar would be visible and is wanted.
    bool shows_progress() const { return !quiet_ && errors_are_terminal(); }

private:
    std::string output_;
    Diagnostics* record_ = nullptr;
    bool output_failed_ = false;
    bool quiet_ = false;
    bool verbose_ = false;
    bool color_ = false;
};

// The higher exit status wins in a batch.
int worse(int status, int other);

} // namespace gonio::cli
