// As engines have it: 1 - (n.h)^2 by its cosine.
vec3 ggx_brdf(vec3 n, vec3 l, vec3 v, vec3 f0, float alpha) {
    vec3 h = normalize(l + v);
    float n_dot_l = dot(n, l);
    float n_dot_v = dot(n, v);
    if (n_dot_l <= 0.0 || n_dot_v <= 0.0) {
        return vec3(0.0);
    }
    float n_dot_h = clamp(dot(n, h), 0.0, 1.0);
    float l_dot_h = clamp(dot(l, h), 0.0, 1.0);
    float a2 = alpha * alpha;
    float t = (n_dot_h * a2 - n_dot_h) * n_dot_h + 1.0;
    float d = a2 / (3.14159265 * t * t);
    float lit = n_dot_v * sqrt((n_dot_l - a2 * n_dot_l) * n_dot_l + a2);
    float seen = n_dot_l * sqrt((n_dot_v - a2 * n_dot_v) * n_dot_v + a2);
    return d * 0.5 / (lit + seen) * (f0 + (1.0 - f0) * pow(1.0 - l_dot_h, 5.0));
}
