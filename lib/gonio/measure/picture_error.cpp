#include <gonio/measure/picture_error.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace gonio::measure {

namespace {

double mean_of(std::span<const double> values) {
    return values.empty() ? 0.0
                          : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

PictureError picture_error(const Image& values, const Image& truth, std::span<const std::uint8_t> left_out) {
    PictureError error;
    std::vector<double> of_values;
    std::vector<double> of_truth;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        if (!left_out.empty() && left_out[i] != 0) continue;
        const auto value = static_cast<double>(values.pixels[i]);
        const auto true_value = static_cast<double>(truth.pixels[i]);
        of_values.push_back(value);
        of_truth.push_back(true_value);
        const double off = value - true_value;
        sum += off;
        squares += off * off;
        error.greatest = std::fmax(error.greatest, true_value);
        if (error.pixels++ != 0 && std::fabs(off) <= std::fabs(error.worst.value - error.worst.truth)) continue;
        const auto width = static_cast<std::size_t>(truth.width);
        error.worst = {static_cast<int>(i % width), static_cast<int>(i / width), value, true_value};
    }
    if (error.pixels == 0) return error;
    const auto count = static_cast<double>(error.pixels);
    const double floor = relative_floor_share * error.greatest;
    error.of_pixels = compare(of_values, of_truth, floor);
    error.mean = mean_of(of_truth);
    error.bias = sum / count;
    error.rms = std::sqrt(squares / count);
    error.mean_relative = mean_of(relative_errors(of_values, of_truth, floor));
    for (std::size_t i = 0; i < of_truth.size(); ++i)
        error.mean_absolute += std::fabs(of_values[i] - of_truth[i]) / count;
    if (error.rms > 0.0) error.psnr_db = 20.0 * std::log10(error.greatest / error.rms);
    return error;
}

} // namespace gonio::measure
