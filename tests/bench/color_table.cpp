// Prints the tables of lib/gonio/color/MEASURED.md, measured now, in Markdown: error and time of every method that
// finds the colour of a temperature, or the temperature of a colour.
//
//   gonio-color-table
#include <gonio/measure/color_methods.hpp>

#include <cmath>
#include <cstdio>
#include <string>

namespace {

using namespace gonio;
using measure::ColorMeasurement;

int refuse(const Error& error) {
    (void)std::fprintf(stderr, "%s\n", to_text(error.diagnostics.back()).c_str());
    return 1;
}

} // namespace

int main() {
    measure::ColorComparisonOptions options;
    options.timing.samples = 21;
    options.timing.sample_seconds = 0.002;
    const Result<std::vector<ColorMeasurement>> forward = measure::compare_color_methods(options);
    if (!forward) return refuse(forward.error());
    const Result<std::vector<measure::CctMeasurement>> backward = measure::compare_cct_methods(options);
    if (!backward) return refuse(backward.error());

    // Times are the fastest sample: other programs on the machine can only make samples slower.
    const double sum = forward->front().timing.lowest_ns;
    (void)std::printf("| method | code | range [K] | worst Δu'v' (at K) | rms | 2000–10000 K | Y at 2700 K | ns each | "
                      "the sum takes | of Krystek's time |\n|---|---|---|---|---|---|---|---|---|---|\n");
    for (const ColorMeasurement& row : *forward) {
        double krystek = 0.0; // of the same code
        for (const ColorMeasurement& other : *forward)
            if (other.name == "krystek" && other.code == row.code) krystek = other.timing.lowest_ns;
        (void)std::printf("| %s | %s | %.0f–%.0f | %.1e (%.0f) | %.1e | %.1e | %.3f | %.2f | %.0f× | %.2f |\n",
                          row.name.c_str(), row.code.c_str(), row.coolest.value, row.hottest.value, row.worst,
                          row.worst_at.value, row.rms, row.worst_2_to_10_kk, row.luminance_2700k, row.timing.lowest_ns,
                          sum / row.timing.lowest_ns, row.timing.lowest_ns / krystek);
    }
    const double newton = backward->front().timing.lowest_ns;
    (void)std::printf("\n| method | 1500–40000 K, Duv to 0.05: worst K | 2000–10000 K, to 0.005: worst K | ns each | "
                      "Newton on the sum takes |\n|---|---|---|---|---|\n");
    for (const measure::CctMeasurement& row : *backward)
        (void)std::printf("| %s | %.2g | %.2g | %.0f | %.0f× |\n", row.name.c_str(), row.worst_wide_k, row.worst_near_k,
                          row.timing.lowest_ns, newton / row.timing.lowest_ns);
    return 0;
}
