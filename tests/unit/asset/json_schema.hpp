// The part of JSON Schema (2020-12) that the schemas in the tree use, to check real output against them.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <utility>

namespace gonio::test {

class JsonSchema {
public:
    explicit JsonSchema(nlohmann::json schema) : root_(std::move(schema)) {}

    // The first violation, with the path to it; empty: none.
    std::string complaint(const nlohmann::json& value) const { return complaint(root_, value, "$"); }

private:
    using Json = nlohmann::json;

    std::string complaint(const Json& schema, const Json& value, const std::string& path) const;
    std::string by_word(const std::string& word, const Json& rule, const Json& schema, const Json& value,
                        const std::string& path) const;

    Json root_;
};

} // namespace gonio::test
