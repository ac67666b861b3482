// A custom target: the kinds of light that an engine has, and the text that it reads. gonio converts the others.
#include <gonio/asset/light_scene.hpp>
#include <gonio/asset/scene_content.hpp>

#include <array>
#include <cstdio>
#include <utility>
#include <vector>

namespace {

std::string line_of(const gonio::SceneLight& light, const gonio::SceneContent& scene) {
    std::array<char, 160> text{};
    const auto& at = light.frame.origin;
    std::snprintf(text.data(), text.size(), "%s at %g %g %g: %.4g cd", light.name.c_str(), at.x, at.y, at.z,
                  light.intensity);
    std::string line = text.data();
    if (light.kind == gonio::LightKind::disk) line += ", a disk of radius " + std::to_string(light.radius);
    if (light.kind == gonio::LightKind::profile) line += ", " + scene.profiles[light.profile].name + ".ies";
    return line + "\n";
}

// One text file for the scene, and an IES file for each light that the engine has no kind for.
std::vector<gonio::AssetFile> engine_files(const gonio::SceneContent& scene) {
    std::vector<gonio::AssetFile> files(1);
    files[0].name = scene.name + ".lights";
    for (const gonio::SceneLight& light : scene.lights)
        files[0].bytes += line_of(light, scene);
    for (const gonio::MeasuredLight& profile : scene.profiles)
        files.push_back({profile.name + ".ies", profile.portable_ies, {}});
    return files;
}

constexpr std::array kinds{gonio::LightKind::point, gonio::LightKind::disk};

} // namespace

int main(int, char** arguments) {
    gonio::Target engine;
    engine.name = "engine";
    engine.holds.kinds = kinds;
    engine.holds.length = gonio::TargetLength::centimeter;
    engine.files = engine_files;

    std::vector<gonio::Light> lights;
    gonio::Diagnostics diagnostics;
    for (const auto& [name, text] : {std::pair<const char*, std::string>{"lamp", "disk:r=20cm"},
                                     {"panel", "rect:w=60cm,h=30cm"},
                                     {"measured", std::string("ies:") + arguments[1]}}) {
        gonio::LightDescription description;
        const auto shape = gonio::parse_shape(text);
        if (!shape) return 1;
        description.name = name;
        description.shape = *shape;
        if (text[0] != 'i') description.intensity = *gonio::parse_photometric_value("800lm");
        description.position = {0.0, 0.0, 2.5};
        auto light = gonio::resolve_light(std::move(description), diagnostics);
        if (!light) return 1;
        lights.push_back(std::move(*light));
    }
    const auto scene = gonio::light_scene(engine, lights, {"room", "three lights", gonio::Meters(1.0)});
    if (!scene) {
        std::puts(to_text(scene.error().diagnostics.back()).c_str());
        return 1;
    }
    for (const gonio::AssetFile& file : scene->files)
        std::printf("%s, %zu bytes\n", file.name.c_str(), file.bytes.size());
    std::fputs(scene->files[0].bytes.c_str(), stdout);
    for (const std::string& instead : scene->instead)
        std::puts(instead.c_str());
}
