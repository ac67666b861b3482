#include "quality_report.hpp"

#include <gonio/base/unit_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

namespace gonio::cli {

namespace {

std::string line(std::string_view name, const std::string& value) {
    return fmt::format("  {:<11} {}\n", name, value);
}

std::string_view reference_key(ReferenceIlluminant kind) {
    switch (kind) {
    case ReferenceIlluminant::planckian:
        return "planckian";
    case ReferenceIlluminant::blend:
        return "blend";
    case ReferenceIlluminant::daylight:
        break;
    }
    return "daylight";
}

std::string rendering_text(const ColorRendering& rendering) {
    const auto row = [&](std::size_t first, std::size_t last) {
        std::string cells;
        for (std::size_t i = first; i < last; ++i)
            cells += fmt::format("{:>7}", fixed(rendering.r[i], 1));
        return cells.substr(std::min<std::size_t>(cells.find_first_not_of(' '), 2));
    };
    return line("CRI", fmt::format("Ra {}, R9 {} (CIE 13.3, reference: {})", fixed(rendering.ra, 1),
                                   fixed(rendering.r[8], 1), to_text(rendering.reference))) +
           line("R1–R8", row(0, 8)) + line("R9–R15", row(8, 15));
}

std::string fidelity_text(const ColorFidelity& fidelity) {
    std::string text = line("TM-30", fmt::format("Rf {}, Rg {} (CIE 224, reference: {})", fixed(fidelity.rf, 1),
                                                 fixed(fidelity.rg, 1), to_text(fidelity.reference)));
    text += fmt::format("  {:<14}{:>8}{:>9}{:>8}\n", "hue bin", "Rf,h", "Rcs,h", "Rhs,h");
    for (std::size_t i = 0; i < hue_bin_count; ++i) {
        const HueBin& bin = fidelity.bins[i];
        const bool some = bin.samples > 0;
        const double first_deg = 22.5 * static_cast<double>(i);
        text += fmt::format("  {:<2} {:<11}{:>8}{:>9}{:>8}\n", i + 1,
                            fmt::format("{}–{}°", rounded(first_deg), rounded(first_deg + 22.5)),
                            some ? fixed(bin.fidelity, 1) : "-", some ? fixed(100.0 * bin.chroma_shift, 1) + "%" : "-",
                            some ? fixed(bin.hue_shift, 2) : "-");
    }
    return text;
}

std::string alpha_opic_text(const AlphaOpic& alpha_opic, Lux illuminance) {
    std::string text =
        line("melanopic",
             fmt::format("DER {}, EDI {} lx at {} lx (CIE S 026)", fixed(alpha_opic.melanopic_der(), 3),
                         rounded(illuminance.value * alpha_opic.melanopic_der(), 4), rounded(illuminance.value, 6)));
    text += fmt::format("  {:<12}{:>8}{:>8}{:>9}\n", "receptor", "mW/lm", "DER", "EDI lx");
    for (const ReceptorName& receptor : receptor_names()) {
        const auto i = static_cast<std::size_t>(receptor.receptor);
        text += fmt::format("  {:<12}{:>8}{:>8}{:>9}\n", receptor.says, fixed(alpha_opic.efficacy_mw_per_lm[i], 4),
                            fixed(alpha_opic.der[i], 3), rounded(illuminance.value * alpha_opic.der[i], 4));
    }
    return text;
}

template<std::size_t n>
Json numbers_json(const std::array<double, n>& values) {
    Json list = Json::array();
    for (const double value : values)
        list.push_back(number_or_null(value));
    return list;
}

Json point_json(HuePoint point) {
    return Json::array({number_or_null(point.a), number_or_null(point.b)});
}

} // namespace

std::string fixed(double value, int decimals) {
    const double scale = std::pow(10.0, decimals);
    if (std::fabs(value) * scale < 0.5) value = 0.0;
    return fmt::format("{:.{}f}", value, decimals);
}

std::string quality_text(const LightQuality& quality, std::optional<Lux> illuminance) {
    std::string text;
    if (quality.rendering) text += rendering_text(*quality.rendering);
    if (quality.fidelity) text += fidelity_text(*quality.fidelity);
    return text + alpha_opic_text(quality.alpha_opic, illuminance.value_or(Lux(100.0)));
}

Json quality_json(const LightQuality& quality, std::optional<Lux> illuminance) {
    Json json{{"cri", nullptr}, {"tm30", nullptr}};
    if (const std::optional<ColorRendering>& rendering = quality.rendering)
        json["cri"] = {{"ra", rendering->ra},
                       {"r", numbers_json(rendering->r)},
                       {"reference", reference_key(rendering->reference)},
                       {"reference_duv", rendering->reference_duv}};
    if (const std::optional<ColorFidelity>& fidelity = quality.fidelity) {
        Json bins = Json::array();
        for (const HueBin& bin : fidelity->bins)
            bins.push_back({{"rf", number_or_null(bin.fidelity)},
                            {"chroma_shift", number_or_null(bin.chroma_shift)},
                            {"hue_shift", number_or_null(bin.hue_shift)},
                            {"samples", bin.samples},
                            {"light_ab", point_json(bin.light)},
                            {"reference_ab", point_json(bin.reference)}});
        json["tm30"] = {{"rf", fidelity->rf},
                        {"rg", number_or_null(fidelity->rg)},
                        {"reference", reference_key(fidelity->reference)},
                        {"hue_bins", std::move(bins)},
                        {"samples", numbers_json(fidelity->samples)}};
    }
    if (illuminance) json["illuminance_lx"] = illuminance->value;
    Json receptors = Json::object();
    for (const ReceptorName& receptor : receptor_names()) {
        const auto i = static_cast<std::size_t>(receptor.receptor);
        Json row{{"efficacy_mW_per_lm", quality.alpha_opic.efficacy_mw_per_lm[i]}, {"der", quality.alpha_opic.der[i]}};
        if (illuminance) row["edi_lx"] = illuminance->value * quality.alpha_opic.der[i];
        receptors[receptor.name] = std::move(row);
    }
    json["alpha_opic"] = std::move(receptors);
    return json;
}

} // namespace gonio::cli
