// A JSON value. Reports, rigs and records are built from it and read through it; nlohmann::json, which reads and writes
// the text, is included where that happens only: its templates would be compiled again for every report.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace gonio::detail {

class JsonItem;

class Json {
public:
    struct Member;

    Json() noexcept; // null
    Json(std::nullptr_t) noexcept : Json() {}
    Json(const Json& other);
    Json(Json&& other) noexcept;
    Json& operator=(const Json& other);
    Json& operator=(Json&& other) noexcept;
    ~Json();

    template<std::same_as<bool> T>
    Json(T value) : Json(Boolean{value}) {}
    template<std::integral T>
    requires(!std::same_as<T, bool>) Json(T value)
        : Json(value < T{} ? Integer{static_cast<std::int64_t>(value), 0}
                           : Integer{0, static_cast<std::uint64_t>(value)}) {}
    template<std::floating_point T>
    Json(T value) : Json(Double{static_cast<double>(value)}) {}
    Json(std::string text);
    Json(std::string_view text);
    Json(const char* text);

    // An array of the elements.
    template<class T>
    requires std::constructible_from<Json, const T&> Json(const std::vector<T>& elements)
        : Json(std::span<const T>(elements)) {}
    template<class T, std::size_t extent>
    requires std::constructible_from < Json, const std::remove_const_t<T>
    & > Json(std::span<T, extent> elements) : Json(array()) {
        for (const T& element : elements)
            push_back(element);
    }

    // An object if every item is a pair of a string and a value, otherwise an array.
    Json(std::initializer_list<JsonItem> items);

    static Json array();
    static Json array(std::initializer_list<JsonItem> items);
    static Json object();

    bool is_null() const noexcept;
    bool is_boolean() const noexcept;
    bool is_number() const noexcept;
    bool is_unsigned() const noexcept; // written as an integer without a sign, below 2^64
    bool is_string() const noexcept;
    bool is_array() const noexcept;
    bool is_object() const noexcept;

    // The value must be of that type; any number is a double.
    double as_double() const;
    std::uint64_t as_uint64() const;
    const std::string& as_string() const;

    // Of an array or an object; 0 of anything else.
    std::size_t size() const noexcept;
    bool empty() const noexcept { return size() == 0; }

    // The elements of an array; none of anything else.
    const Json* begin() const noexcept;
    const Json* end() const noexcept;

    // An element of an array, which must be there.
    const Json& operator[](std::size_t index) const;
    Json& operator[](std::size_t index);
    Json& operator[](int index) { return (*this)[static_cast<std::size_t>(index)]; }
    const Json& front() const { return (*this)[std::size_t{0}]; }
    Json& back() { return (*this)[size() - 1]; }

    // Appends to an array; null becomes one.
    void push_back(Json element);

    // The members of an object in their order; none of anything else.
    std::span<const Member> items() const noexcept;

    // The value of a member; nullptr without it.
    const Json* find(std::string_view key) const noexcept;
    bool contains(std::string_view key) const noexcept { return find(key) != nullptr; }

    // The value of a member, which is appended as null if it is not there; null becomes an object.
    Json& operator[](std::string_view key);
    Json& operator[](const char* key) { return (*this)[std::string_view(key)]; }

    // Removes a member, if it is there.
    void erase(std::string_view key);

    // Sets all members of another object.
    void update(const Json& other);

    // In one line, or, from 0, in lines with `indent` spaces for each level. Numbers read back as the same double;
    // those that are not finite are null. Bytes that are not UTF-8 become replacement characters. `ascii`: other
    // characters as \u escapes.
    std::string dump(int indent = -1, bool ascii = false) const;

    friend bool operator==(const Json& a, const Json& b);

private:
    struct Boolean {
        bool value;
    };
    struct Integer {
        std::int64_t negative;
        std::uint64_t positive;
    };
    struct Double {
        double value;
    };
    using Array = std::vector<Json>;
    using Object = std::vector<Member>;
    // Integers from 0 are unsigned, others signed.
    using Value = std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object>;

    struct Writer;

    explicit Json(Boolean value);
    explicit Json(Integer value);
    explicit Json(Double value);

    Value value_;
};

struct Json::Member {
    std::string key;
    Json value;

    bool operator==(const Member&) const = default;
};

// An item of a list in braces, which is moved from.
class JsonItem {
public:
    template<class T>
    requires(!std::same_as<std::remove_cvref_t<T>, JsonItem> && std::constructible_from<Json, T>)
        // NOLINTNEXTLINE(bugprone-forwarding-reference-overload): the requirement leaves copying and moving out
        JsonItem(T&& value)
        : value_(std::forward<T>(value)) {}
    JsonItem(std::initializer_list<JsonItem> items) : value_(items) {}

    Json& value() const { return value_; }

private:
    mutable Json value_; // the elements of an initializer_list are const
};

} // namespace gonio::detail
