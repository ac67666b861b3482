// A seeded rig of many small lights over a square, for measuring a renderer's culling.
//
// Half of the lights are spots, the other half use profiles of this project; all have 5 to 60 cd, are 2.5 to 5 m high
// and aimed within 20° of the nadir: a park lit to a few lux. The range of each light is where it falls to 0.1 lx.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <string>

namespace gonio::bench {

// A rig file of schema gonio.rig/1 with profiles from `profiles_folder`. The same arguments give the same text on every
// machine.
inline std::string many_lights(std::size_t count, double side_m, const std::string& profiles_folder,
                               unsigned seed = 1) {
    std::mt19937 generator(seed);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(generator()) / 4294967296.0;
    };
    constexpr std::array profiles{"accent", "downlight", "flood", "pendant", "street", "wall-washer"};
    constexpr double threshold_lx = 0.1;
    std::string text = "{\"schema\": \"gonio.rig/1\", \"lights\": [\n";
    for (std::size_t i = 0; i < count; ++i) {
        const double outer_deg = between(15.0, 45.0);
        const std::string shape =
            i % 2 == 0 ? fmt::format("spot:outer={:.2f}deg,inner={:.2f}deg", outer_deg, 0.6 * outer_deg)
                       : fmt::format("ies:{}/{}.ies", profiles_folder, profiles[i / 2 % profiles.size()]);
        const double cd = std::exp(between(std::log(5.0), std::log(60.0)));
        const double tilt = between(0.0, 20.0) * std::numbers::pi / 180.0;
        const double turn = between(0.0, 2.0 * std::numbers::pi);
        const double x = between(-0.5, 0.5) * side_m;
        const double y = between(-0.5, 0.5) * side_m;
        const double z = between(2.5, 5.0);
        text += fmt::format("{{\"shape\": \"{}\", \"intensity\": \"{:.3f}cd\", \"position\": [{:.3f}, {:.3f}, {:.3f}], "
                            "\"direction\": [{:.4f}, {:.4f}, {:.4f}], \"range\": \"{:.3f}m\"}}{}\n",
                            shape, cd, x, y, z, std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn),
                            -std::cos(tilt), std::sqrt(cd / threshold_lx), i + 1 < count ? "," : "");
    }
    return text + "]}\n";
}

} // namespace gonio::bench
