#include <gonio/base/diagnostics.hpp>

#include <fmt/format.h>

template class std::vector<gonio::Diagnostic>;

namespace gonio {

const char* to_text(Severity severity) {
    switch (severity) {
    case Severity::note:
        return "note";
    case Severity::warning:
        return "warning";
    case Severity::error:
        break;
    }
    return "error";
}

std::string to_text(const Diagnostic& diagnostic) {
    std::string text;
    const Location& at = diagnostic.location;
    if (!at.file.empty()) {
        text += at.file;
        if (at.line != 0) text += fmt::format(":{}", at.line);
        if (at.line != 0 && at.column != 0) text += fmt::format(":{}", at.column);
        text += ": ";
    }
    text += to_text(diagnostic.severity);
    if (!diagnostic.code.empty()) text += fmt::format("[{}]", diagnostic.code);
    text += ": " + diagnostic.message;
    if (!diagnostic.hint.empty()) text += "\nhint: " + diagnostic.hint;
    return text;
}

} // namespace gonio
