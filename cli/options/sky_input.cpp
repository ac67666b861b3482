#include "sky_input.hpp"

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

// With the sun of daylight as a light.
Result<SkyInput> input_of(LoadedSky loaded, Diagnostics& diagnostics) {
    SkyInput input;
    diagnostics.insert(diagnostics.end(), loaded.diagnostics.begin(), loaded.diagnostics.end());
    input.sky = std::move(loaded.sky);
    input.is_given = true;
    if (loaded.image) input.source.sha256 = std::move(loaded.image->sha256);
    if (loaded.sun) {
        Result<LightDescription> sun = described(*loaded.sun);
        if (!sun) return pass_on(sun);
        input.sun = std::move(*sun);
    }
    return input;
}

} // namespace

Result<SkyInput> sky_of_rig(const Rig& rig, const SkyRequest& request, Diagnostics& diagnostics) {
    if (!rig.sky) return SkyInput();
    Result<LoadedSky> loaded = load_sky(rig, request);
    if (!loaded) return pass_on(loaded);
    Result<SkyInput> input = input_of(std::move(*loaded), diagnostics);
    if (input) input->source.text = rig.source;
    return input;
}

Result<SkyInput> sky_input(const Arguments& arguments, const Rig& rig, Diagnostics& diagnostics) {
    Result<SkyRequest> plain = plain_sky_request(arguments);
    if (!plain) return pass_on(plain);
    const SkyRequest& request = *plain;
    const auto text = arguments.value("--sky");
    if (!text) return sky_of_rig(rig, request, diagnostics);
    Result<LoadedSky> loaded = load_sky(*text, request);
    if (!loaded) return pass_on(loaded);
    Result<SkyInput> input = input_of(std::move(*loaded), diagnostics);
    if (!input) return input;
    input->source.text = *text;
    if (std::string file = file_of_sky(*text); !file.empty()) input->files.push_back(std::move(file));
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
    Result<SkyInput> sky = sky_input(arguments, input.lights.rig, diagnostics);
    if (!sky) return pass_on(sky);
    input.sky = std::move(*sky);
    if (input.sky.sun) input.lights.others.push_back(*input.sky.sun);
    input.lights.files.insert(input.lights.files.end(), input.sky.files.begin(), input.sky.files.end());
    return input;
}

} // namespace gonio::cli
