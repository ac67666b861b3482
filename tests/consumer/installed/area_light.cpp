// The exact illuminance that an area light gives to a point, cut by the horizon of the receiver.
#include <gonio/light/light.hpp>
#include <gonio/scene/probe.hpp>

#include <cstdio>

int main() {
    const auto shape = gonio::parse_shape("rect:w=60cm,h=30cm");
    const auto amount = gonio::parse_photometric_value("800lm");
    if (!shape || !amount) return 1;
    gonio::LightDescription description;
    description.shape = *shape;
    description.intensity = *amount;
    description.position = {0.0, 0.0, 2.0}; // 2 m above the origin; it shines down

    gonio::Diagnostics diagnostics;
    const auto light = gonio::resolve_light(description, diagnostics);
    if (!light) return 1;
    const gonio::Receiver receiver{{0.5, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    const auto probed = gonio::probe({&*light, 1}, {&receiver, 1});
    if (!probed) return 1;
    std::printf("%.3f lx\n", probed->illuminance_lx[0]);
}
