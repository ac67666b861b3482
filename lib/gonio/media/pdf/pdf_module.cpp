// gonio-pdf.so: the only file of gonio that includes cairo and FreeType. Its contract is in detail/pdf_abi.hpp.
#include <gonio/media/detail/pdf_abi.hpp>

#include <array>
#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <ft2build.h>
#include <new>
#include <string>
#include <vector>
#include FT_FREETYPE_H

namespace gonio::media::abi {

struct PdfDocument {
    struct Font {
        FT_Face file = nullptr;
        cairo_font_face_t* face = nullptr;
    };

    std::array<Font, 2> fonts; // regular, bold
    cairo_surface_t* surface = nullptr;
    cairo_t* page = nullptr;
    bool has_page = false;
    std::vector<unsigned char> bytes;
    int status = done;
    std::array<char, message_bytes> message{};

    PdfDocument() = default;
    PdfDocument(const PdfDocument&) = delete;
    PdfDocument& operator=(const PdfDocument&) = delete;
    ~PdfDocument() {
        if (page != nullptr) cairo_destroy(page);
        if (surface != nullptr) cairo_surface_destroy(surface);
        for (Font& font : fonts)
            if (font.face != nullptr) cairo_font_face_destroy(font.face);
    }
};

} // namespace gonio::media::abi

namespace {

using namespace gonio::media::abi;

void say(char* message, const char* text) {
    std::snprintf(message, message_bytes, "%s", text);
}

// Runs `work` and turns its exceptions into a status.
template<class Work>
int guarded(char* message, Work work) noexcept {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        say(message, "out of memory");
        return out_of_memory;
    } catch (const std::exception& error) {
        say(message, error.what());
    } catch (...) {
        say(message, "unknown exception");
    }
    return internal;
}

// The same for a step of a document that has not failed yet.
template<class Work>
void step(PdfDocument* document, Work work) noexcept {
    if (document->status != done) return;
    document->status = guarded(document->message.data(), [&] {
        work();
        return done;
    });
}

int status_of(cairo_status_t status, char* message) {
    if (status == CAIRO_STATUS_SUCCESS) return done;
    say(message, cairo_status_to_string(status));
    return status == CAIRO_STATUS_NO_MEMORY ? out_of_memory : internal;
}

cairo_status_t append(void* to, const unsigned char* data, unsigned length) {
    auto* const document = static_cast<PdfDocument*>(to);
    const int status = guarded(document->message.data(), [&] {
        document->bytes.insert(document->bytes.end(), data, data + length);
        return done;
    });
    return status == done ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_NO_MEMORY;
}

// The font's file is closed when cairo needs it no longer, which may be after the document.
int open_font(FT_Library library, PdfDocument::Font& font, const char* path, char* message) {
    static const cairo_user_data_key_t key{};
    if (FT_New_Face(library, path, 0, &font.file) != 0) {
        std::snprintf(message, message_bytes, "%s is not a font that can be read", path);
        return malformed;
    }
    font.face = cairo_ft_font_face_create_for_ft_face(font.file, FT_LOAD_NO_HINTING);
    const auto close_file = [](void* file) { FT_Done_Face(static_cast<FT_Face>(file)); };
    const cairo_status_t kept = cairo_font_face_set_user_data(font.face, &key, font.file, close_file);
    if (kept != CAIRO_STATUS_SUCCESS) FT_Done_Face(font.file);
    return status_of(kept, message);
}

int open(const PdfRequest* request, PdfDocument** result, char* message) {
    return guarded(message, [&] {
        // Kept for all documents, because fonts may outlive one.
        static FT_Library library = nullptr;
        if (library == nullptr && FT_Init_FreeType(&library) != 0) {
            say(message, "FreeType cannot be started");
            return static_cast<int>(internal);
        }
        auto* const document = new PdfDocument;
        *result = document;
        if (const int status = open_font(library, document->fonts[0], request->regular_font, message)) return status;
        if (const int status = open_font(library, document->fonts[1], request->bold_font, message)) return status;
        document->surface = cairo_pdf_surface_create_for_stream(append, document, 595.0, 842.0);
        cairo_surface_t* const surface = document->surface;
        cairo_pdf_surface_restrict_to_version(surface, CAIRO_PDF_VERSION_1_5);
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, request->title);
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_AUTHOR, request->author);
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, request->creator);
        // Equal pages give equal bytes: cairo would write the time.
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
        document->page = cairo_create(surface);
        cairo_set_fill_rule(document->page, CAIRO_FILL_RULE_WINDING);
        cairo_set_line_join(document->page, CAIRO_LINE_JOIN_ROUND);
        return status_of(cairo_status(document->page), message);
    });
}

void begin_page(PdfDocument* document, double width, double height) {
    step(document, [&] {
        if (document->has_page) cairo_show_page(document->page);
        document->has_page = true;
        cairo_pdf_surface_set_size(document->surface, width, height);
    });
}

void set_ink(cairo_t* page, const PdfInk& ink) {
    if (ink.opacity < 1.0)
        cairo_set_source_rgba(page, ink.r, ink.g, ink.b, ink.opacity);
    else
        cairo_set_source_rgb(page, ink.r, ink.g, ink.b);
}

void set_path(cairo_t* page, const PdfPart* parts, std::size_t count) {
    cairo_new_path(page);
    for (std::size_t i = 0; i < count; ++i) {
        const PdfPart& part = parts[i];
        for (std::size_t k = 0; k < part.points; ++k) {
            const double x = part.coordinates[2 * k];
            const double y = part.coordinates[2 * k + 1];
            if (k == 0)
                cairo_move_to(page, x, y);
            else
                cairo_line_to(page, x, y);
        }
        if (part.is_closed != 0) cairo_close_path(page);
    }
}

void fill(PdfDocument* document, const PdfPart* parts, std::size_t count, const PdfInk* ink) {
    step(document, [&] {
        set_path(document->page, parts, count);
        set_ink(document->page, *ink);
        cairo_fill(document->page);
    });
}

void stroke(PdfDocument* document, const PdfPart* parts, std::size_t count, const PdfPen* pen) {
    step(document, [&] {
        set_path(document->page, parts, count);
        set_ink(document->page, pen->ink);
        cairo_set_line_width(document->page, pen->width);
        const std::array<double, 2> dash{pen->dash, pen->gap};
        cairo_set_dash(document->page, dash.data(), pen->dash > 0.0 ? 2 : 0, 0.0);
        cairo_stroke(document->page);
    });
}

void rectangle(PdfDocument* document, double left, double top, double width, double height, const PdfInk* ink) {
    step(document, [&] {
        cairo_new_path(document->page);
        cairo_rectangle(document->page, left, top, width, height);
        set_ink(document->page, *ink);
        cairo_fill(document->page);
    });
}

void circle(PdfDocument* document, double x, double y, double radius, const PdfInk* ink) {
    step(document, [&] {
        cairo_new_path(document->page);
        cairo_arc(document->page, x, y, radius, 0.0, 6.283185307179586);
        set_ink(document->page, *ink);
        cairo_fill(document->page);
    });
}

// A glyph for each letter, one after the other, in font sizes from the first; the last is where the text ends.
struct Line {
    std::vector<cairo_glyph_t> glyphs;
    std::vector<cairo_text_cluster_t> clusters;
    double width = 0.0;
};

Line line_of(const PdfDocument& document, const char* text, bool is_bold) {
    const FT_Face file = document.fonts.at(is_bold ? 1 : 0).file;
    Line line;
    const auto* at = reinterpret_cast<const unsigned char*>(text);
    while (*at != 0) {
        const unsigned lead = *at;
        int bytes = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        FT_ULong code = bytes == 1 ? lead : lead & (0x7FU >> static_cast<unsigned>(bytes));
        for (int i = 1; i < bytes; ++i) {
            if ((at[i] & 0xC0U) != 0x80U) { // cut off: a zero ends the text
                bytes = i;
                break;
            }
            code = code << 6U | (at[i] & 0x3FU);
        }
        at += bytes;
        const FT_UInt glyph = FT_Get_Char_Index(file, code);
        line.glyphs.push_back({glyph, line.width, 0.0});
        line.clusters.push_back({bytes, 1});
        if (FT_Load_Glyph(file, glyph, FT_LOAD_NO_SCALE) == 0)
            line.width += static_cast<double>(file->glyph->metrics.horiAdvance) / file->units_per_EM;
    }
    return line;
}

void text(PdfDocument* document, const PdfText* text) {
    step(document, [&] {
        Line line = line_of(*document, text->text, text->is_bold != 0);
        if (line.glyphs.empty()) return;
        const double start = text->x - 0.5 * text->anchor * text->size * line.width;
        for (cairo_glyph_t& glyph : line.glyphs) {
            glyph.x = start + text->size * glyph.x;
            glyph.y = text->y;
        }
        cairo_t* const page = document->page;
        cairo_set_font_face(page, document->fonts.at(text->is_bold != 0 ? 1 : 0).face);
        cairo_set_font_size(page, text->size);
        const int count = static_cast<int>(line.glyphs.size());
        if (text->rim > 0.0) {
            cairo_new_path(page);
            cairo_glyph_path(page, line.glyphs.data(), count);
            set_ink(page, text->rim_ink);
            cairo_set_line_width(page, 2.0 * text->rim);
            cairo_set_dash(page, nullptr, 0, 0.0);
            cairo_stroke(page);
        }
        set_ink(page, text->ink);
        cairo_show_text_glyphs(page, text->text, static_cast<int>(std::strlen(text->text)), line.glyphs.data(), count,
                               line.clusters.data(), static_cast<int>(line.clusters.size()),
                               static_cast<cairo_text_cluster_flags_t>(0));
    });
}

void begin_clip(PdfDocument* document, double left, double top, double width, double height) {
    step(document, [&] {
        cairo_save(document->page);
        cairo_new_path(document->page);
        cairo_rectangle(document->page, left, top, width, height);
        cairo_clip(document->page);
    });
}

void end_clip(PdfDocument* document) {
    step(document, [&] { cairo_restore(document->page); });
}

int finish(PdfDocument* document, PdfReply* reply, char* message) {
    step(document, [&] {
        if (document->has_page) cairo_show_page(document->page);
        document->status = status_of(cairo_status(document->page), document->message.data());
        cairo_surface_finish(document->surface);
        if (document->status == done)
            document->status = status_of(cairo_surface_status(document->surface), document->message.data());
    });
    say(message, document->message.data());
    *reply = {document->bytes.data(), document->bytes.size()};
    return document->status;
}

void close(PdfDocument* document) {
    delete document;
}

double text_width(PdfDocument* document, const char* text, std::int32_t is_bold) {
    double width = 0.0;
    step(document, [&] { width = line_of(*document, text, is_bold != 0).width; });
    return width;
}

constexpr PdfModule table{pdf_version, open,       begin_page, fill,   stroke, rectangle, circle,
                          text,        begin_clip, end_clip,   finish, close,  text_width};

} // namespace

extern "C" __attribute__((visibility("default"))) const void* gonio_pdf_module();

const void* gonio_pdf_module() {
    return &table;
}
