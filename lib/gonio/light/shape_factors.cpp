#include <gonio/light/light_image.hpp>
#include <gonio/light/masked_flux.hpp>
#include <gonio/light/shape_factors.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

namespace gonio {

namespace {

Result<ShapeFactors> masked(const std::string& mask_file, const Web* mask) {
    ShapeFactors factors;
    factors.no_luminance = "a point has no area, so no luminance";
    if (mask == nullptr) {
        if (!mask_file.empty()) return fail(Failure::internal, "the mask of this shape was not loaded");
        return factors;
    }
    factors.peak_cd = peak(*mask).intensity.value;
    if (!(factors.peak_cd > 0.0))
        return fail(Failure::usage, "this mask transmits no light, so the light cannot be scaled", {}, mask_file);
    factors.axial_share = mask->candela(0.0, 0.0) / factors.peak_cd;
    factors.strength = "I₀";
    return factors;
}

Result<ShapeFactors> factors_of(const ProfileShape& profile) {
    if (!profile.web) return fail(Failure::internal, "the profile of this shape was not loaded");
    ShapeFactors factors;
    factors.peak_cd = peak(*profile.web).intensity.value;
    if (!(factors.peak_cd > 0.0))
        return fail(Failure::usage, "this profile emits no light, so it cannot be scaled", {}, profile.file);
    factors.axial_share = profile.web->candela(0.0, 0.0) / factors.peak_cd;
    factors.no_luminance = "a profile is a point that emits by direction: it has no area, so no luminance";
    return factors;
}
template<class Kind>
Result<ShapeFactors> with_mask(const Kind& shape) {
    if constexpr (requires { shape.image; }) {
        if (shape.image != nullptr) {
            ShapeFactors factors;
            factors.no_luminance = "a point has no area, so no luminance";
            factors.peak_cd = 1.0;
            factors.axial_share = image_share(shape, *shape.image->luminance(), {0.0, 0.0, -1.0});
            factors.strength = "I₀";
            return factors;
        }
    }
    return masked(shape.mask_file, shape.mask.get());
}
template<PunctualShape Kind>
Result<ShapeFactors> factors_of(const Kind& shape) {
    return with_mask(shape);
}
template<AreaShape Kind>
Result<ShapeFactors> factors_of(const Kind& shape) {
    Result<ShapeFactors> factors = with_mask(shape);
    if (!factors) return factors;
    factors->no_luminance = "";
    factors->luminance = ShapeTraits<Kind>::projected(shape);
    factors->nearest_m = ShapeTraits<Kind>::nearest(shape);
    return factors;
}
Result<ShapeFactors> factors_of(const SunShape& sun) {
    ShapeFactors factors;
    factors.at_infinity = true;
    factors.strength = "E";
    factors.luminance = ShapeTraits<SunShape>::projected(sun);
    return factors;
}

Factor flux_of(const ProfileShape& profile, const ShapeFactors& factors) {
    return {flux(*profile.web).value / factors.peak_cd, "Φ = (Φ_web / I_peak) I"};
}
Factor flux_of(const SunShape& /*refused before*/, const ShapeFactors& /*factors*/) {
    return {};
}
template<class Kind>
Factor flux_of(const Kind& shape, const ShapeFactors& /*factors*/) {
    using Traits = ShapeTraits<Kind>;
    if constexpr (requires { shape.image; })
        if (shape.image != nullptr)
            return {image_solid_angle(shape, *shape.image->luminance()).value, Traits::masked_flux};
    if (shape.mask) return {masked_solid_angle(shape, *shape.mask).value, Traits::masked_flux};
    return Traits::flux(shape);
}

Factor by_distance(const ShapeFactors& factors, Meters distance, const char* formula) {
    const double d = distance.value;
    return {factors.axial_share / (d * d), formula};
}

Factor facing_of(const ProfileShape& /*profile*/, const ShapeFactors& factors, Meters distance) {
    return by_distance(factors, distance, factors.axial_share == 1.0 ? "E = I/d²" : "E = I(γ=0)/d²");
}
Factor facing_of(const SunShape& /*has no distance*/, const ShapeFactors& /*factors*/, Meters /*distance*/) {
    return {1.0, "E = E"};
}
template<PunctualShape Kind>
Factor facing_of(const Kind& /*shape*/, const ShapeFactors& factors, Meters distance) {
    if (factors.axial_share != 1.0) return by_distance(factors, distance, "E = mask(γ=0) I₀/d²");
    return by_distance(factors, distance, factors.peak_cd > 0.0 ? "E = I₀/d²" : "E = I/d²");
}
template<AreaShape Kind>
Factor facing_of(const Kind& shape, const ShapeFactors& factors, Meters distance) {
    const Factor facing = ShapeTraits<Kind>::facing(shape, distance);
    if (ShapeTraits<Kind>::inverse_square_is_exact) return by_distance(factors, distance, facing.formula);
    return {facing.value / factors.luminance->value, facing.formula};
}

} // namespace

Result<ShapeFactors> shape_factors(const Shape& shape) {
    return std::visit([](const auto& kind) { return factors_of(kind); }, shape);
}

Factor flux_factor(const Shape& shape, const ShapeFactors& factors) {
    return std::visit([&](const auto& kind) { return flux_of(kind, factors); }, shape);
}

Factor facing_factor(const Shape& shape, const ShapeFactors& factors, Meters distance) {
    return std::visit([&](const auto& kind) { return facing_of(kind, factors, distance); }, shape);
}

bool inverse_square_is_exact(const Shape& shape) {
    return with_traits(shape, []<class Kind>(const Kind&, ShapeTraits<Kind>) {
        if constexpr (PunctualShape<Kind>)
            return true;
        else
            return ShapeTraits<Kind>::inverse_square_is_exact;
    });
}

} // namespace gonio
