// The contract between the core and gonio-pdf.so: plain types, one table of functions, no exceptions.
//
// A document is written page by page, from the upper left corner, x to the right and y down, in points of 1/72 inch. A
// function that fails remembers it: finish() then returns the first failure, and everything in between does nothing.
// One document is open at a time.
// Change `pdf_version` whenever anything here or in module_abi.hpp changes.
#pragma once

#include <gonio/media/detail/module_abi.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::media::abi {

inline constexpr std::uint32_t pdf_version = 1;

struct PdfDocument; // opaque

// Texts are UTF-8 and end with a zero.
struct PdfRequest {
    const char* regular_font; // path of a TrueType or OpenType font
    const char* bold_font;
    const char* title;
    const char* author;
    const char* creator;
};

struct PdfInk { // sRGB-encoded, 0 to 1
    double r;
    double g;
    double b;
    double opacity;
};

struct PdfPen {
    PdfInk ink;
    double width;
    double dash; // solid if 0
    double gap;
};

// Points of a line: x, y, x, y, …
struct PdfPart {
    const double* coordinates;
    std::size_t points;
    std::int32_t is_closed;
};

struct PdfText {
    const char* text;
    double x; // of the start, the middle or the end of the baseline
    double y;
    std::int32_t anchor; // 0, 1, 2
    std::int32_t is_bold;
    double size;
    PdfInk ink;
    double rim; // width of a rim of this ink below the letters; 0: none
    PdfInk rim_ink;
};

struct PdfReply {
    const unsigned char* bytes; // belong to the document
    std::size_t size;
};

struct PdfModule {
    std::uint32_t version; // pdf_version; always the first member
    int (*open)(const PdfRequest* request, PdfDocument** document, char* message);
    void (*begin_page)(PdfDocument* document, double width, double height);
    void (*fill)(PdfDocument* document, const PdfPart* parts, std::size_t count, const PdfInk* ink);
    void (*stroke)(PdfDocument* document, const PdfPart* parts, std::size_t count, const PdfPen* pen);
    void (*rectangle)(PdfDocument* document, double left, double top, double width, double height, const PdfInk* ink);
    void (*circle)(PdfDocument* document, double x, double y, double radius, const PdfInk* ink);
    void (*text)(PdfDocument* document, const PdfText* text);
    void (*begin_clip)(PdfDocument* document, double left, double top, double width, double height);
    void (*end_clip)(PdfDocument* document);
    int (*finish)(PdfDocument* document, PdfReply* reply, char* message);
    void (*close)(PdfDocument* document);
    // The width of a text in font sizes, as the font has it.
    double (*text_width)(PdfDocument* document, const char* text, std::int32_t is_bold);
};

} // namespace gonio::media::abi
