// Closed sets as tables: one row for each member, with its name in `name`.
#pragma once

#include <gonio/base/kind_text.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace gonio {

// The row called `name`. Fails (usage) as unknown_name() does: "unknown WHAT 'NAME'", with the nearest name and all of
// them in the hint. The pointer is into `rows`, which must outlive it.
template<class Rows>
auto find_named(std::string_view what, std::string_view name, const Rows& rows) -> Result<decltype(&*rows.begin())> {
    for (const auto& row : rows)
        if (row.name == name) return &row;
    std::vector<std::string_view> names;
    for (const auto& row : rows)
        names.push_back(row.name);
    return unknown_name(what, name, names);
}

// Whether row i describes the enumerator of value i, up to and with `last`: what a table must hold that is indexed by
// an enumeration. static_assert(in_enum_order(rows, &Row::member, Enum::last)).
template<class Rows, class Row, class Enum>
constexpr bool in_enum_order(const Rows& rows, Enum Row::*member, Enum last) {
    std::size_t i = 0;
    for (const auto& row : rows)
        if (static_cast<std::size_t>(row.*member) != i++) return false;
    return i == static_cast<std::size_t>(last) + 1;
}

} // namespace gonio
