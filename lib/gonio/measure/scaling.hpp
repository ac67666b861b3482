// How time grows with the size of a task: lights, pixels, bytes of a file, threads.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/measure/timing.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::measure {

struct ScalingPoint {
    double size = 0.0; // on the curve's x axis
    Timing timing;     // of the whole work, not per item
};

struct ScalingCurve {
    std::string name; // "probe, exact"
    std::vector<ScalingPoint> points;
};

struct ScalingOptions {
    bool quick = false; // fewer sizes
    std::uint64_t seed = 1;
    std::function<bool()> stop{}; // called between points; the points measured by then are the result
};

struct Scaling {
    std::string_view name; // "lights"
    std::string_view summary;
    std::string_view size; // "lights", "bytes": the unit of x
    Result<std::vector<ScalingCurve>> (*measure)(const ScalingOptions& options);
};

// lights, pixels, file-size, threads.
std::span<const Scaling> scalings();

// "lights,threads" or "all". Fails (usage) on an unknown name and lists all names.
Result<std::vector<const Scaling*>> parse_scalings(std::string_view list);

} // namespace gonio::measure
