// The luminance of a surface under area lights by quadrature, for the pixels of a picture that another program has
// made.
//
//   gonio-three-truth SCENE.json PIXELS TRUTH
//
// SCENE.json: `lights` with shape, center, axis (in which a flat light emits; along a tube), width_direction, sizes in
// metres and luminance_nt; `base` and `metallic` of the material. PIXELS: for each, ten floats: position, unit normal,
// unit direction to the eye, linear roughness. TRUTH gets a float for each [nt]: Lambert and GGX, f0 = 0.04 or the
// base, each light entirely visible above the horizon.
#include <gonio/light/light.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/probe_light.hpp>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace gonio;

glm::dvec3 vector_of(const nlohmann::json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Light light_of(const nlohmann::json& json) {
    const auto size = [&](const char* name) { return Meters{json.at(name).get<double>()}; };
    const std::string shape = json.at("shape");
    LightDescription description;
    description.position = vector_of(json.at("center"));
    description.intensity = parse_photometric_value(json.at("luminance_nt").dump() + "nt").value();
    const glm::dvec3 axis = glm::normalize(vector_of(json.at("axis")));
    description.direction = axis;
    if (shape == "rect") {
        description.shape = RectShape{size("width"), size("height")};
        description.up = glm::cross(axis, vector_of(json.at("width_direction")));
    } else if (shape == "disk") {
        description.shape = DiskShape{size("radius")};
        description.up = vector_of(json.at("width_direction"));
    } else if (shape == "sphere") {
        description.shape = SphereShape{size("radius")};
        description.up = vector_of(json.at("width_direction"));
    } else {
        description.shape = TubeShape{size("radius"), size("length")};
        description.direction = vector_of(json.at("width_direction")); // across the axis
        description.up = glm::cross(description.direction, axis);
    }
    Diagnostics diagnostics;
    return resolve_light(description, diagnostics).value();
}

std::string bytes_of(const char* file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void run(const char* scene_file, const char* pixels_file, const char* truth_file) {
    const nlohmann::json scene = nlohmann::json::parse(bytes_of(scene_file));
    std::vector<Light> lights;
    for (const nlohmann::json& each : scene.at("lights"))
        lights.push_back(light_of(each));
    const std::string bytes = bytes_of(pixels_file);
    std::vector<float> numbers(bytes.size() / sizeof(float));
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(numbers.data()));
    const detail::ProbeWay way{IrradianceMethod::reference, {1e-5, 4'000'000}};
    Ue4Material material;
    material.base = glm::dvec3(scene.at("base").get<double>());
    material.metallic = scene.at("metallic").get<double>();
    std::vector<float> truth;
    for (std::size_t i = 0; i + 10 <= numbers.size(); i += 10) {
        const auto at = [&](std::size_t k) {
            return glm::dvec3(static_cast<double>(numbers[i + k]), static_cast<double>(numbers[i + k + 1]),
                              static_cast<double>(numbers[i + k + 2]));
        };
        material.roughness = static_cast<double>(numbers[i + 9]);
        const glm::dvec3 normal = glm::normalize(at(3));
        double nt = 0.0;
        for (const Light& light : lights) {
            const detail::ProbeShare share = detail::illuminance_of(light, at(0), normal, way);
            nt += detail::luminance_of(light, at(0), normal, {material, glm::normalize(at(6))}, share, way)
                      .luminance.total()
                      .value;
        }
        truth.push_back(static_cast<float>(nt));
    }
    std::ofstream(truth_file, std::ios::binary)
        .write(reinterpret_cast<const char*>(truth.data()), static_cast<std::streamsize>(truth.size() * sizeof(float)));
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("usage: gonio-three-truth SCENE.json PIXELS TRUTH\n", stderr);
        return 2;
    }
    try {
        run(argv[1], argv[2], argv[3]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gonio-three-truth: %s\n", error.what());
        return 1;
    }
    return 0;
}
