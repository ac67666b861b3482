#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/measured_light.hpp>
#include <gonio/base/charconv.hpp>
#include <gonio/base/codes/result.hpp>
#include <gonio/base/path.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/greatest_difference.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/to_profile.hpp>
#include <gonio/web/transform.hpp>

#include <fmt/format.h>

#include <utility>

namespace gonio {

namespace {

bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

struct Colored {
    glm::dvec3 rgb{1.0};
    std::string text;
};

Result<Colored> color_of(const MeasuredLightSource& source, const MeasuredLightOptions& options,
                         Diagnostics& diagnostics) {
    Colored colored;
    colored.text = options.color;
    if (colored.text.empty() && !source.spectra.empty()) {
        Result<glm::dvec3> rgb = light_color_of(source.spectra.front(), &diagnostics);
        if (!rgb) return pass_on(rgb);
        if (source.spectra.size() > 1)
            diagnostics.push_back(result_diagnostic(
                "RES0105",
                fmt::format("the profile has {} spectra; the light has the colour of the first", source.spectra.size()),
                "set one colour, for example --color 3000K", source.file));
        return Colored{*rgb, "spectrum"};
    }
    if (colored.text.empty()) {
        const std::string_view said = keyword_text(source.header, "_CCT");
        if (said.empty()) return colored;
        const std::optional<double> kelvin = color_temperature_of(said);
        if (!kelvin) {
            diagnostics.push_back(result_diagnostic(
                "RES0106", fmt::format("the colour temperature '{}' cannot be read: the light is white", said),
                "set one, for example --color 3000K", source.file));
            return colored;
        }
        colored.text = fmt::format("{}K", *kelvin);
    }
    Result<glm::dvec3> rgb = parse_light_color(colored.text, &diagnostics);
    if (!rgb) return pass_on(rgb);
    colored.rgb = *rgb;
    return colored;
}

} // namespace

std::string asset_name(std::string_view file) {
    std::string name;
    for (const char c : without_extension(file_name(file)))
        name += is_letter_or_digit(c) || c == '-' ? c : '_';
    if (name.empty() || name == "-") name = "light";
    return name;
}

std::optional<double> color_temperature_of(std::string_view text) {
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = from_chars(text.data(), end, value);
    if (error != std::errc() || (stop != end && is_letter_or_digit(*stop) && *stop != 'K' && *stop != 'k'))
        return std::nullopt;
    constexpr double lowest = 1000.0;
    constexpr double highest = 40000.0;
    if (value >= lowest && value <= highest) return value;
    // In "830", the 8 is the tens of the colour rendering index and the 30 the hundreds of kelvins.
    const bool is_code = stop - text.data() == 3 && value >= 600.0 && value <= 999.0;
    const double hundreds = is_code ? static_cast<double>(static_cast<int>(value) % 100) : 0.0;
    return hundreds >= 18.0 ? std::optional(100.0 * hundreds) : std::nullopt;
}

Result<MeasuredLight> measured_light(const MeasuredLightSource& source, const MeasuredLightOptions& options,
                                     Diagnostics& diagnostics) {
    if (!(peak(source.web).intensity.value > 0.0))
        return fail(Failure::unsupported, "the profile is dark: an engine cannot scale it to any flux", {},
                    source.file);
    const double turn_deg = to_degrees(options.rotation);
    Web wanted = turn_deg == 0.0 ? source.web : rotated(source.web, turn_deg).web;
    if (options.flux) {
        Result<Web> scaled = scaled_to(wanted, *options.flux);
        if (!scaled) return pass_on(scaled);
        wanted = std::move(*scaled);
    }
    ProfileHeader header = source.header;
    if (turn_deg != 0.0) header.azimuth = AzimuthConvention::as_written;
    Result<MadeProfile> made = to_profile(wanted, header, ProfileTarget::portable);
    if (!made) return pass_on(made);
    std::string bytes = write_profile(made->profile, ProfileTarget::portable);
    Result<Profile> again = read_profile(bytes, source.file);
    Result<ResolvedWeb> delivered = again ? resolve_web(*again) : Result<ResolvedWeb>(pass_on(again));
    if (!delivered) return fail(Failure::internal, "the portable profile cannot be read back", {}, source.file);
    diagnostics.insert(diagnostics.end(), made->diagnostics.begin(), made->diagnostics.end());
    Result<Colored> color = color_of(source, options, diagnostics);
    if (!color) return pass_on(color);
    const Lumens lumens = flux(delivered->web);
    const Candelas greatest = peak(delivered->web).intensity;
    const WebDifference error = web_detail::greatest_difference(wanted, delivered->web);
    return MeasuredLight{.name = asset_name(source.file),
                         .portable_ies = std::move(bytes),
                         .web = std::move(delivered->web),
                         .flux = lumens,
                         .peak = greatest,
                         .color = color->rgb,
                         .color_text = std::move(color->text),
                         .source_file = source.file,
                         .source_sha256 = sha256(source.bytes),
                         .header = source.header,
                         .max_error = error.greatest};
}

} // namespace gonio
