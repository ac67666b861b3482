// Checks a EULUMDAT table that could be read for anything odd.
#include <gonio/profile/parse.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace gonio::profile_detail {

void check_ldt(const LdtFile& file, const LdtPlaces& places, Report& report) {
    const double first = file.gammas_deg.front();
    const double last = file.gammas_deg.back();
    const bool begins = first == 0.0 || first == 90.0;
    if (!begins || (last != 90.0 && last != 180.0))
        report.add("LDT0308", begins ? places.last_vertical : places.vertical,
                   fmt::format("gamma angles from {} to {}: there is no light outside them", first, last),
                   "they begin at 0 or 90 and end at 90 or 180");
    if (places.first_negative != no_place) report.add("LDT0401", places.first_negative, "a negative intensity");
    const Poles poles = look_at_poles(file.gammas_deg, file.candela_per_klm, places.peak);
    if (poles.all_zero) report.add("LDT0402", places.candela, "every intensity is zero");
    if (poles.differ()) report.add("LDT0403", places.candela, poles.difference());
    const std::vector<double>& ratios = file.direct_ratios;
    if (std::all_of(ratios.begin(), ratios.end(), [](double r) { return r == 0.0; }))
        report.add("LDT0404", places.direct_ratios, "the ten direct ratios are zero");
    if (file.light_output_ratio_percent == 0.0)
        report.add("LDT0405", places.light_output_ratio, "the light output ratio is zero");
    const bool absolute = std::any_of(file.lamp_sets.begin(), file.lamp_sets.end(),
                                      [](const LdtLampSet& set) { return set.lamp_count < 0; });
    if (absolute && file.light_output_ratio_percent != 0.0 && file.light_output_ratio_percent != 100.0)
        report.add(
            "LDT0408", places.light_output_ratio,
            fmt::format("absolute photometry, but the light output ratio is {}", file.light_output_ratio_percent));
    if (file.conversion_factor != 1.0)
        report.add("LDT0406", places.conversion_factor,
                   fmt::format("the conversion factor is {}", file.conversion_factor));
    if (file.tilt_deg != 0.0)
        report.add("LDT0407", places.tilt, fmt::format("measured with a tilt of {}", file.tilt_deg));
}

} // namespace gonio::profile_detail
