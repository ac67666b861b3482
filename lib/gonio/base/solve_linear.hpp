// Small dense systems of linear equations, for the programs that fit this tree's tables and polynomials.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace gonio {

// Solves a x = b for x by Gaussian elimination with partial pivoting, in any scalar that has + − × ÷ and <. `a` is
// square with rows as long as b; a singular `a` gives values that are not finite. n³/3 multiplications.
template<typename Real>
std::vector<Real> solve_linear(std::vector<std::vector<Real>> a, std::vector<Real> b) {
    const std::size_t n = b.size();
    const auto magnitude = [](const Real& x) { return x < 0 ? -x : x; };
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (magnitude(a[i][k]) > magnitude(a[pivot][k])) pivot = i;
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const Real factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j)
                a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j)
            b[k] -= a[k][j] * b[j];
        b[k] /= a[k][k];
    }
    return b;
}

} // namespace gonio
