#include "values.hpp"

#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace gonio::cli {

namespace {

std::optional<int> parse_count(std::string_view text) {
    int value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || text.empty() || value < 0) return std::nullopt;
    return value;
}

} // namespace

Result<PixelSize> parse_size(std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross != std::string_view::npos) {
        const std::optional<int> width = parse_count(text.substr(0, cross));
        const std::optional<int> height = parse_count(text.substr(cross + 1));
        if (width && height) return PixelSize{*width, *height};
    }
    return fail("USE0105", fmt::format("'{}' is not a size", text), "write WIDTHxHEIGHT, for example 512x256");
}

Result<glm::dvec3> parse_vector(std::string_view text, std::string_view what) {
    glm::dvec3 vector(0.0);
    std::string_view rest = text;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t comma = rest.find(',');
        const std::optional<double> number = parse_number(rest.substr(0, comma));
        if (!number || (comma == std::string_view::npos) != (axis == 2))
            return fail("USE0105", fmt::format("{} takes three numbers, not '{}'", what, text),
                        "write x,y,z, for example 0,0,2.5");
        vector[axis] = *number;
        if (axis < 2) rest.remove_prefix(comma + 1);
    }
    return vector;
}

Result<double> parse_length(std::string_view text, std::string_view what) {
    if (const std::optional<double> meters = parse_number(text)) return *meters;
    return parse_amount(text, Dimension::length, what);
}

Result<Meters> parse_length_unit(const std::string& text, std::string_view what) {
    const bool has_number = !text.empty() && (text[0] == '.' || text[0] == '-' || (text[0] >= '0' && text[0] <= '9'));
    Result<double> length = parse_amount(has_number ? text : "1" + text, Dimension::length, what);
    if (!length || !(*length > 0.0))
        return fail("USE0105", fmt::format("{} takes a unit of length, not '{}'", what, text),
                    "for example cm, in or 2.5cm");
    return Meters(*length);
}

Result<double> parse_factor(std::string_view text, std::string_view what) {
    const bool is_percent = text.ends_with('%');
    const std::optional<double> number = parse_number(is_percent ? text.substr(0, text.size() - 1) : text);
    if (!number)
        return fail("USE0105", fmt::format("'{}' is not a {}", text, what),
                    "write a number up to 1, or per cent: 0.8, 80%");
    return is_percent ? 0.01 * *number : *number;
}

Result<std::uint64_t> whole_number(std::string_view text, std::string_view what) {
    std::uint64_t digits = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, digits);
    if (error == std::errc() && stop == end && !text.empty()) return digits;
    const std::optional<double> number = parse_number(text);
    if (number && *number >= 0.0 && *number <= 0x1p53 && std::floor(*number) == *number)
        return static_cast<std::uint64_t>(*number);
    return fail("USE0105", fmt::format("{} takes a whole number, not '{}'", what, text));
}

Result<unsigned> thread_count(const Arguments& arguments) {
    const std::optional<std::string> text = arguments.value("--jobs");
    if (!text) return 0U;
    const std::optional<int> count = parse_count(*text);
    if (!count || *count > 1024) return fail("USE0105", fmt::format("-j takes a number of threads, not '{}'", *text));
    return static_cast<unsigned>(*count);
}

Result<simd::InstructionSet> instruction_set(const Arguments& arguments) {
    const std::optional<std::string> text = arguments.value("--simd");
    if (!text) return simd::best_available();
    const std::optional<simd::InstructionSet> set = simd::parse_instruction_set(*text);
    if (!set) return unknown_name("instruction set", *text, simd::instruction_set_names());
    if (!simd::available(*set))
        return fail(Failure::unsupported, fmt::format("this machine cannot run '{}' code", *text),
                    fmt::format("the best available is {}", simd::to_text(simd::best_available())));
    return *set;
}

Result<std::optional<double>> reference_error(const Arguments& arguments, bool by_reference) {
    const auto given = arguments.value("--error");
    if (!given) return std::nullopt;
    if (!by_reference) return fail("USE0104", "--error needs the method reference", "add --method reference");
    const Result<double> error = parse_factor(*given, "relative error");
    if (!error || !(*error >= 1e-12) || !(*error <= 0.1))
        return fail("USE0106", fmt::format("--error must lie in [1e-12, 0.1], not '{}'", *given),
                    "it is relative: 1e-4 is the same as 0.01%");
    return *error;
}

} // namespace gonio::cli
