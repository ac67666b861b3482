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

// Whether a web of type A or B holds one side of a mirror.
bool is_mirrored(const Web& web, Symmetry mirror) {
    const Symmetry stored = web.stored_symmetry();
    return web.photometry() != Photometry::c && (stored == Symmetry::quadrant || stored == mirror);
}

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
    if (cells == 0) return;
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

std::size_t QuickWeb::Axis::cell(double angle_deg) const {
    const auto part = static_cast<std::size_t>((angle_deg - angles_deg.front()) * parts_per_deg);
    if (first_cells.empty()) return std::min(part, per_deg.size() - 1);
    std::size_t cell = first_cells[part];
    cell += angle_deg >= angles_deg[cell + 1] ? 1U : 0U;
    while (holds_many && angle_deg >= angles_deg[cell + 1])
        ++cell;
    return cell;
}

QuickWeb::QuickWeb(const Web& web)
    : web_(web),
      horizontal_(web.horizontal_deg()),
      vertical_(web.vertical_deg()),
      candela_(web.column(0).data()),
      is_axial_(web.photometry() == Photometry::c && web.stored_symmetry() == Symmetry::axial),
      mirrors_x_(is_mirrored(web, Symmetry::bilateral_90_270)),
      mirrors_y_(is_mirrored(web, Symmetry::bilateral_0_180)) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < web.horizontal_deg().size(); ++i)
        for (const double cd : web.column(i))
            greatest = std::max(greatest, std::abs(cd));
    weight_error_ = angle_error_deg / std::min(horizontal_.narrowest_deg, vertical_.narrowest_deg);
    margin_cd_ = greatest * (1e-14 + 4.0 * weight_error_);
}

// Angles of the grid, with its mirrors applied. A NaN is not known.
QuickWeb::Found QuickWeb::between(double horizontal_deg, double vertical_deg) const {
    if (vertical_deg < vertical_.never_below || vertical_deg > vertical_.never_above) return {0.0, true};
    if (!(vertical_deg > vertical_.surely_from && vertical_deg < vertical_.surely_to)) return {0.0, false, false};
    const std::size_t row = vertical_.cell(vertical_deg);
    const double row_weight = (vertical_deg - vertical_.angles_deg[row]) * vertical_.per_deg[row];
    const auto along_vertical = [&](const double* column) {
        return column[row] + row_weight * (column[row + 1] - column[row]);
    };
    const auto is_between = [&](double weight) { return weight > weight_error_ && weight < 1.0 - weight_error_; };
    if (is_axial_) {
        const bool dark = candela_[row] == 0.0 && candela_[row + 1] == 0.0 && is_between(row_weight);
        return {along_vertical(candela_), dark};
    }
    if (horizontal_deg < horizontal_.never_below || horizontal_deg > horizontal_.never_above) return {0.0, true};
    if (!(horizontal_deg > horizontal_.surely_from && horizontal_deg < horizontal_.surely_to))
        return {0.0, false, false};
    const std::size_t plane = horizontal_.cell(horizontal_deg);
    const double weight = (horizontal_deg - horizontal_.angles_deg[plane]) * horizontal_.per_deg[plane];
    const double* const low = candela_ + plane * vertical_.angles_deg.size();
    const double* const high = low + vertical_.angles_deg.size();
    const double at_low = along_vertical(low);
    const double cd = at_low + weight * (along_vertical(high) - at_low);
    const bool dark = cd == 0.0 && low[row] == 0.0 && low[row + 1] == 0.0 && high[row] == 0.0 && high[row + 1] == 0.0 &&
                      is_between(row_weight) && is_between(weight);
    return {cd, dark};
}

// Type C; C from −180° to 180°.
QuickWeb::Found QuickWeb::folded(double c_deg, double gamma_deg) const {
    if (is_axial_) return between(0.0, gamma_deg);
    if (!(c_deg >= -180.0)) return {0.0, false, false};
    const double folded_deg = web_.folded_c_deg(c_deg < 0.0 ? c_deg + 360.0 : c_deg);
    // Just before the first plane is just after the last one.
    if (folded_deg > horizontal_.never_below + 360.0) return {0.0, false, false};
    return between(folded_deg, gamma_deg);
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
        for (std::size_t i = 0; i < count; ++i) {
            // At the poles, the longitude is that of a rounding.
            Found found{0.0, false, false};
            if (across[i] > 1e-10 * std::abs(along[i]))
                found = type_c                  ? folded(longitude_deg[i], latitude_deg[i])
                        : type == Photometry::a ? between(longitude_deg[i], latitude_deg[i])
                                                : between(latitude_deg[i], longitude_deg[i]);
            if (!found.is_known) found = {web_.candela(glm::dvec3(xs[i], ys[i], zs[i])), true};
            to[begin + i] = found.candela;
            if (!is_exact.empty()) is_exact[begin + i] = found.is_exact ? 1 : 0;
        }
    }
}

} // namespace gonio
