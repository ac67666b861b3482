// Luminous efficacy: how many lumens a watt is taken for. Photometry gives no answer by itself, so it is a number, or a
// convention with a name.
#pragma once

#include <gonio/base/result.hpp>

#include <span>
#include <string>
#include <string_view>

namespace gonio {

class FileScope;

// Of radiated watts where a program converts by it, of electrical watts where a lamp is meant: never the same thing.
struct NamedEfficacy {
    std::string_view name; // "khronos-177"
    double lm_per_w = 0.0;
    bool electrical = false;
    std::string_view says; // who means it so
};

std::span<const NamedEfficacy> named_efficacies();

struct Efficacy {
    double lm_per_w = 0.0;
    std::string of; // what it was computed from, with its band: "LED-B3, 380–780 nm"; empty for a number
};

// "90lm/W", "90", "khronos-177", "spectrum:LED-B3", "spectrum:lamp.csv", "spectrum:blackbody:2700K": the luminous flux
// over the radiant flux in all of the spectrum's wavelengths (gonio/color/spectrum.hpp). Fails (usage) on what is not
// above 0 or exceeds 683.002 lm/W, the efficacy of light at 555 nm; as read_spectrum does on a spectrum, which is any
// file, or where `files` is given one that these allow.
Result<Efficacy> parse_efficacy(std::string_view text, FileScope* files = nullptr);

} // namespace gonio
