// Checks a TM-33 intensity that could be read for anything odd.
#include <gonio/profile/parse.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gonio::profile_detail {

namespace {

// The symmetry that the range of the planes implies, as in LM-63.
Tm33Symmetry symmetry_of(const std::vector<double>& planes) {
    if (planes.size() == 1) return Tm33Symmetry::full;
    if (planes.front() == 0.0 && planes.back() == 90.0) return Tm33Symmetry::quadrant;
    if (planes.front() == 0.0 && planes.back() == 180.0) return Tm33Symmetry::bilateral_0;
    if (planes.front() == 90.0 && planes.back() == 270.0) return Tm33Symmetry::bilateral_90;
    return Tm33Symmetry::none;
}

void check_planes(const Tm33Intensity& intensity, const Tm33Places& places, Report& report) {
    const std::vector<double>& planes = intensity.horizontal_deg;
    const Tm33Symmetry seen = symmetry_of(planes);
    if (intensity.symmetry && *intensity.symmetry != Tm33Symmetry::arbitrary && *intensity.symmetry != seen)
        report.add(
            "TM30301", places.symmetry,
            fmt::format("the stated symmetry does not match planes from {} to {}", planes.front(), planes.back()));
    const double gap = 360.0 - (planes.back() - planes.front());
    if (seen == Tm33Symmetry::none && planes.front() == 0.0 && planes.back() > 180.0 && gap > 0.0)
        report.add("TM30304", places.table,
                   fmt::format("the last plane is at {}, and the one at 360 is missing", planes.back()));
}

} // namespace

void check_tm33_intensity(const Tm33Emitter& emitter, bool of_type_c, const Tm33Places& places, Report& report) {
    if (!emitter.intensity) return;
    const Tm33Intensity& intensity = *emitter.intensity;
    const std::vector<double>& planes = intensity.horizontal_deg;
    const std::vector<double>& gammas = intensity.vertical_deg;
    if (gammas.front() < -90.0 || gammas.back() > 180.0 || planes.front() < -360.0 || planes.back() > 360.0 ||
        planes.back() - planes.front() > 360.0) {
        report.add("TM30302", places.table,
                   fmt::format("horizontal angles from {} to {}, vertical from {} to {}", planes.front(), planes.back(),
                               gammas.front(), gammas.back()));
        return;
    }
    if (of_type_c) check_planes(intensity, places, report);
    const auto [lowest, highest] = std::minmax_element(intensity.candela.begin(), intensity.candela.end());
    if (*lowest < 0.0) report.add("TM30401", places.table, "a negative intensity");
    const Poles poles = look_at_poles(gammas, intensity.candela, std::max(std::abs(*lowest), std::abs(*highest)));
    if (poles.all_zero) report.add("TM30402", places.table, "every intensity is zero");
    if (of_type_c && poles.differ()) report.add("TM30403", places.table, poles.difference());
}

} // namespace gonio::profile_detail
