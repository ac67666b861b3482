#include "spectra_text.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/color/spectrum.hpp>

#include "cct/quality_report.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>
#include <variant>

namespace gonio::cli {

namespace {

std::string row(std::string_view name, std::optional<double> computed, std::optional<double> stated, int decimals) {
    return fmt::format("  {:<15}{:>10}{:>10}\n", name,
                       computed ? fmt::format("{:.{}f}", *computed, decimals) : std::string("-"),
                       stated ? rounded(*stated, 6) : std::string("-"));
}

} // namespace

Result<std::vector<ProfileSpectrum>> profile_spectra(const Profile& profile) {
    std::vector<ProfileSpectrum> found;
    const auto* const document = std::get_if<Tm33File>(&profile.file);
    if (document == nullptr) return found;
    Result<std::vector<Spectrum>> spectra = spectra_of(profile);
    if (!spectra) return pass_on(spectra);
    auto spectrum = spectra->begin();
    for (std::size_t e = 0; e < document->emitters.size(); ++e) {
        const Tm33Emitter& emitter = document->emitters[e];
        for (std::size_t i = 0; i < emitter.spectra.size(); ++i, ++spectrum) {
            Result<LightQuality> quality = light_quality(*spectrum);
            if (!quality) return pass_on(quality);
            ProfileSpectrum each;
            each.emitter = e;
            each.stated.cct_k = emitter.cct_k;
            each.stated.duv = emitter.duv;
            each.stated.cri_ra = emitter.cri_ra;
            each.stated.cri_r9 = emitter.cri_r9;
            each.stated.tm30_rf = emitter.tm30_rf;
            each.stated.tm30_rg = emitter.tm30_rg;
            each.quality = std::move(*quality);
            each.quality.diagnostics.insert(each.quality.diagnostics.begin(), spectrum->diagnostics.begin(),
                                            spectrum->diagnostics.end());
            found.push_back(std::move(each));
        }
    }
    return found;
}

std::string spectra_text(const std::vector<ProfileSpectrum>& spectra) {
    std::string text;
    for (const ProfileSpectrum& each : spectra) {
        const LightQuality& q = each.quality;
        const Tm33Emitter& stated = each.stated;
        const auto of = [](const auto& part, auto value) {
            return part ? std::optional<double>(value(*part)) : std::nullopt;
        };
        text += fmt::format("\n  quality of light, emitter {} (CIE 13.3, TM-30, CIE S 026)\n", each.emitter + 1);
        text += fmt::format("  {:<15}{:>10}{:>10}\n", "", "spectrum", "stated");
        text += row("CCT K", of(q.cct, [](const Cct& cct) { return cct.temperature.value; }), stated.cct_k, 0);
        text += row("Duv", of(q.cct, [](const Cct& cct) { return cct.duv; }), stated.duv, 4);
        text += row("Ra", of(q.rendering, [](const ColorRendering& r) { return r.ra; }), stated.cri_ra, 1);
        text += row("R9", of(q.rendering, [](const ColorRendering& r) { return r.r[8]; }), stated.cri_r9, 1);
        text += row("Rf", of(q.fidelity, [](const ColorFidelity& f) { return f.rf; }), stated.tm30_rf, 1);
        text += row("Rg", of(q.fidelity, [](const ColorFidelity& f) { return f.rg; }), stated.tm30_rg, 1);
        text += row("melanopic DER", q.alpha_opic.melanopic_der(), std::nullopt, 3);
    }
    return text;
}

Json spectra_json(const std::vector<ProfileSpectrum>& spectra) {
    Json list = Json::array();
    for (const ProfileSpectrum& each : spectra) {
        Json json{{"emitter", each.emitter + 1}};
        json["cct_K"] = each.quality.cct ? Json(each.quality.cct->temperature.value) : Json(nullptr);
        json["duv"] = each.quality.cct ? Json(each.quality.cct->duv) : Json(nullptr);
        json["quality"] = quality_json(each.quality);
        json["stated"] = {
            {"cct_K", number_or_null(each.stated.cct_k)},     {"duv", number_or_null(each.stated.duv)},
            {"cri_ra", number_or_null(each.stated.cri_ra)},   {"cri_r9", number_or_null(each.stated.cri_r9)},
            {"tm30_rf", number_or_null(each.stated.tm30_rf)}, {"tm30_rg", number_or_null(each.stated.tm30_rg)}};
        json["diagnostics"] = diagnostics_json(each.quality.diagnostics);
        list.push_back(std::move(json));
    }
    return list;
}

} // namespace gonio::cli
