#include "columns.hpp"

#include <gonio/scene/probe.hpp>
#include <gonio/shading/kernels_reflectance.hpp>

#include "failed.hpp"

#include <cmath>
#include <cstring>
#include <optional>
#include <string>

namespace gonio::python {

namespace {

using Four = float __attribute__((vector_size(16)));

Four four_at(const float* from) {
    Four value;
    std::memcpy(&value, from, sizeof value);
    return value;
}
void put(const Four& value, float* to) {
    std::memcpy(to, &value, sizeof value);
}

} // namespace

void rows_to_columns(const float* rows, std::size_t count, float* x, float* y, float* z) {
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        const Four a = four_at(rows + 3 * i);                         // x0 y0 z0 x1
        const Four b = four_at(rows + 3 * i + 4);                     // y1 z1 x2 y2
        const Four c = four_at(rows + 3 * i + 8);                     // z2 x3 y3 z3
        const Four late = __builtin_shufflevector(b, c, 2, 3, 5, 6);  // x2 y2 x3 y3
        const Four early = __builtin_shufflevector(a, b, 1, 2, 4, 5); // y0 z0 y1 z1
        put(__builtin_shufflevector(a, late, 0, 3, 4, 6), x + i);
        put(__builtin_shufflevector(early, late, 0, 2, 5, 7), y + i);
        put(__builtin_shufflevector(early, c, 1, 3, 4, 7), z + i);
    }
    for (; i < count; ++i) {
        x[i] = rows[3 * i];
        y[i] = rows[3 * i + 1];
        z[i] = rows[3 * i + 2];
    }
}

void columns_to_rows(const float* x, const float* y, const float* z, std::size_t count, float* rows) {
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        const Four xs = four_at(x + i);
        const Four ys = four_at(y + i);
        const Four zs = four_at(z + i);
        const Four even = __builtin_shufflevector(xs, ys, 0, 2, 4, 6); // x0 x2 y0 y2
        const Four odd = __builtin_shufflevector(ys, zs, 1, 3, 5, 7);  // y1 y3 z1 z3
        const Four rest = __builtin_shufflevector(zs, xs, 0, 2, 5, 7); // z0 z2 x1 x3
        put(__builtin_shufflevector(even, rest, 0, 2, 4, 6), rows + 3 * i);
        put(__builtin_shufflevector(odd, even, 0, 2, 5, 7), rows + 3 * i + 4);
        put(__builtin_shufflevector(rest, odd, 1, 3, 5, 7), rows + 3 * i + 8);
    }
    for (; i < count; ++i) {
        rows[3 * i] = x[i];
        rows[3 * i + 1] = y[i];
        rows[3 * i + 2] = z[i];
    }
}

void make_unit(std::size_t size, Room& room, const float* (&columns)[3], const char* name) {
    if (shading::reflectance_kernels(simd::best_available()).are_unit(columns, size)) return;
    for (std::size_t i = 0; i < size; ++i) {
        const float x = columns[0][i], y = columns[1][i], z = columns[2][i];
        const float square = x * x + y * y + z * z;
        float unit[3];
        if (square > 1e-30F && square < 1e30F) {
            const float inverse = 1.0F / std::sqrt(square);
            unit[0] = x * inverse;
            unit[1] = y * inverse;
            unit[2] = z * inverse;
        } else {
            const std::optional<glm::dvec3> exact = unit_vector({x, y, z});
            if (!exact) throw Failed{fail("USE0105", std::string(name) + " must be finite and longer than 0").value()};
            for (int k = 0; k < 3; ++k)
                unit[k] = static_cast<float>((*exact)[k]);
        }
        for (std::size_t k = 0; k < 3; ++k)
            room.column(k)[i] = unit[k];
    }
    for (std::size_t k = 0; k < 3; ++k)
        columns[k] = room.column(k);
}

} // namespace gonio::python
