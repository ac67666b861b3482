// As engines have it: the polygon is clipped at the horizon, then Lambert's sum over its edges by arccosines.
float edge(vec3 a, vec3 b, vec3 normal) {
    vec3 plane = cross(a, b);
    float area = length(plane);
    float angle = acos(clamp(dot(a, b) * inversesqrt(dot(a, a) * dot(b, b)), -1.0, 1.0));
    return area > 0.0 ? angle * dot(plane, normal) / area : 0.0;
}

float rect_irradiance(vec3 to_center, vec3 axis, vec3 width_direction, float width, float height,
                      vec3 normal) {
    if (dot(axis, to_center) >= 0.0) {
        return 0.0;
    }
    vec3 x = width_direction * (0.5 * width);
    vec3 y = cross(axis, width_direction) * (0.5 * height);
    vec3 corners[4] = vec3[4](to_center - x - y, to_center + x - y, to_center + x + y, to_center - x + y);
    vec3 seen[6];
    int count = 0;
    for (int i = 0; i < 4; ++i) {
        vec3 a = corners[i];
        vec3 b = corners[(i + 1) % 4];
        float up = dot(a, normal);
        float next = dot(b, normal);
        if (up > 0.0) {
            seen[count++] = a;
        }
        if (up * next < 0.0) {
            seen[count++] = a + (b - a) * (up / (up - next));
        }
    }
    float sum = 0.0;
    for (int i = 0; i < count; ++i) {
        sum += edge(seen[i], seen[(i + 1) % count], normal);
    }
    return 0.5 * abs(sum);
}
