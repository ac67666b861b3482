// Random numbers that are the same everywhere: splitmix64 (G. Steele, D. Lea, C. Flood, OOPSLA 2014).
// The result of std::uniform_real_distribution is not specified to the bit, so cases made with it would differ between
// libraries.
#pragma once

#include <cstdint>

namespace gonio::measure {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }
    // In [low, high).
    double uniform(double low = 0.0, double high = 1.0) {
        return low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1p-53);
    }

private:
    std::uint64_t state_;
};

} // namespace gonio::measure
