#include <gonio/base/unit_text.hpp>
#include <gonio/color/detail/cie_tables.hpp>
#include <gonio/color/detail/spectrum_samples.hpp>
#include <gonio/color/luminous_efficacy.hpp>
#include <gonio/color/planckian.hpp>
#include <gonio/color/spectrum.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gonio {

namespace {

// Whether all steps agree to a thousandth, which tables with rounded wavelengths do.
bool even(const std::vector<double>& nm) {
    const double step = (nm.back() - nm.front()) / static_cast<double>(nm.size() - 1);
    for (std::size_t i = 1; i < nm.size(); ++i)
        if (std::abs(nm[i] - nm[i - 1] - step) > 1e-3 * step) return false;
    return true;
}

bool same_letters(std::string_view a, std::string_view b) {
    const auto fold = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return fold(x) == fold(y); });
}

} // namespace

glm::dvec3 detail::observer_at(double nm) {
    const double place = nm - observer_first_nm;
    if (!(place >= 0.0) || nm > observer_last_nm) return glm::dvec3(0.0);
    const auto i = std::min(static_cast<std::size_t>(place), observer.size() - 2);
    const double f = place - static_cast<double>(i);
    const auto& a = observer[i];
    const auto& b = observer[i + 1];
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
}

detail::Samples detail::samples_of(const Spectrum& spectrum) {
    const std::vector<double>& nm = spectrum.wavelengths_nm;
    if (nm.size() == 1) return {nm, spectrum.power, 1.0};
    const double mean_step = (nm.back() - nm.front()) / static_cast<double>(nm.size() - 1);
    if (mean_step <= 5.0 + 1e-9 && even(nm)) return {nm, spectrum.power, mean_step};
    Samples samples;
    double finest = 1.0;
    for (std::size_t i = 1; i < nm.size(); ++i)
        finest = std::min(finest, nm[i] - nm[i - 1]);
    const double wanted = std::max(finest, 0.05);
    const auto count = static_cast<std::size_t>(std::ceil((nm.back() - nm.front()) / wanted - 1e-9));
    samples.width_nm = (nm.back() - nm.front()) / static_cast<double>(count);
    std::size_t above = 1;
    for (std::size_t i = 0; i <= count; ++i) {
        const double at = i == count ? nm.back() : nm.front() + samples.width_nm * static_cast<double>(i);
        while (above + 1 < nm.size() && nm[above] < at)
            ++above;
        const double f = (at - nm[above - 1]) / (nm[above] - nm[above - 1]);
        samples.nm.push_back(at);
        samples.power.push_back(spectrum.power[above - 1] + f * (spectrum.power[above] - spectrum.power[above - 1]));
    }
    return samples;
}

Result<Band> parse_band(std::string_view text) {
    const std::size_t colon = text.find(':');
    const auto nanometers = [](std::string_view part) -> std::optional<double> {
        if (!part.ends_with("nm")) return std::nullopt;
        return parse_number(part.substr(0, part.size() - 2));
    };
    if (colon != std::string_view::npos) {
        const std::optional<double> first = nanometers(text.substr(0, colon));
        const std::optional<double> last = nanometers(text.substr(colon + 1));
        if (first && last && *first > 0.0 && *first < *last) return Band{*first, *last};
    }
    return fail("USE0105", fmt::format("'{}' is not a band of wavelengths", text), "for example 380nm:780nm");
}

std::string to_text(Band band) {
    return fmt::format("{}–{} nm", rounded(band.first_nm), rounded(band.last_nm));
}

Result<SpectrumColor> color_of(const Spectrum& spectrum, std::optional<Band> band) {
    const detail::Samples samples = detail::samples_of(spectrum);
    SpectrumColor color;
    color.band = band.value_or(Band{spectrum.wavelengths_nm.front(), spectrum.wavelengths_nm.back()});
    // Tables in steps of 5 nm are summed over 380–780 nm (CIE 015): most end there, and a longer range at one end only
    // would bias the sum.
    const Band seen =
        samples.width_nm > 4.9 ? Band{380.0, 780.0} : Band{detail::observer_first_nm, detail::observer_last_nm};
    const double greatest = *std::max_element(samples.power.begin(), samples.power.end()); // sums must not overflow
    double radiant = 0.0;
    std::optional<double> first;
    double last = 0.0;
    for (std::size_t i = 0; i < samples.nm.size(); ++i) {
        const double power = samples.power[i] / greatest;
        if (samples.nm[i] >= seen.first_nm - 1e-9 && samples.nm[i] <= seen.last_nm + 1e-9)
            color.xyz += power * detail::observer_at(samples.nm[i]);
        if (samples.nm[i] < color.band.first_nm - 1e-9 || samples.nm[i] > color.band.last_nm + 1e-9) continue;
        if (!first) first = power;
        last = power;
        radiant += power;
    }
    // The visible part vanishes at the ends, the power does not: it is summed as if at 1 nm, whatever the steps.
    radiant += 0.5 * (first.value_or(0.0) + last) * (1.0 / samples.width_nm - 1.0);
    if (!(color.xyz.y > 0.0))
        return fail(Failure::usage, fmt::format("the spectrum '{}' has no visible light", spectrum.name));
    if (!(radiant > 0.0))
        return fail(Failure::usage,
                    fmt::format("the spectrum '{}' has no power in {}", spectrum.name, to_text(color.band)),
                    fmt::format("it reaches from {} to {} nm", rounded(spectrum.wavelengths_nm.front()),
                                rounded(spectrum.wavelengths_nm.back())));
    color.efficacy_lm_per_w = luminous_efficacy_constant * color.xyz.y / radiant;
    color.xyz /= color.xyz.y;
    color.uv = to_uv(color.xyz);
    return color;
}

std::vector<std::string_view> illuminant_names() {
    std::vector<std::string_view> names;
    names.reserve(detail::illuminant_tables.size());
    for (const detail::IlluminantTable& table : detail::illuminant_tables)
        names.push_back(table.name);
    return names;
}

std::optional<Spectrum> find_illuminant(std::string_view name) {
    for (const detail::IlluminantTable& table : detail::illuminant_tables) {
        if (!same_letters(table.name, name)) continue;
        Spectrum spectrum;
        spectrum.name = table.name;
        spectrum.power.assign(table.power.begin(), table.power.end());
        for (std::size_t i = 0; i < table.power.size(); ++i)
            spectrum.wavelengths_nm.push_back(table.first_nm + detail::illuminant_step_nm * static_cast<double>(i));
        return spectrum;
    }
    return std::nullopt;
}

Result<Spectrum> blackbody_spectrum(Kelvin temperature) {
    if (!(temperature.value >= coolest.value && temperature.value <= hottest.value))
        return fail("USE0106", fmt::format("a black body of {} K is out of range", rounded(temperature.value, 12)),
                    "the range is 500 K to 1e6 K");
    Spectrum spectrum;
    spectrum.name = fmt::format("blackbody {} K", rounded(temperature.value, 12));
    for (int nm = detail::observer_first_nm; nm <= detail::observer_last_nm; ++nm) {
        spectrum.wavelengths_nm.push_back(nm);
        spectrum.power.push_back(std::pow(560.0 / nm, 5) /
                                 std::expm1(c2_meter_kelvin * 1e9 / (nm * temperature.value)));
    }
    const double greatest = *std::max_element(spectrum.power.begin(), spectrum.power.end());
    for (double& power : spectrum.power)
        power /= greatest;
    return spectrum;
}

} // namespace gonio
