// Reading scenes in tests.
#pragma once

#include <gonio/interchange/scene_format.hpp>

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace gonio::test {

// The scene; fails the test if it cannot be read.
inline FoundScene scene_of(std::string_view text, const SceneReadOptions& options = {}, std::string_view format = {}) {
    const SceneFormat* const named = format.empty() ? nullptr : *find_scene_format(format);
    Result<FoundScene> scene = read_scene_lights(text, "scene", options, named);
    EXPECT_TRUE(scene.has_value()) << (scene ? std::string() : to_text(scene.error().diagnostics.back()));
    return scene ? std::move(*scene) : FoundScene{};
}

// The code of the failure, and its message.
inline Diagnostic failure_of(std::string_view text, std::string_view format = {}) {
    const SceneFormat* const named = format.empty() ? nullptr : *find_scene_format(format);
    const Result<FoundScene> scene = read_scene_lights(text, "scene", {}, named);
    EXPECT_FALSE(scene.has_value());
    return scene ? Diagnostic{} : scene.error().diagnostics.back();
}

// Whether a remark of a light has the code.
inline bool has_remark(const FoundLight& light, std::string_view code) {
    for (const LightRemark& said : light.remarks)
        if (said.code->code == code) return true;
    return false;
}

inline double number_of(const FoundLight& light) {
    return light.intensity ? light.intensity->number : -1.0;
}

inline std::string unit_of(const FoundLight& light) {
    return light.intensity ? std::string(light.intensity->unit.unit->symbol) : std::string();
}

} // namespace gonio::test
