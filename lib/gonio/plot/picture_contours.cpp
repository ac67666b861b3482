#include <gonio/base/unit_text.hpp>
#include <gonio/plot/axis.hpp>
#include <gonio/plot/contour.hpp>
#include <gonio/plot/picture_contours.hpp>
#include <gonio/plot/stroke_font.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace gonio {

namespace {

constexpr double text_px = 12.0;
constexpr double shortest_labelled_px = 60.0;
constexpr double between_labels_px = 420.0; // along one line
constexpr double margin_px = 6.0;
constexpr double far_px = 200.0; // from other labels: larger distances score no better

struct Label {
    PagePoint center;
    double half_width = 0.0;
    double half_height = 0.0;

    double gap_to(const Label& other) const {
        const double dx = std::fabs(center.x - other.center.x) - half_width - other.half_width;
        const double dy = std::fabs(center.y - other.center.y) - half_height - other.half_height;
        return std::fmax(dx, dy);
    }
};

double distance(FieldPoint a, FieldPoint b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

double length_of(const ContourLine& line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
        length += distance(line.points[i - 1], line.points[i]);
    return length;
}

// Finds the best place for a label on a line: inside the picture, away from existing labels, on a stretch that is
// straight and closer to level than to steep, so that the number covers little of it.
class LabelPlacer {
public:
    LabelPlacer(int width, int height) : width_(width), height_(height) {}

    std::optional<PagePoint> place(const ContourLine& line, const std::string& text) {
        Label label;
        label.half_width = 0.5 * text_width_px(text, text_px) + 3.0;
        label.half_height = 0.5 * text_px + 1.0;
        std::optional<Label> best;
        double best_score = 0.0;
        const std::size_t step = std::max<std::size_t>(1, line.points.size() / 200);
        for (std::size_t i = 0; i < line.points.size(); i += step) {
            label.center = {line.points[i].x, line.points[i].y};
            const double score = score_of(line, i, label);
            if (score <= best_score) continue;
            best_score = score;
            best = label;
        }
        if (!best) return std::nullopt;
        placed_.push_back(*best);
        return best->center;
    }

private:
    // 0 where a label is not allowed.
    double score_of(const ContourLine& line, std::size_t i, const Label& label) const {
        if (label.center.x - label.half_width < margin_px || label.center.x + label.half_width > width_ - margin_px ||
            label.center.y - label.half_height < margin_px || label.center.y + label.half_height > height_ - margin_px)
            return 0.0;
        double nearest = far_px;
        for (const Label& other : placed_)
            nearest = std::fmin(nearest, label.gap_to(other));
        if (nearest < 6.0) return 0.0;
        // The chord under the label against the length along the line.
        std::size_t first = i;
        std::size_t last = i;
        double way = 0.0;
        while (last + 1 < line.points.size() && way < label.half_width)
            way += distance(line.points[last], line.points[last + 1]), ++last;
        double back = 0.0;
        while (first > 0 && back < label.half_width)
            back += distance(line.points[first], line.points[first - 1]), --first;
        const FieldPoint from = line.points[first];
        const FieldPoint to = line.points[last];
        const double straight = distance(from, to) / std::fmax(way + back, 1e-9);
        const double level = std::fabs(to.x - from.x) / std::fmax(distance(from, to), 1e-9);
        return std::pow(straight, 4.0) * (0.4 + 0.6 * level) * (0.2 + nearest / far_px);
    }

    int width_;
    int height_;
    std::vector<Label> placed_;
};

Field field_of(const Image& values) {
    Field field;
    for (int x = 0; x < values.width; ++x)
        field.xs.push_back(x + 0.5);
    for (int y = 0; y < values.height; ++y)
        field.ys.push_back(y + 0.5);
    field.values.assign(values.pixels.begin(), values.pixels.end());
    return field;
}

PagePath path_of(const ContourLine& line) {
    PagePath path;
    for (const FieldPoint& point : line.points)
        path.empty() ? path.move_to({point.x, point.y}) : path.line_to({point.x, point.y});
    if (line.closed) path.close();
    return path;
}

} // namespace

std::vector<double> contour_levels(double least, double greatest, double unit) {
    constexpr std::size_t wanted = 6;
    std::vector<double> levels = fitting_levels(std::fmax(least, 1e-3 * greatest) / unit, greatest / unit, wanted);
    for (double& level : levels)
        level *= unit;
    return levels;
}

std::vector<Ink> contour_inks(std::size_t count, const Palette& palette) {
    std::vector<Ink> inks;
    for (std::size_t i = 0; i < count; ++i)
        inks.push_back(
            palette.ink_at(count < 2 ? 0.9 : 0.42 + 0.58 * static_cast<double>(i) / static_cast<double>(count - 1)));
    return inks;
}

void dim(Image& picture) {
    for (float& channel : picture.pixels)
        channel *= 0.5F;
}

Drawing contour_drawing(const Image& values, std::span<const std::int32_t> surfaces, std::span<const double> levels,
                        std::span<const Ink> inks, double unit) {
    Drawing drawing(values.width, values.height, {});
    const Field field = field_of(values);
    LabelPlacer placer(values.width, values.height);
    std::vector<WrittenText> labels;
    for (std::size_t i = levels.size(); i-- > 0;) { // the brightest lines are the shortest, so they choose first
        const std::string text = rounded(levels[i] / unit);
        for (const ContourLine& line : contour_lines(field, levels[i], surfaces)) {
            drawing.stroke(path_of(line), {inks[i], 1.4});
            const double length = length_of(line);
            if (length < shortest_labelled_px) continue;
            const int labels_wanted = 1 + static_cast<int>(length / between_labels_px);
            for (int k = 0; k < labels_wanted; ++k) {
                const std::optional<PagePoint> at = placer.place(line, text);
                if (!at) break;
                TextStyle style{TextAnchor::middle, text_px, inks[i], false, 2.2, ink(0x101010)};
                labels.push_back({{at->x, at->y + 0.5 * capital_height * text_px}, text, style});
            }
        }
    }
    for (const WrittenText& label : labels) // above all lines
        drawing.text(label.at, label.text, label.style);
    return drawing;
}

} // namespace gonio
