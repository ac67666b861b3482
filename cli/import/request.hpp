// The request of `gonio import`: the targets, the folder, the light.
#pragma once

#include <gonio/asset/measured_light.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/rig.hpp>

#include "../arguments.hpp"
#include "../catalogue.hpp"
#include "../command.hpp"
#include "../options/light_input.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "../sky/request.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr std::array import_options{
    Option{"--to", "TARGET,…", "programs to write for", "targets"},
    Option{"-O,--output-dir", "DIR", "existing folder; each target gets a folder in it"},
    mirror_option,
    shape_option,
    preset_option,
    Option{"--intensity", "VALUE", "amount of light: 800lm, 1200cd, 5000nt, 300lx@2m (profile: as measured)"},
    Option{"--flux", "LUMENS", "scale a profile to this flux, for example 800lm (as measured)"},
    Option{"--color", "COLOR", "2700K, 2700K/0.002, d65, #ffd9a0, rgb(r,g,b) or an illuminant (from the profile)"},
    Option{"--rotate", "ANGLE", "rotate a profile or a shape about its axis, C0 towards C90 (0deg)"},
    Option{"--unit-scale", "UNIT", "length of one scene unit: mm, cm, m, in, ft or 2.5cm (m, or that of the target)"},
    Option{"--photometric", "", "usd: also lumens and lux, by the schemas of its proposal for physical lighting"},
    Option{"--allow-outside", "", "let rigs name pipes and files outside their folder"},
    Option{"-u,--update", "", "write only outdated assets: made from other bytes or with other options"},
    Option{"--overwrite", "", "replace existing files"},
    Option{"-n,--dry-run", "", "print what would be written, but write nothing"},
    Option{"-o,--output", "FILE", "with --merge: write the merged manifest to this file"},
    durable_option,
};

struct ImportRequest {
    std::vector<const Target*> targets;
    std::string folder;
    MeasuredLightOptions light;
    std::optional<PhotometricValue> intensity; // of a profile
    std::optional<LightDescription> described; // the light of --shape or --preset, instead of files
    std::string description;                   // of that light, or of the intensity: for the recipe
    Diagnostics remarks;                       // about the described light's colour
    Meters unit{1.0};
    ProfileInputOptions input;
    RigReadOptions rig;
    SkyRequest sky; // of rigs
    Catalogue catalogue;
    bool photometric = false;
    bool overwrite = false;
    bool update = false;
};

// Fails (usage, io) on options that make no sense, and on a unit that one of the targets does not have, before anything
// is written.
Result<ImportRequest> parse_import(const Arguments& arguments);

// Whether the light comes from --shape or --preset instead of files.
bool is_described(const Arguments& arguments);

// DIR/TARGET.
std::string folder_of(const ImportRequest& request, const Target& target);

// Everything except the inputs' bytes that the files depend on.
std::string recipe_of(const ImportRequest& request);

} // namespace gonio::cli
