#include <gonio/light/efficacy.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/light/policy.hpp>
#include <gonio/light/presets.hpp>

#include "shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace gonio {
namespace {

using std::numbers::pi;

using test::shape;

double emitted_over_said(const std::string& policy, const std::string& text, Dimension dimension) {
    const Result<PolicyMeaning> meaning = policy_meaning(**find_policy(policy), shape(text), dimension);
    EXPECT_TRUE(meaning.has_value()) << policy << " " << text;
    EXPECT_TRUE(meaning->own) << policy << " " << text;
    return meaning->emitted_over_said;
}

// What a spot of one candela emits with Frostbite's attenuation, by the midpoint rule over the cosine.
double frostbite_flux(double inner, double outer) {
    const double scale = 1.0 / std::max(0.001, std::cos(inner) - std::cos(outer));
    const double offset = -std::cos(outer) * scale;
    const auto lobe = [&](double u) { return std::pow(std::clamp(u * scale + offset, 0.0, 1.0), 2); };
    const int steps = 2'000'000;
    const double depth = 1.0 - std::cos(outer);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        sum += lobe(1.0 - depth * (i + 0.5) / steps);
    return 2.0 * pi * depth * sum / steps;
}

TEST(Policy, LumensOfASpotAreWhatThePublishedFactorsSay) {
    // Half angles of 10° and 20°: the outer cone's lumens are twice what the lobe emits, π's are 16.5 times; without an
    // inner cone and narrow, the outer cone's are three times.
    const std::string spot = "spot:inner=10deg,outer=20deg";
    EXPECT_NEAR(1.0 / emitted_over_said("frostbite-cone", spot, Dimension::luminous_flux), 2.00, 0.01);
    EXPECT_NEAR(1.0 / emitted_over_said("unreal", spot, Dimension::luminous_flux), 2.00, 0.01);
    EXPECT_NEAR(1.0 / emitted_over_said("frostbite", spot, Dimension::luminous_flux), 16.5, 0.1);
    EXPECT_NEAR(1.0 / emitted_over_said("unity-hdrp", spot, Dimension::luminous_flux), 4.0 * 16.5, 0.4);
    EXPECT_NEAR(1.0 / emitted_over_said("frostbite-cone", "spot:outer=20deg", Dimension::luminous_flux), 3.0, 1e-9);
    EXPECT_NEAR(emitted_over_said("pbrt", spot, Dimension::luminous_flux), 1.0, 0.0);
}

TEST(Policy, ASpotHasTheLobeOfTheProgram) {
    const Shape spot = shape("spot:outer=40deg,inner=25deg");
    const auto shown = [&](const char* policy) { return program_shape(**find_policy(policy), spot); };
    const auto lobe = [&](const char* policy) { return std::get<SpotShape>(shown(policy).shape); };
    EXPECT_EQ(lobe("threejs").falloff, Falloff::smoothstep_cos);
    EXPECT_EQ(lobe("godot").falloff, Falloff::linear_cos);
    EXPECT_EQ(lobe("godot").inner.value, 0.0);
    EXPECT_TRUE(shown("unreal").note.empty());
    EXPECT_TRUE(shown("physical").note.empty());
    // 800 lm are 254.6 cd. Over u = (cosθ − cos b)/(cos a − cos b), smoothstep has the mean 1/2 and a linear fall too:
    // Φ = 2π I (1 − cos a + (cos a − cos b)/2).
    const double a = std::cos(25.0 / 180.0 * pi);
    const double b = std::cos(40.0 / 180.0 * pi);
    const auto emitted = [&](const char* policy) {
        return 800.0 *
               policy_meaning(**find_policy(policy), shown(policy).shape, Dimension::luminous_flux)->emitted_over_said;
    };
    EXPECT_NEAR(emitted("threejs"), 1600.0 * (1.0 - a + 0.5 * (a - b)), 1e-9);
    EXPECT_NEAR(emitted("godot"), 1600.0 * 0.5 * (1.0 - b), 1e-9);
    // A hard spot stays hard.
    const Shape hard = shape("spot:outer=40deg,inner=40deg");
    EXPECT_TRUE(program_shape(**find_policy("threejs"), hard).note.empty());
}

TEST(Policy, FrostbitesGuardedLobeIsIntegratedWithItsGuard) {
    for (const auto& [inner, outer] : {std::pair{10.0, 20.0}, {1.0, 2.0}, {2.4, 2.5}, {0.0, 1.0}, {5.0, 5.0}}) {
        const double flux = frostbite_flux(inner * pi / 180.0, outer * pi / 180.0);
        const std::string text = "spot:inner=" + std::to_string(inner) + "deg,outer=" + std::to_string(outer) + "deg";
        EXPECT_NEAR(emitted_over_said("frostbite", text, Dimension::luminous_flux), flux / pi, 1e-6 * flux) << text;
        // The policy's candela are those of the same lobe.
        const double lobe_sr = lobe_solid_angle(std::get<SpotShape>(shape(text))).value;
        EXPECT_NEAR(emitted_over_said("frostbite", text, Dimension::luminous_intensity), flux / lobe_sr,
                    1e-6 * flux / lobe_sr)
            << text;
    }
    // "to a quarter of the flux at 1°/2°"
    const double unguarded = lobe_solid_angle(std::get<SpotShape>(shape("spot:inner=1deg,outer=2deg"))).value / pi;
    const double guarded = emitted_over_said("frostbite", "spot:inner=1deg,outer=2deg", Dimension::luminous_flux);
    EXPECT_NEAR(guarded / unguarded, 0.25, 0.03);
}

TEST(Policy, AreaLightsWithAKnownFault) {
    EXPECT_DOUBLE_EQ(emitted_over_said("unreal", "sphere:r=3cm", Dimension::luminance), 4.0);
    EXPECT_DOUBLE_EQ(emitted_over_said("unreal", "sphere:r=3cm", Dimension::luminous_flux), 1.0);
    EXPECT_DOUBLE_EQ(emitted_over_said("unreal", "rect:w=1m,h=1m", Dimension::luminous_flux), 1.0);
    // A thin tube is a sinθ line; its lumens were taken for those of an isotropic one: π/2.
    EXPECT_NEAR(emitted_over_said("unity-hdrp", "tube:r=1e-6m,l=1m", Dimension::luminous_flux), 0.5 * pi, 1e-5);
}

TEST(Policy, NumbersRoundTrip) {
    const char* const shapes[] = {"point",
                                  "spot:outer=40deg,inner=25deg",
                                  "frustum:h=60deg,v=40deg",
                                  "sphere:r=3cm",
                                  "disk:r=10cm",
                                  "ellipse:w=60cm,h=30cm",
                                  "rect:w=60cm,h=30cm",
                                  "tube:r=1.3cm,l=1.2m",
                                  "cylinder:r=1.3cm,l=1.2m",
                                  "sun:angle=0.53deg"};
    const char* const values[] = {"800lm", "1200cd", "5000nt", "12ev", "300lx", "7evlx", "60W@683"};
    int own = 0;
    for (const Policy& policy : policies())
        for (const char* text : shapes)
            for (const char* value_text : values) {
                const PhotometricValue value = *parse_photometric_value(value_text);
                const auto meaning = policy_meaning(policy, shape(text), value.unit.unit->dimension);
                if (!meaning) {
                    EXPECT_EQ(meaning.error().failure, Failure::unsupported);
                    continue;
                }
                EXPECT_GT(meaning->emitted_over_said, 0.0);
                const PhotometricValue physical = physical_value(*meaning, value);
                EXPECT_NEAR(policy_number(*meaning, physical.unit, physical.number), value.number,
                            1e-14 * value.number);
                own += meaning->own ? 1 : 0;
            }
    EXPECT_GT(own, 100);
}

TEST(Policy, ExposureValuesAreLogarithms) {
    // Unreal: L = 2^EV, here 2^(EV − 3): three stops, and two more for the sphere's surface.
    const PolicyMeaning meaning =
        *policy_meaning(**find_policy("unreal"), shape("sphere:r=3cm"), Dimension::luminance_ev);
    EXPECT_DOUBLE_EQ(physical_value(meaning, *parse_photometric_value("10ev")).number, 15.0);
}

TEST(Policy, MasksKeepTheLumensOfTheBareLight) {
    PointShape masked;
    masked.mask_file = "mask";
    masked.mask = std::make_shared<const Web>(
        *Web::create(Symmetry::axial, {0.0}, {0.0, 90.0, 90.0001, 180.0}, {2.0, 2.0, 0.0, 0.0}));
    const PolicyMeaning meaning = *policy_meaning(**find_policy("frostbite"), masked, Dimension::luminous_flux);
    EXPECT_NEAR(meaning.emitted_over_said, 0.5, 1e-5) << "half the sphere is let through";
    EXPECT_FALSE(meaning.note.empty());
}

TEST(Policy, AnUnknownOneIsRefused) {
    EXPECT_EQ(find_policy("unity").error().failure, Failure::usage);
    EXPECT_EQ(policies().front().name, "physical");
}

TEST(Efficacy, NamesAndNumbers) {
    EXPECT_EQ(parse_efficacy("90lm/W")->lm_per_w, 90.0);
    EXPECT_EQ(parse_efficacy("683")->lm_per_w, 683.0);
    EXPECT_EQ(parse_efficacy("khronos-177")->lm_per_w, 177.0);
    for (const char* bad : {"0", "-1", "700", "khronos", "", "lm/W", "inf"})
        EXPECT_EQ(parse_efficacy(bad).error().failure, Failure::usage) << bad;
    for (const NamedEfficacy& known : named_efficacies())
        EXPECT_EQ(parse_efficacy(known.name)->lm_per_w, known.lm_per_w);
}

TEST(Efficacy, OfSpectraNamesItsBand) {
    const Result<Efficacy> led = parse_efficacy("spectrum:LED-B3");
    ASSERT_TRUE(led);
    EXPECT_EQ(led->of, "LED-B3, 380–780 nm");
    EXPECT_NEAR(led->lm_per_w, 316.9, 0.1);
    EXPECT_EQ(parse_efficacy("spectrum:blackbody:2700K")->of, "blackbody 2700 K, 360–830 nm");
    EXPECT_NEAR(parse_efficacy("spectrum:blackbody:2700K")->lm_per_w, 113.8, 0.1);
    EXPECT_EQ(parse_efficacy("spectrum:no such.csv").error().failure, Failure::io);
}

TEST(Presets, AreLights) {
    for (const LightPreset& preset : light_presets()) {
        const Result<PhotometricValue> value = parse_photometric_value(preset.value);
        const Result<Shape> made = parse_shape(preset.shape);
        ASSERT_TRUE(value && made) << preset.name;
        EXPECT_TRUE(emission_of(*made, *value).has_value()) << preset.name;
    }
    // The sun's luminance is known to be about 1.6e9 nt.
    const LightPreset& sun = **find_preset("full-sun");
    const Emission emission = *emission_of(*parse_shape(sun.shape), *parse_photometric_value(sun.value));
    EXPECT_NEAR(emission.luminance.value, 1.6e9, 0.2e9);
    EXPECT_FALSE(find_preset("sun").has_value());
}

TEST(DistanceOf, IsTheInverseOfTheIlluminance) {
    const char* const shapes[] = {"point",
                                  "spot:outer=40deg,inner=25deg",
                                  "sphere:r=30cm",
                                  "disk:r=50cm",
                                  "ellipse:w=50cm,h=20cm",
                                  "rect:w=60cm,h=3m",
                                  "tube:r=1.3cm,l=1.2m",
                                  "tube:r=40cm,l=1mm",
                                  "cylinder:r=40cm,l=30cm"};
    for (const char* text : shapes) {
        const Shape made = shape(text);
        const Emission emission = *emission_of(made, *parse_photometric_value("800lm"));
        for (const double meters : {0.41, 0.5, 1.0, 3.0, 100.0, 1e6}) {
            const PhotometricUnit lux{find_unit("lx"), Meters(meters), std::nullopt};
            const double illuminance = *express(made, emission, lux);
            const Result<Meters> distance = distance_of(made, emission, Lux(illuminance));
            ASSERT_TRUE(distance.has_value()) << text << " at " << meters;
            EXPECT_NEAR(distance->value, meters, 1e-13 * meters) << text;
        }
    }
}

TEST(DistanceOf, HasLimits) {
    const Shape disk = shape("disk:r=10cm");
    const Emission emission = *emission_of(disk, *parse_photometric_value("1000nt"));
    // On contact a uniform disk fills the hemisphere: π L.
    EXPECT_LT(distance_of(disk, emission, Lux(0.999999 * pi * 1000.0))->value, 1.001e-4);
    EXPECT_EQ(distance_of(disk, emission, Lux(1.001 * pi * 1000.0)).error().failure, Failure::usage);
    EXPECT_FALSE(distance_of(disk, emission, Lux(0.0)).has_value());
    EXPECT_FALSE(distance_of(disk, emission, Lux(std::nan(""))).has_value());
    const Shape sun = shape("sun:angle=0.5deg");
    EXPECT_FALSE(distance_of(sun, *emission_of(sun, *parse_photometric_value("1klx")), Lux(1.0)).has_value());
}

TEST(WithSameFlux, KeepsIt) {
    const Shape point = shape("point");
    const Shape sphere = shape("sphere:r=1cm");
    const Emission emission = *emission_of(point, *parse_photometric_value("800lm"));
    const Emission other = *with_same_flux(point, emission, sphere);
    EXPECT_NEAR(*express(sphere, other, {find_unit("lm"), std::nullopt, std::nullopt}), 800.0, 1e-11);
}

} // namespace
} // namespace gonio
