// Photometric units of random shapes, converted forth and back, and as other programs define them; the flux of lobes
// against quadrature; and the illuminance of random lights at random points.
#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/light/policy.hpp>
#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/scene/probe.hpp>

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <string>

namespace gonio::measure::detail {

namespace {

double log_uniform(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

// From a micrometre to a thousand kilometres.
Shape random_shape(Random& random) {
    const auto size = [&] { return Meters(log_uniform(random, 1e-6, 1e6)); };
    switch (random.bits() % 9) {
    case 0:
        return PointShape{};
    case 1: {
        const double outer = log_uniform(random, 1e-6, std::numbers::pi / 2.0);
        const double inner = random.bits() % 4 == 0 ? outer : outer * random.uniform();
        return SpotShape{Radians(outer), Radians(inner), static_cast<Falloff>(random.bits() % 6), {}, {}};
    }
    case 2:
        return FrustumShape{Radians(log_uniform(random, 1e-6, 3.1)), Radians(log_uniform(random, 1e-6, 3.1)), {}, {}};
    case 3:
        return SphereShape{size()};
    case 4:
        return DiskShape{size(), random.bits() % 2 == 0};
    case 5:
        return RectShape{size(), size(), random.bits() % 2 == 0};
    case 6:
        if (random.bits() % 2 == 0) return CylinderShape{size(), size()};
        return TubeShape{size(), size()};
    case 7:
        return EllipseShape{size(), size(), random.bits() % 2 == 0};
    default:
        return SunShape{Radians(log_uniform(random, 1e-6, std::numbers::pi))};
    }
}

// A value converted to another unit and back: within 1e-12, or an error.
void units(Random& random, std::uint64_t evaluations, StressTally& tally) {
    static const std::array<PhotometricUnit, 6> known = [] {
        std::array<PhotometricUnit, 6> made;
        constexpr std::array names{"lm", "cd", "nt", "lx@2m", "lx", "W@90lm/W"};
        for (std::size_t i = 0; i < made.size(); ++i)
            made[i] = parse_photometric_unit(names[i]).value();
        return made;
    }();
    for (std::uint64_t done = 0; done < evaluations; ++done) {
        const Shape shape = random_shape(random);
        PhotometricUnit from = known[random.bits() % known.size()];
        PhotometricUnit to = known[random.bits() % known.size()];
        if (from.distance) from.distance = Meters(log_uniform(random, 1e-3, 1e6));
        const double number =
            random.bits() % 8 == 0 ? std::fabs(hostile::number(random)) : log_uniform(random, 1e-9, 1e9);
        const Result<Emission> emission = emission_of(shape, {number, from});
        tally.looked_at(1);
        if (!emission) continue; // an error with a reason
        const Result<double> other = express(shape, *emission, to);
        if (!other || *other == 0.0) continue;
        const auto input = [&] {
            return fmt::format("{:a} {} to {} of shape {}: {}", number, from.unit->symbol, to.unit->symbol,
                               shape.index(), *other);
        };
        tally.require(is_amount(*other), input);
        const Result<Emission> again = emission_of(shape, {*other, to});
        if (!again) continue;
        const Result<double> back = express(shape, *again, from);
        if (!back) continue;
        // Below the normal range of doubles there is no requirement.
        if (number > 1e-290 && *other > 1e-290) tally.hold(std::fabs(*back - number) / (1e-12 * number), input);
    }
}

// Φ/I of a spot and of a frustum: the closed forms against quadrature of the lobe itself.
void lobes(Random& random, std::uint64_t evaluations, StressTally& tally) {
    static constexpr auto rule = gauss_legendre<20>();
    const auto integral = [](double from, double to, const auto& f) {
        double sum = 0.0;
        constexpr int pieces = 2;
        for (int piece = 0; piece < pieces; ++piece) {
            const double half = 0.5 * (to - from) / pieces;
            const double middle = from + (2 * piece + 1) * half;
            for (const QuadratureNode& node : rule)
                sum += half * node.weight * f(middle + half * node.at);
        }
        return sum;
    };
    for (std::uint64_t done = 0; done < evaluations; done += 2) {
        const double outer = log_uniform(random, 1e-6, std::numbers::pi / 2.0);
        const double inner = outer * (random.bits() % 4 == 0 ? 1.0 - log_uniform(random, 1e-6, 1.0) : random.uniform());
        const SpotShape spot{Radians(outer), Radians(inner), static_cast<Falloff>(random.bits() % 6), {}, {}};
        const double edge = spot.falloff == Falloff::hard ? outer : inner; // where it begins to fall
        const double core = 4.0 * std::numbers::pi * std::sin(0.5 * edge) * std::sin(0.5 * edge);
        const double ramp =
            edge < outer
                ? 2.0 * std::numbers::pi *
                      integral(edge, outer, [&](double theta) { return lobe(spot, Radians(theta)) * std::sin(theta); })
                : 0.0;
        const double found = lobe_solid_angle(spot).value;
        tally.hold(std::fabs(found - core - ramp) / (1e-11 * (core + ramp)), [&] {
            return fmt::format("spot falloff {} inner {:a} outer {:a}: {} for {}", static_cast<int>(spot.falloff),
                               inner, outer, found, core + ramp);
        });
        // The pyramid between the longitudes ±a: the tangent of its latitude limit is tan b times the cosine of the
        // longitude.
        const double a = log_uniform(random, 1e-6, 1.2);
        const double b = log_uniform(random, 1e-6, 1.2);
        const double pyramid = 2.0 * integral(-a, a, [&](double longitude) {
                                   return std::sin(std::atan(std::tan(b) * std::cos(longitude)));
                               });
        const double stated = lobe_solid_angle(FrustumShape{Radians(2.0 * a), Radians(2.0 * b), {}, {}}).value;
        tally.hold(std::fabs(stated - pyramid) / (1e-11 * pyramid),
                   [&] { return fmt::format("frustum half angles {:a} {:a}: {} for {}", a, b, stated, pyramid); });
    }
}

// The physical value of a program's number, and the program's number for that value.
void programs(Random& random, std::uint64_t evaluations, StressTally& tally) {
    static const std::array<PhotometricUnit, 4> known{
        parse_photometric_unit("lm").value(), parse_photometric_unit("cd").value(),
        parse_photometric_unit("nt").value(), parse_photometric_unit("W@90lm/W").value()};
    for (std::uint64_t done = 0; done < evaluations; ++done) {
        const Shape shape = random_shape(random);
        const Policy& policy = policies()[random.bits() % policies().size()];
        const PhotometricUnit& unit = known[random.bits() % known.size()];
        const double number = log_uniform(random, 1e-9, 1e9);
        const Result<PolicyMeaning> meaning = policy_meaning(policy, shape, unit.unit->dimension);
        if (!meaning) { // the program has no such light
            tally.looked_at(1);
            continue;
        }
        const PhotometricValue emitted = physical_value(*meaning, {number, unit});
        const double back = policy_number(*meaning, unit, emitted.number);
        tally.hold(std::fabs(back - number) / (1e-12 * number), [&] {
            return fmt::format("{}: {:a} {} of shape {}: {} and back {}", policy.name, number, unit.unit->symbol,
                               shape.index(), emitted.number, back);
        });
    }
}

// Probe: any lights and points give numbers, or an error.
void probes(Random& random, std::uint64_t evaluations, StressTally& tally) {
    const auto place = [&] {
        return glm::dvec3(hostile::number(random), hostile::number(random), hostile::number(random));
    };
    constexpr std::size_t points = 16;
    for (std::uint64_t done = 0; done < evaluations; done += points) {
        LightDescription description;
        description.shape = random_shape(random);
        const bool sun = std::holds_alternative<SunShape>(description.shape);
        description.intensity = {log_uniform(random, 1e-6, 1e9), parse_photometric_unit(sun ? "lx" : "cd").value()};
        description.position = place();
        const hostile::Vec d = hostile::random_direction(random);
        description.direction = {d.x, d.y, d.z};
        Diagnostics ignored;
        const Result<Light> light = resolve_light(description, ignored);
        tally.looked_at(points);
        if (!light) continue;
        std::vector<Receiver> receivers;
        for (std::size_t i = 0; i < points; ++i) {
            const hostile::Vec n = hostile::random_direction(random);
            receivers.push_back({i % 4 == 0 ? description.position : place(), {n.x, n.y, n.z}});
        }
        ProbeOptions options;
        constexpr std::array methods{IrradianceMethod::exact, IrradianceMethod::frostbite, IrradianceMethod::ue4,
                                     IrradianceMethod::point};
        options.method = methods[random.bits() % methods.size()];
        options.threads = 1;
        const Result<ProbeResult> result = probe({&*light, 1}, receivers, options);
        if (!result) continue;
        for (std::size_t i = 0; i < points; ++i)
            tally.require(is_amount(result->illuminance_lx[i]), [&] {
                const glm::dvec3& at = receivers[i].position;
                const glm::dvec3& n = receivers[i].normal;
                const glm::dvec3& p = description.position;
                return fmt::format("{}: {} lx of shape {} at {:a} {:a} {:a} along {:a} {:a} {:a}, point {:a} {:a} {:a} "
                                   "normal {:a} {:a} {:a}",
                                   to_text(options.method), result->illuminance_lx[i], description.shape.index(), p.x,
                                   p.y, p.z, d.x, d.y, d.z, at.x, at.y, at.z, n.x, n.y, n.z);
            });
    }
}

} // namespace

std::span<const StressSubject> light_stress() {
    static constexpr std::array subjects{
        StressSubject{"photometric units there and back", "1e-12 of the value, or a refusal", 0.05, units},
        StressSubject{"flux of spots and frusta", "1e-11 of quadrature of the lobe", 0.02, lobes},
        StressSubject{"units of other programs and back", "1e-12 of the value, or a refusal", 0.02, programs},
        StressSubject{"probe of any lights", "finite and not negative, or a refusal", 0.05, probes},
    };
    return subjects;
}

} // namespace gonio::measure::detail
