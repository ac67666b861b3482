// The request of `gonio cct`: values, chromaticities and spectra, and the space for their colours.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/light_quality.hpp>
#include <gonio/color/named_methods.hpp>
#include <gonio/color/planckian.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/color/spectrum.hpp>

#include "../arguments.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

struct CctRequest {
    Locus locus = Locus::planckian;
    std::string_view locus_name;
    std::optional<double> duv; // for every temperature given without a Duv
    RgbSpace space;
    Gamut gamut = Gamut::keep;
    Normalize normalize = Normalize::luminance;
    std::optional<Band> band;
    std::optional<std::string> versus;
    bool quality = false;
    std::optional<Lux> illuminance; // for the equivalent daylight illuminance
};

// How a chromaticity was given.
enum class CctKind { temperature, chromaticity, rgb, spectrum };

struct CctVersus {
    std::string_view method;
    std::string_view source;
    bool in_range = true;
    double cct_k = 0.0;                 // NaN if the method gives none
    double duv = 0.0;                   // as cct_k; for methods that find a temperature
    std::optional<ColorError> of_color; // for methods that take a temperature
};

struct CctAnswer {
    std::string input;
    CctKind kind = CctKind::temperature;
    std::optional<Cct> cct; // empty for a spectrum too far from the locus
    Uv at;
    SpaceColor color;
    std::string_view locus;
    std::optional<BlackbodyEfficacy> blackbody; // for a temperature on the Planckian locus itself
    std::optional<Nits> blackbody_luminance;
    std::optional<SpectrumColor> spectrum;
    std::optional<LightQuality> quality; // if asked for
    std::vector<CctVersus> versus;
    Diagnostics diagnostics;
};

// Reads the options; opens OpenColorIO only for a space that is not built in.
Result<CctRequest> cct_request(const Arguments& arguments);

// "2700K", "2700K/0.003", "2000K:10000K:100K" (and their names with --duv), or an illuminant: the values that a word
// stands for. Fails (usage) on ranges that do not ascend or have more than 100000 steps.
Result<std::vector<std::string>> expanded(const std::string& word);

Result<std::vector<CctAnswer>> answer_value(const std::string& value, const CctRequest& request);
Result<std::vector<CctAnswer>> answer_xy(const std::string& text, const CctRequest& request);
Result<std::vector<CctAnswer>> answer_uv_prime(const std::string& text, const CctRequest& request);
Result<std::vector<CctAnswer>> answer_rgb(const std::string& text, const CctRequest& request);
// One answer for each spectrum of a file.
Result<std::vector<CctAnswer>> answer_spectrum(const std::string& text, const CctRequest& request);

} // namespace gonio::cli
