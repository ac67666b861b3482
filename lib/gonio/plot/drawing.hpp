// Drawing: the lines, areas and text of a diagram, before they become SVG text (svg.hpp) or pixels (raster.hpp).
//
// Coordinates are pixels of a page, x to the right and y down. Later items are drawn on top of earlier ones. Nothing
// fails.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// A point of the page in pixels, from its upper left corner.
struct PagePoint {
    double x = 0.0;
    double y = 0.0;
};

// A colour for displays, sRGB-encoded.
struct Ink {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    double opacity = 1.0;
};

// ink(0xd55e00)
constexpr Ink ink(std::uint32_t rgb, double opacity = 1.0) {
    return {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U & 0xffU),
            static_cast<std::uint8_t>(rgb & 0xffU), opacity};
}

// How a line is drawn.
struct Pen {
    Ink ink = {};
    double width_px = 1.0;
    std::array<double, 2> dash_px{0.0, 0.0}; // dash, gap; solid if the first is 0
};

// Polygons and polylines.
class PagePath {
public:
    // A line through points.
    struct Part {
        std::vector<PagePoint> points;
        bool closed = false;
    };

    PagePath& move_to(PagePoint point);
    PagePath& line_to(PagePoint point);
    PagePath& close();

    bool empty() const { return parts_.empty(); }
    const std::vector<Part>& parts() const { return parts_; }

private:
    std::vector<Part> parts_;
};

// Which end of a text is at its point.
enum class TextAnchor { start, middle, end };

// How text is drawn.
struct TextStyle {
    TextAnchor anchor = TextAnchor::start; // which point of the baseline is placed
    double size_px = 12.0;
    Ink ink = {};
    bool bold = false;
    double rim_px = 0.0; // width of a rim that keeps the text readable on lines
    Ink rim = gonio::ink(0xffffff);
};

// The inside of a path.
struct FilledPath {
    PagePath path; // overlapping parts count once
    Ink ink;
};
// The line of a path.
struct StrokedPath {
    PagePath path;
    Pen pen;
};
// A rectangle along the page's edges.
struct FilledRectangle {
    PagePoint corner;
    double width = 0.0;
    double height = 0.0;
    Ink ink;
};
// A disk of one ink.
struct FilledCircle {
    PagePoint center;
    double radius = 0.0;
    Ink ink;
};
// A line of text.
struct WrittenText {
    PagePoint at;
    std::string text; // UTF-8
    TextStyle style;
};
struct ClipBegin { // clips do not nest
    PagePoint corner;
    double width = 0.0;
    double height = 0.0;
};
struct ClipEnd {};

// One step of a drawing.
using DrawingStep =
    std::variant<FilledPath, StrokedPath, FilledRectangle, FilledCircle, WrittenText, ClipBegin, ClipEnd>;

// A page, as the steps that draw it; an SVG or a picture is made of them.
class Drawing {
public:
    Drawing() = default;
    // A page of this size; `title` is for assistive software and is not drawn.
    Drawing(int width_px, int height_px, std::string title)
        : width_px_(width_px), height_px_(height_px), title_(std::move(title)) {}

    void line(PagePoint from, PagePoint to, const Pen& pen);
    void stroke(PagePath path, const Pen& pen);
    void fill(PagePath path, Ink ink);
    void rectangle(PagePoint corner, double width, double height, Ink ink);
    void circle(PagePoint center, double radius, Ink ink);
    void text(PagePoint at, std::string_view text, const TextStyle& style = {});
    // Everything drawn between these two calls is clipped to the rectangle.
    void begin_clip(PagePoint corner, double width, double height);
    void end_clip();

    // All steps of another drawing, scaled, with its upper left corner there. Outside a clip if it has clips itself.
    void place(const Drawing& other, PagePoint corner, double scale = 1.0);

    int width_px() const { return width_px_; }
    int height_px() const { return height_px_; }
    const std::string& title() const { return title_; }
    const std::vector<DrawingStep>& steps() const { return steps_; }

private:
    int width_px_ = 0;
    int height_px_ = 0;
    std::string title_;
    std::vector<DrawingStep> steps_;
};

} // namespace gonio
#pragma GCC visibility pop
