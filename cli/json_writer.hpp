// A JSON object with a long array that is written piece by piece, so that a report of a million points is never held as
// a tree. The output is the same as dump() of the whole.
#pragma once

#include "console.hpp"
#include "json_text.hpp"

#include <string>
#include <string_view>

namespace gonio::cli {

class JsonWriter {
public:
    // `pretty`: two spaces per level; else one line.
    JsonWriter(Console& console, bool pretty) : console_(console), pretty_(pretty) { console_.print("{"); }

    void member(std::string_view key, const Json& value) {
        begin(key);
        console_.print(text(value, 1));
    }

    void begin_array(std::string_view key) {
        begin(key);
        console_.print("[");
        elements_ = 0;
    }
    void element(const Json& value) {
        if (elements_++ > 0) console_.print(",");
        new_line(2);
        console_.print(text(value, 2));
    }
    void end_array() {
        if (elements_ > 0) new_line(1);
        console_.print("]");
    }

    void end() {
        new_line(0);
        console_.print("}\n");
    }

private:
    void begin(std::string_view key) {
        if (members_++ > 0) console_.print(",");
        new_line(1);
        console_.print(text(Json(key), 0));
        console_.print(pretty_ ? ": " : ":");
    }

    void new_line(std::size_t level) {
        if (pretty_) console_.print("\n" + std::string(2 * level, ' '));
    }

    // All newlines in a dump are between values: in strings they are escaped.
    std::string text(const Json& value, std::size_t level) const {
        std::string dumped = dump(value, pretty_ ? 2 : -1);
        dumped.pop_back(); // the newline
        if (!pretty_) return dumped;
        std::string indented;
        indented.reserve(dumped.size());
        for (const char c : dumped) {
            indented += c;
            if (c == '\n') indented.append(2 * level, ' ');
        }
        return indented;
    }

    Console& console_;
    bool pretty_;
    std::size_t members_ = 0;
    std::size_t elements_ = 0;
};

} // namespace gonio::cli
