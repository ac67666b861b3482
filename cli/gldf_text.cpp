#include "gldf_text.hpp"

#include <gonio/base/archive.hpp>
#include <gonio/base/unit_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace gonio::cli {

namespace {

// For terminals, and in one line.
std::string plain(std::string_view text) {
    return shown_text(text, longest_archive_name);
}

std::string line(std::string_view name, const std::string& value) {
    return fmt::format("  {:<12}{}\n", name, value);
}

std::string file_of(const Gldf& gldf, const GldfLight& light) {
    if (!light.photometry) return "no photometry";
    const std::optional<std::size_t> file = gldf.photometries[*light.photometry].file;
    return file ? plain(gldf.files[*file].entry) : "no photometric file";
}

// Its file in the archive, or null.
Json entry_of(const Gldf& gldf, const GldfLight& light) {
    if (!light.photometry) return nullptr;
    const GldfPhotometry& photometry = gldf.photometries[*light.photometry];
    if (!photometry.file) return nullptr;
    return gldf.files[*photometry.file].entry;
}

std::string light_text(const Gldf& gldf, const GldfLight& light) {
    std::string text = light.kind;
    const auto add = [&](const std::string& more) { text += ", " + more; };
    if (!light.name.empty()) add(fmt::format("'{}'", plain(light.name)));
    if (light.flux_lm)
        add(fmt::format("{} lm{}", rounded(*light.flux_lm), light.kind == "changeable" ? " of lamps" : ""));
    if (light.emergency_flux_lm) add(fmt::format("{} lm in an emergency", rounded(*light.emergency_flux_lm)));
    if (light.cct_k) add(fmt::format("{} K", rounded(*light.cct_k)));
    if (light.cri) add(fmt::format("Ra {}", rounded(*light.cri)));
    if (light.input_w) add(fmt::format("{} W", rounded(*light.input_w)));
    if (light.spectrum) add(fmt::format("spectrum {}", plain(gldf.spectra[*light.spectrum].id)));
    add(file_of(gldf, light));
    return text;
}

std::string spectrum_text(const Gldf& gldf, const GldfSpectrum& spectrum) {
    if (spectrum.file) return plain(gldf.files[*spectrum.file].entry);
    if (spectrum.wavelengths_nm.empty()) return "nothing that can be read";
    const auto [least, most] = std::minmax_element(spectrum.wavelengths_nm.begin(), spectrum.wavelengths_nm.end());
    return fmt::format("{} values, {} to {} nm", spectrum.wavelengths_nm.size(), rounded(*least), rounded(*most));
}

template<class Number>
Json or_null(const std::optional<Number>& value) {
    return value ? Json(*value) : Json(nullptr);
}

} // namespace

std::string gldf_text(const Gldf& gldf) {
    std::string text;
    text += line("product", fmt::format("{}, {}", plain(gldf.name), plain(gldf.number)));
    text += line("maker", plain(gldf.manufacturer));
    text += line("document", fmt::format("GLDF {} of {}", gldf.version, plain(gldf.generator)));
    for (const GldfVariant& variant : gldf.variants) {
        std::string emitters;
        constexpr std::size_t most = 12;
        for (std::size_t i = 0; i < std::min(variant.emitters.size(), most); ++i)
            emitters += (i == 0 ? "" : ", ") + plain(gldf.emitters[variant.emitters[i]].id);
        if (variant.emitters.size() > most) emitters += fmt::format(", {} more", variant.emitters.size() - most);
        text += line("variant", fmt::format("{}{}: {}", plain(variant.id),
                                            variant.name.empty() ? "" : fmt::format(" '{}'", plain(variant.name)),
                                            emitters.empty() ? "no emitter" : emitters));
    }
    for (const GldfEmitter& emitter : gldf.emitters)
        for (const GldfLight& light : emitter.lights)
            text += line("emitter", fmt::format("{}: {}", plain(emitter.id), light_text(gldf, light)));
    for (const GldfSpectrum& spectrum : gldf.spectra)
        text += line("spectrum", fmt::format("{}: {}", plain(spectrum.id), spectrum_text(gldf, spectrum)));
    return text;
}

Json gldf_json(const Gldf& gldf) {
    Json json{{"version", gldf.version},     {"manufacturer", gldf.manufacturer},
              {"generator", gldf.generator}, {"name", gldf.name},
              {"number", gldf.number},       {"files", Json::array()},
              {"variants", Json::array()},   {"emitters", Json::array()},
              {"spectra", Json::array()}};
    for (const GldfFile& file : gldf.files)
        json["files"].push_back(Json{{"id", file.id},
                                     {"content_type", file.content_type},
                                     {"written", file.written},
                                     {"entry", file.entry.empty() ? Json(nullptr) : Json(file.entry)}});
    for (const GldfVariant& variant : gldf.variants) {
        Json one{{"id", variant.id}, {"name", variant.name}, {"number", variant.number}, {"emitters", Json::array()}};
        for (const std::size_t emitter : variant.emitters)
            one["emitters"].push_back(gldf.emitters[emitter].id);
        json["variants"].push_back(std::move(one));
    }
    for (const GldfEmitter& emitter : gldf.emitters)
        for (const GldfLight& light : emitter.lights) {
            json["emitters"].push_back(Json{
                {"id", emitter.id},
                {"kind", light.kind},
                {"name", light.name},
                {"emergency", light.emergency},
                {"photometry", entry_of(gldf, light)},
                {"flux_lm", or_null(light.flux_lm)},
                {"emergency_flux_lm", or_null(light.emergency_flux_lm)},
                {"cct_K", or_null(light.cct_k)},
                {"cri", or_null(light.cri)},
                {"input_W", or_null(light.input_w)},
                {"spectrum", light.spectrum ? Json(gldf.spectra[*light.spectrum].id) : Json(nullptr)},
                {"rotation_deg", Json::array({light.rotation_deg.x, light.rotation_deg.y, light.rotation_deg.z})}});
        }
    for (const GldfSpectrum& spectrum : gldf.spectra)
        json["spectra"].push_back(Json{{"id", spectrum.id},
                                       {"file", spectrum.file ? Json(gldf.files[*spectrum.file].entry) : Json(nullptr)},
                                       {"wavelengths_nm", spectrum.wavelengths_nm},
                                       {"intensities", spectrum.intensities}});
    return json;
}

} // namespace gonio::cli
