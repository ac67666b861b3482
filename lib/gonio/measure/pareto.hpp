// The Pareto front of error against time: what no other method beats in both.
#pragma once

#include <span>
#include <vector>

namespace gonio::measure {

struct ErrorAndTime {
    double error = 0.0;
    double ns = 0.0;
};

// Whether each point is on the front: none other is at least as good in both and better in one. Of two equal points
// both are. What is NaN or infinite in either is on no front and beats nothing.
std::vector<bool> pareto_front(std::span<const ErrorAndTime> points);

} // namespace gonio::measure
