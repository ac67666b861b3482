// Luminous efficacy: how many lumens a watt counts as. Photometry alone does not determine it, so it is a number or a
// named convention.
#pragma once

#include <gonio/base/result.hpp>

#include <span>
#include <string>
#include <string_view>

namespace gonio {

class FileScope;

// Per radiated watt where a program uses it for conversion, per electrical watt where it describes a lamp. The two are
// never interchangeable.
struct NamedEfficacy {
    std::string_view name; // "khronos-177"
    double lm_per_w = 0.0;
    bool electrical = false;
    std::string_view says; // who uses this value
};

std::span<const NamedEfficacy> named_efficacies();

struct Efficacy {
    double lm_per_w = 0.0;
    std::string of; // what it was computed from, with its band: "LED-B3, 380–780 nm"; empty for a number
};

// "90lm/W", "90", "khronos-177", "spectrum:LED-B3", "spectrum:lamp.csv", "spectrum:blackbody:2700K": the luminous flux
// over the radiant flux in all of the spectrum's wavelengths (gonio/color/spectrum.hpp). Fails (usage) on values that
// are not above 0 or exceed 683.002 lm/W, the efficacy of light at 555 nm; fails on a spectrum as read_spectrum does. A
// spectrum may be any file or, if `files` is given, one that `files` allows.
Result<Efficacy> parse_efficacy(std::string_view text, FileScope* files = nullptr);

} // namespace gonio
