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

namespace {

// A step of another drawing, as it is on this page.
class Placed {
public:
    Placed(PagePoint corner, double scale) : corner_(corner), scale_(scale) {}

    DrawingStep operator()(FilledPath step) const {
        step.path = moved(step.path);
        return step;
    }
    DrawingStep operator()(StrokedPath step) const {
        step.path = moved(step.path);
        step.pen.width_px *= scale_;
        for (double& length : step.pen.dash_px)
            length *= scale_;
        return step;
    }
    DrawingStep operator()(FilledRectangle step) const { return sized(step); }
    DrawingStep operator()(FilledCircle step) const {
        step.center = moved(step.center);
        step.radius *= scale_;
        return step;
    }
    DrawingStep operator()(WrittenText step) const {
        step.at = moved(step.at);
        step.style.size_px *= scale_;
        step.style.rim_px *= scale_;
        return step;
    }
    DrawingStep operator()(ClipBegin step) const { return sized(step); }
    DrawingStep operator()(ClipEnd step) const { return step; }

private:
    PagePoint moved(PagePoint point) const { return {corner_.x + scale_ * point.x, corner_.y + scale_ * point.y}; }
    PagePath moved(const PagePath& path) const {
        PagePath out;
        for (const PagePath::Part& part : path.parts()) {
            for (std::size_t i = 0; i < part.points.size(); ++i)
                i == 0 ? out.move_to(moved(part.points[i])) : out.line_to(moved(part.points[i]));
            if (part.closed) out.close();
        }
        return out;
    }
    template<class Step>
    Step sized(Step step) const {
        step.corner = moved(step.corner);
        step.width *= scale_;
        step.height *= scale_;
        return step;
    }

    PagePoint corner_;
    double scale_;
};

} // namespace

void Drawing::place(const Drawing& other, PagePoint corner, double scale) {
    const Placed placed(corner, scale);
    for (const DrawingStep& step : other.steps_)
        steps_.push_back(std::visit(placed, step));
}

} // namespace gonio
