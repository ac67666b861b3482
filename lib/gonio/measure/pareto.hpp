// The Pareto front of error against time: the points that no other point beats in both.
#pragma once

#include <span>
#include <vector>

namespace gonio::measure {

struct ErrorAndTime {
    double error = 0.0;
    double ns = 0.0;
};

// Whether each point is on the front: no other point is at least as good in both and better in one. Equal points do not
// beat each other. A point with a NaN or an infinity is not on the front and beats no other.
std::vector<bool> pareto_front(std::span<const ErrorAndTime> points);

} // namespace gonio::measure
