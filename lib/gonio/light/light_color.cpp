#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <charconv>
#include <cmath>

namespace gonio {

namespace {

// IEC 61966-2-1.
double decode_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Unexpected no_color(std::string_view text) {
    return fail(Failure::usage, fmt::format("'{}' is no colour", text), "write d65, #ffd9a0 or rgb(1,0.8,0.6)");
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

Result<glm::dvec3> parse_light_color(std::string_view text) {
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
        const Result<Amount> amount = parse_amount(text);
        if (amount && amount->unit->dimension == Dimension::temperature)
            return fail(Failure::unsupported, "colour temperatures are not computed yet",
                        "give the colour as #ffd9a0 or rgb(1,0.8,0.6)");
        return no_color(text);
    }
    const double y = glm::dot(rgb, rec709_luminance);
    if (!(y > 0.0)) return fail(Failure::usage, fmt::format("'{}' is black: a light has a colour to be seen by", text));
    return rgb / y;
}

} // namespace gonio
