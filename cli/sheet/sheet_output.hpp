// Where the pages of a sheet go: one PDF, one HTML file, or an SVG file for each page.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/plot/drawing.hpp>
#include <gonio/plot/page_layout.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

inline constexpr Option paper_option{"--paper", "SIZE", "a4 or letter (a4)"};
inline constexpr Option fonts_option{
    "--fonts", "DIR", "PDF: the folder of DejaVuSans.ttf and DejaVuSans-Bold.ttf (where the system has them)"};

enum class SheetFormat { pdf, svg, html };

struct SheetOutput {
    std::string file; // "-" is stdout
    SheetFormat format = SheetFormat::pdf;
    PaperSize paper = PaperSize::a4;
    std::vector<std::string> font_folders; // empty: the usual ones
};

// Whether the name is that of a sheet: .pdf, .html or .htm.
bool names_sheet(std::string_view file);

// --output, --to, --paper and --fonts. Fails (usage) on formats that are not those of a sheet and on stdin's name
// without --to; (unsupported) if the module for PDF or its fonts are missing.
Result<SheetOutput> sheet_output(const Arguments& arguments);

// The files that so many pages make: "lamp.pdf"; of SVG "lamp-1.svg", "lamp-2.svg" if there are several.
std::vector<std::string> sheet_files(const SheetOutput& output, std::size_t pages);

// What a file of pages says about itself.
struct SheetTitle {
    std::string title;
    std::string author;
};

// Writes all files or none. Fails (usage) on several pages of SVG for stdout.
Result<void> write_sheet(const SheetOutput& output, std::span<const Drawing> pages, const SheetTitle& title);

// A note if letters were replaced.
void add_letters_note(std::size_t replaced, const std::string& file, Diagnostics& diagnostics);

} // namespace gonio::cli
