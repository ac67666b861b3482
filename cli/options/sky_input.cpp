#include "sky_input.hpp"

#include "../sky/request.hpp"

#include <cstdlib>
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
    SkyRequest request;
    request.config = arguments.value("--ocio").value_or("");
    // The library never reads the environment; the tool passes $OCIO on.
    if (const char* const environment = std::getenv("OCIO"); environment != nullptr)
        request.environment_config = environment;
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

} // namespace gonio::cli
