#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/base/named.hpp>

#include <fmt/format.h>

#include <array>

namespace gonio {

// Each is defined in the target's own file.
namespace asset_detail {
std::vector<AssetFile> babylon_files(const SceneContent& scene);
std::vector<AssetFile> filament_files(const SceneContent& scene);
std::vector<AssetFile> gltf_files(const SceneContent& scene);
std::vector<AssetFile> godot_files(const SceneContent& scene);
std::vector<AssetFile> luxcore_files(const SceneContent& scene);
std::vector<AssetFile> playcanvas_files(const SceneContent& scene);
std::vector<AssetFile> raw_files(const SceneContent& scene);
std::vector<AssetFile> threejs_files(const SceneContent& scene);
std::vector<AssetFile> unity_files(const SceneContent& scene);
std::vector<AssetFile> unreal_files(const SceneContent& scene);
} // namespace asset_detail

namespace {

// Kinds of light that targets have besides profiles.
constexpr std::array point_sun{LightKind::point, LightKind::sun};
constexpr std::array point_disk_rect_sun{LightKind::point, LightKind::disk, LightKind::rect, LightKind::sun};
constexpr std::array point_rect_sun{LightKind::point, LightKind::rect, LightKind::sun};
constexpr std::array point_rect_tube_sun{LightKind::point, LightKind::rect, LightKind::tube, LightKind::sun};
constexpr std::array point_sphere_rect_sun{LightKind::point, LightKind::sphere, LightKind::rect, LightKind::sun};
constexpr std::array all_kinds{LightKind::point, LightKind::sphere, LightKind::disk,     LightKind::ellipse,
                               LightKind::rect,  LightKind::tube,   LightKind::cylinder, LightKind::sun};
// A cylinder has no caps.
constexpr std::array all_kinds_but_tubes{LightKind::point, LightKind::sphere,   LightKind::disk, LightKind::ellipse,
                                         LightKind::rect,  LightKind::cylinder, LightKind::sun};

constexpr TargetSky latlong{SkyPictureKind::latlong, false, false, {}};
constexpr TargetSky latlong_or_uniform{SkyPictureKind::latlong, true, false, {}};
constexpr TargetSky hidden_latlong_or_uniform{SkyPictureKind::latlong, true, true, {}};
constexpr TargetSky latlong_hdr{SkyPictureKind::latlong_hdr, false, false, {}};
constexpr TargetSky rgbe_or_uniform{SkyPictureKind::latlong_rgbe, true, false, {}};
constexpr TargetSky equal_area_or_uniform{SkyPictureKind::equal_area, true, false, {}};
constexpr TargetSky no_gltf_sky{
    SkyPictureKind::none, false, false,
    "glTF has no skies of its own, and the extension EXT_lights_image_based takes filtered pictures of 8 bits"};

constexpr TargetSky no_filament_sky{SkyPictureKind::none, false, false,
                                    "Filament reads skies as KTX files that its own tool, cmgen, filters"};
constexpr TargetSky no_playcanvas_sky{SkyPictureKind::none, false, false,
                                      "PlayCanvas keeps a sky as a picture of 8 bits that it filters itself"};

// Projectors within the cone of a spot lose too many texels when they are wider.
constexpr double widest_cone_deg = 75.0;
constexpr TargetImages in_cones{widest_cone_deg, false, {}};
constexpr TargetImages in_narrow_cones{60.0, false, {}}; // Godot's cones are wider than their light
constexpr TargetImages everywhere{90.0, true, {}};
constexpr TargetImages panels_alone{0.0, true, {}};

constexpr TargetHolds gltf_holds{
    point_disk_rect_sun, Falloff::frostbite, true, false, 90.0, TargetLength::meter, false, false, no_gltf_sky};
constexpr TargetHolds babylon_holds{
    point_rect_sun, Falloff::frostbite, true, true, 90.0, TargetLength::any, false, false, latlong_hdr, {}, false, true,
    false};
constexpr TargetHolds filament_holds{point_sun,
                                     Falloff::frostbite,
                                     true,
                                     true,
                                     90.0,
                                     TargetLength::any,
                                     false,
                                     false,
                                     no_filament_sky,
                                     {},
                                     false,
                                     false,
                                     true,
                                     true};
constexpr TargetHolds playcanvas_holds{point_sun, Falloff::smoothstep_cos, true, true, 89.0, TargetLength::any, false,
                                       false,     no_playcanvas_sky};
constexpr TargetHolds threejs_holds{
    point_rect_sun, Falloff::smoothstep_cos, true, true, 90.0, TargetLength::any, false, false, latlong, in_cones};
constexpr TargetHolds blender_holds{
    all_kinds,  std::nullopt, false, false, 90.0, TargetLength::any, false, false, hidden_latlong_or_uniform,
    everywhere, true};
constexpr TargetHolds pbrt_holds{all_kinds, Falloff::smoothstep_cos, true,      false, 90.0, TargetLength::any, false,
                                 false,     equal_area_or_uniform,   everywhere};
constexpr TargetHolds mitsuba_holds{all_kinds, Falloff::linear_angle, true,      false, 90.0, TargetLength::any, false,
                                    false,     latlong_or_uniform,    everywhere};
constexpr TargetHolds luxcore_holds{all_kinds, std::nullopt,       false,       false, 90.0, TargetLength::any, false,
                                    false,     latlong_or_uniform, panels_alone};
constexpr TargetHolds radiance_holds{all_kinds,         std::nullopt, false, false,          90.0,
                                     TargetLength::any, false,        false, rgbe_or_uniform};
constexpr TargetHolds usd_holds{all_kinds_but_tubes,
                                Falloff::smoothstep_angle,
                                true,
                                false,
                                90.0,
                                TargetLength::any,
                                false,
                                false,
                                latlong_or_uniform,
                                panels_alone};
constexpr TargetHolds godot_holds{
    point_rect_sun, Falloff::linear_cos, false, true, 90.0, TargetLength::meter, true, false, latlong, in_narrow_cones};
constexpr TargetHolds unity_holds{
    point_rect_tube_sun, Falloff::frostbite, true, true, 89.0, TargetLength::meter, true, false, latlong, in_cones};
constexpr TargetHolds unreal_holds{
    point_sphere_rect_sun, Falloff::frostbite, true, true, 80.0, TargetLength::centimeter, false, true, latlong_hdr};
constexpr TargetHolds raw_holds{{}, std::nullopt, false, false, 90.0, TargetLength::none, false, false, latlong};

constexpr std::array all{
    Target{
        "babylon", "Babylon.js: a module that makes the lights, with profile textures",
        "import { makeLights } from './NAME.js' and call makeLights(scene), which returns them; a luminaire alone "
        "shines down "
        "-Y from the origin until moved. addSky(scene), where there is a sky, sets the scene's environment.",
        "Babylon.js 9.34 in Node.js makes the lights, which light points as the rig's do; textures, sampled as the "
        "shader does, have the profile's means over C. The cube that it makes of a sky gives five planes their lux to "
        "1 %. In Chromium it draws points, spots, rectangles, suns and skies as probe has them, to 0.4 %.",
        "Babylon looks the profile up by the angle to the axis alone: azimuths are averaged, and a street light is off "
        "by 57 "
        "%. The highlights of rectangles need tables that Babylon loads from its own server.",
        babylon_holds, asset_detail::babylon_files},
    Target{
        "blender", "Blender: a script that makes the lights for Cycles, with the profiles inside",
        "Run NAME.py in Blender's text editor, or blender --background --python NAME.py; the new objects are named as "
        "the "
        "lights, a luminaire alone NAME, its beam along -Z, C0 along +X. A sky becomes the world of the scene.",
        "Cycles of Blender 3.4: the illuminance of a plane is that of the profile, to 0.01 % in the mean and 0.8 % of "
        "the greatest anywhere, and that of a rig's lights of every kind to 0.1 % in the mean, luminaires with a size, "
        "masks and images among them; a stage under a sky to 0.2 % in the mean; 177.83 lm are a watt, as Blender's IES "
        "node counts.",
        "EEVEE ignores IES nodes, so that profiles, spots and images are lost, and meshes do not light it. Between the "
        "table's lines Cycles interpolates by cubics, which differs a little "
        "from every other reader; near a sphere light, older Cycles samples a disk in its place.",
        blender_holds, asset_detail::blender_files},
    Target{"filament", "Filament: a module for its WebAssembly that makes the lights",
           "import { makeLights } from './NAME.js' and call makeLights(Filament, engine, scene), which returns their "
           "entities by name; a luminaire alone shines down -Y from the origin. With setExposureDirect(1) a pixel is a "
           "luminance.",
           "Filament 1.53 draws points, spots and suns as probe has them, to 0.3 %.",
           "Filament has no profiles and no area lights: a spot or a point of the same flux stands for them. A scene "
           "has one sun.",
           filament_holds, asset_detail::filament_files},
    Target{
        "gltf", "glTF 2.0, .gltf and .glb: KHR_lights_punctual, EXT_lights_ies for profiles, EXT_lights_area",
        "Load NAME.gltf (with the .ies beside it) or NAME.glb (all in one file): a node for each light; that of a "
        "luminaire alone shines down -Y, C0 along +X.",
        "The Khronos validator finds no error. It does not know EXT_lights_ies and EXT_lights_area, whose indices are "
        "tested here. three.js r187 draws points and suns as probe has them.",
        "Readers of EXT_lights_ies are few, and treat azimuths in their own way; EXT_lights_area is a draft. Others "
        "see the fallback: a spot or point light of the same flux. three.js draws every spot as smoothstep over the "
        "cosine: 30 % off.",
        gltf_holds, asset_detail::gltf_files},
    Target{"godot", "Godot 4: a scene of lights in physical units, with projector textures",
           "Copy the files into a project, turn Rendering > Lights and Shadows > Use Physical Light Units on, and "
           "instance NAME.tscn; a luminaire alone shines down -Y, C0 along +X. Not for the Compatibility renderer. A "
           "sky is "
           "its WorldEnvironment, of which a tree has one.",
           "By the formulas of Godot's shaders, projectors and skies among them, the text lights points as the rig's "
           "lights and sky do.",
           "Nothing was run in Godot. Projectors have 8 bits, and the engine packs them into an atlas of its own size. "
           "Rectangles are AreaLight3D, which came with Godot 4.7; its baked and bounced light differs there.",
           godot_holds, asset_detail::godot_files},
    Target{"luxcore", "LuxCore: scene properties (.scn) with the portable profiles",
           "Add NAME.scn to the scene's properties and run where the .ies lie; a luminaire alone shines along -Z, C0 "
           "along +X.",
           "By the formulas of LuxCore's lights the text lights points as the rig's lights and sky do.",
           "LuxCore was not run. It reads the profile into a map of 1024 x 512, whose shape alone counts: the flux is "
           "the light's power.",
           luxcore_holds, asset_detail::luxcore_files},
    Target{
        "mitsuba", "Mitsuba 3: emitters as XML, a profile as a box of projectors",
        "<include filename=\"NAME.xml\"/> in a scene, with the images beside it; a luminaire alone shines along -Z, "
        "C0 along +X. Numbers are photometric: use an rgb variant.",
        "By the formulas of Mitsuba's emitters, projectors' images and skies among them, the text lights points as the "
        "rig's lights and sky do.",
        "Mitsuba was not run. It has no goniometric emitter: up to six projectors of 90 degrees stand in for one, "
        "and a sun has no disk.",
        mitsuba_holds, asset_detail::mitsuba_files},
    Target{
        "pbrt", "pbrt-v4: a scene snippet of the lights, with equal-area images of the profiles",
        "Include \"NAME.pbrt\" in the world block of a scene; for a luminaire alone after the transformation to its "
        "place: "
        "the beam goes along -Z, C0 along +X.",
        "The images' equal-area mapping was evaluated again by an independent program: intensities and flux agree, and "
        "the lux of a sky on five planes.",
        "pbrt itself was not run. It looks the image up without filtering, and `power` gives it the flux in lumens.",
        pbrt_holds, asset_detail::pbrt_files},
    Target{"playcanvas", "PlayCanvas: a module that makes the lights, with profiles as cookies",
           "import { makeLights } from './NAME.js' and call makeLights(app) before anything is drawn; it returns the "
           "entities. A luminaire alone shines down -Y from the origin. With an exposure of 1 a pixel is a luminance.",
           "PlayCanvas 2.23 draws points, spots, suns and profiles as probe has them, to 0.3 %, without clustered "
           "lighting.",
           "PlayCanvas has 16/(d^2 + 1) for the inverse square: the module puts 1/d^2 in its place, for other lights "
           "too. With clustered lighting, the default, spots are off by 2 % and a street light by 59 %: turn "
           "scene.clusteredLightingEnabled off. WebGPU was not run.",
           playcanvas_holds, asset_detail::playcanvas_files},
    Target{
        "radiance", "Radiance: lights as .rad, profiles as .dat and .cal",
        "oconv NAME.rad ROOM.rad > NAME.oct where the files lie; numbers are W/sr/m2, of which Radiance makes nits by "
        "179. A luminaire alone shines along -Z, C0 along +X.",
        "Radiance 5.3's rtrace: the illuminance by every kind of light and four profiles is probe's to 0.6 %, and that "
        "of a room with all bounces to 2 %, of a corridor to 2.4 %, at 20 points each; under a sky that of the "
        "horizontal to 0.02 %.",
        "A sky is ambient light, for which rtrace and rpict need -ab 1 or more. A point is a sphere of 1 mm radius, an "
        "ellipse 32 rectangles, a tube 72 faces. Lights are opaque in "
        "Radiance: what others send to them is lost. Colours outside its primaries are clipped.",
        radiance_holds, asset_detail::radiance_files},
    Target{
        "raw", "the portable IES files alone, for every other program; of a rig, a table of its lights and its sky too",
        "Give NAME.ies to the program's own importer: factors, TILT, flux and turn are numbers of its table. What the "
        "pixels of a sky mean, its .json says.",
        "The file is read again by gonio, and the light that comes out is the one that was asked for.",
        "What a program makes of azimuths, and whether it takes candela as absolute, is its own.", raw_holds,
        asset_detail::raw_files},
    Target{
        "threejs", "three.js: a module that makes the lights, IESSpotLights for WebGPURenderer among them",
        "import { makeLights } from './NAME.js', add what makeLights() returns to the scene, targets too, and use "
        "WebGPURenderer; a luminaire alone shines down -Y from the origin. await addSky(scene), where there is a sky, "
        "sets the scene's environment.",
        "three.js r187 in Node.js makes the lights, which light points as the rig's do; textures, sampled as the "
        "shader does, have the profile's intensities in every direction, and skies their lux on five planes. In "
        "Chromium, WebGPURenderer draws every kind as probe has it, to 0.4 %.",
        "Releases before r187 take C = 180 for every azimuth, and WebGLRenderer ignores profiles.", threejs_holds,
        asset_detail::threejs_files},
    Target{
        "unity", "Unity: portable profiles, spot and point cookies, and a script that makes the lights",
        "Copy the files under Assets, NAME.cs into a folder named Editor there; GameObject > Light > NAME makes the "
        "lights "
        "with the point cookies, and a volume with the sky. HDRP imports the .ies by itself; the spot cookies' cones "
        "stand in NAME.cs.",
        "Nothing was run in Unity: layout, border and frame are those of HDRP's own importer.",
        "The pipelines count intensities differently, and a spot's cookie is cut at its cone: directions outside it "
        "are lost. Skies are for HDRP alone.",
        unity_holds, asset_detail::unity_files},
    Target{
        "unreal", "Unreal Engine: portable profiles and an editor script that imports them and places the lights",
        "In the editor, Tools > Execute Python Script > NAME.py; the new lights are named as they are here, a "
        "luminaire "
        "alone shines down with the profile's candela, C0 along +X. A sky becomes a sky light with the picture as its "
        "cube map.",
        "Nothing was run: frame and properties follow the engine's documentation.",
        "How the engine fits the profile into its texture, and the sense of azimuths: check a lamp that is asymmetric, "
        "and where the sky is brightest.",
        unreal_holds, asset_detail::unreal_files},
    Target{
        "usd", "OpenUSD, .usda: UsdLux lights, shaped by the profiles",
        "Reference NAME.usda (with the .ies beside it), Z up: its prim NAME holds the lights; a luminaire alone shines "
        "along -Z. A sky is a DomeLight, whose transformation turns its pole from +Y to +Z.",
        "Nothing was run: the text follows UsdLux 24.08.",
        "UsdLux does not state where azimuth 0 lies, and renderers disagree whether candela are absolute: check one "
        "lamp, and scale inputs:intensity once for your renderer. Some turn a dome with the stage's up axis, which "
        "UsdLux "
        "does not.",
        usd_holds, asset_detail::usd_files},
};

} // namespace

std::span<const Target> targets() {
    return all;
}

Result<const Target*> find_target(std::string_view name) {
    return find_named("target", name, all);
}

std::string target_readme(const Target& target) {
    return fmt::format("How to use it: {}\nVerified: {}\nNot verified: {}\n", target.use, target.verified,
                       target.unverified);
}

} // namespace gonio
