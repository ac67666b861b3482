#include <gonio/base/amount_range.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/plane_range.hpp>
#include <gonio/web/web.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gonio {

namespace {

bool strictly_ascending(const std::vector<double>& angles) {
    for (std::size_t i = 0; i < angles.size(); ++i) {
        if (!std::isfinite(angles[i])) return false;
        if (i > 0 && !(angles[i] > angles[i - 1])) return false;
    }
    return !angles.empty();
}

// The range in which planes may be listed: without symmetry they need not begin at 0°.
AngleRange listed_range(Symmetry stored) {
    const bool free = stored == Symmetry::axial || stored == Symmetry::none;
    return free ? AngleRange{-360.0, 720.0} : plane_range(stored);
}

Result<void> check_angles(const std::vector<double>& horizontal, const char* horizontal_name,
                          const std::vector<double>& vertical, const char* vertical_name,
                          const std::vector<double>& candela) {
    if (!strictly_ascending(horizontal))
        return fail(Failure::malformed,
                    fmt::format("the {} are not strictly ascending finite angles", horizontal_name));
    if (!strictly_ascending(vertical))
        return fail(Failure::malformed, fmt::format("the {} are not strictly ascending finite angles", vertical_name));
    if (candela.size() / vertical.size() != horizontal.size() || candela.size() % vertical.size() != 0)
        return fail(Failure::malformed,
                    fmt::format("{} {} and {} {} need {} candela values, not {}", horizontal.size(), horizontal_name,
                                vertical.size(), vertical_name, horizontal.size() * vertical.size(), candela.size()));
    bool in_range = true; // without a branch for each: nearly every table is
    for (const double cd : candela)
        in_range = in_range & in_amount_range(cd);
    if (in_range) return {};
    const auto wrong = std::find_if_not(candela.begin(), candela.end(), in_amount_range);
    if (wrong != candela.end())
        return fail(Failure::malformed,
                    fmt::format("an intensity of {} cd is not a finite number up to {} cd", *wrong, greatest_amount));
    return {};
}

// Checks the range of LM-75's angles of types A and B: `mirrored` angles are stored on their positive side only.
Result<void> check_range(const std::vector<double>& angles, const char* name, double limit, bool mirrored) {
    const double low = mirrored ? 0.0 : -limit;
    if (angles.front() >= low && angles.back() <= limit) return {};
    return fail(Failure::malformed, fmt::format("the {} run from {}° to {}°, outside {}° to {}°", name, angles.front(),
                                                angles.back(), low, limit));
}

// A direction's angle may miss the end of the table by rounding: within 1e-9° it counts as on the end.
double onto_the_end(double angle_deg, const std::vector<double>& angles_deg) {
    for (const double end : {angles_deg.front(), angles_deg.back()})
        if (std::abs(angle_deg - end) <= 1e-9) return end;
    return angle_deg;
}

} // namespace

const char* to_text(Symmetry symmetry) {
    switch (symmetry) {
    case Symmetry::axial:
        return "axial";
    case Symmetry::quadrant:
        return "quadrant";
    case Symmetry::bilateral_0_180:
        return "bilateral-0-180";
    case Symmetry::bilateral_90_270:
        return "bilateral-90-270";
    case Symmetry::none:
        break;
    }
    return "none";
}

double image_count(Symmetry stored) {
    switch (stored) {
    case Symmetry::quadrant:
        return 4.0;
    case Symmetry::bilateral_0_180:
    case Symmetry::bilateral_90_270:
        return 2.0;
    case Symmetry::axial:
    case Symmetry::none:
        break;
    }
    return 1.0;
}

Web::Axis::Axis(std::vector<double> angles) : angles_deg(std::move(angles)) {
    const std::size_t cells = angles_deg.size() - 1;
    if (cells == 0) return;
    const double step = (angles_deg.back() - angles_deg.front()) / static_cast<double>(cells);
    for (std::size_t i = 0; i <= cells; ++i) {
        const double even = angles_deg.front() + step * static_cast<double>(i);
        if (std::abs(angles_deg[i] - even) > 1e-9 * step) return;
    }
    cells_per_deg = 1.0 / step;
}

bool Web::Axis::locate(double angle_deg, std::size_t& cell, double& weight) const {
    // Written so that a NaN fails.
    if (!(angle_deg >= angles_deg.front() && angle_deg <= angles_deg.back())) return false;
    const std::size_t last = angles_deg.size() - 1;
    if (last == 0) {
        cell = 0;
        weight = 0.0;
        return true;
    }
    if (cells_per_deg > 0.0) {
        cell = std::min(static_cast<std::size_t>((angle_deg - angles_deg.front()) * cells_per_deg), last - 1);
        // The product may round across a grid line.
        if (angle_deg < angles_deg[cell]) --cell;
        if (cell + 1 < last && angle_deg >= angles_deg[cell + 1]) ++cell;
    } else {
        const auto above = std::upper_bound(angles_deg.begin(), angles_deg.end(), angle_deg);
        cell = std::min(static_cast<std::size_t>(above - angles_deg.begin()), last) - 1;
    }
    weight = (angle_deg - angles_deg[cell]) / (angles_deg[cell + 1] - angles_deg[cell]);
    return true;
}

Web::Web(Photometry photometry, Symmetry stored, Axis planes, Axis gammas, std::vector<double> candela)
    : photometry_(photometry),
      stored_(stored),
      planes_(std::move(planes)),
      gammas_(std::move(gammas)),
      candela_(std::move(candela)) {}

Result<Web> Web::create(Symmetry stored, std::vector<double> planes_deg, std::vector<double> gammas_deg,
                        std::vector<double> candela) {
    if (Result<void> checked = check_angles(planes_deg, "C-planes", gammas_deg, "gamma angles", candela); !checked)
        return pass_on(checked);
    if (gammas_deg.front() < 0.0 || gammas_deg.back() > 180.0)
        return fail(Failure::malformed, fmt::format("gamma angles run from {}° to {}°, outside 0°–180°",
                                                    gammas_deg.front(), gammas_deg.back()));
    const AngleRange range = listed_range(stored);
    if (planes_deg.front() < range.low || planes_deg.back() > range.high ||
        planes_deg.back() - planes_deg.front() > 360.0 + 1e-9)
        return fail(Failure::malformed, fmt::format("C-planes from {}° to {}° do not match a web of symmetry {}",
                                                    planes_deg.front(), planes_deg.back(), to_text(stored)));
    if (stored == Symmetry::axial && planes_deg.size() != 1)
        return fail(Failure::malformed, "an axial web has one plane");
    return Web(Photometry::c, stored, Axis(std::move(planes_deg)), Axis(std::move(gammas_deg)), std::move(candela));
}

Result<Web> Web::create(Photometry photometry, Symmetry stored, std::vector<double> horizontal_deg,
                        std::vector<double> vertical_deg, std::vector<double> candela) {
    if (photometry == Photometry::c)
        return create(stored, std::move(horizontal_deg), std::move(vertical_deg), std::move(candela));
    const bool a = photometry == Photometry::a;
    Result<void> checked = check_angles(horizontal_deg, "horizontal angles", vertical_deg, "vertical angles", candela);
    if (checked)
        checked = check_range(horizontal_deg, "horizontal angles", a ? 180.0 : 90.0, mirrored_in_90_270(stored));
    if (checked) checked = check_range(vertical_deg, "vertical angles", a ? 90.0 : 180.0, mirrored_in_0_180(stored));
    if (!checked) return pass_on(checked);
    if (stored == Symmetry::axial)
        return fail(Failure::malformed, fmt::format("a web of type {} cannot be stored as axial", a ? 'A' : 'B'));
    return Web(photometry, stored, Axis(std::move(horizontal_deg)), Axis(std::move(vertical_deg)), std::move(candela));
}

double Web::folded_c_deg(double c_deg) const {
    double c = c_deg;
    if (!(c >= 0.0 && c < 360.0)) {
        c = std::fmod(c, 360.0);
        if (c < 0.0) c += 360.0;
    }
    switch (stored_) {
    case Symmetry::axial:
        return planes_.angles_deg.front();
    case Symmetry::quadrant:
        if (c > 180.0) c = 360.0 - c;
        return c > 90.0 ? 180.0 - c : c;
    case Symmetry::bilateral_0_180:
        return c > 180.0 ? 360.0 - c : c;
    case Symmetry::bilateral_90_270:
        if (c < 90.0) return 180.0 - c;
        return c > 270.0 ? 540.0 - c : c;
    case Symmetry::none:
        break;
    }
    // The planes may begin anywhere: use the turn that starts at the first plane.
    const double first = planes_.angles_deg.front();
    while (c < first)
        c += 360.0;
    while (c >= first + 360.0)
        c -= 360.0;
    return c;
}

double Web::folded_horizontal_deg(double horizontal_deg) const {
    if (photometry_ == Photometry::c) return folded_c_deg(horizontal_deg);
    return mirrored_in_90_270(stored_) ? std::abs(horizontal_deg) : horizontal_deg;
}

double Web::folded_vertical_deg(double vertical_deg) const {
    return photometry_ != Photometry::c && mirrored_in_0_180(stored_) ? std::abs(vertical_deg) : vertical_deg;
}

double Web::interpolate(double horizontal_deg, double vertical_deg) const {
    std::size_t row = 0;
    double row_weight = 0.0;
    if (!gammas_.locate(vertical_deg, row, row_weight)) return 0.0;
    std::size_t plane = 0;
    double plane_weight = 0.0;
    if (!planes_.locate(horizontal_deg, plane, plane_weight)) return 0.0;

    // With a weight of 0 the neighbour is not accessed, because it may not exist.
    const auto along_vertical = [&](std::size_t p) {
        const std::span<const double> values = column(p);
        return row_weight == 0.0 ? values[row] : values[row] + row_weight * (values[row + 1] - values[row]);
    };
    const double low = along_vertical(plane);
    return plane_weight == 0.0 ? low : low + plane_weight * (along_vertical(plane + 1) - low);
}

double Web::candela_at(double horizontal_deg, double vertical_deg) const {
    if (!std::isfinite(horizontal_deg)) return 0.0;
    return interpolate(folded_horizontal_deg(horizontal_deg), folded_vertical_deg(vertical_deg));
}

double Web::candela(double c_deg, double gamma_deg) const {
    if (photometry_ == Photometry::c) return candela_at(c_deg, gamma_deg);
    if (!std::isfinite(c_deg) || !(gamma_deg >= 0.0 && gamma_deg <= 180.0)) return 0.0;
    return candela(direction_of(Photometry::c, {c_deg, gamma_deg}));
}

double Web::candela(const glm::dvec3& direction) const {
    if (photometry_ != Photometry::c) {
        const glm::dvec3 folded(mirrored_in_90_270(stored_) ? std::abs(direction.x) : direction.x,
                                mirrored_in_0_180(stored_) ? std::abs(direction.y) : direction.y, direction.z);
        const GoniometerAngles angles = angles_of(photometry_, folded);
        return interpolate(onto_the_end(angles.horizontal_deg, planes_.angles_deg),
                           onto_the_end(angles.vertical_deg, gammas_.angles_deg));
    }
    if (stored_ == Symmetry::axial) {
        const Radians gamma(std::atan2(std::hypot(direction.x, direction.y), -direction.z));
        return candela(0.0, to_degrees(gamma));
    }
    const PolarAngles angles = angles_of(direction);
    return candela(to_degrees(angles.c), to_degrees(angles.gamma));
}

Web Web::scaled(double factor) const {
    Web copy = *this;
    for (double& cd : copy.candela_)
        cd *= factor;
    return copy;
}

} // namespace gonio
