#include <gonio/base/unit_text.hpp>
#include <gonio/plot/page_layout.hpp>
#include <gonio/plot/room_sheet.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace gonio {

using namespace plot_detail;

namespace {

constexpr double row_gap_pt = 12.0;
constexpr double names_pt = 84.0;
constexpr double plan_px = 640.0;                // width that the plan is drawn for
constexpr double plan_furniture_wide_px = 172.0; // numbers, names and scale beside the plan
constexpr double plan_furniture_high_px = 92.0;
constexpr double symbol_pt = 12.0; // in the list of luminaires
constexpr std::size_t most_luminaires = 12;

std::string amount(double value) {
    return value >= 100.0 && value < 1e6 ? fmt::format("{:.0f}", value) : rounded(value, 3);
}

std::vector<SheetLine> lines_of(const std::vector<std::pair<std::string, std::string>>& pairs) {
    std::vector<SheetLine> lines;
    for (const auto& [name, value] : pairs)
        lines.push_back({name, value});
    return lines;
}

std::string number_text(double value, const Verdict& verdict) {
    const std::string number = fmt::format("{:.{}f}", value, verdict.decimals);
    return verdict.unit.empty() ? number : fmt::format("{} {}", number, verdict.unit);
}

SheetTable verdict_rows(const std::vector<Verdict>& verdicts) {
    SheetTable table;
    table.first_pt = 104.0;
    table.head = {{"", "required", "reached", ""}};
    for (const Verdict& verdict : verdicts) {
        const std::optional<bool> passes = verdict.passes();
        table.rows.push_back(
            {std::string(verdict.what),
             fmt::format("{} {}", verdict.is_limit ? "≤" : "≥", number_text(verdict.required, verdict)),
             verdict.reached ? number_text(*verdict.reached, verdict) : std::string("–"),
             !passes   ? "not known"
             : *passes ? "pass"
                       : "FAIL"});
    }
    return table;
}

} // namespace

Result<RoomSheet> room_sheet(const RoomSheetContent& content, PaperSize paper) {
    SheetFurniture furniture;
    furniture.paper = paper;
    furniture.kind = "Lighting plan";
    furniture.title = content.title;
    furniture.source = content.source;
    SheetPage page(furniture, 1, 1);

    Area left = page.left_half();
    left.top = page.heading(left, "Room");
    const double below_facts = page.list(left, lines_of(content.facts), names_pt, 2);
    Area right = page.right_half();
    if (!content.verdicts.empty()) {
        right.top = page.heading(right, content.task);
        right.top = page.table(right, verdict_rows(content.verdicts)) + row_gap_pt;
    }
    if (!content.glare.empty()) {
        right.top = page.heading(right, "UGR", content.glare_rule);
        right.top = page.list(right, lines_of(content.glare), names_pt);
    }

    Area area = page.area();
    area.top = std::max(below_facts, right.top) + row_gap_pt;
    const std::size_t kinds = std::min(content.luminaires.size(), most_luminaires);
    const std::size_t rows = kinds + (content.luminaires.size() > kinds ? 1 : 0) + 2; // with head and sum
    const double list_pt = 14.5 + 9.6 * static_cast<double>(rows) + 8.0;
    Area plan = area;
    plan.bottom = page.area().bottom - list_pt - row_gap_pt;
    GridPlot plot = content.plot;
    plot.title.clear();
    plot.facts.clear();
    plan.top = page.heading(plan, content.plot.title.empty() ? "Plan" : content.plot.title, content.plot.facts);
    // The plan's own proportions, with its numbers and names: no gap below it.
    const double scale = plan.width() / plan_px;
    const double across_m = plot.width_m + 2.0 * plot.margin_m;
    const double along_m = plot.height_m + 2.0 * plot.margin_m;
    plan.bottom = std::min(
        plan.bottom, plan.top + scale * std::max(160.0, plan_furniture_high_px +
                                                            (plan_px - plan_furniture_wide_px) * along_m / across_m));
    bool left_out = false;
    std::optional<Error> error;
    page.diagram(plan, plan_px, [&](int width_px, int height_px) {
        plot.width_px = width_px;
        plot.height_px = height_px;
        Result<Drawing> drawing = grid_diagram(plot, left_out);
        if (!drawing) error = drawing.error();
        return drawing;
    });
    if (error) return Unexpected(std::move(*error));

    Area list = area;
    list.top = plan.bottom + row_gap_pt;
    list.top = page.heading(list, "Luminaires");
    double y = list.top;
    const double width = list.width();
    // Symbol and name take half of the width.
    const std::vector<double> rights{0.58 * width, 0.70 * width, 0.82 * width, width};
    const auto row = [&](const std::string& name, const std::vector<std::string>& cells, Ink ink, bool bold) {
        y += 9.6;
        page.text({list.left + symbol_pt, y - 2.7}, name, 0.5 * width - symbol_pt, {TextAnchor::start, 7.0, ink, bold});
        for (std::size_t i = 0; i < cells.size(); ++i)
            page.text({list.left + rights[i], y - 2.7}, cells[i], (i == 3 ? 0.16 : 0.11) * width,
                      {TextAnchor::end, 7.0, ink, bold});
    };
    const auto number = [](const std::optional<double>& value, std::string_view unit) {
        return value ? fmt::format("{} {}", amount(*value), unit) : std::string("–");
    };
    row("", {"count", "power", content.flux_head, "mounting"}, soft_ink, false);
    std::size_t count = 0;
    std::optional<double> watts = 0.0;
    std::optional<double> lumens = 0.0;
    for (std::size_t i = 0; i < content.luminaires.size(); ++i) {
        const RoomSheetLuminaire& each = content.luminaires[i];
        count += each.count;
        const auto add = [&](std::optional<double>& sum, const std::optional<double>& one) {
            sum = sum && one ? std::optional(*sum + *one * static_cast<double>(each.count)) : std::nullopt;
        };
        add(watts, each.input_w);
        add(lumens, each.flux_lm);
        if (i >= kinds) continue;
        row(each.letter.empty() ? each.name : fmt::format("{}   {}", each.letter, each.name),
            {fmt::format("{}", each.count), number(each.input_w, "W"), number(each.flux_lm, "lm"), each.mounting},
            text_ink, false);
        page.ring({list.left + 4.0, y - 5.2}, 2.8);
    }
    if (content.luminaires.size() > kinds)
        row(fmt::format("and {} more kinds", content.luminaires.size() - kinds), {}, soft_ink, false);
    row("In all", {fmt::format("{}", count), number(watts, "W"), number(lumens, "lm"), ""}, text_ink, true);

    RoomSheet sheet;
    sheet.replaced = page.replaced();
    sheet.pages.push_back(page.take());
    return sheet;
}

} // namespace gonio
