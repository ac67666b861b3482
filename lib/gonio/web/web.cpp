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

struct Range {
    double low;
    double high;
};

// Where the planes of a symmetry may lie.
Range plane_range(Symmetry symmetry) {
    switch (symmetry) {
    case Symmetry::quadrant:
        return {0.0, 90.0};
    case Symmetry::bilateral_0_180:
        return {0.0, 180.0};
    case Symmetry::bilateral_90_270:
        return {90.0, 270.0};
    case Symmetry::axial:
    case Symmetry::none:
        break;
    }
    return {-360.0, 720.0};
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
    // Written so that NaN fails.
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

Web::Web(Symmetry stored, Axis planes, Axis gammas, std::vector<double> candela)
    : stored_(stored), planes_(std::move(planes)), gammas_(std::move(gammas)), candela_(std::move(candela)) {}

Result<Web> Web::create(Symmetry stored, std::vector<double> planes_deg, std::vector<double> gammas_deg,
                        std::vector<double> candela) {
    if (!strictly_ascending(planes_deg))
        return fail(Failure::malformed, "the C-planes are not strictly ascending finite angles");
    if (!strictly_ascending(gammas_deg))
        return fail(Failure::malformed, "the gamma angles are not strictly ascending finite angles");
    if (gammas_deg.front() < 0.0 || gammas_deg.back() > 180.0)
        return fail(Failure::malformed, fmt::format("gamma angles run from {}° to {}°, outside 0°–180°",
                                                    gammas_deg.front(), gammas_deg.back()));
    const Range range = plane_range(stored);
    if (planes_deg.front() < range.low || planes_deg.back() > range.high ||
        planes_deg.back() - planes_deg.front() > 360.0 + 1e-9)
        return fail(Failure::malformed, fmt::format("C-planes from {}° to {}° do not fit a web of symmetry {}",
                                                    planes_deg.front(), planes_deg.back(), to_text(stored)));
    if (stored == Symmetry::axial && planes_deg.size() != 1)
        return fail(Failure::malformed, "an axial web has one plane");
    if (candela.size() / gammas_deg.size() != planes_deg.size() || candela.size() % gammas_deg.size() != 0)
        return fail(Failure::malformed,
                    fmt::format("{} planes of {} gamma angles need {} candela values, not {}", planes_deg.size(),
                                gammas_deg.size(), planes_deg.size() * gammas_deg.size(), candela.size()));
    if (!std::all_of(candela.begin(), candela.end(), [](double cd) { return std::isfinite(cd); }))
        return fail(Failure::malformed, "a candela value is not finite");
    return Web(stored, Axis(std::move(planes_deg)), Axis(std::move(gammas_deg)), std::move(candela));
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
    // The planes may begin anywhere: the one turn that starts at the first plane.
    const double first = planes_.angles_deg.front();
    while (c < first)
        c += 360.0;
    while (c >= first + 360.0)
        c -= 360.0;
    return c;
}

double Web::candela(double c_deg, double gamma_deg) const {
    std::size_t row = 0;
    double row_weight = 0.0;
    if (!gammas_.locate(gamma_deg, row, row_weight) || !std::isfinite(c_deg)) return 0.0;
    std::size_t plane = 0;
    double plane_weight = 0.0;
    if (!planes_.locate(folded_c_deg(c_deg), plane, plane_weight)) return 0.0;

    // A weight of 0 does not touch its neighbour, which may not exist.
    const auto along_gamma = [&](std::size_t p) {
        const std::span<const double> values = column(p);
        return row_weight == 0.0 ? values[row] : values[row] + row_weight * (values[row + 1] - values[row]);
    };
    const double low = along_gamma(plane);
    return plane_weight == 0.0 ? low : low + plane_weight * (along_gamma(plane + 1) - low);
}

double Web::candela(const glm::dvec3& direction) const {
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
