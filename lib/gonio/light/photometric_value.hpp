// Photometric values as text: "800lm", "300lx@2m", "12ev", "60W@90lm/W".
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/base/unit_text.hpp>

#include <optional>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

class FileScope;

// A photometric unit; an illuminance also has a distance from the light's centre, unless it is the sun's, and a power
// has the number of lumens per watt.
struct PhotometricUnit {
    const Unit* unit = nullptr;
    std::optional<Meters> distance;
    std::optional<double> efficacy_lm_per_w;
    std::string efficacy_of = {}; // the spectrum that the efficacy was computed from, with its band
};

// An amount of light in one of the units that text may use.
struct PhotometricValue {
    double number = 0.0;
    PhotometricUnit unit;
};

// "nt", "lx@2m", "evlx@30cm", "lx", "W@90lm/W", "W@khronos-177", "W@spectrum:FILE" (gonio/light/efficacy.hpp). Fails
// (usage) on units of other dimensions, on a distance that is not greater than 0 and on a distance with anything but an
// illuminance.
Result<PhotometricUnit> parse_photometric_unit(std::string_view text);

// "800lm", "300lx@2m", "12ev", "60W@90lm/W" (or "60W@683"). Fails (usage) as above, and on negative amounts. A spectrum
// may be any file or, if `files` is given, one that `files` allows.
Result<PhotometricValue> parse_photometric_value(std::string_view text, FileScope* files = nullptr);

} // namespace gonio
#pragma GCC visibility pop
