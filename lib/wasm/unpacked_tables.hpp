// What pack_tables.mjs wrote, as numbers again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::detail {

class PackedTables {
public:
    explicit PackedTables(const unsigned char* bytes);

    // The next table, of rows that are structures or arrays which begin with so many `Number`s. `stride`: how many rows
    // are a row of its grid.
    template<class Number, std::size_t columns, class Table>
    Table table(std::size_t stride) {
        Table table;
        constexpr std::size_t width = sizeof(table[0]) / sizeof(Number);
        static_assert(columns <= width);
        auto* const numbers = reinterpret_cast<Number*>(table.data());
        for (std::size_t column = 0; column < columns; ++column) {
            read_column(table.size(), stride);
            for (std::size_t row = 0; row < table.size(); ++row)
                numbers[row * width + column] = static_cast<Number>(values_[row]);
        }
        return table;
    }

private:
    struct Chance {
        std::uint32_t of_one = 32768; // in 65536
        std::int32_t seen = 0;
    };
    struct Context {
        std::array<Chance, 64> longer, second;
    };

    bool bit(Chance& chance);
    bool even_bit();
    std::int64_t number(Context& context, int& length);
    void read_column(std::size_t rows, std::size_t stride);

    const unsigned char* next_;
    std::uint32_t low_ = 0, high_ = 0xFFFFFFFF, code_ = 0;
    Context orders_, decimals_;
    std::array<Context, 21> steps_;
    std::vector<double> values_;
};

} // namespace gonio::detail
