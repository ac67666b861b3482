// Elapsed time for the output of --verbose; no result depends on it.
#pragma once

#include <chrono>

namespace gonio::cli {

class Stopwatch {
public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
    }

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

} // namespace gonio::cli
