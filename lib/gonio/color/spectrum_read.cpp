#include <gonio/base/codes/result.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/file_scope.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/profile/read.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>

namespace gonio {

namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::string_view separators = ",; \t\r";
constexpr double widest_step_nm = 20.0;
constexpr double least_nm = 1.0;
constexpr double greatest_nm = 1e5;

Unexpected malformed(const Location& where, std::string message, std::string hint = {}) {
    return Unexpected(error_at(Failure::malformed, where, std::move(message), std::move(hint)));
}

// The places of the points in their file, for messages; empty if there are none.
struct Places {
    std::string source;
    std::vector<std::uint32_t> line;

    Location of(std::size_t point) const { return {source, point < line.size() ? line[point] : 0, 0}; }
};

// Checks that apply to every spectrum that was read.
Result<void> check(Spectrum& spectrum, const Places& places) {
    const std::vector<double>& nm = spectrum.wavelengths_nm;
    if (nm.size() < 2) return malformed(places.of(nm.size()), "a spectrum of fewer than two points");
    for (std::size_t i = 0; i < nm.size(); ++i) {
        if (spectrum.power[i] < 0.0)
            return malformed(places.of(i),
                             fmt::format("negative power, {} at {} nm", rounded(spectrum.power[i]), rounded(nm[i], 9)));
        if (!(nm[i] >= least_nm && nm[i] <= greatest_nm))
            return malformed(places.of(i),
                             fmt::format("{} is not a wavelength of light in nanometres", rounded(nm[i], 9)),
                             "wavelengths are from 1 to 100000 nm; the eye sees from 380 to 780 nm");
        if (i > 0 && !(nm[i] > nm[i - 1]))
            return malformed(places.of(i), fmt::format("wavelengths must ascend, but {} nm follows {} nm",
                                                       rounded(nm[i], 9), rounded(nm[i - 1], 9)));
    }
    std::vector<double> steps;
    for (std::size_t i = 1; i < nm.size(); ++i)
        steps.push_back(nm[i] - nm[i - 1]);
    std::vector<double> sorted = steps;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double widest = std::min(widest_step_nm + 1e-9, std::max(2.5 * *middle, 1.0));
    for (std::size_t i = 0; i < steps.size(); ++i) {
        // Only gaps in the visible range count.
        if (steps[i] <= widest || nm[i + 1] < 380.0 || nm[i] > 780.0) continue;
        return malformed(places.of(i + 1),
                         fmt::format("a gap: nothing between {} and {} nm", rounded(nm[i], 9), rounded(nm[i + 1], 9)),
                         "fill it in, with zeros where there is no light");
    }
    if (nm.front() > 400.0 || nm.back() < 700.0)
        return malformed(
            places.of(nm.size()),
            fmt::format("the spectrum reaches from {} to {} nm only", rounded(nm.front(), 9), rounded(nm.back(), 9)),
            "the eye sees from 380 to 780 nm");
    if (std::all_of(spectrum.power.begin(), spectrum.power.end(), [](double power) { return power == 0.0; }))
        return malformed(places.of(nm.size()), "no power anywhere in the spectrum");
    if (nm.front() > 380.0 || nm.back() < 780.0)
        spectrum.diagnostics.push_back(result_diagnostic(
            "RES0103",
            fmt::format("the spectrum reaches from {} to {} nm: taken as 0 beyond, up to 380 and 780 nm",
                        rounded(nm.front(), 9), rounded(nm.back(), 9)),
            {}, places.source));
    return {};
}

struct Word {
    std::string_view text;
    std::uint32_t column = 0;
};

// Cells of a line; a comma or semicolon with nothing before it makes an empty cell.
std::vector<Word> words_of(std::string_view line) {
    std::vector<Word> words;
    std::size_t at = 0;
    bool expect = false; // a separator that must be followed by a cell
    while (true) {
        at = line.find_first_not_of(blanks, at);
        if (at == std::string_view::npos) break;
        if (line[at] == ',' || line[at] == ';') {
            if (expect || words.empty()) words.push_back({line.substr(at, 0), static_cast<std::uint32_t>(at + 1)});
            expect = true;
            ++at;
            continue;
        }
        const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
        words.push_back({line.substr(at, end - at), static_cast<std::uint32_t>(at + 1)});
        expect = false;
        at = end;
    }
    if (expect) words.push_back({line.substr(line.size()), static_cast<std::uint32_t>(line.size() + 1)});
    return words;
}

constexpr std::string_view blackbody_prefix = "blackbody:";

Unexpected unknown_spectrum(const std::string& text, const std::string& path) {
    const std::vector<std::string_view> names = illuminant_names();
    const std::string_view guess = nearest(text, names);
    return fail(Failure::io, fmt::format("'{}' is neither an illuminant nor a file that exists", path),
                guess.empty() ? "name a CIE illuminant ('gonio list illuminants'), blackbody:2700K, a CSV or TM-33 file"
                              : fmt::format("did you mean '{}'?", guess));
}

} // namespace

Result<Spectrum> parse_spectrum_csv(std::string_view text, const std::string& source) {
    Spectrum spectrum;
    spectrum.name = source;
    Places places{source, {}};
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    bool head = false;
    for (std::uint32_t line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view row = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        row = row.substr(0, row.find('#'));
        const std::vector<Word> words = words_of(row);
        if (words.empty()) continue;
        std::optional<double> nm = parse_number(words.front().text);
        if (!nm && spectrum.power.empty() && !head) { // column names
            head = true;
            continue;
        }
        // Before the first row of a spectrum, the text may be any file, so nothing of it is quoted.
        const bool is_spectrum = !spectrum.power.empty();
        const bool is_row = nm && words.size() > 1 && parse_number(words[1].text);
        if (!is_spectrum && !is_row)
            return malformed({source, line, words.front().column}, "not a spectrum: expected lines WAVELENGTH,POWER");
        if (!nm)
            return malformed({source, line, words.front().column},
                             fmt::format("'{}' is not a wavelength", words.front().text), "lines are WAVELENGTH,POWER");
        if (words.size() > 2)
            return malformed({source, line, words[2].column}, "more than two columns",
                             "lines are WAVELENGTH,POWER: keep one spectrum in the file");
        const auto behind = static_cast<std::uint32_t>(row.size() + 1);
        if (words.size() < 2 || words[1].text.empty())
            return malformed({source, line, words.size() < 2 ? behind : words[1].column},
                             fmt::format("no power is given at {} nm", rounded(*nm, 9)));
        const std::optional<double> power = parse_number(words[1].text);
        if (!power)
            return malformed({source, line, words[1].column}, fmt::format("'{}' is not a power", words[1].text));
        spectrum.wavelengths_nm.push_back(*nm);
        spectrum.power.push_back(*power);
        places.line.push_back(line);
    }
    if (Result<void> sound = check(spectrum, places); !sound) return pass_on(sound);
    return spectrum;
}

Result<std::vector<Spectrum>> spectra_of(const Profile& profile) {
    std::vector<Spectrum> spectra;
    const auto* const document = std::get_if<Tm33File>(&profile.file);
    if (document == nullptr) return spectra;
    for (std::size_t e = 0; e < document->emitters.size(); ++e) {
        for (const Tm33Spectrum& read : document->emitters[e].spectra) {
            Spectrum spectrum;
            spectrum.name = read.emitter_name.empty() ? fmt::format("{}, emitter {}", profile.source, e + 1)
                                                      : fmt::format("{}, {}", profile.source, read.emitter_name);
            spectrum.wavelengths_nm = read.wavelengths_nm;
            spectrum.power = read.power;
            if (Result<void> sound = check(spectrum, {profile.source, {}}); !sound) return pass_on(sound);
            spectra.push_back(std::move(spectrum));
        }
    }
    return spectra;
}

Result<std::vector<Spectrum>> parse_spectra(const std::string& bytes, const std::string& source) {
    std::vector<Spectrum> spectra;
    const std::size_t begin = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    const bool markup = begin != std::string::npos && bytes[begin] == '<';
    if (!markup) {
        Result<Spectrum> read = parse_spectrum_csv(bytes, source);
        if (!read) return pass_on(read);
        spectra.push_back(std::move(*read));
        return spectra;
    }
    ReadOptions options;
    options.format = ProfileFormat::tm33;
    Result<Profile> profile = read_profile(bytes, source, options);
    if (!profile) return pass_on(profile);
    Result<std::vector<Spectrum>> found = spectra_of(*profile);
    if (found && found->empty())
        return fail(Failure::unsupported, "the document has no spectrum", "it needs one, as SpectralData of an emitter",
                    source);
    return found;
}

Result<std::vector<Spectrum>> read_spectra(const std::string& text, FileScope* files) {
    std::vector<Spectrum> spectra;
    if (std::optional<Spectrum> illuminant = find_illuminant(text)) {
        spectra.push_back(std::move(*illuminant));
        return spectra;
    }
    if (text.starts_with(blackbody_prefix)) {
        Result<double> kelvin = parse_amount(text.substr(blackbody_prefix.size()), Dimension::temperature,
                                             "the temperature of a black body");
        if (!kelvin) return pass_on(kelvin);
        Result<Spectrum> body = blackbody_spectrum(Kelvin(*kelvin));
        if (!body) return pass_on(body);
        spectra.push_back(std::move(*body));
        return spectra;
    }
    Result<std::string> path = files == nullptr ? text : files->path_of(text);
    if (!path) return pass_on(path);
    Result<std::string> bytes = read_file(*path, limit("spectrum-bytes"));
    if (!bytes) {
        if (!file_exists(*path)) return unknown_spectrum(text, *path);
        return pass_on(bytes);
    }
    return parse_spectra(*bytes, *path);
}

Result<Spectrum> read_spectrum(const std::string& text, FileScope* files) {
    Result<std::vector<Spectrum>> spectra = read_spectra(text, files);
    if (!spectra) return pass_on(spectra);
    if (spectra->size() > 1)
        return fail(Failure::unsupported,
                    fmt::format("'{}' has {} spectra, but only one is expected", text, spectra->size()),
                    "'gonio cct --spectrum' shows them all; write one of them to a CSV file");
    return std::move(spectra->front());
}

} // namespace gonio
