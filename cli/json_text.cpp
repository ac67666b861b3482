#include "json_text.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace gonio::cli {

namespace {

// From this many on, numbers of an array stay on one line.
constexpr std::size_t many_numbers = 10;

bool is_row_of_numbers(const Json& json) {
    return json.size() >= many_numbers && json.is_array() &&
           std::all_of(json.begin(), json.end(), [](const Json& value) { return value.is_number(); });
}

void append(std::string& text, const Json& json, std::size_t indent, std::size_t level);

// An element or a member on a line of its own.
void append_line(std::string& text, bool is_first, const Json& json, std::size_t indent, std::size_t level,
                 std::string_view before = {}) {
    text += is_first ? "\n" : ",\n";
    text.append(level * indent, ' ');
    text += before;
    append(text, json, indent, level);
}

void append(std::string& text, const Json& json, std::size_t indent, std::size_t level) {
    if (json.empty()) {
        text += json.dump();
    } else if (is_row_of_numbers(json)) {
        const char* before = "[";
        for (const Json& value : json) {
            text += before;
            text += value.dump();
            before = ", ";
        }
        text += "]";
    } else {
        text += json.is_array() ? "[" : "{";
        for (const Json& element : json)
            append_line(text, &element == json.begin(), element, indent, level + 1);
        for (const Json::Member& member : json.items())
            append_line(text, &member == json.items().data(), member.value, indent, level + 1,
                        Json(member.key).dump() + ": ");
        text += "\n";
        text.append(level * indent, ' ');
        text += json.is_array() ? "]" : "}";
    }
}

} // namespace

std::string dump(const Json& json, int indent) {
    if (indent < 0) return json.dump() + "\n";
    std::string text;
    append(text, json, static_cast<std::size_t>(indent), 0);
    return text + "\n";
}

std::string dump_element(const Json& json) {
    std::string text;
    append(text, json, 2, 1);
    return text;
}

} // namespace gonio::cli
