#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/scene/detail/read_material_key.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace gonio::detail {

namespace {

Unexpected outside(const KindText& text, std::string_view key, std::string_view value) {
    return fail("USE0106", fmt::format("{} of '{}' must lie in [0, 1], not {}", key, text.kind, value));
}

} // namespace

Result<void> read_share(const KindText& text, std::string_view key, double& target) {
    const std::string* value = text.value(key);
    if (value == nullptr) return {};
    const std::optional<double> number = parse_number(*value);
    if (!number) return fail("USE0105", fmt::format("{} of '{}' is not a number: '{}'", key, text.kind, *value));
    if (*number < 0.0 || *number > 1.0) return outside(text, key, *value);
    target = *number;
    return {};
}

Result<void> read_degrees(const KindText& text, std::string_view key, double& target) {
    const std::string* value = text.value(key);
    if (value == nullptr) return {};
    std::optional<double> degrees = parse_number(*value);
    if (!degrees) {
        const Result<Amount> angle = parse_amount(*value);
        if (!angle || angle->unit->dimension != Dimension::angle)
            return fail("USE0105", fmt::format("{} of '{}' is not an angle: '{}'", key, text.kind, *value),
                        "write degrees, such as 30 or 30deg");
        degrees = angle->unit == find_unit("deg") ? angle->number : angle->in_base_units() * (180.0 / std::numbers::pi);
    }
    if (std::fabs(*degrees) > 360.0)
        return fail("USE0106",
                    fmt::format("{} of '{}' must lie in [-360, 360] degrees, not {}", key, text.kind, *value));
    target = *degrees;
    return {};
}

Result<void> read_color(const KindText& text, std::string_view key, glm::dvec3& target) {
    const std::string* value = text.value(key);
    if (value == nullptr) return {};
    const Result<glm::dvec3> rgb = parse_rgb(*value);
    if (!rgb)
        return fail("USE0105", fmt::format("{} of '{}' is not a colour: '{}'", key, text.kind, *value),
                    "write a number in [0, 1] or rgb(r,g,b)");
    for (int channel = 0; channel < 3; ++channel)
        if ((*rgb)[channel] > 1.0) return outside(text, key, *value);
    target = *rgb;
    return {};
}

Result<void> read_alpha(const KindText& text, std::string_view key, double& target) {
    if (text.value(key) != nullptr && text.value("roughness") != nullptr)
        return fail("USE0107", fmt::format("'{}' is given both {} and roughness", text.kind, key),
                    fmt::format("{} is the square of roughness", key));
    if (text.value("roughness") == nullptr) return read_share(text, key, target);
    double roughness = 0.0;
    Result<void> read = read_share(text, "roughness", roughness);
    if (read) target = roughness * roughness;
    return read;
}

Result<void> read_coat(const KindText& text, std::optional<Coat>& coat) {
    const auto [amount, smoothness, order] = coat_keys;
    for (const std::string_view key : {smoothness, order})
        if (text.value(key) != nullptr && text.value(amount) == nullptr && !coat)
            return fail("USE0104", fmt::format("{} of '{}' needs a coat", key, text.kind), "add coat=1");
    if (text.value(amount) == nullptr && text.value(smoothness) == nullptr && text.value(order) == nullptr) return {};
    Coat made = coat.value_or(Coat());
    Result<void> read = read_share(text, amount, made.amount);
    if (read) read = read_share(text, smoothness, made.smoothness);
    if (!read) return read;
    if (const std::string* name = text.value(order)) {
        std::vector<std::string_view> names;
        bool known = false;
        for (const CoatOrderName& of : coat_orders()) {
            names.push_back(of.name);
            if (of.name == *name) {
                made.order = of.order;
                known = true;
            }
        }
        if (!known) return unknown_name(order, *name, names, text.kind);
    }
    coat = made;
    return {};
}

} // namespace gonio::detail
