#include <gonio/base/unit_text.hpp>
#include <gonio/color/detail/cie_tables.hpp>
#include <gonio/color/detail/spectrum_samples.hpp>
#include <gonio/color/detail/test_light.hpp>
#include <gonio/color/planckian.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gonio {

std::string_view to_text(ReferenceIlluminant kind) {
    switch (kind) {
    case ReferenceIlluminant::planckian:
        return "black body";
    case ReferenceIlluminant::blend:
        return "black body and daylight";
    case ReferenceIlluminant::daylight:
        break;
    }
    return "daylight";
}

namespace detail {

namespace {

constexpr double hair_nm = 1e-6; // wavelengths of tables are rounded

glm::dvec3 observer_10deg_at(double nm) {
    const double place = std::clamp(nm - quality_first_nm, 0.0, static_cast<double>(observer_10deg.size() - 1));
    const auto i = std::min(static_cast<std::size_t>(place), observer_10deg.size() - 2);
    const double f = place - static_cast<double>(i);
    const auto& a = observer_10deg[i];
    const auto& b = observer_10deg[i + 1];
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
}

// Planck's law over its value at 560 nm or so: any scale will do.
std::vector<double> planckian_power(const std::vector<double>& nm, Kelvin temperature) {
    std::vector<double> power;
    power.reserve(nm.size());
    const double exponent = c2_meter_kelvin * 1e9 / temperature.value; // nm
    const double middle = std::expm1(exponent / 560.0);
    for (const double at : nm) {
        const double w = 560.0 / at;
        const double w2 = w * w;
        power.push_back(w2 * w2 * w * middle / std::expm1(exponent / at));
    }
    return power;
}

// A D illuminant (CIE 015), from its components, which are linear between their rows.
std::vector<double> daylight_power(const std::vector<double>& nm, Kelvin temperature) {
    const Xy xy = daylight_xy(temperature);
    const double m = 0.0241 + 0.2562 * xy.x - 0.7341 * xy.y;
    const double m1 = (-1.3515 - 1.7703 * xy.x + 5.9114 * xy.y) / m;
    const double m2 = (0.0300 - 31.4424 * xy.x + 30.0717 * xy.y) / m;
    std::vector<double> power;
    power.reserve(nm.size());
    for (const double at : nm) {
        const double place = (at - daylight_first_nm) / illuminant_step_nm;
        const auto i = std::min(static_cast<std::size_t>(place), daylight_components.size() - 2);
        const double f = place - static_cast<double>(i);
        const auto& a = daylight_components[i];
        const auto& b = daylight_components[i + 1];
        const auto component = [&](std::size_t c) { return a[c] + f * (b[c] - a[c]); };
        power.push_back(component(0) + m1 * component(1) + m2 * component(2));
    }
    return power;
}

// The shares of six neighbouring nodes, from two before to three after, in Sprague's interpolation at t from 0 to 1
// behind the third (CIE 167:2005).
std::array<double, 6> sprague(double t) {
    constexpr double by_power[5][6] = {{2, -16, 0, 16, -2, 0},
                                       {-1, 16, -30, 16, -1, 0},
                                       {-9, 39, -70, 66, -33, 7},
                                       {13, -64, 126, -124, 61, -12},
                                       {-5, 25, -50, 50, -25, 5}};
    std::array<double, 6> shares{0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
    double power = t / 24.0;
    for (const auto& row : by_power) {
        for (std::size_t k = 0; k < shares.size(); ++k)
            shares[k] += power * row[k];
        power *= t;
    }
    return shares;
}

double luminous(const Rays& rays) {
    double sum = 0.0;
    for (std::size_t i = 0; i < rays.nm.size(); ++i)
        sum += rays.power[i] * observer_at(rays.nm[i]).y;
    return sum;
}

} // namespace

Result<Rays> rays_of(const Spectrum& spectrum) {
    const Samples samples = samples_of(spectrum);
    Rays rays;
    const auto dark_from = [&](double first, double last) {
        for (double nm = first; nm <= last + hair_nm; nm += samples.width_nm) {
            rays.nm.push_back(nm);
            rays.power.push_back(0.0);
        }
    };
    const double before = std::floor((samples.nm.front() - quality_first_nm + hair_nm) / samples.width_nm);
    if (before > 0.0) dark_from(samples.nm.front() - before * samples.width_nm, samples.nm.front() - samples.width_nm);
    for (std::size_t i = 0; i < samples.nm.size(); ++i) {
        if (samples.nm[i] < quality_first_nm - hair_nm || samples.nm[i] > quality_last_nm + hair_nm) continue;
        rays.nm.push_back(samples.nm[i]);
        rays.power.push_back(samples.power[i]);
    }
    dark_from(samples.nm.back() + samples.width_nm, quality_last_nm);
    const double greatest = rays.power.empty() ? 0.0 : *std::max_element(rays.power.begin(), rays.power.end());
    if (!(greatest > 0.0))
        return fail(Failure::usage, fmt::format("the spectrum '{}' is dark from 380 to 780 nm", spectrum.name));
    for (double& power : rays.power)
        power /= greatest;
    return rays;
}

Result<Cct> reference_temperature(const Spectrum& spectrum) {
    Result<SpectrumColor> color = color_of(spectrum);
    if (!color) return pass_on(color);
    // The fit costs a quarter of a microsecond, but ends at 800 K.
    const Cct fast = fast_cct(color->uv);
    Result<Cct> cct =
        std::isfinite(fast.temperature.value) && fast.temperature.value > 801.0 ? fast : exact_cct(color->uv);
    if (!cct) return pass_on(cct);
    if (!(cct->temperature.value >= coolest_reference.value && cct->temperature.value <= hottest_reference.value))
        return fail(Failure::usage, fmt::format("no reference illuminant has {} K", rounded(cct->temperature.value, 6)),
                    "colour rendering is defined from 500 K to 25000 K");
    return cct;
}

Rays reference_rays(const Rays& light, Kelvin temperature, ReferenceIlluminant kind) {
    switch (kind) {
    case ReferenceIlluminant::planckian:
        return {light.nm, planckian_power(light.nm, temperature)};
    case ReferenceIlluminant::daylight:
        return {light.nm, daylight_power(light.nm, temperature)};
    case ReferenceIlluminant::blend:
        break;
    }
    Rays mixed{light.nm, planckian_power(light.nm, temperature)};
    const Rays daylight{light.nm, daylight_power(light.nm, temperature)};
    const double share = std::clamp((temperature.value - 4000.0) / 1000.0, 0.0, 1.0);
    const double of_body = (1.0 - share) / luminous(mixed);
    const double of_daylight = share / luminous(daylight);
    for (std::size_t i = 0; i < mixed.power.size(); ++i)
        mixed.power[i] = of_body * mixed.power[i] + of_daylight * daylight.power[i];
    return mixed;
}

NodeWeights node_weights(const Rays& light, Observer by) {
    NodeWeights weights{};
    double y = 0.0;
    constexpr auto last = static_cast<double>(sample_nodes - 1);
    for (std::size_t i = 0; i < light.nm.size(); ++i) {
        const double nm = light.nm[i];
        const glm::dvec3 xyz = light.power[i] * (by == Observer::cie_1931 ? observer_at(nm) : observer_10deg_at(nm));
        y += xyz.y;
        const double place = std::clamp((nm - quality_first_nm) / sample_step_nm, 0.0, last);
        const double node = std::floor(place);
        const std::array<double, 6> shares = sprague(place - node);
        for (std::size_t k = 0; k < shares.size(); ++k)
            if (shares[k] != 0.0) // beyond the ends of the table its last values go on
                weights[static_cast<std::size_t>(std::clamp(node + static_cast<double>(k) - 2.0, 0.0, last))] +=
                    shares[k] * xyz;
    }
    for (glm::dvec3& weight : weights)
        weight *= 100.0 / y;
    return weights;
}

glm::dvec3 white_of(const NodeWeights& weights) {
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& weight : weights)
        sum += weight;
    return sum;
}

} // namespace detail

} // namespace gonio
