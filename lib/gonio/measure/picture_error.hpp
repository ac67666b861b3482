// The numerical difference of two pictures.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/measure/error_statistics.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace gonio::measure {

// Pixels where the truth is below this share of its greatest value count as dark: they have no relative error.
inline constexpr double relative_floor_share = 1e-4;

struct PictureError {
    std::size_t pixels = 0;        // number compared
    double mean = 0.0;             // of the truth
    double greatest = 0.0;         // of the truth
    double bias = 0.0;             // mean of value − truth
    double mean_absolute = 0.0;    // mean of |value − truth|
    double mean_relative = 0.0;    // mean of |value − truth|/truth above the floor
    double rms = 0.0;              // root of the mean of (value − truth)²
    std::optional<double> psnr_db; // 20 log10(greatest/rms); empty if the pictures are identical
    ErrorStatistics of_pixels;     // |value − truth|, and relative above the floor
    struct {
        int column = 0;
        int row = 0;
        double value = 0.0;
        double truth = 0.0;
    } worst; // where |value − truth| is largest
};

// Pictures of the same size with one channel. Pixels for which `left_out` (empty, or one value per pixel) is not 0 are
// not compared.
PictureError picture_error(const Image& values, const Image& truth, std::span<const std::uint8_t> left_out = {});

} // namespace gonio::measure
