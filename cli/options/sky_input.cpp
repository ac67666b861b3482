#include "sky_input.hpp"

#include "../sky/request.hpp"
#include "light_input.hpp"
#include "profile_size.hpp"

#include <utility>

namespace gonio::cli {

namespace {

Result<LightDescription> described(const SunLight& sun) {
    LightDescription light;
    light.name = "sun";
    light.shape = SunShape{sun.diameter};
    Result<PhotometricUnit> lux = parse_photometric_unit("lx");
    if (!lux) return pass_on(lux);
    light.intensity = PhotometricValue{sun.illuminance.value, *lux};
    light.color = sun.color;
    light.direction = -sun.direction;
    return light;
}

} // namespace

Result<SkyInput> sky_input(const Arguments& arguments, const std::optional<SkyDescription>& of_rig,
                           Diagnostics& diagnostics) {
    SkyInput input;
    const auto text = arguments.value("--sky");
    if (!text && !of_rig) return input;
    const SkyRequest request = sky_request_of_colors(arguments);
    Result<LoadedSky> loaded = text ? load_sky(*text, request) : load_sky(*of_rig, request);
    if (!loaded) return pass_on(loaded);
    diagnostics.insert(diagnostics.end(), loaded->diagnostics.begin(), loaded->diagnostics.end());
    input.sky = std::move(loaded->sky);
    input.is_given = true;
    if (std::string file = text ? file_of_sky(*text) : std::string(); !file.empty())
        input.files.push_back(std::move(file));
    if (loaded->sun) {
        Result<LightDescription> sun = described(*loaded->sun);
        if (!sun) return pass_on(sun);
        input.sun = std::move(*sun);
    }
    return input;
}

Result<LightsAndSky> lights_and_sky(const Arguments& arguments, const LightPlacement& placement, ProfileSize usual,
                                    Diagnostics& diagnostics) {
    LightsAndSky input;
    const bool asks_for_light =
        arguments.has("--rig") || !given_light_option(arguments).empty() || !arguments.positional().empty();
    // A sky is light enough, and so is a surface that emits.
    if (asks_for_light || !(arguments.has("--sky") || arguments.has("--emits"))) {
        Result<LightsInput> lights = lights_input(arguments, placement, diagnostics);
        if (!lights) return pass_on(lights);
        input.lights = std::move(*lights);
        if (Result<void> sized = set_profile_sizes(arguments, usual, input.lights.rig.lights); !sized)
            return pass_on(sized);
    }
    Result<SkyInput> sky = sky_input(arguments, input.lights.rig.sky, diagnostics);
    if (!sky) return pass_on(sky);
    input.sky = std::move(*sky);
    if (input.sky.sun) input.lights.others.push_back(*input.sky.sun);
    input.lights.files.insert(input.lights.files.end(), input.sky.files.begin(), input.sky.files.end());
    return input;
}

} // namespace gonio::cli
