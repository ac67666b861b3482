// Checks that every number of a file made from a web can be read again.
#include <gonio/base/amount_range.hpp>
#include <gonio/web/make_profile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace gonio::web_detail {

namespace {

// Keeps the first number that is out of range.
class Numbers {
public:
    void see(std::string_view name, double value) {
        if (!found_ && !in_amount_range(value)) found_ = Found{name, value};
    }
    void see(std::string_view name, const std::optional<double>& value) {
        if (value) see(name, *value);
    }
    void see(std::string_view name, const std::vector<double>& values) {
        const auto wrong = std::find_if_not(values.begin(), values.end(), in_amount_range);
        if (wrong != values.end()) see(name, *wrong);
    }

    void operator()(const IesFile& file) {
        see("number of lumens per lamp", file.lumens_per_lamp);
        see("candela multiplier", file.candela_multiplier);
        for (const double size : {file.width, file.length, file.height})
            see("size of the luminous opening", size);
        see("ballast factor", file.ballast_factor);
        see("12th field", file.field_12);
        see("input power", file.input_watts);
        see("TILT factor", file.tilt.factors);
        see("intensity", file.candela);
    }

    void operator()(const LdtFile& file) {
        for (const double size : {file.length_mm, file.width_mm, file.height_mm})
            see("size of the luminaire", size);
        for (const double size :
             {file.luminous_length_mm, file.luminous_width_mm, file.luminous_height_c0_mm, file.luminous_height_c90_mm,
              file.luminous_height_c180_mm, file.luminous_height_c270_mm})
            see("size of the luminous area", size);
        see("downward flux fraction", file.downward_flux_percent);
        see("light output ratio", file.light_output_ratio_percent);
        see("conversion factor", file.conversion_factor);
        for (const LdtLampSet& set : file.lamp_sets) {
            see("luminous flux of the lamps", set.flux_lm);
            see("input power", set.input_watts);
        }
        see("direct ratio", file.direct_ratios);
        see("intensity per 1000 lm", file.candela_per_klm);
    }

    void operator()(const Tm33File& file) {
        for (const auto& size : {file.length_m, file.width_m, file.height_m})
            see("size of the luminaire", size);
        for (const Tm33Emitter& emitter : file.emitters) {
            see("number of rated lumens", emitter.rated_lumens);
            see("luminous flux", emitter.luminous_flux_lm);
            see("input power", emitter.input_watts);
            see("ballast factor", emitter.ballast_factor);
            see("tilt factor", emitter.tilt.factors);
            for (const Tm33Area& area : emitter.bottom_areas) {
                see("size of the luminous area", area.length_m);
                see("size of the luminous area", area.width_m);
            }
            if (!emitter.intensity) continue;
            see("multiplier", emitter.intensity->multiplier);
            see("intensity", emitter.intensity->candela);
        }
    }

    struct Found {
        std::string_view name;
        double value;
    };
    const std::optional<Found>& found() const { return found_; }

private:
    std::optional<Found> found_;
};

} // namespace

Result<MadeProfile> with_numbers_in_range(MadeProfile made) {
    Numbers numbers;
    std::visit([&](const auto& file) { numbers(file); }, made.profile.file);
    if (!numbers.found()) return made;
    return fail(Failure::malformed,
                fmt::format("the {} would be {}, but photometric files hold numbers up to {}", numbers.found()->name,
                            numbers.found()->value, greatest_amount),
                {}, made.profile.source);
}

} // namespace gonio::web_detail
