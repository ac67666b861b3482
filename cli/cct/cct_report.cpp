#include "cct_report.hpp"

#include <gonio/base/unit_text.hpp>

#include "quality_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gonio::cli {

namespace {

std::string signed_duv(double duv) {
    return std::abs(duv) < 5e-7 ? "0" : fmt::format("{:+.5f}", duv);
}

std::string kelvin(double value) {
    return std::isfinite(value) ? rounded(value, 6) : "-";
}

Json vector_json(const glm::dvec3& v) {
    return Json::array({v.x, v.y, v.z});
}

// Cells padded to the width of the widest in their column, except in the last column.
using Rows = std::vector<std::vector<std::string>>;
std::string aligned(const Rows& rows) {
    std::vector<std::size_t> width;
    const auto letters = [](const std::string& text) { // of UTF-8
        return static_cast<std::size_t>(std::count_if(
            text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
    };
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i == width.size()) width.push_back(0);
            width[i] = std::max(width[i], letters(row[i]));
        }
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            text += row[i];
            if (i + 1 < row.size()) text.append(width[i] - letters(row[i]) + 2, ' ');
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    return text;
}

std::string versus_text(const CctAnswer& answer) {
    if (answer.versus.empty()) return {};
    Rows rows;
    const bool forward = answer.versus.front().of_color.has_value();
    if (forward)
        rows.push_back({"  method", "Δu'v'", "cct K", "error K", "Duv", "luminance", "formula"});
    else
        rows.push_back({"  method", "cct K", "error K", "formula"});
    const double truth = answer.cct->temperature.value;
    for (const CctVersus& versus : answer.versus) {
        const std::string error = std::isfinite(versus.cct_k) ? fmt::format("{:+.3g}", versus.cct_k - truth) : "-";
        std::string says(versus.source);
        if (!versus.in_range) says += "; outside its range";
        if (forward)
            rows.push_back({fmt::format("  {}", versus.method), fmt::format("{:.1e}", versus.of_color->delta_uv_prime),
                            kelvin(versus.cct_k), error,
                            std::isfinite(versus.duv) ? fmt::format("{:+.1e}", versus.duv) : "-",
                            rounded(versus.of_color->luminance, 4), says});
        else
            rows.push_back({fmt::format("  {}", versus.method), kelvin(versus.cct_k), error, says});
    }
    return aligned(rows);
}

Rows::value_type table_row(const CctAnswer& answer) {
    const Xy xy = to_xy(answer.at);
    const SpaceColor& color = answer.color;
    Rows::value_type row{answer.input,
                         answer.cct ? rounded(answer.cct->temperature.value, 7) : "-",
                         answer.cct ? signed_duv(answer.cct->duv) : "-",
                         fixed(xy.x, 6),
                         fixed(xy.y, 6),
                         fixed(color.rgb.x, 6),
                         fixed(color.rgb.y, 6),
                         fixed(color.rgb.z, 6)};
    if (answer.spectrum)
        row.push_back(fmt::format("{} lm/W, {}", rounded(answer.spectrum->efficacy_lm_per_w, 4),
                                  gonio::to_text(answer.spectrum->band)));
    else
        row.push_back(color.in_gamut ? "" : "outside");
    return row;
}

std::string block(const CctAnswer& answer, const CctRequest& request) {
    const Xy xy = to_xy(answer.at);
    const UvPrime uv = to_uv_prime(answer.at);
    const glm::dvec3 xyz = to_xyz(answer.at);
    const SpaceColor& color = answer.color;
    std::string text;
    const auto line = [&](std::string_view name, const std::string& value) {
        text += fmt::format("  {:<11} {}\n", name, value);
    };
    text += answer.input + '\n';
    if (answer.cct) {
        // A given temperature is printed as it was given, a computed one with its significant digits.
        const bool given = answer.kind == CctKind::temperature;
        line("cct", fmt::format("{} K", given ? rounded(answer.cct->temperature.value, 12)
                                              : fixed(answer.cct->temperature.value, 2)));
        const std::string duv = signed_duv(answer.cct->duv);
        line("Duv", duv == "0" ? duv : fmt::format("{} (tint {}@dng)", duv, fixed(3000.0 * answer.cct->duv, 2)));
    }
    if (answer.locus != "planckian") line("locus", std::string(answer.locus));
    line("xy", fmt::format("{} {}", fixed(xy.x, 6), fixed(xy.y, 6)));
    line("u'v'", fmt::format("{} {}", fixed(uv.u, 6), fixed(uv.v, 6)));
    line("XYZ", fmt::format("{} {} {}", fixed(xyz.x, 6), fixed(xyz.y, 6), fixed(xyz.z, 6)));
    line(request.space.name,
         fmt::format("{} {} {}", fixed(color.rgb.x, 6), fixed(color.rgb.y, 6), fixed(color.rgb.z, 6)));
    line("luminance", rounded(color.luminance, 4));
    if (!color.in_gamut)
        line("gamut", request.gamut == Gamut::clip
                          ? fmt::format("outside {}: clipped by {} in u'v'", request.space.name,
                                        rounded(color.delta_uv_prime, 2))
                          : fmt::format("outside {}: a component is negative", request.space.name));
    if (answer.spectrum)
        line("efficacy", fmt::format("{} lm/W of {}", rounded(answer.spectrum->efficacy_lm_per_w, 5),
                                     gonio::to_text(answer.spectrum->band)));
    if (answer.blackbody)
        line("black body",
             fmt::format("{} lm/W in total, {} within 360–830 nm, {} nt", rounded(answer.blackbody->total_lm_per_w, 4),
                         rounded(answer.blackbody->band_lm_per_w, 4), rounded(answer.blackbody_luminance->value, 4)));
    if (answer.quality) text += quality_text(*answer.quality, request.illuminance);
    return text + versus_text(answer);
}

Rows::value_type quality_row(const CctAnswer& answer, std::optional<Lux> illuminance) {
    const std::optional<ColorRendering>& rendering = answer.quality->rendering;
    const std::optional<ColorFidelity>& fidelity = answer.quality->fidelity;
    const auto tenths = [](bool known, double value) { return known ? fixed(value, 1) : std::string("-"); };
    Rows::value_type row{answer.input,
                         answer.cct ? rounded(answer.cct->temperature.value, 7) : "-",
                         answer.cct ? signed_duv(answer.cct->duv) : "-",
                         tenths(rendering.has_value(), rendering ? rendering->ra : 0.0),
                         tenths(rendering.has_value(), rendering ? rendering->r[8] : 0.0),
                         tenths(fidelity.has_value(), fidelity ? fidelity->rf : 0.0),
                         tenths(fidelity.has_value(), fidelity ? fidelity->rg : 0.0),
                         fixed(answer.quality->alpha_opic.melanopic_der(), 3)};
    if (illuminance) row.push_back(rounded(illuminance->value * answer.quality->alpha_opic.melanopic_der(), 4));
    return row;
}

} // namespace

std::string to_text(std::span<const CctAnswer> answers, const CctRequest& request) {
    if (answers.size() == 1) return block(answers.front(), request);
    Rows rows;
    if (request.quality) {
        rows.push_back({"input", "cct K", "Duv", "Ra", "R9", "Rf", "Rg", "melanopic DER"});
        if (request.illuminance) rows.back().emplace_back("EDI lx");
        for (const CctAnswer& answer : answers)
            rows.push_back(quality_row(answer, request.illuminance));
        return aligned(rows);
    }
    rows.push_back({"input", "cct K", "Duv", "x", "y", "r", "g", "b", request.space.name});
    std::string text;
    for (const CctAnswer& answer : answers) {
        rows.push_back(table_row(answer));
        if (answer.versus.empty()) continue;
        text += aligned(rows) + versus_text(answer);
        rows.resize(1);
    }
    return answers.front().versus.empty() ? aligned(rows) : text;
}

Json to_json(const CctAnswer& answer, const CctRequest& request) {
    const Xy xy = to_xy(answer.at);
    const UvPrime uv = to_uv_prime(answer.at);
    Json json{{"schema", "gonio.cct/1"}, {"input", answer.input}};
    json["cct_K"] = answer.cct ? Json(answer.cct->temperature.value) : Json(nullptr);
    json["duv"] = answer.cct ? Json(answer.cct->duv) : Json(nullptr);
    json["locus"] = answer.locus;
    json["xy"] = Json::array({xy.x, xy.y});
    json["uv_prime"] = Json::array({uv.u, uv.v});
    json["xyz"] = vector_json(to_xyz(answer.at));
    json["space"] = request.space.name;
    json["rgb"] = vector_json(answer.color.rgb);
    json["luminance"] = answer.color.luminance;
    json["luminance_weights"] = vector_json(luminance_row(request.space));
    json["in_gamut"] = answer.color.in_gamut;
    json["gamut_delta_uv_prime"] = answer.color.delta_uv_prime;
    if (answer.spectrum) {
        json["efficacy_lm_per_W"] = answer.spectrum->efficacy_lm_per_w;
        json["efficacy_band_nm"] = Json::array({answer.spectrum->band.first_nm, answer.spectrum->band.last_nm});
    }
    if (answer.blackbody)
        json["blackbody"] = {{"efficacy_lm_per_W", answer.blackbody->total_lm_per_w},
                             {"efficacy_360_830nm_lm_per_W", answer.blackbody->band_lm_per_w},
                             {"luminance_nt", answer.blackbody_luminance->value}};
    if (answer.quality) json["quality"] = quality_json(*answer.quality, request.illuminance);
    if (!answer.versus.empty()) {
        Json list = Json::array();
        for (const CctVersus& versus : answer.versus) {
            Json row{{"method", versus.method}, {"in_range", versus.in_range}, {"cct_K", number_or_null(versus.cct_k)}};
            if (versus.of_color) {
                row["duv"] = number_or_null(versus.duv);
                row["delta_uv_prime"] = number_or_null(versus.of_color->delta_uv_prime);
                row["luminance"] = number_or_null(versus.of_color->luminance);
            }
            list.push_back(std::move(row));
        }
        json["versus"] = std::move(list);
    }
    json["diagnostics"] = diagnostics_json(answer.diagnostics);
    return json;
}

} // namespace gonio::cli
