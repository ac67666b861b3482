// Diagnostics: messages about an input, on success as well as on failure.
//
// A diagnostic has a stable code ("IES0204"), a severity, a place (file, 1-based line and column; 0 = not known),
// one sentence, and a hint on what to do. The library collects them and never prints.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// How serious a diagnostic is: an error is the reason of a failure, the others accompany a result.
enum class Severity : std::uint8_t { note, warning, error };

// A place in a file.
struct Location {
    std::string file;
    std::uint32_t line = 0;   // 1-based, 0 when the diagnostic concerns the whole file
    std::uint32_t column = 0; // 1-based, in bytes, 0 when it concerns the whole line
};

// A remark about an input, or the reason of a failure.
struct Diagnostic {
    std::string code; // of diagnostic_codes.hpp; empty for remarks without a code; an error always has one
    Severity severity = Severity::error;
    Location location;
    std::string message; // one sentence without a full stop
    std::string hint;    // may be empty
};

// In the order in which they were found.
using Diagnostics = std::vector<Diagnostic>;

// "file:line:column: error[CODE]: message" and, when there is a hint, a second line "hint: …". No newline at the end.
std::string to_text(const Diagnostic& diagnostic);

// "note", "warning", "error".
const char* to_text(Severity severity);

} // namespace gonio
#pragma GCC visibility pop

// Compiled once, in diagnostics.cpp.
extern template class std::vector<gonio::Diagnostic>;
