// The colour of 2700 K in linear Rec.709, at luminance 1, and the temperature of a chromaticity.
#include <gonio/color/cct.hpp>
#include <gonio/color/rgb_space.hpp>

#include <cstdio>

int main() {
    const auto at = gonio::exact_uv({gonio::Kelvin(2700.0)});
    if (!at) return 1;
    const gonio::SpaceColor color = gonio::to_space(*at, *gonio::find_rgb_space("rec709"));
    std::printf("2700 K: %.4f %.4f %.4f\n", color.rgb.x, color.rgb.y, color.rgb.z);

    const auto cct = gonio::exact_cct(gonio::to_uv(gonio::Xy{0.38, 0.38}));
    if (!cct) return 1;
    std::printf("x 0.38, y 0.38: %.1f K, Duv %.5f\n", cct->temperature.value, cct->duv);
}
