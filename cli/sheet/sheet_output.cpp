#include "sheet_output.hpp"

#include <gonio/base/codes/result.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/version.hpp>
#include <gonio/media/pdf_file.hpp>
#include <gonio/plot/page_font.hpp>
#include <gonio/plot/svg.hpp>

#include "../options/output.hpp"
#include "../report/html.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array formats{Named{"pdf", SheetFormat::pdf}, Named{"svg", SheetFormat::svg},
                             Named{"html", SheetFormat::html}};

std::optional<SheetFormat> format_of_name(std::string_view file) {
    for (const auto& format : formats)
        if (ends_with_any_case(file, fmt::format(".{}", format.name))) return format.value;
    return ends_with_any_case(file, ".htm") ? std::optional(SheetFormat::html) : std::nullopt;
}

// On screen a page lies on grey; printed it is the paper.
constexpr std::string_view style = R"css(
body { margin: 0; background: #d9dce0 }
.page { display: block; width: max-content; max-width: 100%; margin: 1rem auto; background: #fff;
  box-shadow: 0 1px 4px #0004 }
.page svg { display: block; max-width: 100%; height: auto }
@media print {
  body { background: none }
  .page { margin: 0; box-shadow: none; break-after: page; break-inside: avoid }
  .page:last-child { break-after: auto }
}
)css";

std::string html_of(std::span<const Drawing> pages, PaperSize paper, const SheetTitle& title) {
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"generator\" content=\"gonio {}\">\n<title>{}</title>\n"
        "<style>@page {{ size: {} portrait; margin: 0 }}{}</style>\n</head>\n<body>\n<main>\n",
        version, html(title.title), paper == PaperSize::a4 ? "A4" : "letter", style);
    for (std::size_t i = 0; i < pages.size(); ++i)
        text += fmt::format("<section class=\"page\" aria-label=\"page {}\">\n{}</section>\n", i + 1,
                            to_svg(pages[i], {fmt::format("p{}-", i + 1), false, "pt"}));
    return text + "</main>\n</body>\n</html>\n";
}

} // namespace

bool names_sheet(std::string_view file) {
    const std::optional<SheetFormat> format = format_of_name(file);
    return format && *format != SheetFormat::svg;
}

Result<SheetOutput> sheet_output(const Arguments& arguments) {
    SheetOutput output;
    const std::optional<std::string> file = arguments.value("--output");
    if (!file) return fail("USE0104", "no output is given", "use -o FILE, for example -o lamp.pdf");
    output.file = *file;
    if (const auto named = arguments.value("--to")) {
        Result<SheetFormat> format = find_value("format of sheets", *named, formats);
        if (!format) return pass_on(format);
        output.format = *format;
    } else if (const std::optional<SheetFormat> format = format_of_name(*file)) {
        output.format = *format;
    } else {
        return *file == "-" ? fail("USE0104", "stdout has no file name to show the format", "add --to pdf, svg or html")
                            : fail("USE0104", fmt::format("the name '{}' does not show a format of sheets", *file),
                                   "end it in .pdf, .svg or .html, or add --to");
    }
    if (const auto paper = arguments.value("--paper")) {
        constexpr std::array papers{Named{"a4", PaperSize::a4}, Named{"letter", PaperSize::letter}};
        Result<PaperSize> size = find_value("paper", *paper, papers);
        if (!size) return pass_on(size);
        output.paper = *size;
    }
    if (const auto folder = arguments.value("--fonts")) {
        if (output.format != SheetFormat::pdf)
            return fail("USE0107", "--fonts is for PDF", "SVG and HTML take the fonts of the machine that shows them");
        output.font_folders = {*folder};
    }
    if (output.format == SheetFormat::pdf)
        if (Result<void> there = media::check_pdf({{}, {}, output.font_folders}); !there) return pass_on(there);
    return output;
}

std::vector<std::string> sheet_files(const SheetOutput& output, std::size_t pages) {
    if (output.format != SheetFormat::svg || pages == 1 || output.file == "-") return {output.file};
    const std::string stem = without_extension(output.file);
    const std::string extension = output.file.substr(stem.size());
    std::vector<std::string> files;
    for (std::size_t i = 1; i <= pages; ++i)
        files.push_back(fmt::format("{}-{}{}", stem, i, extension));
    return files;
}

Result<void> write_sheet(const SheetOutput& output, std::span<const Drawing> pages, const SheetTitle& title) {
    const std::vector<std::string> names = sheet_files(output, pages.size());
    if (output.format == SheetFormat::svg) {
        if (names.size() != pages.size())
            return fail("USE0107", fmt::format("stdout takes one page of SVG, and there are {}", pages.size()),
                        "write --to pdf or --to html, or a file for each page with -o lamp.svg");
        std::vector<OutputFile> files;
        for (std::size_t i = 0; i < pages.size(); ++i)
            files.push_back({names[i], to_svg(pages[i], {{}, false, "pt"})});
        return write_outputs(files);
    }
    if (output.format == SheetFormat::html) return write_output(output.file, html_of(pages, output.paper, title));
    Result<std::string> bytes =
        media::to_pdf(pages, {page_text(title.title).text, page_text(title.author).text, output.font_folders});
    if (!bytes) return pass_on(bytes);
    return write_output(output.file, *bytes);
}

void add_letters_note(std::size_t replaced, const std::string& file, Diagnostics& diagnostics) {
    if (replaced == 0) return;
    diagnostics.push_back(result_diagnostic(
        "RES0210", "letters of the texts are not in the font of the sheet, and are shown as U+FFFD", {}, file));
}

} // namespace gonio::cli
