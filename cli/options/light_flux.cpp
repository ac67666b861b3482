#include "light_flux.hpp"

#include <gonio/light/photometry.hpp>

namespace gonio::cli {

std::optional<double> flux_lm(const Light& light) {
    Result<ShapePhotometry> photometry = ShapePhotometry::of(light.shape);
    const Result<PhotometricUnit> lumen = parse_photometric_unit("lm");
    if (!photometry || !lumen) return std::nullopt;
    const Result<double> flux = photometry->express({light.intensity, light.luminance, light.illuminance}, *lumen);
    return flux ? std::optional(*flux) : std::nullopt;
}

} // namespace gonio::cli
