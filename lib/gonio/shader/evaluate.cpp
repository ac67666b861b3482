#include <gonio/shader/arithmetic.hpp>
#include <gonio/shader/evaluate.hpp>
#include <gonio/shader/helpers.hpp>
#include <gonio/shader/schedule.hpp>

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

const Evaluator& evaluator_of(Helper helper) {
    static const std::vector<Evaluator> all = [] {
        std::vector<Evaluator> made;
        for (std::size_t i = 0; i < helper_count; ++i)
            made.emplace_back(function_of(static_cast<Helper>(i)));
        return made;
    }();
    return all[static_cast<std::size_t>(helper)];
}

// Scalars and masks are stored in all three places, so they mix with vectors. `rows` are those of the loops that run.
template<class T>
Value<T> value_of(const Function& function, const Node& node, const std::vector<Value<T>>& values,
                  const std::vector<std::size_t>& rows, std::span<const T> inputs) {
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
    case Operation::element: {
        const Loop& loop = function.graph.loops()[node.index];
        return all_alike(static_cast<T>(loop.columns[static_cast<std::size_t>(node.number)].numbers[rows[node.index]]));
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
        std::array<T, 3 * most_arguments> of_helper{};
        std::size_t count = 0;
        for (std::size_t k = 0; k < node.argument_count(); ++k) {
            const std::size_t size = function.graph[node.arguments[k]].type == Type::vector ? 3U : 1U;
            for (std::size_t i = 0; i < size; ++i)
                of_helper[count++] = argument(k)[i];
        }
        return evaluator_of(static_cast<Helper>(node.index))(std::span<const T>(of_helper.data(), count));
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

template<class T>
void run(const Function& function, const std::vector<Step>& steps, std::vector<Value<T>>& values,
         std::vector<std::size_t>& rows, std::span<const T> inputs) {
    for (const Step& step : steps) {
        if (step.node != no_node) {
            values[step.node] = value_of(function, function.graph[step.node], values, rows, inputs);
            continue;
        }
        for (const NodeId sum : step.sums)
            values[sum] = {};
        for (std::size_t row = 0; row < function.graph.loops()[step.loop].rows(); ++row) {
            rows[step.loop] = row;
            run(function, step.body, values, rows, inputs);
            for (const NodeId sum : step.sums)
                for (std::size_t i = 0; i < 3; ++i)
                    values[sum][i] += values[function.graph[sum].arguments[0]][i];
        }
    }
}

} // namespace

Evaluator::Evaluator(const Function& function) : function_(function) {
    std::vector<bool> done(function.graph.nodes().size(), false);
    steps_ = schedule(function, printing_order(function), std::vector<bool>(done.size(), true), done);
}

template<class T>
std::array<T, 3> Evaluator::operator()(std::span<const T> inputs) const {
    std::vector<Value<T>> values(function_.graph.nodes().size());
    std::vector<std::size_t> rows(function_.graph.loops().size(), 0);
    run<T>(function_, steps_, values, rows, inputs);
    for (const Stage& stage : function_.stages)
        if (stage.condition == no_node || values[stage.condition][0] != T(0)) return values[stage.value];
    return {};
}

template std::array<float, 3> Evaluator::operator()(std::span<const float>) const;
template std::array<double, 3> Evaluator::operator()(std::span<const double>) const;

} // namespace gonio::shader
