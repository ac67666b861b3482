#include "probe_report.hpp"

#include <gonio/base/codes/result.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/figures/disability_glare.hpp>
#include <gonio/plot/grid_diagram.hpp>

#include "../facts_text.hpp"
#include "../options/glare_text.hpp"
#include "../options/output.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

namespace gonio::cli {

namespace {

// Whether all receivers lie on a floor.
bool face_up(std::span<const Receiver> receivers) {
    return std::all_of(receivers.begin(), receivers.end(), [](const Receiver& receiver) {
        return receiver.normal.z > 0.999 * glm::length(receiver.normal);
    });
}

constexpr std::size_t points_listed = 100; // as text; more are summarised

// Shown of a grid: the share of the points that is not brighter.
struct Percentile {
    std::string_view key;
    std::string_view name;
    double percent;
};
constexpr std::array percentiles{Percentile{"percentile_5", "5 %", 5.0}, Percentile{"percentile_50", "median", 50.0},
                                 Percentile{"percentile_95", "95 %", 95.0}};

std::string_view name_of(IlluminanceKind kind) {
    for (const IlluminanceKindName& known : illuminance_kinds())
        if (known.kind == kind) return known.name;
    return {};
}

// Of the modelling index; 0 in the dark.
double index_of(const ProbeStretch& stretch, std::size_t i) {
    const double horizontal = stretch.horizontal_lx[i];
    return horizontal > 0.0 ? stretch.by_method.front().illuminance_lx[i] / horizontal : 0.0;
}

double relative_error(double value, double truth) {
    return value == truth ? 0.0 : (value - truth) / truth;
}

// The compared value: the luminance if requested, else the illuminance.
double compared(const ProbeResult& result, std::size_t i) {
    return result.luminance.empty() ? result.illuminance_lx[i] : result.luminance[i].total().value;
}

Json luminance_json(const ProbeLuminance& nt, bool with_error) {
    Json json{{"diffuse", nt.diffuse.value}, {"specular", nt.specular.value}, {"total", nt.total().value}};
    if (with_error) json["error_estimate"] = nt.error_estimate.value;
    return json;
}

Json vector_json(const glm::dvec3& v) {
    return Json::array({v.x, v.y, v.z});
}

// What an illuminance consists of on a stage or under a sky.
struct Source {
    std::string_view name;
    const std::vector<double>* lx;
};

std::vector<Source> sources_of(const ProbeRequest& request, const ProbeStretch& stretch) {
    std::vector<Source> sources;
    if (!request.stage) return sources;
    sources.push_back({"direct", &stretch.direct_lx});
    if (!request.sky.is_dark()) sources.push_back({"sky", &stretch.sky_lx});
    if (request.indirect) sources.push_back({"indirect", &stretch.indirect_lx});
    return sources;
}

// One of the compared methods at a point, relative to the first of them.
Json method_json(const ProbeRequest& request, const ProbeStretch& stretch, std::size_t m, std::size_t i) {
    const ProbeResult& truth = stretch.by_method.front();
    const ProbeResult& result = stretch.by_method[m];
    const double lx = result.illuminance_lx[i];
    // A ratio to zero is not a number.
    Json json{{"method", to_text(request.methods[m])},
              {"illuminance_lx", lx},
              {"error_lx", lx - truth.illuminance_lx[i]},
              {"error_relative", number_or_null(relative_error(lx, truth.illuminance_lx[i]))}};
    if (result.luminance.empty()) return json;
    const double nt = compared(result, i);
    const double true_nt = compared(truth, i);
    json["luminance_nt"] = luminance_json(result.luminance[i], false);
    json["error_nt"] = nt - true_nt;
    json["error_nt_relative"] = number_or_null(relative_error(nt, true_nt));
    return json;
}

// Of the sum L²ω/p² of all lights.
double share_of_glare(const GlareRating& rating, std::size_t light) {
    double sum = 0.0;
    for (const GlareShare& share : rating.lights)
        sum += share.sum;
    return sum > 0.0 ? rating.lights[light].sum / sum : 0.0;
}

// " UGR 17.2 before 45 nt"
std::string glare_text(const GlareRating& rating) {
    return fmt::format(", UGR {} before {} nt", ugr_text(rating), rounded(rating.background.value, 4));
}

Json point_json(const ProbeRequest& request, const ProbeStretch& stretch, std::size_t i) {
    const Receiver& receiver = stretch.receivers[i];
    const ProbeResult& result = stretch.by_method.front();
    const bool estimated = !result.illuminance_error_lx.empty();
    Json json{{"position", vector_json(receiver.position)},
              {"normal", vector_json(unit_vector(receiver.normal).value_or(receiver.normal))},
              {"illuminance_lx", result.illuminance_lx[i]}};
    if (!stretch.horizontal_lx.empty()) {
        json["horizontal_lx"] = stretch.horizontal_lx[i];
        json["modelling_index"] = index_of(stretch, i);
    }
    for (const Source& source : sources_of(request, stretch))
        json[fmt::format("{}_lx", source.name)] = (*source.lx)[i];
    if (estimated) json["illuminance_error_lx"] = result.illuminance_error_lx[i];
    if (!result.luminance.empty()) json["luminance_nt"] = luminance_json(result.luminance[i], estimated);
    if (request.compare) {
        Json methods = Json::array();
        for (std::size_t m = 0; m < request.methods.size(); ++m)
            methods.push_back(method_json(request, stretch, m, i));
        json["methods"] = std::move(methods);
    }
    if (!stretch.glare.empty()) {
        json["ugr"] = number_or_null(stretch.glare[i].ugr);
        json["background_nt"] = stretch.glare[i].background.value;
    }
    Json lights = Json::array();
    for (std::size_t l = 0; l < request.lights.size(); ++l) {
        const std::size_t part = i * request.lights.size() + l;
        Json light{{"name", request.lights[l].name}, {"illuminance_lx", result.parts_lx[part]}};
        if (!result.parts_nt.empty()) light["luminance_nt"] = luminance_json(result.parts_nt[part], estimated);
        if (!stretch.glare.empty()) {
            const GlareShare& share = stretch.glare[i].lights[l];
            light["glare"] = {{"source_luminance_nt", share.luminance.value},
                              {"solid_angle_sr", share.solid_angle_sr},
                              {"position_index", share.position_index},
                              {"share", share_of_glare(stretch.glare[i], l)}};
        }
        lights.push_back(std::move(light));
    }
    json["lights"] = std::move(lights);
    return json;
}

std::string row_text(const glm::dvec3& p) {
    return fmt::format("{},{},{}", shortest(p.x), shortest(p.y), shortest(p.z));
}

std::string position_text(const glm::dvec3& p) {
    return fmt::format("{},{},{}", rounded(p.x), rounded(p.y), rounded(p.z));
}

std::string percent(double relative) {
    if (!std::isfinite(relative)) return "not dark";
    const std::string text = rounded(100.0 * relative, 3);
    return fmt::format("{}{} %", relative > 0.0 ? "+" : "", text);
}

std::string luminance_text(const ProbeLuminance& nt) {
    return fmt::format("{:>14} nt (diffuse {}, specular {})", rounded(nt.total().value), rounded(nt.diffuse.value),
                       rounded(nt.specular.value));
}

// Heading and width of a method's column in a comparison.
std::string method_column(const ProbeRequest& request, std::size_t m) {
    return fmt::format("{} {}", to_text(request.methods[m]), request.options.view ? "nt" : "lx");
}
std::size_t column_width(const ProbeRequest& request, std::size_t m) {
    return std::max<std::size_t>(14, method_column(request, m).size() + 2);
}

} // namespace

ProbeReport::ProbeReport(const ProbeRequest& request, Console& console) : request_(request), console_(console) {
    for (std::size_t m = 0; m < request.methods.size(); ++m)
        values_.emplace_back();
}

bool ProbeReport::wants_parts() const {
    return request_.form == ProbeForm::json || request_.form == ProbeForm::json_line ||
           (listed() && lights_listed_too());
}

void ProbeReport::begin() {
    if (request_.form == ProbeForm::json || request_.form == ProbeForm::json_line) {
        json_.emplace(console_, request_.form == ProbeForm::json);
        json_->member("schema", "gonio.probe/1");
        if (!request_.rig.empty()) json_->member("rig", request_.rig);
        json_->member("method", to_text(request_.methods.front()));
        if (request_.kind != IlluminanceKind::planar) json_->member("quantity", name_of(request_.kind));
        json_->begin_array("points");
    } else if (request_.form == ProbeForm::csv) {
        console_.print("x,y,z,nx,ny,nz");
        print_csv_heading();
    } else if (request_.compare && listed()) {
        console_.print(fmt::format("{:<24}", "point"));
        for (std::size_t m = 0; m < request_.methods.size(); ++m)
            console_.print(fmt::format("{:>{}}{}", method_column(request_, m), column_width(request_, m),
                                       m == 0 ? "" : "       error"));
        console_.print("\n");
    }
}

void ProbeReport::add(const ProbeStretch& stretch) {
    for (std::size_t i = 0; i < stretch.receivers.size(); ++i) {
        if (json_)
            json_->element(point_json(request_, stretch, i));
        else if (request_.form == ProbeForm::csv)
            csv_row(stretch, i);
        else if (listed())
            text_lines(stretch, i);
    }
    for (std::size_t m = 0; m < request_.methods.size(); ++m) {
        const ProbeResult& result = stretch.by_method[m];
        for (std::size_t i = 0; i < stretch.receivers.size(); ++i)
            values_[m].push_back(request_.compare                ? compared(result, i)
                                 : stretch.horizontal_lx.empty() ? result.illuminance_lx[i]
                                                                 : index_of(stretch, i));
    }
    for (const GlareRating& rating : stretch.glare) {
        lacks_rating_ = lacks_rating_ || !rating.ugr;
        has_too_large_ = has_too_large_ || rating.has_too_large;
    }
    indirect_lx_.insert(indirect_lx_.end(), stretch.indirect_lx.begin(), stretch.indirect_lx.end());
    note_error(stretch.by_method.front());
    remarks_.add(stretch.by_method.front().remarks, stretch.first);
}

void ProbeReport::end(Diagnostics& diagnostics) {
    const Diagnostics said = to_diagnostics(remarks_, request_.summed ? request_.summed->remarked : request_.lights);
    diagnostics.insert(diagnostics.end(), said.begin(), said.end());
    judge();
    add_glare_remarks(lacks_rating_, has_too_large_, diagnostics);
    if (json_) {
        json_->end_array();
        if (request_.methods.front() == IrradianceMethod::reference) json_->member("error_estimate", largest_error_);
        if (request_.points.grid) json_->member("grid", grid_json());
        if (verdict_) json_->member("verdict", verdicts_json(*verdict_));
        json_->member("diagnostics", diagnostics_json(diagnostics));
        json_->end();
    } else if (request_.form == ProbeForm::text && !listed()) {
        summary_text();
        if (verdict_) console_.print(verdicts_text(*verdict_));
    }
}

void ProbeReport::judge() {
    if (!request_.task) return;
    verdict_ = request_.task;
    const Spread all = spread(values_.front());
    ReachedLight reached;
    if (request_.kind == IlluminanceKind::cylindrical) {
        reached.cylindrical_lx = all.mean;
    } else {
        reached.mean_lx = all.mean;
        reached.least_lx = all.least;
        reached.uniformity = all.uniformity();
    }
    if (verdict_->task.gr && request_.kind <= IlluminanceKind::horizontal && face_up(request_.points.receivers)) {
        std::vector<glm::dvec3> points;
        for (const Receiver& receiver : request_.points.receivers)
            points.push_back(receiver.position);
        reached.gr = greatest_field_glare_rating(request_.lights, points, Lux(all.mean));
    }
    verdict_->verdicts = verdicts(verdict_->task, reached, verdict_->raised);
}

bool ProbeReport::listed() const {
    return request_.form == ProbeForm::text && !request_.points.grid &&
           request_.points.receivers.size() <= points_listed;
}

bool ProbeReport::lights_listed_too() const {
    return request_.light_count() > 1 && request_.light_count() <= lights_listed && !request_.compare;
}

void ProbeReport::note_error(const ProbeResult& result) {
    const auto note = [&](double error, double value) {
        if (value > 0.0) largest_error_ = std::max(largest_error_, error / value);
    };
    for (std::size_t i = 0; i < result.illuminance_error_lx.size(); ++i) {
        note(result.illuminance_error_lx[i], result.illuminance_lx[i]);
        if (!result.luminance.empty())
            note(result.luminance[i].error_estimate.value, result.luminance[i].total().value);
    }
}

bool ProbeReport::estimated() const {
    return request_.methods.front() == IrradianceMethod::reference;
}

void ProbeReport::print_csv_heading() {
    if (request_.compare) {
        for (const IrradianceMethod method : request_.methods)
            console_.print(fmt::format(",illuminance_{}_lx", to_text(method)));
        for (const IrradianceMethod method : request_.methods)
            if (request_.options.view) console_.print(fmt::format(",total_{}_nt", to_text(method)));
        console_.print("\n");
        return;
    }
    console_.print(estimated() ? ",illuminance_lx,illuminance_error_lx" : ",illuminance_lx");
    for (const Source& source : sources_of(request_, {}))
        console_.print(fmt::format(",{}_lx", source.name));
    if (request_.options.view) console_.print(",diffuse_nt,specular_nt,total_nt");
    if (request_.kind == IlluminanceKind::modelling) console_.print(",horizontal_lx,modelling_index");
    if (request_.glare) console_.print(",ugr,background_nt");
    console_.print(request_.options.view && estimated() ? ",error_nt\n" : "\n");
}

void ProbeReport::csv_row(const ProbeStretch& stretch, std::size_t i) {
    const Receiver& r = stretch.receivers[i];
    const glm::dvec3 n = unit_vector(r.normal).value_or(r.normal);
    std::string row = row_text(r.position) + ',' + row_text(n);
    const ProbeResult& first = stretch.by_method.front();
    for (const ProbeResult& result : stretch.by_method)
        row += ',' + shortest(result.illuminance_lx[i]);
    if (request_.compare) {
        for (const ProbeResult& result : stretch.by_method)
            if (!result.luminance.empty()) row += ',' + shortest(result.luminance[i].total().value);
    } else {
        if (estimated()) row += ',' + shortest(first.illuminance_error_lx[i]);
        for (const Source& source : sources_of(request_, stretch))
            row += ',' + shortest((*source.lx)[i]);
        if (request_.options.view) {
            const ProbeLuminance& nt = first.luminance[i];
            row += fmt::format(",{},{},{}", shortest(nt.diffuse.value), shortest(nt.specular.value),
                               shortest(nt.total().value));
            if (estimated()) row += ',' + shortest(nt.error_estimate.value);
        }
        if (!stretch.horizontal_lx.empty())
            row += fmt::format(",{},{}", shortest(stretch.horizontal_lx[i]), shortest(index_of(stretch, i)));
        if (!stretch.glare.empty()) {
            const GlareRating& rating = stretch.glare[i];
            row += fmt::format(",{},{}", rating.ugr ? shortest(*rating.ugr) : std::string(),
                               shortest(rating.background.value));
        }
    }
    console_.print(row + '\n');
}

void ProbeReport::text_lines(const ProbeStretch& stretch, std::size_t i) {
    const std::string position = position_text(stretch.receivers[i].position);
    const ProbeResult& result = stretch.by_method.front();
    const double lx = result.illuminance_lx[i];
    if (request_.compare) {
        const double truth = compared(result, i);
        std::string line = fmt::format("{:<24}{:>{}}", position, rounded(truth), column_width(request_, 0));
        for (std::size_t m = 1; m < request_.methods.size(); ++m) {
            const double other = compared(stretch.by_method[m], i);
            line += fmt::format("{:>{}}{:>12}", rounded(other), column_width(request_, m),
                                percent(relative_error(other, truth)));
        }
        console_.print(line + '\n');
        return;
    }
    if (stretch.horizontal_lx.empty())
        console_.print(fmt::format("{:<24}{:>14} lx", position, rounded(lx)));
    else
        console_.print(fmt::format("{:<24}{:>14} ({} lx over {} lx)", position, rounded(index_of(stretch, i)),
                                   rounded(lx), rounded(stretch.horizontal_lx[i])));
    if (estimated()) console_.print(fmt::format(" ±{}", rounded(result.illuminance_error_lx[i], 2)));
    std::string parts;
    for (const Source& source : sources_of(request_, stretch))
        parts += fmt::format("{}{} {}", parts.empty() ? " (" : ", ", source.name, rounded((*source.lx)[i]));
    if (!parts.empty()) console_.print(parts + ")");
    if (!result.luminance.empty()) {
        console_.print(luminance_text(result.luminance[i]));
        if (estimated()) console_.print(fmt::format(" ±{}", rounded(result.luminance[i].error_estimate.value, 2)));
    }
    if (!stretch.glare.empty()) console_.print(glare_text(stretch.glare[i]));
    console_.print("\n");
    if (!lights_listed_too()) return;
    for (std::size_t l = 0; l < request_.lights.size(); ++l) {
        const std::size_t part = i * request_.lights.size() + l;
        console_.print(fmt::format("  {:<22}{:>14} lx", request_.lights[l].name, rounded(result.parts_lx[part])));
        if (!result.parts_nt.empty()) console_.print(luminance_text(result.parts_nt[part]));
        if (!stretch.glare.empty())
            console_.print(fmt::format(", {:.1f} % of the glare", 100.0 * share_of_glare(stretch.glare[i], l)));
        console_.print("\n");
    }
}

std::string_view ProbeReport::compared_unit() const {
    if (request_.kind == IlluminanceKind::modelling) return "";
    return request_.compare && request_.options.view ? "nt" : "lx";
}

std::string ProbeReport::with_unit(std::string_view key) const {
    const std::string_view unit = compared_unit();
    return unit.empty() ? std::string(key) : fmt::format("{}_{}", key, unit);
}

Json ProbeReport::spread_json(const Spread& s) const {
    return {{with_unit("min"), s.least},
            {with_unit("mean"), s.mean},
            {with_unit("max"), s.greatest},
            {"uniformity_min_mean", s.uniformity()},
            {"uniformity_min_max", s.diversity()}};
}

Json ProbeReport::grid_json() const {
    const ReceiverGrid& grid = *request_.points.grid;
    Json json{{"columns", grid.columns}, {"rows", grid.rows}};
    json["points"] = values_.front().size();
    json["spacing_m"] = Json::array({glm::length(grid.u) / static_cast<double>(grid.columns),
                                     glm::length(grid.v) / static_cast<double>(grid.rows)});
    json.update(spread_json(spread(values_.front())));
    for (const Percentile& each : percentiles)
        json[with_unit(each.key)] = percentile(values_.front(), each.percent);
    if (request_.indirect && request_.kind != IlluminanceKind::modelling)
        json["mean_indirect_lx"] = spread(indirect_lx_).mean;
    if (!request_.compare) return json;
    Json methods = Json::array();
    for (std::size_t m = 0; m < request_.methods.size(); ++m) {
        Json of_method{{"method", to_text(request_.methods[m])}};
        of_method.update(spread_json(spread(values_[m])));
        of_method[fmt::format("max_error_{}", compared_unit())] = worst(m).error;
        methods.push_back(std::move(of_method));
    }
    json["methods"] = std::move(methods);
    return json;
}

ProbeReport::Worst ProbeReport::worst(std::size_t m) const {
    Worst found;
    for (std::size_t i = 0; i < values_[m].size(); ++i) {
        const double error = values_[m][i] - values_.front()[i];
        if (std::abs(error) > std::abs(found.error)) found = {error, i};
    }
    return found;
}

void ProbeReport::summary_text() {
    const auto& grid = request_.points.grid;
    const std::size_t count = request_.points.receivers.size();
    if (grid && count == grid->columns * grid->rows)
        console_.print(fmt::format("{} x {} points", grid->columns, grid->rows));
    else
        console_.print(fmt::format("{} points", count));
    if (request_.kind != IlluminanceKind::planar)
        console_.print(fmt::format(", {}{}", name_of(request_.kind),
                                   request_.kind == IlluminanceKind::modelling ? " index" : " illuminance"));
    console_.print("\n");
    struct Line {
        const char* name;
        double (*of)(const Spread&);
    };
    constexpr std::array lines{Line{"min", [](const Spread& s) { return s.least; }},
                               Line{"mean", [](const Spread& s) { return s.mean; }},
                               Line{"max", [](const Spread& s) { return s.greatest; }},
                               Line{"min/mean", [](const Spread& s) { return s.uniformity(); }},
                               Line{"min/max", [](const Spread& s) { return s.diversity(); }}};
    std::vector<Spread> spreads;
    for (const std::vector<double>& values : values_)
        spreads.push_back(spread(values));
    if (request_.compare) {
        console_.print(fmt::format("{:<10}", ""));
        for (std::size_t m = 0; m < request_.methods.size(); ++m)
            console_.print(fmt::format("{:>{}}", method_column(request_, m), column_width(request_, m)));
        console_.print("\n");
    }
    for (std::size_t line = 0; line < lines.size(); ++line) {
        console_.print(fmt::format("{:<10}", lines[line].name));
        for (std::size_t m = 0; m < spreads.size(); ++m)
            console_.print(fmt::format("{:>{}}", rounded(lines[line].of(spreads[m])),
                                       request_.compare ? column_width(request_, m) : 14));
        const bool has_unit = line < 3 && !request_.compare && !compared_unit().empty();
        console_.print(has_unit ? fmt::format(" {}\n", compared_unit()) : std::string("\n"));
    }
    if (grid && !request_.compare)
        for (const Percentile& each : percentiles)
            console_.print(fmt::format("{:<10}{:>14}{}{}\n", each.name,
                                       rounded(percentile(values_.front(), each.percent)),
                                       compared_unit().empty() ? "" : " ", compared_unit()));
    if (request_.indirect && request_.kind != IlluminanceKind::modelling)
        console_.print(fmt::format("indirect  {:>14} lx of the mean\n", rounded(spread(indirect_lx_).mean)));
    for (std::size_t m = 1; m < request_.methods.size(); ++m) {
        const Worst w = worst(m);
        console_.print(fmt::format("{} is off by up to {} {} ({}), at {}\n", to_text(request_.methods[m]),
                                   rounded(w.error), compared_unit(),
                                   percent(relative_error(values_[m][w.point], values_.front()[w.point])),
                                   position_text(request_.points.receivers[w.point].position)));
    }
}

Result<void> ProbeReport::draw(Diagnostics& diagnostics) const {
    const GridDrawing& drawing = *request_.drawing;
    const ReceiverGrid& grid = *request_.points.grid;
    const Spread all = spread(values_.front());
    GridPlot plot;
    plot.columns = grid.columns;
    plot.rows = grid.rows;
    plot.width_m = glm::length(grid.u);
    plot.height_m = glm::length(grid.v);
    const std::optional<glm::dvec3> along = unit_vector(grid.u);
    const std::optional<glm::dvec3> across = unit_vector(grid.v);
    if (!along || !across)
        return fail("USE0106", "a grid with an edge of length 0 has no plan", "give --grid two edges");
    // In plan where it lies along X and Y, else along its own edges.
    const bool is_plan = along->x == 1.0 && across->y == 1.0;
    plot.x_name = is_plan ? "x [m]" : "along U [m]";
    plot.y_name = is_plan ? "y [m]" : "along V [m]";
    const auto in_plan = [&](const glm::dvec3& point) {
        const glm::dvec3 from = is_plan ? point : point - grid.corner;
        return PagePoint{glm::dot(from, *along), glm::dot(from, *across)};
    };
    const PagePoint corner = in_plan(grid.corner);
    plot.left_m = corner.x;
    plot.low_m = corner.y;
    plot.values.assign(grid.columns * grid.rows, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < values_.front().size(); ++i)
        plot.values[grid.cell_of(i)] = values_.front()[i];
    for (const glm::dvec3& point : grid.outline)
        plot.outline.push_back(in_plan(point));
    if (is_plan)
        for (const Light& light : request_.lights)
            if (!std::holds_alternative<SunShape>(light.shape)) plot.marks.push_back(in_plan(light.frame.origin));
    plot.unit = compared_unit();
    plot.title = drawing.title;
    if (plot.title.empty())
        plot.title = request_.kind == IlluminanceKind::planar ? "illuminance"
                     : request_.kind == IlluminanceKind::modelling
                         ? "modelling index"
                         : fmt::format("{} illuminance", name_of(request_.kind));
    const std::string unit = plot.unit.empty() ? std::string() : " " + plot.unit;
    plot.facts =
        fmt::format("min {}{}, mean {}{}, max {}{}, min/mean {}", amount_text(all.least), unit, amount_text(all.mean),
                    unit, amount_text(all.greatest), unit, rounded(all.uniformity(), 2));
    if (is_plan) plot.facts = fmt::format("at {} m: {}", rounded(grid.corner.z, 4), plot.facts);
    return write_grid_drawing(drawing, std::move(plot), diagnostics);
}

} // namespace gonio::cli
