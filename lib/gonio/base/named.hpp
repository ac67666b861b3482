// Closed sets as tables: one row for each member, with its name in `name`. A row may also be a pointer to such a row,
// or just the name. Looking up a name and rejecting an unknown one is done only here.
#pragma once

#include <gonio/base/kind_text.hpp>
#include <gonio/base/result.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <vector>

namespace gonio {

template<class Row>
constexpr std::string_view name_of_row(const Row& row) {
    if constexpr (std::is_convertible_v<const Row&, std::string_view>)
        return row;
    else if constexpr (std::is_pointer_v<Row>)
        return row->name;
    else
        return row.name;
}

// The names of all rows, in their order.
template<class Rows>
std::vector<std::string_view> names_of(const Rows& rows) {
    std::vector<std::string_view> names;
    for (const auto& row : rows)
        names.push_back(name_of_row(row));
    return names;
}

// The row named `name`. Fails (usage) as unknown_name() does: "unknown WHAT 'NAME'", or "unknown WHAT 'NAME' of 'OF'",
// with the nearest name and all of them in the hint. The pointer is into `rows`, which must outlive it.
template<class Rows>
auto find_named(std::string_view what, std::string_view name, const Rows& rows, std::string_view of = {})
    -> Result<decltype(&*rows.begin())> {
    for (const auto& row : rows)
        if (name_of_row(row) == name) return &row;
    return unknown_name(what, name, names_of(rows), of);
}

// The same for a list of names separated by commas. `all`, if not empty, is an additional name that stands for every
// row. No row appears twice.
template<class Rows>
auto find_all_named(std::string_view what, std::string_view list, const Rows& rows, std::string_view all = {})
    -> Result<std::vector<decltype(&*rows.begin())>> {
    std::vector<decltype(&*rows.begin())> found;
    const auto add = [&](decltype(&*rows.begin()) row) {
        if (std::find(found.begin(), found.end(), row) == found.end()) found.push_back(row);
    };
    for (bool more = true; more;) {
        const std::size_t comma = list.find(',');
        const std::string_view name = list.substr(0, comma);
        const auto at =
            std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return name_of_row(row) == name; });
        if (at != rows.end()) {
            add(&*at);
        } else if (!all.empty() && name == all) {
            for (const auto& row : rows)
                add(&row);
        } else {
            std::vector<std::string_view> names = names_of(rows);
            if (!all.empty()) names.push_back(all);
            return unknown_name(what, name, names);
        }
        more = comma != std::string_view::npos;
        if (more) list.remove_prefix(comma + 1);
    }
    return found;
}

// A name for a value, if there is nothing else to state about it.
template<class T>
struct Named {
    std::string_view name;
    T value;
};
template<class T>
Named(std::string_view, T) -> Named<T>;

// The value of that name; fails as find_named() does.
template<class Rows>
auto find_value(std::string_view what, std::string_view name, const Rows& rows)
    -> Result<std::remove_cvref_t<decltype(rows.begin()->value)>> {
    return find_named(what, name, rows).map([](const auto* row) { return row->value; });
}

// Whether row i describes the enumerator of value i, up to and including `last`: required of a table that is indexed by
// an enumeration. static_assert(in_enum_order(rows, &Row::member, Enum::last)).
template<class Rows, class Row, class Enum>
constexpr bool in_enum_order(const Rows& rows, Enum Row::*member, Enum last) {
    std::size_t i = 0;
    for (const auto& row : rows)
        if (static_cast<std::size_t>(row.*member) != i++) return false;
    return i == static_cast<std::size_t>(last) + 1;
}

} // namespace gonio
