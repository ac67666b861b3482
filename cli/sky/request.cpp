#include "request.hpp"

#include <gonio/asset/content_hash.hpp>
#include <gonio/base/codes/result.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/sky/sky_direction.hpp>
#include <gonio/sky/sky_measures.hpp>
#include <gonio/sky/sun_extraction.hpp>

#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace gonio::cli {

namespace {

// "room.exr" as "image:room.exr"; other texts as they are.
std::string in_the_grammar(const std::string& text) {
    if (text == "-") return "image:-";
    const std::string kind = text.substr(0, text.find(':'));
    const bool is_kind = std::any_of(sky_kinds().begin(), sky_kinds().end(),
                                     [&](const SkyKindInfo& known) { return known.name == kind; });
    if (is_kind) return text;
    const std::string_view file = file_before_keys(text);
    const bool shows_format = file.find('.') != std::string_view::npos && media::find_image_format(file) != nullptr;
    return shows_format ? "image:" + text : text;
}

Result<LoadedImage> read_image(const ImageSkyKind& kind, const SkyRequest& request, Diagnostics& diagnostics) {
    Result<std::string> bytes = kind.file == "-" ? read_standard_input(limit("environment-bytes"))
                                                 : read_file(kind.file, limit("environment-bytes"));
    if (!bytes) return pass_on(bytes);
    media::EnvironmentReadOptions options;
    options.layout = kind.layout;
    options.space = kind.space;
    options.bad_pixels = kind.bad_pixels;
    options.config = request.config;
    // A configuration of the environment does not hide a built-in space.
    if (options.config.empty() && find_rgb_space(kind.space) == nullptr) options.config = request.environment_config;
    Result<media::EnvironmentImage> image = media::decode_environment(*bytes, options, diagnostics);
    for (Diagnostic& one : image ? diagnostics : image.error().diagnostics)
        if (one.location.file.empty() && one.code.rfind("USE", 0) != 0) one.location.file = kind.file;
    if (!image) return pass_on(image);
    return LoadedImage{std::make_shared<const EnvironmentMap>(std::move(image->map)), image->pixel, sha256(*bytes), 0,
                       0.0};
}

// What lights a picture unevenly, and is blurred over its texels.
void warn_of_sun(const EnvironmentMap& map, Radians rotation, const std::string& file, unsigned threads,
                 Diagnostics& diagnostics) {
    const std::optional<BrightestSpot> spot = sun_like_spot(map, threads);
    if (!spot) return;
    const SkyAngles at = sky_angles_of(turned(spot->direction, rotation));
    diagnostics.push_back(result_diagnostic(
        "RES0504",
        fmt::format("{:.3g} % of the light comes from within {}° of azimuth {:.4g}°, elevation {:.4g}°",
                    100.0 * spot->share, spot_radius_deg, at.azimuth_deg, at.elevation_deg),
        "'gonio sky convert --cut-sun' takes a sun out of the pixels and reports it as a light", file));
}

// Takes the sun out of the image, and returns it in the frame of the turned sky.
Result<SunLight> cut_sun(LoadedImage& image, Radians rotation) {
    Result<ExtractedSun> found = extract_sun(*image.map);
    if (!found) return pass_on(found);
    image.map = std::make_shared<const EnvironmentMap>(std::move(found->sky));
    image.sun_texels = found->texels;
    image.sun_sr = found->region.value;
    found->sun.direction = turned(found->sun.direction, rotation);
    return found->sun;
}

} // namespace

Result<SkyRequest> plain_sky_request(const Arguments& arguments) {
    SkyRequest request;
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    request.threads = *threads;
    request.config = arguments.value("--ocio").value_or("");
    // The library never reads the environment; the tool passes $OCIO on.
    if (const char* const environment = std::getenv("OCIO"); environment != nullptr)
        request.environment_config = environment;
    return request;
}

Result<SkyRequest> sky_request(const Arguments& arguments) {
    Result<SkyRequest> plain = plain_sky_request(arguments);
    if (!plain) return plain;
    SkyRequest& request = *plain;
    request.cut_sun = arguments.has("--cut-sun");
    const auto facing = arguments.value("--facing");
    if (const auto lux = arguments.value("--calibrate")) {
        Calibration calibration;
        Result<double> value = parse_amount(*lux, Dimension::illuminance, "--calibrate");
        if (!value) return pass_on(value);
        calibration.value = *value;
        if (facing) {
            Result<SkyAngles> at = parse_sky_angles(*facing, "--facing");
            if (!at) return pass_on(at);
            calibration.normal = direction_of(*at);
        }
        request.calibration = calibration;
    } else if (facing) {
        return fail("USE0104", "--facing is the plane of --calibrate", "add --calibrate 500lx");
    }
    return plain;
}

std::string file_of_sky(const std::string& text) {
    const Result<SkyDescription> read = parse_sky_description(in_the_grammar(text));
    const auto* const image = read ? std::get_if<ImageSkyKind>(&read->kind) : nullptr;
    return image != nullptr ? image->file : std::string();
}

Result<LoadedSky> load_sky(const std::string& text, const SkyRequest& request) {
    Diagnostics diagnostics;
    Result<SkyDescription> description = parse_sky_description(in_the_grammar(text), &diagnostics);
    if (!description) return pass_on(description);
    Result<LoadedSky> loaded = load_sky(std::move(*description), request);
    if (loaded) loaded->diagnostics.insert(loaded->diagnostics.begin(), diagnostics.begin(), diagnostics.end());
    return loaded;
}

Result<LoadedSky> load_sky(const Rig& rig, const SkyRequest& request) {
    Result<LoadedSky> loaded = load_sky(*rig.sky, request);
    if (!loaded) return failed_sky(rig, loaded.error());
    return loaded;
}

Result<LoadedSky> load_sky(SkyDescription description, const SkyRequest& request) {
    LoadedSky loaded;
    loaded.kind = name_of(description.kind);
    const auto* const kind = std::get_if<ImageSkyKind>(&description.kind);
    if (kind == nullptr) {
        if (request.calibration || request.cut_sun)
            return fail("USE0107",
                        fmt::format("{} is for images, and '{}' is a formula",
                                    request.calibration ? "--calibrate" : "--cut-sun", loaded.kind),
                        request.calibration ? "its amount is a key: horizontal=500lx" : "its sun is a light already");
        Result<Sky> sky = resolve_sky(description);
        if (!sky) return pass_on(sky);
        loaded.sky = std::move(*sky);
        loaded.sun = loaded.sky.sun();
        return loaded;
    }
    if (request.calibration && description.amount)
        return fail("USE0107", "the image has two amounts", "leave --calibrate or the key of the image out");
    Result<LoadedImage> image = read_image(*kind, request, loaded.diagnostics);
    if (!image) return pass_on(image);
    // The calibration goes into the image, so that what is cut out of it or written has it too.
    Result<Sky> sky = resolve_sky(description, image->map, request.threads);
    if (!sky) return pass_on(sky);
    EnvironmentMap map = *image->map;
    map.set_nits_per_unit(map.nits_per_unit() * sky->image_scale());
    if (request.calibration) {
        Calibration calibration = *request.calibration;
        calibration.normal = turned(calibration.normal, Radians(-description.rotation.value));
        if (Result<void> scaled = calibrate(map, calibration, request.threads); !scaled) return pass_on(scaled);
    }
    image->map = std::make_shared<const EnvironmentMap>(std::move(map));
    if (request.cut_sun) {
        Result<SunLight> sun = cut_sun(*image, description.rotation);
        if (!sun) return pass_on(sun);
        loaded.sun = *sun;
    } else {
        warn_of_sun(*image->map, description.rotation, kind->file, request.threads, loaded.diagnostics);
    }
    description.amount.reset();
    sky = resolve_sky(description, image->map, request.threads);
    if (!sky) return pass_on(sky);
    loaded.sky = std::move(*sky);
    loaded.image = std::move(*image);
    return loaded;
}

} // namespace gonio::cli
