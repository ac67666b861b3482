// Loops over constant tables, and the sums that they build.
//
// For numbers and packs they are plain loops. A scalar that records what is computed with it (shader/) has its own,
// which record the body once; a template that should be recorded as a loop says so with these names.
#pragma once

#include <gonio/simd/math.hpp>

#include <cstddef>

namespace gonio::simd {

// Whether loops over this scalar are recorded, so that their bodies run once and must not count.
template<class S>
inline constexpr bool is_recorded = false;

// work(element) for each element of a table. When it is recorded, the element's numbers are scalars.
template<class S, class Element, std::size_t count, class Work>
GONIO_FORCE_INLINE void for_each_of(const Element (&table)[count], const Work& work) {
    for (const Element& element : table)
        work(element);
}

// Adds to a total that begins before the loops around it.
template<class S>
GONIO_FORCE_INLINE void accumulate(S& total, S term) {
    total = total + term;
}
template<class S>
GONIO_FORCE_INLINE void accumulate_product(S& total, S a, S b) {
    total = mul_add(a, b, total);
}

} // namespace gonio::simd
