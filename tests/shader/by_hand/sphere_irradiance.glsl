// As engines have it: the tilted sphere by cotangents, with clamps against 0/0.
float sphere_irradiance(vec3 to_center, float radius, vec3 normal) {
    float d2 = dot(to_center, to_center);
    if (d2 < radius * radius) {
        return 3.14159265;
    }
    float c = clamp(dot(normal, to_center) * inversesqrt(d2), -0.999, 0.999);
    float s2 = min(radius * radius / d2, 0.9999);
    if (c * c > s2) {
        return 3.14159265 * s2 * max(c, 0.0);
    }
    float x = sqrt(1.0 / s2 - 1.0);
    float t = sqrt(1.0 - c * c);
    float y = -x * c / t;
    float root = sqrt(max(1.0 - y * y, 0.0));
    return max((c * acos(clamp(y, -1.0, 1.0)) - x * t * root) * s2 + atan(t * root / x), 0.0);
}
