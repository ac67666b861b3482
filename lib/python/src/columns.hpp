// Vectors of three floats as columns, which is what the packs read: in place where they lie so, else transposed piece
// by piece in memory that stays in the first cache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace gonio::python {

// Points to a piece: 512 vectors of two kinds, and results, are 20 kB.
inline constexpr std::size_t piece_of_columns = 512;

// x y z x y z … into three columns, and back.
void rows_to_columns(const float* rows, std::size_t count, float* x, float* y, float* z);
void columns_to_rows(const float* x, const float* y, const float* z, std::size_t count, float* rows);

// Three numbers of each point, wherever they lie.
class Vectors {
public:
    // Bytes from one point to the next, 0 if all are the same, and from one component to the next.
    Vectors(const float* numbers, std::ptrdiff_t row, std::ptrdiff_t column)
        : data_(static_cast<const char*>(static_cast<const void*>(numbers))), row_(row), column_(column) {}

    // Whether all points have the same numbers.
    bool are_one() const { return row_ == 0; }

    // Whether the packs read them in place.
    bool are_columns() const { return row_ == size_of_float && column_ % size_of_float == 0 && is_aligned(); }

    // Columns of the points from `begin` on: in place, or copied into `room`, 3 × piece_of_columns.
    void take(std::size_t begin, std::size_t size, float* room, const float* (&columns)[3]) const {
        const char* const first = data_ + static_cast<std::ptrdiff_t>(begin) * row_;
        if (are_columns()) {
            for (int k = 0; k < 3; ++k)
                columns[k] = static_cast<const float*>(static_cast<const void*>(first + k * column_));
            return;
        }
        for (std::size_t k = 0; k < 3; ++k)
            columns[k] = room + k * piece_of_columns;
        if (row_ == 3 * size_of_float && column_ == size_of_float && is_aligned()) {
            rows_to_columns(static_cast<const float*>(static_cast<const void*>(first)), size, room,
                            room + piece_of_columns, room + 2 * piece_of_columns);
            return;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const char* from = first + static_cast<std::ptrdiff_t>(k) * column_;
            for (std::size_t i = 0; i < size; ++i, from += row_)
                std::memcpy(room + k * piece_of_columns + i, from, sizeof(float));
        }
    }

private:
    static constexpr auto size_of_float = static_cast<std::ptrdiff_t>(sizeof(float));
    bool is_aligned() const { return reinterpret_cast<std::uintptr_t>(data_) % alignof(float) == 0; }

    const char* data_;
    std::ptrdiff_t row_;    // bytes from one point to the next; 0: the same for all
    std::ptrdiff_t column_; // bytes from one component to the next
};

// Makes vectors of any length unit ones; those that are, stay where they are. Fails (usage) on one without a direction.
void make_unit(std::size_t size, float* room, const float* (&columns)[3], const char* name);

} // namespace gonio::python
