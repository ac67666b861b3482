// From a method that is named at run time to code that is compiled for each.
#pragma once

#include <gonio/shading/specular_method.hpp>

namespace gonio::shading {

// work.template operator()<method>(), whose result is returned; a value-initialised one for a value that is no method.
// With GONIO_STANDARD_METHODS, where nobody can choose a method, there is none but the standard one.
template<class Work>
auto with_specular_method(SpecularMethod method, const Work& work)
    -> decltype(work.template operator()<SpecularMethod::ltc>()) {
    switch (method) {
    case SpecularMethod::ltc:
        return work.template operator()<SpecularMethod::ltc>();
#ifdef GONIO_STANDARD_METHODS
    default:
        break;
#else
    case SpecularMethod::representative_point:
        return work.template operator()<SpecularMethod::representative_point>();
    case SpecularMethod::dominant_direction:
        return work.template operator()<SpecularMethod::dominant_direction>();
    case SpecularMethod::specular_d:
        return work.template operator()<SpecularMethod::specular_d>();
    case SpecularMethod::spherical_hack:
        return work.template operator()<SpecularMethod::spherical_hack>();
    case SpecularMethod::sun_disk:
        return work.template operator()<SpecularMethod::sun_disk>();
#endif
    }
    return {};
}

} // namespace gonio::shading
