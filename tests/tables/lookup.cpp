// Runs the lookups that `gonio bake --table` prints at the places on stdin, "n_dot_v roughness" a line: the C header's
// (HEADER), and those in shading languages (SOURCE), which are C++ but for the names below and for what reread.py
// replaces. Prints the members of the result. TEXELS is a file of floats: layers of HEIGHT x WIDTH texels with four
// components each.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#ifdef HEADER
#include HEADER
#else
struct Vector {
    double x = 0.0, y = 0.0, z = 0.0, w = 0.0;
};
static float max(double a, double b) {
    return static_cast<float>(a > b ? a : b);
}
static float min(double a, double b) {
    return static_cast<float>(a < b ? a : b);
}
using std::sqrt;

// A texture with bilinear filtering, clamped to its edge.
struct Texels {
    std::vector<float> values;

    Vector at(double u, double v, std::size_t layer) const {
        const double x = std::fmin(std::fmax(u * WIDTH - 0.5, 0.0), WIDTH - 1.0);
        const double y = std::fmin(std::fmax(v * HEIGHT - 0.5, 0.0), HEIGHT - 1.0);
        const auto left = static_cast<std::size_t>(x);
        const auto top = static_cast<std::size_t>(y);
        const std::size_t right = left + 1 < WIDTH ? left + 1 : left;
        const std::size_t bottom = top + 1 < HEIGHT ? top + 1 : top;
        const auto mixed = [&](std::size_t c) {
            const auto get = [&](std::size_t column, std::size_t row) {
                return static_cast<double>(values[((layer * HEIGHT + row) * WIDTH + column) * 4 + c]);
            };
            const double s = x - static_cast<double>(left);
            const double t = y - static_cast<double>(top);
            return (1 - t) * ((1 - s) * get(left, top) + s * get(right, top)) +
                   t * ((1 - s) * get(left, bottom) + s * get(right, bottom));
        };
        return {mixed(0), mixed(1), mixed(2), mixed(3)};
    }
};
static Texels texels;
using vec4 = Vector;
using float4 = Vector;
struct vec2 {
    double x, y;
    vec2(double a, double b) : x(a), y(b) {}
};
struct vec3 {
    double x, y, z;
    vec3(double a, double b, double c) : x(a), y(b), z(c) {}
};
using float2 = vec2;
using float3 = vec3;
#define highp // the language of GLSL alone
struct sampler2D {};
struct sampler2DArray {};
struct SamplerState {};
[[maybe_unused]] static vec4 texture(sampler2D, vec2 at) {
    return texels.at(at.x, at.y, 0);
}
[[maybe_unused]] static vec4 texture(sampler2DArray, vec3 at) {
    return texels.at(at.x, at.y, static_cast<std::size_t>(at.z));
}
template<class T>
struct Texture2D {
    T SampleLevel(SamplerState, float2 at, double) const { return texels.at(at.x, at.y, 0); }
};
template<class T>
struct Texture2DArray {
    T SampleLevel(SamplerState, float3 at, double) const {
        return texels.at(at.x, at.y, static_cast<std::size_t>(at.z));
    }
};
// MSL.
struct sampler {};
struct level {
    explicit level(double) {}
};
template<class>
struct texture2d {
    float4 sample(sampler, float2 at, level) const { return texels.at(at.x, at.y, 0); }
};
template<class>
struct texture2d_array {
    float4 sample(sampler, float2 at, std::size_t layer, level) const { return texels.at(at.x, at.y, layer); }
};
#define constant const
// WGSL.
using texture_2d = texture2d<float>;
using texture_2d_array = texture2d_array<float>;
[[maybe_unused]] static vec4 textureSampleLevel(texture_2d, sampler, vec2 at, double) {
    return texels.at(at.x, at.y, 0);
}
[[maybe_unused]] static vec4 textureSampleLevel(texture_2d_array, sampler, vec2 at, std::size_t layer, double) {
    return texels.at(at.x, at.y, layer);
}
#include SOURCE
#endif

int main(int, char** arguments) {
#ifdef HEADER
    (void)arguments;
#else
    if (std::FILE* const file = std::fopen(arguments[1], "rb")) {
        for (float value = 0.0F; std::fread(&value, sizeof value, 1, file) == 1;)
            texels.values.push_back(value);
        (void)std::fclose(file);
    }
#endif
    float n_dot_v = 0.0F;
    float roughness = 0.0F;
    while (std::scanf("%f %f", &n_dot_v, &roughness) == 2) {
        const auto found = LOOKUP;
        static_assert(sizeof found % sizeof(float) == 0);
        const auto* const members = reinterpret_cast<const float*>(&found);
        for (std::size_t i = 0; i < sizeof found / sizeof(float); ++i)
            std::printf("%.9g ", static_cast<double>(members[i]));
        std::printf("\n");
    }
    return 0;
}
