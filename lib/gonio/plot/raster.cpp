#include <gonio/plot/raster.hpp>
#include <gonio/plot/stroke_font.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace gonio {

namespace {

// Pixels [left, right) × [top, bottom).
struct Box {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;

    bool empty() const { return left >= right || top >= bottom; }
    int width() const { return right - left; }
    int height() const { return bottom - top; }
};

// The part of the pixels [low, high) that is inside `bounds`; coordinates may be far beyond the range of an int.
Box box_around(PagePoint low, PagePoint high, const Box& bounds) {
    const auto pixel = [](double at, int least, int most) {
        return static_cast<int>(std::clamp(at, static_cast<double>(least), static_cast<double>(most)));
    };
    return {pixel(std::floor(low.x), bounds.left, bounds.right), pixel(std::floor(low.y), bounds.top, bounds.bottom),
            pixel(std::ceil(high.x), bounds.left, bounds.right), pixel(std::ceil(high.y), bounds.top, bounds.bottom)};
}

struct Extent {
    PagePoint low{1e300, 1e300};
    PagePoint high{-1e300, -1e300};

    void add(PagePoint point) {
        low = {std::fmin(low.x, point.x), std::fmin(low.y, point.y)};
        high = {std::fmax(high.x, point.x), std::fmax(high.y, point.y)};
    }
};

double square(double x) {
    return x * x;
}

// How much of each pixel of a box is covered.
class Coverage {
public:
    explicit Coverage(const Box& box)
        : box_(box),
          stride_(static_cast<std::size_t>(box.width()) + 1),
          values_(stride_ * static_cast<std::size_t>(box.height())) {}

    const Box& box() const { return box_; }
    float* row(int y) { return values_.data() + stride_ * static_cast<std::size_t>(y - box_.top); }

    // The signed area to the right of an edge, as differences along each row; add_up() turns them into coverage.
    void add_edge(PagePoint from, PagePoint to) {
        if (!(from.y != to.y)) return;
        const double sign = from.y < to.y ? 1.0 : -1.0;
        if (sign < 0.0) std::swap(from, to);
        const double slope = (to.x - from.x) / (to.y - from.y);
        const int first = static_cast<int>(std::fmax(std::floor(from.y), box_.top));
        const int last = static_cast<int>(std::fmin(std::ceil(to.y), box_.bottom));
        for (int y = first; y < last; ++y) {
            const double upper = std::fmax(from.y, y);
            const double lower = std::fmin(to.y, y + 1.0);
            if (!(lower > upper)) continue;
            const auto column = [&](double at) {
                return std::clamp(from.x + slope * (at - from.y) - box_.left, 0.0, static_cast<double>(box_.width()));
            };
            const double a = column(upper);
            const double b = column(lower);
            add_row_edge(row(y), std::fmin(a, b), std::fmax(a, b), sign * (lower - upper));
        }
    }

    // Overlapping parts count once.
    void add_up() {
        for (int y = box_.top; y < box_.bottom; ++y) {
            float* const values = row(y);
            float sum = 0.0F;
            for (int x = 0; x < box_.width(); ++x) {
                sum += values[x];
                values[x] = std::min(std::fabs(sum), 1.0F);
            }
        }
    }

    void add_segment(PagePoint from, PagePoint to, double width) {
        const double reach = 0.5 * width + 1.0;
        Extent extent;
        extent.add(from);
        extent.add(to);
        const Box near = box_around({extent.low.x - reach, extent.low.y - reach},
                                    {extent.high.x + reach, extent.high.y + reach}, box_);
        const double dx = to.x - from.x;
        const double dy = to.y - from.y;
        const double length2 = dx * dx + dy * dy;
        for (int y = near.top; y < near.bottom; ++y) {
            float* const values = row(y);
            for (int x = near.left; x < near.right; ++x) {
                const double px = x + 0.5 - from.x;
                const double py = y + 0.5 - from.y;
                const double along = length2 > 0.0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
                const double distance = std::sqrt(square(px - along * dx) + square(py - along * dy));
                // The overlap of the pixel across the line, [d − ½, d + ½], with the line, [−w/2, w/2].
                const double share = std::fmin(distance + 0.5, 0.5 * width) - std::fmax(distance - 0.5, -0.5 * width);
                float& value = values[x - box_.left];
                value = std::max(value, static_cast<float>(std::clamp(share, 0.0, 1.0)));
            }
        }
    }

private:
    static void add_row_edge(float* values, double left, double right, double height) {
        const int first = static_cast<int>(left);
        if (right - left < 1e-9) {
            const double inside = left - first;
            values[first] += static_cast<float>(height * (1.0 - inside));
            if (inside > 0.0) values[first + 1] += static_cast<float>(height * inside);
            return;
        }
        for (int x = first; x < right; ++x) {
            const double begin = std::fmax(left, x);
            const double end = std::fmin(right, x + 1.0);
            const double part = height * (end - begin) / (right - left);
            const double inside = 0.5 * (begin + end) - x;
            values[x] += static_cast<float>(part * (1.0 - inside));
            values[x + 1] += static_cast<float>(part * inside);
        }
    }

    Box box_;
    std::size_t stride_; // one more than the width, because an edge in the last column writes one value past it
    std::vector<float> values_;
};

// A polyline split into its dashes.
std::vector<Polyline> dashes_of(const Polyline& line, const std::array<double, 2>& dash) {
    if (!(dash[0] > 0.0) || !(dash[1] > 0.0)) return {line};
    std::vector<Polyline> dashes;
    bool drawn = true;
    double left = dash[0];
    dashes.push_back({line.front()});
    for (std::size_t i = 1; i < line.size(); ++i) {
        PagePoint from = line[i - 1];
        double length = std::hypot(line[i].x - from.x, line[i].y - from.y);
        while (length > left) {
            from = {from.x + (line[i].x - from.x) * (left / length), from.y + (line[i].y - from.y) * (left / length)};
            length -= left;
            if (drawn)
                dashes.back().push_back(from);
            else
                dashes.push_back({from});
            drawn = !drawn;
            left = dash[drawn ? 0 : 1];
        }
        left -= length;
        if (drawn) dashes.back().push_back(line[i]);
    }
    return dashes;
}

class Painter {
public:
    Painter(Image& image, PagePoint corner)
        : image_(image), corner_(corner), bounds_{0, 0, image.width, image.height}, clip_(bounds_) {}

    void operator()(const FilledPath& step) {
        Extent extent;
        for (const PagePath::Part& part : step.path.parts())
            for (const PagePoint point : part.points)
                extent.add(moved(point));
        const Box box = box_around(extent.low, extent.high, clip_);
        if (box.empty()) return;
        Coverage coverage(box);
        for (const PagePath::Part& part : step.path.parts())
            for (std::size_t i = 0; i < part.points.size(); ++i)
                coverage.add_edge(moved(part.points[i]), moved(part.points[(i + 1) % part.points.size()]));
        coverage.add_up();
        blend(coverage, step.ink);
    }

    void operator()(const StrokedPath& step) {
        std::vector<Polyline> lines;
        for (const PagePath::Part& part : step.path.parts()) {
            Polyline line;
            for (const PagePoint point : part.points)
                line.push_back(moved(point));
            if (part.closed) line.push_back(line.front());
            if (step.path.parts().size() == 1 && line.size() == 2) sharpen(line, step.pen.width_px);
            for (Polyline& dash : dashes_of(line, step.pen.dash_px))
                lines.push_back(std::move(dash));
        }
        stroke(lines, step.pen.width_px, step.pen.ink);
    }

    void operator()(const FilledRectangle& step) {
        PagePath path;
        path.move_to(step.corner).line_to({step.corner.x + step.width, step.corner.y});
        path.line_to({step.corner.x + step.width, step.corner.y + step.height});
        path.line_to({step.corner.x, step.corner.y + step.height}).close();
        (*this)(FilledPath{std::move(path), step.ink});
    }

    void operator()(const FilledCircle& step) { stroke({{moved(step.center)}}, 2.0 * step.radius, step.ink); }

    void operator()(const WrittenText& step) {
        const TextStyle& style = step.style;
        const double width = text_width_px(step.text, style.size_px);
        PagePoint at = moved(step.at);
        at.x -= style.anchor == TextAnchor::start ? 0.0 : style.anchor == TextAnchor::middle ? 0.5 * width : width;
        const std::vector<Polyline> lines = text_lines(step.text, at, style.size_px, true);
        const double weight = style.size_px * (style.bold ? bold_stroke_weight : stroke_weight);
        if (style.rim_px > 0.0) stroke(lines, weight + 2.0 * style.rim_px, style.rim);
        stroke(lines, weight, style.ink, 1.35);
    }

    void operator()(const ClipBegin& step) {
        const PagePoint low = moved(step.corner);
        clip_ = box_around({std::round(low.x), std::round(low.y)},
                           {std::round(low.x + step.width), std::round(low.y + step.height)}, bounds_);
    }

    void operator()(const ClipEnd& /*step*/) { clip_ = bounds_; }

private:
    PagePoint moved(PagePoint point) const { return {point.x + corner_.x, point.y + corner_.y}; }

    // Aligns a line along an axis with whole pixels if it is wide enough to fill one.
    static void sharpen(Polyline& line, double width) {
        const double offset = static_cast<int>(std::round(width)) % 2 == 0 ? 0.0 : 0.5;
        if (line[0].x == line[1].x) line[0].x = line[1].x = std::round(line[0].x - offset) + offset;
        if (line[0].y == line[1].y) line[0].y = line[1].y = std::round(line[0].y - offset) + offset;
    }

    // A single point is a dot, `dot` times as wide.
    void stroke(const std::vector<Polyline>& lines, double width, Ink ink, double dot = 1.0) {
        Extent extent;
        for (const Polyline& line : lines)
            for (const PagePoint point : line)
                extent.add(point);
        const double reach = 0.5 * width + 1.0;
        const Box box = box_around({extent.low.x - reach, extent.low.y - reach},
                                   {extent.high.x + reach, extent.high.y + reach}, clip_);
        if (lines.empty() || box.empty()) return;
        Coverage coverage(box);
        for (const Polyline& line : lines) {
            if (line.size() == 1) coverage.add_segment(line[0], line[0], dot * width);
            for (std::size_t i = 1; i < line.size(); ++i)
                coverage.add_segment(line[i - 1], line[i], width);
        }
        blend(coverage, ink);
    }

    void blend(Coverage& coverage, Ink ink) {
        const std::array<float, 3> color{static_cast<float>(ink.r / 255.0), static_cast<float>(ink.g / 255.0),
                                         static_cast<float>(ink.b / 255.0)};
        const auto opacity = static_cast<float>(ink.opacity);
        const Box& box = coverage.box();
        for (int y = box.top; y < box.bottom; ++y) {
            const float* const share = coverage.row(y);
            for (int x = box.left; x < box.right; ++x) {
                const float weight = opacity * share[x - box.left];
                if (weight <= 0.0F) continue;
                float* const pixel = image_.at(x, y);
                for (std::size_t c = 0; c < 3; ++c)
                    pixel[c] += weight * (color[c] - pixel[c]);
            }
        }
    }

    Image& image_;
    PagePoint corner_;
    Box bounds_;
    Box clip_;
};

} // namespace

void draw(const Drawing& drawing, Image& image, PagePoint corner) {
    Painter painter(image, corner);
    for (const DrawingStep& step : drawing.steps())
        std::visit(painter, step);
}

Image to_image(const Drawing& drawing) {
    Image image(drawing.width_px(), drawing.height_px(), 3);
    std::fill(image.pixels.begin(), image.pixels.end(), 1.0F);
    draw(drawing, image);
    return image;
}

void paste(const Image& from, Image& to, int left, int top) {
    const int first = std::max(0, -left);
    const int last = std::min(from.width, to.width - left);
    if (last <= first) return;
    for (int y = std::max(0, -top); y < std::min(from.height, to.height - top); ++y)
        std::copy_n(from.at(first, y), static_cast<std::size_t>(last - first) * static_cast<std::size_t>(from.channels),
                    to.at(left + first, top + y));
}

} // namespace gonio
