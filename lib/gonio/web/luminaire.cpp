#include <gonio/web/combine.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/luminaire.hpp>
#include <gonio/web/transform.hpp>

#include <fmt/format.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace gonio {

namespace {

void scale_lamps(ProfileHeader& header, double factor) {
    if (header.lamp_flux_lm) *header.lamp_flux_lm *= factor;
}

} // namespace

Result<Luminaire> dimmed(const Luminaire& luminaire, double factor) {
    Result<Web> web = scaled_by(luminaire.web, factor);
    if (!web) return pass_on(web);
    Luminaire result{std::move(*web), luminaire.header};
    scale_lamps(result.header, factor);
    return result;
}

Result<Luminaire> stretched(const Luminaire& luminaire, double factor) {
    Result<Luminaire> result = dimmed(luminaire, factor);
    if (!result) return result;
    ProfileHeader& header = result->header;
    if (!(header.opening.length_m > 0.0) || header.opening.shape == OpeningShape::disk ||
        header.opening.shape == OpeningShape::sphere)
        return fail(
            Failure::usage,
            fmt::format("a luminous opening that is a {} has no length to stretch", to_text(header.opening.shape)),
            "only linear luminaires can be stretched; --dim and --lumens scale the others", header.source);
    header.opening.length_m *= factor;
    header.length_m *= factor;
    header.input_watts *= factor;
    return result;
}

Result<Luminaire> scaled_to(const Luminaire& luminaire, Lumens wanted) {
    Result<Web> web = scaled_to(luminaire.web, wanted);
    if (!web) return pass_on(web);
    Luminaire result{std::move(*web), luminaire.header};
    scale_lamps(result.header, wanted / flux(luminaire.web));
    return result;
}

Result<CombinedLuminaire> combined(std::span<const Luminaire> luminaires, std::span<const double> weights) {
    if (luminaires.size() != weights.size())
        return fail(Failure::usage, fmt::format("{} weights for {} luminaires", weights.size(), luminaires.size()));
    std::vector<WeightedWeb> webs;
    for (std::size_t i = 0; i < luminaires.size(); ++i)
        webs.push_back({&luminaires[i].web, weights[i]});
    Result<CombinedWeb> sum = combined(webs);
    if (!sum) return pass_on(sum);
    ProfileHeader header = luminaires.front().header;
    header.input_watts = 0.0;
    header.lamp_flux_lm = 0.0;
    for (std::size_t i = 0; i < luminaires.size(); ++i) {
        const ProfileHeader& part = luminaires[i].header;
        header.input_watts += weights[i] * part.input_watts;
        if (header.lamp_flux_lm && part.lamp_flux_lm)
            *header.lamp_flux_lm += weights[i] * *part.lamp_flux_lm;
        else
            header.lamp_flux_lm.reset();
    }
    return CombinedLuminaire{{std::move(sum->web), std::move(header)}, sum->max_error_cd};
}

} // namespace gonio
