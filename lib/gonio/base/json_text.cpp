#include <gonio/base/json_events.hpp>
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

// Builds the value without recursion: open objects and arrays are on an explicit stack.
class Builder final : public JsonHandler {
public:
    Result<Json> result() {
        if (error_) return Unexpected(std::move(*error_));
        return std::move(root_);
    }

    bool scalar(Json value) override { return put(std::move(value)) != nullptr; }

    bool key(std::string name) override {
        // An ordered object is searched from the beginning for each key.
        if (open_.back()->size() == limit("json-keys").value)
            return refuse(fmt::format("an object has more than {}", to_text(limit("json-keys"))));
        key_ = std::move(name);
        return true;
    }

    bool start_object() override { return open(Json::object()); }
    bool start_array() override { return open(Json::array()); }
    bool end() override {
        open_.pop_back();
        return true;
    }

    void broken(Diagnostic complaint) override { error_ = Error{Failure::malformed, {std::move(complaint)}}; }

private:
    bool refuse(std::string message) {
        error_ = error_at(Failure::malformed, place(), std::move(message), std::string(limits_hint));
        return false;
    }

    // nullptr where there are too many.
    Json* put(Json value) {
        if (++values_ > limit("json-values").value) {
            refuse(fmt::format("there are more than {}", to_text(limit("json-values"))));
            return nullptr;
        }
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        Json& parent = *open_.back();
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        return &(parent[key_] = std::move(value));
    }

    bool open(Json value) {
        if (open_.size() == limit("json-depth").value)
            return refuse(fmt::format("nested deeper than {}", to_text(limit("json-depth"))));
        Json* const placed = put(std::move(value));
        if (placed == nullptr) return false;
        open_.push_back(placed);
        return true;
    }

    Json root_;
    std::vector<Json*> open_; // objects and arrays that are not closed yet
    std::string key_;         // in the innermost open object
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

Result<Json> parse_json(std::string_view text, const std::string& source) {
    Builder builder;
    read_json(text, source, false, builder);
    return builder.result();
}

} // namespace gonio::detail
