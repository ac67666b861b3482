// The part of JSON Schema (2020-12) that the schemas in the tree use, to check real output against them.
#pragma once

#include <nlohmann/json.hpp>

#include <regex>
#include <string>

namespace gonio::test {

class JsonSchema {
public:
    explicit JsonSchema(nlohmann::json schema) : root_(std::move(schema)) {}

    // The first violation, with the path to it; empty: none.
    std::string complaint(const nlohmann::json& value) const { return complaint(root_, value, "$"); }

private:
    using Json = nlohmann::json;

    static bool is_of_type(const Json& value, const std::string& type) {
        if (type == "object") return value.is_object();
        if (type == "array") return value.is_array();
        if (type == "string") return value.is_string();
        if (type == "integer") return value.is_number_integer();
        if (type == "number") return value.is_number();
        if (type == "boolean") return value.is_boolean();
        return type == "null" && value.is_null();
    }

    std::string complaint(const Json& schema, const Json& value, const std::string& path) const {
        for (const auto& [word, rule] : schema.items()) {
            std::string wrong = by_word(word, rule, schema, value, path);
            if (!wrong.empty()) return wrong;
        }
        return {};
    }

    std::string by_word(const std::string& word, const Json& rule, const Json& schema, const Json& value,
                        const std::string& path) const {
        const std::string bad = path + ": " + word;
        if (word == "$ref")
            return complaint(root_.at(Json::json_pointer(rule.get<std::string>().substr(1))), value, path);
        if (word == "const") return value == rule ? "" : bad;
        if (word == "enum") return std::find(rule.begin(), rule.end(), value) != rule.end() ? "" : bad;
        if (word == "type") {
            if (rule.is_string()) return is_of_type(value, rule.get<std::string>()) ? "" : bad;
            for (const Json& type : rule)
                if (is_of_type(value, type.get<std::string>())) return "";
            return bad;
        }
        if (word == "minimum") return value.get<double>() >= rule.get<double>() ? "" : bad;
        if (word == "maximum") return value.get<double>() <= rule.get<double>() ? "" : bad;
        if (word == "exclusiveMinimum") return value.get<double>() > rule.get<double>() ? "" : bad;
        if (word == "pattern")
            return std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())) ? "" : bad;
        if (word == "minItems") return value.size() >= rule.get<std::size_t>() ? "" : bad;
        if (word == "maxItems") return value.size() <= rule.get<std::size_t>() ? "" : bad;
        if (word == "items") {
            for (const Json& item : value)
                if (std::string wrong = complaint(rule, item, path + "[]"); !wrong.empty()) return wrong;
            return "";
        }
        if (word == "oneOf") {
            int fitting = 0;
            for (const Json& one : rule)
                fitting += complaint(one, value, path).empty() ? 1 : 0;
            return fitting == 1 ? "" : bad;
        }
        if (word == "required" && value.is_object()) {
            for (const Json& key : rule)
                if (!value.contains(key.get<std::string>())) return bad + ' ' + key.get<std::string>();
            return "";
        }
        if (word == "properties" && value.is_object()) {
            for (const auto& [key, of] : rule.items())
                if (value.contains(key))
                    if (std::string wrong = complaint(of, value.at(key), path + '.' + key); !wrong.empty())
                        return wrong;
            return "";
        }
        if (word == "additionalProperties" && rule == false && value.is_object()) {
            for (const auto& [key, of] : value.items())
                if (!schema.at("properties").contains(key)) return bad + ' ' + key;
            return "";
        }
        for (const char* known : {"$schema", "$id", "$defs", "title", "description", "examples", "properties",
                                  "required", "additionalProperties"})
            if (word == known) return "";
        return path + ": the test knows no word '" + word + "'";
    }

    Json root_;
};

} // namespace gonio::test
