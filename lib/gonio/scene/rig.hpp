// Rig: the lights of a scene and the stage they are shown on, from a JSON file of schema gonio.rig/1.
//
//   { "schema": "gonio.rig/1",
//     "lights": [ { "name": "key", "shape": "sphere:r=10cm", "intensity": "800lm", "color": "#ffd9a0",
//                   "position": [0, 0, 2], "direction": [0, 0, -1], "up": [0, 1, 0], "rotate": "90deg",
//                   "range": "12m" },
//                 { "shape": "ies:lamp.ies", "smooth": "1deg", "position": [1, 0, 2] } ],
//     "sky": "cie:12,sun=180/40,horizontal=20klx",
//     "stage": "floor",
//     "camera": { "position": [0, -5, 1.5], "target": [0, 0, 1], "up": [0, 0, 1], "fov": "40deg" },
//     "materials": { "floor": "lambert:albedo=0.5" },
//     "emits": { "sphere": "500nt,color=3000K" } }
//
// `stage` is a name, or a custom stage, Z up:
//
//   "stage": { "name": "desk", "figure": [1, 1, 0], "surfaces": [
//       { "name": "floor", "plane": { "point": [0, 0, 0], "normal": [0, 0, 1] }, "material": "lambert:albedo=0.3" },
//       { "name": "screen", "panel": { "center": [0, 1, 1], "normal": [0, -1, 0], "up": [0, 0, 1], "width": "2m",
//                                      "height": "1m" } },
//       { "name": "table", "box": { "center": [0, 0, 0.7], "size": [1.6, 0.8, 0.04], "up": [0, 0, 1],
//                                   "rotate": "30deg" } },
//       { "name": "globe", "sphere": { "center": [0, 0, 0.9], "radius": "15cm" }, "emits": "800lm" },
//       { "name": "leg", "capsule": { "from": [0.7, 0, 0], "to": [0.7, 0, 0.7], "radius": "3cm" } } ] }
//
// Lights that repeat: a luminaire is named and has no place, a light names it; an array is centred at its position; a
// group has lights, a position, a rotation, and its own array. All are expanded to single lights in the order of the
// file; an array counts along X first, then Y, then Z, and numbers its lights from 1 ("desk[1,2]"); the lights of a
// group are named below it ("row[2,1]/desk"). Dimming and maintenance factors multiply.
//
//   "luminaires": { "A": { "shape": "ies:lamp.ies", "maintenance": 0.8 } },
//   "maintenance": "90%",
//   "lights": [ { "name": "desk", "luminaire": "A", "position": [0, 0, 2.7],
//                 "array": { "count": [3, 4], "spacing": [2.4, 1.8] } },
//               { "name": "row", "position": [0, 4, 0], "rotate": "90deg", "dimming": 0.5,
//                 "array": { "count": [2, 1], "room": [6, 4] },
//                 "lights": [ { "luminaire": "A", "positions": [[0, 0, 3], [1, 0, 3]] },
//                             { "shape": "spot:outer=20deg", "intensity": "900cd", "position": [0, 1, 3],
//                               "target": [0, 2, 1.5] } ] } ]
//
// With a sky or a surface that emits, `lights` may be an empty array. Only `shape`, or `luminaire`, is required for a
// light; the defaults are those of LightDescription. Arrays are in metres. Files named by a shape, a mask or a spectrum
// are relative to the rig's folder and must be regular files under it, symbolic links resolved, unless RigReadOptions
// allows others; a profile is read once and shared by every light that names it. The JSON is read as a stream: memory
// grows only with the lights (about 0.8 kB each with resolving); nesting and the size of one light are limited. A
// million points take 1.5 s with resolving, and 0.9 s by stream_rig_file(). rig.schema.json is the schema for editors.
//
// A failure is one diagnostic: "rig.json:LINE:COLUMN: error[RIG0106]: lights[3].shape: …", or without line and column
// where values contradict each other or a light cannot be resolved. malformed: JSON, an unknown key, a wrong type, a
// bad value; io: a file that cannot be read or may not be named; unsupported: a feature of a shape or colour that gonio
// does not have.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/emissive_lights.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/sky/sky_description.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// A material for the surfaces of that name on the stage.
struct SurfaceMaterial {
    std::string surface;
    Material material;
};

// Where in the file lights stand: those from `first` on, up to the next place.
struct LightsPlace {
    std::size_t first = 0;
    std::string path; // "lights[2].lights[0]"
};

// A rig as read: lights, and what they are shown on.
struct Rig {
    std::string source;                   // the name used in messages
    std::vector<LightDescription> lights; // single ones, profiles loaded; without a name "light N", N from 1
    std::vector<LightsPlace> places;      // in their order; before the first, light i stands at "lights[i]"
    std::optional<SkyDescription> sky;    // an image is named and not read
    std::optional<Stage> stage;           // as in the file: `materials` and `emits` are not applied
    std::optional<Camera> camera;
    std::vector<SurfaceMaterial> materials;
    std::vector<NamedEmission> emits; // of "emits"; what surfaces of a custom stage emit is in `stage`
    std::vector<std::string> files;   // all files read for it: profiles, masks, spectra; sorted, each once
    Diagnostics diagnostics;          // of reading: anything unusual in a profile
};

// Which files a rig may name. A rig from an untrusted source must not read arbitrary files.
struct RigReadOptions {
    bool allow_outside = false; // any file, not only regular ones under the rig's folder
    std::string outside_hint;   // the advice of a refusal, such as a command's option; empty: to put the file there
    unsigned threads = 0;       // 0 = all hardware threads; the rig is the same for any number
};

// `source` names the text in messages; relative file names are looked up in `folder` (empty: the current one).
Result<Rig> read_rig(std::string_view text, const std::string& source, const std::string& folder,
                     const RigReadOptions& options = {});

// Reads the file at `path`. For "-", standard input, file names are relative to the current folder.
Result<Rig> read_rig_file(const std::string& path, const RigReadOptions& options = {});

// A rig that read_rig() takes, as JSON of single lights: without luminaires, groups, arrays and lists of positions, one
// light a line, and without comments. It reads as the same lights, with the same names. File names stay as they are,
// relative to the rig's folder.
Result<std::string> expand_rig(std::string_view text, const std::string& source);

// The stage that a rig's surfaces are those of: its own, else the first of stage_kinds(); as in the file.
Result<Stage> stage_of(const Rig& rig);

// The lights that the surfaces of stage_of() emit. Fails (malformed) if
// the stage has no surface of that name, or cannot emit the amount.
Result<std::vector<LightDescription>> emissive_lights(const Rig& rig);

// The failure of a rig's sky that could not be resolved, such as a missing image or a sun below the horizon: with the
// place in the rig in front.
Unexpected failed_sky(const Rig& rig, const Error& error);

// Fails (malformed) on a rig without lights and without surfaces that emit: there is nothing to export, and nothing to
// show unless it has a sky.
Result<void> require_lights(const Rig& rig);

// Resolves every light, in order; runs on several threads. Fails as resolve_light does, with the light's JSON path.
// Remarks are appended to `diagnostics`.
Result<std::vector<Light>> resolve_lights(Rig rig, Diagnostics& diagnostics, unsigned threads = 0);

// Takes the lights of a rig while it is read.
class LightsSink {
public:
    LightsSink() = default;
    LightsSink(const LightsSink&) = delete;
    LightsSink& operator=(const LightsSink&) = delete;
    virtual ~LightsSink() = default;

    // The next lights, in the order of the rig.
    virtual void add(std::vector<Light> lights) = 0;

    // Lights that were added before do not count: the first light of the rig is the next one.
    virtual void restart() = 0;
};

// read_rig_file() and resolve_lights() in one, for sums over many lights: these are passed on, some thousands at a
// time, and only the text of the file is kept. All at once where the rig must be read by its values: if its maintenance
// factor, or luminaires that lights name, stand behind the lights, or if a light could name a pipe. The rig that is
// returned has no lights and no diagnostics: what was noticed is appended to `diagnostics`. Fails as those do, with the
// same messages; what was added does not count then.
Result<Rig> stream_rig_file(const std::string& path, const RigReadOptions& options, LightsSink& sink,
                            Diagnostics& diagnostics);

// The keys that a rig, one of its lights and its camera may have.
std::span<const std::string_view> rig_keys();
std::span<const std::string_view> rig_light_keys();
std::span<const std::string_view> rig_camera_keys();

} // namespace gonio
#pragma GCC visibility pop
