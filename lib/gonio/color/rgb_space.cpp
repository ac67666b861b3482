#include <gonio/color/rgb_space.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace gonio {

namespace {

constexpr std::array names{
    RgbSpaceName{"rec709", "srgb-linear", "linear, ITU-R BT.709 primaries, D65 white: gonio's working space"},
    RgbSpaceName{"rec2020", "", "linear, ITU-R BT.2020 primaries, D65 white"},
    RgbSpaceName{"p3-d65", "", "linear, SMPTE RP 431-2 primaries, D65 white (Display P3)"},
    RgbSpaceName{"acescg", "ap1", "linear, ACES AP1 primaries, adapted to D65 by Bradford"},
    RgbSpaceName{"aces2065-1", "ap0", "linear, ACES AP0 primaries, adapted to D65 by Bradford"},
    RgbSpaceName{"xyz", "", "CIE XYZ of 1931"},
};

struct Primaries {
    Xy red, green, blue, white;
};
constexpr std::array primaries{
    Primaries{{0.640, 0.330}, {0.300, 0.600}, {0.150, 0.060}, d65_white},
    Primaries{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, d65_white},
    Primaries{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, d65_white},
    Primaries{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, aces_white},
    Primaries{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, aces_white},
};

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool same(Xy a, Xy b) {
    return a.x == b.x && a.y == b.y;
}

// RGB → XYZ of primaries that add up to the white.
glm::dmat3 matrix_of(const Primaries& p) {
    // Not divided by y: AP0's blue has a negative y, and a green of y = 1 works as well.
    const auto xyz = [](Xy c) { return glm::dvec3(c.x, c.y, 1.0 - c.x - c.y); };
    const glm::dmat3 columns(xyz(p.red), xyz(p.green), xyz(p.blue));
    const glm::dvec3 amount = glm::inverse(columns) * to_xyz(p.white);
    glm::dmat3 matrix(columns[0] * amount.x, columns[1] * amount.y, columns[2] * amount.z);
    if (!same(p.white, d65_white)) matrix = bradford(p.white, d65_white) * matrix;
    return matrix;
}

const std::array<RgbSpace, names.size()>& spaces() {
    static const std::array<RgbSpace, names.size()> made = [] {
        std::array<RgbSpace, names.size()> all;
        for (std::size_t i = 0; i < names.size(); ++i) {
            all[i].name = names[i].name;
            if (i >= primaries.size()) continue; // xyz is the identity
            all[i].to_xyz = matrix_of(primaries[i]);
            all[i].from_xyz = glm::inverse(all[i].to_xyz);
        }
        return all;
    }();
    return made;
}

} // namespace

glm::dmat3 bradford(Xy from, Xy to) {
    const glm::dmat3 response(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296);
    const glm::dvec3 a = response * to_xyz(from);
    const glm::dvec3 b = response * to_xyz(to);
    const glm::dmat3 scale(b.x / a.x, 0.0, 0.0, 0.0, b.y / a.y, 0.0, 0.0, 0.0, b.z / a.z);
    return glm::inverse(response) * scale * response;
}

glm::dvec3 luminance_row(const RgbSpace& space) {
    return {space.to_xyz[0].y, space.to_xyz[1].y, space.to_xyz[2].y};
}

std::span<const RgbSpaceName> rgb_spaces() {
    return names;
}

const RgbSpace* find_rgb_space(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (name == names[i].name || (!names[i].alias.empty() && name == names[i].alias)) return &spaces()[i];
    return nullptr;
}

Result<RgbSpace> rgb_space_of(std::string name, Xy red, Xy green, Xy blue, Xy white) {
    const double area = (green.x - red.x) * (blue.y - red.y) - (blue.x - red.x) * (green.y - red.y);
    if (!(std::abs(area) > 1e-6) || !(white.y > 0.0))
        return fail(Failure::usage, "these primaries and this white do not form a colour space",
                    "give xy of red, green and blue, which must span a triangle, and of white");
    RgbSpace space{std::move(name), matrix_of({red, green, blue, white}), {}};
    space.from_xyz = glm::inverse(space.to_xyz);
    for (int i = 0; i < 3; ++i)
        if (!finite(space.to_xyz[i]) || !finite(space.from_xyz[i]))
            return fail(Failure::usage, "these primaries and this white do not form a colour space");
    return space;
}

Result<RgbSpace> rgb_space_of_aces(std::string name, const glm::dmat3& from_aces2065_1) {
    const RgbSpace& aces = *find_rgb_space("aces2065-1");
    if (!(std::abs(glm::determinant(from_aces2065_1)) > 1e-9))
        return fail(Failure::unsupported, fmt::format("the matrix of the colour space '{}' has no inverse", name));
    RgbSpace space{std::move(name), {}, from_aces2065_1 * aces.from_xyz};
    space.to_xyz = glm::inverse(space.from_xyz);
    return space;
}

SpaceColor to_space(Uv at, const RgbSpace& space, Gamut gamut, Normalize normalize) {
    SpaceColor color;
    color.rgb = space.from_xyz * to_xyz(at);
    const glm::dvec3 row = luminance_row(space);
    color.in_gamut = std::min({color.rgb.x, color.rgb.y, color.rgb.z}) >= -1e-9;
    if (gamut == Gamut::clip) {
        color.rgb = glm::max(color.rgb, glm::dvec3(0.0));
        if (!color.in_gamut) color.delta_uv_prime = delta_uv_prime(at, to_uv(space.to_xyz * color.rgb));
    }
    color.rgb /= glm::dot(row, color.rgb);
    if (normalize == Normalize::max) color.rgb /= std::max({color.rgb.x, color.rgb.y, color.rgb.z});
    color.luminance = glm::dot(row, color.rgb);
    return color;
}

Result<Uv> uv_of_rgb(const glm::dvec3& rgb, const RgbSpace& space) {
    if (!finite(rgb)) return fail("USE0105", "an RGB component is not a finite number");
    const double size = std::max({std::abs(rgb.x), std::abs(rgb.y), std::abs(rgb.z)});
    if (!(size > 0.0)) return fail(Failure::usage, "black has no chromaticity");
    const glm::dvec3 xyz = space.to_xyz * (rgb / size);
    if (!(xyz.y > 0.0))
        return fail(Failure::usage, "an RGB of this luminance has no chromaticity", "its Y must be above 0");
    return to_uv(xyz);
}

double decode_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double encode_srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

} // namespace gonio
