#include <gonio/measure/pareto.hpp>

#include <algorithm>
#include <cmath>

namespace gonio::measure {

namespace {

bool is_finite(const ErrorAndTime& point) {
    return std::isfinite(point.error) && std::isfinite(point.ns);
}

bool beats(const ErrorAndTime& a, const ErrorAndTime& b) {
    return is_finite(a) && a.error <= b.error && a.ns <= b.ns && (a.error < b.error || a.ns < b.ns);
}

} // namespace

std::vector<bool> pareto_front(std::span<const ErrorAndTime> points) {
    std::vector<bool> front;
    for (const ErrorAndTime& point : points)
        front.push_back(is_finite(point) && std::none_of(points.begin(), points.end(), [&](const ErrorAndTime& other) {
                            return beats(other, point);
                        }));
    return front;
}

} // namespace gonio::measure
