// Points and spots with the parameters that their functions take, recorded: illuminance per candela.
#pragma once

#include <gonio/shader/exact_irradiance.hpp>
#include <gonio/shader/parameters.hpp>
// After the recording scalar.
#include <gonio/shading/falloff.hpp>

namespace gonio::shader {

struct Punctual {
    Vector to_light, normal;
    explicit Punctual(Function& f)
        : to_light(f.vector("to_light", "[m] from the receiver to the light")), normal(normal_of(f)) {}

    S illuminance(Function& f) const {
        const core::Direction<S> d = core::direction(to_light, normal);
        name_direction(f, d);
        const S inverse = d.scale * d.inverse_distance;
        return simd::max(d.n_dot_l, S(0)) * inverse * inverse;
    }
};

struct Spot : Punctual {
    Vector aim;
    S inner, outer;
    explicit Spot(Function& f)
        : Punctual(f),
          aim(f.unit("aim", "unit, from the light along its beam")),
          inner(f.size("inner", "[rad] half angle of full intensity, in [0, outer]")),
          outer(f.size("outer", "[rad] half angle of the beam's edge, in [0, pi]")) {}

    S theta(Function& f) const {
        const S angle = core::angle_from_aim(aim, to_light * S(-1));
        f.label("theta", angle);
        return angle;
    }
};

} // namespace gonio::shader
