#include <gonio/color/color_fidelity.hpp>
#include <gonio/color/detail/ciecam02.hpp>
#include <gonio/color/detail/rendering_of_rays.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gonio {

namespace {

using detail::UcsPoint;

// 100 at no difference, never below 0.
double fidelity_of(double difference) {
    const double linear = 100.0 - 6.73 * difference;
    // log1p(e^x) without overflow
    return 10.0 * (std::fmax(linear / 10.0, 0.0) + std::log1p(std::exp(-std::fabs(linear / 10.0))));
}

struct Seen {
    std::array<UcsPoint, fidelity_sample_count> points;
    std::array<double, fidelity_sample_count> hue_deg;
};

Seen see(const detail::NodeWeights& weights) {
    const detail::Ciecam02 model({detail::white_of(weights)});
    const auto xyz = detail::lit(detail::fidelity_samples, detail::fidelity_sample_unit, weights);
    Seen seen{};
    for (std::size_t i = 0; i < xyz.size(); ++i) {
        const detail::Appearance appearance = model.appearance(xyz[i]);
        seen.points[i] = cam02_ucs(appearance);
        seen.hue_deg[i] = appearance.hue_deg;
    }
    return seen;
}

// Of the polygon of the bins that have samples.
double area(const std::array<HueBin, hue_bin_count>& bins, HuePoint HueBin::*point) {
    double sum = 0.0;
    const HueBin* last = nullptr;
    for (const HueBin& bin : bins)
        if (bin.samples > 0) last = &bin;
    for (const HueBin& bin : bins) {
        if (bin.samples == 0) continue;
        const HuePoint from = last->*point;
        const HuePoint to = bin.*point;
        sum += 0.5 * (from.a * to.b - from.b * to.a);
        last = &bin;
    }
    return sum;
}

} // namespace

ColorFidelity detail::fidelity_of_rays(const Rays& light, Kelvin temperature) {
    ColorFidelity fidelity;
    fidelity.reference = temperature.value <= 4000.0   ? ReferenceIlluminant::planckian
                         : temperature.value >= 5000.0 ? ReferenceIlluminant::daylight
                                                       : ReferenceIlluminant::blend;
    const Seen seen = see(node_weights(light, Observer::cie_1964));
    const Seen expected = see(node_weights(reference_rays(light, temperature, fidelity.reference), Observer::cie_1964));
    double sum = 0.0;
    std::array<double, hue_bin_count> differences{};
    for (std::size_t i = 0; i < fidelity_sample_count; ++i) {
        const UcsPoint& p = seen.points[i];
        const UcsPoint& q = expected.points[i];
        const double difference = std::hypot(p.j - q.j, p.a - q.a, p.b - q.b);
        sum += difference;
        fidelity.samples[i] = fidelity_of(difference);
        const auto at = std::min(static_cast<std::size_t>(expected.hue_deg[i] / 22.5), hue_bin_count - 1);
        HueBin& bin = fidelity.bins[at];
        ++bin.samples;
        differences[at] += difference;
        bin.light.a += p.a;
        bin.light.b += p.b;
        bin.reference.a += q.a;
        bin.reference.b += q.b;
    }
    fidelity.rf = fidelity_of(sum / fidelity_sample_count);
    for (std::size_t at = 0; at < hue_bin_count; ++at) {
        HueBin& bin = fidelity.bins[at];
        if (bin.samples == 0) {
            constexpr double none = std::numeric_limits<double>::quiet_NaN();
            bin = {none, none, none, 0, {none, none}, {none, none}};
            continue;
        }
        for (HuePoint* const point : {&bin.light, &bin.reference}) {
            point->a /= bin.samples;
            point->b /= bin.samples;
        }
        bin.fidelity = fidelity_of(differences[at] / bin.samples);
        const double middle = (22.5 * static_cast<double>(at) + 11.25) * std::numbers::pi / 180.0;
        const double chroma = std::hypot(bin.reference.a, bin.reference.b);
        const double da = (bin.light.a - bin.reference.a) / chroma;
        const double db = (bin.light.b - bin.reference.b) / chroma;
        bin.chroma_shift = da * std::cos(middle) + db * std::sin(middle);
        bin.hue_shift = db * std::cos(middle) - da * std::sin(middle);
    }
    fidelity.rg = 100.0 * area(fidelity.bins, &HueBin::light) / area(fidelity.bins, &HueBin::reference);
    return fidelity;
}

Result<ColorFidelity> color_fidelity(const Spectrum& spectrum) {
    Result<Cct> cct = detail::reference_temperature(spectrum);
    if (!cct) return pass_on(cct);
    Result<detail::Rays> light = detail::rays_of(spectrum);
    if (!light) return pass_on(light);
    return detail::fidelity_of_rays(*light, cct->temperature);
}

} // namespace gonio
