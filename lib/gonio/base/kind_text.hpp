// Text of the form KIND:key=value,key=value: the grammar of shapes ("sphere:r=3cm") and materials
// ("frostbite:base=rgb(0.5,0.4,0.3),metal=1"). Commas inside parentheses do not separate.
#pragma once

#include <gonio/base/result.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

struct KindText {
    struct Entry {
        std::string key;
        std::optional<std::string> value; // nothing for a bare key: "two-sided"
    };

    std::string kind;
    std::vector<Entry> entries;

    // The entry's value, nullptr when the key is missing. A bare key counts as not having a value.
    const std::string* value(std::string_view key) const;
};

// Nothing after the colon means no entries, as completion leaves it: "frostbite:" is "frostbite". Fails (usage) on an
// empty kind or key, on a key that is given twice and beyond the limits kind-bytes and kind-keys.
Result<KindText> parse_kind_text(std::string_view text);

// Fails (usage) when an entry's key is not one of `known`, naming the nearest one and all of them.
Result<void> only_keys(const KindText& text, std::span<const std::string_view> known);

// "unknown WHAT 'NAME'", or "unknown WHAT 'NAME' of 'OF'", with the nearest of `known` and all of them in the hint.
Unexpected unknown_name(std::string_view what, std::string_view name, std::span<const std::string_view> known,
                        std::string_view of = {});

} // namespace gonio
