#include <gonio/light/closed_forms.hpp>
#include <gonio/light/facing.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/light/masked_flux.hpp>
#include <gonio/light/shape_factors.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include <numbers>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr const char* point_has_no_area = "a point has no area, so no luminance";

struct MakeFactors {
    static Result<ShapeFactors> punctual(const std::string& mask_file, const Web* mask) {
        ShapeFactors factors;
        factors.no_luminance = point_has_no_area;
        if (mask == nullptr) {
            if (!mask_file.empty()) return fail(Failure::internal, "the mask of this shape was not loaded");
            return factors;
        }
        factors.peak_cd = peak(*mask).intensity.value;
        if (!(factors.peak_cd > 0.0))
            return fail(Failure::usage, "this mask lets no light through, so nothing can be scaled to it", {},
                        mask_file);
        factors.axial_share = mask->candela(0.0, 0.0) / factors.peak_cd;
        factors.strength = "I₀";
        return factors;
    }
    template<class Area>
    static Result<ShapeFactors> area(const Area& shape, double projected_m2, const char* formula,
                                     double nearest_m = 0.0) {
        Result<ShapeFactors> masked = punctual(shape.mask_file, shape.mask.get());
        if (!masked) return masked;
        ShapeFactors factors = *masked;
        factors.no_luminance = "";
        factors.luminance = Factor{projected_m2, formula};
        factors.nearest_m = nearest_m;
        return factors;
    }

    Result<ShapeFactors> operator()(const PointShape& point) const {
        return punctual(point.mask_file, point.mask.get());
    }
    Result<ShapeFactors> operator()(const SpotShape& spot) const { return punctual(spot.mask_file, spot.mask.get()); }
    Result<ShapeFactors> operator()(const FrustumShape& frustum) const {
        return punctual(frustum.mask_file, frustum.mask.get());
    }
    Result<ShapeFactors> operator()(const ProfileShape& profile) const {
        if (!profile.web) return fail(Failure::internal, "the profile of this shape was not loaded");
        ShapeFactors factors;
        factors.peak_cd = peak(*profile.web).intensity.value;
        if (!(factors.peak_cd > 0.0))
            return fail(Failure::usage, "this profile emits no light, so nothing can be scaled to it", {},
                        profile.file);
        factors.axial_share = profile.web->candela(0.0, 0.0) / factors.peak_cd;
        factors.no_luminance = "a profile is a point that emits by direction: it has no area, so no luminance";
        return factors;
    }
    Result<ShapeFactors> operator()(const SphereShape& sphere) const {
        const double r = sphere.radius.value;
        return area(sphere, closed_form::disk_area(r), "I = π r² L", r);
    }
    Result<ShapeFactors> operator()(const DiskShape& disk) const {
        return area(disk, closed_form::disk_area(disk.radius.value), "I = π r² L");
    }
    Result<ShapeFactors> operator()(const RectShape& rect) const {
        return area(rect, rect.width.value * rect.height.value, "I = w h L");
    }
    Result<ShapeFactors> operator()(const TubeShape& tube) const {
        const double r = tube.radius.value;
        return area(tube, closed_form::tube_area(r, tube.length.value), "I = (2 r l + π r²) L", r);
    }
    Result<ShapeFactors> operator()(const SunShape& sun) const {
        ShapeFactors factors;
        factors.at_infinity = true;
        factors.strength = "E";
        factors.luminance = Factor{closed_form::sun_projected_solid_angle(sun.diameter.value), "E = π sin²(δ/2) L"};
        return factors;
    }
};

struct FluxFactor {
    const Shape& shape;
    const ShapeFactors& factors;

    Factor masked(const char* formula, const Web& mask) const {
        return {masked_solid_angle(shape, mask).value, formula};
    }
    static Factor sided(bool two_sided) { return two_sided ? Factor{2.0 * pi, "Φ = 2π I"} : Factor{pi, "Φ = π I"}; }

    Factor operator()(const PointShape& point) const {
        if (point.mask) return masked("Φ = (∬ mask dω) I₀", *point.mask);
        return {4.0 * pi, "Φ = 4π I"};
    }
    Factor operator()(const SpotShape& spot) const {
        if (spot.mask) return masked("Φ = (∬ lobe · mask dω) I₀", *spot.mask);
        return {lobe_solid_angle(spot).value, flux_formula(spot)};
    }
    Factor operator()(const FrustumShape& frustum) const {
        if (frustum.mask) return masked("Φ = (∬ mask dω inside the pyramid) I₀", *frustum.mask);
        return {lobe_solid_angle(frustum).value, "Φ = 4 asin(sin(h/2) sin(v/2)) I"};
    }
    Factor operator()(const ProfileShape& profile) const {
        return {flux(*profile.web).value / factors.peak_cd, "Φ = (Φ_web / I_peak) I"};
    }
    Factor operator()(const SphereShape& sphere) const {
        if (sphere.mask) return masked("Φ = (∬ mask dω) I₀", *sphere.mask);
        return {4.0 * pi, "Φ = 4π I"};
    }
    Factor operator()(const DiskShape& disk) const {
        if (disk.mask) return masked("Φ = (∬ mask cosγ dω) I₀", *disk.mask);
        return sided(disk.two_sided);
    }
    Factor operator()(const RectShape& rect) const {
        if (rect.mask) return masked("Φ = (∬ mask cosγ dω) I₀", *rect.mask);
        return sided(rect.two_sided);
    }
    Factor operator()(const TubeShape& tube) const {
        if (tube.mask) return masked("Φ = (∬ mask A(ω)/A dω) I₀", *tube.mask);
        return {closed_form::tube_solid_angle(tube.radius.value, tube.length.value),
                "Φ = π (2π r l + 4π r²)/(2 r l + π r²) I"};
    }
    Factor operator()(const SunShape&) const { return {}; } // refused before
};

struct FacingFactor {
    const ShapeFactors& factors;
    Meters distance;

    Factor punctual(const char* formula) const {
        const double d = distance.value;
        return {factors.axial_share / (d * d), formula};
    }
    Factor masked() const {
        if (factors.axial_share != 1.0) return punctual("E = mask(γ=0) I₀/d²");
        return punctual(factors.peak_cd > 0.0 ? "E = I₀/d²" : "E = I/d²");
    }
    template<class Area>
    Factor area(const Area& shape, const char* formula) const {
        return {facing_illuminance(shape, distance) / factors.luminance->value, formula};
    }

    Factor operator()(const PointShape&) const { return masked(); }
    Factor operator()(const SpotShape&) const { return masked(); }
    Factor operator()(const FrustumShape&) const { return masked(); }
    Factor operator()(const ProfileShape&) const {
        return punctual(factors.axial_share == 1.0 ? "E = I/d²" : "E = I(γ=0)/d²");
    }
    Factor operator()(const SphereShape&) const { return punctual("E = I/d²"); }
    Factor operator()(const DiskShape& disk) const { return area(disk, "E = I/(d² + r²)"); }
    Factor operator()(const RectShape& rect) const {
        return area(rect, "E = 2 [A/√(1+A²) atan(B/√(1+A²)) + B/√(1+B²) atan(A/√(1+B²))] L, A = w/2d, B = h/2d");
    }
    Factor operator()(const TubeShape& tube) const {
        return area(tube, "E = 2 [(r/d) atan(z/k) + r²d/D³ atan(Dk/rz) + r z k/(d D²)] L, z = l/2, k² = d²−r², "
                          "D² = d²+z²");
    }
    Factor operator()(const SunShape&) const { return {1.0, "E = E"}; } // has no distance
};

} // namespace

Result<ShapeFactors> shape_factors(const Shape& shape) {
    return std::visit(MakeFactors{}, shape);
}

Factor flux_factor(const Shape& shape, const ShapeFactors& factors) {
    return std::visit(FluxFactor{shape, factors}, shape);
}

Factor facing_factor(const Shape& shape, const ShapeFactors& factors, Meters distance) {
    return std::visit(FacingFactor{factors, distance}, shape);
}

} // namespace gonio
