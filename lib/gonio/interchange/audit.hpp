// What is implausible in the lights of a scene: the mistakes that exporters, importers and people make, by their
// signatures. A finding is a suspicion: its message states the number that gave it away.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/interchange/found_light.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// A number of the file to be changed.
struct SceneFix {
    std::size_t light = 0;         // index into FoundScene::lights
    std::vector<std::string> path; // from the light's own entry: "spot", "outerConeAngle"
    double from = 0.0;             // not a number: `to` is a factor on what the file has
    double to = 0.0;               // the corrected number
};

// Something implausible.
struct SceneFinding {
    const DiagnosticCode* code = nullptr; // SCN03…
    std::vector<std::size_t> lights;      // indices
    std::string message;                  // the number that gave it away
    std::string hint;                     // what to do
    std::vector<SceneFix> fixes;          // often empty
};

// The findings, by code. Profiles must be loaded for SCN0306 to be found. `lumens_per_watt`: what watts that were taken
// for candela should have been multiplied by; without it they have no fix.
std::vector<SceneFinding> audit_scene(const FoundScene& scene, std::optional<double> lumens_per_watt = {});

// "light 'key' and 3 more (nodes[2]): message" as a diagnostic at the first light.
Diagnostic to_diagnostic(const SceneFinding& finding, const FoundScene& scene);

// A fix that was applied.
struct AppliedFix {
    std::string code;  // of the finding
    std::string light; // its name
    std::string path;  // "spot.outerConeAngle"
    double from = 0.0; // what the file had
    double to = 0.0;   // what it has now
};

// A scene's bytes after its fixes.
struct FixedScene {
    std::string bytes;               // of the file
    std::vector<AppliedFix> applied; // in the order of the file
};

// The glTF or GLB with the fixes of the findings applied: only these numbers change. A number that two fixes would
// change is changed by the first. Fails (unsupported) on other formats, and as read_scene_lights().
Result<FixedScene> fix_scene(std::string_view bytes, const FoundScene& scene, std::span<const SceneFinding> findings);

} // namespace gonio
#pragma GCC visibility pop
