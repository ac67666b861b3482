#include "diagnostics_list.hpp"

#include <gonio/base/diagnostic_codes.hpp>

#include "excerpt.hpp"
#include "html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace gonio::cli {

namespace {

// "18:208"; empty without a line.
std::string place_of(const Location& location) {
    if (location.line == 0) return {};
    return location.column == 0 ? fmt::format("{}", location.line)
                                : fmt::format("{}:{}", location.line, location.column);
}

std::string explanation_of(const std::string& code) {
    const DiagnosticCode* const entry = find_diagnostic_code(code);
    if (entry == nullptr) return {};
    return fmt::format("<details><summary>What {} means</summary><p>{}: {}</p></details>\n", html(code),
                       html(entry->title), html(entry->explanation));
}

} // namespace

std::string diagnostics_list(const Diagnostics& diagnostics, const std::string& file, std::string_view bytes) {
    if (diagnostics.empty()) return "<p>No problems found.</p>\n";
    std::string list = "<ul class=\"diagnostics\">\n";
    std::set<std::string> explained;
    for (const Diagnostic& diagnostic : diagnostics) {
        const Location& at = diagnostic.location;
        const bool is_here = at.file == file;
        std::string place = place_of(at);
        if (!is_here && !at.file.empty()) place = place.empty() ? at.file : fmt::format("{}:{}", at.file, place);
        list += fmt::format("<li class=\"{0}\"><p><strong>{0}</strong> <code>{1}</code>{2} {3}</p>\n",
                            to_text(diagnostic.severity), html(diagnostic.code),
                            place.empty() ? "" : fmt::format(" <span class=\"place\">{}</span>", html(place)),
                            html(diagnostic.message));
        if (!diagnostic.hint.empty()) list += fmt::format("<p>Hint: {}</p>\n", html(diagnostic.hint));
        if (is_here) list += excerpt(bytes, at);
        if (explained.insert(diagnostic.code).second) list += explanation_of(diagnostic.code);
        list += "</li>\n";
    }
    return list + "</ul>\n";
}

std::string diagnostics_count(const Diagnostics& diagnostics) {
    std::string text;
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
        const auto count = std::count_if(diagnostics.begin(), diagnostics.end(),
                                         [&](const Diagnostic& diagnostic) { return diagnostic.severity == severity; });
        if (count == 0) continue;
        text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, to_text(severity), count == 1 ? "" : "s");
    }
    return text;
}

} // namespace gonio::cli
