#include "sweep_axis.hpp"

#include <gonio/base/charconv.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/scene/parameter.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace gonio::cli {

namespace {

constexpr int kept_digits = 12;
constexpr int shown_digits = 4;

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> short_names{
    {{"r", "radius"}, {"w", "width"}, {"l", "length"}, {"metal", "metallic"}, {"colour", "color"}, {"z", "height"}}};

// A number and the text after it.
struct Quantity {
    double number = 0.0;
    std::string_view unit;
};

std::optional<Quantity> quantity_of(std::string_view text) {
    Quantity quantity;
    const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
    const auto [end, error] = gonio::from_chars(digits.data(), digits.data() + digits.size(), quantity.number);
    if (error != std::errc() || !std::isfinite(quantity.number)) return std::nullopt;
    quantity.unit = digits.substr(static_cast<std::size_t>(end - digits.data()));
    return quantity;
}

class AxisReader {
public:
    explicit AxisReader(std::string_view text) : text_(text) { axis_.text = std::string(text); }

    Result<SweepAxis> read() {
        const std::size_t equals = text_.find('=');
        if (equals == std::string_view::npos || equals == 0)
            return wrong(0, fmt::format("'{}' does not list values", text_),
                         "write KEY=FROM:TO:COUNT or KEY=A,B,C, for example cct=2000K:8000K:7");
        if (Result<void> key = read_key(text_.substr(0, equals)); !key) return pass_on(key);
        const std::size_t begin = equals + 1;
        if (begin == text_.size())
            return wrong(begin, fmt::format("no value follows '{}'", text_), "write FROM:TO:COUNT or A,B,C");
        const bool ranged = text_.find(',', begin) == std::string_view::npos && colons(begin) >= 2;
        Result<void> values = ranged ? read_range(begin) : read_list(begin);
        if (!values) return pass_on(values);
        return std::move(axis_);
    }

private:
    Unexpected wrong(std::size_t at, std::string_view message, std::string hint = {}) const {
        return fail("USE0105", fmt::format("--sweep '{}', column {}: {}", text_, at + 1, message), std::move(hint));
    }

    std::size_t colons(std::size_t from) const {
        return static_cast<std::size_t>(
            std::count(text_.begin() + static_cast<std::ptrdiff_t>(from), text_.end(), ':'));
    }

    Result<void> read_key(std::string_view name) {
        const std::size_t dot = name.rfind('.');
        if (dot != std::string_view::npos) {
            axis_.target = std::string(name.substr(0, dot));
            name.remove_prefix(dot + 1);
        }
        for (const auto& [alias, full] : short_names)
            if (name == alias) name = full;
        std::vector<std::string_view> known;
        for (const ParameterName& parameter : light_parameters())
            known.push_back(parameter.name);
        for (const ParameterName& parameter : material_parameters())
            known.push_back(parameter.name);
        for (const ViewParameter& parameter : view_parameters)
            known.push_back(parameter.name);
        if (std::find(known.begin(), known.end(), name) == known.end())
            return unknown_name("parameter", name, known, fmt::format("--sweep {}", text_));
        axis_.key = std::string(name);
        return {};
    }

    // Commas inside parentheses do not separate: rgb(1,0.8,0.6).
    Result<void> read_list(std::size_t begin) {
        int depth = 0;
        std::size_t from = begin;
        for (std::size_t i = begin; i <= text_.size(); ++i) {
            const char c = i < text_.size() ? text_[i] : ',';
            if (c == '(') ++depth;
            if (c == ')') --depth;
            if (c != ',' || (depth > 0 && i < text_.size())) continue;
            if (i == from) return wrong(from, "a value is empty", "write KEY=A,B,C");
            axis_.values.emplace_back(text_.substr(from, i - from));
            from = i + 1;
        }
        if (axis_.values.size() < 2)
            return wrong(begin, fmt::format("'{}' is only one value", axis_.values.front()),
                         "write FROM:TO:COUNT, for example 1:5:9, or two or more values with commas");
        if (axis_.values.size() > most_sweep_values)
            return wrong(
                begin, fmt::format("{} values are more than {}", axis_.values.size(), to_text(limit("sweep-values"))));
        return {};
    }

    Result<void> read_range(std::size_t begin) {
        // An exposure may be given in lux; then every value of the range is in lux.
        constexpr std::string_view card = "lux:";
        std::string prefix;
        if (axis_.key == "exposure" && text_.substr(begin).starts_with(card)) {
            prefix = std::string(card);
            begin += card.size();
            if (colons(begin) < 2) return read_list(begin - card.size());
        }
        std::array<std::string_view, 4> parts;
        std::array<std::size_t, 4> at{};
        std::size_t count = 0;
        for (std::size_t from = begin; from <= text_.size();) {
            const std::size_t end = std::min(text_.find(':', from), text_.size());
            if (count == parts.size()) return wrong(from, "nothing may follow log", "write FROM:TO:COUNT:log");
            at.at(count) = from;
            parts.at(count++) = text_.substr(from, end - from);
            from = end + 1;
        }
        if (count == 4 && parts[3] != "log")
            return wrong(at[3], fmt::format("'{}' is not log", parts[3]),
                         "write equal ratios as FROM:TO:COUNT:log, equal steps as FROM:TO:COUNT");
        const std::optional<Quantity> from = quantity_of(parts[0]);
        const std::optional<Quantity> to = quantity_of(parts[1]);
        if (!from)
            return wrong(at[0], fmt::format("'{}' is not a number", parts[0]), "separate values with commas: A,B,C");
        if (!to) return wrong(at[1], fmt::format("'{}' is not a number", parts[1]));
        Result<double> last = same_unit(*from, *to, at[1]);
        if (!last) return pass_on(last);
        Result<std::size_t> steps = read_count(parts[2], at[2]);
        if (!steps) return pass_on(steps);
        if (from->number == *last) return wrong(at[1], "both ends are the same");
        const bool logarithmic = count == 4;
        if (logarithmic && !(from->number > 0.0 && *last > 0.0))
            return wrong(at[0], "equal ratios need both ends above 0", "leave :log out for equal steps");
        for (std::size_t i = 0; i < *steps; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(*steps - 1);
            const double number = logarithmic ? from->number * std::pow(*last / from->number, share)
                                              : from->number + share * (*last - from->number);
            const std::string text = i == 0            ? shortest(from->number)
                                     : i == *steps - 1 ? shortest(*last)
                                                       : rounded(number, kept_digits);
            axis_.values.push_back(fmt::format("{}{}{}", prefix, text, from->unit));
        }
        return {};
    }

    // The number of `to`, converted to the unit of `from`.
    Result<double> same_unit(const Quantity& from, const Quantity& to, std::size_t at) const {
        if (from.unit == to.unit) return to.number;
        if (from.unit.empty() || to.unit.empty())
            return wrong(at, "one end has a unit, the other does not", "give both the same unit");
        const Unit* const of_from = find_unit(from.unit);
        const Unit* const of_to = find_unit(to.unit);
        const auto is_level = [](const Unit& unit) {
            return unit.dimension == Dimension::luminance_ev || unit.dimension == Dimension::illuminance_ev;
        };
        if (of_from == nullptr || of_to == nullptr || of_from->dimension != of_to->dimension || is_level(*of_from))
            return wrong(at, fmt::format("{} and {} are different quantities", from.unit, to.unit),
                         "give both ends the same unit");
        const Amount amount{to.number, of_to};
        return amount.in_base_units() / of_from->base_per_unit;
    }

    Result<std::size_t> read_count(std::string_view text, std::size_t at) const {
        std::size_t count = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
        if ((error != std::errc() && error != std::errc::result_out_of_range) || end != text.data() + text.size())
            return wrong(at, fmt::format("'{}' is not a count of values", text), "write FROM:TO:COUNT");
        if (error != std::errc() || count < 2 || count > most_sweep_values)
            return wrong(at, fmt::format("a sweep has 2 to {} (the limit '{}'), not {}",
                                         amount_of(limit("sweep-values")), limit("sweep-values").name, text));
        return count;
    }

    std::string_view text_;
    SweepAxis axis_;
};

} // namespace

std::string SweepAxis::name() const {
    return target.empty() ? key : fmt::format("{}.{}", target, key);
}

std::string SweepAxis::label(std::size_t value) const {
    const std::string& full = values[value];
    const auto quantity = quantity_of(full);
    return fmt::format("{} {}", name(),
                       quantity ? fmt::format("{}{}", rounded(quantity->number, shown_digits), quantity->unit) : full);
}

Result<SweepAxis> parse_sweep_axis(std::string_view text) {
    return AxisReader(text).read();
}

Unexpected refused_value(const SweepAxis& axis, std::size_t value, const Error& error) {
    Error of_axis = error;
    if (!of_axis.diagnostics.empty()) {
        std::string& message = of_axis.diagnostics.back().message;
        message = fmt::format("--sweep '{}', value {}: {}", axis.text, axis.values[value], message);
    }
    return Unexpected(std::move(of_axis));
}

} // namespace gonio::cli
