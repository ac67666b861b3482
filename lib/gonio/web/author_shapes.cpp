#include <gonio/base/kind_text.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/web/author.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180.0;

constexpr std::array kinds{
    AuthoredKind{"cosine", "cosine:power=NUMBER,up=NUMBER", "cosᵖγ down, `up` times as much upwards (1, 0)"},
    AuthoredKind{"gaussian", "gaussian:beam=ANGLE", "2^−(γ/½beam)²: half of the peak at the beam angle (30deg)"},
    AuthoredKind{"downlight", "downlight:beam=ANGLE,spill=NUMBER",
                 "cosγ [(1 − spill) 2^−(γ/½beam)² + spill cos³γ] (30deg, 0.05)"},
    AuthoredKind{
        "batwing", "batwing:reach=ANGLE,across=ANGLE,edge=NUMBER",
        "1/cos³γ, uniform illuminance inside an ellipse on the floor, then 2^−((ρ−1)/edge)² (45deg, reach, 0.25)"},
    AuthoredKind{"wall-washer", "wall-washer:lean=ANGLE,height=ANGLE,width=ANGLE,spill=NUMBER",
                 "a lobe that leans towards C0, over a spill, cut off to 90deg (35deg, 18deg, 32deg, 0.03)"},
    AuthoredKind{"street", "street:throw=ANGLE,out=ANGLE,width=ANGLE",
                 "two lobes along C0–C180, turned out to the street at C90 (60deg, 20deg, 20deg)"},
    AuthoredKind{"tube", "tube:r=LENGTH,l=LENGTH",
                 "2 r l sinθ + π r²: a bare Lambertian tube, its axis along C0 (13mm, 1.2m)"},
};

// Exact at the multiples of 90°, where a distribution must be exactly dark.
double cos_deg(double deg) {
    return std::fmod(deg, 180.0) == 90.0 ? 0.0 : std::cos(deg * radians_per_degree);
}
double sin_deg(double deg) {
    return cos_deg(90.0 - deg);
}
double tan_deg(double deg) {
    return sin_deg(deg) / cos_deg(deg);
}

// One half at x = ±1.
double half_at_one(double x) {
    return std::exp2(-x * x);
}

// 1 up to 20° below the horizon, 0 from the horizon on, smooth in between.
double cut_off(double gamma_deg) {
    const double x = std::clamp((90.0 - gamma_deg) / 20.0, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

class Values {
public:
    explicit Values(const KindText& text) : text_(text) {}

    Result<double> angle_deg(std::string_view key, double standard) const {
        const std::string* const value = text_.value(key);
        if (value == nullptr) return standard;
        Result<double> rad = parse_amount(*value, Dimension::angle, key);
        if (!rad) return pass_on(rad);
        const double deg = std::round(to_degrees(Radians(*rad)) * 1e9) / 1e9;
        if (deg > 0.0 && deg < 90.0) return deg;
        return fail("USE0106", fmt::format("{}={} is not between 0deg and 90deg", key, *value));
    }

    // The full beam angle.
    Result<double> beam_deg(std::string_view key, double standard) const {
        const std::string* const value = text_.value(key);
        if (value == nullptr) return standard;
        Result<double> rad = parse_amount(*value, Dimension::angle, key);
        if (!rad) return pass_on(rad);
        const double deg = std::round(to_degrees(Radians(*rad)) * 1e9) / 1e9;
        if (deg > 0.0 && deg <= 180.0) return deg;
        return fail("USE0106", fmt::format("{}={} is not between 0deg and 180deg", key, *value));
    }

    Result<double> length_m(std::string_view key, double standard) const {
        const std::string* const value = text_.value(key);
        if (value == nullptr) return standard;
        Result<double> meters = parse_amount(*value, Dimension::length, key);
        if (!meters) return pass_on(meters);
        if (*meters > 0.0) return *meters;
        return fail("USE0106", fmt::format("{}={} is not a length greater than 0", key, *value));
    }

    Result<double> number(std::string_view key, double standard, double low, double high) const {
        const std::string* const value = text_.value(key);
        if (value == nullptr) return standard;
        const std::optional<double> number = parse_number(*value);
        if (number && *number >= low && *number <= high) return *number;
        return fail("USE0105", fmt::format("{}={} is not a number between {} and {}", key, *value, low, high));
    }

private:
    const KindText& text_;
};

Result<AuthoredShape> cosine(const Values& values) {
    const Result<double> power = values.number("power", 1.0, 0.0, 1000.0);
    if (!power) return Unexpected(power.error());
    const Result<double> up = values.number("up", 0.0, 0.0, 1e6);
    if (!up) return Unexpected(up.error());
    return AuthoredShape{[p = *power, up = *up](double, double gamma) {
                             const double cosine = cos_deg(gamma);
                             return (cosine >= 0.0 ? 1.0 : up) * std::pow(std::abs(cosine), p);
                         },
                         Symmetry::axial, *up > 0.0 ? 180.0 : 90.0};
}

Result<AuthoredShape> gaussian(const Values& values) {
    const Result<double> beam = values.beam_deg("beam", 30.0);
    if (!beam) return Unexpected(beam.error());
    return AuthoredShape{
        [half = 0.5 * *beam](double, double gamma) { return gamma > 90.0 ? 0.0 : half_at_one(gamma / half); },
        Symmetry::axial, 90.0};
}

Result<AuthoredShape> downlight(const Values& values) {
    const Result<double> beam = values.beam_deg("beam", 30.0);
    if (!beam) return Unexpected(beam.error());
    const Result<double> spill = values.number("spill", 0.05, 0.0, 1.0);
    if (!spill) return Unexpected(spill.error());
    return AuthoredShape{[half = 0.5 * *beam, spill = *spill](double, double gamma) {
                             const double cosine = std::max(0.0, cos_deg(gamma));
                             return cosine *
                                    ((1.0 - spill) * half_at_one(gamma / half) + spill * cosine * cosine * cosine);
                         },
                         Symmetry::axial, 90.0};
}

Result<AuthoredShape> batwing(const Values& values) {
    const Result<double> reach = values.angle_deg("reach", 45.0);
    if (!reach) return Unexpected(reach.error());
    const Result<double> across = values.angle_deg("across", *reach);
    if (!across) return Unexpected(across.error());
    const Result<double> edge = values.number("edge", 0.25, 0.01, 10.0);
    if (!edge) return Unexpected(edge.error());
    const Symmetry symmetry = *reach == *across ? Symmetry::axial : Symmetry::quadrant;
    return AuthoredShape{[x = tan_deg(*reach), y = tan_deg(*across), edge = *edge](double c, double gamma) {
                             const double cosine = cos_deg(gamma);
                             if (cosine < 1e-3) return 0.0; // beyond a thousand heights; the edge ends long before that
                             const double out = sin_deg(gamma) / cosine;
                             const double rho = std::hypot(out * cos_deg(c) / x, out * sin_deg(c) / y);
                             return half_at_one(std::max(0.0, rho - 1.0) / edge) / (cosine * cosine * cosine);
                         },
                         symmetry, 90.0};
}

Result<AuthoredShape> wall_washer(const Values& values) {
    const Result<double> lean = values.angle_deg("lean", 35.0);
    if (!lean) return Unexpected(lean.error());
    const Result<double> height = values.angle_deg("height", 18.0);
    if (!height) return Unexpected(height.error());
    const Result<double> width = values.angle_deg("width", 32.0);
    if (!width) return Unexpected(width.error());
    const Result<double> spill = values.number("spill", 0.03, 0.0, 1.0);
    if (!spill) return Unexpected(spill.error());
    return AuthoredShape{[lean = *lean, height = *height, width = *width, spill = *spill](double c, double gamma) {
                             // v from the nadir towards the wall, h out of the plane C0–C180.
                             const double v =
                                 std::atan2(sin_deg(gamma) * cos_deg(c), cos_deg(gamma)) / radians_per_degree;
                             const double h = std::asin(sin_deg(gamma) * sin_deg(c)) / radians_per_degree;
                             const double beam = half_at_one(std::hypot((v - lean) / height, h / width));
                             return cut_off(gamma) * std::max(0.0, cos_deg(gamma)) * (beam + spill);
                         },
                         Symmetry::bilateral_0_180, 90.0};
}

Result<AuthoredShape> street(const Values& values) {
    const Result<double> reach = values.angle_deg("throw", 60.0);
    if (!reach) return Unexpected(reach.error());
    const Result<double> out = values.angle_deg("out", 20.0);
    if (!out) return Unexpected(out.error());
    const Result<double> width = values.angle_deg("width", 20.0);
    if (!width) return Unexpected(width.error());
    return AuthoredShape{[reach = *reach, out = *out, width = *width](double c, double gamma) {
                             // The cosine of the angle to the lobe at (azimuth, throw).
                             const auto lobe = [&](double azimuth) {
                                 const double cosine = sin_deg(gamma) * sin_deg(reach) * cos_deg(c - azimuth) +
                                                       cos_deg(gamma) * cos_deg(reach);
                                 const double away = std::acos(std::clamp(cosine, -1.0, 1.0)) / radians_per_degree;
                                 return half_at_one(away / width);
                             };
                             const double below =
                                 0.25 * std::max(0.0, cos_deg(gamma)) * (1.0 + 0.5 * sin_deg(gamma) * sin_deg(c));
                             return cut_off(gamma) * (lobe(out) + lobe(180.0 - out) + below);
                         },
                         Symmetry::bilateral_90_270, 90.0};
}

Result<AuthoredShape> tube(const Values& values) {
    const Result<double> radius = values.length_m("r", 0.013);
    if (!radius) return Unexpected(radius.error());
    const Result<double> length = values.length_m("l", 1.2);
    if (!length) return Unexpected(length.error());
    return AuthoredShape{[r = *radius, l = *length](double c, double gamma) {
                             // cosθ = sinγ cosC, θ the angle to the axis.
                             const double cosine = sin_deg(gamma) * cos_deg(c);
                             return 2.0 * r * l * std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) + pi * r * r;
                         },
                         Symmetry::quadrant, 180.0};
}

struct Parser {
    std::string_view name;
    std::array<std::string_view, 4> keys;
    Result<AuthoredShape> (*parse)(const Values&);
};

constexpr std::array parsers{
    Parser{"cosine", {"power", "up"}, cosine},
    Parser{"gaussian", {"beam"}, gaussian},
    Parser{"downlight", {"beam", "spill"}, downlight},
    Parser{"batwing", {"reach", "across", "edge"}, batwing},
    Parser{"wall-washer", {"lean", "height", "width", "spill"}, wall_washer},
    Parser{"street", {"throw", "out", "width"}, street},
    Parser{"tube", {"r", "l"}, tube},
};

} // namespace

std::span<const AuthoredKind> authored_kinds() {
    return kinds;
}

Result<AuthoredShape> parse_authored(std::string_view text) {
    Result<KindText> parsed = parse_kind_text(text);
    if (!parsed) return pass_on(parsed);
    Result<const Parser*> parser = find_named("kind of luminaire", parsed->kind, parsers);
    if (!parser) return pass_on(parser);
    std::vector<std::string_view> keys;
    for (const std::string_view key : (*parser)->keys)
        if (!key.empty()) keys.push_back(key);
    if (Result<void> known = only_keys(*parsed, keys); !known) return pass_on(known);
    return (*parser)->parse(Values(*parsed));
}

} // namespace gonio
