// Vectors of three floats as columns, which is what the packs read: in place where they lie so, else transposed piece
// by piece in memory that stays in a cache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace gonio::python {

// Room for three columns of `size` floats each.
class Room {
public:
    explicit Room(std::size_t size) : size_(size), numbers_(3 * size) {}
    float* column(std::size_t k) { return numbers_.data() + k * size_; }

private:
    std::size_t size_;
    std::vector<float> numbers_;
};

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

    // Columns of the points from `begin` on; are_columns().
    void in_place(std::size_t begin, const float* (&columns)[3]) const {
        const char* const first = data_ + static_cast<std::ptrdiff_t>(begin) * row_;
        for (int k = 0; k < 3; ++k)
            columns[k] = static_cast<const float*>(static_cast<const void*>(first + k * column_));
    }

    // The same of any vectors: in place, or copied into the room.
    void take(std::size_t begin, std::size_t size, Room& room, const float* (&columns)[3]) const {
        if (are_columns()) return in_place(begin, columns);
        const char* const first = data_ + static_cast<std::ptrdiff_t>(begin) * row_;
        for (std::size_t k = 0; k < 3; ++k)
            columns[k] = room.column(k);
        if (row_ == 3 * size_of_float && column_ == size_of_float && is_aligned()) {
            rows_to_columns(static_cast<const float*>(static_cast<const void*>(first)), size, room.column(0),
                            room.column(1), room.column(2));
            return;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const char* from = first + static_cast<std::ptrdiff_t>(k) * column_;
            for (std::size_t i = 0; i < size; ++i, from += row_)
                std::memcpy(room.column(k) + i, from, sizeof(float));
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
void make_unit(std::size_t size, Room& room, const float* (&columns)[3], const char* name);

} // namespace gonio::python
