#include <gonio/base/json_text.hpp>
#include <gonio/base/limits.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

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

// Builds the value without recursion: open objects and arrays are on an explicit stack.
class Builder final : public nlohmann::json_sax<OrderedJson> {
public:
    Builder(const JsonBytes& bytes, const std::string& source) : bytes_(bytes), source_(source) {}

    Result<OrderedJson> result() {
        if (error_) return Unexpected(std::move(*error_));
        return std::move(root_);
    }

    bool null() override { return scalar(nullptr); }
    bool boolean(bool value) override { return scalar(value); }
    bool number_integer(number_integer_t value) override { return scalar(value); }
    bool number_unsigned(number_unsigned_t value) override { return scalar(value); }
    bool number_float(number_float_t value, const string_t& /*written*/) override { return scalar(value); }
    bool string(string_t& value) override { return scalar(std::move(value)); }
    bool binary(binary_t& /*value*/) override { return false; }

    bool key(string_t& name) override {
        // An ordered object is searched from the beginning for each key.
        if (open_.back()->size() == limit("json-keys").value)
            return refuse(fmt::format("an object has more than {}", to_text(limit("json-keys"))));
        key_ = std::move(name);
        return true;
    }

    bool start_object(std::size_t /*elements*/) override { return open(OrderedJson::object()); }
    bool start_array(std::size_t /*elements*/) override { return open(OrderedJson::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::detail::exception& exception) override {
        error_ = Error{Failure::malformed, {json_complaint(bytes_.text(), source_, position, last_token, exception)}};
        return false;
    }

private:
    bool refuse(std::string message) {
        error_ = error_at(Failure::malformed, bytes_.place(source_), std::move(message), std::string(limits_hint));
        return false;
    }

    // nullptr where there are too many.
    OrderedJson* place(OrderedJson value) {
        if (++values_ > limit("json-values").value) {
            refuse(fmt::format("there are more than {}", to_text(limit("json-values"))));
            return nullptr;
        }
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        OrderedJson& parent = *open_.back();
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        return &(parent[key_] = std::move(value));
    }

    bool scalar(OrderedJson value) { return place(std::move(value)) != nullptr; }

    bool open(OrderedJson value) {
        if (open_.size() == limit("json-depth").value)
            return refuse(fmt::format("nested deeper than {}", to_text(limit("json-depth"))));
        OrderedJson* const placed = place(std::move(value));
        if (placed == nullptr) return false;
        open_.push_back(placed);
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    const JsonBytes& bytes_;
    const std::string& source_;
    OrderedJson root_;
    std::vector<OrderedJson*> open_; // objects and arrays that are not closed yet
    std::string key_;                // in the innermost open object
    std::size_t values_ = 0;
    std::optional<Error> error_;
};

} // namespace

Location location_in(std::string_view text, std::size_t offset, const std::string& source) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t line_start = before.rfind('\n') + 1; // npos + 1 = 0
    const auto line = static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n') + 1);
    return {source, line, static_cast<std::uint32_t>(before.size() - line_start + 1)};
}

Location JsonBytes::place(const std::string& source) const {
    const auto read = static_cast<std::size_t>(read_ - text_.data());
    return location_in(text_, read - std::min<std::size_t>(read, 1), source);
}

Diagnostic json_complaint(std::string_view text, const std::string& source, std::size_t position,
                          const std::string& last_token, const nlohmann::detail::exception& exception) {
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

Result<OrderedJson> parse_json(std::string_view text, const std::string& source) {
    JsonBytes bytes(text);
    Builder builder(bytes, source);
    OrderedJson::sax_parse(bytes.begin(), bytes.end(), &builder);
    return builder.result();
}

} // namespace gonio::detail
