#version 450
#extension GL_GOOGLE_include_directive : require
// A glTF surface (metallic-roughness) under area lights of any shape, for Vulkan: tests/shader/include.sh compiles it.
#include "area_lights.glsl" // gonio shader, as ENGINES.md says

struct AreaLight {
    int shape;            // 0 rectangle, 1 disk, 2 sphere, 3 tube
    vec3 luminance_nt;    // of red, green and blue [cd/m2]
    vec3 center;          // [m]
    vec3 axis;            // unit: in which a rectangle or disk emits; along a tube
    vec3 width_direction; // unit, across the axis
    float width;          // [m] of a rectangle; the radius of another shape
    float height;         // [m] of a rectangle; the length of a tube without its half spheres
};
layout(std140, set = 0, binding = 0) uniform Scene {
    vec3 eye;
    int light_count;
    AreaLight lights[16];
};
layout(set = 0, binding = 1) uniform sampler2DArray ltc_ggx; // bilinear, clamped to the edge

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 shading_normal;
layout(location = 2) in vec4 base_color_metallic;
layout(location = 3) in float perceptual_roughness;
layout(location = 0) out vec4 luminance;

float irradiance(AreaLight light, vec3 to_center, vec3 n) { // E/L [sr]
    if (light.shape == 0) return rect_irradiance(to_center, light.axis, light.width_direction, light.width, light.height, n);
    if (light.shape == 1) return disk_irradiance(to_center, light.axis, light.width, n);
    if (light.shape == 2) return sphere_irradiance(to_center, light.width, n);
    return tube_irradiance(to_center, light.axis, light.width, light.height, n);
}

vec3 highlight(AreaLight light, vec3 to_center, vec3 n, vec3 v, vec3 f0, float f90, float roughness, vec3 leaning, vec3 reflected) {
    if (light.shape == 0)
        return rect_shade_ggx_ltc(to_center, light.axis, light.width_direction, light.width, light.height, n, v, f0, f90, roughness, leaning, reflected);
    if (light.shape == 1) return disk_shade_ggx_ltc(to_center, light.axis, light.width, n, v, f0, f90, roughness, leaning, reflected);
    if (light.shape == 2) return sphere_shade_ggx_ltc(to_center, light.width, n, v, f0, f90, roughness, leaning, reflected);
    return tube_shade_ggx_ltc(to_center, light.axis, light.width, light.height, n, v, f0, f90, roughness, leaning, reflected);
}

void main() {
    vec3 n = normalize(shading_normal);
    vec3 v = normalize(eye - position);
    vec3 base = base_color_metallic.rgb;
    float metallic = base_color_metallic.a;
    float roughness = max(perceptual_roughness, 0.01); // alpha = roughness^2 is at least 1e-4
    vec3 f0 = mix(vec3(0.04), base, metallic);
    // The table once for each surface, not for each light.
    vec2 at = vec2(sqrt(clamp(dot(n, v), 0.0, 1.0)), roughness) * 0.96875 + 0.015625; // 32 texels
    vec4 first = texture(ltc_ggx, vec3(at, 0.0));
    vec3 leaning = first.xyz;
    vec3 reflected = vec3(first.w, texture(ltc_ggx, vec3(at, 1.0)).xy);
    // What the highlight reflects of uniform light: the diffuse part gets the rest, and what a rough lobe loses between its
    // facets is given back.
    vec3 reflectance = f0 * (reflected.y - reflected.z) + reflected.z;
    vec3 diffuse = base * (1.0 - metallic) * (1.0 - reflectance) / 3.14159265;
    vec3 several_times = 1.0 + f0 * (1.0 / reflected.y - 1.0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < light_count; ++i) {
        vec3 to_center = lights[i].center - position;
        sum += lights[i].luminance_nt * (diffuse * irradiance(lights[i], to_center, n) +
                                         several_times * highlight(lights[i], to_center, n, v, f0, 1.0, roughness, leaning, reflected));
    }
    luminance = vec4(sum, 1.0);
}
