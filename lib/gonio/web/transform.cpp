#include <gonio/base/amount_range.hpp>
#include <gonio/base/sort_unique.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/grid.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/plane_range.hpp>
#include <gonio/web/resample_light.hpp>
#include <gonio/web/separable.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/transform.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180.0;

ResampledWeb exact(Web web) {
    return {std::move(web), Candelas(0.0), 0.0, 0.0, Lumens(0.0), Candelas(0.0)};
}

double in_one_turn(double deg) {
    const double turned = std::fmod(deg, 360.0);
    return turned < 0.0 ? turned + 360.0 : turned;
}

// A change of azimuth: the light towards C moves to sign · C + offset.
struct Azimuth {
    double sign = 1.0;
    double offset_deg = 0.0;

    double to(double c_deg) const { return sign * c_deg + offset_deg; }
    double from(double c_deg) const { return sign * (c_deg - offset_deg); }
};

Symmetry swapped(Symmetry symmetry) {
    if (symmetry == Symmetry::bilateral_0_180) return Symmetry::bilateral_90_270;
    return symmetry == Symmetry::bilateral_90_270 ? Symmetry::bilateral_0_180 : symmetry;
}

// Brings C of [0°, 360°) into the range of the planes that a symmetry stores.
double folded(Symmetry symmetry, double c_deg) {
    double c = c_deg;
    if (symmetry == Symmetry::bilateral_90_270) return c < 90.0 ? 180.0 - c : c > 270.0 ? 540.0 - c : c;
    if (c > 180.0) c = 360.0 - c;
    return symmetry == Symmetry::quadrant && c > 90.0 ? 180.0 - c : c;
}

// Removes the rounding error of 360° − offset and similar.
double tidy(double deg) {
    const double even = std::round(deg * 1e9) / 1e9;
    return (std::abs(even - deg) < 1e-12 ? even : deg) + 0.0; // no −0
}

// Type C on the given planes, with the columns of `web` at their original azimuths.
Web on_planes(const Web& web, Symmetry stored, std::vector<double> planes_deg, const Azimuth& azimuth) {
    std::vector<double> candela;
    candela.reserve(planes_deg.size() * web.gammas_deg().size());
    for (const double c : planes_deg) {
        // 360° − offset and similar values have a rounding error: use the table's own plane.
        const double source = std::round(azimuth.from(c) * 1e9) / 1e9;
        for (const double gamma : web.gammas_deg())
            candela.push_back(web.candela(source, gamma));
    }
    std::vector<double> gammas(web.gammas_deg().begin(), web.gammas_deg().end());
    Result<Web> made = Web::create(stored, std::move(planes_deg), std::move(gammas), std::move(candela));
    if (!made) return web;
    return std::move(*made);
}

// The stored planes after a change of azimuth that keeps the mirrors, in the range of `target`. Keeps planes that do
// not reach the ends of the range.
Web permuted_planes(const Web& web, Symmetry target, const Azimuth& azimuth) {
    const std::span<const double> planes = web.planes_deg();
    std::vector<std::pair<double, std::size_t>> moved;
    for (std::size_t i = 0; i < planes.size(); ++i)
        moved.emplace_back(folded(target, in_one_turn(tidy(azimuth.to(planes[i])))), i);
    std::sort(moved.begin(), moved.end());
    std::vector<double> angles;
    std::vector<double> candela;
    for (const auto& [angle, source] : moved) {
        if (!angles.empty() && angle == angles.back()) continue; // differs by less than rounding
        angles.push_back(angle);
        candela.insert(candela.end(), web.column(source).begin(), web.column(source).end());
    }
    std::vector<double> gammas(web.gammas_deg().begin(), web.gammas_deg().end());
    Result<Web> made = Web::create(target, std::move(angles), std::move(gammas), std::move(candela));
    if (!made) return web;
    return std::move(*made);
}

// Planes without symmetry, moved one by one: keeps gaps, and a first plane that differs from the last.
Web moved_planes(const Web& web, const Azimuth& azimuth) {
    const std::span<const double> planes = web.planes_deg();
    const std::size_t count = planes.size();
    std::vector<double> moved(count);
    std::vector<double> candela;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t source = azimuth.sign > 0.0 ? i : count - 1 - i;
        moved[i] = azimuth.to(planes[source]);
        candela.insert(candela.end(), web.column(source).begin(), web.column(source).end());
    }
    const double turn = in_one_turn(moved.front()) - moved.front();
    for (double& c : moved)
        c += turn;
    std::vector<double> gammas(web.gammas_deg().begin(), web.gammas_deg().end());
    Result<Web> made = Web::create(Symmetry::none, std::move(moved), std::move(gammas), std::move(candela));
    if (!made) return web;
    return std::move(*made);
}

bool closes_evenly(const Web& web) {
    const std::span<const double> planes = web.planes_deg();
    if (planes.back() - planes.front() < 360.0 - 1e-9) return false;
    return std::equal(web.column(0).begin(), web.column(0).end(), web.column(planes.size() - 1).begin());
}

bool is_bright(std::span<const double> candela) {
    return std::any_of(candela.begin(), candela.end(), [](double cd) { return cd != 0.0; });
}

// Type C: every C in [0°, 360°) at which the web jumps, because its planes end there at a non-zero value or its last
// plane differs from its first a full turn earlier.
std::vector<double> jumps_deg(const Web& web) {
    const Symmetry stored = web.stored_symmetry();
    const std::span<const double> planes = web.planes_deg();
    const std::size_t last = planes.size() - 1;
    if (stored == Symmetry::axial || (stored == Symmetry::none && closes_evenly(web))) return {};
    const AngleRange range = plane_range(stored);
    const bool turns = stored == Symmetry::none;
    std::vector<double> jumps;
    for (const bool front : {true, false}) {
        const std::size_t end = front ? 0 : last;
        const double c = planes[end];
        if (!turns && c == (front ? range.low : range.high)) continue; // continued by its mirror image
        const bool whole_turn = turns && planes[last] - planes[0] >= 360.0 - 1e-9;
        if (!whole_turn && !is_bright(web.column(end))) continue;
        jumps.push_back(in_one_turn(c));
        if (mirrored_in_0_180(stored)) jumps.push_back(in_one_turn(-c));
        if (mirrored_in_90_270(stored)) jumps.push_back(in_one_turn(180.0 - c));
        if (stored == Symmetry::quadrant) jumps.push_back(in_one_turn(180.0 + c));
    }
    sort_unique(jumps);
    return jumps;
}

// A list of angles in [low, high] between which a function is linear, but with jumps at some of them. A jump is sampled
// on both sides, at a distance of half the ramp that files use. The middle of the ramp is on the jump, so the integral
// does not change. Angles that differ only by rounding count as one.
class RampedAngles {
public:
    RampedAngles(std::vector<double> angles, std::vector<double> jumps, double low, double high)
        : angles_({low}), jumps_(std::move(jumps)), high_(high) {
        std::sort(angles.begin(), angles.end());
        for (const double angle : angles)
            if (angle > angles_.back() + same && angle < high - same) angles_.push_back(angle);
        angles_.push_back(high);
        for (std::size_t i = 0; i + 1 < angles_.size(); ++i)
            off_ = std::min(off_, 0.25 * (angles_[i + 1] - angles_[i]));
    }

    // Calls add(angle, value) in ascending order for every angle of the new table; `value` is computed with `at`, which
    // returns intensities. If the range itself ends in a jump, the value is the limit from within.
    template<class At, class Add>
    void each(const At& at, const Add& add) const {
        for (const double angle : angles_) {
            if (!jumps(angle)) {
                add(angle, at(angle));
            } else if (angle == angles_.front() || angle == high_) {
                const double inwards = angle == high_ ? -off_ : off_;
                std::vector<double> limit = at(angle + inwards);
                const std::vector<double> further = at(angle + 2.0 * inwards);
                for (std::size_t j = 0; j < limit.size(); ++j) {
                    const double linear = 2.0 * limit[j] - further[j];
                    limit[j] = limit[j] >= 0.0 && further[j] >= 0.0 ? std::max(linear, 0.0) : linear;
                }
                add(angle, limit);
            } else {
                add(angle - off_, at(angle - off_));
                add(angle + off_, at(angle + off_));
            }
        }
    }

private:
    static constexpr double same = 1e-9;

    bool jumps(double angle) const {
        return std::any_of(jumps_.begin(), jumps_.end(), [&](double at) { return std::abs(at - angle) <= same; });
    }

    std::vector<double> angles_;
    std::vector<double> jumps_;
    double high_;
    double off_ = 0.5 * web_detail::dark_step_deg;
};

// A type C web with the γ of `web`; `at` returns the intensities of a plane.
template<class At>
Result<Web> on_ramped_planes(const Web& web, Symmetry stored, const RampedAngles& planes, const At& at) {
    std::vector<double> angles;
    std::vector<double> candela;
    planes.each(at, [&](double angle, const std::vector<double>& column) {
        angles.push_back(angle);
        candela.insert(candela.end(), column.begin(), column.end());
    });
    std::vector<double> gammas(web.gammas_deg().begin(), web.gammas_deg().end());
    return Web::create(stored, std::move(angles), std::move(gammas), std::move(candela));
}

// A mirrored web with dark sectors, written out over the full turn, with a ramp for every jump.
Web with_ramps(const Web& web) {
    std::vector<double> jumps = jumps_deg(web);
    if (std::find(jumps.begin(), jumps.end(), 0.0) != jumps.end()) jumps.push_back(360.0);
    const RampedAngles planes(plane_bends_deg(web), std::move(jumps), 0.0, 360.0);
    const auto at = [&](double c) {
        std::vector<double> column;
        for (const double gamma : web.gammas_deg())
            column.push_back(web.candela(c, gamma));
        return column;
    };
    Result<Web> made = on_ramped_planes(web, Symmetry::none, planes, at);
    if (!made) return web;
    return std::move(*made);
}

Web with_azimuth(const Web& web, const Azimuth& azimuth) {
    const Symmetry stored = web.stored_symmetry();
    if (stored == Symmetry::axial) return web;
    if (stored == Symmetry::none && !closes_evenly(web)) return moved_planes(web, azimuth);
    const double quarters = azimuth.offset_deg / 90.0;
    if (stored != Symmetry::none && quarters == std::round(quarters)) {
        const bool odd = std::fmod(std::abs(quarters), 2.0) == 1.0;
        return permuted_planes(web, odd ? swapped(stored) : stored, azimuth);
    }
    if (!jumps_deg(web).empty()) return moved_planes(with_ramps(web), azimuth);
    const Web source = expanded(web);
    std::vector<double> planes{0.0, 360.0};
    for (const double bend : plane_bends_deg(source))
        planes.push_back(in_one_turn(std::round(azimuth.to(bend) * 1e9) / 1e9));
    sort_unique(planes);
    return on_planes(source, Symmetry::none, std::move(planes), azimuth);
}

// Types A and B by (H, V) → (±H, ±V) or (±V, ±H); the latter changes the type.
struct NativeMap {
    bool swap = false;
    double h_sign = 1.0; // of the new H
    double v_sign = 1.0;
};

Web with_native_map(const Web& web, NativeMap map) {
    const Web full = expanded(web);
    const auto signed_angles = [](std::span<const double> angles, double sign) {
        std::vector<double> all(angles.begin(), angles.end());
        for (double& angle : all)
            angle = sign * angle + 0.0; // no −0
        std::sort(all.begin(), all.end());
        return all;
    };
    const std::vector<double> h = signed_angles(map.swap ? full.vertical_deg() : full.horizontal_deg(), map.h_sign);
    const std::vector<double> v = signed_angles(map.swap ? full.horizontal_deg() : full.vertical_deg(), map.v_sign);
    std::vector<double> candela;
    candela.reserve(h.size() * v.size());
    for (const double at_h : h)
        for (const double at_v : v)
            candela.push_back(map.swap ? full.candela_at(map.v_sign * at_v, map.h_sign * at_h)
                                       : full.candela_at(map.h_sign * at_h, map.v_sign * at_v));
    Photometry type = full.photometry();
    if (map.swap) type = type == Photometry::a ? Photometry::b : Photometry::a;
    Result<Web> made = Web::create(type, Symmetry::none, h, v, std::move(candela));
    if (!made) return web;
    return web.stored_symmetry() == Symmetry::none ? std::move(*made) : compacted(*made, 0.0);
}

} // namespace

ResampledWeb rotated(const Web& web, double angle_deg) {
    const double angle = in_one_turn(angle_deg);
    if (angle == 0.0) return exact(web);
    if (web.photometry() == Photometry::c) return exact(with_azimuth(web, {1.0, angle}));
    // A quarter turn moves x to y: the new H is −V, the new V is H.
    if (angle == 90.0) return exact(with_native_map(web, {true, -1.0, 1.0}));
    if (angle == 180.0) return exact(with_native_map(web, {false, -1.0, -1.0}));
    if (angle == 270.0) return exact(with_native_map(web, {true, 1.0, -1.0}));
    web_detail::Light light{[&](double c, double gamma) { return web.candela(c - angle, gamma); }, {}};
    for (const GoniometerAngles at : web_detail::table_directions(web))
        light.points.push_back({at.horizontal_deg + angle, at.vertical_deg});
    return web_detail::resample(light, Symmetry::none, peak(web).intensity, flux(web), resampling_tolerance);
}

Web mirrored(const Web& web, MirrorPlane plane) {
    const bool c0_180 = plane == MirrorPlane::c0_180;
    if (web.photometry() != Photometry::c)
        return with_native_map(web, c0_180 ? NativeMap{false, 1.0, -1.0} : NativeMap{false, -1.0, 1.0});
    return with_azimuth(web, {-1.0, c0_180 ? 0.0 : 180.0});
}

ResampledWeb tilted(const Web& web, double angle_deg, double towards_c_deg, double tolerance) {
    if (angle_deg == 0.0) return exact(web);
    // About the horizontal axis that takes the nadir towards C: a rotation within each plane parallel to C and nadir.
    const double a = angle_deg * radians_per_degree;
    const double c = towards_c_deg * radians_per_degree;
    const auto turned = [&](const glm::dvec3& d, double by) {
        const double along = d.x * std::cos(c) + d.y * std::sin(c);
        const double aside = d.y * std::cos(c) - d.x * std::sin(c);
        const double along_turned = along * std::cos(by) - d.z * std::sin(by);
        const double z = along * std::sin(by) + d.z * std::cos(by);
        return glm::dvec3(along_turned * std::cos(c) - aside * std::sin(c),
                          along_turned * std::sin(c) + aside * std::cos(c), z);
    };
    web_detail::Light light{[&](double at_c, double gamma) {
                                return web.candela(turned(direction_of(Photometry::c, {at_c, gamma}), -a));
                            },
                            {}};
    for (const GoniometerAngles at : web_detail::table_directions(web))
        light.points.push_back(
            angles_of(Photometry::c, turned(direction_of(Photometry::c, {at.horizontal_deg, at.vertical_deg}), a)));
    // Tilting keeps the mirror that contains the direction of the tilt.
    const Symmetry has = detected_symmetry(web);
    const double turn = in_one_turn(towards_c_deg);
    const bool along_c0 = turn == 0.0 || turn == 180.0;
    const bool along_c90 = turn == 90.0 || turn == 270.0;
    const bool any = has == Symmetry::axial || has == Symmetry::quadrant;
    Symmetry stored = Symmetry::none;
    if (along_c0 && (any || has == Symmetry::bilateral_0_180)) stored = Symmetry::bilateral_0_180;
    if (along_c90 && (any || has == Symmetry::bilateral_90_270)) stored = Symmetry::bilateral_90_270;
    return web_detail::resample(light, stored, peak(web).intensity, flux(web), tolerance);
}

Result<Web> symmetrized(const Web& web, Symmetry symmetry) {
    const bool c = web.photometry() == Photometry::c;
    if (symmetry == Symmetry::none) return web;
    if (symmetry == Symmetry::axial && !c)
        return fail(Failure::unsupported, "a web of type A or B cannot be made axial",
                    "resample it to type C first (gonio edit --resample 5deg,2.5deg)");
    const bool across_c0 = mirrored_in_0_180(symmetry);
    const bool across_c90 = mirrored_in_90_270(symmetry);
    if (!c) {
        const Web full = expanded(web);
        std::vector<double> h(full.horizontal_deg().begin(), full.horizontal_deg().end());
        std::vector<double> v(full.vertical_deg().begin(), full.vertical_deg().end());
        // Both signs of the angles; if a table ends at a non-zero value closer to 0 on one side, there is a jump.
        const auto with_images = [](std::vector<double>& angles, bool first_is_bright, bool last_is_bright) {
            std::vector<double> jumps;
            if (first_is_bright) jumps.insert(jumps.end(), {angles.front(), -angles.front()});
            if (last_is_bright) jumps.insert(jumps.end(), {angles.back(), -angles.back()});
            const double most = std::max(std::abs(angles.front()), std::abs(angles.back()));
            if (!(most > 0.0)) return;
            const std::size_t count = angles.size();
            for (std::size_t i = 0; i < count; ++i)
                angles.push_back(-angles[i] + 0.0);
            const RampedAngles both(std::move(angles), std::move(jumps), -most, most);
            angles.clear();
            both.each([](double) { return std::vector<double>{}; },
                      [&](double angle, const std::vector<double>&) { angles.push_back(angle); });
        };
        const auto row_is_bright = [&](std::size_t row) {
            for (std::size_t i = 0; i < full.horizontal_deg().size(); ++i)
                if (full.column(i)[row] != 0.0) return true;
            return false;
        };
        if (across_c90) with_images(h, is_bright(full.column(0)), is_bright(full.column(h.size() - 1)));
        if (across_c0) with_images(v, row_is_bright(0), row_is_bright(v.size() - 1));
        std::vector<double> candela;
        for (const double at_h : h)
            for (const double at_v : v) {
                const double own = full.candela_at(at_h, at_v);
                const double in_h = across_c90 ? full.candela_at(-at_h, at_v) : own;
                const double in_v = across_c0 ? full.candela_at(at_h, -at_v) : own;
                const double in_both = across_c0 && across_c90 ? full.candela_at(-at_h, -at_v)
                                       : across_c90            ? in_h
                                                               : in_v;
                candela.push_back(0.25 * ((own + in_both) + (in_h + in_v)));
            }
        Result<Web> made = Web::create(web.photometry(), Symmetry::none, h, v, std::move(candela));
        return made ? compacted(*made) : web;
    }
    const std::vector<double> bends = plane_bends_deg(web);
    std::vector<double> gammas(web.gammas_deg().begin(), web.gammas_deg().end());
    std::vector<double> candela;
    if (symmetry == Symmetry::axial) {
        const Terms circle = plane_terms(web, bends, 0.0, 360.0);
        for (std::size_t j = 0; j < gammas.size(); ++j) {
            double sum = 0.0;
            for (const Term& term : circle)
                sum += term.weight * web.column(term.index)[j];
            candela.push_back(sum / (2.0 * pi));
        }
        return Web::create(symmetry, {0.0}, std::move(gammas), std::move(candela));
    }
    const std::vector<double> jumps = jumps_deg(web);
    if (!jumps.empty() && web.stored_symmetry() == symmetry) return web;
    const AngleRange range = plane_range(symmetry);
    const auto within_range = [&](const std::vector<double>& angles) {
        std::vector<double> images;
        for (const double angle : angles)
            for (const double image :
                 {angle, in_one_turn(360.0 - angle), in_one_turn(540.0 - angle), in_one_turn(180.0 + angle)})
                if (image >= range.low && image <= range.high) images.push_back(image);
        return images;
    };
    const auto mean = [&](double at, double gamma) {
        const double own = web.candela(at, gamma);
        const double over_c0 = across_c0 ? web.candela(-at, gamma) : own;
        const double over_c90 = across_c90 ? web.candela(180.0 - at, gamma) : own;
        const double over_both = across_c0 && across_c90 ? web.candela(180.0 + at, gamma)
                                 : across_c90            ? over_c90
                                                         : over_c0;
        return 0.25 * ((own + over_both) + (over_c0 + over_c90));
    };
    const auto column_at = [&](double at) {
        std::vector<double> column;
        for (const double gamma : gammas)
            column.push_back(mean(at, gamma));
        return column;
    };
    if (!jumps.empty())
        return on_ramped_planes(
            web, symmetry, RampedAngles(within_range(bends), within_range(jumps), range.low, range.high), column_at);
    std::vector<double> planes = within_range(bends);
    planes.insert(planes.end(), {range.low, range.high});
    sort_unique(planes);
    for (const double at : planes)
        for (const double gamma : gammas)
            candela.push_back(mean(at, gamma));
    return Web::create(symmetry, std::move(planes), std::move(gammas), std::move(candela));
}

Result<Web> cropped(const Web& web, double gamma_low_deg, double gamma_high_deg) {
    if (!(gamma_low_deg >= 0.0 && gamma_low_deg < gamma_high_deg && gamma_high_deg <= 180.0))
        return fail("USE0106",
                    fmt::format("cannot keep gamma from {}° to {}° of 0° to 180°", gamma_low_deg, gamma_high_deg));
    if (web.photometry() != Photometry::c)
        return fail(Failure::unsupported, "a web of type A or B cannot be cropped by gamma",
                    "resample it to type C first (gonio edit --resample 5deg,2.5deg)");
    const double low = std::max(gamma_low_deg, web.gammas_deg().front());
    const double high = std::min(gamma_high_deg, web.gammas_deg().back());
    if (low > high)
        return fail(Failure::usage,
                    fmt::format("the table from gamma {}° to {}° has nothing between {}° and {}°",
                                web.gammas_deg().front(), web.gammas_deg().back(), gamma_low_deg, gamma_high_deg));
    std::vector<double> gammas{low, high};
    for (const double gamma : web.gammas_deg())
        if (gamma > low && gamma < high) gammas.push_back(gamma);
    sort_unique(gammas);
    std::vector<double> planes(web.planes_deg().begin(), web.planes_deg().end());
    std::vector<double> candela;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const std::span<const double> column = web.column(i);
        for (const double gamma : gammas) {
            const auto above = std::upper_bound(web.gammas_deg().begin(), web.gammas_deg().end(), gamma);
            const auto j = static_cast<std::size_t>(above - web.gammas_deg().begin()) - 1;
            double cd = column[j];
            if (gamma != web.gammas_deg()[j])
                cd += (gamma - web.gammas_deg()[j]) / (web.gammas_deg()[j + 1] - web.gammas_deg()[j]) *
                      (column[j + 1] - cd);
            candela.push_back(cd);
        }
    }
    return Web::create(web.stored_symmetry(), std::move(planes), std::move(gammas), std::move(candela));
}

Result<Web> scaled_to(const Web& web, Lumens wanted) {
    const Lumens now = flux(web);
    if (!(now.value > 0.0))
        return fail(Failure::usage, fmt::format("a web of {} lm cannot be scaled to a flux", now.value));
    if (!(wanted.value > 0.0))
        return fail("USE0106", fmt::format("a flux of {} lm is not greater than 0", wanted.value));
    return scaled_by(web, wanted / now);
}

Result<Web> scaled_by(const Web& web, double factor) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < web.horizontal_deg().size(); ++i)
        for (const double cd : web.column(i))
            greatest = std::max(greatest, std::abs(cd));
    if (!(factor > 0.0) || !std::isfinite(factor))
        return fail("USE0106", fmt::format("a factor of {} is not a number greater than 0", factor));
    if (!in_amount_range(greatest * factor))
        return fail("USE0106", fmt::format("a factor of {} makes {} cd more than {} cd", factor, rounded(greatest),
                                           greatest_amount));
    return web.scaled(factor);
}

} // namespace gonio
