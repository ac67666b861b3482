#include <gonio/base/named.hpp>
#include <gonio/plot/diagram.hpp>

#include <array>

namespace gonio {

namespace {

constexpr std::array kinds{
    DiagramKind{"polar", "intensity around the nadir, a curve for each plane", polar_diagram},
    DiagramKind{"cartesian", "intensity against gamma along an axis", cartesian_diagram},
    DiagramKind{"heat-map", "intensity in colour over C and gamma", heat_map_diagram},
    DiagramKind{"isolux", "illuminance on the plane below, in lines of equal lux", isolux_diagram},
    DiagramKind{"cone", "width of the beam and illuminance at five distances", cone_diagram},
    DiagramKind{"falloff", "lux against distance on the axis, next to the inverse square", nullptr},
};

} // namespace

std::span<const DiagramKind> diagram_kinds() {
    return kinds;
}

Result<const DiagramKind*> find_diagram(std::string_view name) {
    return find_named("diagram", name, kinds);
}

} // namespace gonio
