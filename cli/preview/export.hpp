// `gonio preview --export`: the rendered scene in the formats of other renderers.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>

#include "../command.hpp"
#include "../options/output.hpp"
#include "request.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr std::array preview_export_options{
    Option{"--export", "FILE",
           "write stage, camera, materials, lights and sky for other renderers: .gltf, .glb (these without a sky), "
           ".usda, .pbrt, .rad (Radiance), .xml (Mitsuba) or .py (Blender), with the files that they need; renders a "
           "picture only with -o"},
};

// Fails (usage) on a name that implies no format, and on a folder or stdout.
Result<void> check_export(const std::string& file);

struct ExportedScene {
    std::vector<OutputFile> files; // the scene first
    Diagnostics diagnostics;       // anything its format cannot store, with the replacement
};

// `white`: the luminance that the picture shows as 1, if it is known.
Result<ExportedScene> export_scene(const PreviewRequest& request, std::span<const Light> lights,
                                   std::optional<Nits> white);

} // namespace gonio::cli
