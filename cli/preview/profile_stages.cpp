#include "profile_stages.hpp"

#include <gonio/web/integrate.hpp>
#include <gonio/web/zones.hpp>

#include <utility>

namespace gonio::cli {

namespace {

// Where a luminaire that shines mostly upwards is shown.
const Stage& room_for_uplights() {
    static const Stage stage = [] {
        Stage room = make_stage("room").value();
        room.light.position.z = 1.8; // a floor lamp's height
        return room;
    }();
    return stage;
}

bool is_uplight(const Web& web) {
    return zone_flux(web, 90.0, 180.0).value > 0.5 * flux(web).value;
}

} // namespace

Result<ProfileStages::Shown> ProfileStages::show(const std::string& name, ProfileShape profile, RenderOptions options,
                                                 Diagnostics& diagnostics) {
    const Stage& stage = !is_chosen_ && is_uplight(*profile.web) ? room_for_uplights() : stage_;
    LightDescription description;
    description.name = name;
    description.shape = std::move(profile);
    hang(description, stage.light);
    Result<Light> light = resolve_light(std::move(description), diagnostics);
    if (!light) return pass_on(light);
    {
        const std::scoped_lock lock(mutex_);
        options.known = known_[&stage];
    }
    Result<Rendering> rendering = render(stage, {&*light, 1}, stage.camera, options);
    if (!rendering) return pass_on(rendering);
    {
        const std::scoped_lock lock(mutex_);
        known_[&stage] = rendering->indirect;
    }
    return Shown{&stage, std::move(*light), std::move(*rendering)};
}

} // namespace gonio::cli
