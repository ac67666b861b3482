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
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace gonio {

namespace {

constexpr std::array method_names{
    IrradianceMethodName{IrradianceMethod::exact, "exact",
                         "closed forms with horizon clipping, no distance guard; luminance by quadrature to 1e-6"},
    IrradianceMethodName{IrradianceMethod::reference, "reference",
                         "quadrature over the light to the error of --error, with an estimate of its own error"},
    IrradianceMethodName{
        IrradianceMethod::ltc, "ltc",
        "illuminance as exact; highlights of lights with a size summed at points that transformed cosines place"},
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
constexpr std::size_t integrals_in_task = 16; // of 0.1 to 1 ms each
constexpr double farthest = 1e100;            // [m]; differences and their products stay far from overflow
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

// Without `unseen`, which is about receivers alone.
std::array<ProbeOccurrence*, 5> occurrences_of_lights(ProbeRemarks& remarks) {
    return {&remarks.on_light, &remarks.inside, &remarks.near_point, &remarks.at_ceiling, &remarks.not_converged};
}

std::vector<std::size_t> lights_of(ProbeRemarks remarks) {
    std::vector<std::size_t> lights;
    for (const ProbeOccurrence* const each : occurrences_of_lights(remarks))
        if (each->count > 0) lights.push_back(each->light);
    return lights;
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

// The lights that were added, by whole blocks and the block that is not full yet.
class ProbeSum::Implementation {
public:
    static Result<std::unique_ptr<Implementation>> of(std::span<const Receiver> receivers,
                                                      const ProbeOptions& options) {
        auto made = std::make_unique<Implementation>();
        made->options_ = options;
        made->receivers_.assign(receivers.begin(), receivers.end());
        made->normals_.reserve(receivers.size());
        for (std::size_t i = 0; i < receivers.size(); ++i) {
            const std::optional<glm::dvec3> normal = unit_vector(receivers[i].normal);
            if (!normal) return fail("USE0106", fmt::format("the normal of point {} is zero or not finite", i + 1));
            if (!in_range(receivers[i].position))
                return fail("USE0106", fmt::format("the position of point {} is out of range", i + 1),
                            fmt::format("coordinates reach to {} m", farthest));
            made->normals_.push_back(*normal);
        }
        made->full_.resize(receivers.size());
        made->open_.resize(receivers.size());
        return made;
    }

    // After the lights, in the order of what probe() reports.
    Result<void> look() {
        if (!options_.view) return {};
        Result<std::vector<glm::dvec3>> found = views_of(*options_.view, receivers_);
        if (!found) return pass_on(found);
        views_ = std::move(*found);
        if (!detail::has_luminance(options_.view->material, options_.method))
            return fail(Failure::unsupported,
                        fmt::format("the method '{}' does not compute the luminance of this material",
                                    to_text(options_.method)),
                        "use the method exact or reference, or another material");
        return {};
    }

    // `parts`: of these lights alone; nullptr: not wanted.
    void add(std::span<const Light> lights, ProbeResult* parts) {
        if (receivers_.empty() || lights.empty()) {
            lights_ += lights.size();
            return;
        }
        // A task is one block of lights for a few receivers; the sums of blocks are added in order afterwards. The
        // first block goes on with the one that was not full.
        const std::size_t in_open = lights_ % lights_in_block;
        const std::size_t blocks = (in_open + lights.size() - 1) / lights_in_block + 1;
        const bool integrates = std::any_of(lights.begin(), lights.end(), [&](const Light& light) {
            return detail::is_integrated(light, options_.method);
        });
        const std::size_t in_task = integrates ? integrals_in_task : lights_in_block;
        const std::size_t group = std::clamp<std::size_t>(in_task / lights.size(), 1, 1024);
        const std::size_t groups = (receivers_.size() - 1) / group + 1;
        std::vector<Sums> sums(receivers_.size() * blocks);
        std::vector<ProbeRemarks> remarks(groups * blocks);
        parallel_for(groups * blocks, options_.threads, [&](std::size_t task) {
            const std::size_t block = task % blocks;
            const std::size_t first = task / blocks * group;
            const std::size_t first_light = block == 0 ? 0 : block * lights_in_block - in_open;
            const std::size_t last_light = std::min(lights.size(), (block + 1) * lights_in_block - in_open);
            for (std::size_t r = first; r < std::min(receivers_.size(), first + group); ++r) {
                Sums& sum = sums[r * blocks + block];
                if (block == 0) sum = open_[r];
                for (std::size_t l = first_light; l < last_light; ++l)
                    add(lights, l, r, sum, remarks[task], parts);
            }
        });
        lights_ += lights.size();
        const bool is_open = lights_ % lights_in_block != 0;
        for (std::size_t r = 0; r < receivers_.size(); ++r) {
            for (std::size_t block = 0; block + (is_open ? 1 : 0) < blocks; ++block)
                full_[r].add(sums[r * blocks + block]);
            open_[r] = is_open ? sums[(r + 1) * blocks - 1] : Sums();
        }
        for (const ProbeRemarks& of_task : remarks)
            remarks_.add(of_task);
    }

    ProbeResult result() const {
        ProbeResult result;
        const bool has_error = options_.method == IrradianceMethod::reference;
        const bool surface = options_.view.has_value();
        result.illuminance_lx.reserve(receivers_.size());
        result.remarks = remarks_;
        for (std::size_t r = 0; r < receivers_.size(); ++r) {
            Sums sum = full_[r];
            if (lights_ % lights_in_block != 0) sum.add(open_[r]);
            result.illuminance_lx.push_back(sum.illuminance_lx);
            if (has_error) result.illuminance_error_lx.push_back(sum.error_lx);
            if (surface) result.luminance.push_back(sum.luminance);
            if (surface && lights_ > 0 && !(glm::dot(normals_[r], views_[r]) > 0.0))
                result.remarks.unseen.add({1, r, 0});
        }
        return result;
    }

    std::size_t lights() const { return lights_; }
    std::size_t receivers() const { return receivers_.size(); }
    const ProbeRemarks& remarks() const { return remarks_; }

    std::map<std::size_t, Light> remarked; // the lights of remarks(), by their number

private:
    // One light at one receiver.
    void add(std::span<const Light> lights, std::size_t l, std::size_t r, Sums& sum, ProbeRemarks& remarks,
             ProbeResult* parts) const {
        const Light& light = lights[l];
        const detail::ProbeWay way{options_.method, options_.goal};
        const glm::dvec3& position = receivers_[r].position;
        const detail::ProbeShare share = detail::illuminance_of(light, position, normals_[r], way);
        const bool surface = options_.view.has_value();
        detail::ProbeShine shine;
        if (surface)
            shine =
                detail::luminance_of(light, position, normals_[r], {options_.view->material, views_[r]}, share, way);
        sum.add({share.illuminance_lx, share.error_lx, shine.luminance});
        if (parts != nullptr) parts->parts_lx[r * lights.size() + l] = share.illuminance_lx;
        if (parts != nullptr && surface) parts->parts_nt[r * lights.size() + l] = shine.luminance;
        const ProbeOccurrence here{1, r, lights_ + l};
        if (share.remark == detail::ProbeRemark::at_light) remarks.on_light.add(here);
        if (share.remark == detail::ProbeRemark::inside) remarks.inside.add(here);
        if (is_near_opening(light, position)) remarks.near_point.add(here);
        if (at_ceiling(share.illuminance_lx) || at_ceiling(shine.luminance.diffuse.value) ||
            at_ceiling(shine.luminance.specular.value))
            remarks.at_ceiling.add(here);
        if (!share.converged || !shine.converged) remarks.not_converged.add(here);
    }

    ProbeOptions options_;
    std::vector<Receiver> receivers_;
    std::vector<glm::dvec3> normals_; // unit, and so are the views
    std::vector<glm::dvec3> views_;
    std::vector<Sums> full_; // of each receiver
    std::vector<Sums> open_;
    std::size_t lights_ = 0;
    ProbeRemarks remarks_;
};

Result<ProbeResult> probe(std::span<const Light> lights, std::span<const Receiver> receivers,
                          const ProbeOptions& options) {
    Result<std::unique_ptr<ProbeSum::Implementation>> sum = ProbeSum::Implementation::of(receivers, options);
    if (!sum) return pass_on(sum);
    if (Result<void> checked = check_lights(lights); !checked) return pass_on(checked);
    if (Result<void> looked = (*sum)->look(); !looked) return pass_on(looked);
    ProbeResult parts;
    if (options.parts) parts.parts_lx.resize(receivers.size() * lights.size());
    if (options.parts && options.view) parts.parts_nt.resize(receivers.size() * lights.size());
    (*sum)->add(lights, options.parts ? &parts : nullptr);
    ProbeResult result = (*sum)->result();
    result.parts_lx = std::move(parts.parts_lx);
    result.parts_nt = std::move(parts.parts_nt);
    return result;
}

ProbeSum::ProbeSum(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}
ProbeSum::ProbeSum(ProbeSum&& other) noexcept = default;
ProbeSum& ProbeSum::operator=(ProbeSum&& other) noexcept = default;
ProbeSum::~ProbeSum() = default;

Result<ProbeSum> ProbeSum::of(std::span<const Receiver> receivers, const ProbeOptions& options) {
    Result<std::unique_ptr<Implementation>> made = Implementation::of(receivers, options);
    if (!made) return pass_on(made);
    if (Result<void> looked = (*made)->look(); !looked) return pass_on(looked);
    return ProbeSum(std::move(*made));
}

Result<void> ProbeSum::add(std::span<const Light> lights) {
    if (Result<void> checked = check_lights(lights); !checked) return checked;
    const std::size_t first = implementation_->lights();
    implementation_->add(lights, nullptr);
    std::map<std::size_t, Light>& remarked = implementation_->remarked;
    const std::vector<std::size_t> wanted = lights_of(implementation_->remarks());
    for (const std::size_t light : wanted)
        if (light >= first) remarked.emplace(light, lights[light - first]);
    std::erase_if(remarked, [&](const auto& known) {
        return std::find(wanted.begin(), wanted.end(), known.first) == wanted.end();
    });
    return {};
}

std::size_t ProbeSum::lights() const {
    return implementation_->lights();
}

ProbeResult ProbeSum::result() const {
    ProbeResult result = implementation_->result();
    const std::map<std::size_t, Light>& remarked = implementation_->remarked;
    for (ProbeOccurrence* const each : occurrences_of_lights(result.remarks))
        if (each->count > 0)
            each->light = static_cast<std::size_t>(std::distance(remarked.begin(), remarked.find(each->light)));
    return result;
}

std::vector<Light> ProbeSum::remarked() const {
    std::vector<Light> lights;
    for (const auto& [number, light] : implementation_->remarked)
        lights.push_back(light);
    return lights;
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
