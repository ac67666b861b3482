#include <gonio/base/amount_range.hpp>
#include <gonio/web/author.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/make_profile.hpp>
#include <gonio/web/resample.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <system_error>
#include <utility>
#include <vector>

namespace gonio {

namespace {

constexpr double darkest_cd_per_klm = 1e-9; // smaller values become 0

bool divides_a_quarter(double step_deg) {
    if (!(step_deg >= 0.05 && step_deg <= 90.0)) return false;
    const double parts = 90.0 / step_deg;
    return std::abs(parts - std::round(parts)) < 1e-9 * parts;
}

std::vector<double> angles(double first, double last, double step) {
    return even_angles(first, last, static_cast<std::size_t>(std::lround((last - first) / step)));
}

struct Axes {
    Symmetry stored;
    std::vector<double> horizontal;
    std::vector<double> vertical;
};

Axes axes_of(const AuthoredShape& shape, const AuthorOptions& options) {
    const double h = options.horizontal_step_deg;
    const double v = options.vertical_step_deg;
    Axes axes{shape.symmetry, {}, {}};
    if (options.photometry != Photometry::c) {
        if (shape.symmetry == Symmetry::axial) axes.stored = Symmetry::quadrant;
        const bool across = mirrored_in_90_270(axes.stored);
        const bool along = mirrored_in_0_180(axes.stored);
        axes.horizontal = angles(across ? 0.0 : -90.0, 90.0, h);
        axes.vertical = angles(along ? 0.0 : -90.0, 90.0, v);
        return axes;
    }
    axes.vertical = angles(0.0, shape.gamma_end_deg, v);
    switch (shape.symmetry) {
    case Symmetry::axial:
        axes.horizontal = {0.0};
        break;
    case Symmetry::quadrant:
        axes.horizontal = angles(0.0, 90.0, h);
        break;
    case Symmetry::bilateral_0_180:
        axes.horizontal = angles(0.0, 180.0, h);
        break;
    case Symmetry::bilateral_90_270:
        axes.horizontal = angles(90.0, 270.0, h);
        break;
    case Symmetry::none:
        axes.horizontal = angles(0.0, 360.0, h);
        break;
    }
    return axes;
}

} // namespace

Result<Web> authored(const AuthoredShape& shape, const AuthorOptions& options) {
    for (const double step : {options.horizontal_step_deg, options.vertical_step_deg})
        if (!divides_a_quarter(step))
            return fail("USE0105", fmt::format("steps of {}° do not divide 90° into whole parts", step),
                        "from 0.05°, for example 2.5°");
    if (!(options.flux.value > 0.0) || !std::isfinite(options.flux.value))
        return fail("USE0106", fmt::format("a flux of {} lm is not greater than 0", options.flux.value));
    const Axes axes = axes_of(shape, options);
    std::vector<double> relative;
    for (const double h : axes.horizontal)
        for (const double v : axes.vertical) {
            GoniometerAngles at{h == 360.0 ? 0.0 : h, v};
            if (options.photometry != Photometry::c)
                at = angles_of(Photometry::c, direction_of(options.photometry, at));
            relative.push_back(shape.relative(at.horizontal_deg, at.vertical_deg));
            if (!(relative.back() >= 0.0) || !std::isfinite(relative.back()))
                return fail(Failure::usage, fmt::format("the shape gives an intensity of {} at C {}°, gamma {}°",
                                                        relative.back(), at.horizontal_deg, at.vertical_deg));
        }
    const auto web_of = [&](std::vector<double> candela) {
        return Web::create(options.photometry, axes.stored, axes.horizontal, axes.vertical, std::move(candela));
    };
    Result<Web> raw = web_of(relative);
    if (!raw) return raw;
    const double lumens = flux(*raw).value;
    if (!(lumens > 0.0))
        return fail(Failure::usage, "the shape gives no light at any angle of the grid",
                    "it may be narrower than the steps");
    for (double& cd : relative) {
        const double per_klm = web_detail::rounded_to(cd * 1000.0 / lumens, 7);
        // Seven digits of cd/klm times the digits of the flux. A formula's tail may go down to 1e-300, which no file
        // can store.
        cd = per_klm < darkest_cd_per_klm ? 0.0 : web_detail::rounded_to(per_klm * options.flux.value / 1000.0, 10);
    }
    if (const double greatest = *std::max_element(relative.begin(), relative.end()); !in_amount_range(greatest))
        return fail("USE0106", fmt::format("a flux of {} lm makes an intensity of {} cd, above {} cd",
                                           options.flux.value, greatest, greatest_amount));
    return web_of(std::move(relative));
}

} // namespace gonio
