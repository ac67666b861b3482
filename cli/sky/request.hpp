// The skies of `gonio sky`: by formula or from an image, calibrated, with the sun cut out.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/media/environment_file.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/sky.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace gonio::cli {

inline constexpr std::array sky_image_options{
    Option{"--calibrate", "LUX", "scale an image so that an open plane has this illuminance: 500lx"},
    Option{"--facing", "AZ/EL", "the plane of --calibrate: where it faces, in degrees (0/90: up)"},
    Option{"--cut-sun", "", "take the sun out of an image and report it as a light"},
    Option{"--ocio", "FILE", "OpenColorIO configuration for space= ($OCIO, else built in)"},
};

struct SkyRequest {
    std::optional<Calibration> calibration;
    bool cut_sun = false;
    std::string config;             // --ocio
    std::string environment_config; // $OCIO, for names that are not built in
    unsigned threads = 0;
};

// With the colour configurations of --ocio and $OCIO and the threads of -j alone: for commands that take a sky as it
// is.
Result<SkyRequest> plain_sky_request(const Arguments& arguments);

Result<SkyRequest> sky_request(const Arguments& arguments);

// Of an image: how it was stored, and what became of it.
struct LoadedImage {
    std::shared_ptr<const EnvironmentMap> map; // calibrated, without a sun that was cut out
    media::Pixel pixel = media::Pixel::float32;
    std::string sha256; // of the file's bytes
    std::size_t sun_texels = 0;
    double sun_sr = 0.0;
};

struct LoadedSky {
    std::string_view kind; // "image"
    Sky sky;
    std::optional<SunLight> sun; // of daylight, or cut out of an image
    std::optional<LoadedImage> image;
    Diagnostics diagnostics;
};

// The file that the text names: "room.exr", "image:room.exr,rotate=30deg", "-" for stdin; empty for a sky by formula.
std::string file_of_sky(const std::string& text);

// A sky that is described, with its image read. Fails as decode_environment and calibrate do.
Result<LoadedSky> load_sky(SkyDescription description, const SkyRequest& request);

// That of a rig, which has one. The error has the place in the rig in front.
Result<LoadedSky> load_sky(const Rig& rig, const SkyRequest& request);

// A sky in its grammar, or the name of an image. Fails as parse_sky_description, decode_environment and calibrate do.
Result<LoadedSky> load_sky(const std::string& text, const SkyRequest& request);

} // namespace gonio::cli
