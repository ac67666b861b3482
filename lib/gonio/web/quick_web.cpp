#include <gonio/web/kernels_angles.hpp>
#include <gonio/web/quick_web.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace gonio {

namespace {

constexpr std::size_t chunk = 64; // directions
constexpr double most_parts = 4096;
constexpr double close_deg = 2e-9; // to an end of a table: within half of it, a direction's angle counts as on the end
constexpr double angle_error_deg = 1e-12;

} // namespace

QuickWeb::Axis::Axis(std::span<const double> angles) : angles_deg(angles) {
    const double first = angles.front();
    const double last = angles.back();
    surely_from = first + close_deg;
    surely_to = last - close_deg;
    never_below = first - close_deg;
    never_above = last + close_deg;
    narrowest_deg = std::numeric_limits<double>::infinity();
    const std::size_t cells = angles.size() - 1;
    if (cells == 0) {
        per_deg.push_back(0.0); // no angle is surely inside, but each has a cell
        return;
    }
    double widest_deg = 0.0;
    for (std::size_t i = 0; i < cells; ++i) {
        const double width_deg = angles[i + 1] - angles[i];
        per_deg.push_back(1.0 / width_deg);
        narrowest_deg = std::min(narrowest_deg, width_deg);
        widest_deg = std::max(widest_deg, width_deg);
    }
    parts_per_deg = static_cast<double>(cells) / (last - first);
    // Uniform: to the same parts as for the web itself, and then no angle misses its part by more.
    if (widest_deg - narrowest_deg <= 1e-11 * widest_deg) return;
    const double wanted = std::ceil(1.001 * (last - first) / narrowest_deg);
    holds_many = wanted > most_parts;
    const auto parts = static_cast<std::size_t>(std::min(wanted, most_parts));
    parts_per_deg = static_cast<double>(parts) / (last - first);
    std::uint32_t cell = 0;
    for (std::size_t part = 0; part <= parts; ++part) {
        const double from = first + static_cast<double>(part) / parts_per_deg;
        while (cell + 1 < cells && angles[cell + 1] <= from)
            ++cell;
        first_cells.push_back(cell);
    }
}

QuickWeb::QuickWeb(const Web& web)
    : web_(web),
      horizontal_(web.horizontal_deg()),
      vertical_(web.vertical_deg()),
      candela_(web.column(0).data()),
      is_axial_(web.photometry() == Photometry::c && web.stored_symmetry() == Symmetry::axial),
      mirrors_x_(web.photometry() != Photometry::c && mirrored_in_90_270(web.stored_symmetry())),
      mirrors_y_(web.photometry() != Photometry::c && mirrored_in_0_180(web.stored_symmetry())) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < web.horizontal_deg().size(); ++i)
        for (const double cd : web.column(i))
            greatest = std::max(greatest, std::abs(cd));
    weight_error_ = angle_error_deg / std::min(horizontal_.narrowest_deg, vertical_.narrowest_deg);
    margin_cd_ = greatest * (1e-14 + 4.0 * weight_error_);
}

struct QuickWeb::Places {
    std::array<std::uint32_t, chunk> cell;
    std::array<double, chunk> weight;
    std::array<bool, chunk> is_inside;  // surely
    std::array<bool, chunk> is_outside; // surely
};

// An angle that is not surely inside, a NaN too, gets some cell of the axis.
void QuickWeb::locate(const Axis& axis, std::span<const double> angles_deg, Places& places) const {
    const double first = axis.angles_deg.front();
    const auto last_part =
        static_cast<double>(axis.first_cells.empty() ? axis.per_deg.size() - 1 : axis.first_cells.size() - 1);
    std::array<std::uint32_t, chunk> parts;
    for (std::size_t i = 0; i < angles_deg.size(); ++i) {
        const double angle = angles_deg[i];
        // Written so that a NaN becomes 0.
        const double part = (angle - first) * axis.parts_per_deg;
        parts[i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(part > 0.0 ? std::min(part, last_part) : 0.0));
        places.is_inside[i] = angle > axis.surely_from && angle < axis.surely_to;
        places.is_outside[i] = angle < axis.never_below || angle > axis.never_above;
    }
    for (std::size_t i = 0; i < angles_deg.size(); ++i) {
        std::uint32_t cell = parts[i];
        if (!axis.first_cells.empty()) {
            cell = axis.first_cells[cell];
            cell += cell + 1 < axis.per_deg.size() && angles_deg[i] >= axis.angles_deg[cell + 1] ? 1U : 0U;
            while (axis.holds_many && cell + 1 < axis.per_deg.size() && angles_deg[i] >= axis.angles_deg[cell + 1])
                ++cell;
        }
        places.cell[i] = cell;
        places.weight[i] = (angles_deg[i] - axis.angles_deg[cell]) * axis.per_deg[cell];
    }
}

void QuickWeb::fold(std::span<double> c_deg) const {
    // Just before the first plane is just after the last one.
    const double end = horizontal_.never_below + 360.0;
    for (double& c : c_deg) {
        const double folded = c >= -180.0 ? web_.folded_c_deg(c < 0.0 ? c + 360.0 : c) : c;
        c = folded > end ? std::numeric_limits<double>::quiet_NaN() : folded;
    }
}

QuickWeb::Found QuickWeb::between(const Places& rows, const Places& planes, std::size_t at) const {
    const std::size_t row = rows.cell[at];
    const double row_weight = rows.weight[at];
    const auto along_vertical = [&](const double* column) {
        return column[row] + row_weight * (column[row + 1] - column[row]);
    };
    const auto is_between = [&](double weight) { return weight > weight_error_ && weight < 1.0 - weight_error_; };
    if (is_axial_) {
        const bool dark = candela_[row] == 0.0 && candela_[row + 1] == 0.0 && is_between(row_weight);
        return {along_vertical(candela_), dark};
    }
    const double weight = planes.weight[at];
    const double* const low = candela_ + planes.cell[at] * vertical_.angles_deg.size();
    const double* const high = low + vertical_.angles_deg.size();
    const double at_low = along_vertical(low);
    const double cd = at_low + weight * (along_vertical(high) - at_low);
    const bool dark = cd == 0.0 && low[row] == 0.0 && low[row + 1] == 0.0 && high[row] == 0.0 && high[row + 1] == 0.0 &&
                      is_between(row_weight) && is_between(weight);
    return {cd, dark};
}

void QuickWeb::candela(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                       std::span<double> to, std::span<char> is_exact) const {
    static const web_detail::AngleKernels& kernels = web_detail::angle_kernels(simd::best_available());
    // Latitude from the polar axis or from the equator, and longitude about the axis: type A has its poles up and down,
    // type B to the left and right, type C at the nadir and the zenith.
    const Photometry type = web_.photometry();
    const bool type_c = type == Photometry::c;
    std::array<double, chunk> right;
    std::array<double, chunk> up;
    std::array<double, chunk> ahead;
    std::array<double, chunk> across;
    std::array<double, chunk> latitude_deg;
    std::array<double, chunk> longitude_deg;
    Places rows;
    Places planes;
    const double* const along = type_c ? ahead.data() : type == Photometry::a ? up.data() : right.data();
    const double* const beside = type == Photometry::a ? right.data() : up.data();
    const double* const before = type_c ? right.data() : ahead.data();
    for (std::size_t begin = 0; begin < to.size(); begin += chunk) {
        const std::size_t count = std::min(chunk, to.size() - begin);
        const double* const xs = x.data() + begin;
        const double* const ys = y.data() + begin;
        const double* const zs = z.data() + begin;
        for (std::size_t i = 0; i < count; ++i) {
            right[i] = mirrors_x_ ? std::abs(xs[i]) : xs[i];
            up[i] = mirrors_y_ ? std::abs(ys[i]) : ys[i];
            ahead[i] = -zs[i];
        }
        for (std::size_t i = 0; i < count; ++i)
            across[i] = std::sqrt(beside[i] * beside[i] + before[i] * before[i]);
        if (type_c)
            kernels.angles_deg(count, across.data(), along, latitude_deg.data());
        else
            kernels.angles_deg(count, along, across.data(), latitude_deg.data());
        if (!is_axial_) kernels.angles_deg(count, beside, before, longitude_deg.data());
        if (type_c && !is_axial_) fold({longitude_deg.data(), count});
        const bool stands = type_c || type == Photometry::a; // rows are latitudes
        locate(vertical_, {stands ? latitude_deg.data() : longitude_deg.data(), count}, rows);
        if (!is_axial_) locate(horizontal_, {stands ? longitude_deg.data() : latitude_deg.data(), count}, planes);
        for (std::size_t i = 0; i < count; ++i) {
            // At the poles, the longitude is that of a rounding.
            const bool is_clear = across[i] > 1e-10 * std::abs(along[i]);
            const bool in_rows = is_clear && rows.is_inside[i];
            Found found;
            if (in_rows && (is_axial_ || planes.is_inside[i]))
                found = between(rows, planes, i);
            else if (!(is_clear && rows.is_outside[i]) && !(in_rows && !is_axial_ && planes.is_outside[i]))
                found.candela = web_.candela(glm::dvec3(xs[i], ys[i], zs[i]));
            to[begin + i] = found.candela;
            if (!is_exact.empty()) is_exact[begin + i] = found.is_exact ? 1 : 0;
        }
    }
}

void QuickWeb::candela(std::span<const glm::dvec3> directions, std::span<double> to, std::span<char> is_exact) const {
    std::array<double, chunk> x;
    std::array<double, chunk> y;
    std::array<double, chunk> z;
    for (std::size_t begin = 0; begin < to.size(); begin += chunk) {
        const std::size_t count = std::min(chunk, to.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = directions[begin + i].x;
            y[i] = directions[begin + i].y;
            z[i] = directions[begin + i].z;
        }
        candela({x.data(), count}, {y.data(), count}, {z.data(), count}, to.subspan(begin, count),
                is_exact.empty() ? is_exact : is_exact.subspan(begin, count));
    }
}

} // namespace gonio
