#include <gonio/measure/comparison.hpp>

namespace gonio::measure {

void fill_errors(MethodMeasurement& measured, std::span<const double> values, std::span<const double> truth,
                 std::span<const Stratum> strata, double relative_floor) {
    measured.error = compare(values, truth, relative_floor);
    for (std::size_t s = 0; s < stratum_count; ++s) {
        std::vector<double> some_values;
        std::vector<double> some_truth;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (strata[i] != static_cast<Stratum>(s)) continue;
            some_values.push_back(values[i]);
            some_truth.push_back(truth[i]);
        }
        measured.error_by_stratum[s] = compare(some_values, some_truth, relative_floor);
    }
}

} // namespace gonio::measure
