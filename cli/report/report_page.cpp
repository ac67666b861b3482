#include "report_page.hpp"

#include <gonio/base/version.hpp>

#include "html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace gonio::cli {

namespace {

// Diagrams and pictures are drawn for white paper: they keep it in the dark.
constexpr std::string_view style = R"css(
:root { color-scheme: light dark; --ink: #1b1f24; --paper: #fff; --soft: #57606a; --line: #d0d7de; --panel: #f6f8fa;
  --link: #0550ae; --warning: #7d4e00; --error: #a40e26 }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6edf3; --paper: #0d1117; --soft: #9ba6b2; --line: #30363d; --panel: #161b22; --link: #79b8ff;
    --warning: #e3b341; --error: #ff8d86 }
}
* { box-sizing: border-box }
body { margin: 0 auto; padding: 1rem; max-width: 82rem; background: var(--paper); color: var(--ink);
  font: 1rem/1.45 system-ui, "DejaVu Sans", Verdana, Arial, sans-serif }
h1, h2, h3, p, figure, ul { margin: 0 0 .75rem }
h1 { font-size: 1.6rem } h2 { font-size: 1.3rem } h3 { font-size: 1.05rem }
a { color: var(--link) }
.file, .place, footer, figcaption { color: var(--soft); font-size: .875rem }
h2, .file, li, td { overflow-wrap: anywhere }
section { margin-top: 2rem; padding-top: 1rem; border-top: 1px solid var(--line) }
table { border-collapse: collapse; width: 100%; margin-bottom: 1rem; font-size: .875rem }
caption { text-align: left; font-weight: 600; padding-bottom: .25rem }
th, td { text-align: left; vertical-align: top; padding: .2rem .6rem .2rem 0; border-bottom: 1px solid var(--line) }
thead th { border-bottom: 2px solid var(--line) }
tbody th { font-weight: 500 }
.facts tbody th { color: var(--soft); white-space: nowrap; width: 1% }
.keywords tbody th { white-space: normal; overflow-wrap: anywhere; min-width: 6.5rem }
.text { white-space: pre-line }
thead th, .number, .short { white-space: nowrap }
.number { font-variant-numeric: tabular-nums }
.overview tbody th { overflow-wrap: anywhere; min-width: 9rem }
.overview .name { min-width: 11rem }
.overview .counts { min-width: 6rem; overflow-wrap: normal }
.zones td { font-variant-numeric: tabular-nums }
.failed td { color: var(--error) }
.scroll { overflow-x: auto }
.beside { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 27rem), 1fr)); gap: 0 2rem }
.diagrams { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 22rem), 1fr)); gap: 1rem;
  align-items: start; margin-bottom: 1rem }
.diagram, .picture { background: #fff; color: #1b1f24; border: 1px solid var(--line); border-radius: .375rem;
  padding: .5rem; min-width: 0 }
.diagram p { color: #1b1f24 }
.diagram figcaption, .picture figcaption { color: #57606a; text-align: center }
.diagram svg, .picture img { display: block; width: 100%; height: auto }
.rig .picture { max-width: 46rem }
.diagnostics { list-style: none; padding: 0 }
.diagnostics li { border-left: .25rem solid var(--line); padding-left: .75rem; margin-bottom: 1rem }
.diagnostics p { margin: 0 0 .25rem }
.diagnostics .warning { border-color: var(--warning) } .warning strong { color: var(--warning) }
.diagnostics .error { border-color: var(--error) } .error strong { color: var(--error) }
.source { margin: 0 0 .25rem; padding: .4rem .6rem; overflow-x: auto; background: var(--panel); font-size: .8rem;
  font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace }
.source b { color: var(--error) }
iframe { display: block; width: 100%; height: 90vh; border: 1px solid var(--line) }
@media print {
  :root { color-scheme: light; --ink: #000; --paper: #fff; --soft: #444; --line: #bbb; --panel: #f3f3f3; --link: #000;
    --warning: #7d4e00; --error: #a40e26 }
  body { max-width: none; padding: 0; font-size: 7.5pt; line-height: 1.3; print-color-adjust: exact;
    -webkit-print-color-adjust: exact }
  h1 { font-size: 14pt } h2 { font-size: 12pt; margin-bottom: 1pt } h3 { font-size: 9pt; margin-bottom: 3pt }
  h1, h2, h3, caption { break-after: avoid }
  a { text-decoration: none }
  p, ul { margin-bottom: 3pt }
  section { margin: 0; padding: 0; border: 0 }
  .profile, .rig { break-before: page }
  .file, .place, footer, figcaption { font-size: 7pt }
  table { font-size: 7pt; margin-bottom: 4pt }
  th, td { padding: .6pt 4pt .6pt 0 }
  tr, figure, .diagnostics li { break-inside: avoid }
  .scroll { overflow: visible }
  .overview tbody th, .overview .name { min-width: 14mm } .overview .counts { min-width: 14mm }
  .keywords tbody th { min-width: 17mm }
  .beside { grid-template-columns: 1.4fr 1fr; gap: 0 5mm }
  .diagrams { grid-template-columns: repeat(3, 1fr); gap: 2mm; margin-bottom: 2mm }
  .diagram, .picture { padding: 1mm; margin: 0 0 2mm; border-radius: 0 }
  .diagrams .diagram { margin: 0 }
  .beside .picture { max-width: 66mm } .rig .picture { max-width: 110mm }
  .zones { font-size: 6pt; line-height: 1.1; margin: 0 } .zones th, .zones td { padding: .4pt 3pt .4pt 0 }
  .diagnostics { columns: 2; column-gap: 5mm }
  .diagnostics li { margin-bottom: 4pt; padding-left: 5pt }
  .source { font-size: 6.5pt; padding: 2pt 4pt; white-space: pre-wrap }
  .interactive, details { display: none }
}
)css";

std::string page_rule(Paper paper) {
    // The wider paper is lower: its columns are as wide as those of the other.
    return paper == Paper::a4 ? "@page { size: A4 portrait; margin: 12mm }"
                              : "@page { size: letter portrait; margin: 9mm 15mm }\n"
                                "@media print { .diagrams svg { width: 92%; margin: auto } }";
}

std::string counted(std::size_t number, std::string_view what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

std::string overview(std::span<const ProfilePart> profiles) {
    std::string table =
        "<div class=\"scroll\" role=\"region\" aria-label=\"Profiles\" tabindex=\"0\">\n"
        "<table class=\"overview\"><caption>Profiles; beam and field in C0–C180 / C90–C270</caption><thead><tr>"
        "<th scope=\"col\">File</th><th scope=\"col\">Luminaire</th><th scope=\"col\">Format</th>"
        "<th scope=\"col\">Flux</th><th scope=\"col\">Peak</th><th scope=\"col\">Beam</th><th scope=\"col\">Field</th>"
        "<th scope=\"col\">Input</th><th scope=\"col\">Efficacy</th><th scope=\"col\">Diagnostics</th>"
        "</tr></thead><tbody>\n";
    for (const ProfilePart& profile : profiles)
        table += profile.row;
    return table + "</tbody></table>\n</div>\n";
}

std::string interactive(const ReportParts& parts) {
    std::vector<EmbeddedFile> files;
    for (std::size_t i = 0; i < parts.profiles.size(); ++i)
        if (parts.profiles[i].bytes) files.push_back({parts.names[i], *parts.profiles[i].bytes});
    const bool has_rig = parts.rig != nullptr && !parts.rig->error;
    if (has_rig)
        for (const auto& [name, bytes] : parts.rig->profiles)
            if (std::none_of(files.begin(), files.end(), [&, &name = name, &bytes = bytes](const EmbeddedFile& file) {
                    return file.name == name && file.bytes == bytes;
                }))
                files.push_back({name, bytes});
    return interactive_section(*parts.page, files, has_rig ? &parts.rig->text : nullptr);
}

} // namespace

std::string report_html(const ReportParts& parts) {
    std::string html_text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"generator\" content=\"gonio {}\">\n"
        "<title>{}</title>\n<style>{}{}\n</style>\n</head>\n<body>\n<main>\n<h1>{}</h1>\n",
        content_policy(parts.page), version, html(parts.title), style, page_rule(parts.paper), html(parts.title));
    if (!parts.remark.empty()) html_text += fmt::format("<p>{}</p>\n", html(parts.remark));
    if (!parts.profiles.empty()) {
        html_text += fmt::format("<p>{}</p>\n", counted(parts.profiles.size(), "profile"));
        html_text += overview(parts.profiles);
    }
    if (parts.page != nullptr) html_text += interactive(parts);
    if (parts.rig != nullptr) html_text += parts.rig->section;
    for (const ProfilePart& profile : parts.profiles)
        html_text += profile.section;
    return html_text + fmt::format("</main>\n<footer>Made by gonio {}</footer>\n</body>\n</html>\n", version);
}

} // namespace gonio::cli
