#include <gonio/base/json_events.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/scene/detail/rig_stream.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace gonio::detail {

namespace {

// The number of values in a value, itself included.
std::size_t size_of(const Json& json) { // NOLINT(misc-no-recursion): as deep as rig-depth
    std::size_t size = 1;
    for (const Json& element : json)
        size += size_of(element);
    for (const auto& [key, value] : json.items())
        size += size_of(value);
    return size;
}

class Handler final : public JsonHandler {
public:
    Handler(const std::string& source, const RigSink& sink) : source_(source), sink_(sink) {}

    Result<void> result() {
        if (error_) return Unexpected(std::move(*error_));
        if (!lights_seen_)
            return rig_error("RIG0104", source_, {}, "the key 'lights' is missing", R"(write "lights": [ … ])");
        return {};
    }

    bool scalar(Json value) override {
        if (put(std::move(value)) == nullptr) return false;
        return !open_.empty() || deliver();
    }

    bool key(std::string name) override {
        if (!open_.empty()) {
            if (open_.back()->contains(name))
                return refuse("RIG0107", path(), fmt::format("the key '{}' is given twice", name));
            key_ = std::move(name);
            key_end_ = bytes_read() - 1;
            return true;
        }
        if (std::find(members_.begin(), members_.end(), name) != members_.end())
            return refuse("RIG0107", {}, fmt::format("the key '{}' is given twice", name));
        if (members_.size() == limit("rig-values").value)
            return refuse_beyond({},
                                 fmt::format("more than {} keys, the limit 'rig-values'", limit("rig-values").value));
        members_.push_back(name);
        member_ = std::move(name);
        key_end_ = bytes_read() - 1;
        return true;
    }

    bool start_object() override {
        if (where_ == Where::outside) {
            where_ = Where::rig;
            return true;
        }
        return open(Json::object());
    }

    bool start_array() override {
        if (where_ == Where::rig && open_.empty() && member_ == "lights") {
            where_ = Where::lights;
            lights_seen_ = true;
            return !sink_.lights || skip_lights();
        }
        return open(Json::array());
    }

    bool end() override {
        if (open_.empty()) {
            where_ = where_ == Where::lights ? Where::rig : Where::outside;
            return true;
        }
        open_.pop_back();
        return !open_.empty() || deliver();
    }

    void broken(Diagnostic complaint) override {
        const RigCode code = "RIG0101";
        complaint.code = code->code;
        error_ = Error{Failure::malformed, {std::move(complaint)}};
    }

private:
    enum class Where : std::uint8_t { outside, rig, lights };

    std::string path() const { return where_ == Where::lights ? fmt::format("lights[{}]", lights_) : member_; }

    bool refuse(RigCode code, const std::string& path, std::string message, std::string hint = {}) {
        error_ = std::move(rig_error(code, source_, path, std::move(message), std::move(hint)).value());
        return false;
    }

    // Refuses a value beyond a limit, with its place.
    bool refuse_beyond(const std::string& path, std::string message) {
        refuse("RIG0108", path, std::move(message), std::string(limits_hint));
        error_->diagnostics.back().location = place();
        return false;
    }

    // Puts a value where the text has it; nullptr where it is not allowed.
    Json* put(Json value) {
        if (where_ == Where::outside) {
            refuse("RIG0101", {}, "a rig is a JSON object", R"(write { "schema": "gonio.rig/1", "lights": [ … ] })");
            return nullptr;
        }
        if (where_ == Where::rig && open_.empty() && member_ == "lights") {
            refuse("RIG0105", "lights", "must be an array");
            return nullptr;
        }
        if (open_.empty()) {
            values_ = 0;
            ends_.clear();
            note_end(value, where_ == Where::lights);
            root_ = std::move(value);
            return &root_;
        }
        if (++values_ > limit("rig-values").value) {
            refuse_beyond(path(), fmt::format("holds more than {}", to_text(limit("rig-values"))));
            return nullptr;
        }
        Json& parent = *open_.back();
        note_end(value, parent.is_array());
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        return &(parent[key_] = std::move(value));
    }

    bool open(Json value) {
        if (open_.size() == limit("rig-depth").value)
            return refuse_beyond(path(), fmt::format("is nested deeper than {}", to_text(limit("rig-depth"))));
        Json* const placed = put(std::move(value));
        if (placed == nullptr) return false;
        open_.push_back(placed);
        return true;
    }

    bool skip_lights() {
        Result<std::size_t> end = sink_.lights(bytes_read() - 1);
        if (end)
            skip_to(*end);
        else
            error_ = std::move(end.error());
        return end.has_value();
    }

    bool deliver() {
        if (where_ == Where::lights && lights_ == limit("rig-lights").value)
            return refuse_beyond("lights", fmt::format("holds more than {}", to_text(limit("rig-lights"))));
        Result<void> taken = where_ == Where::lights ? sink_.light(lights_, root_) : sink_.member(member_, root_);
        if (!taken) {
            error_ = std::move(taken.error());
            if (!error_->diagnostics.empty()) locate(error_->diagnostics.back());
            return false;
        }
        if (where_ == Where::lights) ++lights_;
        return true;
    }

    // Where the value ends that was just read, or the key in front of it.
    void note_end(const Json& value, bool in_array) {
        // A number was read with the byte after it.
        ends_.push_back(in_array ? bytes_read() - (value.is_number() ? 2 : 1) : key_end_);
    }

    // Gives a message that begins with its path in the rig the line and column of the innermost value on that path.
    void locate(Diagnostic& said) const {
        std::string_view rest = said.message;
        if (said.location.line > 0 || !rest.starts_with(path())) return;
        rest.remove_prefix(path().size());
        const auto follows = [&](std::string_view step) {
            const std::string_view after = rest.substr(std::min(step.size(), rest.size()));
            return rest.starts_with(step) &&
                   (after.empty() || std::string_view(".[:").find(after[0]) != std::string_view::npos);
        };
        const Json* value = &root_;
        std::size_t number = 0; // of the value, in the order of the text
        for (bool found = true; found;) {
            found = false;
            std::size_t next = number + 1;
            const auto step = [&](const std::string& name, const Json& inner) {
                found = follows(name);
                if (!found) {
                    next += size_of(inner);
                    return;
                }
                rest.remove_prefix(name.size());
                value = &inner;
                number = next;
            };
            std::size_t index = 0;
            const Json& at = *value;
            for (const Json& element : at)
                if (!found) step(fmt::format("[{}]", index++), element);
            for (const auto& [key, inner] : at.items())
                if (!found) step("." + key, inner);
        }
        // An unknown key is reported for its object.
        std::size_t next = number + 1;
        for (const auto& [key, inner] : value->items()) {
            if (rest.starts_with(fmt::format(": unknown key '{}'", key))) number = next;
            next += size_of(inner);
        }
        said.location = place_at(begin_of_token(ends_[number]));
    }

    // Of the token that ends at this byte; a bracket is a token.
    std::size_t begin_of_token(std::size_t end) const {
        const auto in_word = [&](std::size_t at) {
            const char c = text()[at];
            return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == 'E' || c == '+' || c == '-' || c == '.';
        };
        std::size_t begin = end;
        if (text()[end] == '"') {
            const auto is_escaped = [&](std::size_t at) {
                std::size_t slashes = 0;
                while (slashes < at && text()[at - 1 - slashes] == '\\')
                    ++slashes;
                return slashes % 2 == 1;
            };
            do {
                if (begin == 0) return end;
                --begin;
            } while (text()[begin] != '"' || is_escaped(begin));
        } else if (in_word(end)) {
            while (begin > 0 && in_word(begin - 1))
                --begin;
        }
        return begin;
    }

    const std::string& source_;
    const RigSink& sink_;
    Where where_ = Where::outside;
    bool lights_seen_ = false;
    std::size_t lights_ = 0;
    std::vector<std::string> members_; // keys of the rig so far
    std::string member_;               // the latest of them
    Json root_;                        // the value that is being read
    std::vector<Json*> open_;          // its objects and arrays that are not closed yet
    std::string key_;                  // in the innermost of them
    std::size_t values_ = 0;
    std::size_t key_end_ = 0;       // of the latest key, in the text
    std::vector<std::size_t> ends_; // of the values in root_, in the order of the text
    std::optional<Error> error_;
};

} // namespace

namespace {

std::string at_path(std::string_view path, std::string message) {
    return path.empty() ? std::move(message) : fmt::format("{}: {}", path, message);
}

// Translates the code of a grammar's error into the rig's: the same errors occur on a command line.
std::string_view code_in_rig(std::string_view code) {
    struct Twin {
        CodeOf<failure_codes> of;
        RigCode in_rig;
    };
    constexpr std::array special{Twin{"USE0103", "RIG0103"}, Twin{"USE0104", "RIG0104"}, Twin{"USE0107", "RIG0107"}};
    constexpr RigCode other = "RIG0106";
    for (const Twin& twin : special)
        if (twin.of->code == code) return twin.in_rig->code;
    const std::string_view family = code_family(code);
    return family == "USE" || family == "INP" ? other->code : code;
}

} // namespace

Unexpected rig_error(RigCode code, const std::string& source, std::string_view path, std::string message,
                     std::string hint) {
    Unexpected error = rig_value_error(code, at_path(path, std::move(message)), std::move(hint));
    error.value().diagnostics.back().location.file = source;
    return error;
}

Unexpected rig_value_error(RigCode code, std::string message, std::string hint) {
    Error error = error_at(Failure::malformed, {}, std::move(message), std::move(hint));
    error.diagnostics.back().code = code->code;
    return Unexpected(std::move(error));
}

Unexpected placed(const Error& error, const std::string& source, std::string_view path) {
    Diagnostic reason = error.diagnostics.empty() ? Diagnostic{} : error.diagnostics.back();
    const Location& in = reason.location;
    if (!in.file.empty() && in.line > 0)
        reason.message = fmt::format("{}:{}:{}: {}", in.file, in.line, in.column, reason.message);
    else if (!in.file.empty())
        reason.message = fmt::format("{}: {}", in.file, reason.message);
    const Failure failure = error.failure == Failure::usage ? Failure::malformed : error.failure;
    reason.code = std::string(code_in_rig(reason.code));
    reason.location = {source, 0, 0};
    reason.message = at_path(path, std::move(reason.message));
    return Unexpected(Error{failure, {std::move(reason)}});
}

Result<void> stream_rig(std::string_view text, const std::string& source, const RigSink& sink) {
    Handler handler(source, sink);
    constexpr bool comments = true; // as in `gonio rig new`
    read_json(text, source, comments, handler);
    return handler.result();
}

} // namespace gonio::detail
