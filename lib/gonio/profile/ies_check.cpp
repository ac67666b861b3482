// Checks an LM-63 table that could be read for anything odd.
#include <gonio/profile/parse.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace gonio::profile_detail {

namespace {

bool is_one_of(double value, std::initializer_list<double> values) {
    for (const double v : values)
        if (value == v) return true;
    return false;
}

void check_vertical(const IesFile& file, const TablePlaces& places, Report& report) {
    const double first = file.vertical_deg.front();
    const double last = file.vertical_deg.back();
    const bool c = file.photometry == Photometry::c;
    const double lowest = c ? 0.0 : -90.0;
    const double highest = c ? 180.0 : 90.0;
    if (first < lowest || last > highest) {
        report.add(
            "IES0307", first < lowest ? places.vertical : places.last_vertical,
            fmt::format("vertical angle {} is outside {} to {}", first < lowest ? first : last, lowest, highest));
        return;
    }
    const bool begins = c ? is_one_of(first, {0.0, 90.0}) : is_one_of(first, {-90.0, 0.0});
    const bool ends = c ? is_one_of(last, {90.0, 180.0}) : last == 90.0;
    if (!begins || !ends)
        report.add("IES0305", begins ? places.last_vertical : places.vertical,
                   fmt::format("vertical angles from {} to {}: there is no light outside them", first, last),
                   c ? "type C begins at 0 or 90 and ends at 90 or 180"
                     : "types A and B begin at -90 or 0 and end at 90");
}

void check_horizontal_c(const IesFile& file, const TablePlaces& places, Report& report) {
    const std::vector<double>& planes = file.horizontal_deg;
    const double first = planes.front();
    const double last = planes.back();
    if (planes.size() == 1) {
        if (first != 0.0)
            report.add("IES0308", places.horizontal, fmt::format("the only plane is at {}", first), "write 0");
        return;
    }
    if (first == 90.0 && last == 270.0) {
        if (file.version != IesVersion::lm63_1995)
            report.add("IES0310", places.horizontal,
                       fmt::format("planes from 90 to 270 degrees in {}", to_text(file.version)));
        return;
    }
    const double gap = 360.0 - (last - first);
    const double step = planes[planes.size() - 1] - planes[planes.size() - 2];
    if (first == 0.0 && gap > 0.0 && last > 180.0 && std::abs(gap - step) <= 1e-6 * step) {
        report.add("IES0309", places.last_horizontal,
                   fmt::format("the last plane is at {}, and the one at 360 is missing", last),
                   "repeat the plane at 0 as the plane at 360");
        return;
    }
    if (first != 0.0 || !is_one_of(last, {90.0, 180.0, 360.0}))
        report.add("IES0306", first != 0.0 ? places.horizontal : places.last_horizontal,
                   fmt::format("planes from {} to {}", first, last), "planes run from 0 to 0, 90, 180 or 360");
}

void check_horizontal(const IesFile& file, const TablePlaces& places, Report& report) {
    const double first = file.horizontal_deg.front();
    const double last = file.horizontal_deg.back();
    const bool c = file.photometry == Photometry::c;
    const double lowest = c ? -360.0 : -180.0;
    const double highest = c ? 360.0 : 180.0;
    if (first < lowest || last > highest || last - first > 360.0) {
        report.add("IES0307", first < lowest ? places.horizontal : places.last_horizontal,
                   fmt::format("horizontal angles from {} to {}", first, last));
        return;
    }
    if (c) {
        check_horizontal_c(file, places, report);
    } else if (!is_one_of(first, {-90.0, 0.0}) || last != 90.0) {
        report.add("IES0306", is_one_of(first, {-90.0, 0.0}) ? places.last_horizontal : places.horizontal,
                   fmt::format("horizontal angles from {} to {}", first, last),
                   "types A and B run from -90 or 0 to 90");
    }
}

} // namespace

void check_ies(const IesFile& file, const TablePlaces& places, Report& report) {
    check_vertical(file, places, report);
    check_horizontal(file, places, report);
    if (!ies_opening_shape(file)) {
        const std::optional<OpeningShape> in_1995 = opening_shape_of_1995(file);
        report.add("IES0219", places.shape,
                   fmt::format("width {}, length {} and height {} encode no shape in {}", file.width, file.length,
                               file.height, to_text(file.version)),
                   fmt::format("it is read as a {}; a circle of diameter d is -d -d 0 since 2002 and -d 0 0 before",
                               in_1995 ? fmt::format("{}, as in LM-63-1995", to_text(*in_1995)) : "box"));
    }
    if (places.first_negative != no_place) report.add("IES0401", places.first_negative, "a negative candela value");
    const Poles poles = look_at_poles(file.vertical_deg, file.candela, places.peak);
    if (poles.all_zero) report.add("IES0402", places.candela, "every candela value is zero");
    if (file.photometry != Photometry::c) return;
    if (poles.differ()) report.add("IES0403", places.candela, poles.difference());
    if (file.horizontal_deg.front() == 0.0 && file.horizontal_deg.back() == 360.0) {
        const std::size_t count = file.vertical_deg.size();
        const std::size_t last = file.candela.size() - count;
        const double peak = places.peak;
        double difference = 0.0;
        for (std::size_t i = 0; i < count; ++i)
            difference = std::max(difference, std::abs(file.candela[i] - file.candela[last + i]));
        if (difference > peak * 1e-3)
            report.add("IES0404", places.candela,
                       fmt::format("the planes at 0 and 360 degrees differ by up to {:.4g} cd of a peak of {:.4g}",
                                   difference, peak));
    }
}

} // namespace gonio::profile_detail
