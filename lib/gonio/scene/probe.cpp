#include <gonio/base/codes/result.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/shading/lights.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace gonio {

namespace {

constexpr std::array method_names{
    IrradianceMethodName{IrradianceMethod::exact, "exact",
                         "closed forms with horizon clipping, no distance guard; luminance by quadrature to 1e-6"},
    IrradianceMethodName{IrradianceMethod::reference, "reference",
                         "quadrature over the light to the error of --error, with an estimate of its own error"},
    IrradianceMethodName{IrradianceMethod::ltc, "ltc",
                         "illuminance as exact; highlights of lights with a size by linearly transformed cosines"},
    IrradianceMethodName{IrradianceMethod::representative_point, "representative-point",
                         "the same; highlights by the light's point nearest to the mirrored view (Karis 2013)"},
    IrradianceMethodName{IrradianceMethod::dominant_direction, "dominant-direction",
                         "the same, with the lobe's dominant direction (Lagarde and de Rousiers 2014)"},
    IrradianceMethodName{IrradianceMethod::specular_d, "specular-d",
                         "highlights by the light's centre and a widened lobe (Karis 2013)"},
    IrradianceMethodName{IrradianceMethod::spherical_hack, "spherical-hack",
                         "highlights by the light's centre and a lower power (Lagarde and Harduin 2013)"},
    IrradianceMethodName{IrradianceMethod::sun_disk, "sun-disk",
                         "highlights by the nearest point of the light's disk (Lagarde and de Rousiers 2014)"},
    IrradianceMethodName{IrradianceMethod::frostbite, "frostbite",
                         "Lagarde and de Rousiers 2014: its approximation of each shape, guard max(d2, 1 cm2)"},
    IrradianceMethodName{IrradianceMethod::ue4, "ue4",
                         "Karis 2013: spheres as points, tubes as lines, other shapes as points, guard d2 + 1 cm2"},
    IrradianceMethodName{IrradianceMethod::point, "point", "every light as a point (the five-times rule)"},
};

// The number of lights that are summed in sequence; a block's sum does not depend on the number of threads.
constexpr std::size_t lights_in_block = 4096;
constexpr double farthest = 1e100; // [m]; differences and their products stay far from overflow
bool in_range(const glm::dvec3& position) {
    return std::abs(position.x) <= farthest && std::abs(position.y) <= farthest && std::abs(position.z) <= farthest;
}

struct Sums {
    double illuminance_lx = 0.0;
    double error_lx = 0.0;
    ProbeLuminance luminance;

    void add(const Sums& other) {
        illuminance_lx += other.illuminance_lx;
        error_lx += other.error_lx;
        luminance.diffuse = luminance.diffuse + other.luminance.diffuse;
        luminance.specular = luminance.specular + other.luminance.specular;
        luminance.error_estimate = luminance.error_estimate + other.luminance.error_estimate;
    }
};

Result<void> check_lights(std::span<const Light> lights) {
    for (const Light& light : lights) {
        if (!in_range(light.frame.origin))
            return fail("USE0106", fmt::format("the position of '{}' is out of range", light.name),
                        fmt::format("coordinates reach to {} m", farthest));
        if (!std::isfinite(light.luminance.value) || !std::isfinite(light.intensity.value))
            return fail("USE0106", fmt::format("the luminance of '{}' is infinite", light.name),
                        "its amount is too large for its size");
    }
    return {};
}

// The direction to the eye from each receiver, unit.
Result<std::vector<glm::dvec3>> views_of(const ProbeView& view, std::span<const Receiver> receivers) {
    std::vector<glm::dvec3> views;
    views.reserve(receivers.size());
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const std::optional<glm::dvec3> toward =
            unit_vector(view.eye ? *view.eye - receivers[i].position : view.direction);
        if (!toward)
            return view.eye ? fail("USE0106", fmt::format("the eye is at point {}", i + 1))
                            : fail("USE0106", "the view is zero or not finite");
        views.push_back(*toward);
    }
    return views;
}

// Whether a profile that is a point without being meant as one is nearer than five times its luminous opening.
bool is_near_opening(const Light& light, const glm::dvec3& position) {
    const auto* const profile = std::get_if<ProfileShape>(&light.shape);
    if (profile == nullptr || profile->size != ProfileSize::unsaid || profile->declared == nullptr) return false;
    const double size_m = profile->declared->largest_m();
    return size_m > 0.0 && glm::distance(position, light.frame.origin) < 5.0 * size_m;
}

// Each share is limited to the ceiling separately.
bool at_ceiling(double value) {
    return value >= shading::illuminance_ceiling;
}

std::string others(std::size_t count) {
    return count > 1 ? fmt::format("; {} such pairs of point and light in total", count) : std::string();
}

} // namespace

std::span<const IrradianceMethodName> irradiance_methods() {
    return method_names;
}

std::string_view to_text(IrradianceMethod method) {
    const auto found = std::find_if(method_names.begin(), method_names.end(),
                                    [&](const IrradianceMethodName& name) { return name.method == method; });
    return found == method_names.end() ? std::string_view() : found->name;
}

Result<IrradianceMethod> parse_irradiance_method(std::string_view name) {
    return find_named("method", name, method_names).map([](const IrradianceMethodName* known) {
        return known->method;
    });
}

void ProbeOccurrence::add(const ProbeOccurrence& others, std::size_t offset) {
    if (others.count == 0) return;
    const std::pair theirs(others.receiver + offset, others.light);
    if (count == 0 || theirs < std::pair(receiver, light)) std::tie(receiver, light) = theirs;
    count += others.count;
}

void ProbeRemarks::add(const ProbeRemarks& others, std::size_t offset) {
    on_light.add(others.on_light, offset);
    inside.add(others.inside, offset);
    unseen.add(others.unseen, offset);
    near_point.add(others.near_point, offset);
    at_ceiling.add(others.at_ceiling, offset);
    not_converged.add(others.not_converged, offset);
}

std::optional<glm::dvec3> unit_vector(const glm::dvec3& vector) {
    const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
    if (!std::isfinite(vector.x) || !std::isfinite(vector.y) || !std::isfinite(vector.z) || !(largest > 0.0))
        return std::nullopt;
    // A division: the reciprocal of a denormal number overflows.
    const glm::dvec3 scaled(vector.x / largest, vector.y / largest, vector.z / largest);
    return scaled / glm::length(scaled);
}

Result<ProbeResult> probe(std::span<const Light> lights, std::span<const Receiver> receivers,
                          const ProbeOptions& options) {
    std::vector<glm::dvec3> normals;
    normals.reserve(receivers.size());
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const std::optional<glm::dvec3> normal = unit_vector(receivers[i].normal);
        if (!normal) return fail("USE0106", fmt::format("the normal of point {} is zero or not finite", i + 1));
        if (!in_range(receivers[i].position))
            return fail("USE0106", fmt::format("the position of point {} is out of range", i + 1),
                        fmt::format("coordinates reach to {} m", farthest));
        normals.push_back(*normal);
    }
    if (Result<void> checked = check_lights(lights); !checked) return pass_on(checked);
    std::vector<glm::dvec3> views;
    if (options.view) {
        Result<std::vector<glm::dvec3>> found = views_of(*options.view, receivers);
        if (!found) return pass_on(found);
        views = std::move(*found);
        if (!detail::has_luminance(options.view->material, options.method))
            return fail(
                Failure::unsupported,
                fmt::format("the method '{}' does not compute the luminance of this material", to_text(options.method)),
                "use the method exact or reference, or another material");
    }
    const bool surface = options.view.has_value();

    ProbeResult result;
    result.illuminance_lx.resize(receivers.size());
    if (options.method == IrradianceMethod::reference) result.illuminance_error_lx.resize(receivers.size());
    if (options.parts) result.parts_lx.resize(receivers.size() * lights.size());
    if (surface) result.luminance.resize(receivers.size());
    if (surface && options.parts) result.parts_nt.resize(receivers.size() * lights.size());
    if (receivers.empty() || lights.empty()) return result;

    // A task is one block of lights for a few receivers; if there are several blocks, their sums are added in order
    // afterwards.
    const std::size_t blocks = (lights.size() - 1) / lights_in_block + 1;
    const std::size_t group = std::clamp<std::size_t>(lights_in_block / lights.size(), 1, 1024);
    const std::size_t groups = (receivers.size() - 1) / group + 1;
    std::vector<Sums> sums(receivers.size() * blocks);
    std::vector<ProbeRemarks> remarks(groups * blocks);
    const detail::ProbeWay way{options.method, options.goal};
    parallel_for(groups * blocks, options.threads, [&](std::size_t task) {
        const std::size_t block = task % blocks;
        const std::size_t first = task / blocks * group;
        const std::size_t last_light = std::min(lights.size(), (block + 1) * lights_in_block);
        for (std::size_t r = first; r < std::min(receivers.size(), first + group); ++r) {
            Sums sum;
            for (std::size_t l = block * lights_in_block; l < last_light; ++l) {
                const detail::ProbeShare share =
                    detail::illuminance_of(lights[l], receivers[r].position, normals[r], way);
                detail::ProbeShine shine;
                if (surface)
                    shine = detail::luminance_of(lights[l], receivers[r].position, normals[r],
                                                 {options.view->material, views[r]}, share, way);
                sum.add({share.illuminance_lx, share.error_lx, shine.luminance});
                if (options.parts) result.parts_lx[r * lights.size() + l] = share.illuminance_lx;
                if (surface && options.parts) result.parts_nt[r * lights.size() + l] = shine.luminance;
                if (share.remark == detail::ProbeRemark::at_light) remarks[task].on_light.add({1, r, l});
                if (share.remark == detail::ProbeRemark::inside) remarks[task].inside.add({1, r, l});
                if (is_near_opening(lights[l], receivers[r].position)) remarks[task].near_point.add({1, r, l});
                if (at_ceiling(share.illuminance_lx) || at_ceiling(shine.luminance.diffuse.value) ||
                    at_ceiling(shine.luminance.specular.value))
                    remarks[task].at_ceiling.add({1, r, l});
                if (!share.converged || !shine.converged) remarks[task].not_converged.add({1, r, l});
            }
            sums[r * blocks + block] = sum;
        }
    });
    for (std::size_t r = 0; r < receivers.size(); ++r) {
        Sums sum;
        for (std::size_t block = 0; block < blocks; ++block)
            sum.add(sums[r * blocks + block]);
        result.illuminance_lx[r] = sum.illuminance_lx;
        if (!result.illuminance_error_lx.empty()) result.illuminance_error_lx[r] = sum.error_lx;
        if (surface) result.luminance[r] = sum.luminance;
        if (surface && !(glm::dot(normals[r], views[r]) > 0.0)) result.remarks.unseen.add({1, r, 0});
    }
    for (const ProbeRemarks& of_task : remarks)
        result.remarks.add(of_task);
    return result;
}

Diagnostics to_diagnostics(const ProbeRemarks& remarks, std::span<const Light> lights) {
    Diagnostics diagnostics;
    const auto say = [&](CodeOf<result_codes> code, std::string message, std::string hint) {
        diagnostics.push_back(result_diagnostic(code, std::move(message), std::move(hint)));
    };
    if (remarks.on_light.count > 0)
        say("RES0401",
            fmt::format("point {} lies on '{}', which counts as a point: its light is 0 there{}",
                        remarks.on_light.receiver + 1, lights[remarks.on_light.light].name,
                        others(remarks.on_light.count)),
            {});
    if (remarks.inside.count > 0)
        say("RES0402",
            fmt::format("point {} lies inside '{}', which lights it from everywhere{}", remarks.inside.receiver + 1,
                        lights[remarks.inside.light].name, others(remarks.inside.count)),
            {});
    if (remarks.unseen.count > 0)
        say("RES0403",
            fmt::format("point {} is seen from below its surface, where its luminance is 0{}",
                        remarks.unseen.receiver + 1,
                        remarks.unseen.count > 1 ? fmt::format("; {} such points in total", remarks.unseen.count)
                                                 : std::string()),
            "the view points from the surface to the eye");
    if (remarks.near_point.count > 0) {
        const Light& light = lights[remarks.near_point.light];
        say("RES0407",
            fmt::format("point {} is nearer to '{}' than five times its luminous opening ({}), and the light counts as "
                        "a point{}",
                        remarks.near_point.receiver + 1, light.name,
                        to_text(*std::get<ProfileShape>(light.shape).declared), others(remarks.near_point.count)),
            "--profile-size opening, or ies:FILE,opening in a rig, lets it emit from there; off says that a point is "
            "meant");
    }
    if (remarks.at_ceiling.count > 0)
        say("RES0203",
            fmt::format("the light of '{}' at point {} is limited to {} lx or cd/m2{}",
                        lights[remarks.at_ceiling.light].name, remarks.at_ceiling.receiver + 1,
                        shading::illuminance_ceiling, others(remarks.at_ceiling.count)),
            "use less light, or move it farther away");
    if (remarks.not_converged.count > 0)
        say("RES0202",
            fmt::format("the requested error was not reached at point {} under '{}'{}",
                        remarks.not_converged.receiver + 1, lights[remarks.not_converged.light].name,
                        others(remarks.not_converged.count)),
            "the estimates state the error that was reached");
    return diagnostics;
}

Spread spread(std::span<const double> values) {
    if (values.empty()) return {};
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    // A mean of values divided by the greatest cannot overflow, nor leave the interval by more than rounding.
    double sum = 0.0;
    for (const double value : values)
        sum += *greatest > 0.0 ? value / *greatest : 0.0;
    const double mean = *greatest * (sum / static_cast<double>(values.size()));
    return {*least, std::clamp(mean, *least, *greatest), *greatest};
}

} // namespace gonio
