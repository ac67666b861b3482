#include <gonio/base/unit_text.hpp>
#include <gonio/plot/opening_diagram.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

constexpr Ink line_ink = ink(0x1c1c1c);
constexpr Ink dimension_ink = ink(0x666666);
constexpr Ink light_ink = ink(0xfff3c4);
constexpr double letters_px = 11.0;
constexpr double least_px = 2.0; // of a side that is thin or absent

struct Box {
    PagePoint middle;
    double width = 0.0;
    double height = 0.0;
};

bool is_round_from_above(OpeningShape shape) {
    return shape == OpeningShape::disk || shape == OpeningShape::ellipse || shape == OpeningShape::vertical_cylinder ||
           shape == OpeningShape::sphere || shape == OpeningShape::ellipsoid;
}

bool is_round_from_the_side(OpeningShape shape) {
    return shape == OpeningShape::sphere || shape == OpeningShape::ellipsoid ||
           shape == OpeningShape::horizontal_cylinder_across;
}

void draw_shape(Drawing& page, const Box& box, bool is_round) {
    PagePath path;
    const double x = 0.5 * std::max(box.width, least_px);
    const double y = 0.5 * std::max(box.height, least_px);
    constexpr int corners = 96;
    if (is_round)
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners;
            const PagePoint at{box.middle.x + x * std::cos(angle), box.middle.y + y * std::sin(angle)};
            i == 0 ? path.move_to(at) : path.line_to(at);
        }
    else
        path.move_to({box.middle.x - x, box.middle.y - y})
            .line_to({box.middle.x + x, box.middle.y - y})
            .line_to({box.middle.x + x, box.middle.y + y})
            .line_to({box.middle.x - x, box.middle.y + y});
    path.close();
    page.fill(path, light_ink);
    page.stroke(std::move(path), {line_ink, 1.2});
}

std::string millimeters(double length_m) {
    return fmt::format("{} mm", rounded(1000.0 * length_m, 4));
}

void tick(Drawing& page, PagePoint at) {
    page.line({at.x - 2.5, at.y + 2.5}, {at.x + 2.5, at.y - 2.5}, {dimension_ink, 1.0});
}

// Below the shape.
void draw_width(Drawing& page, const Box& box, double length_m) {
    const double y = box.middle.y + 0.5 * box.height + 14.0;
    const double left = box.middle.x - 0.5 * box.width;
    const double right = box.middle.x + 0.5 * box.width;
    page.line({left, y}, {right, y}, {dimension_ink, 0.7});
    tick(page, {left, y});
    tick(page, {right, y});
    page.text({box.middle.x, y + 14.0}, millimeters(length_m), {TextAnchor::middle, letters_px, dimension_ink});
}

// On the right of the shape.
void draw_height(Drawing& page, const Box& box, double length_m) {
    const double x = box.middle.x + 0.5 * box.width + 14.0;
    const double top = box.middle.y - 0.5 * box.height;
    const double bottom = box.middle.y + 0.5 * box.height;
    page.line({x, top}, {x, bottom}, {dimension_ink, 0.7});
    tick(page, {x, top});
    tick(page, {x, bottom});
    page.text({x + 7.0, box.middle.y + 4.0}, millimeters(length_m), {TextAnchor::start, letters_px, dimension_ink});
}

} // namespace

Result<Drawing> opening_diagram(const Opening& opening, int width_px, int height_px) {
    const double largest_m = opening.largest_m();
    if (opening.shape == OpeningShape::point || !(largest_m > 0.0) || !std::isfinite(largest_m))
        return fail(Failure::usage, "the file states no luminous opening");
    Drawing page(width_px, height_px, "luminous opening: " + to_text(opening));
    const glm::dvec3& size = opening.size_m;
    const bool has_side = size.z > 0.0;
    constexpr double number_px = 76.0; // beside a shape
    constexpr double below_px = 36.0;
    constexpr double above_px = 24.0;
    const double half = has_side ? 0.58 * width_px : 1.0 * width_px;
    const double room_x = std::min(half - number_px - 30.0, 0.42 * width_px);
    const double room_y = height_px - below_px - above_px - 12.0;
    const double px_per_m = std::min({room_x / std::max(size.x, 1e-9), room_y / std::max({size.y, size.z, 1e-9}),
                                      room_x / std::max(largest_m, 1e-9),
                                      has_side ? (width_px - half - number_px) / std::max(size.x, 1e-9) : 1e12});
    const double middle_y = above_px + 0.5 * room_y;
    const Box plan{{has_side ? 30.0 + 0.5 * room_x : 0.46 * width_px, middle_y}, px_per_m * size.x, px_per_m * size.y};
    draw_shape(page, plan, is_round_from_above(opening.shape));
    page.text({8.0, 12.0}, "from above, C0 →, C90 ↑", {TextAnchor::start, letters_px, dimension_ink});
    if (size.x > 0.0) draw_width(page, plan, size.x);
    if (size.y > 0.0) draw_height(page, plan, size.y);
    if (has_side) {
        const double room_side = width_px - half - number_px;
        const Box side{{half + 0.5 * room_side, middle_y}, px_per_m * size.x, px_per_m * size.z};
        draw_shape(page, side, is_round_from_the_side(opening.shape));
        page.text({half - 8.0, 12.0}, "from the side, C0 →", {TextAnchor::start, letters_px, dimension_ink});
        draw_height(page, side, size.z);
    }
    page.text({8.0, height_px - 4.0}, to_text(opening), {TextAnchor::start, letters_px, line_ink});
    return page;
}

} // namespace gonio
