#include <gonio/measure/brdf_cases.hpp>

#include <cmath>
#include <numbers>

namespace gonio::measure {

namespace {

using shading::vec3;

vec3<double> about(const vec3<double>& n, double cosine, double phi) {
    const shading::TangentFrame<double> frame(n);
    const double sine = std::sqrt(std::fmax((1.0 - cosine) * (1.0 + cosine), 0.0));
    return frame.to_world({sine * std::cos(phi), sine * std::sin(phi), cosine});
}

double turn(Random& random) {
    return random.uniform(0.0, 2.0 * std::numbers::pi);
}

vec3<double> even(Random& random) {
    const double z = random.uniform(-1.0, 1.0);
    return about({0.0, 0.0, 1.0}, z, turn(random));
}

double shallow(Random& random) {
    const double magnitude = std::exp(random.uniform(std::log(1e-40), 0.0));
    return random.uniform() < 0.1 ? -magnitude : magnitude;
}

vec3<float> as_float(const vec3<double>& a) {
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

} // namespace

BrdfPose ordinary_brdf_pose(Random& random) {
    const vec3<double> n = even(random);
    const vec3<double> l = about(n, random.uniform(0.02, 1.0), turn(random));
    const vec3<double> v = about(n, random.uniform(0.02, 1.0), turn(random));
    return {as_float(n), as_float(l), as_float(v), as_float({random.uniform(), random.uniform(), random.uniform()})};
}

BrdfPose hostile_brdf_pose(Random& random) {
    const vec3<double> n =
        random.uniform() < 0.3 ? vec3<double>{0.0, 0.0, random.uniform() < 0.5 ? 1.0 : -1.0} : even(random);
    const vec3<double> v = about(n, random.uniform() < 0.5 ? shallow(random) : random.uniform(), turn(random));
    const vec3<double> mirrored = n * (2.0 * dot(n, v)) - v;
    vec3<double> l{0.0, 0.0, 0.0};
    switch (random.bits() % 6) {
    case 0:
        l = even(random);
        break;
    case 1:
        l = about(n, shallow(random), turn(random));
        break;
    case 2:
        l = about(mirrored, 1.0 - std::exp(random.uniform(std::log(1e-16), std::log(0.5))), turn(random));
        break;
    case 3:
        l = about(v, 1.0 - std::exp(random.uniform(std::log(1e-16), std::log(0.5))), turn(random));
        break;
    case 4:
        l = random.uniform() < 0.5 ? v : mirrored;
        break;
    default:
        l = v * -1.0;
        break;
    }
    const auto uniform = [&] {
        return random.uniform() < 0.05 ? (random.uniform() < 0.5 ? 0.0 : 1.0 - 6e-8) : random.uniform();
    };
    const double u[3] = {uniform(), uniform(), uniform()};
    return {as_float(n), as_float(l), as_float(v), as_float({u[0], u[1], u[2]})};
}

BrdfParameters::BrdfParameters(Random& random, bool hostile) {
    static constexpr double corners[] = {0.0, 1e-4, 1.0, 1.0};
    for (double& value : p)
        value = hostile && random.uniform() < 0.5 ? corners[random.bits() % 4] : random.uniform();
}

Material scene_material(std::size_t kind, const BrdfParameters& parameters) {
    constexpr std::size_t bases = std::variant_size_v<BaseMaterial>;
    if (kind >= bases) {
        const auto& p = parameters.p;
        const auto one_of = [](double number, std::size_t count) {
            return std::min(static_cast<std::size_t>(number * static_cast<double>(count)), count - 1);
        };
        const std::size_t order = one_of(p[5], coat_orders().size());
        return CoatedMaterial{base_of(scene_material(one_of(p[4], bases), parameters)),
                              {p[7], p[6], coat_orders()[order].order}};
    }
    Material made;
    std::size_t place = 0;
    for_each_material([&]<class M>() {
        if (place++ != kind) return;
        M material;
        std::size_t next = 0;
        for_each_key<M>([&](const auto& key) {
            const auto number = [&] { return parameters.p[next++]; };
            if constexpr (detail::is_color<std::decay_t<decltype(key)>>)
                material.*key.member = glm::dvec3{number(), number(), number()};
            else
                material.*key.member = number() * (key.form == KeyForm::degrees ? 360.0 : 1.0);
        });
        made = material;
    });
    return made;
}

} // namespace gonio::measure
