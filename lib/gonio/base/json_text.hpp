// JSON texts: reading them within limits, and locating errors in them.
#pragma once

#include <gonio/base/result.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

namespace gonio::detail {

using OrderedJson = nlohmann::ordered_json;

// The bytes of a text as nlohmann::json reads them, and how many it has read. Within a call of a json_sax the last byte
// read ends the token that the call is about, or, for a number, is the byte after it. Must outlive its iterators.
class JsonBytes {
public:
    class Iterator {
    public:
        using iterator_category = std::input_iterator_tag;
        using value_type = char;
        using difference_type = std::ptrdiff_t;
        using pointer = const char*;
        using reference = const char&;

        Iterator(const char* at, const char** read) : at_(at), read_(read) {}
        reference operator*() const { return *at_; }
        Iterator& operator++() {
            *read_ = ++at_;
            return *this;
        }
        Iterator operator++(int) {
            Iterator before = *this;
            ++*this;
            return before;
        }
        bool operator==(const Iterator& other) const { return at_ == other.at_; }
        bool operator!=(const Iterator& other) const { return at_ != other.at_; }

    private:
        const char* at_;
        const char** read_;
    };

    explicit JsonBytes(std::string_view text) : text_(text), read_(text.data()) {}
    JsonBytes(const JsonBytes&) = delete;
    JsonBytes& operator=(const JsonBytes&) = delete;

    Iterator begin() { return {text_.data(), &read_}; }
    Iterator end() { return {text_.data() + text_.size(), &read_}; }

    std::string_view text() const { return text_; }

    // Line and column of the last byte that was read.
    Location place(const std::string& source) const;

private:
    std::string_view text_;
    const char* read_;
};

// Line and column, from 1, of the byte at `offset`.
Location location_in(std::string_view text, std::size_t offset, const std::string& source);

// The arguments of json_sax::parse_error() as a diagnostic in our words, with its place and the general code of
// malformed inputs.
Diagnostic json_complaint(std::string_view text, const std::string& source, std::size_t position,
                          const std::string& last_token, const nlohmann::detail::exception& exception);

// The value of the text. If a key is given twice, the last one counts. Fails (malformed), with line and column in
// `source`, on anything that is not JSON and beyond the limits json-depth, json-keys and json-values.
Result<OrderedJson> parse_json(std::string_view text, const std::string& source = {});

} // namespace gonio::detail
