// The illuminance of a rig's lights on a work plane of 1.6 m by 0.8 m, 75 cm high, and the share of each light.
#include <gonio/scene/probe.hpp>
#include <gonio/scene/rig.hpp>

#include <cstdio>
#include <utility>
#include <vector>

int main(int, char** arguments) {
    auto rig = gonio::read_rig_file(arguments[1]);
    gonio::Diagnostics diagnostics;
    const auto lights =
        rig ? gonio::resolve_lights(std::move(*rig), diagnostics) : gonio::Unexpected(std::move(rig.error()));
    if (!lights) {
        std::puts(to_text(lights.error().diagnostics.back()).c_str());
        return 1;
    }

    std::vector<gonio::Receiver> points;
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 16; ++column)
            points.push_back({{-0.75 + 0.1 * column, -0.35 + 0.1 * row, 0.75}, {0.0, 0.0, 1.0}});
    gonio::ProbeOptions options;
    options.parts = true;
    const auto probed = gonio::probe(*lights, points, options);
    if (!probed) return 1;

    const gonio::Spread lux = gonio::spread(probed->illuminance_lx);
    std::printf("mean %.1f lx, least %.1f lx, uniformity %.2f\n", lux.mean, lux.least, lux.uniformity());
    for (std::size_t light = 0; light < lights->size(); ++light) {
        double sum = 0.0;
        for (std::size_t point = 0; point < points.size(); ++point)
            sum += probed->parts_lx[point * lights->size() + light];
        std::printf("%s: %.1f lx\n", (*lights)[light].name.c_str(), sum / static_cast<double>(points.size()));
    }
}
