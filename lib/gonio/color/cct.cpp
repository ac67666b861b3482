#include <gonio/base/codes/result.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/locus.hpp>
#include <gonio/color/planckian.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace gonio {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Kelvin coolest_daylight{4000.0};
constexpr Kelvin hottest_daylight{25000.0};

constexpr std::array loci{
    LocusName{"planckian", Locus::planckian, "black bodies, 500 K to 1e6 K"},
    LocusName{"daylight", Locus::daylight, "CIE D illuminants, 4000–25000 K"},
    LocusName{"blend", Locus::blend, "planckian to 4000 K, daylight from 5000 K, mixed between (TM-30)"},
};
static_assert(in_enum_order(loci, &LocusName::locus, Locus::blend));

double per_kk(Kelvin temperature) {
    return 1e3 / temperature.value;
}

LocusPoint fitted(double t) {
    const color::LocusJet<double> jet = color::locus_jet<2>(t);
    return {{jet.u, jet.v / 1.5}, {jet.du, jet.dv / 1.5}, {jet.ddu, jet.ddv / 1.5}};
}

// To the left of the direction of growing t: above the locus, because u grows with t.
Uv normal(const LocusPoint& point) {
    const double length = std::hypot(point.first.u, point.first.v);
    return {-point.first.v / length, point.first.u / length};
}

Uv offset(const LocusPoint& point, double duv) {
    const Uv n = normal(point);
    return {point.at.u + duv * n.u, point.at.v + duv * n.v};
}

// The step in t after which the tangent at `p` is perpendicular to the line to `at`; NaN where the curve bends too much
// to have a single nearest point.
double newton_step(Uv at, const LocusPoint& p) {
    const double du = at.u - p.at.u;
    const double dv = at.v - p.at.v;
    const double f = du * p.first.u + dv * p.first.v;
    const double slope = p.first.u * p.first.u + p.first.v * p.first.v - du * p.second.u - dv * p.second.v;
    return slope > 0.0 ? f / slope : nan;
}

// Newton's method from t; NaN if it does not converge inside [least, greatest].
template<class Point>
double nearest_t(Uv at, double t, double least, double greatest, const Point& point) {
    constexpr double settled = 1e-8; // the error after such a step is its square
    for (int i = 0; i < 24; ++i) {
        const double step = newton_step(at, point(t));
        if (std::isnan(step)) return nan;
        const double wanted = t + step;
        t = std::clamp(wanted, least, greatest);
        if (std::abs(wanted - t) > settled && (step > 0.0 ? t == greatest : t == least) && i > 0) return nan;
        if (std::abs(step) <= settled) return t;
    }
    return nan;
}

// A start for nearest_t: one step from the nearest of a set of points on the locus.
double start_near(Uv at) {
    struct Node {
        double t = 0.0;
        LocusPoint point;
    };
    constexpr std::size_t count = 51;
    static const std::array<Node, count> nodes = [] {
        std::array<Node, count> made;
        for (std::size_t i = 0; i < count; ++i) {
            made[i].t = color::greatest_t * static_cast<double>(i) / (count - 1);
            made[i].point = fitted(made[i].t);
        }
        return made;
    }();
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
        const double du = at.u - nodes[i].point.at.u;
        const double dv = at.v - nodes[i].point.at.v;
        const double square = du * du + dv * dv;
        if (square < least) {
            least = square;
            best = i;
        }
    }
    const double step = newton_step(at, nodes[best].point);
    const double reach = color::greatest_t / (count - 1);
    return std::isnan(step) ? nodes[best].t
                            : std::clamp(nodes[best].t + std::clamp(step, -reach, reach), 0.0, color::greatest_t);
}

double signed_distance(Uv at, const LocusPoint& point) {
    const Uv n = normal(point);
    return (at.u - point.at.u) * n.u + (at.v - point.at.v) * n.v;
}

Unexpected no_temperature(Uv at, std::string why) {
    const Xy xy = to_xy(at);
    return fail(Failure::usage, fmt::format("xy {:.6g},{:.6g} has no colour temperature: {}", xy.x, xy.y, why),
                "it is defined from 500 K to 1e6 K, up to 0.1 from the Planckian locus in u, v");
}

using PointOfLocus = LocusPoint (*)(double t);

Result<Uv> checked_uv(Cct cct, Locus locus, PointOfLocus point) {
    const bool planckian = locus == Locus::planckian;
    const Kelvin low = locus == Locus::daylight ? coolest_daylight : coolest;
    const Kelvin high = planckian ? hottest : hottest_daylight;
    const Kelvin T = cct.temperature;
    if (!(T.value >= low.value && T.value <= high.value))
        return fail("USE0106",
                    fmt::format("{} K is outside the {} locus", rounded(T.value, 12),
                                loci[static_cast<std::size_t>(locus)].name),
                    fmt::format("the locus runs from {} K to {} K", rounded(low.value), rounded(high.value, 7)));
    if (!(std::abs(cct.duv) <= greatest_duv))
        return fail("USE0106", fmt::format("a Duv of {} is too far from the locus", rounded(cct.duv)),
                    "colour temperature is meaningful up to 0.05 and unique up to 0.1");
    if (!planckian && cct.duv != 0.0)
        return fail("USE0107",
                    fmt::format("a Duv of {} cannot be combined with the {} locus", rounded(cct.duv),
                                loci[static_cast<std::size_t>(locus)].name),
                    "Duv is measured from the Planckian locus: leave out one of the two");
    if (locus == Locus::daylight || (locus == Locus::blend && T.value >= 5000.0)) return to_uv(daylight_xy(T));
    const Uv planck = offset(point(per_kk(T)), cct.duv);
    if (locus == Locus::blend && T.value > 4000.0) {
        const double daylight = (T.value - 4000.0) / 1000.0;
        return to_uv((1.0 - daylight) * to_xyz(planck) + daylight * to_xyz(daylight_xy(T)));
    }
    if (cct.duv != 0.0 && !is_real(to_xy(planck)))
        return fail("USE0106",
                    fmt::format("{} K with a Duv of {} is not a real colour", rounded(T.value), rounded(cct.duv)),
                    "it lies outside the spectral locus: use a smaller Duv");
    return planck;
}

} // namespace

std::span<const LocusName> locus_names() {
    return loci;
}

Result<Locus> parse_locus(std::string_view text) {
    return find_named("locus", text, loci).map([](const LocusName* known) { return known->locus; });
}

Xy daylight_xy(Kelvin temperature) {
    const double t = per_kk(temperature);
    const double x = temperature.value <= 7000.0 ? ((-4.6070 * t + 2.9678) * t + 0.09911) * t + 0.244063
                                                 : ((-2.0064 * t + 1.9018) * t + 0.24748) * t + 0.237040;
    return {x, (-3.000 * x + 2.870) * x - 0.275};
}

Result<Uv> exact_uv(Cct cct, Locus locus) {
    return checked_uv(cct, locus, planckian_sum);
}

Result<Uv> uv_of(Cct cct, Locus locus) {
    return checked_uv(cct, locus, per_kk(cct.temperature) <= color::greatest_t ? fitted : planckian_sum);
}

Result<Cct> exact_cct(Uv at) {
    if (!std::isfinite(at.u) || !std::isfinite(at.v)) return fail("USE0105", "the chromaticity is not a number");
    const double least = per_kk(hottest);
    const double greatest = per_kk(coolest);
    // The fit ends at 800 K; Newton's method goes on from there.
    const double t = nearest_t(at, std::clamp(start_near(at), least, greatest), least, greatest, planckian_sum);
    if (std::isnan(t)) return no_temperature(at, "no black body is nearest to it");
    const Cct found{Kelvin(1e3 / t), signed_distance(at, planckian_sum(t))};
    if (!(std::abs(found.duv) <= greatest_duv))
        return no_temperature(at, fmt::format("its Duv is {}", rounded(found.duv, 3)));
    return found;
}

Uv fast_uv(Cct cct) {
    const double t = per_kk(cct.temperature);
    if (!(t >= 0.0 && t <= color::greatest_t) || !(std::abs(cct.duv) <= greatest_duv)) return {nan, nan};
    const color::UvPrimeOf<double> at = color::off_locus(t, cct.duv);
    return {at.u, at.v / 1.5};
}

Cct fast_cct(Uv at) {
    const double t = nearest_t(at, start_near(at), 0.0, color::greatest_t, fitted);
    if (!(t >= per_kk(hottest) * (1.0 - 1e-9))) return {Kelvin(nan), nan};
    const double duv = signed_distance(at, fitted(t));
    if (!(std::abs(duv) <= greatest_duv)) return {Kelvin(nan), nan};
    return {Kelvin(1e3 / t), duv};
}

Diagnostics remarks(Cct cct) {
    if (std::abs(cct.duv) <= meaningful_duv) return {};
    return {result_diagnostic(
        "RES0101", fmt::format("a Duv of {} is beyond 0.05, where colour temperature means little according to the CIE",
                               rounded(cct.duv, 4)))};
}

std::span<const TintConvention> tint_conventions() {
    // The same value on a photo slider makes the picture, not the light, greener or pinker.
    static constexpr std::array conventions{
        TintConvention{"dng", 3000.0, "Adobe DNG: 3000 Duv, positive is a greener light"},
        TintConvention{"blender", 3000.0, "Blender's white balance: 3000 Duv, positive is a greener light"},
        TintConvention{"milliduv", 1000.0, "1000 Duv, as in camera metadata"},
    };
    return conventions;
}

Result<double> parse_tint(std::string_view text) {
    const std::size_t at = text.find('@');
    const std::optional<double> number = parse_number(text.substr(0, at));
    if (!number) return fail("USE0105", fmt::format("'{}' is not a tint", text), "for example 10@dng");
    if (at == std::string_view::npos)
        return fail("USE0104", fmt::format("the tint '{}' does not name its convention", text),
                    fmt::format("write {}@dng, or another of 'gonio list tints'", text));
    return find_named("tint", text.substr(at + 1), tint_conventions()).map([&](const TintConvention* known) {
        return *number / known->per_duv;
    });
}

Result<Cct> parse_cct(std::string_view text) {
    const std::size_t slash = text.find('/');
    Result<double> kelvin = parse_amount(text.substr(0, slash), Dimension::temperature, "a colour temperature");
    if (!kelvin) return pass_on(kelvin);
    Cct cct{Kelvin(*kelvin), 0.0};
    if (slash == std::string_view::npos) return cct;
    const std::optional<double> duv = parse_number(text.substr(slash + 1));
    if (!duv)
        return fail("USE0105", fmt::format("'{}' is not a Duv", text.substr(slash + 1)), "for example 2700K/0.003");
    cct.duv = *duv;
    return cct;
}

} // namespace gonio
