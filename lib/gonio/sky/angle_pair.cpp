#include <gonio/base/quantity.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/sky/detail/angle_pair.hpp>

#include <fmt/format.h>

#include <optional>

namespace gonio::detail {

namespace {

std::optional<double> angle_deg(std::string_view text) {
    if (const std::optional<double> number = parse_number(text)) return number;
    const Result<Amount> amount = parse_amount(text);
    if (!amount || amount->unit->dimension != Dimension::angle) return std::nullopt;
    if (amount->unit->symbol == "deg") return amount->number;
    return to_degrees(Radians(amount->in_base_units()));
}

} // namespace

Result<AnglePair> parse_angle_pair(std::string_view text, std::string_view what, std::string_view form,
                                   std::string_view example) {
    const std::size_t slash = text.find('/');
    if (slash != std::string_view::npos) {
        const std::optional<double> first = angle_deg(text.substr(0, slash));
        const std::optional<double> second = angle_deg(text.substr(slash + 1));
        if (first && second) return AnglePair{*first, *second};
    }
    return fail("USE0105", fmt::format("{} is {} in degrees, not '{}'", what, form, text),
                fmt::format("for example {}", example));
}

} // namespace gonio::detail
