// libFuzzer: any bytes for a rig's key "stage" are refused with one reason, or give a stage with sound ray
// intersections and a valid camera.
#include <gonio/scene/rig.hpp>

#include "check.hpp"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>
#include <optional>
#include <string>

namespace {

using namespace gonio;
using namespace gonio::fuzz;

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool same_hit(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    return a.has_value() == b.has_value() && (!a || (a->distance == b->distance && a->surface == b->surface));
}

bool same_stage(const Stage& a, const Stage& b) {
    if (a.name != b.name || a.surfaces.size() != b.surfaces.size() || a.camera.position != b.camera.position)
        return false;
    for (std::size_t i = 0; i < a.surfaces.size(); ++i)
        if (a.surfaces[i].name != b.surfaces[i].name ||
            a.surfaces[i].geometry.index() != b.surfaces[i].geometry.index())
            return false;
    return true;
}

void check_stage(const Stage& stage) {
    require(!stage.name.empty() && !stage.surfaces.empty() && stage.surfaces.size() <= 256);
    require(finite(stage.figure_position) && finite(stage.camera.position) && finite(stage.camera.target));
    for (const Surface& surface : stage.surfaces) {
        require(!surface.name.empty());
        const std::optional<Ball> around = bounds(surface.geometry);
        require(!around || (finite(around->center) && around->radius > 0.0 && std::isfinite(around->radius)));
    }
    const Result<void> camera = check_camera(stage, stage.camera);
    if (!camera) require_reason(camera.error());
    const glm::dvec3 from = stage.camera.position;
    for (const glm::dvec3& toward :
         {stage.camera.target - from, glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(1.0, 0.5, 0.25)}) {
        if (!(glm::length(toward) > 0.0)) continue;
        const Ray ray{from, glm::normalize(toward)};
        const std::optional<Hit> hit = first_hit(stage, ray);
        require(same_hit(hit, first_hit(stage, ray)));
        if (!hit) continue;
        require(hit->distance >= 0.0 && std::isfinite(hit->distance) && hit->surface < stage.surfaces.size());
        require(finite(hit->position) && std::abs(glm::length(hit->normal) - 1.0) < 1e-6);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string rig = R"({"schema":"gonio.rig/1","lights":[],"stage":)";
    rig.append(as_text(data, size)).append("}");
    const auto same = [](const Rig& a, const Rig& b) {
        return a.stage.has_value() == b.stage.has_value() && (!a.stage || same_stage(*a.stage, *b.stage));
    };
    const Result<Rig> read = read_twice([&] { return read_rig(rig, "fuzz.json", "no such folder"); }, same);
    if (read && read->stage) check_stage(*read->stage);
    return 0;
}
