#include <gonio/base/text.hpp>
#include <gonio/profile/luminous_opening.hpp>
#include <gonio/profile/tm33_light.hpp>

#include <string>
#include <utility>

namespace gonio {

namespace {

// "CIE _ C", "Type C" → "CIEC", "TYPEC".
std::string canonical(const std::string& text) {
    std::string result;
    for (const char c : text)
        if (to_upper(c) >= 'A' && to_upper(c) <= 'Z') result += to_upper(c);
    return result;
}

bool is_relative(const Tm33Emitter& emitter) {
    const bool rated = emitter.rated_lumens && *emitter.rated_lumens > 0.0;
    return rated && emitter.intensity && !emitter.intensity->absolute.value_or(false);
}

double factor_of(const Tm33Emitter& emitter) {
    return emitter.intensity->multiplier.value_or(1.0) * emitter.ballast_factor.value_or(1.0);
}

void set_opening(IesFile& file, const Tm33File& of) {
    const LuminousOpening opening = luminous_opening({{}, of, {}});
    const bool round = opening.shape == OpeningShape::disk || opening.shape == OpeningShape::ellipse;
    file.width = round ? -opening.width_m : opening.width_m;
    file.length = round ? -opening.length_m : opening.length_m;
    file.height = opening.height_m;
}

} // namespace

std::optional<Photometry> photometry_of(const Tm33File& file) {
    std::string named = canonical(file.goniometer);
    for (const Tm33Emitter& emitter : file.emitters)
        if (named.empty() && emitter.intensity) named = canonical(emitter.intensity->photometry_type);
    if (named == "CUSTOM" || named == "CIEA") return std::nullopt;
    if (named == "IESA" || named == "TYPEA" || named == "A") return Photometry::a;
    if (named == "IESB" || named == "CIEB" || named == "TYPEB" || named == "B") return Photometry::b;
    return Photometry::c;
}

Result<IesFile> lm63_of(const Tm33File& file) {
    const std::optional<Photometry> photometry = photometry_of(file);
    if (!photometry)
        return fail(Failure::unsupported, "LM-63 does not have the goniometer geometry " + file.goniometer,
                    "IES_A, IES_B, IES_C, CIE_B and CIE_C are known");
    IesFile light;
    light.version = IesVersion::lm63_2019;
    light.photometry = *photometry;
    double watts = 0.0;
    double lumens = 0.0;
    double lamps = 0.0;
    const Tm33Emitter* first = nullptr;
    std::size_t shining = 0;
    for (const Tm33Emitter& emitter : file.emitters) {
        watts += emitter.input_watts.value_or(0.0);
        if (!emitter.intensity) continue;
        ++shining;
        lamps += emitter.quantity.value_or(1.0);
        if (is_relative(emitter)) lumens += *emitter.rated_lumens * emitter.quantity.value_or(1.0);
        const Tm33Intensity& intensity = *emitter.intensity;
        if (first == nullptr) {
            first = &emitter;
            light.vertical_deg = intensity.vertical_deg;
            light.horizontal_deg = intensity.horizontal_deg;
            light.candela = intensity.candela;
            light.tilt = emitter.tilt;
            light.candela_multiplier = intensity.multiplier.value_or(1.0);
            light.ballast_factor = emitter.ballast_factor.value_or(1.0);
            continue;
        }
        if (intensity.vertical_deg != light.vertical_deg || intensity.horizontal_deg != light.horizontal_deg ||
            emitter.tilt != light.tilt)
            return fail(Failure::unsupported,
                        "the emitters have different angles or tilt factors, so they cannot be added",
                        "give them the same angles and tilt factors");
        const double factor = factor_of(emitter);
        if (shining == 2) { // from here on every table has its own factor
            for (double& candela : light.candela)
                candela *= factor_of(*first);
            light.candela_multiplier = 1.0;
            light.ballast_factor = 1.0;
        }
        for (std::size_t i = 0; i < light.candela.size(); ++i)
            light.candela[i] += factor * intensity.candela[i];
    }
    if (first == nullptr)
        return fail(Failure::unsupported, "no emitter has a luminous intensity",
                    "radiant and photon intensities are kept, but not turned into candela");
    if (!light.tilt.angles_deg.empty()) light.tilt_keyword = "INCLUDE";
    constexpr double most_lamps = 1e6; // a larger number is not a real count
    light.lamp_count = lamps >= 1.0 && lamps <= most_lamps ? static_cast<int>(lamps) : 1;
    light.lumens_per_lamp = lumens > 0.0 ? lumens / light.lamp_count : -1.0;
    light.input_watts = watts;
    set_opening(light, file);
    return light;
}

std::optional<double> declared_flux_lm(const Tm33File& file) {
    double lumens = 0.0;
    for (const Tm33Emitter& emitter : file.emitters)
        if (is_relative(emitter)) lumens += *emitter.rated_lumens * emitter.quantity.value_or(1.0);
    return lumens > 0.0 ? std::optional(lumens) : std::nullopt;
}

} // namespace gonio
