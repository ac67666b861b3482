// Equality of every field of a file as read, for tests of write → read. Numbers are equal as doubles.
#pragma once

#include <gonio/profile/profile.hpp>

#include <algorithm>
#include <tuple>

namespace gonio::test {

inline bool equal(const IesFile& a, const IesFile& b) {
    const auto keywords = [](const IesKeyword& x, const IesKeyword& y) { return x.name == y.name && x.text == y.text; };
    const auto rest = [](const IesFile& f) {
        return std::tie(f.version, f.version_line, f.tilt_keyword, f.tilt.lamp_to_luminaire_geometry, f.tilt.angles_deg,
                        f.tilt.factors, f.lamp_count, f.lumens_per_lamp, f.candela_multiplier, f.photometry, f.feet,
                        f.width, f.length, f.height, f.ballast_factor, f.field_12, f.input_watts, f.vertical_deg,
                        f.horizontal_deg, f.candela);
    };
    return rest(a) == rest(b) &&
           std::equal(a.keywords.begin(), a.keywords.end(), b.keywords.begin(), b.keywords.end(), keywords);
}

inline bool equal(const LdtFile& a, const LdtFile& b) {
    const auto set = [](const LdtLampSet& s) {
        return std::tie(s.lamp_count, s.lamp_type, s.flux_lm, s.color_temperature, s.color_rendering, s.input_watts);
    };
    const auto rest = [](const LdtFile& f) {
        return std::tie(
            f.company, f.type_indicator, f.symmetry, f.plane_count, f.plane_step_deg, f.gamma_count, f.gamma_step_deg,
            f.report_number, f.luminaire_name, f.luminaire_number, f.file_name, f.date_user, f.length_mm, f.width_mm,
            f.height_mm, f.luminous_length_mm, f.luminous_width_mm, f.luminous_height_c0_mm, f.luminous_height_c90_mm,
            f.luminous_height_c180_mm, f.luminous_height_c270_mm, f.downward_flux_percent, f.light_output_ratio_percent,
            f.conversion_factor, f.tilt_deg, f.direct_ratios, f.planes_deg, f.gammas_deg, f.candela_per_klm);
    };
    return rest(a) == rest(b) &&
           std::equal(a.lamp_sets.begin(), a.lamp_sets.end(), b.lamp_sets.begin(), b.lamp_sets.end(),
                      [&](const LdtLampSet& x, const LdtLampSet& y) { return set(x) == set(y); });
}

// For a TM-33 document the contents are compared, not the layout.
inline bool equal(const Tm33File& a, const Tm33File& b) {
    return a == b;
}

template<class A, class B>
bool equal(const A&, const B&) {
    return false; // different formats
}

inline bool equal(const std::variant<IesFile, LdtFile, Tm33File>& a,
                  const std::variant<IesFile, LdtFile, Tm33File>& b) {
    return std::visit([](const auto& x, const auto& y) { return equal(x, y); }, a, b);
}

} // namespace gonio::test
