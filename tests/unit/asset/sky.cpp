// Skies in the files of targets. tests/import/sky_check.py reads the pictures by what each program documents.
#include <gonio/asset/light_scene.hpp>
#include <gonio/asset/scene_content.hpp>
#include <gonio/asset/sky_picture.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/sky/sky.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace gonio {
namespace {

using std::numbers::pi;

constexpr glm::dvec3 up{0.0, 0.0, 1.0};

Sky sky_of(const char* text) {
    return *resolve_sky(*parse_sky_description(text));
}

// Luminances that differ from texel to texel, and channel to channel.
EnvironmentMap uneven(EnvironmentLayout layout, int width, int height) {
    const EnvironmentGrid grid = EnvironmentGrid::create(layout, width, height).value();
    Image image(width, height, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<float>(1 + (i * 7919) % 101);
    return EnvironmentMap::of_valid(grid, std::move(image), 2.0);
}

std::vector<Light> bulb(const char* name) {
    LightDescription light;
    light.name = name;
    light.shape = *parse_shape("point");
    light.intensity = *parse_photometric_value("100cd");
    Diagnostics ignored;
    return {*resolve_light(std::move(light), ignored)};
}

LightScene scene_for(const char* target, const SkyPicture& sky, const std::vector<Light>& lights = {}) {
    LightSceneOptions options;
    options.name = "scene";
    options.sky = &sky;
    return *light_scene(**find_target(target), lights, options);
}

std::string text_of(const LightScene& scene) {
    std::string text;
    for (const AssetFile& file : scene.files)
        text += file.bytes;
    return text;
}

const AssetFile* picture_in(const LightScene& scene) {
    const auto found = std::find_if(scene.files.begin(), scene.files.end(),
                                    [](const AssetFile& file) { return file.environment || file.picture; });
    return found == scene.files.end() ? nullptr : &*found;
}

TEST(SkyPicture, OfAFormulaHasItsIlluminance) {
    const Sky sky = sky_of("cie:15,sun=200/10,horizontal=20klx,color=2700K");
    const SkyPicture picture = *sky_picture(sky);
    ASSERT_TRUE(picture.image);
    EXPECT_NEAR(picture.horizontal.value, 20000.0, 1e-3);
    EXPECT_NEAR(glm::dot(picture.image->irradiance(up), rec709_luminance), 20000.0, 2.0);
    // Red exceeds what half floats hold.
    EXPECT_GT(picture.image->nits_per_unit(), 1.0);
    const std::vector<float>& values = picture.image->image().pixels;
    EXPECT_LE(*std::max_element(values.begin(), values.end()), 65504.0F);
}

TEST(SkyPicture, OfAnImageIsALatLongWithItsLight) {
    const auto map = std::make_shared<const EnvironmentMap>(uneven(EnvironmentLayout::cube_cross, 36, 27));
    const Sky sky = *resolve_sky(*parse_sky_description("image:x.exr,horizontal=500lx,rotate=50deg"), map);
    const SkyPicture picture = *sky_picture(sky);
    EXPECT_EQ(picture.image->grid().layout(), EnvironmentLayout::latlong);
    EXPECT_EQ(picture.image->grid().height(), 18);
    const glm::dvec3 light = sky.light();
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(picture.image->light()[c], light[c], 1e-6 * light[c]);
}

TEST(SkyPicture, OfAUniformSkyIsANumber) {
    const SkyPicture picture = *sky_picture(sky_of("uniform:horizontal=500lx,color=2700K"));
    EXPECT_FALSE(picture.image);
    EXPECT_NEAR(picture.uniform.value, 500.0 / pi, 1e-9);
    EXPECT_NEAR(glm::dot(picture.color, rec709_luminance), 1.0, 1e-12);
    EXPECT_GT(picture.color.x, picture.color.z);
}

// Each target as its row says; the sky alone is enough for a scene.
TEST(SkyInTargets, IsAPictureOrTheirConstant) {
    const SkyPicture uniform = *sky_picture(sky_of("500lx"));
    SkyPicture image;
    image.image = std::make_shared<const EnvironmentMap>(uneven(EnvironmentLayout::latlong, 8, 4));
    for (const Target& target : targets()) {
        const std::string name(target.name);
        const TargetSky& held = target.holds.sky;
        if (held.picture == SkyPictureKind::none) {
            EXPECT_FALSE(held.reason.empty()) << name;
            LightSceneOptions options;
            options.name = "scene";
            options.sky = &uniform;
            EXPECT_FALSE(light_scene(target, {}, options)) << name;
            const LightScene scene = scene_for(name.c_str(), image, bulb("bulb"));
            ASSERT_EQ(scene.instead.size(), 1U) << name;
            EXPECT_NE(scene.instead[0].find(held.reason), std::string::npos);
            EXPECT_EQ(picture_in(scene), nullptr) << name;
            continue;
        }
        const LightScene scene = scene_for(name.c_str(), image);
        const AssetFile* const file = picture_in(scene);
        ASSERT_NE(file, nullptr) << name;
        EXPECT_EQ(file->picture.has_value(), held.picture == SkyPictureKind::equal_area) << name;
        EXPECT_TRUE(name == "raw" || text_of(scene).find(file->name) != std::string::npos) << name;
        EXPECT_TRUE(scene.instead.empty()) << name;
        EXPECT_EQ(picture_in(scene_for(name.c_str(), uniform)) == nullptr, held.has_uniform) << name;
    }
}

TEST(SkyInTargets, UniformLuminances) {
    const SkyPicture sky = *sky_picture(sky_of("100nt"));
    EXPECT_NE(text_of(scene_for("usd", sky)).find("float inputs:intensity = 100\n"), std::string::npos);
    EXPECT_NE(text_of(scene_for("pbrt", sky)).find("\"infinite\" \"rgb L\" [ 1 1 1 ] \"float scale\" [ 100 ]"),
              std::string::npos);
    EXPECT_NE(text_of(scene_for("mitsuba", sky)).find(R"(type="constant">)"), std::string::npos);
    EXPECT_NE(text_of(scene_for("mitsuba", sky)).find(R"(<rgb name="radiance" value="100, 100, 100"/>)"),
              std::string::npos);
    EXPECT_NE(text_of(scene_for("luxcore", sky))
                  .find("\"constantinfinite\"\nscene.lights.sky.color = 1 1 1\n"
                        "scene.lights.sky.gain = 100 100 100\n"),
              std::string::npos);
    EXPECT_NE(text_of(scene_for("blender", sky)).find("sky_world(\"sky\", (1, 1, 1), 0.56233481"), std::string::npos);
    EXPECT_NE(text_of(scene_for("radiance", sky)).find("glow sky\n0\n0\n4 0.5586592178770949"), std::string::npos);
}

// A light of the same name keeps it, also where its profile is a picture.
TEST(SkyInTargets, HasANameOfItsOwn) {
    SkyPicture sky;
    sky.image = std::make_shared<const EnvironmentMap>(uneven(EnvironmentLayout::latlong, 8, 4));
    const LightScene scene = scene_for("pbrt", sky, bulb("sky"));
    EXPECT_EQ(picture_in(scene)->name, "scene.sky_2.equal-area.exr");
    EXPECT_NE(text_of(scene).find("# sky\n"), std::string::npos);
}

} // namespace
} // namespace gonio
