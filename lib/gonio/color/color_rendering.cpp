#include <gonio/color/color_rendering.hpp>
#include <gonio/color/detail/rendering_of_rays.hpp>

#include <cmath>

namespace gonio {

namespace {

// Von Kries' adaptation to the reference, CIE 13.3, 5.7.
struct Adaptation {
    double c = 1.0; // c of the reference over that of the light
    double d = 1.0;

    static double c_of(Uv uv) { return (4.0 - uv.u - 10.0 * uv.v) / uv.v; }
    static double d_of(Uv uv) { return (1.708 * uv.v + 0.404 - 1.481 * uv.u) / uv.v; }

    Adaptation(Uv light, Uv reference) : c(c_of(reference) / c_of(light)), d(d_of(reference) / d_of(light)) {}

    Uv operator()(Uv uv) const {
        const double ci = c * c_of(uv);
        const double di = d * d_of(uv);
        const double below = 16.518 + 1.481 * ci - di;
        return {(10.872 + 0.404 * ci - 4.0 * di) / below, 5.520 / below};
    }
};

// U*, V*, W* of 1964 relative to a white.
glm::dvec3 uvw(Uv uv, double y, Uv white) {
    const double w = 25.0 * std::cbrt(y) - 17.0;
    return {13.0 * w * (uv.u - white.u), 13.0 * w * (uv.v - white.v), w};
}

} // namespace

ColorRendering detail::rendering_of_rays(const Rays& light, Kelvin temperature) {
    ColorRendering rendering;
    rendering.reference = temperature.value < 5000.0 ? ReferenceIlluminant::planckian : ReferenceIlluminant::daylight;
    const NodeWeights by_light = node_weights(light, Observer::cie_1931);
    const NodeWeights by_reference =
        node_weights(reference_rays(light, temperature, rendering.reference), Observer::cie_1931);
    const Uv light_uv = to_uv(white_of(by_light));
    const Uv reference_uv = to_uv(white_of(by_reference));
    rendering.reference_duv = std::hypot(light_uv.u - reference_uv.u, light_uv.v - reference_uv.v);
    const Adaptation adapted(light_uv, reference_uv);
    const auto seen = lit(rendering_samples, rendering_sample_unit, by_light);
    const auto expected = lit(rendering_samples, rendering_sample_unit, by_reference);
    for (std::size_t i = 0; i < rendering.r.size(); ++i) {
        const glm::dvec3 difference = uvw(adapted(to_uv(seen[i])), seen[i].y, reference_uv) -
                                      uvw(to_uv(expected[i]), expected[i].y, reference_uv);
        rendering.r[i] = 100.0 - 4.6 * std::hypot(difference.x, difference.y, difference.z);
        if (i < 8) rendering.ra += rendering.r[i] / 8.0;
    }
    return rendering;
}

Result<ColorRendering> color_rendering(const Spectrum& spectrum) {
    Result<Cct> cct = detail::reference_temperature(spectrum);
    if (!cct) return pass_on(cct);
    Result<detail::Rays> light = detail::rays_of(spectrum);
    if (!light) return pass_on(light);
    return detail::rendering_of_rays(*light, cct->temperature);
}

} // namespace gonio
