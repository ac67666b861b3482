// Radiance: scene descriptions (.rad), data (.dat) and functions (.cal), Z up.
//
// Numbers are radiometric: W/sr/m² in three channels, of which Radiance makes cd/m² by 179 (0.265 R + 0.670 G + 0.065
// B). The channels are those of Radiance's own primaries with equal energy as white; greys stay grey. It has no points:
// a small sphere stands for one. A profile is data over C and γ on such a sphere, looked up by the direction to the
// receiver in the light's own frame and linear between its angles, as here. Its spots have a hard edge and no falloff,
// so spots become profiles. `light` shines from the front of a surface.
//
// Radiance samples a polygon as the parallelogram of its first corner, or as a square of its area, and a sphere at its
// centre, even where another surface hides it; a cylinder loses a tenth of its light towards its ends. So an ellipse is
// a row of rectangles of its area, and a tube is small faces.
//
// A sky is a glow around everything, with a Radiance picture whose pixels are Rec.709. Radiance reads a mantissa as the
// middle of what it stands for.
#include <gonio/asset/detail/radiance_text.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/web/symmetry.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gonio::asset_detail {

namespace {

using std::numbers::pi;

constexpr double lumens_per_watt = 179.0;
constexpr double point_radius_m = 1e-3;
const glm::dvec3 brightness(0.265074126, 0.670114631, 0.064811243); // of its channels, Radiance's color.h

std::string of_three(std::string_view modifier, std::string_view kind, std::string_view name, const glm::dvec3& rgb) {
    return fmt::format("{} {} {}\n0\n0\n3 {}\n", modifier, kind, name, triple(rgb, " "));
}

// W/sr/m² for cd/m² of a colour of luminance 1.
glm::dvec3 radiance(const glm::dvec3& color, double nits) {
    const glm::dvec3 rgb = glm::max(radiance_rgb(color), glm::dvec3(0.0));
    return rgb * (nits / lumens_per_watt / glm::dot(rgb, brightness));
}

std::string ball(const SceneLight& light, std::string_view part, const glm::dvec3& center, double radius) {
    return fmt::format("{0} sphere {0}{1}\n0\n0\n4 {2} {3}\n", light.name, part, triple(center, " "), radius);
}

// In the light's own frame: its middle and half of its sides; it shines along u × v.
std::string rectangle(const SceneLight& light, std::string_view part, const glm::dvec3& middle, const glm::dvec3& u,
                      const glm::dvec3& v) {
    const Frame& frame = light.frame;
    return fmt::format("{0} polygon {0}{1}\n", light.name, part) +
           radiance_rectangle(frame.origin + frame.to_world(middle), frame.to_world(u), frame.to_world(v));
}

// Rectangles side by side along the longer axis, each as high as the ellipse is in the mean over its width.
std::string ellipse(const SceneLight& light) {
    constexpr int count = 32;
    const bool along_x = light.width >= light.height;
    const double half_length = 0.5 * std::max(light.width, light.height);
    const double half_width = 0.5 * std::min(light.width, light.height);
    // ∫ √(1 − t²) dt
    const auto area = [](double t) { return 0.5 * (t * std::sqrt(std::max(1.0 - t * t, 0.0)) + std::asin(t)); };
    std::string text;
    for (int i = 0; i < count; ++i) {
        const double low = -1.0 + 2.0 * i / count;
        const double high = -1.0 + 2.0 * (i + 1) / count;
        const double half = half_width * (area(high) - area(low)) / (high - low);
        const double along = 0.5 * (low + high) * half_length;
        const double half_step = 0.5 * (high - low) * half_length;
        text += along_x ? rectangle(light, fmt::format(".{}", i + 1), {along, 0.0, 0.0}, {0.0, half, 0.0},
                                    {half_step, 0.0, 0.0})
                        : rectangle(light, fmt::format(".{}", i + 1), {0.0, along, 0.0}, {0.0, half_step, 0.0},
                                    {half, 0.0, 0.0});
    }
    return text;
}

// The side of a tube or a cylinder: rectangles of its area.
std::string cylinder(const SceneLight& light) {
    constexpr int around = 24;
    const double half_length = 0.5 * light.width;
    std::string text;
    for (int i = 0; i < around; ++i) {
        const double turn = 2.0 * pi * i / around;
        const glm::dvec3 out(0.0, light.radius * std::cos(turn), light.radius * std::sin(turn));
        const glm::dvec3 u(half_length, 0.0, 0.0);
        const glm::dvec3 v = pi * light.radius / around * glm::dvec3(0.0, -std::sin(turn), std::cos(turn));
        text += rectangle(light, fmt::format(".{}", i + 1), out, v, u);
    }
    return text;
}

// A hemisphere at the end of a tube at `side` (−1, 1) of its X: a rectangle for each part of a ring, of the area of
// that part of the sphere.
std::string cap(const SceneLight& light, double side) {
    constexpr int rings = 3;
    constexpr int around = 8;
    std::string text;
    for (int ring = 0; ring < rings; ++ring) {
        const double low = 0.5 * pi * ring / rings; // from the axis
        const double high = 0.5 * pi * (ring + 1) / rings;
        const double polar = 0.5 * (low + high);
        const double area = 2.0 * pi / around * (std::cos(low) - std::cos(high));
        const double half_length = 0.5 * (high - low);
        const double half_width = 0.25 * area / half_length;
        for (int i = 0; i < around; ++i) {
            const double turn = 2.0 * pi * (i + 0.5 * (ring % 2)) / around;
            const glm::dvec3 out(side * std::cos(polar), std::sin(polar) * std::cos(turn),
                                 std::sin(polar) * std::sin(turn));
            const glm::dvec3 across(0.0, -std::sin(turn), std::cos(turn));
            const glm::dvec3 u = half_width * across;
            const glm::dvec3 v = half_length * glm::cross(out, across);
            const glm::dvec3 middle = out + glm::dvec3(0.5 * light.width / light.radius * side, 0.0, 0.0);
            text += rectangle(light, fmt::format(".{}{}", side < 0.0 ? "a" : "b", ring * around + i + 1),
                              light.radius * middle, light.radius * u, light.radius * v);
        }
    }
    return text;
}

std::string text_of(const SceneLight& light, const SceneContent& scene) {
    const Frame& frame = light.frame;
    const double point_radius = point_radius_m * scene.units_per_meter;
    const double point_area = pi * point_radius * point_radius;
    const auto glowing = [&](double nits) {
        return of_three("void", "light", light.name, radiance(light.color, nits));
    };
    switch (light.kind) {
    case LightKind::profile: {
        const MeasuredLight& profile = scene.profiles[light.profile];
        return fmt::format(
                   "void brightdata {0}.profile\n5 as_it_is {1}.dat {2}.cal azimuth gamma\n0\n9 {3}  {4}  {5}\n",
                   light.name, profile.name, scene.name, triple(frame.x, " "), triple(frame.y, " "),
                   triple(frame.z, " ")) +
               of_three(light.name + ".profile", "light", light.name,
                        radiance(light.color, light.intensity / profile.peak.value / point_area)) +
               ball(light, ".point", frame.origin, point_radius);
    }
    case LightKind::sphere:
        return glowing(light.nits) + ball(light, ".body", frame.origin, light.radius);
    case LightKind::disk:
        return glowing(light.nits) + fmt::format("{0} ring {0}.face\n0\n0\n8 {1}  {2}  0 {3}\n", light.name,
                                                 triple(frame.origin, " "), triple(-frame.z, " "), light.radius);
    case LightKind::ellipse:
        return glowing(light.nits) + ellipse(light);
    case LightKind::rect:
        return glowing(light.nits) + rectangle(light, ".face", glm::dvec3(0.0), {0.0, 0.5 * light.height, 0.0},
                                               {0.5 * light.width, 0.0, 0.0});
    case LightKind::tube: {
        return glowing(light.nits) + cylinder(light) + cap(light, -1.0) + cap(light, 1.0);
    }
    case LightKind::cylinder:
        return glowing(light.nits) + cylinder(light);
    case LightKind::sun:
        return glowing(light.nits) + fmt::format("{0} source {0}.disk\n0\n0\n4 {1}  {2}\n", light.name,
                                                 triple(frame.z, " "), light.diameter * 180.0 / pi);
    default: // a point
        return glowing(light.intensity / point_area) + ball(light, ".point", frame.origin, point_radius);
    }
}

// Radiance keeps the positions of data as floats and refuses two equal ones.
void remove_equal_floats(std::vector<double>& ascending) {
    const auto is_equal = [](double a, double b) { return static_cast<float>(a) == static_cast<float>(b); };
    ascending.erase(std::unique(ascending.begin(), ascending.end(), is_equal), ascending.end());
}

// Ascending, from 0 to 360°.
std::vector<double> all_planes(const Web& web) {
    std::vector<double> planes = plane_bends_deg(web);
    if (planes.empty() || planes.front() > 0.0) planes.insert(planes.begin(), 0.0);
    planes.push_back(360.0);
    remove_equal_floats(planes);
    return planes;
}

// From 0 to 180°; no light outside the stored angles.
std::vector<double> all_gammas(const Web& web) {
    constexpr double step = 1e-4; // some floats apart at 180
    const std::span<const double> stored = web.gammas_deg();
    std::vector<double> gammas;
    if (stored.front() > 0.0) gammas.push_back(0.0);
    if (stored.front() > step) gammas.push_back(stored.front() - step);
    gammas.insert(gammas.end(), stored.begin(), stored.end());
    if (stored.back() < 180.0 - step) gammas.push_back(stored.back() + step);
    if (stored.back() < 180.0) gammas.push_back(180.0);
    remove_equal_floats(gammas);
    return gammas;
}

// Candela by C and γ, as Radiance reads data between uneven positions.
std::string data_of(const MeasuredLight& profile) {
    const std::vector<double> planes = all_planes(profile.web);
    const std::vector<double> gammas = all_gammas(profile.web);
    std::string text = fmt::format("# {}\n# candela by C and gamma [degrees]\n2\n", describe(profile));
    for (const std::vector<double>* angles : {&planes, &gammas}) {
        text += fmt::format("0 0 {}", angles->size());
        for (const double angle : *angles)
            text += fmt::format(" {}", angle);
        text += '\n';
    }
    for (const double c : planes) {
        for (const double gamma : gammas)
            text += fmt::format("{} ", profile.web.candela(c, gamma));
        text.back() = '\n';
    }
    return text;
}

std::string profile_functions() {
    return "{ Axes of a light: A1 A2 A3 is its X, C = 0; A4 A5 A6 its Y, C = 90; A7 A8 A9 its Z, which it shines "
           "from.\n"
           "  A ray meets the light along D, so what it sees was sent along -D. }\n"
           "sent_x = -(Dx*A1 + Dy*A2 + Dz*A3);\n"
           "sent_y = -(Dx*A4 + Dy*A5 + Dz*A6);\n"
           "sent_z = -(Dx*A7 + Dy*A8 + Dz*A9);\n"
           "turn = atan2(sent_y, sent_x) * 180 / PI;\n"
           "azimuth = if(turn, turn, turn + 360);\n"
           "gamma = atan2(sqrt(sent_x*sent_x + sent_y*sent_y), -sent_z) * 180 / PI;\n"
           "as_it_is(v) = v;\n"
           "{ The share of a material in a mix. }\n"
           "share = A1;\n";
}

// How a sky is looked up: its picture is two wide and one high, from the middle of its lower left pixel to that of its
// upper right one. Its colours become Radiance's own of the same luminance, as those of lights do.
std::string sky_functions(int height) {
    std::string text = fmt::format("{{ The sky: north in the middle of the picture, east to the right. }}\n"
                                   "sky_u = 2 * ({0} * (0.5 + atan2(Dx, Dy) / (2*PI)) - 0.5) / {1};\n"
                                   "sky_v = ({2} * (0.5 + atan2(Dz, sqrt(Dx*Dx + Dy*Dy)) / PI) - 0.5) / {3};\n",
                                   2 * height, 2 * height - 1, height, height - 1);
    const std::array<glm::dvec3, 3> columns{radiance_rgb({1.0, 0.0, 0.0}), radiance_rgb({0.0, 1.0, 0.0}),
                                            radiance_rgb({0.0, 0.0, 1.0})};
    constexpr std::array<std::string_view, 3> names{"red", "green", "blue"};
    const auto row = [&](int channel) {
        return fmt::format("max(0, {:.9g}*r + {:.9g}*g + {:.9g}*b)", columns[0][channel], columns[1][channel],
                           columns[2][channel]);
    };
    for (int channel = 0; channel < 3; ++channel)
        text += fmt::format("own_{}(r, g, b) = {};\n", names.at(static_cast<std::size_t>(channel)), row(channel));
    const auto weighted = [](const glm::dvec3& weights, std::string_view r, std::string_view g, std::string_view b) {
        return fmt::format("{:.9g}*{} + {:.9g}*{} + {:.9g}*{}", weights.x, r, weights.y, g, weights.z, b);
    };
    text += fmt::format("own_luminance(r, g, b) = {};\n",
                        weighted(brightness, "own_red(r, g, b)", "own_green(r, g, b)", "own_blue(r, g, b)"));
    text += fmt::format("kept(r, g, b) = if(own_luminance(r, g, b), ({}) / own_luminance(r, g, b), 0);\n",
                        weighted(rec709_luminance, "r", "g", "b"));
    for (const std::string_view name : names)
        text += fmt::format("sky_{0}(r, g, b) = kept(r, g, b) * own_{0}(r, g, b);\n", name);
    return text;
}

// A source all around, which ambient light alone reaches.
std::string text_of(const SceneSky& sky, std::string_view functions) {
    const auto glow = [&](std::string_view modifier, const glm::dvec3& rgb) {
        return fmt::format("{0} glow {1}\n0\n0\n4 {2} 0\n{1} source {1}.dome\n0\n0\n4 0 0 1 360\n", modifier, sky.name,
                           triple(rgb, " "));
    };
    const std::string title = fmt::format("# {:.6g} lx on the horizontal\n", sky.lux);
    if (sky.picture.empty()) return title + glow("void", radiance(sky.color, sky.nits));
    return title +
           fmt::format("void colorpict {0}.picture\n7 sky_red sky_green sky_blue {1} {2}.cal sky_u sky_v\n0\n0\n",
                       sky.name, sky.picture, functions) +
           glow(sky.name + ".picture", glm::dvec3(sky.nits_per_unit / lumens_per_watt));
}

} // namespace

glm::dvec3 radiance_rgb(const glm::dvec3& rec709) {
    if (rec709.x == rec709.y && rec709.y == rec709.z) return rec709; // without rounding
    static const glm::dmat3 matrix = [] {
        const RgbSpace own =
            rgb_space_of("radiance", Xy{0.64, 0.33}, Xy{0.29, 0.6}, Xy{0.15, 0.06}, Xy{1.0 / 3.0, 1.0 / 3.0}).value();
        return own.from_xyz * find_rgb_space("rec709")->to_xyz;
    }();
    return matrix * rec709;
}

std::string radiance_rectangle(const glm::dvec3& middle, const glm::dvec3& u, const glm::dvec3& v) {
    std::string text = "0\n0\n12\n";
    for (const glm::dvec3& corner : {middle - u - v, middle + u - v, middle + u + v, middle - u + v})
        text += fmt::format("    {}\n", triple(corner, " "));
    return text;
}

std::vector<AssetFile> radiance_files(const SceneContent& scene) {
    std::string text = fmt::format("# {}\n", scene.description);
    std::string functions;
    bool has_functions = !scene.profiles.empty();
    std::vector<AssetFile> files;
    if (scene.stage) {
        text += radiance_stage(*scene.stage, scene.name, scene.sky.has_value());
        has_functions = has_functions || text.find(" mixfunc ") != std::string::npos;
        files.push_back({scene.name + ".vf", radiance_view(scene.stage->camera), {}});
    } else {
        text += fmt::format("# oconv {0}.rad ROOM.rad > {0}.oct\n", scene.name);
        if (scene.single) text += "# The beam goes along -Z, C0 along +X, C90 along +Y.\n";
    }
    for (const SceneLight& light : scene.lights)
        text += '\n' + text_of(light, scene);
    if (has_functions) functions = profile_functions();
    if (scene.sky) {
        text += '\n' + text_of(*scene.sky, scene.name);
        if (!scene.sky->picture.empty()) functions += sky_functions(scene.sky->picture_height);
    }
    files.insert(files.begin(), {scene.name + ".rad", std::move(text), {}});
    if (!functions.empty()) files.push_back({scene.name + ".cal", std::move(functions), {}});
    for (const MeasuredLight& profile : scene.profiles)
        files.push_back({profile.name + ".dat", data_of(profile), {}});
    return files;
}

} // namespace gonio::asset_detail
