#include <gonio/color/chromaticity.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/plot/color_vector_graphic.hpp>
#include <gonio/plot/diagram_page.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace gonio {

using namespace plot_detail;

namespace {

constexpr Ink light_ink = ink(0xd62020);
constexpr double least_extent = 1.4; // radii of the reference circle from the middle to the edge
constexpr double bin_rad = 2.0 * std::numbers::pi / hue_bin_count;

// A colour of a hue, in CIE L*a*b* under D65, for displays.
Ink hue_ink(double lightness, double chroma, double hue_rad) {
    const auto cube = [](double f) { return f > 6.0 / 29.0 ? f * f * f : (f - 4.0 / 29.0) * 108.0 / 841.0; };
    const double fy = (lightness + 16.0) / 116.0;
    const glm::dvec3 white = to_xyz(d65_white);
    const glm::dvec3 xyz(white.x * cube(fy + chroma * std::cos(hue_rad) / 500.0), cube(fy),
                         white.z * cube(fy - chroma * std::sin(hue_rad) / 200.0));
    const glm::dvec3 rgb = find_rgb_space("rec709")->from_xyz * xyz;
    const auto byte = [](double linear) {
        return static_cast<std::uint8_t>(std::lround(255.0 * encode_srgb(std::clamp(linear, 0.0, 1.0))));
    };
    return {byte(rgb.x), byte(rgb.y), byte(rgb.z), 1.0};
}

struct Wheel {
    PagePoint center;
    double radius_px = 0.0; // of the reference circle

    PagePoint at(double x, double y) const { return {center.x + radius_px * x, center.y - radius_px * y}; }
    PagePoint polar(double radius, double angle_rad) const {
        return at(radius * std::cos(angle_rad), radius * std::sin(angle_rad));
    }
};

PagePath circle(const Wheel& wheel, double radius) {
    PagePath path;
    constexpr int steps = 128;
    path.move_to(wheel.polar(radius, 0.0));
    for (int i = 1; i < steps; ++i)
        path.line_to(wheel.polar(radius, 2.0 * std::numbers::pi * i / steps));
    path.close();
    return path;
}

// Pale hues, whiter towards the middle: rings over each other, each of wedges that overlap, so that no seam shows.
void draw_hues(Drawing& page, const Wheel& wheel, double extent) {
    constexpr int wedges = 48;
    constexpr int rings = 5;
    constexpr double wedge_rad = 2.0 * std::numbers::pi / wedges;
    for (int ring = rings; ring > 0; --ring) {
        const double radius = extent * ring / rings;
        for (int i = 0; i < wedges; ++i) {
            PagePath path;
            path.move_to(wheel.center);
            for (int step = 0; step <= 5; ++step)
                path.line_to(wheel.polar(radius, (i + 0.25 * step) * wedge_rad));
            path.close();
            page.fill(std::move(path), hue_ink(92.0, 22.0 * ring / rings, (i + 0.5) * wedge_rad));
        }
    }
}

// Of a bin on the wheel, relative to the reference, which is on the circle in the middle of its bin.
struct Vector {
    double x = 0.0;
    double y = 0.0;
    double reference_x = 0.0;
    double reference_y = 0.0;
    double middle_rad = 0.0;
};

std::vector<Vector> vectors_of(const ColorFidelity& fidelity) {
    std::vector<Vector> vectors;
    for (std::size_t i = 0; i < hue_bin_count; ++i) {
        const HueBin& bin = fidelity.bins[i];
        if (bin.samples == 0) continue;
        Vector vector;
        vector.middle_rad = (static_cast<double>(i) + 0.5) * bin_rad;
        vector.reference_x = std::cos(vector.middle_rad);
        vector.reference_y = std::sin(vector.middle_rad);
        const double chroma = std::hypot(bin.reference.a, bin.reference.b);
        vector.x = vector.reference_x + (bin.light.a - bin.reference.a) / chroma;
        vector.y = vector.reference_y + (bin.light.b - bin.reference.b) / chroma;
        vectors.push_back(vector);
    }
    return vectors;
}

// A smooth closed curve through all points (Catmull and Rom).
PagePath curve_through(const Wheel& wheel, const std::vector<Vector>& points) {
    constexpr int steps = 10;
    PagePath path;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vector& before = points[(i + n - 1) % n];
        const Vector& from = points[i];
        const Vector& to = points[(i + 1) % n];
        const Vector& after = points[(i + 2) % n];
        for (int step = 0; step < steps; ++step) {
            const double t = step / static_cast<double>(steps);
            const auto blend = [t](double a, double b, double c, double d) {
                return 0.5 * (2.0 * b +
                              t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * b - a - 3.0 * c + d))));
            };
            const PagePoint at =
                wheel.at(blend(before.x, from.x, to.x, after.x), blend(before.y, from.y, to.y, after.y));
            i == 0 && step == 0 ? path.move_to(at) : path.line_to(at);
        }
    }
    path.close();
    return path;
}

void draw_arrow(Drawing& page, const Wheel& wheel, const Vector& vector) {
    const Ink ink = hue_ink(48.0, 55.0, vector.middle_rad);
    const PagePoint from = wheel.at(vector.reference_x, vector.reference_y);
    const PagePoint to = wheel.at(vector.x, vector.y);
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (length < 1.0) {
        page.circle(to, 2.5, ink);
        return;
    }
    const double along_x = (to.x - from.x) / length;
    const double along_y = (to.y - from.y) / length;
    const double head = std::fmin(9.0, length);
    const PagePoint neck{to.x - head * along_x, to.y - head * along_y};
    page.line(from, neck, {ink, 3.0});
    PagePath triangle;
    triangle.move_to(to);
    triangle.line_to({neck.x - 0.5 * head * along_y, neck.y + 0.5 * head * along_x});
    triangle.line_to({neck.x + 0.5 * head * along_y, neck.y - 0.5 * head * along_x});
    triangle.close();
    page.fill(std::move(triangle), ink);
}

void draw_corners(Drawing& page, const Area& area, const LightQuality& quality) {
    const bool small = area.width() < 300.0;
    const auto corner = [&](bool right, bool low, const std::string& name, const std::string& value) {
        const double x = right ? area.right : area.left;
        const double y = low ? area.bottom - 4.0 : area.top + 18.0;
        page.text({x, y}, fmt::format("{} {}", name, value),
                  {right ? TextAnchor::end : TextAnchor::start, small ? 11.0 : 16.0, {}, true, 2.0});
    };
    corner(false, false, "Rf", fmt::format("{:.0f}", quality.fidelity->rf));
    corner(true, false, "Rg", fmt::format("{:.0f}", quality.fidelity->rg));
    corner(false, true, "CCT", fmt::format("{:.0f} K", quality.cct->temperature.value));
    corner(true, true, "Duv", fmt::format("{:.4f}", quality.cct->duv));
}

} // namespace

Result<Drawing> color_vector_graphic(const LightQuality& quality, const ColorVectorOptions& options) {
    PlotOptions page_options;
    page_options.width_px = options.width_px;
    page_options.height_px = options.height_px;
    page_options.title = options.title;
    const PlottedWeb name{options.title};
    if (Result<void> fine = check_request({&name, 1}, page_options, 1); !fine) return pass_on(fine);
    if (!quality.fidelity || !quality.cct)
        return fail(Failure::usage, "a light without a reference illuminant has no colour vector graphic");
    const std::vector<Vector> vectors = vectors_of(*quality.fidelity);
    double extent = least_extent;
    for (const Vector& vector : vectors)
        extent = std::fmax(extent, 1.05 * std::hypot(vector.x, vector.y));

    const LegendEntry legend[] = {{"light", {light_ink, 2.5}}, {"reference illuminant", {ink(0x000000), 1.5}}};
    Area area;
    Drawing page = begin_page({&name, 1}, page_options, "colour vector graphic", legend, area);
    Wheel wheel;
    wheel.center = {0.5 * (area.left + area.right), 0.5 * (area.top + area.bottom)};
    wheel.radius_px = 0.5 * std::fmin(area.width(), area.height()) / extent;
    draw_hues(page, wheel, extent);
    for (const double radius : {0.8, 0.9, 1.1, 1.2})
        page.stroke(circle(wheel, radius), {ink(0xffffff), 1.0});
    for (std::size_t i = 0; i < hue_bin_count; ++i) {
        const double angle = static_cast<double>(i) * bin_rad;
        page.line(wheel.center, wheel.polar(extent, angle), {ink(0x999999), 0.75, {3.0, 3.0}});
        const PagePoint at = wheel.polar(extent * 0.95, angle + 0.5 * bin_rad);
        page.text({at.x, at.y + 4.0}, fmt::format("{}", i + 1), {TextAnchor::middle, 11.0, ink(0x555555)});
    }
    page.stroke(circle(wheel, 1.0), {ink(0x000000), 1.5});
    page.stroke(curve_through(wheel, vectors), {light_ink, 2.5});
    for (const Vector& vector : vectors)
        draw_arrow(page, wheel, vector);
    draw_corners(page, area, quality);
    return page;
}

} // namespace gonio
