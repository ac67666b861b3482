#include <gonio/light/closed_forms.hpp>
#include <gonio/light/facing.hpp>

namespace gonio {

double facing_illuminance(const SphereShape& sphere, Meters distance) {
    return closed_form::facing_sphere(sphere.radius.value, distance.value);
}

double facing_illuminance(const DiskShape& disk, Meters distance) {
    return closed_form::facing_disk(disk.radius.value, distance.value);
}

double facing_illuminance(const RectShape& rect, Meters distance) {
    return closed_form::facing_rectangle(rect.width.value, rect.height.value, distance.value);
}

double facing_illuminance(const TubeShape& tube, Meters distance) {
    return closed_form::facing_tube(tube.radius.value, tube.length.value, distance.value);
}

} // namespace gonio
