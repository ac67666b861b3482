#include <gonio/base/sort_unique.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/plane_range.hpp>
#include <gonio/web/plane_rows.hpp>
#include <gonio/web/symmetry.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace gonio {

namespace {

// A table with different first and last planes a full turn apart jumps there, and no mirror maps that jump to another.
bool closes(const Web& web, double limit_cd) {
    const std::span<const double> planes = web.planes_deg();
    if (web.stored_symmetry() != Symmetry::none || planes.back() - planes.front() < 360.0 - 1e-9) return true;
    const std::span<const double> first = web.column(0);
    const std::span<const double> last = web.column(planes.size() - 1);
    for (std::size_t j = 0; j < first.size(); ++j)
        if (std::abs(first[j] - last[j]) > limit_cd) return false;
    return true;
}

// Whether a web of type A or B equals its mirror image with H (`across`) or V negated.
bool mirrors_native(const Web& web, double limit_cd, bool across) {
    for (const double h : web.horizontal_deg())
        for (const double v : web.vertical_deg())
            for (const double sign : {-1.0, 1.0}) {
                // The mirror image bends at the images of the grid's angles.
                const double at_h = across ? sign * h : h;
                const double at_v = across ? v : sign * v;
                const double image = web.candela_at(across ? -at_h : at_h, across ? at_v : -at_v);
                if (std::abs(web.candela_at(at_h, at_v) - image) > limit_cd) return false;
            }
    return true;
}

Symmetry combined(bool across_0_180, bool across_90_270) {
    if (across_0_180 && across_90_270) return Symmetry::quadrant;
    if (across_0_180) return Symmetry::bilateral_0_180;
    return across_90_270 ? Symmetry::bilateral_90_270 : Symmetry::none;
}

// Whether I(C) = I(mirror(C)) for every C: both sides are piecewise linear and bend only at the listed angles.
template<class Mirror>
bool mirrors(const Web& web, const std::vector<double>& bends, double limit_cd, Mirror&& mirror) {
    const web_detail::PlaneRows rows(web, web.gammas_deg());
    std::vector<double> here;
    std::vector<double> there;
    for (const double c : bends) {
        here.clear();
        there.clear();
        rows.append(c, here);
        rows.append(mirror(c), there);
        for (std::size_t j = 0; j < here.size(); ++j)
            if (std::abs(here[j] - there[j]) > limit_cd) return false;
    }
    return true;
}

// The angles on both sides of a mirrored axis, folded to its positive side, including 0.
std::vector<double> folded(std::span<const double> angles) {
    std::vector<double> all{0.0};
    for (const double angle : angles)
        all.push_back(std::abs(angle));
    sort_unique(all);
    return all;
}

std::vector<double> unfolded(std::span<const double> angles) {
    std::vector<double> all(angles.begin(), angles.end());
    for (const double angle : angles)
        if (angle > 0.0) all.push_back(-angle);
    std::sort(all.begin(), all.end());
    return all;
}

// The web's intensities at the angles of another grid of the same type, on which they are exact.
Web on_grid(const Web& web, Symmetry stored, std::vector<double> horizontal, std::vector<double> vertical) {
    std::vector<double> candela;
    candela.reserve(horizontal.size() * vertical.size());
    for (const double h : horizontal)
        for (const double v : vertical)
            candela.push_back(web.candela_at(h, v));
    Result<Web> made =
        Web::create(web.photometry(), stored, std::move(horizontal), std::move(vertical), std::move(candela));
    if (!made) return web;
    return std::move(*made);
}

// Whether the stored planes cover the full circle: a gap is dark and ends in a jump that another set of planes may not
// have.
bool covers_circle(const Web& web) {
    const std::span<const double> planes = web.planes_deg();
    if (web.stored_symmetry() == Symmetry::axial) return true;
    if (web.stored_symmetry() == Symmetry::none) return planes.back() - planes.front() >= 360.0 - 1e-9;
    const AngleRange range = plane_range(web.stored_symmetry());
    return planes.front() == range.low && planes.back() == range.high;
}

// The candidate planes within the range of a symmetry, and the ends of the range.
std::vector<double> planes_within(const std::vector<double>& candidates, AngleRange range) {
    std::vector<double> planes{range.low, range.high};
    for (const double c : candidates)
        if (c > range.low && c < range.high) planes.push_back(c);
    sort_unique(planes);
    return planes;
}

bool agree(const Web& a, const Web& b, const std::vector<double>& bends, double limit_cd) {
    for (const double c : bends)
        for (const double gamma : a.gammas_deg())
            if (std::abs(a.candela(c, gamma) - b.candela(c, gamma)) > limit_cd) return false;
    return true;
}

Web compacted_c(const Web& web, Symmetry symmetry, double limit_cd) {
    const std::vector<double> gammas(web.gammas_deg().begin(), web.gammas_deg().end());
    if (!covers_circle(web)) return web;
    if (symmetry == Symmetry::axial) return on_grid(web, symmetry, {0.0}, gammas);
    const AngleRange range = plane_range(symmetry);
    std::vector<double> own;
    for (const double c : web.planes_deg())
        own.push_back(c);
    const std::vector<double> bends = plane_bends_deg(web);
    Web compact = on_grid(web, symmetry, planes_within(own, range), gammas);
    if (agree(web, compact, bends, limit_cd)) return compact;
    return on_grid(web, symmetry, planes_within(bends, range), gammas);
}

} // namespace

std::vector<double> plane_bends_deg(const Web& web) {
    std::vector<double> all;
    for (const double c : web.planes_deg())
        for (const double image : {c, 180.0 - c, 180.0 + c, 360.0 - c})
            all.push_back(std::fmod(image + 720.0, 360.0));
    sort_unique(all);
    return all;
}

Symmetry detected_symmetry(const Web& web, double tolerance) {
    if (web.stored_symmetry() == Symmetry::axial) return Symmetry::axial;
    const double limit = tolerance * std::abs(peak(web).intensity.value);
    if (web.photometry() != Photometry::c)
        return combined(mirrors_native(web, limit, false), mirrors_native(web, limit, true));
    const std::vector<double> bends = plane_bends_deg(web);
    if (!closes(web, limit)) return Symmetry::none;
    if (mirrors(web, bends, limit, [&](double) { return bends.front(); })) return Symmetry::axial;
    return combined(mirrors(web, bends, limit, [](double c) { return 360.0 - c; }),
                    mirrors(web, bends, limit, [](double c) { return 540.0 - c; }));
}

Web compacted(const Web& web, double tolerance) {
    const Symmetry symmetry = detected_symmetry(web, tolerance);
    const Symmetry stored = web.stored_symmetry();
    if (symmetry == stored) return web;
    if (web.photometry() == Photometry::c)
        return compacted_c(web, symmetry, tolerance * std::abs(peak(web).intensity.value));
    // Existing mirrors are kept: every stored mirror is also detected.
    std::vector<double> horizontal(web.horizontal_deg().begin(), web.horizontal_deg().end());
    std::vector<double> vertical(web.vertical_deg().begin(), web.vertical_deg().end());
    if (mirrored_in_90_270(symmetry) && !mirrored_in_90_270(stored)) horizontal = folded(web.horizontal_deg());
    if (mirrored_in_0_180(symmetry) && !mirrored_in_0_180(stored)) vertical = folded(web.vertical_deg());
    return on_grid(web, symmetry, std::move(horizontal), std::move(vertical));
}

Web expanded(const Web& web) {
    const Symmetry stored = web.stored_symmetry();
    if (stored == Symmetry::none) return web;
    std::vector<double> vertical(web.vertical_deg().begin(), web.vertical_deg().end());
    if (web.photometry() != Photometry::c) {
        std::vector<double> horizontal(web.horizontal_deg().begin(), web.horizontal_deg().end());
        if (stored != Symmetry::bilateral_0_180) {
            if (horizontal.front() > 0.0) return web;
            horizontal = unfolded(horizontal);
        }
        if (stored != Symmetry::bilateral_90_270) {
            if (vertical.front() > 0.0) return web;
            vertical = unfolded(vertical);
        }
        return on_grid(web, Symmetry::none, std::move(horizontal), std::move(vertical));
    }
    if (!covers_circle(web)) return web;
    std::vector<double> planes{0.0, 360.0};
    if (stored != Symmetry::axial)
        for (const double c : web.planes_deg()) {
            planes.push_back(std::fmod(c, 360.0));
            if (stored != Symmetry::bilateral_90_270) planes.push_back(360.0 - c);
            if (stored == Symmetry::bilateral_90_270) planes.push_back(std::fmod(540.0 - c, 360.0));
            if (stored == Symmetry::quadrant) {
                planes.push_back(180.0 - c);
                planes.push_back(180.0 + c);
            }
        }
    sort_unique(planes);
    return on_grid(web, Symmetry::none, std::move(planes), std::move(vertical));
}

} // namespace gonio
