#include <gonio/shader/arithmetic.hpp>
#include <gonio/shader/evaluate.hpp>
#include <gonio/shader/helpers.hpp>

#include <cmath>
#include <vector>

namespace gonio::shader {

namespace {

template<class T>
using Value = std::array<T, 3>;

template<class T>
T dot(const Value<T>& a, const Value<T>& b) {
    return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]);
}

template<class T>
Value<T> all_alike(T x) {
    return {x, x, x};
}

// Scalars and masks are stored in all three places, so they mix with vectors.
template<class T>
Value<T> value_of(const Function& function, const Node& node, const std::vector<Value<T>>& values,
                  std::span<const T> inputs) {
    const auto argument = [&](std::size_t k) -> const Value<T>& { return values[node.arguments[k]]; };
    switch (node.operation) {
    case Operation::constant:
    case Operation::truth:
        return all_alike(static_cast<T>(node.number));
    case Operation::parameter: {
        std::size_t at = 0;
        for (std::size_t k = 0; k < node.index; ++k)
            at += function.parameters[k].type == Type::vector ? 3U : 1U;
        if (node.type == Type::vector) return {inputs[at], inputs[at + 1], inputs[at + 2]};
        return all_alike(inputs[at]);
    }
    case Operation::component:
        return all_alike(argument(0)[node.index]);
    case Operation::pack:
        return {argument(0)[0], argument(1)[0], argument(2)[0]};
    case Operation::dot:
        return all_alike(dot(argument(0), argument(1)));
    case Operation::length:
        return all_alike(std::sqrt(dot(argument(0), argument(0))));
    case Operation::cross: {
        const Value<T>& a = argument(0);
        const Value<T>& b = argument(1);
        return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
    case Operation::select:
        return argument(0)[0] != T(0) ? argument(1) : argument(2);
    case Operation::call: {
        const Function& helper = function_of(static_cast<Helper>(node.index));
        std::array<T, 3 * most_arguments> of_helper{};
        std::size_t count = 0;
        for (std::size_t k = 0; k < node.argument_count(); ++k) {
            const std::size_t size = function.graph[node.arguments[k]].type == Type::vector ? 3U : 1U;
            for (std::size_t i = 0; i < size; ++i)
                of_helper[count++] = argument(k)[i];
        }
        return evaluate<T>(helper, std::span<const T>(of_helper.data(), count));
    }
    default: {
        const Value<T>& a = argument(0);
        const Value<T>& b = node.argument_count() > 1 ? argument(1) : a;
        Value<T> result{};
        for (std::size_t i = 0; i < 3; ++i)
            result[i] = of_numbers<T>(node.operation, a[i], b[i]);
        return result;
    }
    }
}

} // namespace

template<class T>
std::array<T, 3> evaluate(const Function& function, std::span<const T> inputs) {
    std::vector<Value<T>> values(function.graph.nodes().size());
    for (const NodeId id : printing_order(function))
        values[id] = value_of(function, function.graph[id], values, inputs);
    for (const Stage& stage : function.stages)
        if (stage.condition == no_node || values[stage.condition][0] != T(0)) return values[stage.value];
    return {};
}

template std::array<float, 3> evaluate(const Function&, std::span<const float>);
template std::array<double, 3> evaluate(const Function&, std::span<const double>);

} // namespace gonio::shader
