#include <gonio/color/cct.hpp>
#include <gonio/color/detail/cie_tables.hpp>

#include <vector>

namespace gonio {

namespace {

// The curve of single wavelengths; its last and first points are the ends of the line of purples.
std::vector<Xy> outline() {
    std::vector<Xy> curve;
    curve.reserve(detail::observer.size());
    for (const auto& xyz : detail::observer)
        curve.push_back(to_xy(glm::dvec3(xyz[0], xyz[1], xyz[2])));
    return curve;
}

} // namespace

bool is_real(Xy p) {
    if (!(std::isfinite(p.x) && std::isfinite(p.y))) return false;
    static const std::vector<Xy> curve = outline();
    bool inside = false;
    for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) {
        const Xy& a = curve[i];
        const Xy& b = curve[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
}

} // namespace gonio
