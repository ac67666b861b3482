// libFuzzer: for any bytes, each reader of scenes does not crash and fails with one reason, or finds the same lights
// twice; these make a rig that reads, an audit, and for glTF a fixed file that reads.
#include <gonio/interchange/audit.hpp>
#include <gonio/interchange/scene_format.hpp>
#include <gonio/interchange/scene_rig.hpp>
#include <gonio/scene/rig.hpp>

#include "check.hpp"

#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace gonio;
    std::string_view text = fuzz::as_text(data, size);
    if (text.empty()) return 0;
    const SceneFormat& format = scene_formats()[fuzz::take_choice(text, scene_formats().size())];
    SceneReadOptions options;
    if (text.size() % 2 == 0) options.time = 3.0; // of USD; what changes between samples is read too
    options.read_beside = [&](const std::string& /*name*/) -> Result<std::string> {
        return fail(Failure::io, "no such file");
    };
    auto scene = fuzz::read_twice([&] { return read_scene_lights(text, "fuzz", options, &format); },
                                  [](const FoundScene& a, const FoundScene& b) {
                                      const auto no_file = [](const FoundLight&) { return std::string("a.ies"); };
                                      return a.lights.size() == b.lights.size() &&
                                             scene_rig(a, no_file) == scene_rig(b, no_file);
                                  });
    if (!scene) return 0;
    load_scene_profiles(*scene, options);
    const auto findings = audit_scene(*scene, 180.0);
    if (format.name == "gltf") {
        const Result<FixedScene> fixed = fix_scene(text, *scene, findings);
        fuzz::require(fixed.has_value());
        fuzz::require(read_scene_lights(fixed->bytes, "fuzz", options, &format).has_value());
    }
    const std::string rig = scene_rig(*scene, [](const FoundLight& /*light*/) { return std::string("a.ies"); });
    const Result<Rig> read = read_rig(rig, "rig", "no such folder");
    for (const FoundLight& light : scene->lights)
        if (light.profile) return 0; // whose file was not written
    fuzz::require(read.has_value());
    return 0;
}
