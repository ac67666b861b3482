#include <gonio/plot/drawing.hpp>

#include <utility>

namespace gonio {

PagePath& PagePath::move_to(PagePoint point) {
    parts_.emplace_back().points.push_back(point);
    return *this;
}

PagePath& PagePath::line_to(PagePoint point) {
    if (parts_.empty()) return move_to(point);
    parts_.back().points.push_back(point);
    return *this;
}

PagePath& PagePath::close() {
    if (!parts_.empty()) parts_.back().closed = true;
    return *this;
}

void Drawing::line(PagePoint from, PagePoint to, const Pen& pen) {
    PagePath path;
    path.move_to(from).line_to(to);
    stroke(std::move(path), pen);
}

void Drawing::stroke(PagePath path, const Pen& pen) {
    if (!path.empty()) steps_.emplace_back(StrokedPath{std::move(path), pen});
}

void Drawing::fill(PagePath path, Ink ink) {
    if (!path.empty()) steps_.emplace_back(FilledPath{std::move(path), ink});
}

void Drawing::rectangle(PagePoint corner, double width, double height, Ink ink) {
    steps_.emplace_back(FilledRectangle{corner, width, height, ink});
}

void Drawing::circle(PagePoint center, double radius, Ink ink) {
    steps_.emplace_back(FilledCircle{center, radius, ink});
}

void Drawing::text(PagePoint at, std::string_view text, const TextStyle& style) {
    steps_.emplace_back(WrittenText{at, std::string(text), style});
}

void Drawing::begin_clip(PagePoint corner, double width, double height) {
    steps_.emplace_back(ClipBegin{corner, width, height});
}

void Drawing::end_clip() {
    steps_.emplace_back(ClipEnd{});
}

} // namespace gonio
