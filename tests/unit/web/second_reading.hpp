// A second reader of LM-63 and EULUMDAT, written from the formats' descriptions without any of the library's code and
// by other means: tokens of the whole text through strtod, mirrors written out plane by plane, angles from acos and
// asin, flux by Gauss–Legendre quadrature. It supports only well-formed files and is slow.
#pragma once

#include <string>
#include <vector>

namespace gonio::test {

struct SecondReading {
    char type = 'C';
    // The whole light: every mirror is written out. C-planes and γ, or H and V.
    std::vector<double> horizontal_deg;
    std::vector<double> vertical_deg;
    std::vector<std::vector<double>> candela; // [horizontal][vertical], every factor applied

    [[nodiscard]] double peak_cd() const;
    [[nodiscard]] double flux_lm() const;
    // Along a unit vector: −z is the aim, x is C0 or H = 90°, y is C90 or V = 90°.
    [[nodiscard]] double candela_along(double x, double y, double z) const;
};

// From the bytes of a file: LM-63 if they contain a TILT line, else EULUMDAT with its first lamp set.
SecondReading second_reading(const std::string& bytes);

} // namespace gonio::test
