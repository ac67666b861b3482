#include <gonio/base/parallel.hpp>
#include <gonio/light/light_parts.hpp>
#include <gonio/light/luminaire.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/scene/detail/light_resolver.hpp>
#include <gonio/scene/detail/rig_stream.hpp>
#include <gonio/scene/rig.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace gonio {

namespace {

// Where the rig has it.
std::string place_of_light(const Rig& rig, std::size_t index) {
    const auto after = std::upper_bound(rig.places.begin(), rig.places.end(), index,
                                        [](std::size_t i, const LightsPlace& place) { return i < place.first; });
    return after == rig.places.begin() ? fmt::format("lights[{}]", index) : std::prev(after)->path;
}

constexpr std::size_t block_size = 1024;
constexpr std::size_t none = static_cast<std::size_t>(-1);

// The values of the shape's keys, of any kind.
std::vector<double> numbers_of(const Shape& shape) {
    struct Number {
        double operator()(Meters length) const { return length.value; }
        double operator()(Radians angle) const { return angle.value; }
        double operator()(bool there) const { return there ? 1.0 : 0.0; }
        double operator()(Falloff falloff) const { return static_cast<double>(falloff); }
    };
    std::vector<double> numbers;
    for (const ShapeValue& value : values_of(shape))
        numbers.push_back(std::visit(Number(), value.value));
    return numbers;
}

// Combines frame, name, colour and range of the description with another resolved light of the same emission.
Result<Light> like(const Light& prototype, LightDescription description, Diagnostics& diagnostics) {
    description.shape = PointShape{};
    description.intensity = PhotometricValue{0.0, {find_unit("cd"), std::nullopt, std::nullopt}};
    Result<Light> placement = resolve_light(std::move(description), diagnostics);
    if (!placement) return placement;
    Light light = prototype;
    light.name = std::move(placement->name);
    light.frame = placement->frame;
    light.color = placement->color;
    light.range = placement->range;
    light.emitted_by = placement->emitted_by;
    if (Result<void> parts = place_parts(light); !parts) return pass_on(parts);
    return light;
}

} // namespace

namespace detail {

// Nothing for lights without either: they need only arithmetic.
std::optional<LightResolver::Emitter> LightResolver::emitter_of(const LightDescription& light) {
    const void* const pattern = pattern_of(light.shape);
    if (pattern == nullptr) return std::nullopt;
    const auto* const profile = std::get_if<ProfileShape>(&light.shape);
    const PhotometricValue value = light.intensity.value_or(PhotometricValue{});
    return Emitter{light.shape.index(),
                   numbers_of(light.shape),
                   pattern,
                   profile != nullptr ? profile->opening() : nullptr,
                   value.unit.unit != nullptr ? value.unit.unit->symbol : std::string_view(),
                   value.number,
                   value.unit.distance.value_or(Meters()).value,
                   value.unit.efficacy_lm_per_w.value_or(0.0),
                   light.level};
}

Result<std::vector<Light>> LightResolver::resolve(std::span<LightDescription> descriptions, const Place& place) {
    std::vector<std::size_t> first_light;                        // of each new kind of emitter
    std::vector<std::size_t> emitter(descriptions.size(), none); // of each light
    const std::size_t known_before = prototypes_.size();
    for (std::size_t i = 0; i < descriptions.size(); ++i) {
        const std::optional<Emitter> key = emitter_of(descriptions[i]);
        if (!key) continue;
        const auto [at, added] = known_.emplace(*key, known_before + first_light.size());
        if (added) first_light.push_back(i);
        emitter[i] = at->second;
    }

    std::vector<Light> lights(descriptions.size());
    std::vector<Diagnostics> noticed(descriptions.empty() ? 0 : (descriptions.size() - 1) / block_size + 1);
    std::vector<std::optional<Error>> errors(std::max(noticed.size(), first_light.size()));
    const auto first_error = [&]() -> Error* {
        const auto found = std::find_if(errors.begin(), errors.end(), [](const auto& e) { return e.has_value(); });
        return found == errors.end() ? nullptr : &**found;
    };
    const auto at = [&](const Error& error, std::size_t i) { return placed(error, source_, place(i)).value(); };

    make_bodies(descriptions, first_light);
    prototypes_.resize(known_before + first_light.size());
    std::vector<Diagnostics> noticed_in_webs(first_light.size());
    parallel_for(first_light.size(), threads_, [&](std::size_t e) {
        Result<Light> light = resolve_light(descriptions[first_light[e]], noticed_in_webs[e], bodies_);
        if (light)
            prototypes_[known_before + e] = std::move(*light);
        else
            errors[e] = at(light.error(), first_light[e]);
    });
    if (Error* const error = first_error()) return Unexpected(std::move(*error));

    parallel_for(noticed.size(), threads_, [&](std::size_t b) {
        const std::size_t end = std::min(lights.size(), (b + 1) * block_size);
        for (std::size_t i = b * block_size; i < end; ++i) {
            Result<Light> light = emitter[i] == none
                                      ? resolve_light(std::move(descriptions[i]), noticed[b])
                                      : like(prototypes_[emitter[i]], std::move(descriptions[i]), noticed[b]);
            if (!light) {
                errors[b] = at(light.error(), i);
                return;
            }
            lights[i] = std::move(*light);
        }
    });
    if (Error* const error = first_error()) return Unexpected(std::move(*error));
    for (Diagnostics& list : noticed_in_webs)
        std::move(list.begin(), list.end(), std::back_inserter(noticed_in_webs_));
    for (Diagnostics& list : noticed)
        std::move(list.begin(), list.end(), std::back_inserter(noticed_));
    return lights;
}

// Of the openings that these lights have and no light before them.
void LightResolver::make_bodies(std::span<const LightDescription> lights, std::span<const std::size_t> of) {
    std::vector<std::pair<const Web*, const Opening*>> missing;
    for (const std::size_t light : of) {
        const auto* const profile = std::get_if<ProfileShape>(&lights[light].shape);
        const Opening* const opening = profile != nullptr ? profile->opening() : nullptr;
        if (opening == nullptr || opening->shape == OpeningShape::point) continue;
        if (bodies_.try_emplace({profile->web.get(), opening}).second)
            missing.emplace_back(profile->web.get(), opening);
    }
    parallel_for(missing.size(), threads_, [&](std::size_t i) {
        bodies_.find(missing[i])->second = opening_body(*missing[i].second, *missing[i].first);
    });
}

Diagnostics LightResolver::noticed() {
    Diagnostics all = std::move(noticed_in_webs_);
    std::move(noticed_.begin(), noticed_.end(), std::back_inserter(all));
    return all;
}

} // namespace detail

Result<std::vector<Light>> resolve_lights(Rig rig, Diagnostics& diagnostics, unsigned threads) {
    std::move(rig.diagnostics.begin(), rig.diagnostics.end(), std::back_inserter(diagnostics));
    detail::LightResolver resolver(rig.source, threads);
    Result<std::vector<Light>> lights =
        resolver.resolve(rig.lights, [&rig](std::size_t i) { return place_of_light(rig, i); });
    if (!lights) return lights;
    Diagnostics noticed = resolver.noticed();
    std::move(noticed.begin(), noticed.end(), std::back_inserter(diagnostics));
    return lights;
}

} // namespace gonio
