// A progress bar on stderr, for work that takes over a second. One thread at a time.
#pragma once

#include "stopwatch.hpp"

#include <cstddef>
#include <string_view>

namespace gonio::cli {

class Progress {
public:
    // `wanted`: whether the bar would be visible.
    Progress(std::size_t total, bool wanted) : total_(total), wanted_(wanted) {}

    // Redraws the bar, at most ten times per second, with the items per second and the time that is left: `done` items
    // are finished, `latest` is the last of them.
    void show(std::size_t done, std::string_view latest);

    // Removes the bar, so that a message can be written.
    void clear();

private:
    Stopwatch since_start_;
    std::size_t total_;
    double last_ms_ = 0.0;
    bool wanted_;
    bool drawn_ = false;
};

} // namespace gonio::cli
