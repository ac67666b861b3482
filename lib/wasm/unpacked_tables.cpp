#include "unpacked_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gonio::detail {

namespace {

constexpr std::int64_t as_bits = 40; // in place of a count of decimals: the number as it is stored

double binomial(std::size_t n, std::size_t k) {
    double value = 1.0;
    for (std::size_t i = 0; i < k; ++i)
        value = value * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return value;
}

// What differences of these orders, along a row of the grid and across its rows, would be 0 for.
double expected(const std::vector<double>& values, std::size_t i, std::size_t stride, std::size_t order,
                std::size_t row_order) {
    const std::size_t a = std::min(order, i % stride);
    const std::size_t b = std::min(row_order, i / stride);
    double sum = 0.0;
    for (std::size_t k = 0; k <= b; ++k)
        for (std::size_t j = k == 0 ? 1 : 0; j <= a; ++j)
            sum += ((j + k) % 2 != 0 ? 1.0 : -1.0) * binomial(a, j) * binomial(b, k) * values[i - j - k * stride];
    return sum;
}

} // namespace

PackedTables::PackedTables(const unsigned char* bytes) : next_(bytes) {
    for (int i = 0; i < 4; ++i)
        code_ = code_ << 8U | *next_++;
}

bool PackedTables::bit(Chance& chance) {
    const std::uint32_t range = high_ - low_;
    const std::uint32_t middle = low_ + (range >> 16U) * chance.of_one + ((range & 0xFFFFU) * chance.of_one >> 16U);
    const bool one = code_ <= middle;
    if (one)
        high_ = middle;
    else
        low_ = middle + 1;
    while ((low_ ^ high_) >> 24U == 0) {
        low_ <<= 8U;
        high_ = high_ << 8U | 0xFFU;
        code_ = code_ << 8U | *next_++;
    }
    const auto was = static_cast<std::int32_t>(chance.of_one);
    const std::int32_t step = 2 * ((one ? 65535 : 0) - was) / (2 * chance.seen + 3);
    chance.of_one = static_cast<std::uint32_t>(std::clamp(was + step, 32, 65503));
    if (chance.seen < 30) ++chance.seen;
    return one;
}

bool PackedTables::even_bit() {
    Chance even;
    return bit(even);
}

std::int64_t PackedTables::number(Context& context, int& length) {
    length = 0;
    while (bit(context.longer[static_cast<std::size_t>(length)]))
        ++length;
    if (length == 0) return 0;
    std::int64_t size = 1;
    if (length > 1) size = bit(context.second[static_cast<std::size_t>(length)]) ? 3 : 2;
    for (int n = 2; n < length; ++n)
        size = 2 * size + (even_bit() ? 1 : 0);
    return even_bit() ? -size : size;
}

void PackedTables::read_column(std::size_t rows, std::size_t stride) {
    int length = 0;
    const auto order = static_cast<std::size_t>(number(orders_, length));
    const auto row_order = static_cast<std::size_t>(number(orders_, length));
    values_.resize(rows);
    std::int64_t decimals = 0;
    int last = 0;
    int before = 0;
    for (std::size_t i = 0; i < rows; ++i) {
        const std::int64_t more = number(decimals_, length);
        if (decimals + more == as_bits) {
            std::uint64_t bits = 0;
            for (int n = 0; n < 64; ++n)
                bits = bits << 1U | (even_bit() ? 1U : 0U);
            std::memcpy(&values_[i], &bits, sizeof(bits)); // libc++ 14 has no bit_cast
            continue;
        }
        decimals += more;
        double unit = 1.0;
        for (std::int64_t n = 0; n < decimals; ++n)
            unit *= 10.0;
        const std::int64_t step =
            number(steps_[static_cast<std::size_t>(std::min(20, (last + before + 1) / 2))], length);
        before = last;
        last = length;
        values_[i] =
            (static_cast<double>(step) + std::floor(expected(values_, i, stride, order, row_order) * unit + 0.5)) /
            unit;
    }
}

} // namespace gonio::detail
