// Writing SVG 1.1: the few elements that diagrams are made of.
//
// Coordinates are pixels, x to the right and y down, written with at most two decimals: a hundredth of a pixel is below
// what any screen shows, and equal input gives equal bytes. Text is escaped. Nothing fails.
#pragma once

#include <string>
#include <string_view>

namespace gonio {

struct SvgPoint {
    double x = 0.0;
    double y = 0.0;
};

// The d attribute of a path, built step by step.
class SvgPath {
public:
    SvgPath& move_to(SvgPoint point);
    SvgPath& line_to(SvgPoint point);
    SvgPath& close();

    bool empty() const { return data_.empty(); }
    const std::string& data() const { return data_; }

private:
    std::string data_;
};

enum class TextAnchor { start, middle, end };

class Svg {
public:
    // A white picture of so many pixels; `title` is what assistive software reads, and is not drawn.
    Svg(int width, int height, std::string_view title);

    // `style` is the text of more attributes, such as `stroke="#888"`.
    void line(SvgPoint from, SvgPoint to, std::string_view style);
    void circle(SvgPoint center, double radius, std::string_view style);
    void rectangle(SvgPoint corner, double width, double height, std::string_view style);
    void path(const SvgPath& path, std::string_view style);
    // `at` is the baseline's start, middle or end.
    void text(SvgPoint at, std::string_view text, TextAnchor anchor = TextAnchor::start, double size_px = 12.0,
              std::string_view style = {});
    // The same, with a white rim that keeps it readable on lines.
    void label(SvgPoint at, std::string_view text, TextAnchor anchor = TextAnchor::start, double size_px = 12.0);

    // Everything between is drawn inside the rectangle only.
    void begin_clip(SvgPoint corner, double width, double height);
    void end_clip();

    // The whole document. The picture may not be added to afterwards.
    std::string finish();

private:
    std::string text_;
    int clips_ = 0;
};

// At most two decimals, no exponent, no negative zero.
std::string svg_number(double value);

} // namespace gonio
