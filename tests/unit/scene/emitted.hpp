// The lights that a stage emits, resolved, for tests.
#pragma once

#include <gonio/scene/emissive_lights.hpp>

#include <vector>

namespace gonio::test {

inline std::vector<Light> emitted_by(const Stage& stage) {
    Diagnostics diagnostics;
    const std::vector<LightDescription> descriptions = emissive_lights(stage).value();
    std::vector<Light> lights;
    for (const LightDescription& description : descriptions)
        lights.push_back(resolve_light(description, diagnostics).value());
    return lights;
}

} // namespace gonio::test
