#include <gonio/light/light_change.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gonio {

namespace {

// Amounts are computed from what was asked for, which leaves a few roundings between factors that are the same.
constexpr double same = 1e-12;

bool are_same(double a, double b) {
    return std::abs(a - b) <= same * std::max(std::abs(a), std::abs(b));
}

// The amount of a light that its shape has: one of them.
double amount(const Light& light) {
    if (light.luminance.value != 0.0) return light.luminance.value;
    return light.intensity.value;
}

std::optional<LightChange> change_of(const Light& before, const Light& now) {
    LightChange change;
    if (!(amount(before) > 0.0)) return std::nullopt;
    change.amount = amount(now) / amount(before);
    for (int channel = 0; channel < 3; ++channel) {
        if (before.color[channel] == 0.0 && now.color[channel] == 0.0)
            change.rgb[channel] = change.amount;
        else if (before.color[channel] == 0.0)
            return std::nullopt;
        else
            change.rgb[channel] = change.amount * (now.color[channel] / before.color[channel]);
        if (!std::isfinite(change.rgb[channel])) return std::nullopt;
    }
    return change;
}

bool are_same(const std::vector<ShapeValue>& a, const std::vector<ShapeValue>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const ShapeValue& x, const ShapeValue& y) { return x.key == y.key && x.value == y.value; });
}

bool are_same(const Shape& a, const Shape& b) {
    if (a.index() != b.index() || pattern_of(a) != pattern_of(b)) return false;
    if (const auto* profile = std::get_if<ProfileShape>(&a))
        if (profile->opening() != std::get<ProfileShape>(b).opening()) return false;
    return are_same(values_of(a), values_of(b));
}

bool are_same(const Frame& a, const Frame& b) {
    return a.origin == b.origin && a.x == b.x && a.y == b.y && a.z == b.z;
}

bool are_same(const std::optional<EmittingFace>& a, const std::optional<EmittingFace>& b) {
    if (a.has_value() != b.has_value()) return false;
    return !a || (a->surface == b->surface && a->face == b->face);
}

// The body of a profile's opening and its faces follow from the profile and the frame.
bool has_same_parts(const Light& a, const Light& b) {
    if (std::holds_alternative<ProfileShape>(a.shape))
        return (a.body == nullptr) == (b.body == nullptr) && (a.parts == nullptr) == (b.parts == nullptr);
    return a.parts == b.parts && a.body == b.body;
}

bool differs_in_amount_alone(const Light& a, const Light& b) {
    // A profile's scale goes with its amount, that of a mask with its web.
    const bool has_profile = std::holds_alternative<ProfileShape>(a.shape);
    return are_same(a.shape, b.shape) && are_same(a.frame, b.frame) && a.range == b.range &&
           are_same(a.emitted_by, b.emitted_by) && has_same_parts(a, b) && a.emission == b.emission &&
           a.image == b.image &&
           (has_profile ? are_same(a.web_scale * amount(b), b.web_scale * amount(a)) : a.web_scale == b.web_scale);
}

} // namespace

bool LightChange::is_of_color() const {
    return !are_same(rgb.x, amount) || !are_same(rgb.y, amount) || !are_same(rgb.z, amount);
}

std::optional<LightChange> common_change(std::span<const Light> before, std::span<const Light> now) {
    if (before.size() != now.size()) return std::nullopt;
    std::optional<LightChange> all;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const std::optional<LightChange> one = change_of(before[i], now[i]);
        if (!one) return std::nullopt;
        if (!all) all = one;
        if (!are_same(one->amount, all->amount)) return std::nullopt;
        for (int channel = 0; channel < 3; ++channel)
            if (!are_same(one->rgb[channel], all->rgb[channel])) return std::nullopt;
    }
    return all;
}

bool differ_in_amount_alone(std::span<const Light> a, std::span<const Light> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), differs_in_amount_alone);
}

} // namespace gonio
