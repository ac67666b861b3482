#include <gonio/base/json.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace gonio::detail {

namespace {

using LibraryJson = nlohmann::ordered_json;

// Bytes that are not UTF-8 become replacement characters.
constexpr auto on_error = LibraryJson::error_handler_t::replace;

bool is_member(const JsonItem& item) {
    const Json& value = item.value();
    return value.is_array() && value.size() == 2 && value.front().is_string();
}

} // namespace

// The value as nlohmann's, which writes it.
struct Json::Writer {
    LibraryJson operator()(std::monostate) const { return nullptr; }
    LibraryJson operator()(const Array& array) const {
        LibraryJson made = LibraryJson::array();
        for (const Json& element : array)
            made.push_back(std::visit(*this, element.value_));
        return made;
    }
    LibraryJson operator()(const Object& object) const {
        LibraryJson made = LibraryJson::object();
        for (const Member& member : object)
            made.emplace(member.key, std::visit(*this, member.value.value_));
        return made;
    }
    template<class T>
    LibraryJson operator()(const T& leaf) const {
        return leaf;
    }
};

Json::Json() noexcept = default;
Json::Json(const Json& other) = default;
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(const Json& other) = default;
Json& Json::operator=(Json&& other) noexcept = default;
Json::~Json() = default;

Json::Json(std::string text) : value_(std::move(text)) {}
Json::Json(std::string_view text) : value_(std::string(text)) {}
Json::Json(const char* text) : value_(std::string(text)) {}
Json::Json(Boolean value) : value_(value.value) {}
Json::Json(Double value) : value_(value.value) {}
Json::Json(Integer value) : value_(value.negative < 0 ? Value(value.negative) : Value(value.positive)) {}

Json::Json(std::initializer_list<JsonItem> items) {
    if (!std::all_of(items.begin(), items.end(), is_member)) {
        *this = array(items);
        return;
    }
    *this = object();
    for (const JsonItem& item : items) {
        Json& pair = item.value();
        (*this)[pair.front().as_string()] = std::move(pair.back());
    }
}

Json Json::array() {
    Json made;
    made.value_.emplace<Array>();
    return made;
}

Json Json::array(std::initializer_list<JsonItem> items) {
    Json made = array();
    for (const JsonItem& item : items)
        made.push_back(std::move(item.value()));
    return made;
}

Json Json::object() {
    Json made;
    made.value_.emplace<Object>();
    return made;
}

bool Json::is_null() const noexcept {
    return std::holds_alternative<std::monostate>(value_);
}
bool Json::is_boolean() const noexcept {
    return std::holds_alternative<bool>(value_);
}
bool Json::is_number() const noexcept {
    return is_unsigned() || std::holds_alternative<std::int64_t>(value_) || std::holds_alternative<double>(value_);
}
bool Json::is_unsigned() const noexcept {
    return std::holds_alternative<std::uint64_t>(value_);
}
bool Json::is_string() const noexcept {
    return std::holds_alternative<std::string>(value_);
}
bool Json::is_array() const noexcept {
    return std::holds_alternative<Array>(value_);
}
bool Json::is_object() const noexcept {
    return std::holds_alternative<Object>(value_);
}

double Json::as_double() const {
    if (const auto* integer = std::get_if<std::uint64_t>(&value_)) return static_cast<double>(*integer);
    if (const auto* integer = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*integer);
    return std::get<double>(value_);
}

std::uint64_t Json::as_uint64() const {
    return std::get<std::uint64_t>(value_);
}

const std::string& Json::as_string() const {
    return std::get<std::string>(value_);
}

std::size_t Json::size() const noexcept {
    if (const auto* array = std::get_if<Array>(&value_)) return array->size();
    return items().size();
}

const Json* Json::begin() const noexcept {
    const auto* array = std::get_if<Array>(&value_);
    return array != nullptr ? array->data() : nullptr;
}

const Json* Json::end() const noexcept {
    const auto* array = std::get_if<Array>(&value_);
    return array != nullptr ? array->data() + array->size() : nullptr;
}

const Json& Json::operator[](std::size_t index) const {
    return std::get<Array>(value_).at(index);
}

Json& Json::operator[](std::size_t index) {
    return std::get<Array>(value_).at(index);
}

void Json::push_back(Json element) {
    if (is_null()) value_.emplace<Array>();
    std::get<Array>(value_).push_back(std::move(element));
}

std::span<const Json::Member> Json::items() const noexcept {
    const auto* object = std::get_if<Object>(&value_);
    return object != nullptr ? std::span<const Member>(*object) : std::span<const Member>();
}

const Json* Json::find(std::string_view key) const noexcept {
    for (const Member& member : items())
        if (member.key == key) return &member.value;
    return nullptr;
}

Json& Json::operator[](std::string_view key) {
    if (is_null()) value_.emplace<Object>();
    auto& object = std::get<Object>(value_);
    for (Member& member : object)
        if (member.key == key) return member.value;
    return object.emplace_back(Member{std::string(key), {}}).value;
}

void Json::erase(std::string_view key) {
    std::erase_if(std::get<Object>(value_), [&](const Member& member) { return member.key == key; });
}

void Json::update(const Json& other) {
    for (const Member& member : other.items())
        (*this)[member.key] = member.value;
}

std::string Json::dump(int indent, bool ascii) const {
    return std::visit(Writer{}, value_).dump(indent, ' ', ascii, on_error);
}

bool operator==(const Json& a, const Json& b) {
    return a.value_ == b.value_;
}

} // namespace gonio::detail
