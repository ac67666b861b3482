#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/nearest.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gonio {

namespace {

// Splits `text` at commas outside parentheses.
std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> parts;
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') ++depth;
        if (text[i] == ')') --depth;
        if (text[i] != ',' || depth > 0) continue;
        parts.push_back(text.substr(begin, i - begin));
        begin = i + 1;
    }
    parts.push_back(text.substr(begin));
    return parts;
}

} // namespace

const std::string* KindText::value(std::string_view key) const {
    for (const Entry& entry : entries)
        if (entry.key == key && entry.value) return &*entry.value;
    return nullptr;
}

Result<KindText> parse_kind_text(std::string_view text) {
    if (text.size() > limit("kind-bytes").value)
        return fail("USE0106", fmt::format("the text is longer than {}", to_text(limit("kind-bytes"))),
                    std::string(limits_hint));
    const std::size_t colon = text.find(':');
    KindText parsed;
    parsed.kind = text.substr(0, colon);
    if (parsed.kind.empty()) return fail("USE0105", fmt::format("'{}' does not begin with a kind", text));
    if (colon == std::string_view::npos || colon + 1 == text.size()) return parsed;
    for (const std::string_view part : split(text.substr(colon + 1))) {
        if (parsed.entries.size() == limit("kind-keys").value)
            return fail("USE0106", fmt::format("'{}' has more than {}", parsed.kind, to_text(limit("kind-keys"))),
                        std::string(limits_hint));
        const std::size_t equals = part.find('=');
        KindText::Entry entry;
        entry.key = part.substr(0, equals);
        if (equals != std::string_view::npos) entry.value = std::string(part.substr(equals + 1));
        if (entry.key.empty())
            return fail("USE0105", fmt::format("'{}' has an empty entry", text), "write KIND:key=value,key=value");
        const bool twice = std::any_of(parsed.entries.begin(), parsed.entries.end(),
                                       [&](const KindText::Entry& other) { return other.key == entry.key; });
        if (twice) return fail("USE0107", fmt::format("'{}' gives '{}' twice", text, entry.key));
        parsed.entries.push_back(std::move(entry));
    }
    return parsed;
}

Unexpected unknown_name(std::string_view what, std::string_view name, std::span<const std::string_view> known,
                        std::string_view of) {
    const std::string_view guess = nearest(name, known);
    const std::string all = fmt::format("there are: {}", fmt::join(known, ", "));
    std::string message = fmt::format("unknown {} '{}'", what, name);
    if (!of.empty()) message += fmt::format(" of '{}'", of);
    return fail("USE0103", std::move(message), guess.empty() ? all : fmt::format("did you mean '{}'? {}", guess, all));
}

Result<void> only_keys(const KindText& text, std::span<const std::string_view> known) {
    for (const KindText::Entry& entry : text.entries) {
        if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
        if (known.empty())
            return fail("USE0103", fmt::format("'{}' takes no keys, but '{}' is given", text.kind, entry.key));
        return unknown_name("key", entry.key, known, text.kind);
    }
    return {};
}

} // namespace gonio
