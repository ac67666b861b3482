// Mitsuba 3: XML of emitters, right-handed; its numbers are used as photometric ones.
//
// There is no goniometric emitter (only an environment map is looked up by direction). The closest substitute is a box
// of up to six projectors of 90° at the luminaire's position. A projector emits π t(u, v) scale/cos³θ W/sr along +Z,
// with θ from its own axis, at u = (1 − x/z)/2 and v = (1 − y/z)/2; its texture has the first row at v = 0 and is
// filtered linearly. So a texel stores the intensity times cos³θ/π. Spots fall linearly over the angle, along +Z;
// rectangles and disks emit along +Z. A capsule is a cylinder and two spheres; the inner halves of the spheres only
// light its inside. A rectangle's texture has its first row at y = −1. An environment map has +Y as its pole and +Z in
// its middle, with −X to the right.
#include <gonio/asset/detail/mitsuba_text.hpp>
#include <gonio/asset/detail/scene_image.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace gonio::asset_detail {

namespace {

using std::numbers::pi;

constexpr int face_size = 256;

// A projector's axes in the light's frame, right-handed: it emits along `z`.
struct Face {
    std::string_view name;
    glm::dvec3 x, y, z;
};

constexpr std::array<std::string_view, 6> face_names{"nz", "px", "nx", "py", "ny", "pz"};

Face face_of(std::size_t index) {
    const std::array<glm::dvec3, 6> aims{{{0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}};
    const glm::dvec3 z = aims[index];
    const glm::dvec3 x = z.z != 0.0 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    return {face_names[index], x, glm::cross(z, x), z};
}

// The projector's texture, relative to the peak and in the light's colour; its greatest channel is 1 at the peak.
Image face_image(const Face& face, const MeasuredLight& profile, const glm::dvec3& color) {
    Image image(face_size, face_size, 3);
    for (int row = 0; row < face_size; ++row)
        for (int column = 0; column < face_size; ++column) {
            const double x = 1.0 - 2.0 * (column + 0.5) / face_size;
            const double y = 1.0 - 2.0 * (row + 0.5) / face_size;
            const double cosine = 1.0 / std::sqrt(1.0 + x * x + y * y);
            const double share = profile.web.candela(x * face.x + y * face.y + face.z) / profile.peak.value * cosine *
                                 cosine * cosine / pi;
            for (int k = 0; k < 3; ++k)
                image.at(column, row)[k] = static_cast<float>(std::max(share, 0.0) * color[k]);
        }
    return image;
}

bool is_dark(const Image& image) {
    return std::all_of(image.pixels.begin(), image.pixels.end(), [](float value) { return value == 0.0F; });
}

// Mitsuba's +Z is our −Z.
std::string aimed(const Frame& frame, double width = 1.0, double height = 1.0) {
    return mitsuba_matrix(width * frame.x, -height * frame.y, -frame.z, frame.origin);
}

// The text without anything that ends an XML comment.
std::string comment(std::string_view text) {
    std::string plain;
    for (const char c : text)
        plain += c == '-' ? '_' : c;
    return plain;
}

std::string emitting(const SceneLight& light) {
    return fmt::format("<emitter type=\"area\">{}</emitter>", mitsuba_rgb("radiance", light.nits * light.color));
}

std::string ball(const SceneLight& light, const glm::dvec3& center) {
    return fmt::format(
        "    <shape type=\"sphere\">\n        <point name=\"center\" value=\"{}\"/><float name=\"radius\" "
        "value=\"{}\"/>\n        {}\n    </shape>\n",
        triple(center), light.radius, emitting(light));
}

std::string side_of(const SceneLight& light) {
    const glm::dvec3 half = 0.5 * light.width * light.frame.x;
    return fmt::format("    <shape type=\"cylinder\">\n        <point name=\"p0\" value=\"{}\"/><point name=\"p1\" "
                       "value=\"{}\"/><float name=\"radius\" value=\"{}\"/>\n        {}\n    </shape>\n",
                       triple(light.frame.origin - half), triple(light.frame.origin + half), light.radius,
                       emitting(light));
}

std::string flat(std::string_view type, const SceneLight& light, double width, double height) {
    return fmt::format("    <shape type=\"{}\">\n        {}\n        {}\n    </shape>\n", type,
                       aimed(light.frame, width, height), emitting(light));
}

std::string emitter(std::string_view type, const std::string& inside) {
    return fmt::format("    <emitter type=\"{}\">\n        {}\n    </emitter>\n", type, inside);
}

std::string bitmap(std::string_view name, std::string_view file, std::string_view more = {}) {
    return fmt::format(R"(<texture type="bitmap" name="{}"><string name="filename" value="{}"/>)"
                       R"(<string name="wrap_mode" value="clamp"/>{}</texture>)",
                       name, file, more);
}

AssetFile picture_of(const SceneImage& image) {
    if (!(image.slope_x > 0.0)) {
        // The numbers of an area light's texture are its luminances.
        Image picture = panel_picture(image);
        for (float& value : picture.pixels)
            value = static_cast<float>(static_cast<double>(value) * image.peak);
        return {image.name + ".exr", {}, AssetPicture{std::move(picture), TexelType::float32}};
    }
    const Projection projection = square_texels(image);
    Image picture = projected_picture(image, projection);
    for (int row = 0; row < projection.height; ++row)
        for (int column = 0; column < projection.width; ++column) {
            const double x = (2.0 * (column + 0.5) / projection.width - 1.0) * projection.slopes.x;
            const double y = (2.0 * (row + 0.5) / projection.height - 1.0) * projection.slopes.y;
            const double square = 1.0 + x * x + y * y;
            for (int channel = 0; channel < 3; ++channel) {
                float& value = picture.at(column, row)[channel];
                value = static_cast<float>(static_cast<double>(value) / (pi * square * std::sqrt(square)));
            }
        }
    return {image.name + ".exr", {}, AssetPicture{std::move(picture), TexelType::float32}};
}

std::string text_of(const SceneLight& light, const SceneContent& scene, const std::vector<AssetFile>& faces) {
    const Frame& frame = light.frame;
    constexpr double degree = 180.0 / pi;
    switch (light.kind) {
    case LightKind::point:
        return emitter("point", fmt::format(R"(<point name="position" value="{}"/>{})", triple(frame.origin),
                                            mitsuba_rgb("intensity", light.intensity * light.color)));
    case LightKind::spot:
        return emitter("spot", fmt::format("{}\n        {}<float name=\"cutoff_angle\" value=\"{}\"/><float "
                                           "name=\"beam_width\" value=\"{}\"/>",
                                           aimed(frame), mitsuba_rgb("intensity", light.intensity * light.color),
                                           light.outer * degree, light.inner * degree));
    case LightKind::profile: {
        std::string text;
        for (std::size_t i = 0; i < face_names.size(); ++i) {
            const std::string file = fmt::format("{}.{}.exr", scene.profiles[light.profile].name, face_names[i]);
            if (std::none_of(faces.begin(), faces.end(), [&](const AssetFile& face) { return face.name == file; }))
                continue;
            const Face face = face_of(i);
            text += emitter(
                "projector",
                fmt::format(
                    "{}\n        <float name=\"fov\" value=\"90\"/><float name=\"scale\" value=\"{}\"/>\n        {}",
                    mitsuba_matrix(frame.to_world(face.x), frame.to_world(face.y), frame.to_world(face.z),
                                   frame.origin),
                    light.intensity * scaled(light.color).factor, bitmap("irradiance", file)));
        }
        return text;
    }
    case LightKind::projector: {
        const SceneImage& image = scene.images[light.image];
        return emitter("projector",
                       fmt::format("{}\n        <float name=\"fov\" value=\"{}\"/><string name=\"fov_axis\" "
                                   "value=\"x\"/><float name=\"scale\" value=\"{}\"/>\n        {}",
                                   mitsuba_matrix(-frame.x, frame.y, -frame.z, frame.origin),
                                   2.0 * std::atan(square_texels(image).slopes.x) * degree, light.intensity,
                                   bitmap("irradiance", image.name + ".exr")));
    }
    case LightKind::sphere:
        return ball(light, frame.origin);
    case LightKind::disk:
        return flat("disk", light, light.radius, light.radius);
    case LightKind::ellipse:
        return flat("disk", light, 0.5 * light.width, 0.5 * light.height);
    case LightKind::rect:
        return flat("rectangle", light, 0.5 * light.width, 0.5 * light.height);
    case LightKind::panel: {
        // The picture's left is at +X, its top at +Y: v is turned about.
        constexpr std::string_view turned =
            R"(<transform name="to_uv"><scale x="1" y="-1"/><translate y="1"/></transform>)";
        return fmt::format(
            "    <shape type=\"rectangle\">\n        {}\n        <emitter type=\"area\">{}</emitter>\n"
            "    </shape>\n",
            mitsuba_matrix(-0.5 * light.width * frame.x, 0.5 * light.height * frame.y, -frame.z, frame.origin),
            bitmap("radiance", scene.images[light.image].name + ".exr", turned));
    }
    case LightKind::tube: {
        const glm::dvec3 half = 0.5 * light.width * frame.x;
        return ball(light, frame.origin - half) + ball(light, frame.origin + half) + side_of(light);
    }
    case LightKind::cylinder:
        return side_of(light);
    case LightKind::sun:
        return emitter("directional", fmt::format(R"(<vector name="direction" value="{}"/>{})", triple(-frame.z),
                                                  mitsuba_rgb("irradiance", light.lux * light.color)));
    }
    return {};
}

std::string text_of(const SceneSky& sky) {
    if (sky.picture.empty()) return emitter("constant", mitsuba_rgb("radiance", sky.nits * sky.color));
    // The pole becomes +Z, the middle +Y, the right +X.
    return emitter("envmap",
                   fmt::format("<string name=\"filename\" value=\"{}\"/><float name=\"scale\" value=\"{}\"/>\n"
                               "        {}",
                               sky.picture, sky.nits_per_unit,
                               mitsuba_matrix({-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, glm::dvec3(0.0))));
}

} // namespace

std::string mitsuba_matrix(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& origin) {
    return fmt::format(R"(<transform name="to_world"><matrix value="{} {} {} 0 0 0 1"/></transform>)",
                       triple({x.x, y.x, z.x}, " ") + fmt::format(" {}", origin.x),
                       triple({x.y, y.y, z.y}, " ") + fmt::format(" {}", origin.y),
                       triple({x.z, y.z, z.z}, " ") + fmt::format(" {}", origin.z));
}

std::string mitsuba_rgb(std::string_view name, const glm::dvec3& color) {
    return fmt::format(R"(<rgb name="{}" value="{}"/>)", name, triple(color));
}

std::vector<AssetFile> mitsuba_files(const SceneContent& scene) {
    std::vector<AssetFile> faces;
    std::vector<bool> done(scene.profiles.size());
    for (const SceneLight& light : scene.lights) {
        if (light.kind != LightKind::profile || done[light.profile]) continue; // a profile has one colour
        done[light.profile] = true;
        const MeasuredLight& profile = scene.profiles[light.profile];
        for (std::size_t i = 0; i < face_names.size(); ++i) {
            Image image = face_image(face_of(i), profile, scaled(light.color).rgb);
            if (!is_dark(image))
                faces.push_back({fmt::format("{}.{}.exr", profile.name, face_names[i]),
                                 {},
                                 AssetPicture{std::move(image), TexelType::float32}});
        }
    }
    std::string text = fmt::format("<!-- {} -->\n<scene version=\"3.0.0\">\n", comment(scene.description));
    if (scene.stage) text += mitsuba_stage(*scene.stage);
    for (const SceneLight& light : scene.lights) {
        if (!scene.single) text += fmt::format("    <!-- {} -->\n", comment(light.name));
        text += text_of(light, scene, faces);
    }
    if (scene.sky)
        text +=
            fmt::format("    <!-- {}: {:.6g} lx on the horizontal -->\n", comment(scene.sky->name), scene.sky->lux) +
            text_of(*scene.sky);
    text += "</scene>\n";
    std::vector<AssetFile> files{{scene.name + ".xml", std::move(text), {}}};
    std::move(faces.begin(), faces.end(), std::back_inserter(files));
    std::transform(scene.images.begin(), scene.images.end(), std::back_inserter(files), picture_of);
    return files;
}

} // namespace gonio::asset_detail
