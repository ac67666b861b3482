// Renders a light on a stage to a buffer of luminances in cd/m².
#include <gonio/light/light.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/stage.hpp>

#include <cstdio>

int main() {
    const auto stage = gonio::make_stage("floor");
    gonio::LightDescription description;
    const auto shape = gonio::parse_shape("sphere:r=10cm");
    const auto amount = gonio::parse_photometric_value("800lm");
    if (!stage || !shape || !amount) return 1;
    description.shape = *shape;
    description.intensity = *amount;
    gonio::hang(description, stage->light);
    gonio::Diagnostics diagnostics;
    const auto light = gonio::resolve_light(description, diagnostics);
    if (!light) return 1;

    gonio::RenderOptions options;
    options.width = 64;
    options.height = 48;
    const auto picture = gonio::render(*stage, {&*light, 1}, stage->camera, options);
    if (!picture) return 1;
    const float* const middle = picture->luminance_nt.at(32, 40);
    std::printf("%.4f %.4f %.4f cd/m2\n", static_cast<double>(middle[0]), static_cast<double>(middle[1]),
                static_cast<double>(middle[2]));
}
