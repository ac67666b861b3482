// Spectra: relative or absolute spectral power over wavelength, and their colour and luminous efficacy.
//
// Sources: the CIE illuminants of data/cie_illuminants.csv by name, black bodies, CSV files, TM-33 documents. A
// spectrum in uniform steps of at most 5 nm is summed at its own wavelengths with the observer there, as its tables are
// intended (interpolation would move line spectra of 5 nm by 2e-4 in xy), over 380–780 nm if the steps are 5 nm (CIE
// 015), else over 360–830 nm. A spectrum with coarser or non-uniform steps is interpolated linearly, then summed in
// steps of 1 nm or of its finest step. Outside its wavelengths a spectrum is 0.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/color/chromaticity.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

class FileScope;
struct Profile;

// A spectral power distribution by its values at wavelengths; linear between them, 0 outside.
struct Spectrum {
    std::string name;
    std::vector<double> wavelengths_nm; // strictly ascending
    std::vector<double> power;          // same count, ≥ 0, not all 0
    Diagnostics diagnostics;            // from reading it
};

// Wavelengths in nm, ends included.
struct Band {
    double first_nm = 0.0;
    double last_nm = 0.0;
};
// "380nm:780nm". Fails (usage) on anything else, and if the first is not below the last.
Result<Band> parse_band(std::string_view text);
std::string to_text(Band band); // "380–780 nm"

// What a spectrum looks like, and its efficacy.
struct SpectrumColor {
    glm::dvec3 xyz{0.0}; // Y = 1
    Uv uv;
    double efficacy_lm_per_w = 0.0; // luminous flux over the radiant flux in `band`
    Band band;
};

// `band`: the range of the radiant flux, summed at 1 nm; by default the whole spectrum. Fails (usage) on a spectrum
// without visible light, and on a band in which it has no power.
Result<SpectrumColor> color_of(const Spectrum& spectrum, std::optional<Band> band = std::nullopt);

// Names of the CIE illuminants, in the table's order.
std::vector<std::string_view> illuminant_names();

// By name, ignoring case ("d65", "LED-B3"); nothing if there is none. As tabulated, in steps of 5 nm.
std::optional<Spectrum> find_illuminant(std::string_view name);

// A black body in steps of 1 nm, 360–830 nm [W/(m²·sr·nm), over its maximum]. Fails (usage) outside 500 K to 1e6 K.
Result<Spectrum> blackbody_spectrum(Kelvin temperature);

// Lines of WAVELENGTH,POWER: nm; separated by comma, semicolon, tab or blanks; '#' begins a comment, and the first line
// may have column names. Fails (malformed) with line and column on text that is not a number, on negative power, on
// wavelengths that do not ascend or are outside 1–100000 nm, on gaps (a step above 20 nm, or more than 2.5 times the
// usual one), on spectra that do not cover 400 to 700 nm, and if no power is above 0. Warns if a spectrum does not
// reach 380 and 780 nm. If the text has no such line at all, the message does not quote it, because it may be any file.
Result<Spectrum> parse_spectrum_csv(std::string_view text, const std::string& source);

// The spectra of a TM-33 document, with the same checks as for a CSV file; empty for other profiles.
Result<std::vector<Spectrum>> spectra_of(const Profile& profile);

// From the bytes of a CSV file or of a TM-33 document; at least one spectrum. Fails (malformed, unsupported).
Result<std::vector<Spectrum>> parse_spectra(const std::string& bytes, const std::string& source);

// With it begin a colour and an efficacy that a spectrum gives; the text for read_spectrum() follows.
inline constexpr std::string_view spectrum_prefix = "spectrum:";

// "d65", "blackbody:2700K", or a file as above: any file, or if `files` is given, one that it allows. Fails (io,
// malformed, usage, unsupported).
Result<std::vector<Spectrum>> read_spectra(const std::string& text, FileScope* files = nullptr);

// The only spectrum of that text. Fails (unsupported) if there are several.
Result<Spectrum> read_spectrum(const std::string& text, FileScope* files = nullptr);

} // namespace gonio
#pragma GCC visibility pop
