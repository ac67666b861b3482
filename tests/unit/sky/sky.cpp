#include <gonio/light/light_color.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

namespace gonio {
namespace {

using std::numbers::pi;

Sky sky(std::string_view text) {
    const Result<SkyDescription> description = parse_sky_description(text);
    EXPECT_TRUE(description) << text;
    if (!description) return Sky();
    const Result<Sky> resolved = resolve_sky(*description);
    EXPECT_TRUE(resolved) << text;
    return resolved.value_or(Sky());
}

double luminance(const glm::dvec3& rgb) {
    return glm::dot(rgb, rec709_luminance);
}

constexpr glm::dvec3 up{0.0, 0.0, 1.0};

std::string reason(std::string_view text) {
    const Result<SkyDescription> description = parse_sky_description(text);
    if (!description) return description.error().diagnostics.back().message;
    const Result<Sky> resolved = resolve_sky(*description);
    return resolved ? "" : resolved.error().diagnostics.back().message;
}

TEST(SkyText, ShortFormsAreUniform) {
    for (const char* text : {"500lx", "uniform:horizontal=500lx", "0.5klx"}) {
        const Sky of = sky(text);
        EXPECT_NEAR(luminance(of.irradiance(up)), 500.0, 1e-9) << text;
        EXPECT_NEAR(luminance(of.irradiance({0.0, 0.6, -0.8})), 500.0, 1e-9) << text;
        EXPECT_NEAR(luminance(of.radiance({0.0, 0.0, -1.0})), 500.0 / pi, 1e-9) << text;
    }
    for (const char* text : {"150nt", "uniform:mean=150nt", "uniform:zenith=150cd/m2"})
        EXPECT_NEAR(luminance(sky(text).radiance({1.0, 0.0, 0.0})), 150.0, 1e-12) << text;
    EXPECT_EQ(parse_uniform_sky("500lx").value().value, 500.0 / pi);
    for (const char* bad : {"", "500", "-3lx", "3lm", "3lx@2m", "1e31nt", "lx"})
        EXPECT_FALSE(parse_uniform_sky(bad)) << bad;
}

TEST(SkyText, AmountsAreWhatTheyAreMeasuredOn) {
    for (const char* type : {"1", "7", "12", "15", "overcast"}) {
        const std::string base = std::string("cie:") + type + ",sun=200/35,";
        const Sky horizontal = sky(base + "horizontal=20klx");
        EXPECT_NEAR(luminance(horizontal.irradiance(up)), 20e3, 1e-6) << type;
        const Sky zenith = sky(base + "zenith=3000nt");
        EXPECT_NEAR(luminance(zenith.radiance(up)), 3000.0, 1e-9) << type;
        EXPECT_NEAR(zenith.zenith().value, 3000.0, 1e-9) << type;
        const Sky mean = sky(base + "mean=3000nt");
        EXPECT_NEAR(mean.mean().value, 3000.0, 1e-9) << type;
        // The same sky, whatever it is measured on.
        const double factor = zenith.zenith().value / horizontal.zenith().value;
        const glm::dvec3 direction = direction_of({50.0, 30.0});
        EXPECT_NEAR(luminance(zenith.radiance(direction)) / luminance(horizontal.radiance(direction)), factor,
                    1e-12 * factor);
    }
}

TEST(SkyText, ColorsKeepTheAmount) {
    const Sky of = sky("cie:12,sun=180/40,horizontal=10klx,color=3000K");
    EXPECT_NEAR(luminance(of.irradiance(up)), 10e3, 1e-6);
    EXPECT_GT(of.irradiance(up).x, 1.2 * of.irradiance(up).z);
    const Sky even = sky("uniform:horizontal=500lx,color=rgb(1,0,0)");
    EXPECT_EQ(even.radiance(up).y, 0.0);
    EXPECT_NEAR(luminance(even.radiance(up)), 500.0 / pi, 1e-9);
}

TEST(SkyText, RotationAddsToAzimuths) {
    const Sky plain = sky("cie:13,sun=180/40,zenith=1000nt");
    const Sky turn = sky("cie:13,sun=150/40,zenith=1000nt,rotate=30deg");
    const Sky rotated = sky("cie:13,sun=180/40,zenith=1000nt,rotate=77deg");
    for (const SkyAngles& at : {SkyAngles{180.0, 40.0}, SkyAngles{20.0, 10.0}, SkyAngles{300.0, 80.0}}) {
        const double before = luminance(plain.radiance(direction_of(at)));
        EXPECT_NEAR(luminance(turn.radiance(direction_of(at))), before, 1e-9 * before);
        const SkyAngles moved{at.azimuth_deg + 77.0, at.elevation_deg};
        EXPECT_NEAR(luminance(rotated.radiance(direction_of(moved))), before, 1e-9 * before);
    }
}

TEST(SkyText, TheGroundShowsBelow) {
    const Sky of = sky("cie:12,sun=180/40,horizontal=10klx,ground=0.3");
    EXPECT_NEAR(luminance(of.radiance({0.0, 0.6, -0.8})), 0.3 * 10e3 / pi, 1e-6);
    EXPECT_NEAR(luminance(of.irradiance(-up)), 0.3 * 10e3, 1e-6);
    EXPECT_NEAR(luminance(of.irradiance(up)), 10e3, 1e-6);
    const Sky black = sky("cie:12,sun=180/40,horizontal=10klx");
    const glm::dvec3 wall = direction_of({180.0, 0.0});
    EXPECT_NEAR(luminance(of.irradiance(wall) - black.irradiance(wall)), 0.5 * 0.3 * 10e3, 1e-6);
    EXPECT_EQ(black.radiance({0.0, 0.6, -0.8}), glm::dvec3(0.0));
    // The ground sees the sun too.
    const Sky day = sky("daylight:place=0/0,time=2024-03-20T12:00Z,ground=0.5");
    const double global = luminance(day.irradiance(up)) + day.sun()->illuminance.value * day.sun()->direction.z;
    EXPECT_NEAR(luminance(day.irradiance(-up)), 0.5 * global, 1e-6);
}

TEST(SkyText, DaylightIsTheModel) {
    const char* const text = "daylight:place=52.52/13.405,time=2024-06-20T13:00+02:00";
    const Sky clear = sky(text);
    const SkyAngles at = sky_angles_of(clear.sun()->direction);
    EXPECT_NEAR(at.elevation_deg, 90.0 - 29.1243, 0.01);
    EXPECT_NEAR(at.azimuth_deg, 176.1917, 0.01);
    const DaylightAvailability model = daylight_availability(at.elevation_deg, 172, Weather::clear);
    EXPECT_NEAR(luminance(clear.irradiance(up)), model.sky.value, 1e-4);
    EXPECT_NEAR(clear.sun()->illuminance.value, model.sun.value, 1e-4);
    EXPECT_EQ(clear.cie()->type().number, 12);
    EXPECT_LT(glm::length(clear.cie()->axis() - clear.sun()->direction), 1e-15);
    const Sky overcast = sky(std::string(text) + ",weather=overcast");
    EXPECT_FALSE(overcast.sun());
    EXPECT_NEAR(luminance(overcast.irradiance(up)),
                daylight_availability(at.elevation_deg, 172, Weather::overcast).sky.value, 1e-4);
    const Sky seen = sky("daylight:place=52.52/13.405,time=2024-12-20T15:30+01:00,refraction");
    const Sky geometric = sky("daylight:place=52.52/13.405,time=2024-12-20T15:30+01:00");
    EXPECT_GT(seen.sun()->direction.z, geometric.sun()->direction.z + 1e-3);
    const Sky turned_away = sky(std::string(text) + ",rotate=90deg,sun-color=3000K");
    EXPECT_NEAR(sky_angles_of(turned_away.sun()->direction).azimuth_deg, at.azimuth_deg + 90.0, 1e-9);
    EXPECT_NEAR(luminance(turned_away.sun()->color), 1.0, 1e-12);
    EXPECT_EQ(reason("daylight:place=52.52/13.405,time=2024-06-20T01:00+02:00").substr(0, 11), "the sun is ");
}

TEST(SkyText, ErrorsSayWhatIsWrong) {
    EXPECT_EQ(reason("unifrom:mean=3nt"), "unknown sky 'unifrom'");
    EXPECT_EQ(reason("uniform"), "'uniform' needs an amount");
    EXPECT_EQ(reason("uniform:horizontal=3nt"), "horizontal of 'uniform' is an illuminance, but '3nt' is a luminance");
    EXPECT_EQ(reason("uniform:500lx"), "'500lx' of 'uniform' does not say what it is measured on");
    EXPECT_EQ(reason("uniform:horizontal=5lx,mean=3nt"), "'uniform' has two amounts");
    EXPECT_EQ(reason("uniform:rotate=3deg,mean=3nt"), "unknown key 'rotate' of 'uniform'");
    EXPECT_EQ(reason("cie"), "'cie' needs the number of a sky");
    EXPECT_EQ(reason("cie:sun=3/4"), "'cie' needs the number of a sky");
    EXPECT_EQ(reason("cie:17,mean=3nt"), "unknown CIE sky '17'");
    EXPECT_EQ(reason("cie:12,mean=3nt"), "the CIE sky 12 needs the direction of its sun");
    EXPECT_EQ(reason("cie:12,sun=40,mean=3nt"), "the sun is azimuth/elevation in degrees, not '40'");
    EXPECT_EQ(reason("cie:12,sun=40/180,mean=3nt"),
              "the elevation of the sun must lie between -90 and 90 degrees, not 180");
    EXPECT_EQ(reason("cie:12,sun=180/-4,mean=3nt"),
              "the sun must not be below the horizon: its elevation is -4 degrees");
    EXPECT_EQ(reason("cie:12,sun=180/40"), "'cie' needs an amount");
    EXPECT_EQ(reason("cie:12,sun=180/40,mean"), "'mean' of 'cie' needs a value");
    EXPECT_EQ(reason("cie:1,mean=-3nt"), "mean of 'cie' must lie between 0 and 1e+30, not -3nt");
    EXPECT_EQ(reason("cie:1,mean=3nt,ground=2"), "ground of 'cie' is an albedo from 0 to 1, not '2'");
    EXPECT_EQ(reason("cie:1,mean=3nt,rotate=30"), "'30' has no unit");
    EXPECT_EQ(reason("cie:1,mean=3nt,color=blackish"), "'blackish' is not a colour");
    EXPECT_EQ(reason("daylight"), "'daylight' needs place=LATITUDE/LONGITUDE");
    EXPECT_EQ(reason("daylight:place=1/2"), "'daylight' needs time=TIME");
    EXPECT_EQ(reason("daylight:place=1/2,time=2024-06-21T12:00"), "the time '2024-06-21T12:00' has no zone");
    EXPECT_EQ(reason("daylight:place=1/2,time=2024-06-21T12:00Z,wether=clear"), "unknown key 'wether' of 'daylight'");
    EXPECT_EQ(reason("daylight:place=1/2,time=2024-06-21T12:00Z,weather=fog"), "unknown weather 'fog'");
    EXPECT_EQ(reason("daylight:place=1/2,time=2024-06-21T12:00Z,refraction=1"),
              "'refraction' of 'daylight' takes no value");
    EXPECT_EQ(reason("daylight:place=1/2,time=2024-06-21T12:00Z,horizontal=3lx"),
              "unknown key 'horizontal' of 'daylight'");
}

ImageSkyKind image_kind(std::string_view text) {
    const Result<SkyDescription> read = parse_sky_description(text);
    EXPECT_TRUE(read) << text;
    return read ? std::get<ImageSkyKind>(read->kind) : ImageSkyKind();
}

TEST(SkyText, ImagesAreNamedByTheirFile) {
    EXPECT_EQ(image_kind("image:room.exr").file, "room.exr");
    EXPECT_EQ(image_kind("image:a=b, c:d.exr").file, "a=b, c:d.exr");
    const ImageSkyKind all =
        image_kind("image:x,y,2.exr,layout=cube-cross,space=acescg,bad-pixels=black,rotate=30deg,horizontal=5lx");
    EXPECT_EQ(all.file, "x,y,2.exr");
    EXPECT_EQ(all.layout, EnvironmentLayout::cube_cross);
    EXPECT_EQ(all.space, "acescg");
    EXPECT_EQ(all.bad_pixels, BadPixels::black);
    EXPECT_FALSE(image_kind("image:room.exr").layout);
    EXPECT_FALSE(parse_sky_description("image:room.exr").value().amount);
    EXPECT_EQ(parse_sky_description("image:room.exr,zenith=3nt").value().amount->measure, SkyMeasure::zenith);
    EXPECT_EQ(reason("image:"), "'image' needs a file");
    EXPECT_EQ(reason("image"), "'image' needs a file");
    EXPECT_EQ(reason("image:a.exr,layuot=latlong"), "unknown key 'layuot' of 'image'");
    EXPECT_EQ(reason("image:a.exr,layout=mirror-ball"), "unknown layout 'mirror-ball'");
    EXPECT_EQ(reason("image:a.exr,bad-pixels=keep"), "unknown choice 'keep'");
    EXPECT_EQ(reason("image:a.exr,color=3000K"), "unknown key 'color' of 'image'");
    EXPECT_EQ(reason("image:a.exr,file=b.exr"), "unknown key 'file' of 'image'");
}

// An image of a sky is that sky, also turned and with another amount.
TEST(SkyImage, IsWhatItWasMadeOf) {
    const Sky truth = sky("cie:12,sun=200/40,horizontal=10klx,ground=0.2");
    const auto image = std::make_shared<const EnvironmentMap>(
        rendered(truth, environment_grid(EnvironmentLayout::latlong, 256).value()));
    const auto of = [&](std::string_view text) {
        return resolve_sky(parse_sky_description(text).value(), image).value();
    };
    const Sky same = of("image:sky.exr");
    const Sky half = of("image:sky.exr,horizontal=5klx");
    const Sky turn = of("image:sky.exr,rotate=30deg");
    const Sky turned_truth = sky("cie:12,sun=200/40,horizontal=10klx,ground=0.2,rotate=30deg");
    EXPECT_NEAR(luminance(half.irradiance(up)), 5000.0, 1e-6);
    EXPECT_NEAR(luminance(same.irradiance(up)), 10e3, 1.0);
    for (const SkyAngles& at : {SkyAngles{10.0, 60.0}, SkyAngles{100.0, 20.0}, SkyAngles{230.0, 45.0}}) {
        const glm::dvec3 direction = direction_of(at);
        const double expected = luminance(truth.radiance(direction));
        EXPECT_NEAR(luminance(same.radiance(direction)) / expected, 1.0, 1e-3);
        EXPECT_NEAR(luminance(half.radiance(direction)) / expected, 0.5, 1e-3);
        EXPECT_NEAR(luminance(turn.radiance(direction)) / luminance(turned_truth.radiance(direction)), 1.0, 1e-3);
        EXPECT_NEAR(luminance(turn.irradiance(direction)) / luminance(turned_truth.irradiance(direction)), 1.0, 1e-3);
    }
    // Of many planes in any order, some of them alike, as of each.
    const std::vector<glm::dvec3> normals{up, {0, 1, 0}, up, {1, 0, 0}, {0, 1, 0}, -up};
    for (const Sky* of_many : {&truth, &turn}) {
        const std::vector<glm::dvec3> found = of_many->irradiance(normals);
        ASSERT_EQ(found.size(), normals.size());
        for (std::size_t i = 0; i < normals.size(); ++i)
            EXPECT_LT(glm::length(found[i] - of_many->irradiance(normals[i])), 1e-9 * 10e3) << i;
    }
    EXPECT_NEAR(same.zenith().value / truth.zenith().value, 1.0, 1e-3);
    EXPECT_NEAR(luminance(same.light()) / luminance(truth.light()), 1.0, 1e-6);
    EXPECT_NEAR(of("image:sky.exr,mean=70nt").mean().value, 70.0, 1e-9);
    EXPECT_NEAR(of("image:sky.exr,zenith=70nt").zenith().value, 70.0, 1e-9);
    EXPECT_FALSE(resolve_sky(parse_sky_description("image:sky.exr").value()));
    EXPECT_FALSE(resolve_sky(parse_sky_description("image:sky.exr,horizontal=0lx").value(), image));
}

TEST(SkyText, KindsAreListed) {
    ASSERT_EQ(sky_kinds().size(), std::variant_size_v<SkyKind>);
    for (const SkyKindInfo& kind : sky_kinds()) {
        EXPECT_EQ(kind.grammar.find(kind.name), 0U);
        EXPECT_FALSE(kind.summary.empty());
    }
}

} // namespace
} // namespace gonio
