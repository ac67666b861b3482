#include <gonio/base/unit_text.hpp>
#include <gonio/light/shape_keys.hpp>
#include <gonio/light/shapes/spot.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

using Traits = ShapeTraits<SpotShape>;

constexpr AngleRange full_angles{0.0, 180.0, true, true};

// "outer", or "cone", which is twice the outer angle.
Result<Radians> read_outer(const KindText& text) {
    if (text.value("cone") == nullptr) return read_angle(text, "outer", "40deg", Traits::half_angles);
    return read_angle(text, "cone", "80deg", full_angles).map([](Radians cone) { return cone / 2.0; });
}

KindText one_key(std::string_view key, const std::string& value) {
    return {std::string(Traits::kind), {{std::string(key), value}}};
}

Result<bool> set_angles(SpotShape& spot, const Result<Radians>& inner, const Result<Radians>& outer) {
    if (!inner) return Unexpected(inner.error());
    if (!outer) return Unexpected(outer.error());
    if (inner->value > outer->value)
        return fail("USE0106",
                    fmt::format("inner of 'spot', {}deg, is more than outer, {}deg", rounded(to_degrees(*inner)),
                                rounded(to_degrees(*outer))),
                    "both are half angles from the axis");
    spot.inner = *inner;
    spot.outer = *outer;
    return true;
}

// The half angle at which a lobe has half of its peak.
Radians half_beam(const SpotShape& spot) {
    double inside = 0.0;
    double outside = spot.outer.value;
    for (int step = 0; step < 64; ++step) {
        const double middle = 0.5 * (inside + outside);
        (lobe(spot, Radians(middle)) >= 0.5 ? inside : outside) = middle;
    }
    return Radians(outside);
}

SpotShape with_outer(SpotShape spot, double outer, double inner_share) {
    spot.outer = Radians(outer);
    spot.inner = Radians(std::fmin(inner_share, 1.0) * outer);
    return spot;
}

// The beam angle grows with the outer angle, so a bisection finds it.
Result<bool> set_beam(SpotShape& spot, const std::string& value) {
    Result<double> beam = parse_amount(value, Dimension::angle, "beam");
    if (!beam) return pass_on(beam);
    const double widest = 0.5 * std::numbers::pi;
    const double inner_share = spot.outer.value > 0.0 ? spot.inner / spot.outer : 0.0;
    const double most = 2.0 * half_beam(with_outer(spot, widest, inner_share)).value;
    if (!(*beam > 0.0) || *beam > most)
        return fail("USE0106",
                    fmt::format("beam of this 'spot' must be greater than 0deg and at most {}deg, not {}",
                                rounded(to_degrees(Radians(most))), value),
                    "it is the full angle at half of the peak");
    double low = 0.0;
    double high = widest;
    for (int step = 0; step < 64; ++step) {
        const double middle = 0.5 * (low + high);
        (2.0 * half_beam(with_outer(spot, middle, inner_share)).value < *beam ? low : high) = middle;
    }
    spot = with_outer(spot, high, inner_share);
    return true;
}

} // namespace

Result<SpotShape> ShapeTraits<SpotShape>::parse(const KindText& text) {
    constexpr std::array<std::string_view, 5> known{"outer", "cone", "inner", "falloff", "mask"};
    if (Result<void> only = only_keys(text, known); !only) return pass_on(only);
    if (text.value("cone") != nullptr && text.value("outer") != nullptr)
        return fail("USE0107", "'spot' takes outer or cone, not both", "outer is the half angle, cone the full one");
    SpotShape made;
    Result<Radians> outer = read_outer(text);
    if (!outer) return pass_on(outer);
    made.outer = *outer;
    if (const std::string* inner_text = text.value("inner")) {
        Result<double> inner = parse_amount(*inner_text, Dimension::angle, "inner of 'spot'");
        if (!inner) return pass_on(inner);
        made.inner = Radians(*inner);
        if (!(*inner >= 0.0))
            return fail("USE0106", fmt::format("inner of 'spot' must be at least 0deg, not {}", *inner_text));
        if (*inner > made.outer.value)
            return fail("USE0106",
                        fmt::format("inner of 'spot' must be at most its outer half angle of {}deg, not {}",
                                    rounded(to_degrees(made.outer)), *inner_text),
                        "inner is a half angle too");
    } else if (Result<bool> bare = read_flag(text, "inner"); bare && *bare) {
        return fail("USE0104", "'spot' needs a value for inner", "for example inner=25deg");
    }
    Result<void> read = read_key(text, std::get<2>(keys), made);
    if (read) read = read_mask(text, made.mask_file);
    if (!read) return pass_on(read);
    return made;
}

Result<bool> ShapeTraits<SpotShape>::set_parameter(SpotShape& spot, std::string_view name, const std::string& value) {
    const KindText text = one_key(name, value);
    if (name == "beam") return set_beam(spot, value);
    if (name == "falloff") {
        Result<void> read = read_key(text, std::get<2>(keys), spot);
        if (!read) return pass_on(read);
        return true;
    }
    if (name == "inner") { // bounded by the spot's own outer angle
        KindText widest = one_key("outer", "90deg");
        widest.entries.push_back({"inner", value});
        return set_angles(spot, parse(widest).map([](const SpotShape& read) { return read.inner; }), spot.outer);
    }
    if (name == "outer" || name == "cone") return set_angles(spot, spot.inner, read_outer(text));
    return false;
}

} // namespace gonio
