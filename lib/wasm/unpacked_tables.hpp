// What pack_tables.mjs wrote, as numbers again.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <type_traits>

namespace gonio::detail {

template<class T, std::size_t count>
T& column_at(std::array<T, count>& table, std::size_t row, std::size_t /*column*/) {
    return table[row];
}
template<class T, std::size_t width, std::size_t count>
T& column_at(std::array<std::array<T, width>, count>& table, std::size_t row, std::size_t column) {
    return table[row][column];
}

template<class T, std::size_t count>
constexpr std::size_t width_of(const std::array<T, count>* /*table*/) {
    return 1;
}
template<class T, std::size_t width, std::size_t count>
constexpr std::size_t width_of(const std::array<std::array<T, width>, count>* /*table*/) {
    return width;
}

template<class Table>
Table unpacked(const char* text) {
    Table table;
    for (std::size_t column = 0; column < width_of(static_cast<const Table*>(nullptr)); ++column) {
        std::int64_t step = 0;
        std::int64_t whole = 0;
        for (std::size_t row = 0; row < table.size(); ++row) {
            auto& to = column_at(table, row, column);
            using T = std::remove_reference_t<decltype(to)>;
            char* end = nullptr;
            if constexpr (std::integral<T>) {
                step += std::strtol(text, &end, 10);
                whole += step;
                to = static_cast<T>(whole);
            } else {
                to = std::strtod(text, &end);
            }
            text = end;
        }
    }
    return table;
}

} // namespace gonio::detail
