#include <gonio/shading/specular_in_double.hpp>
#include <gonio/shading/specular_named.hpp>
#include <gonio/shading/with_specular_method.hpp>

namespace gonio::shading {

template<class Light>
SpecularLuminance<double> specular_in_double(SpecularMethod method, const Light& light, vec3<double> to_center,
                                             vec3<double> normal, vec3<double> view, double alpha) {
    return with_specular_method(
        method, [&]<SpecularMethod named>() { return specular_by<named>(light, to_center, normal, view, alpha); });
}

using Vec = vec3<double>;
template SpecularLuminance<double> specular_in_double(SpecularMethod, const SphereLight<double>&, Vec, Vec, Vec,
                                                      double);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const DiskLight<double>&, Vec, Vec, Vec, double);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const RectangleLight<double>&, Vec, Vec, Vec,
                                                      double);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const TubeLight<double>&, Vec, Vec, Vec, double);

} // namespace gonio::shading
