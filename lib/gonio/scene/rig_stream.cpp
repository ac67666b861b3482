#include <gonio/scene/detail/rig_stream.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace gonio::detail {

namespace {

// Line and column, from 1, of the byte at `offset`.
Location location_of(std::string_view text, std::size_t offset, const std::string& source) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t line_start = before.rfind('\n') + 1; // npos + 1 = 0
    const auto line = static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n') + 1);
    return {source, line, static_cast<std::uint32_t>(before.size() - line_start + 1)};
}

// nlohmann::json says "… syntax error while parsing value - unexpected ']'; expected '}'", or "… - invalid literal;
// last read: 'tru}'".
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

class Handler final : public nlohmann::json_sax<RigJson> {
public:
    Handler(std::string_view text, const std::string& source, const RigSink& sink)
        : text_(text), source_(source), sink_(sink) {}

    Result<void> result() {
        if (error_) return Unexpected(std::move(*error_));
        if (!lights_seen_)
            return rig_error(Failure::malformed, source_, {}, "there is no key 'lights'", R"(write "lights": [ … ])");
        return {};
    }

    bool null() override { return scalar(nullptr); }
    bool boolean(bool value) override { return scalar(value); }
    bool number_integer(number_integer_t value) override { return scalar(value); }
    bool number_unsigned(number_unsigned_t value) override { return scalar(value); }
    bool number_float(number_float_t value, const string_t& /*written*/) override { return scalar(value); }
    bool string(string_t& value) override { return scalar(std::move(value)); }
    bool binary(binary_t& /*value*/) override { return false; }

    bool key(string_t& name) override {
        if (!open_.empty()) {
            if (open_.back()->contains(name)) return refuse(path(), fmt::format("the key '{}' is given twice", name));
            key_ = std::move(name);
            return true;
        }
        if (std::find(members_.begin(), members_.end(), name) != members_.end())
            return refuse({}, fmt::format("the key '{}' is given twice", name));
        if (members_.size() == max_rig_values) return refuse({}, "there are too many keys");
        members_.push_back(name);
        member_ = std::move(name);
        return true;
    }

    bool start_object(std::size_t /*elements*/) override {
        if (where_ == Where::outside) {
            where_ = Where::rig;
            return true;
        }
        return open(RigJson::object());
    }

    bool start_array(std::size_t /*elements*/) override {
        if (where_ == Where::rig && open_.empty() && member_ == "lights") {
            where_ = Where::lights;
            lights_seen_ = true;
            return true;
        }
        return open(RigJson::array());
    }

    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::detail::exception& exception) override {
        // `position` counts the bytes read: the last one of them, or the end of the text, is where it went wrong.
        const bool at_end = position > text_.size() || (position == text_.size() && last_token.empty());
        const bool too_large = exception.id == 406; // a number out of the range of a double
        const std::size_t back = too_large ? last_token.size() : 1;
        const std::size_t offset = at_end ? text_.size() : position - std::min(position, back);
        Diagnostic diagnostic;
        diagnostic.location = location_of(text_, offset, source_);
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
        error_ = Error{Failure::malformed, {std::move(diagnostic)}};
        return false;
    }

private:
    enum class Where : std::uint8_t { outside, rig, lights };

    static std::string excerpt(std::string token) {
        constexpr std::size_t shown = 40;
        if (token.size() <= shown) return token;
        std::size_t end = shown;
        while (end > 0 && (static_cast<unsigned char>(token[end]) & 0xc0U) == 0x80U)
            --end; // not within a character
        return token.substr(0, end) + "…";
    }

    std::string path() const { return where_ == Where::lights ? fmt::format("lights[{}]", lights_) : member_; }

    bool refuse(const std::string& path, std::string message, std::string hint = {}) {
        error_ = std::move(rig_error(Failure::malformed, source_, path, std::move(message), std::move(hint)).value());
        return false;
    }

    // Puts a value where the text has it; nullptr where it may not be.
    RigJson* place(RigJson value) {
        if (where_ == Where::outside) {
            refuse({}, "a rig is a JSON object", R"(write { "schema": "gonio.rig/1", "lights": [ … ] })");
            return nullptr;
        }
        if (where_ == Where::rig && open_.empty() && member_ == "lights") {
            refuse("lights", "must be an array");
            return nullptr;
        }
        if (open_.empty()) {
            values_ = 0;
            root_ = std::move(value);
            return &root_;
        }
        if (++values_ > max_rig_values) {
            refuse(path(), fmt::format("holds more than {} values", max_rig_values));
            return nullptr;
        }
        RigJson& parent = *open_.back();
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        return &(parent[key_] = std::move(value));
    }

    bool scalar(RigJson value) {
        if (place(std::move(value)) == nullptr) return false;
        return !open_.empty() || deliver();
    }

    bool open(RigJson value) {
        if (open_.size() == max_rig_depth)
            return refuse(path(), fmt::format("is nested more than {} levels deep", max_rig_depth));
        RigJson* const placed = place(std::move(value));
        if (placed == nullptr) return false;
        open_.push_back(placed);
        return true;
    }

    bool close() {
        if (open_.empty()) {
            where_ = where_ == Where::lights ? Where::rig : Where::outside;
            return true;
        }
        open_.pop_back();
        return !open_.empty() || deliver();
    }

    bool deliver() {
        if (where_ == Where::lights && lights_ == max_rig_lights)
            return refuse("lights", fmt::format("holds more than {} lights", max_rig_lights));
        Result<void> taken = where_ == Where::lights ? sink_.light(lights_++, root_) : sink_.member(member_, root_);
        if (taken) return true;
        error_ = std::move(taken.error());
        return false;
    }

    std::string_view text_;
    const std::string& source_;
    const RigSink& sink_;
    Where where_ = Where::outside;
    bool lights_seen_ = false;
    std::size_t lights_ = 0;
    std::vector<std::string> members_; // keys of the rig so far
    std::string member_;               // the latest of them
    RigJson root_;                     // the value that is being read
    std::vector<RigJson*> open_;       // its objects and arrays that are not closed yet
    std::string key_;                  // in the innermost of them
    std::size_t values_ = 0;
    std::optional<Error> error_;
};

} // namespace

Unexpected rig_error(Failure failure, const std::string& source, std::string_view path, std::string message,
                     std::string hint) {
    if (!path.empty()) message = fmt::format("{}: {}", path, message);
    return fail(failure, std::move(message), std::move(hint), source);
}

Unexpected placed(const Error& error, const std::string& source, std::string_view path) {
    Diagnostic reason = error.diagnostics.empty() ? Diagnostic{} : error.diagnostics.back();
    const Location& in = reason.location;
    if (!in.file.empty() && in.line > 0)
        reason.message = fmt::format("{}:{}:{}: {}", in.file, in.line, in.column, reason.message);
    else if (!in.file.empty())
        reason.message = fmt::format("{}: {}", in.file, reason.message);
    const Failure failure = error.failure == Failure::usage ? Failure::malformed : error.failure;
    Error at_path = rig_error(failure, source, path, std::move(reason.message), std::move(reason.hint)).value();
    at_path.diagnostics.back().code = std::move(reason.code);
    return Unexpected(std::move(at_path));
}

Result<void> stream_rig(std::string_view text, const std::string& source, const RigSink& sink) {
    Handler handler(text, source, sink);
    RigJson::sax_parse(text.begin(), text.end(), &handler);
    return handler.result();
}

} // namespace gonio::detail
