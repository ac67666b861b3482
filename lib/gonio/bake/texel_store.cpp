#include <gonio/bake/kernels.hpp>
#include <gonio/bake/texel_store.hpp>

#include <algorithm>
#include <cmath>

namespace gonio {

StoredTotals& StoredTotals::operator+=(const StoredTotals& other) {
    lumens += other.lumens;
    steradians += other.steradians;
    max_error = std::max(max_error, other.max_error);
    quantization_error = std::max(quantization_error, other.quantization_error);
    deepest_negative = std::min(deepest_negative, other.deepest_negative);
    evaluated += other.evaluated;
    return *this;
}

double store_texel(double mean, double center, const Storage& storage, float& texel, StoredTotals& totals) {
    const double wanted = mean > 0.0 ? mean : 0.0; // never −0
    const double kept =
        decoded(storage.transfer, as_stored(storage.type, encoded(storage.transfer, wanted / storage.cd_per_unit)));
    texel = static_cast<float>(kept);
    const double intensity = kept * storage.cd_per_unit;
    totals.max_error = std::max(totals.max_error, std::abs(intensity - center));
    totals.quantization_error = std::max(totals.quantization_error, std::abs(intensity - wanted));
    totals.deepest_negative = std::min(totals.deepest_negative, mean);
    ++totals.evaluated;
    return intensity;
}

double store_run(const LinearRun& run, const Storage& storage, std::span<float> texels, StoredTotals& totals) {
    if (storage.transfer != Transfer::linear) {
        double sum = 0.0;
        for (std::size_t k = 0; k < texels.size(); ++k) {
            const auto at = static_cast<double>(k);
            sum += store_texel(run.mean + at * run.mean_step, run.center + at * run.center_step, storage, texels[k],
                               totals);
        }
        return sum;
    }
    const double unit = storage.cd_per_unit;
    const bake::Ramp ramp{run.mean / unit, run.mean_step / unit, run.center / unit, run.center_step / unit};
    static const bake::Kernels& kernels = bake::kernels(simd::best_available());
    const bake::RampTotals stored = kernels.store_ramp(ramp, storage.type, texels.data(), texels.size());
    totals.max_error = std::max(totals.max_error, stored.error * unit);
    totals.quantization_error = std::max(totals.quantization_error, stored.rounding * unit);
    totals.deepest_negative = std::min(totals.deepest_negative, stored.least * unit);
    totals.evaluated += texels.size();
    return stored.sum * unit;
}

} // namespace gonio
