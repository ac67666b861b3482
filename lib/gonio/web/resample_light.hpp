// Any light given by direction, converted to a type C web with its error. Internal to the web room.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/web.hpp>
#include <gonio/web/web_rows.hpp>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gonio::web_detail {

struct Light {
    std::function<double(double c_deg, double gamma_deg)> candela;
    std::vector<GoniometerAngles> points; // (C, γ) at which it may bend: the error is evaluated there too
    std::vector<double> gammas_deg = {};  // γ of bends that follow a C-plane: a chosen grid includes them
    const Web* web = nullptr;             // whose light this is, if there is one: the same, but faster
};

// A light on planes at the same γ. What its functions return lasts until the next call.
class LightRows {
public:
    // The light and the γ must outlive this.
    LightRows(const Light& light, std::span<const double> gammas_deg);

    // candela() at each γ.
    std::span<const double> exact(double c_deg);
    // The same within margin_cd(), in less time.
    std::span<const double> quick(double c_deg);
    [[nodiscard]] double margin_cd() const { return of_web_ ? of_web_->margin_cd() : 0.0; }

private:
    const Light& light_;
    std::span<const double> gammas_deg_;
    std::optional<WebRows> of_web_;
    std::vector<double> row_;
};

// (C, γ) of every point of a web's table, without mirror images.
std::vector<GoniometerAngles> table_directions(const Web& web);

// On the given grid, mirrored by `stored`; the flux error is relative to `flux`.
Result<ResampledWeb> resample(const Light& light, Symmetry stored, std::vector<double> planes_deg,
                              std::vector<double> gammas_deg, Lumens flux);

// On a grid that refined_grid() makes from steps of 2.5° and the light's own γ, for `tolerance` · peak; γ covers the
// half or full sphere that is not dark.
ResampledWeb resample(const Light& light, Symmetry stored, Candelas peak, Lumens flux, double tolerance);

} // namespace gonio::web_detail
