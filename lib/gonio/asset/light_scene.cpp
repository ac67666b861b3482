#include <gonio/asset/detail/scene_image.hpp>
#include <gonio/asset/detail/scene_sky.hpp>
#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/asset/light_scene.hpp>
#include <gonio/base/amount_range.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/light/far_field.hpp>
#include <gonio/light/light_image.hpp>
#include <gonio/light/luminaire.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/light/shape_factors.hpp>
#include <gonio/light/shape_traits.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace gonio {

namespace {

// Units per metre, and the factor on intensities that keeps lux when distances are in units. Programs with a fixed unit
// know that unit.
struct Scale {
    double length = 1.0;
    double intensity = 1.0;
};

Scale scale_of(const Target& target, Meters unit) {
    if (target.holds.length == TargetLength::centimeter) return {100.0, 1.0};
    const double units = 1.0 / unit.value;
    return {units, units * units};
}

std::vector<double> steps(double first, double last, int count) {
    std::vector<double> angles;
    for (int i = 0; i <= count; ++i)
        angles.push_back(first + (last - first) * i / count);
    return angles;
}

// Angles from the axis [deg] at which straight lines between a spot's intensities follow its lobe well.
std::vector<double> gammas_of(const SpotShape& spot) {
    const double inner = to_degrees(spot.inner);
    const double outer = to_degrees(spot.outer);
    constexpr double sharp = 1e-4; // a jump, as a share of the angle
    std::vector<double> gammas{0.0};
    if (inner < outer)
        for (const double gamma : steps(inner, outer, 64)) {
            if (gamma > gammas.back()) gammas.push_back(gamma);
        }
    else
        gammas.insert(gammas.end(), {outer, std::min(outer * (1.0 + sharp), 180.0)});
    return gammas;
}

struct Grid {
    Symmetry symmetry = Symmetry::axial;
    std::vector<double> planes{0.0};
    std::vector<double> gammas;
};

// As fine as the shape's far intensity needs, in the shape's own frame.
Grid grid_of(const SpotShape& spot) {
    return {Symmetry::axial, {0.0}, gammas_of(spot)};
}
Grid grid_of(const FrustumShape& /*above the horizon it is dark*/) {
    return {Symmetry::quadrant, steps(0.0, 90.0, 45), steps(0.0, 90.0, 180)};
}
Grid grid_of(const TubeShape& /*smooth*/) {
    return {Symmetry::quadrant, steps(0.0, 90.0, 36), steps(0.0, 180.0, 72)};
}
Grid grid_of(const CylinderShape& /*smooth*/) {
    return {Symmetry::quadrant, steps(0.0, 90.0, 36), steps(0.0, 180.0, 72)};
}
Grid around_axis() {
    return {Symmetry::axial, {0.0}, steps(0.0, 180.0, 180)};
}
Grid grid_of(const PointShape& /*shape*/) {
    return around_axis();
}
Grid grid_of(const ProfileShape& /*its web is taken*/) {
    return around_axis();
}
Grid grid_of(const SunShape& /*is refused*/) {
    return around_axis();
}
Grid grid_of(const SphereShape& /*shape*/) {
    return around_axis();
}
// From far away, a flat light is a cosine about its direction, whatever its outline.
template<class Flat>
requires requires(Flat flat) {
    flat.two_sided;
}
Grid grid_of(const Flat& /*shape*/) {
    return around_axis();
}

Grid grid_of(const Light& light) {
    const Mask mask = mask_of(light.shape);
    if (mask.web != nullptr) return {Symmetry::none, steps(0.0, 360.0, 144), steps(0.0, 180.0, 180)};
    // From far away an image on a rectangle is its mean. One that is projected needs as many directions as it has
    // pixels; half a degree is what profiles of this kind are read at.
    if (mask.image != nullptr && class_of(light.shape) == ShapeClass::punctual)
        return {Symmetry::none, steps(0.0, 360.0, 360), steps(0.0, 90.0, 180)};
    return std::visit([](const auto& shape) { return grid_of(shape); }, light.shape);
}

// The light's intensities by the angles of `frame`, which is the light's own or turned about its direction.
Result<Web> far_web(const Light& light, const Frame& frame) {
    Grid grid = grid_of(light);
    std::vector<double> candela;
    for (const double c : grid.planes)
        for (const double gamma : grid.gammas) {
            const glm::dvec3 local = direction_of({degrees(c), degrees(gamma)});
            candela.push_back(light.intensity_towards(frame.to_world(local)).value);
        }
    return Web::create(grid.symmetry, std::move(grid.planes), std::move(grid.gammas), std::move(candela));
}

// What the light emits [lm].
Result<Lumens> flux_of(const Light& light) {
    const Result<ShapeFactors> factors = shape_factors(light.shape);
    if (!factors) return Unexpected(factors.error());
    return Lumens(flux_factor(light.shape, *factors).value * light.intensity.value);
}

Result<MeasuredLight> luminaire_of(const Light& light, const Web& web, const std::string& file, const std::string& name,
                                   MeasuredLightOptions options) {
    options.color = "rgb(1,1,1)";
    Diagnostics ignored; // of the portable text: those of the rig were reported when it was read
    ProfileHeader header;
    header.source = file;
    Result<MeasuredLight> made = measured_light({file, {}, web, header}, options, ignored);
    if (!made) return made;
    made->name = name;
    made->color = light.color;
    made->color_text.clear();
    return made;
}

// The light's intensity in every direction as a luminaire; exact for a web and for a masked point, which have the
// light's own frame.
Result<MeasuredLight> profile_of(const Light& light, const Frame& frame, const std::string& name) {
    MeasuredLightOptions options;
    std::string file = fmt::format("a {}", kind_of(light.shape));
    std::optional<Web> web;
    if (const auto* profile = std::get_if<ProfileShape>(&light.shape)) {
        web = profile->web->scaled(light.web_scale);
        file = profile->file;
    } else if (const auto* point = std::get_if<PointShape>(&light.shape); point != nullptr && point->mask) {
        web = point->mask->scaled(light.web_scale * light.intensity.value);
        file = point->mask_file;
    } else {
        Result<Web> made = far_web(light, frame);
        if (!made) return pass_on(made);
        web = std::move(*made);
        Result<Lumens> flux = flux_of(light);
        if (!flux) return pass_on(flux);
        options.flux = *flux;
    }
    return luminaire_of(light, *web, file, name, options);
}

// The mask of an area light as a luminaire whose candela are the luminances of the light [nt].
Result<MeasuredLight> mask_of_luminances(const Light& light, const std::string& name) {
    const Mask mask = mask_of(light.shape);
    return luminaire_of(light, mask.web->scaled(light.web_scale * light.luminance.value), *mask.file, name, {});
}

// What the profile of a light depends on: lights with equal keys share one.
struct ProfileKey {
    const void* pattern;
    std::vector<double> numbers;

    bool operator<(const ProfileKey& other) const {
        return std::tie(pattern, numbers) < std::tie(other.pattern, other.numbers);
    }
};

ProfileKey profile_key(const Light& light) {
    ProfileKey key{pattern_of(light.shape),
                   {static_cast<double>(light.shape.index()), light.web_scale, light.intensity.value, light.color.x,
                    light.color.y, light.color.z}};
    const auto number = [](const auto& value) {
        if constexpr (requires { value.value; })
            return value.value;
        else
            return static_cast<double>(value);
    };
    for (const ShapeValue& value : values_of(light.shape))
        key.numbers.push_back(std::visit(number, value.value));
    return key;
}

// What the target loses of a profile, for a report; empty: nothing.
std::string loss_of_profile(const Target& target, const MeasuredLight& profile) {
    if (!target.holds.profiles)
        return fmt::format("{} does not have profiles: written as a spot or a point of the same flux", target.name);
    if (!target.holds.azimuths && profile.web.stored_symmetry() != Symmetry::axial)
        return fmt::format("{} does not have azimuths: the profile is averaged over them", target.name);
    return {};
}

class SceneBuilder {
public:
    SceneBuilder(const Target& target, const LightSceneOptions& options)
        : target_(target), name_(options.name), scale_(scale_of(target, options.unit)) {
        content_.name = options.name;
        content_.description = asset_detail::ascii(options.description);
        content_.units_per_meter = scale_.length;
        content_.photometric = options.photometric;
    }

    Result<void> add(const Light& light) {
        const std::string name = asset_detail::unique_name(light.name, names_);
        const bool is_sun = class_of(light.shape) == ShapeClass::sun;
        const bool dark = is_sun ? !(light.illuminance.value > 0.0) : !emits(light);
        if (dark) {
            say(light, "is dark and is left out");
            return {};
        }
        if (light.range && !target_.holds.range && !is_sun)
            say(light, fmt::format("its range of {:.6g} m is left out", light.range->value));
        SceneLight made;
        made.name = name;
        made.frame = light.frame;
        made.frame.origin *= scale_.length;
        made.color = light.color;
        made.intensity = light.intensity.value * scale_.intensity;
        made.nits = light.luminance.value;
        made.lux = light.illuminance.value;
        if (light.range && target_.holds.range) made.range = light.range->value * scale_.length;
        return std::visit([&](const auto& shape) { return place(light, shape, std::move(made)); }, light.shape);
    }

    void add(const SkyPicture& sky) {
        const TargetSky& held = target_.holds.sky;
        if (held.picture == SkyPictureKind::none) {
            instead_.push_back(fmt::format("the sky is left out: {}", held.reason.empty()
                                                                          ? fmt::format("{} stores none", target_.name)
                                                                          : std::string(held.reason)));
            return;
        }
        content_.sky = asset_detail::scene_sky(sky, held, asset_detail::unique_name("sky", names_), name_);
    }

    SceneContent& content() { return content_; }
    std::vector<std::string>& instead() { return instead_; }

    // The brightest; of several of the same illuminance the first.
    void keep_one_sun() {
        std::vector<SceneLight>& lights = content_.lights;
        const auto is_sun = [](const SceneLight& light) { return light.kind == LightKind::sun; };
        const auto brightest = std::max_element(lights.begin(), lights.end(), [&](const auto& a, const auto& b) {
            return (is_sun(a) ? a.lux : -1.0) < (is_sun(b) ? b.lux : -1.0);
        });
        if (brightest == lights.end() || !is_sun(*brightest)) return;
        const std::string kept = brightest->name;
        std::erase_if(lights, [&](const SceneLight& light) {
            if (!is_sun(light) || light.name == kept) return false;
            instead_.push_back(
                fmt::format("light '{}' is left out: a scene of {} has one sun, and '{}' is the brightest", light.name,
                            target_.name, kept));
            return true;
        });
    }

private:
    static bool emits(const Light& light) {
        const auto* spot = std::get_if<SpotShape>(&light.shape);
        return light.intensity.value > 0.0 && (spot == nullptr || spot->outer.value > 0.0);
    }

    bool holds(LightKind kind) const {
        return std::find(target_.holds.kinds.begin(), target_.holds.kinds.end(), kind) != target_.holds.kinds.end();
    }

    void say(const Light& light, const std::string& what) {
        instead_.push_back(fmt::format("light '{}': {}", light.name, what));
    }

    Result<void> place_as(LightKind kind, SceneLight made) {
        made.kind = kind;
        content_.lights.push_back(std::move(made));
        return {};
    }

    Result<void> place_profile(const Light& light, SceneLight made) {
        Result<std::size_t> profile = index_of_profile(light, made);
        if (!profile) return pass_on(profile);
        made.profile = *profile;
        if (std::string lost = loss_of_profile(target_, content_.profiles[made.profile]); !lost.empty())
            say(light, lost);
        made.intensity = content_.profiles[made.profile].peak.value * scale_.intensity;
        return place_as(LightKind::profile, std::move(made));
    }

    // Of a profile that `make` makes under a name if no light before has had it.
    template<class Make>
    Result<std::size_t> index_of_profile(const Light& light, const SceneLight& made, const Make& make) {
        auto [known, is_new] = shared_.try_emplace(profile_key(light), content_.profiles.size());
        if (is_new) {
            Result<MeasuredLight> profile = make(fmt::format("{}.{}", name_, made.name));
            if (!profile) return pass_on(profile);
            content_.profiles.push_back(std::move(*profile));
        }
        return known->second;
    }
    Result<std::size_t> index_of_profile(const Light& light, const SceneLight& made) {
        return index_of_profile(light, made,
                                [&](const std::string& name) { return profile_of(light, made.frame, name); });
    }

    // The faces of a luminous opening, as area lights of the luminaire.
    Result<void> place_faces(const Light& light, SceneLight made) {
        Result<std::size_t> profile = index_of_profile(light, made);
        if (!profile) return pass_on(profile);
        SceneLuminaire luminaire{made.name, made.frame, *profile, scale_.intensity, {}};
        for (const LuminousFace& face : light.body->faces())
            luminaire.facing.push_back({face.normal, (face.is_flat ? 1.0 : 0.25) * face.area_m2 * scale_.intensity});
        made.luminaire = content_.luminaires.size();
        content_.luminaires.push_back(std::move(luminaire));
        for (const Light& part : *light.parts) {
            SceneLight face = made;
            face.name = asset_detail::unique_name(made.name + "_face", names_);
            face.frame = part.frame;
            face.frame.origin *= scale_.length;
            if (Result<void> placed =
                    std::visit([&](const auto& shape) { return place_face(shape, std::move(face)); }, part.shape);
                !placed)
                return placed;
        }
        return {};
    }
    Result<void> place_face(const RectShape& rect, SceneLight face) {
        face.width = rect.width.value * scale_.length;
        face.height = rect.height.value * scale_.length;
        return place_as(LightKind::rect, std::move(face));
    }
    Result<void> place_face(const EllipseShape& ellipse, SceneLight face) {
        face.width = ellipse.width.value * scale_.length;
        face.height = ellipse.height.value * scale_.length;
        return place_as(LightKind::ellipse, std::move(face));
    }
    Result<void> place_face(const DiskShape& disk, SceneLight face) {
        face.radius = disk.radius.value * scale_.length;
        return place_as(LightKind::disk, std::move(face));
    }
    Result<void> place_face(const SphereShape& sphere, SceneLight face) {
        face.radius = sphere.radius.value * scale_.length;
        return place_as(LightKind::sphere, std::move(face));
    }
    template<class Kind>
    Result<void> place_face(const Kind& /*no face has it*/, const SceneLight& /*face*/) {
        return fail(Failure::internal, "a face of a luminous opening is a rectangle, a disk, an ellipse or a sphere");
    }

    // A light with an image, by a kind of the target's own.
    Result<void> place_image(const Light& light, LightKind kind, SceneLight made) {
        auto [known, is_new] = shared_images_.try_emplace(profile_key(light), content_.images.size());
        if (is_new) content_.images.push_back(asset_detail::scene_image(light, fmt::format("{}.{}", name_, made.name)));
        made.image = known->second;
        const double peak = content_.images[made.image].peak;
        (kind == LightKind::panel ? made.nits : made.intensity) =
            kind == LightKind::panel ? peak : peak * scale_.intensity;
        made.color = glm::dvec3(1.0);
        return place_as(kind, std::move(made));
    }

    Result<void> place_projected(const Light& light, SceneLight made) {
        const TargetImages& held = target_.holds.images;
        if (!(held.widest_projector_deg > 0.0))
            return place_far(light, std::move(made), fmt::format("{} does not project images", target_.name));
        const glm::dvec2 covered = covered_by_image(light.shape);
        const double corner_deg = to_degrees(Radians(std::atan(glm::length(covered))));
        if (corner_deg > held.widest_projector_deg)
            return place_far(light, std::move(made),
                             fmt::format("{} projects images up to {} degrees from the axis", target_.name,
                                         held.widest_projector_deg));
        if (!held.loses.empty()) say(light, std::string(held.loses));
        return place_image(light, LightKind::projector, std::move(made));
    }

    Result<void> place_far(const Light& light, SceneLight made, std::string_view why,
                           std::string_view what = "a point") {
        const LightImage* const image = mask_of(light.shape).image;
        if (!target_.holds.profiles) {
            say(light, std::string(why)); // place_profile() says what stands for it
            return place_profile(light, std::move(made));
        }
        say(light, fmt::format("{}: written as {} with the same intensity in every direction{}", why, what,
                               image != nullptr && image->is_colored() ? ", without the colours of its image" : ""));
        return place_profile(light, std::move(made));
    }

    // An area light: of the target's own kind, or as from far away.
    template<class Area>
    Result<void> place_area(const Light& light, const Area& shape, LightKind kind, bool two_sided, SceneLight made) {
        if (light.image != nullptr) {
            if (!target_.holds.images.has_panels)
                return place_far(light, std::move(made),
                                 fmt::format("{} does not have rectangles with an image", target_.name));
            kind = LightKind::panel;
        }
        if (shape.mask) {
            if (!target_.holds.near_profiles || !holds(kind) || kind == LightKind::tube || kind == LightKind::cylinder)
                return place_far(light, std::move(made), "a mask on an area light");
            Result<std::size_t> profile =
                index_of_profile(light, made, [&](const std::string& name) { return mask_of_luminances(light, name); });
            if (!profile) return pass_on(profile);
            made.luminaire = content_.luminaires.size();
            content_.luminaires.push_back({made.name, made.frame, *profile, 1.0, {}});
            made.name = asset_detail::unique_name(made.name + "_face", names_);
        }
        if (kind != LightKind::panel && !holds(kind))
            return place_far(light, std::move(made),
                             fmt::format("{} does not have {} lights", target_.name, kind_of(light.shape)));
        const auto place_side = [&](SceneLight side) {
            return kind == LightKind::panel ? place_image(light, kind, std::move(side))
                                            : place_as(kind, std::move(side));
        };
        if (!two_sided) return place_side(std::move(made));
        say(light, "two lights back to back, for its two sides");
        SceneLight back = made;
        back.name = asset_detail::unique_name(made.name + "_back", names_);
        back.frame.z = -back.frame.z; // turned about Y
        back.frame.x = -back.frame.x;
        if (Result<void> front = place_side(std::move(made)); !front) return front;
        return place_side(std::move(back));
    }

    Result<void> place(const Light& light, const PointShape& point, SceneLight made) {
        if (point.mask) return place_profile(light, std::move(made));
        if (holds(LightKind::point)) return place_as(LightKind::point, std::move(made));
        return place_profile(light, std::move(made));
    }
    Result<void> place(const Light& light, const ProfileShape& profile, SceneLight made) {
        if (light.body != nullptr && target_.holds.near_profiles) return place_faces(light, std::move(made));
        if (light.body != nullptr)
            say(light,
                fmt::format("its luminous opening ({}) is left out: a point, which is within 1 % from {:.2g} m on",
                            to_text(*profile.opening()), point_distance_m(*light.body, *profile.web)));
        return place_profile(light, std::move(made));
    }
    Result<void> place(const Light& light, const SpotShape& spot, SceneLight made) {
        const bool hard = spot.falloff == Falloff::hard || !(spot.inner.value < spot.outer.value);
        const TargetHolds& held = target_.holds;
        const bool same = spot.falloff == held.spot_falloff && (held.spot_has_inner || spot.inner.value == 0.0);
        if (spot.image != nullptr) return place_projected(light, std::move(made));
        if (spot.mask) return place_far(light, std::move(made), "a mask on a spot");
        if (!held.spot_falloff || (hard ? !held.spot_has_inner : !same))
            return place_far(light, std::move(made),
                             fmt::format("{} does not have spots with the falloff {}", target_.name,
                                         to_text(hard ? Falloff::hard : spot.falloff)));
        if (to_degrees(spot.outer) > held.widest_spot_deg)
            return place_far(light, std::move(made),
                             fmt::format("{} limits spots to {} degrees", target_.name, 2.0 * held.widest_spot_deg));
        made.outer = spot.outer.value;
        made.inner = hard ? asset_detail::hard_edge * spot.outer.value : spot.inner.value;
        return place_as(LightKind::spot, std::move(made));
    }
    Result<void> place(const Light& light, const FrustumShape& frustum, SceneLight made) {
        if (frustum.image != nullptr) return place_projected(light, std::move(made));
        return place_far(light, std::move(made), fmt::format("{} does not have frustum lights", target_.name));
    }
    Result<void> place(const Light& light, const SphereShape& sphere, SceneLight made) {
        made.radius = sphere.radius.value * scale_.length;
        if (!sphere.mask && !holds(LightKind::sphere) && holds(LightKind::point)) {
            say(light, fmt::format("{} does not have sphere lights: written as a point of the same intensity{}",
                                   target_.name, target_.holds.point_radius ? " and radius" : ""));
            return place_as(LightKind::point, std::move(made));
        }
        return place_area(light, sphere, LightKind::sphere, false, std::move(made));
    }
    Result<void> place(const Light& light, const DiskShape& disk, SceneLight made) {
        made.radius = disk.radius.value * scale_.length;
        return place_area(light, disk, LightKind::disk, disk.two_sided, std::move(made));
    }
    Result<void> place(const Light& light, const EllipseShape& ellipse, SceneLight made) {
        made.width = ellipse.width.value * scale_.length;
        made.height = ellipse.height.value * scale_.length;
        return place_area(light, ellipse, LightKind::ellipse, ellipse.two_sided, std::move(made));
    }
    Result<void> place(const Light& light, const RectShape& rect, SceneLight made) {
        made.width = rect.width.value * scale_.length;
        made.height = rect.height.value * scale_.length;
        return place_area(light, rect, LightKind::rect, rect.two_sided, std::move(made));
    }
    Result<void> place(const Light& light, const TubeShape& tube, SceneLight made) {
        made.radius = tube.radius.value * scale_.length;
        made.width = tube.length.value * scale_.length;
        if (!tube.mask && !holds(LightKind::tube) && holds(LightKind::cylinder)) {
            say(light, fmt::format("{} does not have tube lights: written as a cylinder without caps, of the same flux",
                                   target_.name));
            made.nits *= 1.0 + 2.0 * made.radius / made.width;
            return place_as(LightKind::cylinder, std::move(made));
        }
        if (!tube.mask && !holds(LightKind::tube) && target_.holds.profile_size) {
            // The tube lies along C90 of its profile.
            const glm::dvec3 along = made.frame.x;
            made.frame.x = made.frame.y;
            made.frame.y = -along;
            return place_far(light, std::move(made), fmt::format("{} does not have tube lights", target_.name),
                             "a point of the tube's size");
        }
        return place_area(light, tube, LightKind::tube, false, std::move(made));
    }
    Result<void> place(const Light& light, const CylinderShape& cylinder, SceneLight made) {
        made.radius = cylinder.radius.value * scale_.length;
        made.width = cylinder.length.value * scale_.length;
        return place_area(light, cylinder, LightKind::cylinder, false, std::move(made));
    }
    Result<void> place(const Light& light, const SunShape& sun, SceneLight made) {
        if (!holds(LightKind::sun)) {
            say(light, fmt::format("{} does not have suns, and a sun has no intensity: left out", target_.name));
            return {};
        }
        made.diameter = sun.diameter.value;
        return place_as(LightKind::sun, std::move(made));
    }

    const Target& target_;
    std::string name_;
    Scale scale_;
    SceneContent content_;
    // Lights with the same profile share a body.
    double point_distance_m(const LuminousBody& body, const Web& web) {
        const auto [known, added] = point_distances_m_.emplace(&body, 0.0);
        if (added) known->second = point_distance(body, web, 0.01).value;
        return known->second;
    }

    std::vector<std::string> instead_;
    std::map<const LuminousBody*, double> point_distances_m_;
    asset_detail::TakenNames names_;
    std::map<ProfileKey, std::size_t> shared_; // indices of the content's profiles
    std::map<ProfileKey, std::size_t> shared_images_;
};

} // namespace

Result<void> check_unit(const Target& target, Meters unit) {
    // Intensities scale with the square of the unit, and must fit 32-bit floats.
    constexpr double least = 1e-4;
    constexpr double most = 1e4;
    if (!(unit.value >= least && unit.value <= most))
        return fail("USE0106", fmt::format("a unit of {} m is out of range", unit.value),
                    fmt::format("it must lie between {} m and {} m", least, most));
    const auto is = [&](double meters) { return std::abs(unit.value - meters) <= 1e-12 * meters; };
    switch (target.holds.length) {
    case TargetLength::any:
        return {};
    case TargetLength::meter:
        if (is(1.0)) return {};
        return fail("USE0107", fmt::format("{} always uses metres", target.name), "leave --unit-scale out");
    case TargetLength::centimeter:
        if (is(1.0) || is(0.01)) return {};
        return fail("USE0107", fmt::format("{} always uses centimetres", target.name),
                    "leave --unit-scale out: lengths are written in cm");
    case TargetLength::none:
        break;
    }
    if (is(1.0)) return {};
    return fail("USE0107", fmt::format("{} does not have lengths to scale", target.name), "leave --unit-scale out");
}

Result<void> check_light_count(std::size_t lights) {
    if (lights <= limit("import-lights").value) return {};
    return fail(Failure::unsupported,
                fmt::format("{} lights are more than {}", lights, to_text(limit("import-lights"))), "divide the rig");
}

Result<asset_detail::BuiltScene> asset_detail::scene_content(const Target& target, std::span<const Light> lights,
                                                             const LightSceneOptions& options) {
    if (Result<void> unit = check_unit(target, options.unit); !unit) return pass_on(unit);
    if (Result<void> fits = check_light_count(lights.size()); !fits) return pass_on(fits);
    SceneBuilder builder(target, options);
    for (const Light& light : lights)
        if (const glm::dvec3& at = light.frame.origin;
            !in_amount_range(at.x) || !in_amount_range(at.y) || !in_amount_range(at.z))
            return fail("USE0106", fmt::format("the position of '{}' is out of range", light.name),
                        fmt::format("coordinates of a scene reach to {} m", greatest_amount));
    for (const Light& light : lights)
        if (Result<void> added = builder.add(light); !added) return pass_on(added);
    if (target.holds.one_sun) builder.keep_one_sun();
    if (options.sky != nullptr) builder.add(*options.sky);
    if (builder.content().lights.empty() && !builder.content().sky)
        return fail(Failure::unsupported,
                    lights.empty() && options.sky != nullptr
                        ? fmt::format("there are no lights, and {}", builder.instead().back())
                        : fmt::format("{} cannot store any of the lights", target.name),
                    "see 'gonio list targets'");
    return BuiltScene{std::move(builder.content()), std::move(builder.instead())};
}

Result<LightScene> light_scene(const Target& target, std::span<const Light> lights, const LightSceneOptions& options) {
    Result<asset_detail::BuiltScene> built = asset_detail::scene_content(target, lights, options);
    if (!built) return pass_on(built);
    LightScene scene{target.files(built->content), std::move(built->instead)};
    asset_detail::add_sky_file(built->content, options.sky, target.holds.sky, scene.files);
    return scene;
}

Result<LightScene> light_scene(const Target& target, const MeasuredLight& light, Meters unit, bool photometric) {
    if (Result<void> checked = check_unit(target, unit); !checked) return pass_on(checked);
    SceneContent content;
    content.name = light.name;
    content.description = asset_detail::describe(light);
    const Scale scale = scale_of(target, unit);
    content.units_per_meter = scale.length;
    content.single = true;
    content.photometric = photometric;
    SceneLight placed;
    placed.kind = LightKind::profile;
    placed.name = light.name;
    placed.color = light.color;
    placed.intensity = light.peak.value * scale.intensity;
    content.profiles.push_back(light);
    content.lights.push_back(std::move(placed));
    std::vector<std::string> instead;
    if (const std::string lost = loss_of_profile(target, light); !lost.empty())
        instead.push_back(fmt::format("light '{}': {}", light.name, lost));
    return LightScene{target.files(content), std::move(instead)};
}

} // namespace gonio
