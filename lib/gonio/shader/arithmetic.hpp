// What the operations of a graph do with numbers. Masks are 1 and 0.
#pragma once

#include <gonio/shader/graph.hpp>

#include <cmath>

namespace gonio::shader {

// Of one operand, `b` is not looked at; operations on vectors give 0.
template<class T>
T of_numbers(Operation operation, T a, T b) {
    switch (operation) {
    case Operation::add:
        return a + b;
    case Operation::subtract:
        return a - b;
    case Operation::multiply:
        return a * b;
    case Operation::divide:
        return a / b;
    case Operation::negate:
        return -a;
    case Operation::abs:
        return std::fabs(a);
    case Operation::sqrt:
        return std::sqrt(a);
    case Operation::min:
        return a < b ? a : b;
    case Operation::max:
        return a > b ? a : b;
    case Operation::floor:
        return std::floor(a);
    case Operation::exp2:
        return std::exp2(a);
    case Operation::log2:
        return std::log2(a);
    case Operation::less:
        return a < b ? T(1) : T(0);
    case Operation::less_equal:
        return a <= b ? T(1) : T(0);
    case Operation::greater:
        return a > b ? T(1) : T(0);
    case Operation::greater_equal:
        return a >= b ? T(1) : T(0);
    case Operation::equal:
        return a == b ? T(1) : T(0);
    case Operation::both:
        return a != T(0) && b != T(0) ? T(1) : T(0);
    case Operation::either:
        return a != T(0) || b != T(0) ? T(1) : T(0);
    case Operation::invert:
        return a != T(0) ? T(0) : T(1);
    default:
        return T(0);
    }
}

} // namespace gonio::shader
