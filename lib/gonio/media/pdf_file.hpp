// Drawings as a PDF file, by cairo in the module gonio-pdf.so.
//
// Lines stay lines and text stays text: DejaVu Sans and DejaVu Sans Bold are embedded, as far as their letters are
// used. A pixel of a drawing is a point, 1/72 inch. Equal drawings give equal bytes with the same version of cairo,
// whatever the time.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/plot/drawing.hpp>

#include <span>
#include <string>
#include <vector>

namespace gonio::media {

// What a PDF says about itself, and where its fonts are.
struct PdfOptions {
    std::string title; // UTF-8
    std::string author;
    std::vector<std::string> font_folders; // of DejaVuSans.ttf and DejaVuSans-Bold.ttf; empty: default_font_folders()
};

// Where Debian, Fedora, Arch and macOS's Homebrew install the fonts.
std::vector<std::string> default_font_folders();

// Fails as to_pdf() does for want of the module or the fonts: before the work that the pages take.
Result<void> check_pdf(const PdfOptions& options);

// A page for each drawing. Fails (unsupported) without the module or the fonts, and (malformed) if a font cannot be
// read.
Result<std::string> to_pdf(std::span<const Drawing> pages, const PdfOptions& options = {});

} // namespace gonio::media
