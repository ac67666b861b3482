#include <gonio/base/unit_text.hpp>
#include <gonio/plot/legend.hpp>
#include <gonio/plot/raster.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace gonio {

namespace {

constexpr Ink paper = ink(0x17181a);
constexpr Ink words = ink(0xdcdcdc);
constexpr TextStyle number_style{TextAnchor::start, 12.0, words};
constexpr double left_px = 12.0;
constexpr double bar_px = 16.0;
constexpr double top_px = 40.0;
constexpr double foot_px = 50.0; // space below the bar for the greatest value
constexpr double line_px = 17.0; // space that a number needs

// Four digits; large numbers without an exponent.
std::string number(double value) {
    return value >= 1000.0 ? rounded(std::round(value), 9) : rounded(value, 4);
}

// The picture with an empty column added on the right.
Image widened(const Image& picture) {
    Image wide(picture.width + legend_width_px, picture.height, 3);
    Drawing background(wide.width, wide.height, {});
    background.rectangle({static_cast<double>(picture.width), 0.0}, legend_width_px, picture.height, paper);
    draw(background, wide);
    paste(picture, wide, 0, 0);
    return wide;
}

Drawing begin_legend(int height, const LegendUnit& unit, double greatest) {
    Drawing legend(legend_width_px, height, {});
    legend.text({left_px, 24.0}, unit.symbol, {TextAnchor::start, 14.0, words, true});
    if (height >= 160) {
        legend.text({left_px, height - 26.0}, "max", {TextAnchor::start, 12.0, ink(0x9a9a9a)});
        legend.text({left_px, height - 10.0}, number(greatest / unit.factor), number_style);
    }
    return legend;
}

} // namespace

Image with_legend(const Image& picture, const RampLegend& legend) {
    Image wide = widened(picture);
    const double bottom = std::fmax(picture.height - (picture.height >= 160 ? foot_px : 10.0), top_px + 1.0);
    const double height = bottom - top_px;
    const double left = picture.width + left_px;
    const auto last = static_cast<double>(legend.ramp.size() - 1);
    for (int y = static_cast<int>(top_px); y < std::min(static_cast<int>(bottom), picture.height); ++y) {
        const double share = std::clamp((bottom - y - 0.5) / height, 0.0, 1.0);
        const std::array<float, 3>& color = legend.ramp[static_cast<std::size_t>(std::lround(share * last))];
        for (int x = static_cast<int>(left); x < static_cast<int>(left + bar_px); ++x)
            std::copy(color.begin(), color.end(), wide.at(x, y));
    }
    Drawing page = begin_legend(picture.height, legend.unit, legend.use.greatest);
    const auto point = [&](double foot, double tip, const std::array<float, 3>& color) {
        PagePath path;
        path.move_to({left_px, foot}).line_to({left_px + bar_px, foot}).line_to({left_px + 0.5 * bar_px, tip}).close();
        const auto byte = [](float v) {
            return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(v, 0.0F, 1.0F)));
        };
        page.fill(std::move(path), {byte(color[0]), byte(color[1]), byte(color[2])});
    };
    if (legend.use.above_share > 0.0) point(top_px, top_px - 8.0, legend.ramp.back());
    if (legend.use.below_share > 0.0) point(bottom, bottom + 8.0, legend.ramp.front());
    const int room = std::max(2, static_cast<int>(height / (1.6 * line_px)));
    double free_below = bottom + line_px;
    for (const double value : scale_numbers(legend.scale, legend.unit.factor, room)) {
        const double y = bottom - height * legend.scale.share(value);
        if (y > free_below - line_px) continue;
        free_below = y;
        page.line({left_px + bar_px, y}, {left_px + bar_px + 4.0, y}, {words});
        page.text({left_px + bar_px + 8.0, y + 4.5}, rounded(value / legend.unit.factor), number_style);
    }
    draw(page, wide, {static_cast<double>(picture.width), 0.0});
    return wide;
}

Image with_legend(const Image& picture, const LineLegend& legend) {
    Image wide = widened(picture);
    Drawing page = begin_legend(picture.height, legend.unit, legend.greatest);
    double y = top_px + 8.0;
    for (std::size_t i = legend.levels.size(); i-- > 0 && y < picture.height - (picture.height >= 160 ? foot_px : 4.0);
         y += line_px + 3.0) {
        page.line({left_px, y}, {left_px + bar_px, y}, {legend.inks[i], 3.0});
        page.text({left_px + bar_px + 8.0, y + 4.5}, rounded(legend.levels[i] / legend.unit.factor), number_style);
    }
    draw(page, wide, {static_cast<double>(picture.width), 0.0});
    return wide;
}

} // namespace gonio
