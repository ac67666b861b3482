// What printed pages are made of: a page with its head and foot, headings, lists and tables.
//
// Lengths are points of 1/72 inch, and a pixel of the drawing is a point. All text goes through page_text() and is cut
// to the width that it has. Internal to this room, except PaperSize.
#pragma once

#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/drawing.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

// Upright paper.
enum class PaperSize { a4, letter };

} // namespace gonio

namespace gonio::plot_detail {

inline constexpr Ink text_ink = ink(0x1c1c1c);
inline constexpr Ink soft_ink = ink(0x666666);
inline constexpr Ink rule_ink = ink(0x9a9a9a);
inline constexpr Ink faint_ink = ink(0xe2e2e2);
inline constexpr double body_pt = 7.5;
inline constexpr double small_pt = 6.2;
inline constexpr double column_gap_pt = 26.0;

// What all pages of a sheet have at their head and foot.
struct SheetFurniture {
    PaperSize paper = PaperSize::a4;
    std::string kind;     // "Photometric data sheet"
    std::string maker;    // may be empty
    std::string title;    // the luminaire's name
    std::string subtitle; // its catalogue number; may be empty
    std::string source;   // the file
};

// A line of a list: a name, its value, and in small letters what it is by.
struct SheetLine {
    std::string name;
    std::string value;
    std::string rule = {};
};

// Columns of equal width but for the first, which names the row.
struct SheetTable {
    double first_pt = 40.0;
    double size_pt = 7.0;
    double line_pt = 9.6;
    std::vector<std::vector<std::string>> head;
    std::vector<std::vector<std::string>> rows;
    std::vector<std::size_t> groups = {}; // columns with a gap before them, which the rule below the head has too
};

// Writes on a page.
class SheetPage {
public:
    SheetPage(const SheetFurniture& furniture, std::size_t number, std::size_t of);

    // Between head and foot.
    const Area& area() const { return area_; }
    Area left_half() const;
    Area right_half() const;

    void text(PagePoint at, std::string_view bytes, double width, const TextStyle& style);
    // Wrapped into at most so many lines; returns the y below it.
    double paragraph(PagePoint top_left, double width, std::string_view bytes, double size, Ink ink, std::size_t most);
    // Returns the y at which the content begins.
    double heading(const Area& area, std::string_view title, std::string_view rule = {});
    // Names in a column of their own; lines that would pass the bottom are left out. Returns the y below.
    double list(const Area& area, const std::vector<SheetLine>& lines, double names_pt, std::size_t most_lines = 1);
    // Returns the y below.
    double table(const Area& area, const SheetTable& table);
    // The symbol of a luminaire in a plan.
    void ring(PagePoint center, double radius);
    // A diagram in its box, or why there is none. `across_px`: the width for which it is drawn.
    void diagram(const Area& box, double across_px, const std::function<Result<Drawing>(int, int)>& draw);

    Drawing take() { return std::move(page_); }
    std::size_t replaced() const { return replaced_; }

private:
    Drawing page_;
    Area area_;
    std::size_t replaced_ = 0;
};

} // namespace gonio::plot_detail
