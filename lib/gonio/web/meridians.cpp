#include <gonio/base/sort_unique.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/meridians.hpp>
#include <gonio/web/symmetry.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180.0;
constexpr double turn = 2.0 * pi;

// The angles of types A and B with their mirror images, if the table is stored with a mirror.
std::vector<double> with_mirror(std::span<const double> angles_deg, bool mirrored) {
    std::vector<double> all(angles_deg.begin(), angles_deg.end());
    if (mirrored)
        for (const double angle : angles_deg)
            all.push_back(-angle);
    sort_unique(all);
    return all;
}

} // namespace

Meridians::Meridians(const Web& web) {
    const Photometry type = web.photometry();
    const Symmetry stored = web.stored_symmetry();
    std::vector<double> azimuths_deg;
    std::vector<double> polars_deg; // the table's own angle, ascending with θ
    double polar_zero_deg = 0.0;    // where θ = 0
    if (type == Photometry::c) {
        azimuths_deg = plane_bends_deg(web);
        polars_deg.assign(web.vertical_deg().begin(), web.vertical_deg().end());
    } else {
        const bool mirrors_h = mirrored_in_90_270(stored);
        const bool mirrors_v = mirrored_in_0_180(stored);
        const std::vector<double> h = with_mirror(web.horizontal_deg(), mirrors_h);
        const std::vector<double> v = with_mirror(web.vertical_deg(), mirrors_v);
        const bool a = type == Photometry::a;
        azimuths_deg = a ? h : v;
        polars_deg = a ? v : h;
        polar_zero_deg = -90.0;
        azimuth_0_ = {0.0, 0.0, -1.0};
        azimuth_90_ = a ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        pole_ = a ? glm::dvec3(0.0, -1.0, 0.0) : glm::dvec3(-1.0, 0.0, 0.0);
        // A table of the full circle has both −180° and 180°.
        if (azimuths_deg.size() > 1 && azimuths_deg.back() - azimuths_deg.front() >= 360.0) azimuths_deg.pop_back();
    }
    if (azimuths_deg.empty()) azimuths_deg.push_back(0.0);
    // Images of one angle that differ only by rounding count as one.
    const auto same = [](double a, double b) { return b - a < 1e-9; };
    azimuths_deg.erase(std::unique(azimuths_deg.begin(), azimuths_deg.end(), same), azimuths_deg.end());
    // A sector of more than half a turn would let an outline wrap around the pole unnoticed.
    for (std::size_t i = 0; i < azimuths_deg.size(); ++i) {
        const double next = i + 1 < azimuths_deg.size() ? azimuths_deg[i + 1] : azimuths_deg.front() + 360.0;
        if (next - azimuths_deg[i] > 90.0)
            azimuths_deg.insert(azimuths_deg.begin() + static_cast<std::ptrdiff_t>(i) + 1, azimuths_deg[i] + 90.0);
    }
    for (const double angle : azimuths_deg)
        azimuths_.push_back(angle * radians_per_degree);
    for (const double angle : polars_deg) {
        polars_.push_back((angle - polar_zero_deg) * radians_per_degree);
        cosines_.push_back(std::cos(polars_.back()));
    }

    // I is linear in α inside a sector: its values at the ends follow from two angles inside, where there is no jump.
    std::vector<double> low(polars_.size());
    std::vector<double> high(polars_.size());
    std::vector<char> lit_polars(polars_.size(), 0);
    std::vector<char> lit_sectors(azimuths_.size(), 0);
    for (std::size_t i = 0; i < azimuths_deg.size(); ++i) {
        const double begin = azimuths_deg[i];
        const double width = (i + 1 < azimuths_deg.size() ? azimuths_deg[i + 1] : azimuths_deg.front() + 360.0) - begin;
        const auto at = [&](double share, double polar_deg) {
            double azimuth = begin + share * width;
            if (type == Photometry::c) return web.candela_at(azimuth, polar_deg);
            if (azimuth > 180.0) azimuth -= 360.0;
            return type == Photometry::a ? web.candela_at(azimuth, polar_deg) : web.candela_at(polar_deg, azimuth);
        };
        for (std::size_t j = 0; j < polars_deg.size(); ++j) {
            const double early = at(0.25, polars_deg[j]);
            const double late = at(0.75, polars_deg[j]);
            low[j] = 1.5 * early - 0.5 * late;
            high[j] = 1.5 * late - 0.5 * early;
            if (early != 0.0 || late != 0.0) lit_polars[j] = lit_sectors[i] = 1;
        }
        add_end(low);
        add_end(high);
    }
    find_darkness(lit_polars, lit_sectors);
}

void Meridians::find_darkness(std::span<const char> lit_polars, std::span<const char> lit_sectors) {
    const auto first = std::find(lit_polars.begin(), lit_polars.end(), 1);
    if (first == lit_polars.end()) return;
    const auto last = std::find(lit_polars.rbegin(), lit_polars.rend(), 1);
    const auto from = static_cast<std::size_t>(first - lit_polars.begin());
    const auto to = lit_polars.size() - 1 - static_cast<std::size_t>(last - lit_polars.rbegin());
    lit_polar_from_ = polars_[from > 0 ? from - 1 : 0];
    lit_polar_to_ = polars_[std::min(to + 1, polars_.size() - 1)];
    // The longest cyclic run of dark sectors.
    const std::size_t count = lit_sectors.size();
    for (std::size_t begin = 0; begin < count; ++begin) {
        double width = 0.0;
        for (std::size_t k = 0; k < count && lit_sectors[(begin + k) % count] == 0; ++k) {
            const std::size_t i = (begin + k) % count;
            width += (i + 1 < count ? azimuths_[i + 1] : azimuths_.front() + turn) - azimuths_[i];
        }
        if (width <= dark_azimuth_width_) continue;
        dark_azimuth_begin_ = azimuths_[begin];
        dark_azimuth_width_ = width;
    }
}

Meridians::Patch Meridians::patch(std::size_t sector, std::size_t cell) const {
    const double begin = azimuths_[sector];
    const std::size_t cells = polars_.size() + 1;
    const Piece* const pieces = pieces_.data() + 2 * sector * cells;
    return {begin,
            (sector + 1 < azimuths_.size() ? azimuths_[sector + 1] : azimuths_.front() + turn) - begin,
            cell > 0 ? polars_[cell - 1] : 0.0,
            pieces[cell],
            pieces[cells + cell],
            pieces[cells - 1].constant,
            pieces[2 * cells - 1].constant};
}

void Meridians::add_end(std::span<const double> candela) {
    pieces_.emplace_back(); // before the first break: dark
    double sum = 0.0;
    for (std::size_t j = 0; j < polars_.size(); ++j) {
        if (j + 1 == polars_.size()) {
            pieces_.push_back({0.0, 0.0, sum}); // after the last break
            break;
        }
        const double width = polars_[j + 1] - polars_[j];
        Piece piece;
        piece.slope = (candela[j + 1] - candela[j]) / width;
        piece.intensity = candela[j];
        piece.constant = sum + candela[j] * cosines_[j] - piece.slope * std::sin(polars_[j]);
        pieces_.push_back(piece);
        sum += integrate_linear_sin(polars_[j], polars_[j + 1], candela[j], candela[j + 1]);
    }
}

std::size_t Meridians::sector_of(double azimuth) const {
    const double first = azimuths_.front();
    double from_first = std::fmod(azimuth - first, turn);
    if (from_first < 0.0) from_first += turn;
    const auto above = std::upper_bound(azimuths_.begin() + 1, azimuths_.end(), first + from_first);
    return static_cast<std::size_t>(above - azimuths_.begin()) - 1;
}

std::size_t Meridians::cell_of(double polar) const {
    return static_cast<std::size_t>(std::upper_bound(polars_.begin(), polars_.end(), polar) - polars_.begin());
}

Meridians::Integral Meridians::integral(std::size_t sector, double azimuth, std::size_t cell, double polar,
                                        double cos_polar, double sin_polar) const {
    const double begin = azimuths_[sector];
    const double width = (sector + 1 < azimuths_.size() ? azimuths_[sector + 1] : azimuths_.front() + turn) - begin;
    double from = azimuth - begin;
    from -= turn * std::round((from - 0.5 * width) / turn);
    const double weight = from / width;
    const std::size_t cells = polars_.size() + 1;
    const auto end = [&](std::size_t which) {
        const Piece* const pieces = pieces_.data() + (2 * sector + which) * cells;
        const Piece& piece = pieces[cell];
        const double here = piece.intensity + (cell > 0 ? piece.slope * (polar - polars_[cell - 1]) : 0.0);
        const double integral = piece.constant - here * cos_polar + piece.slope * sin_polar;
        return Integral{integral, integral - pieces[cells - 1].constant};
    };
    const Integral low = end(0);
    const Integral high = end(1);
    return {low.to_here + weight * (high.to_here - low.to_here), low.beyond + weight * (high.beyond - low.beyond)};
}

} // namespace gonio
