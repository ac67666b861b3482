#include <gonio/asset/detail/target_files.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/base/kind_text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>

namespace gonio {

namespace {

constexpr std::array all{
    Target{
        "babylon", "Babylon.js: a module that makes a spot light with a profile texture",
        "import { makeLight } from './NAME.js' and call makeLight(scene); it shines down -Y from the origin until "
        "moved.",
        "Babylon.js 9.34 in Node.js makes the light, and its texture, sampled as the shader does, has the profile's "
        "means "
        "over C.",
        "No picture was rendered. Babylon looks the profile up by the angle to the axis alone: azimuths are averaged.",
        asset_detail::babylon_files},
    Target{
        "blender", "Blender: a script that makes a point light with the profile inside",
        "Run NAME.py in Blender's text editor, or blender --background --python NAME.py; the light is the new object "
        "NAME, its beam along -Z, C0 along +X.",
        "Cycles of Blender 3.4: the illuminance of a plane is that of the profile, to 0.01 % in the mean and 0.8 % of "
        "the greatest anywhere, counting 177.83 lm for a watt as Blender's IES node does.",
        "EEVEE ignores IES nodes. Between the table's lines Cycles interpolates by cubics, which differs a little "
        "from every other reader.",
        asset_detail::blender_files},
    Target{"gltf", "glTF 2.0, .gltf and .glb: EXT_lights_ies with a KHR_lights_punctual fallback",
           "Load NAME.gltf (with NAME.ies beside it) or NAME.glb (all in one file): its node NAME shines down -Y, C0 "
           "along +X.",
           "The Khronos validator finds no error. It does not know EXT_lights_ies, whose schema and indices are tested "
           "here.",
           "Readers of EXT_lights_ies are few, and treat azimuths in their own way. Others see the fallback: a spot or "
           "point light of the same flux, without the profile.",
           asset_detail::gltf_files},
    Target{
        "pbrt", "pbrt-v4: an equal-area image and a scene snippet of a goniometric light",
        "Include \"NAME.pbrt\" in the world block of a scene, after the transformation to the luminaire's place: the "
        "beam goes along -Z, C0 along +X.",
        "The image's equal-area mapping was evaluated again by an independent program: intensities and flux agree.",
        "pbrt itself was not run. It looks the image up without filtering, and `power` gives it the flux in lumens.",
        asset_detail::pbrt_files},
    Target{"raw", "the portable IES file alone, for every other program",
           "Give NAME.ies to the program's own importer: factors, TILT, flux and turn are numbers of its table.",
           "The file is read again by gonio, and the light that comes out is the one that was asked for.",
           "What a program makes of azimuths, and whether it takes candela as absolute, is its own.",
           asset_detail::raw_files},
    Target{"threejs", "three.js: a module that makes an IESSpotLight for WebGPURenderer",
           "import { makeLight } from './NAME.js', add the light and its target to the scene, and use WebGPURenderer.",
           "three.js r187 in Node.js makes the light, and its texture, sampled as the shader does, has the profile's "
           "intensities in every direction.",
           "No picture was rendered. Releases before r187 take C = 180 for every azimuth, and WebGLRenderer ignores "
           "profiles.",
           asset_detail::threejs_files},
    Target{"usd", "OpenUSD, .usda: a sphere light treated as a point, shaped by the profile",
           "Reference NAME.usda (with NAME.ies beside it): the light NAME shines along -Z, in metres, Z up.",
           "Nothing was run: the text follows UsdLux 24.08.",
           "UsdLux does not state where azimuth 0 lies, and renderers disagree whether candela are absolute: check one "
           "lamp, and scale inputs:intensity once for your renderer.",
           asset_detail::usd_files},
};

} // namespace

std::span<const Target> targets() {
    return all;
}

Result<const Target*> find_target(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Target& target : all) {
        if (target.name == name) return &target;
        names.push_back(target.name);
    }
    return unknown_name("target", name, names);
}

std::string target_readme(const Target& target) {
    return fmt::format("How to use it: {}\nVerified: {}\nNot verified: {}\n", target.use, target.verified,
                       target.unverified);
}

namespace asset_detail {

std::string describe(const MeasuredLight& light) {
    std::string file;
    for (const char c : light.source_file)
        file += static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e ? '?' : c;
    return fmt::format("{:.6g} lm, peak {:.6g} cd, of {}", light.flux.value, light.peak.value, file);
}

std::string quoted(std::string_view text) {
    return nlohmann::json(std::string(text)).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

} // namespace asset_detail

} // namespace gonio
