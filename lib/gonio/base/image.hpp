// Image: a plain float buffer with its size, independent of files and colour spaces.
#pragma once

#include <cstddef>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// Rows from top to bottom, pixels from left to right, channels interleaved.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> pixels; // width × height × channels

    Image() = default;
    Image(int w, int h, int c); // all 0

    std::size_t index(int column, int row) const {
        return (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)) *
               static_cast<std::size_t>(channels);
    }
    float* at(int column, int row) { return pixels.data() + index(column, row); }
    const float* at(int column, int row) const { return pixels.data() + index(column, row); }
};

} // namespace gonio
#pragma GCC visibility pop
