// As engines have it: cosines of the half angles, and a guard against a division by 0.
float spot_illuminance_frostbite(vec3 to_light, vec3 normal, vec3 aim, float inner, float outer) {
    float d2 = dot(to_light, to_light);
    vec3 l = to_light * inversesqrt(d2);
    float scale = 1.0 / max(cos(inner) - cos(outer), 0.001);
    float x = clamp(dot(aim, -l) * scale - cos(outer) * scale, 0.0, 1.0);
    return max(dot(normal, l), 0.0) / d2 * x * x;
}
