#include <gonio/base/codes/result.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/light/light_color.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

namespace gonio {

namespace {

Unexpected no_color(std::string_view text) {
    return fail("USE0105", fmt::format("'{}' is not a colour", text),
                "write 2700K, d65, #ffd9a0, rgb(1,0.8,0.6) or an illuminant of 'gonio list illuminants'");
}

Result<Uv> color_of_spectrum(const Spectrum& spectrum) {
    Result<SpectrumColor> color = color_of(spectrum);
    if (!color) return pass_on(color);
    return color->uv;
}

// Chromaticity of a temperature, an illuminant or a spectrum.
Result<Uv> chromaticity(std::string_view text, FileScope* files) {
    if (text.starts_with(spectrum_prefix)) {
        Result<Spectrum> spectrum = read_spectrum(std::string(text.substr(spectrum_prefix.size())), files);
        if (!spectrum) return pass_on(spectrum);
        return color_of_spectrum(*spectrum);
    }
    if (const std::optional<Spectrum> illuminant = find_illuminant(text)) return color_of_spectrum(*illuminant);
    const Result<Amount> amount = parse_amount(text.substr(0, text.find('/')));
    if (!amount || amount->unit->dimension != Dimension::temperature) {
        const std::string_view guess = nearest(text, illuminant_names());
        if (guess.empty()) return no_color(text);
        return fail("USE0105", fmt::format("'{}' is not a colour", text), fmt::format("did you mean '{}'?", guess));
    }
    Result<Cct> cct = parse_cct(text);
    if (!cct) return pass_on(cct);
    return uv_of(*cct);
}

glm::dvec3 in_working_space(std::string_view text, Uv at, Diagnostics* diagnostics) {
    const SpaceColor color = to_space(at, *find_rgb_space("rec709"), Gamut::clip);
    if (!color.in_gamut && diagnostics != nullptr)
        diagnostics->push_back(result_diagnostic(
            "RES0104",
            fmt::format(
                "'{}' lies outside Rec.709, the space of lights: clipped to it by {} in u'v' at the same luminance",
                text, rounded(color.delta_uv_prime, 2))));
    return color.rgb;
}

} // namespace

Result<glm::dvec3> parse_rgb(std::string_view text) {
    if (const std::optional<double> grey = parse_number(text); grey && *grey >= 0.0) return glm::dvec3(*grey);
    std::string_view rest = text;
    if (!rest.starts_with("rgb(") || !rest.ends_with(")")) return no_color(text);
    rest.remove_prefix(4);
    rest.remove_suffix(1);
    glm::dvec3 rgb(0.0);
    for (int channel = 0; channel < 3; ++channel) {
        const std::size_t comma = rest.find(',');
        if ((comma == std::string_view::npos) != (channel == 2)) return no_color(text);
        const std::optional<double> value = parse_number(rest.substr(0, comma));
        if (!value || *value < 0.0) return no_color(text);
        rgb[channel] = *value;
        if (channel < 2) rest.remove_prefix(comma + 1);
    }
    return rgb;
}

Result<glm::dvec3> light_color_of(const Spectrum& spectrum, Diagnostics* diagnostics) {
    Result<Uv> at = color_of_spectrum(spectrum);
    if (!at) return pass_on(at);
    return in_working_space(spectrum.name, *at, diagnostics);
}

Result<glm::dvec3> parse_light_color(std::string_view text, Diagnostics* diagnostics, FileScope* files) {
    if (text == "d65" || text == "D65") return glm::dvec3(1.0);
    glm::dvec3 rgb(0.0);
    if (text.starts_with("#")) {
        unsigned value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data() + 1, end, value, 16);
        if (text.size() != 7 || error != std::errc() || stop != end) return no_color(text);
        for (int channel = 0; channel < 3; ++channel)
            rgb[channel] = decode_srgb(((value >> (16 - 8 * channel)) & 0xffU) / 255.0);
    } else if (text.starts_with("rgb(")) {
        Result<glm::dvec3> parsed = parse_rgb(text);
        if (!parsed) return pass_on(parsed);
        rgb = *parsed;
    } else {
        Result<Uv> at = chromaticity(text, files);
        if (!at) return pass_on(at);
        return in_working_space(text, *at, diagnostics);
    }
    // Relative to the greatest channel, so that neither huge nor tiny numbers leave the range.
    const double greatest = std::max({rgb.x, rgb.y, rgb.z});
    if (greatest > 0.0) rgb = glm::dvec3(rgb.x / greatest, rgb.y / greatest, rgb.z / greatest);
    const double y = glm::dot(rgb, rec709_luminance);
    if (!(y > 0.0)) return fail("USE0106", fmt::format("'{}' is black; the colour of a light must not be black", text));
    return rgb / y;
}

} // namespace gonio
