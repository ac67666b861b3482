// What 800 lm of a spot are in candela, and what they give at 2 m.
#include <gonio/light/photometry.hpp>

#include <cstdio>

int main() {
    const auto shape = gonio::parse_shape("spot:outer=20deg,inner=10deg");
    const auto flux = gonio::parse_photometric_value("800lm");
    if (!shape || !flux) return 1;
    const auto emission = gonio::emission_of(*shape, *flux);
    const auto lux = gonio::parse_photometric_unit("lx@2m");
    if (!emission || !lux) return 1;
    const auto illuminance = gonio::express(*shape, *emission, *lux);
    if (!illuminance) return 1;
    std::printf("%.2f cd, %.2f lx at 2 m\n", emission->intensity.value, *illuminance);
}
