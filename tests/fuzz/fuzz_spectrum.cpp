// libFuzzer: for any bytes, a spectrum in CSV is refused with a reason or is sound: ascending, not negative, and its
// colour has finite numbers.
#include <gonio/color/spectrum.hpp>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace gonio;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as text
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Result<Spectrum> read = parse_spectrum_csv(bytes, "fuzz.csv");
    if (!read) {
        const Diagnostics& diagnostics = read.error().diagnostics;
        if (diagnostics.empty() || diagnostics.back().severity != Severity::error) std::abort();
        return 0;
    }
    for (std::size_t i = 0; i < read->power.size(); ++i)
        if (read->power[i] < 0.0 || (i > 0 && read->wavelengths_nm[i] <= read->wavelengths_nm[i - 1])) std::abort();
    const Result<SpectrumColor> color = color_of(*read);
    if (color && !(std::isfinite(color->uv.u) && std::isfinite(color->uv.v) && color->efficacy_lm_per_w > 0.0 &&
                   color->efficacy_lm_per_w <= 684.0))
        std::abort();
    return 0;
}
