// `gonio preview --export`: what is rendered, as a scene of other renderers.
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
           "write stage, camera, materials and lights for other renderers: .gltf, .glb, .usda, .pbrt, .xml (Mitsuba) "
           "or .py (Blender), with the files that they need; renders a picture only with -o"},
};

// Fails (usage) on a name that tells no format, and on a folder or standard output.
Result<void> check_export(const std::string& file);

struct ExportedScene {
    std::vector<OutputFile> files; // the scene first
    Diagnostics diagnostics;       // what its format cannot hold, with what it does instead
};

// `white`: the luminance that the picture shows as 1, where that is known.
Result<ExportedScene> export_scene(const PreviewRequest& request, std::span<const Light> lights,
                                   std::optional<Nits> white);

} // namespace gonio::cli
