#include <gonio/shading/specular_in_double.hpp>
#include <gonio/shading/specular_named.hpp>

namespace gonio::shading {

template<class Light>
SpecularLuminance<double> specular_in_double(SpecularMethod method, const Light& light, vec3<double> to_center,
                                             vec3<double> normal, vec3<double> view, double alpha) {
    const auto by = [&]<SpecularMethod named>() { return specular_by<named>(light, to_center, normal, view, alpha); };
    switch (method) {
    case SpecularMethod::ltc:
        return by.template operator()<SpecularMethod::ltc>();
    case SpecularMethod::representative_point:
        return by.template operator()<SpecularMethod::representative_point>();
    case SpecularMethod::dominant_direction:
        return by.template operator()<SpecularMethod::dominant_direction>();
    case SpecularMethod::specular_d:
        return by.template operator()<SpecularMethod::specular_d>();
    case SpecularMethod::spherical_hack:
        return by.template operator()<SpecularMethod::spherical_hack>();
    case SpecularMethod::sun_disk:
        return by.template operator()<SpecularMethod::sun_disk>();
    }
    return {};
}

using Vec = vec3<double>;
template SpecularLuminance<double> specular_in_double(SpecularMethod, const SphereLight<double>&, Vec, Vec, Vec,
                                                      double);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const DiskLight<double>&, Vec, Vec, Vec, double);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const RectangleLight<double>&, Vec, Vec, Vec,
                                                      double);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const TubeLight<double>&, Vec, Vec, Vec, double);

} // namespace gonio::shading
