#include <gonio/light/shape_keys.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace gonio {

namespace {

const KindText::Entry* entry_of(const KindText& text, std::string_view key) {
    const auto entry = std::find_if(text.entries.begin(), text.entries.end(),
                                    [&](const KindText::Entry& candidate) { return candidate.key == key; });
    return entry == text.entries.end() ? nullptr : &*entry;
}

// The entry as written; fails if it is missing or has no value. `example` is a valid value.
Result<std::string> needed(const KindText& text, std::string_view key, const char* what, std::string_view example) {
    if (const std::string* value = text.value(key)) return *value;
    return fail("USE0104", fmt::format("'{}' needs {}={}", text.kind, key, what),
                fmt::format("for example {}:{}={}", text.kind, key, example));
}

} // namespace

void take_spellings(KindText& text, std::string_view key, std::string_view name) {
    if (entry_of(text, key) != nullptr) return; // another spelling beside it is an unknown key
    for (KindText::Entry& entry : text.entries) {
        if (entry.key == name || (key == "h" && entry.key == "height")) {
            entry.key = key;
            return;
        }
        if (key != "r" || (entry.key != "d" && entry.key != "diameter") || !entry.value) continue;
        const Result<double> diameter = parse_amount(*entry.value, Dimension::length, "diameter");
        if (!diameter) return; // reported as an unknown key
        entry.key = key;
        entry.value = shortest(0.5 * *diameter) + "m";
        return;
    }
}

void take_diagonal(KindText& text) {
    if (text.entries.empty() || text.entries.front().value) return;
    const Result<double> diagonal = parse_amount(text.entries.front().key, Dimension::length, "diagonal");
    if (!diagonal || text.value("w") != nullptr || text.value("h") != nullptr) return;
    constexpr double across = 16.0;
    constexpr double down = 9.0;
    const double unit = *diagonal / std::hypot(across, down);
    text.entries.front() = {"w", shortest(across * unit) + "m"};
    text.entries.insert(text.entries.begin() + 1, {"h", shortest(down * unit) + "m"});
}

Result<Meters> read_length(const KindText& text, std::string_view key) {
    Result<std::string> value = needed(text, key, "LENGTH", "3cm");
    if (!value) return pass_on(value);
    Result<double> meters = parse_amount(*value, Dimension::length, fmt::format("{} of '{}'", key, text.kind));
    if (!meters) return pass_on(meters);
    if (!(*meters > 0.0))
        return fail("USE0106", fmt::format("{} of '{}' must be greater than 0, not {}", key, text.kind, *value));
    return Meters(*meters);
}

// An angle in degrees that rounds to just above the greatest angle is taken as the greatest.
Result<Radians> read_angle(const KindText& text, std::string_view key, std::string_view example,
                           const AngleRange& range) {
    Result<std::string> value = needed(text, key, "ANGLE", example);
    if (!value) return pass_on(value);
    Result<double> angle = parse_amount(*value, Dimension::angle, fmt::format("{} of '{}'", key, text.kind));
    if (!angle) return pass_on(angle);
    const double least = range.least_deg / 180.0 * std::numbers::pi;
    const double most = range.most_deg / 180.0 * std::numbers::pi;
    if (*angle > most && *angle < most * (1.0 + 1e-15)) *angle = most;
    const bool fits =
        (range.takes_least ? *angle >= least : *angle > least) && (range.takes_most ? *angle <= most : *angle < most);
    if (!fits)
        return fail("USE0106", fmt::format("{} of '{}' must be {} {}deg and {} {}deg, not {}", key, text.kind,
                                           range.takes_least ? "at least" : "greater than", range.least_deg,
                                           range.takes_most ? "at most" : "less than", range.most_deg, *value));
    return Radians(*angle);
}

Result<bool> read_flag(const KindText& text, std::string_view key) {
    const KindText::Entry* const entry = entry_of(text, key);
    if (entry == nullptr) return false;
    if (entry->value)
        return fail("USE0107", fmt::format("'{}' of '{}' takes no value", key, text.kind),
                    fmt::format("write {} alone", key));
    return true;
}

Result<Falloff> read_falloff(const KindText& text, std::string_view key) {
    const KindText::Entry* const entry = entry_of(text, key);
    if (entry == nullptr) return Falloff::frostbite;
    return parse_falloff(entry->value.value_or(""));
}

Result<void> read_mask(const KindText& text, std::string& file) {
    const KindText::Entry* const entry = entry_of(text, "mask");
    if (entry == nullptr) return {};
    if (!entry->value || entry->value->empty())
        return fail("USE0104", fmt::format("mask of '{}' needs a file", text.kind), "write mask=lamp.ies");
    file = *entry->value;
    return {};
}

Result<double> read_factor(std::string_view value) {
    const std::optional<double> factor = parse_number(value);
    if (!factor || !(*factor > 0.0))
        return fail("USE0106", fmt::format("size is a factor greater than 0, not '{}'", value));
    return *factor;
}

} // namespace gonio
