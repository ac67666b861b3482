#include <gonio/base/named.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/light/efficacy.hpp>

#include <fmt/format.h>

#include <array>
#include <vector>

namespace gonio {

namespace {

constexpr double greatest_lm_per_w = 683.002; // at the peak of V(λ) in air, 555 nm

constexpr std::array efficacies{
    NamedEfficacy{"683", 683.0, false, "the SI constant at 540 THz; Frostbite; glTF-Blender-IO since 2022"},
    NamedEfficacy{"blender-gltf-683", 683.0, false, "glTF-Blender-IO since 2022, \"standard\" lighting mode"},
    NamedEfficacy{"khronos-177", 177.0, false, "D65; what Khronos' PBR group agreed on in 2025 for glTF exporters"},
    NamedEfficacy{"cycles-ies-177.83", 177.83, false, "D65; Blender Cycles' IES loader"},
    NamedEfficacy{"radiance-179", 179.0, false, "white of equal energy over the visible; Radiance's WHTEFFICACY"},
    NamedEfficacy{"incandescent", 14.0, true, "per electrical watt: 840 lm of a 60 W tungsten lamp"},
    NamedEfficacy{"tungsten", 14.0, true, "another name for incandescent"},
    NamedEfficacy{"halogen", 20.0, true, "per electrical watt, low-voltage tungsten halogen"},
    NamedEfficacy{"fluorescent", 80.0, true, "per electrical watt, T8 tube with its ballast"},
    NamedEfficacy{"led", 100.0, true, "per electrical watt, a typical LED lamp"},
    NamedEfficacy{"sodium", 120.0, true, "per electrical watt, high-pressure sodium"},
};

Result<Efficacy> efficacy_of_spectrum(const std::string& name, FileScope* files) {
    Result<Spectrum> spectrum = read_spectrum(name, files);
    if (!spectrum) return pass_on(spectrum);
    Result<SpectrumColor> color = color_of(*spectrum);
    if (!color) return pass_on(color);
    return Efficacy{color->efficacy_lm_per_w, fmt::format("{}, {}", spectrum->name, to_text(color->band))};
}

} // namespace

std::span<const NamedEfficacy> named_efficacies() {
    return efficacies;
}

Result<Efficacy> parse_efficacy(std::string_view text, FileScope* files) {
    for (const NamedEfficacy& known : efficacies)
        if (known.name == text) return Efficacy{known.lm_per_w, {}};
    if (text.starts_with(spectrum_prefix))
        return efficacy_of_spectrum(std::string(text.substr(spectrum_prefix.size())), files);
    std::string_view number = text;
    if (number.ends_with("lm/W")) number.remove_suffix(4);
    const std::optional<double> value = parse_number(number);
    if (value && *value > 0.0 && *value <= greatest_lm_per_w) return Efficacy{*value, {}};
    const std::string_view guess = value ? std::string_view() : nearest(text, names_of(efficacies));
    return fail(
        "USE0105", fmt::format("'{}' is not a luminous efficacy", text),
        guess.empty()
            ? std::string(
                  "for example 60W@90lm/W, at most 683 lm/W; 'gonio list efficacies' shows the named conventions")
            : fmt::format("did you mean '{}'?", guess));
}

} // namespace gonio
