#include <gonio/measure/stage_lamp.hpp>

#include <utility>

namespace gonio::measure {

Light lamp_over(const Stage& stage) {
    LightDescription description;
    description.shape = parse_shape("disk:r=15cm").value();
    description.intensity = {1000.0, parse_photometric_unit("lm").value()};
    hang(description, stage.light);
    Diagnostics ignored;
    return resolve_light(std::move(description), ignored).value();
}

} // namespace gonio::measure
