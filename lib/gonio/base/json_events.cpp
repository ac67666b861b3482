#include <gonio/base/json_events.hpp>
#include <gonio/base/json_text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace gonio::detail {

namespace {

// Messages of nlohmann::json: "… syntax error while parsing value - unexpected ']'; expected '}'", or "… - invalid
// literal; last read: 'tru}'".
struct Complaint {
    std::string what;     // "unexpected ']'"
    std::string expected; // "expected '}'"; may be empty
};

Complaint complaint_of(std::string_view said) {
    constexpr std::string_view dash = " - ";
    constexpr std::string_view expected = "; expected ";
    Complaint complaint;
    if (const std::size_t at = said.rfind(expected); at != std::string_view::npos) {
        complaint.expected = fmt::format("expected {}", said.substr(at + expected.size()));
        said = said.substr(0, at);
    }
    const std::size_t at = said.find(dash);
    if (at != std::string_view::npos) said.remove_prefix(at + dash.size());
    complaint.what = said.substr(0, said.find("; last read"));
    return complaint;
}

std::string excerpt(const std::string& token) {
    constexpr std::size_t shown = 40;
    if (token.size() <= shown) return token;
    std::size_t end = shown;
    while (end > 0 && (static_cast<unsigned char>(token[end]) & 0xc0U) == 0x80U)
        --end; // not inside a character
    return token.substr(0, end) + "…";
}

Diagnostic described(std::string_view text, const std::string& source, std::size_t position,
                     const std::string& last_token, const nlohmann::json::exception& exception) {
    // `position` counts the bytes read: the error is at the last of them, or at the end of the text.
    const bool at_end = position > text.size() || (position == text.size() && last_token.empty());
    const bool too_large = exception.id == 406; // a number out of the range of a double
    const std::size_t back = too_large ? last_token.size() : 1;
    const std::size_t offset = at_end ? text.size() : position - std::min(position, back);
    Diagnostic diagnostic;
    diagnostic.code = Cause(Failure::malformed).code();
    diagnostic.location = location_in(text, offset, source);
    Complaint complaint = complaint_of(exception.what());
    if (too_large)
        diagnostic.message = fmt::format("the number {} is too large", excerpt(last_token));
    else if (at_end || last_token == "<end of input>")
        diagnostic.message = "the JSON ends too early";
    else if (complaint.what.find("UTF-8") != std::string::npos)
        diagnostic.message = "the text is not UTF-8";
    else
        diagnostic.message = "broken JSON: " + complaint.what;
    diagnostic.hint = std::move(complaint.expected);
    return diagnostic;
}

// A place in the text that is stored elsewhere, where it may be moved on. The place of the text's end does not move.
class Bytes {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    explicit Bytes(const char** at) : at_(at) {}
    reference operator*() const { return **at_; }
    Bytes& operator++() {
        ++*at_;
        return *this;
    }
    bool operator==(const Bytes& other) const { return *at_ == *other.at_; }
    bool operator!=(const Bytes& other) const { return *at_ != *other.at_; }

private:
    const char** at_;
};

// nlohmann's events as ours.
class Events final : public nlohmann::json_sax<nlohmann::json> {
public:
    Events(std::string_view text, const std::string& source, JsonHandler& handler)
        : text_(text), source_(source), handler_(handler) {}

    bool null() override { return handler_.scalar(nullptr); }
    bool boolean(bool value) override { return handler_.scalar(value); }
    bool number_integer(number_integer_t value) override { return handler_.scalar(value); }
    bool number_unsigned(number_unsigned_t value) override { return handler_.scalar(value); }
    bool number_float(number_float_t value, const string_t& /*written*/) override { return handler_.scalar(value); }
    bool string(string_t& value) override { return handler_.scalar(std::move(value)); }
    bool binary(binary_t& /*value*/) override { return false; }
    bool key(string_t& name) override { return handler_.key(std::move(name)); }
    bool start_object(std::size_t /*elements*/) override { return handler_.start_object(); }
    bool start_array(std::size_t /*elements*/) override { return handler_.start_array(); }
    bool end_object() override { return handler_.end(); }
    bool end_array() override { return handler_.end(); }
    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::json::exception& exception) override {
        handler_.broken(described(text_, source_, position, last_token, exception));
        return false;
    }

private:
    std::string_view text_;
    const std::string& source_;
    JsonHandler& handler_;
};

} // namespace

Location JsonHandler::place() const {
    return place_at(bytes_read() - std::min<std::size_t>(bytes_read(), 1));
}

Location JsonHandler::place_at(std::size_t offset) const {
    return location_in(text_, offset, *source_);
}

void read_json(std::string_view text, const std::string& source, bool comments, JsonHandler& handler) {
    handler.text_ = text;
    handler.source_ = &source;
    handler.read_ = text.data();
    Events events(text, source, handler);
    constexpr bool strict = true;
    const char* end = text.data() + text.size();
    nlohmann::json::sax_parse(Bytes(&handler.read_), Bytes(&end), &events, nlohmann::json::input_format_t::json, strict,
                              comments);
}

} // namespace gonio::detail
