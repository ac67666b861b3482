#include <gonio/asset/detail/scene_sky.hpp>
#include <gonio/asset/sky_picture.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/equal_area_square.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

constexpr int usual_height = 512; // of skies by formula
constexpr glm::dvec3 up{0.0, 0.0, 1.0};

// The same luminances with a scale at which half floats hold all pixels.
EnvironmentMap within_halfs(const EnvironmentMap& map) {
    constexpr double largest_half = 65504.0;
    const std::vector<float>& values = map.image().pixels;
    const double most = static_cast<double>(*std::max_element(values.begin(), values.end())) * map.nits_per_unit();
    const double scale = most > largest_half ? std::exp2(std::ceil(std::log2(most / largest_half))) : 1.0;
    if (scale == map.nits_per_unit()) return map;
    Image image = map.image();
    const double factor = map.nits_per_unit() / scale;
    for (float& value : image.pixels)
        value = static_cast<float>(static_cast<double>(value) * factor);
    return EnvironmentMap::of_valid(map.grid(), std::move(image), scale);
}

// For targets without a constant: small, and large enough for what they filter.
std::shared_ptr<const EnvironmentMap> uniform_image(const SkyPicture& sky) {
    constexpr int height = 32;
    const EnvironmentGrid grid = EnvironmentGrid::create(EnvironmentLayout::latlong, 2 * height, height).value();
    Image image(grid.width(), grid.height(), 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<float>(sky.uniform.value * sky.color[static_cast<int>(i % 3)]);
    return std::make_shared<const EnvironmentMap>(within_halfs(EnvironmentMap::of_valid(grid, std::move(image), 1.0)));
}

// Half a unit of the shared exponent less in each channel, which the reader adds. What rounds to a channel of 0 is read
// as half a unit.
EnvironmentMap for_rgbe_reader(const EnvironmentMap& map) {
    Image image = map.image();
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
        float* const rgb = image.pixels.data() + i;
        const float most = std::max({rgb[0], rgb[1], rgb[2]});
        if (!(most > 0.0F)) continue;
        int exponent = 0;
        std::frexp(most, &exponent);
        for (int c = 0; c < 3; ++c)
            rgb[c] = std::max(rgb[c] - std::ldexp(0.5F, exponent - 8), 0.0F);
    }
    return EnvironmentMap::of_valid(map.grid(), std::move(image), map.nits_per_unit());
}

// As dense as the lat-long at its horizon.
int equal_area_side(int height) {
    return 2 * static_cast<int>(std::ceil(height * std::sqrt(std::numbers::inv_pi)));
}

std::shared_ptr<const EnvironmentMap> image_of(const SkyPicture& sky) {
    return sky.image ? sky.image : uniform_image(sky);
}

} // namespace

Result<SkyPicture> sky_picture(const Sky& sky, unsigned threads) {
    SkyPicture made;
    made.sun = sky.sun();
    made.horizontal = Lux(glm::dot(sky.irradiance(up, threads), rec709_luminance));
    if (!sky.image() && !sky.cie()) {
        made.uniform = sky.zenith();
        if (made.uniform.value > 0.0) made.color = sky.radiance(up) / made.uniform.value;
        return made;
    }
    int height = usual_height;
    if (sky.image()) {
        const EnvironmentGrid& own = sky.image()->grid();
        height = side_like(own.layout(), own.side(), EnvironmentLayout::latlong);
        height += height % 2;
    }
    Result<EnvironmentGrid> grid = environment_grid(EnvironmentLayout::latlong, height);
    if (!grid) return pass_on(grid);
    made.image = std::make_shared<const EnvironmentMap>(within_halfs(environment_of(sky, *grid, threads)));
    return made;
}

SceneSky asset_detail::scene_sky(const SkyPicture& sky, const TargetSky& held, std::string name,
                                 std::string_view scene) {
    SceneSky made;
    made.name = std::move(name);
    made.lux = sky.horizontal.value;
    if (!sky.image && held.has_uniform) {
        made.nits = sky.uniform.value;
        made.color = sky.color;
        return made;
    }
    // Scenes for several programs may lie in one folder.
    const std::string_view ending = held.picture == SkyPictureKind::equal_area ? "equal-area.exr"
                                    : held.picture == SkyPictureKind::latlong  ? "exr"
                                                                               : "hdr";
    made.picture = fmt::format("{}.{}.{}", scene, made.name, ending);
    const std::shared_ptr<const EnvironmentMap> image = image_of(sky);
    made.nits_per_unit = image->nits_per_unit();
    made.picture_height = image->grid().height();
    return made;
}

void asset_detail::add_sky_file(const SceneContent& scene, const SkyPicture* sky, const TargetSky& held,
                                std::vector<AssetFile>& files) {
    if (sky == nullptr || !scene.sky || scene.sky->picture.empty()) return;
    std::shared_ptr<const EnvironmentMap> map = image_of(*sky);
    AssetFile file{scene.sky->picture, {}, {}};
    if (held.picture == SkyPictureKind::equal_area) {
        file.picture = AssetPicture{equal_area_square(*map, equal_area_side(map->grid().height())), TexelType::float32};
    } else {
        if (held.picture == SkyPictureKind::latlong_rgbe)
            map = std::make_shared<const EnvironmentMap>(for_rgbe_reader(*map));
        file.environment = AssetEnvironment{std::move(map), sky->sun, sky->source, sky->source_sha256};
    }
    files.push_back(std::move(file));
}

} // namespace gonio
