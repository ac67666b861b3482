#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/palette.hpp>
#include <gonio/plot/raster.hpp>
#include <gonio/plot/sheet.hpp>
#include <gonio/plot/stroke_font.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

constexpr Ink paper = ink(0x17181a);
constexpr Ink card = ink(0x232529);
constexpr Ink words = ink(0xe4e4e4);
constexpr Ink quiet = ink(0x9aa0a6);
constexpr Ink alarm = ink(0xf2a39b);
constexpr Ink grid = ink(0x4a4f57);
constexpr Ink first_plane = ink(0xffc24d);
constexpr Ink second_plane = ink(0x6cb8f0);

constexpr int gap_px = 10;
constexpr int title_px = 40;
constexpr int words_px = 42; // text below the picture
constexpr double name_px = 13.0;
constexpr double fact_px = 12.0;

int tile_width(const SheetOptions& options) {
    return options.picture_width_px + (options.polar ? sheet_polar_px : 0);
}

int tile_height(const SheetOptions& options) {
    return std::max(options.picture_height_px, options.polar ? sheet_polar_px : 0) + words_px;
}

// UTF-8 text cut where it becomes too wide.
std::string cut(const std::string& text, double size_px, double width_px) {
    if (text_width_px(text, size_px) <= width_px) return text;
    std::string kept = text;
    while (!kept.empty() && text_width_px(kept + "…", size_px) > width_px) {
        while (!kept.empty() && (static_cast<unsigned char>(kept.back()) & 0xc0U) == 0x80U)
            kept.pop_back();
        if (!kept.empty()) kept.pop_back();
    }
    return kept + "…";
}

// Text broken into lines that fit; a word that is longer than a line is cut.
std::vector<std::string> wrapped(const std::string& text, double size_px, double width_px, std::size_t most) {
    std::vector<std::string> lines;
    std::string line;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        begin = end + 1;
        std::string longer = line;
        if (!line.empty()) longer += ' ';
        longer += word;
        if (line.empty() || text_width_px(longer, size_px) <= width_px) {
            line = longer;
            continue;
        }
        lines.push_back(cut(line, size_px, width_px));
        line = word;
    }
    if (!line.empty()) lines.push_back(cut(line, size_px, width_px));
    if (lines.size() > most) {
        lines.resize(most);
        lines.back() = cut(lines.back() + " …", size_px, width_px);
    }
    return lines;
}

Drawing words_of(const SheetTile& tile, const SheetOptions& options) {
    const double width = tile_width(options);
    const double top = tile_height(options) - words_px;
    Drawing drawing(tile_width(options), tile_height(options), {});
    drawing.text({8.0, top + 17.0}, cut(tile.name, name_px, width - 16.0), {TextAnchor::start, name_px, words});
    double y = top + 33.0;
    for (const std::string& fact : tile.facts) {
        drawing.text({8.0, y}, cut(fact, fact_px, width - 16.0), {TextAnchor::start, fact_px, quiet});
        y += 14.0;
    }
    if (tile.fault.empty()) return drawing;
    y = 26.0;
    for (const std::string& line :
         wrapped(tile.fault, fact_px, width - 24.0, static_cast<std::size_t>((top - 26.0) / 16.0))) {
        drawing.text({12.0, y}, line, {TextAnchor::start, fact_px, alarm});
        y += 16.0;
    }
    return drawing;
}

} // namespace

SheetLayout layout_of(std::size_t tiles, const SheetOptions& options) {
    const int width = tile_width(options) + gap_px;
    const int height = tile_height(options) + gap_px;
    const auto count = static_cast<double>(std::max<std::size_t>(tiles, 1));
    SheetLayout layout;
    layout.columns = options.columns > 0
                         ? options.columns
                         : static_cast<int>(std::lround(std::sqrt(count * height * 4.0 / (3.0 * width))));
    layout.columns = std::clamp(layout.columns, 1, static_cast<int>(count));
    layout.rows = static_cast<int>(std::ceil(count / layout.columns));
    layout.width_px = layout.columns * width + gap_px;
    layout.height_px = layout.rows * height + gap_px + (options.title.empty() ? 0 : title_px);
    return layout;
}

Image sheet(std::span<const SheetTile> tiles, const SheetOptions& options) {
    const SheetLayout layout = layout_of(tiles.size(), options);
    Image image(layout.width_px, layout.height_px, 3);
    Drawing background(image.width, image.height, {});
    background.rectangle({0.0, 0.0}, image.width, image.height, paper);
    if (!options.title.empty())
        background.text({gap_px + 2.0, title_px - 8.0}, options.title, {TextAnchor::start, 18.0, words, true});
    draw(background, image);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const SheetTile& tile = tiles[i];
        const int column = static_cast<int>(i) % layout.columns;
        const int row = static_cast<int>(i) / layout.columns;
        const int left = gap_px + column * (tile_width(options) + gap_px);
        const int top = gap_px + (options.title.empty() ? 0 : title_px) + row * (tile_height(options) + gap_px);
        const PagePoint corner{static_cast<double>(left), static_cast<double>(top)};
        Drawing empty(image.width, image.height, {});
        empty.rectangle({0.0, 0.0}, tile_width(options), tile_height(options), card);
        draw(empty, image, corner);
        paste(tile.picture, image, left, top);
        if (tile.polar) draw(*tile.polar, image, {corner.x + options.picture_width_px, corner.y});
        draw(words_of(tile, options), image, corner);
    }
    return image;
}

Drawing polar_thumbnail(const Web& web) {
    constexpr double size = sheet_polar_px;
    constexpr double radius = 0.5 * size - 10.0;
    constexpr double middle = 0.5 * size;
    Drawing drawing(sheet_polar_px, sheet_polar_px, {});
    const auto at = [&](double gamma_deg, double share) {
        const double angle = gamma_deg * (std::numbers::pi / 180.0);
        return PagePoint{middle + radius * share * std::sin(angle), middle + radius * share * std::cos(angle)};
    };
    for (const double ring : {1.0 / 3.0, 2.0 / 3.0, 1.0}) {
        PagePath circle;
        for (int gamma = 0; gamma < 360; gamma += 4)
            circle.empty() ? circle.move_to(at(gamma, ring)) : circle.line_to(at(gamma, ring));
        circle.close();
        drawing.stroke(std::move(circle), {grid, 1.0});
    }
    for (int gamma = 0; gamma < 180; gamma += 30)
        drawing.line(at(gamma, 1.0), at(gamma + 180.0, 1.0), {grid, gamma % 90 == 0 ? 1.0 : 0.6});
    std::vector<std::vector<plot_detail::CurvePoint>> curves;
    double top = 0.0;
    const bool axial = web.stored_symmetry() == Symmetry::axial;
    for (const double c_deg : {0.0, 90.0}) {
        if (axial && !curves.empty()) continue;
        curves.push_back(plot_detail::plane_curve(web, c_deg, 1.0));
        for (const plot_detail::CurvePoint& point : curves.back())
            top = std::fmax(top, point.intensity);
    }
    if (!(top > 0.0)) return drawing;
    for (std::size_t i = curves.size(); i-- > 0;) {
        PagePath path;
        for (const plot_detail::CurvePoint& point : curves[i]) {
            const PagePoint on = at(point.gamma_deg, point.intensity / top);
            path.empty() ? path.move_to(on) : path.line_to(on);
        }
        path.close();
        Ink pale = i == 0 ? first_plane : second_plane;
        pale.opacity = 0.16;
        drawing.fill(path, pale);
        drawing.stroke(std::move(path), {i == 0 ? first_plane : second_plane, 1.6});
    }
    return drawing;
}

} // namespace gonio
