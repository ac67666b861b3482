#include <gonio/base/version.hpp>
#include <gonio/plot/page_font.hpp>
#include <gonio/plot/page_layout.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace gonio::plot_detail {

namespace {

constexpr double side_pt = 44.0; // margins
constexpr double top_pt = 40.0;
constexpr double foot_pt = 34.0;
constexpr double head_pt = 58.0; // of the page's head, below the margin
constexpr std::array title_sizes_pt{15.0, 13.0, 11.0};

struct PageSize {
    int width;
    int height;
};

PageSize size_of(PaperSize paper) {
    return paper == PaperSize::a4 ? PageSize{595, 842} : PageSize{612, 792};
}

std::string title_of(const SheetFurniture& furniture) {
    return fmt::format("{}: {}", page_text(furniture.title).text, furniture.kind);
}

// At spaces, and within a word that is longer than a line.
std::vector<std::string> wrapped(std::string_view text, double width, double size, std::size_t most) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        if (lines.size() + 1 == most || page_text_width(text, size) <= width) {
            lines.push_back(fitted_text(text, width, size));
            return lines;
        }
        std::size_t end = 0;
        for (std::size_t blank = text.find(' '); blank != std::string_view::npos; blank = text.find(' ', blank + 1)) {
            if (page_text_width(text.substr(0, blank), size) > width) break;
            end = blank;
        }
        if (end == 0) {
            // fitted_text() ends in an ellipsis of three bytes, which nothing is cut for here.
            const std::string cut = fitted_text(text, width, size);
            end = cut.size() > 3 ? cut.size() - 3 : text.size();
        }
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
        while (text.starts_with(' '))
            text.remove_prefix(1);
    }
    return lines;
}

} // namespace

SheetPage::SheetPage(const SheetFurniture& furniture, std::size_t number, std::size_t of)
    : page_(size_of(furniture.paper).width, size_of(furniture.paper).height, title_of(furniture)) {
    const double width = page_.width_px();
    const double height = page_.height_px();
    area_ = {side_pt, top_pt + head_pt, width - side_pt, height - foot_pt - 14.0};
    const double across = area_.width();
    text({area_.left, top_pt + 4.0}, furniture.maker, 0.6 * across, {TextAnchor::start, 8.0, soft_ink});
    text({area_.right, top_pt + 4.0}, furniture.kind, 0.38 * across, {TextAnchor::end, 8.0, soft_ink});
    const std::string title = page_text(furniture.title).text;
    double size = title_sizes_pt.back();
    for (const double candidate : title_sizes_pt)
        if (page_text_width(title, candidate, true) <= across) {
            size = candidate;
            break;
        }
    text({area_.left, top_pt + 25.0}, furniture.title, across, {TextAnchor::start, size, text_ink, true});
    text({area_.left, top_pt + 38.0}, furniture.subtitle, across, {TextAnchor::start, 8.5, soft_ink});
    page_.line({area_.left, top_pt + 45.0}, {area_.right, top_pt + 45.0}, {text_ink, 0.8});

    const double foot = height - foot_pt;
    page_.line({area_.left, foot}, {area_.right, foot}, {rule_ink, 0.4});
    text({area_.left, foot + 10.0}, furniture.source, 0.55 * across, {TextAnchor::start, small_pt, soft_ink});
    text({area_.right, foot + 10.0},
         fmt::format("gonio {}{}", version, of > 1 ? fmt::format(" · page {} of {}", number, of) : std::string()),
         0.4 * across, {TextAnchor::end, small_pt, soft_ink});
}

Area SheetPage::left_half() const {
    Area half = area_;
    half.right = 0.5 * (area_.left + area_.right - column_gap_pt);
    return half;
}

Area SheetPage::right_half() const {
    Area half = area_;
    half.left = 0.5 * (area_.left + area_.right + column_gap_pt);
    return half;
}

void SheetPage::text(PagePoint at, std::string_view bytes, double width, const TextStyle& style) {
    const PageText clean = page_text(bytes);
    replaced_ += clean.replaced;
    const std::string fitted = fitted_text(clean.text, width, style.size_px, style.bold);
    if (!fitted.empty()) page_.text(at, fitted, style);
}

double SheetPage::paragraph(PagePoint top_left, double width, std::string_view bytes, double size, Ink ink,
                            std::size_t most) {
    const PageText clean = page_text(bytes);
    replaced_ += clean.replaced;
    double y = top_left.y;
    for (const std::string& line : wrapped(clean.text, width, size, most)) {
        y += 1.3 * size;
        page_.text({top_left.x, y - 0.3 * size}, line, {TextAnchor::start, size, ink});
    }
    return y;
}

double SheetPage::heading(const Area& area, std::string_view title, std::string_view rule) {
    const double y = area.top + 8.5;
    text({area.left, y}, title, area.width(), {TextAnchor::start, 8.5, text_ink, true});
    if (!rule.empty()) {
        const double taken = page_text_width(page_text(title).text, 8.5, true) + 8.0;
        text({area.right, y}, rule, area.width() - taken, {TextAnchor::end, small_pt, soft_ink});
    }
    page_.line({area.left, y + 4.0}, {area.right, y + 4.0}, {rule_ink, 0.5});
    return y + 6.0;
}

double SheetPage::list(const Area& area, const std::vector<SheetLine>& lines, double names_pt, std::size_t most_lines) {
    const double left = area.left + names_pt;
    const double width = area.right - left;
    const double line_pt = 1.3 * body_pt;
    const auto lines_of = [](std::string_view bytes, double across, double size, std::size_t most) {
        return static_cast<double>(std::max<std::size_t>(1, wrapped(page_text(bytes).text, across, size, most).size()));
    };
    const auto height_of = [&](const SheetLine& line, std::size_t most) {
        return 0.5 + line_pt * lines_of(line.value, width, body_pt, most) +
               (line.rule.empty() ? 0.0 : 1.3 * small_pt * lines_of(line.rule, width, small_pt, 2)) + 1.5;
    };
    // Long values take fewer lines where all of them would not fit.
    std::size_t most = most_lines;
    for (; most > 1; --most) {
        double height = 0.0;
        for (const SheetLine& line : lines)
            height += height_of(line, most);
        if (area.top + height <= area.bottom) break;
    }
    double y = area.top;
    for (const SheetLine& line : lines) {
        const double below = y + height_of(line, most);
        if (below > area.bottom + 0.01) break;
        text({area.left, y + line_pt - 1.4}, line.name, names_pt - 6.0, {TextAnchor::start, body_pt, soft_ink});
        const double end = paragraph({left, y + 0.5}, width, line.value, body_pt, text_ink, most);
        if (!line.rule.empty())
            paragraph({left, std::max(end, y + 0.5 + line_pt)}, width, line.rule, small_pt, soft_ink, 2);
        y = below;
        page_.line({area.left, y}, {area.right, y}, {faint_ink, 0.4});
    }
    return y;
}

double SheetPage::table(const Area& area, const SheetTable& table) {
    const std::size_t columns = table.head.empty() ? table.rows.front().size() : table.head.back().size();
    const double group_gap_pt = 10.0;
    const double across = area.width() - table.first_pt - group_gap_pt * static_cast<double>(table.groups.size());
    const double column_pt = across / static_cast<double>(std::max<std::size_t>(columns, 2) - 1);
    const auto gaps_before = [&](std::size_t column) {
        const auto before =
            std::count_if(table.groups.begin(), table.groups.end(), [&](std::size_t group) { return column >= group; });
        return group_gap_pt * static_cast<double>(before);
    };
    const auto right_of = [&](std::size_t column) {
        return area.left + table.first_pt + column_pt * static_cast<double>(column) + gaps_before(column);
    };
    double y = area.top;
    const auto row = [&](const std::vector<std::string>& cells, Ink ink) {
        y += table.line_pt;
        const double baseline = y - 0.28 * table.line_pt;
        for (std::size_t i = 0; i < cells.size(); ++i)
            i == 0 ? text({area.left, baseline}, cells[0], table.first_pt, {TextAnchor::start, table.size_pt, soft_ink})
                   : text({right_of(i), baseline}, cells[i], column_pt - 1.0, {TextAnchor::end, table.size_pt, ink});
    };
    const auto rule = [&](Ink ink, double width) {
        double left = area.left;
        for (const std::size_t group : table.groups) {
            page_.line({left, y}, {right_of(group - 1), y}, {ink, width});
            left = right_of(group - 1) + group_gap_pt;
        }
        page_.line({left, y}, {area.right, y}, {ink, width});
    };
    for (const std::vector<std::string>& cells : table.head)
        row(cells, soft_ink);
    if (!table.head.empty()) rule(rule_ink, 0.5);
    for (const std::vector<std::string>& cells : table.rows) {
        row(cells, text_ink);
        rule(faint_ink, 0.4);
    }
    return y;
}

void SheetPage::ring(PagePoint center, double radius) {
    constexpr int corners = 32;
    PagePath path;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        const PagePoint at{center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)};
        i == 0 ? path.move_to(at) : path.line_to(at);
    }
    path.close();
    page_.stroke(path, {ink(0x000000), 1.5});
    page_.stroke(std::move(path), {ink(0xff9d5c), 0.75});
}

void SheetPage::diagram(const Area& box, double across_px, const std::function<Result<Drawing>(int, int)>& draw) {
    const double scale = box.width() / across_px;
    const Result<Drawing> drawing = draw(static_cast<int>(std::lround(across_px)),
                                         std::max(160, static_cast<int>(std::floor(box.height() / scale))));
    if (!drawing) {
        paragraph({box.left, box.top + 2.0}, box.width(),
                  fmt::format("None: {}.", drawing.error().diagnostics.back().message), body_pt, soft_ink, 4);
        return;
    }
    const double spare = std::max(0.0, box.height() - scale * drawing->height_px());
    page_.place(*drawing, {box.left, box.top + 0.5 * spare}, scale);
}

} // namespace gonio::plot_detail
