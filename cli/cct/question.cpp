#include "question.hpp"

#include <gonio/base/codes/result.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/media/color_space.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::size_t most_steps = limit("cct-steps").value;

Result<std::vector<double>> numbers(std::string_view text, std::size_t count, std::string_view what,
                                    std::string_view example) {
    std::vector<double> found;
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        const std::optional<double> number = parse_number(rest.substr(0, comma));
        if (!number) break;
        found.push_back(*number);
        if (comma == std::string_view::npos) {
            if (found.size() == count) return found;
            break;
        }
        rest.remove_prefix(comma + 1);
    }
    return fail("USE0105", fmt::format("{} takes {} numbers, not '{}'", what, count, text),
                fmt::format("for example {}", example));
}

constexpr std::string_view primaries_prefix = "primaries:";

// A space by name: built in, by primaries, or from the OpenColorIO configuration.
Result<RgbSpace> space_of(const Arguments& arguments) {
    const std::string name = arguments.value("--space").value_or("rec709");
    // A configuration given by --ocio is searched for every space, so it is never ignored.
    if (arguments.has("--ocio") && !arguments.has("--space"))
        return fail("USE0107", "--ocio needs a --space of that configuration", "for example --space scene_linear");
    const RgbSpace* const known = find_rgb_space(name);
    if (known != nullptr && !arguments.has("--ocio")) return *known;
    if (name.starts_with(primaries_prefix)) {
        Result<std::vector<double>> xy = numbers(
            std::string_view(name).substr(primaries_prefix.size()), 8,
            "--space primaries:", "primaries:0.64,0.33,0.3,0.6,0.15,0.06,0.3127,0.329 (red, green, blue, white)");
        if (!xy) return pass_on(xy);
        const std::vector<double>& v = *xy;
        return rgb_space_of("primaries", {v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]});
    }
    // The library never reads the environment; the tool passes $OCIO on.
    const char* const environment = std::getenv("OCIO");
    const std::string config = arguments.value("--ocio").value_or(environment == nullptr ? "" : environment);
    return media::rgb_space_of_config(name, config);
}

template<class T, std::size_t n>
Result<T> choose(const Arguments& arguments, std::string_view option, std::string_view what,
                 const std::array<Named<T>, n>& choices) {
    const auto text = arguments.value(option);
    if (!text) return choices.front().value;
    return find_value(what, *text, choices);
}

// An answer for a chromaticity that is known; fills in its colour in the requested space.
CctAnswer in_space(std::string input, CctKind kind, Uv at, const CctRequest& request) {
    CctAnswer answer;
    answer.input = std::move(input);
    answer.kind = kind;
    answer.at = at;
    answer.color = to_space(at, request.space, request.gamut, request.normalize);
    answer.locus = "planckian";
    return answer;
}

Result<void> compare_colors(const CctRequest& request, CctAnswer& answer) {
    if (!request.versus) return {};
    if (answer.cct->duv != 0.0 || request.locus != Locus::planckian)
        return fail("USE0107", "--versus compares black bodies, and this colour is not one",
                    "leave out --duv, --tint and --locus");
    Result<std::vector<const ColorMethod*>> methods = parse_color_methods(*request.versus);
    if (!methods) return pass_on(methods);
    for (const ColorMethod* method : *methods) {
        const ColorError error = error_of(*method, answer.cct->temperature);
        answer.versus.push_back({method->name, method->source, error.in_range, error.cct_k, error.duv, error});
    }
    return {};
}

Result<void> compare_temperatures(const CctRequest& request, CctAnswer& answer) {
    if (!request.versus || !answer.cct) return {};
    Result<std::vector<const CctMethod*>> methods = parse_cct_methods(*request.versus);
    if (!methods) return pass_on(methods);
    for (const CctMethod* method : *methods) {
        const Kelvin truth = answer.cct->temperature;
        answer.versus.push_back({method->name, method->source,
                                 truth.value >= method->coolest.value && truth.value <= method->hottest.value,
                                 method->cct_k(answer.at), 0.0, std::nullopt});
    }
    return {};
}

Result<void> add_quality(const Spectrum& spectrum, CctAnswer& answer) {
    Result<LightQuality> quality = light_quality(spectrum);
    if (!quality) return pass_on(quality);
    answer.diagnostics.insert(answer.diagnostics.end(), quality->diagnostics.begin(), quality->diagnostics.end());
    answer.quality = std::move(*quality);
    return {};
}

Unexpected no_spectrum(const std::string& input) {
    return fail("USE0107", fmt::format("--quality needs a spectrum, and '{}' is only a chromaticity", input),
                "name an illuminant (d65), a black body (2700K) or, with --spectrum, a file");
}

// The answer for a chromaticity: its correlated colour temperature.
Result<std::vector<CctAnswer>> nearest_black_body(std::string input, CctKind kind, Uv at, const CctRequest& request) {
    if (request.duv) return fail("USE0107", fmt::format("'{}' already has a Duv", input), "leave --duv and --tint out");
    if (request.quality) return no_spectrum(input);
    Result<Cct> cct = exact_cct(at);
    if (!cct) return pass_on(cct);
    CctAnswer answer = in_space(std::move(input), kind, at, request);
    answer.cct = *cct;
    answer.diagnostics = remarks(*cct);
    if (Result<void> compared = compare_temperatures(request, answer); !compared) return pass_on(compared);
    return std::vector{std::move(answer)};
}

Result<CctAnswer> answer_of(const Spectrum& spectrum, std::string input, const CctRequest& request) {
    Result<SpectrumColor> color = color_of(spectrum, request.band);
    if (!color) return pass_on(color);
    CctAnswer answer = in_space(std::move(input), CctKind::spectrum, color->uv, request);
    answer.spectrum = *color;
    answer.diagnostics = spectrum.diagnostics;
    if (Result<Cct> cct = exact_cct(color->uv)) {
        answer.cct = *cct;
        for (Diagnostic& said : remarks(*cct))
            answer.diagnostics.push_back(std::move(said));
    } else {
        Diagnostic& reason = cct.error().diagnostics.back();
        reason.severity = Severity::warning;
        reason.code = CodeOf<result_codes>("RES0102")->code; // not that of an error
        answer.diagnostics.push_back(std::move(reason));
    }
    if (request.quality)
        if (Result<void> added = add_quality(spectrum, answer); !added) return pass_on(added);
    if (Result<void> compared = compare_temperatures(request, answer); !compared) return pass_on(compared);
    return answer;
}

} // namespace

Result<CctRequest> cct_request(const Arguments& arguments) {
    CctRequest request;
    const std::string locus = arguments.value("--locus").value_or("planckian");
    Result<Locus> parsed = parse_locus(locus);
    if (!parsed) return pass_on(parsed);
    request.locus = *parsed;
    for (const LocusName& known : locus_names())
        if (known.locus == request.locus) request.locus_name = known.name;
    if (const auto text = arguments.value("--duv")) {
        const std::optional<double> duv = parse_number(*text);
        if (!duv)
            return fail("USE0105", fmt::format("--duv takes a number, not '{}'", *text), "for example --duv 0.003");
        request.duv = *duv;
    }
    if (const auto text = arguments.value("--tint")) {
        if (request.duv)
            return fail("USE0107", "--duv and --tint are both given", "both set the distance from the locus");
        Result<double> duv = parse_tint(*text);
        if (!duv) return pass_on(duv);
        request.duv = *duv;
    }
    request.quality = arguments.has("--quality");
    if (request.quality && arguments.has("--versus"))
        return fail("USE0107", "--quality and --versus are both given", "ask for them one by one");
    if (const auto text = arguments.value("--illuminance")) {
        if (!request.quality)
            return fail("USE0107", "--illuminance needs --quality", "it gives the equivalent daylight illuminance");
        Result<double> lux = parse_amount(*text, Dimension::illuminance, "--illuminance");
        if (!lux) return pass_on(lux);
        if (!(*lux >= 0.0))
            return fail("USE0105", fmt::format("--illuminance takes an illuminance from 0, not '{}'", *text));
        request.illuminance = Lux(*lux);
    }
    Result<Gamut> gamut = choose(arguments, "--gamut", "gamut",
                                 std::array{Named<Gamut>{"keep", Gamut::keep}, Named<Gamut>{"clip", Gamut::clip}});
    if (!gamut) return pass_on(gamut);
    request.gamut = *gamut;
    Result<Normalize> normalize = choose(
        arguments, "--normalize", "normalisation",
        std::array{Named<Normalize>{"luminance", Normalize::luminance}, Named<Normalize>{"max", Normalize::max}});
    if (!normalize) return pass_on(normalize);
    request.normalize = *normalize;
    if (const auto text = arguments.value("--band")) {
        Result<Band> band = parse_band(*text);
        if (!band) return pass_on(band);
        request.band = *band;
    }
    request.versus = arguments.value("--versus");
    Result<RgbSpace> space = space_of(arguments);
    if (!space) return pass_on(space);
    request.space = std::move(*space);
    return request;
}

Result<std::vector<std::string>> expanded(const std::string& word) {
    const std::size_t first = word.find(':');
    if (first == std::string::npos || first != word.find_first_of(":/@")) return std::vector{word};
    const std::size_t second = word.find(':', first + 1);
    const auto kelvin = [&](std::string_view text) -> Result<double> {
        if (const std::optional<double> bare = parse_number(text); bare && second != std::string::npos) return *bare;
        return parse_amount(text, Dimension::temperature, "a bound of a range");
    };
    if (second == std::string::npos)
        return fail("USE0105", fmt::format("'{}' is neither a value nor a range", word),
                    "a range is FROM:TO:STEP, for example 2000K:10000K:100K");
    Result<double> from = parse_amount(word.substr(0, first), Dimension::temperature, "the start of a range");
    if (!from) return pass_on(from);
    Result<double> to =
        parse_amount(word.substr(first + 1, second - first - 1), Dimension::temperature, "the end of a range");
    if (!to) return pass_on(to);
    Result<double> step = kelvin(word.substr(second + 1));
    if (!step) return pass_on(step);
    const double count = std::floor((*to - *from) / *step + 1e-9);
    if (!(*step > 0.0) || !(count >= 0.0))
        return fail("USE0106", fmt::format("the range '{}' does not ascend", word),
                    "a range is FROM:TO:STEP, for example 2000K:10000K:100K");
    if (count > static_cast<double>(most_steps))
        return fail("USE0106", fmt::format("the range '{}' has more than {}", word, to_text(limit("cct-steps"))));
    std::vector<std::string> values;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(count); ++i)
        values.push_back(fmt::format("{}K", rounded(*from + static_cast<double>(i) * *step, 15)));
    return values;
}

Result<std::vector<CctAnswer>> answer_value(const std::string& value, const CctRequest& request) {
    if (const std::optional<Spectrum> illuminant = find_illuminant(value)) {
        if (request.duv)
            return fail("USE0107", fmt::format("'{}' already has a Duv", value), "leave --duv and --tint out");
        Result<CctAnswer> answer = answer_of(*illuminant, value, request);
        if (!answer) return pass_on(answer);
        return std::vector{std::move(*answer)};
    }
    Result<Cct> cct = parse_cct(value);
    if (!cct) {
        if (const std::string_view guess = nearest(value, illuminant_names()); !guess.empty())
            error_hint(cct.error(), fmt::format("did you mean the illuminant '{}'?", guess));
        else
            error_hint(cct.error(), "write 2700K, 2700K/0.003 (with its Duv), 2000K:10000K:100K or an illuminant: d65");
        return pass_on(cct);
    }
    if (request.duv) {
        if (value.find('/') != std::string::npos)
            return fail("USE0107", fmt::format("'{}' already has a Duv, and --duv or --tint gives another one", value));
        cct->duv = *request.duv;
    }
    if (request.quality && (request.locus != Locus::planckian || cct->duv != 0.0)) return no_spectrum(value);
    Result<Uv> at = exact_uv(*cct, request.locus);
    if (!at) return pass_on(at);
    CctAnswer answer = in_space(value, CctKind::temperature, *at, request);
    answer.locus = request.locus_name;
    answer.cct = *cct;
    if (request.locus != Locus::planckian) {
        // The temperature only names the illuminant; the distance from a black body is computed.
        if (Result<Cct> found = exact_cct(*at)) answer.cct->duv = found->duv;
    } else if (cct->duv == 0.0) {
        answer.blackbody = blackbody_efficacy(cct->temperature);
        answer.blackbody_luminance = blackbody_luminance(cct->temperature, *answer.blackbody);
    }
    answer.diagnostics = remarks(*answer.cct);
    if (request.quality) {
        Result<Spectrum> body = blackbody_spectrum(cct->temperature);
        if (!body) return pass_on(body);
        if (Result<void> added = add_quality(*body, answer); !added) return pass_on(added);
    }
    if (Result<void> compared = compare_colors(request, answer); !compared) return pass_on(compared);
    return std::vector{std::move(answer)};
}

Result<std::vector<CctAnswer>> answer_xy(const std::string& text, const CctRequest& request) {
    Result<std::vector<double>> v = numbers(text, 2, "--xy", "--xy 0.3127,0.329");
    if (!v) return pass_on(v);
    const Xy xy{(*v)[0], (*v)[1]};
    if (!is_real(xy))
        return fail("USE0106", fmt::format("xy {} is not a colour: it lies outside the spectral locus", text),
                    "real colours are mixtures of wavelengths and lie inside it");
    return nearest_black_body(fmt::format("xy {}", text), CctKind::chromaticity, to_uv(xy), request);
}

Result<std::vector<CctAnswer>> answer_uv_prime(const std::string& text, const CctRequest& request) {
    Result<std::vector<double>> v = numbers(text, 2, "--uv-prime", "--uv-prime 0.1978,0.4683");
    if (!v) return pass_on(v);
    const Uv uv = to_uv(UvPrime{(*v)[0], (*v)[1]});
    if (!is_real(to_xy(uv)))
        return fail("USE0106", fmt::format("u'v' {} is not a colour: it lies outside the spectral locus", text),
                    "real colours are mixtures of wavelengths and lie inside it");
    return nearest_black_body(fmt::format("u'v' {}", text), CctKind::chromaticity, uv, request);
}

Result<std::vector<CctAnswer>> answer_rgb(const std::string& text, const CctRequest& request) {
    Result<std::vector<double>> v = numbers(text, 3, "--rgb", "--rgb 1.9,0.8,0.2");
    if (!v) return pass_on(v);
    Result<Uv> uv = uv_of_rgb({(*v)[0], (*v)[1], (*v)[2]}, request.space);
    if (!uv) return pass_on(uv);
    return nearest_black_body(fmt::format("rgb {}", text), CctKind::rgb, *uv, request);
}

Result<std::vector<CctAnswer>> answer_spectrum(const std::string& text, const CctRequest& request) {
    if (request.duv) return fail("USE0107", fmt::format("'{}' already has a Duv", text), "leave --duv and --tint out");
    Result<std::vector<Spectrum>> spectra = std::vector<Spectrum>();
    if (text == "-") {
        Result<std::string> bytes = read_standard_input(limit("spectrum-bytes"));
        if (!bytes) return pass_on(bytes);
        spectra = parse_spectra(*bytes, "-");
    } else {
        spectra = read_spectra(text);
    }
    if (!spectra) return pass_on(spectra);
    std::vector<CctAnswer> answers;
    for (const Spectrum& spectrum : *spectra) {
        Result<CctAnswer> answer = answer_of(spectrum, spectrum.name, request);
        if (!answer) return pass_on(answer);
        answers.push_back(std::move(*answer));
    }
    return answers;
}

} // namespace gonio::cli
