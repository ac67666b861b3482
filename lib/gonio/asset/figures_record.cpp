#include <gonio/asset/figures_record.hpp>
#include <gonio/figures/figure_rules.hpp>

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace gonio::detail {

namespace {

template<std::size_t count>
Json numbers(const std::array<double, count>& values) {
    return std::span<const double, count>(values);
}

template<class Rows>
Json rows_json(const Rows& rows) {
    Json json = Json::array();
    for (const auto& row : rows)
        json.push_back(numbers(row));
    return json;
}

// ["70/50/20", …]: of ceiling, walls and floor in per cent
template<class Columns>
Json reflectances_json(const Columns& columns) {
    Json json = Json::array();
    for (const RoomReflectances& reflectances : columns)
        json.push_back(to_text(reflectances));
    return json;
}

Json luminances_json(const LuminanceDiagram& diagram) {
    Json planes = Json::array();
    for (std::size_t plane = 0; plane < luminance_planes; ++plane)
        planes.push_back(15 * plane);
    return {{"gamma_deg", numbers(luminance_gammas_deg)},
            {"c_deg", std::move(planes)},
            {"nt", rows_json(diagram.nt)},
            {"greatest_nt",
             {{"65", diagram.greatest_nt(65)}, {"75", diagram.greatest_nt(75)}, {"85", diagram.greatest_nt(85)}}},
            {"mean_c0_c180_nt", numbers(diagram.mean_of_planes_nt(0))},
            {"mean_c90_c270_nt", numbers(diagram.mean_of_planes_nt(90))}};
}

// "G*3"; "none"
std::string class_text(const char* letter, int number) {
    return number > 0 ? fmt::format("{}{}", letter, number) : "none";
}

class Members {
public:
    template<class T, class Write>
    void add(const char* name, const Figure<T>& figure, const Write& write) {
        members_[name] = figure ? Json(write(*figure)) : Json(nullptr);
        rules_[name] = rule_of_figure(name);
        if (!figure) missing_[name] = figure.error();
    }
    void note(const char* name, Json value) { members_[name] = std::move(value); }

    Json take() {
        members_["figure_rules"] = std::move(rules_);
        members_["missing_figures"] = std::move(missing_);
        return std::move(members_);
    }

private:
    Json members_ = Json::object();
    Json rules_ = Json::object();
    Json missing_ = Json::object();
};

} // namespace

Json figures_json(const LuminaireFigures& figures) {
    const auto as_is = [](const auto& value) { return value; };
    Members members;
    members.add("light_output_ratios", figures.output, [](const OutputRatios& ratios) {
        return Json{{"lor", ratios.all}, {"dlor", ratios.downward}, {"ulor", ratios.upward}};
    });
    members.add("upward_light_ratio", figures.upward_share, as_is);
    members.add("distribution_class", figures.distribution, [](char letter) { return std::string(1, letter); });
    members.note("crosswise_c_deg", figures.crosswise_c_deg == 0.0 ? 0 : 90);
    Json rooms = Json::array();
    for (const UgrRoom& room : ugr_rooms)
        rooms.push_back(fmt::format("{}x{}", room.across, room.along));
    members.note("ugr_rooms", std::move(rooms));
    members.note("ugr_reflectances", reflectances_json(ugr_reflectances));
    members.add("ugr_correction", figures.ugr_correction, as_is);
    const auto table = [](const UgrTable& ugr) { return rows_json(ugr); };
    members.add("ugr_table", figures.ugr, table);
    members.add("ugr_table_sh1", figures.ugr_sh1, table);
    members.add("luminances", figures.luminances, luminances_json);
    members.note("room_indices", numbers(room_indices));
    members.add("direct_ratios", figures.direct_ratios, [](const auto& ratios) { return numbers(ratios); });
    members.note("utilisation_reflectances", reflectances_json(utilisation_reflectances));
    members.add("utilisation_factors", figures.factors, [](const auto& factors) { return rows_json(factors); });
    members.note("cu_reflectances", reflectances_json(cu_reflectances));
    members.add("coefficients_of_utilisation", figures.coefficients,
                [](const auto& coefficients) { return rows_json(coefficients); });
    members.add("bug", figures.bug, [](const BugRating& rating) {
        return Json{{"backlight", rating.backlight}, {"uplight", rating.uplight},
                    {"glare", rating.glare},         {"glare_type_v", rating.glare_type_v},
                    {"rating", to_text(rating)},     {"rating_type_v", to_text(rating, true)}};
    });
    members.add("cut_off", figures.cut_off_class, [](CutOff cut_off) { return to_text(cut_off); });
    members.add("luminous_intensity_class", figures.intensity_class,
                [](int number) { return class_text("G*", number); });
    members.add("luminous_intensity_class_lamps", figures.intensity_class_lamp,
                [](int number) { return class_text("G*", number); });
    members.add("glare_index", figures.glare, [](const GlareIndex& index) {
        return Json{{"cd_per_m", index.cd_per_m}, {"class", class_text("D", index.glare_index_class)}};
    });
    return members.take();
}

} // namespace gonio::detail
