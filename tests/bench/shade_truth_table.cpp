// The error of pictures of lights with a size: the formulas of shading/shade.hpp against the reference integrator, over
// points of a floor below the light and of a wall beside it. In Markdown, for MEASURED.md of shading/.
//
//   gonio-shade-truth-table [POINTS_ALONG_A_SIDE]
//
// Each error is the mean of |value − truth| over the mean of the truth: the error as seen over a whole picture. The
// last row is over all lights except the sun. Without arguments 12 points per side; takes about a minute.
#include <gonio/light/light.hpp>
#include <gonio/measure/shade_in_double.hpp>
#include <gonio/scene/reference.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <variant>

namespace {

using namespace gonio;
using shading::SpecularMethod;

struct Parts {
    double diffuse = 0.0;
    double specular = 0.0;
};

struct Point {
    glm::dvec3 position, normal, view;
};

shading::vec3<double> vec(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

// A floor of 6 m by 6 m below the origin's axis, seen from 4 m away at eye height, or a wall of the same size.
Point point_of(bool wall, double x, double y) {
    Point point;
    point.position = wall ? glm::dvec3(6.0 * x - 3.0, 1.0, 3.0 * y) : glm::dvec3(6.0 * x - 3.0, 6.0 * y - 3.0, 0.0);
    point.normal = wall ? glm::dvec3(0.0, -1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    point.view = glm::normalize(glm::dvec3(0.3, -4.0, 1.6) - point.position);
    return point;
}

shading::LightConstants constants_of(const Light& light) {
    shading::LightConstants constants = light_constants(light);
    if (const auto* sun = std::get_if<SunShape>(&light.shape)) {
        constants.kind = shading::LightConstants::Kind::sun;
        constants.angular_radius = static_cast<float>(0.5 * sun->diameter.value);
    }
    for (float& channel : constants.color)
        channel = static_cast<float>(light.luminance.value);
    return constants;
}

Parts shaded(SpecularMethod method, const Light& light, const Material& material, const Point& point) {
    shading::LightConstants constants = constants_of(light);
    constants.specular_method = method;
    const auto found = measure::shade_parts_in_double({vec(point.position), vec(point.normal), vec(point.view)},
                                                      constants, material_constants(material));
    return {found.diffuse.x, found.specular.x};
}

struct Errors {
    double diffuse = 0.0, specular = 0.0, by_point = 0.0, truth_diffuse = 0.0, truth_specular = 0.0;

    Errors& operator+=(const Errors& other) {
        diffuse += other.diffuse;
        specular += other.specular;
        by_point += other.by_point;
        truth_diffuse += other.truth_diffuse;
        truth_specular += other.truth_specular;
        return *this;
    }
    void print(const char* surface, const char* shape, const char* material) const {
        const auto percent = [](double error, double truth) { return truth > 0.0 ? 100.0 * error / truth : 0.0; };
        (void)std::printf("| %s | %s | %s | %.4f %% | %.2f %% | %.0f %% |\n", surface, shape, material,
                          percent(diffuse, truth_diffuse), percent(specular, truth_specular),
                          percent(by_point, truth_specular));
        (void)std::fflush(stdout);
    }
};

} // namespace

int main(int argc, char** argv) {
    const int side = argc > 1 ? std::atoi(argv[1]) : 12;
    constexpr std::array shapes{"sphere:r=10cm",      "sphere:r=40cm",       "disk:r=30cm",        "rect:w=60cm,h=30cm",
                                "rect:w=1.2m,h=1.2m", "tube:r=1.3cm,l=1.2m", "tube:r=10cm,l=60cm", "sun:angle=0.53deg"};
    constexpr std::array materials{"frostbite", "frostbite:smoothness=0.9",    "frostbite:smoothness=0.2", "gltf",
                                   "eon",       "kulla-conty:f0=0.8,alpha=0.4"};
    (void)std::printf("| surface | light | material | diffuse | specular, ltc | representative point |\n"
                      "|---|---|---|---|---|---|\n");
    Errors all;
    for (const bool wall : {false, true})
        for (const char* shape : shapes)
            for (const char* text : materials) {
                Diagnostics diagnostics;
                LightDescription description;
                const auto parsed = parse_shape(shape);
                const auto material = parse_material(text);
                if (!parsed || !material) {
                    (void)std::fprintf(stderr, "%s or %s is none\n", shape, text);
                    return 1;
                }
                description.shape = *parsed;
                description.position = {0.2, 0.1, 2.0};
                description.direction = wall ? glm::dvec3(0.1, 0.5, -0.8) : glm::dvec3(0.1, 0.2, -0.9);
                description.up = {0.3, 1.0, 0.0};
                description.intensity =
                    *parse_photometric_value(std::holds_alternative<SunShape>(*parsed) ? "1000lx" : "1000nt");
                const auto light = resolve_light(description, diagnostics);
                if (!light) {
                    (void)std::fprintf(stderr, "%s: %s\n", shape, to_text(light.error().diagnostics.back()).c_str());
                    return 1;
                }
                Errors errors;
                for (int i = 0; i < side * side; ++i) {
                    const Point point = point_of(wall, (i % side + 0.5) / side, (i / side + 0.5) / side);
                    const ReferenceLuminance truth = reference_luminance(*light, point.position, point.normal,
                                                                         point.view, *material, {1e-5, 400'000});
                    const Parts ltc = shaded(SpecularMethod::ltc, *light, *material, point);
                    const Parts one = shaded(SpecularMethod::representative_point, *light, *material, point);
                    errors.diffuse += std::abs(ltc.diffuse - truth.diffuse.value);
                    errors.specular += std::abs(ltc.specular - truth.specular.value);
                    errors.by_point += std::abs(one.specular - truth.specular.value);
                    errors.truth_diffuse += truth.diffuse.value;
                    errors.truth_specular += truth.specular.value;
                }
                errors.print(wall ? "wall" : "floor", shape, text);
                if (!std::holds_alternative<SunShape>(*parsed)) all += errors; // the sun outshines the others
            }
    all.print("all", "", "");
    return 0;
}
