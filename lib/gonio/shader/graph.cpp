#include <gonio/shader/arithmetic.hpp>
#include <gonio/shader/graph.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace gonio::shader {

namespace {

constexpr std::array infos{
    OperationInfo{Operation::constant, Form::leaf, 0, ""},
    OperationInfo{Operation::truth, Form::leaf, 0, ""},
    OperationInfo{Operation::parameter, Form::leaf, 0, ""},
    OperationInfo{Operation::element, Form::leaf, 0, ""},
    OperationInfo{Operation::component, Form::other, 1, ""},
    OperationInfo{Operation::pack, Form::other, 3, ""},
    OperationInfo{Operation::add, Form::infix, 2, "+"},
    OperationInfo{Operation::subtract, Form::infix, 2, "-"},
    OperationInfo{Operation::multiply, Form::infix, 2, "*"},
    OperationInfo{Operation::divide, Form::infix, 2, "/"},
    OperationInfo{Operation::negate, Form::other, 1, "-"},
    OperationInfo{Operation::abs, Form::function, 1, "abs"},
    OperationInfo{Operation::sqrt, Form::function, 1, "sqrt"},
    OperationInfo{Operation::min, Form::function, 2, "min"},
    OperationInfo{Operation::max, Form::function, 2, "max"},
    OperationInfo{Operation::floor, Form::function, 1, "floor"},
    OperationInfo{Operation::exp2, Form::function, 1, "exp2"},
    OperationInfo{Operation::log2, Form::function, 1, "log2"},
    OperationInfo{Operation::dot, Form::function, 2, "dot"},
    OperationInfo{Operation::cross, Form::function, 2, "cross"},
    OperationInfo{Operation::length, Form::function, 1, "length"},
    OperationInfo{Operation::less, Form::infix, 2, "<"},
    OperationInfo{Operation::less_equal, Form::infix, 2, "<="},
    OperationInfo{Operation::greater, Form::infix, 2, ">"},
    OperationInfo{Operation::greater_equal, Form::infix, 2, ">="},
    OperationInfo{Operation::equal, Form::infix, 2, "=="},
    OperationInfo{Operation::both, Form::infix, 2, "&&"},
    OperationInfo{Operation::either, Form::infix, 2, "||"},
    OperationInfo{Operation::invert, Form::other, 1, "!"},
    OperationInfo{Operation::select, Form::other, 3, ""},
    OperationInfo{Operation::sum, Form::other, 1, ""},
    OperationInfo{Operation::call, Form::other, 0, ""},
};

constexpr bool are_in_order() {
    for (std::size_t i = 0; i < infos.size(); ++i)
        if (infos[i].operation != static_cast<Operation>(i)) return false;
    return infos.size() == static_cast<std::size_t>(Operation::call) + 1;
}
static_assert(are_in_order());

bool is_power_of_two(double x) {
    int exponent = 0;
    return std::isfinite(x) && std::fabs(std::frexp(x, &exponent)) == 0.5;
}

bool is_comparison(Operation operation) {
    return operation >= Operation::less && operation <= Operation::equal;
}

} // namespace

const OperationInfo& info(Operation operation) {
    return infos[static_cast<std::size_t>(operation)];
}

std::size_t Node::argument_count() const {
    if (operation != Operation::call) return info(operation).arguments;
    std::size_t count = 0;
    while (count < arguments.size() && arguments[count] != no_node)
        ++count;
    return count;
}

std::size_t Graph::Hash::operator()(const Node& node) const {
    std::uint64_t hash =
        (static_cast<std::uint64_t>(node.operation) << 16) ^ (static_cast<std::uint64_t>(node.type) << 8) ^ node.index;
    for (const std::uint64_t part : {std::uint64_t{node.arguments[0]}, std::uint64_t{node.arguments[1]},
                                     std::uint64_t{node.arguments[2]}, __builtin_bit_cast(std::uint64_t, node.number)})
        hash = (hash ^ part) * 0x9E3779B97F4A7C15U + (hash >> 29);
    return static_cast<std::size_t>(hash);
}

NodeId Graph::add(const Node& node) {
    const auto [at, is_new] = known_.try_emplace(node, static_cast<NodeId>(nodes_.size()));
    const NodeId id = at->second;
    if (is_new) {
        nodes_.push_back(node);
        LoopSet around = 0;
        for (std::size_t k = 0; k < node.argument_count(); ++k)
            around |= around_[node.arguments[k]];
        if (node.operation == Operation::element) around |= LoopSet{1} << node.index;
        if (node.operation == Operation::sum) around &= ~(LoopSet{1} << node.index);
        around_.push_back(around);
    }
    return node.type == Type::mask && !assumed_.empty() ? known_truth(id) : id;
}

NodeId Graph::known_truth(NodeId mask) {
    const auto found = assumed_.find(mask);
    return found == assumed_.end() ? mask : truth(found->second);
}

void Graph::assume(NodeId mask, bool value) {
    const Node node = nodes_[mask];
    if (node.operation == Operation::truth) return;
    if (node.operation == Operation::invert) {
        assume(node.arguments[0], !value);
        return;
    }
    assumed_.try_emplace(mask, value);
    if (node.operation == (value ? Operation::both : Operation::either)) {
        assume(node.arguments[0], value);
        assume(node.arguments[1], value);
    }
}

std::uint8_t Graph::begin_loop(std::vector<Column> columns) {
    Loop loop{std::move(columns), 0};
    for (const std::uint8_t each : begun_)
        if (loops_[each].columns == loop.columns) ++loop.depth;
    auto at = std::find(loops_.begin(), loops_.end(), loop);
    if (at == loops_.end()) at = loops_.insert(at, std::move(loop));
    assert(loops_.size() <= 8 * sizeof(LoopSet));
    begun_.push_back(static_cast<std::uint8_t>(at - loops_.begin()));
    return begun_.back();
}

void Graph::end_loop() {
    begun_.pop_back();
}

NodeId Graph::element(std::uint8_t loop, std::size_t column) {
    const std::vector<double>& numbers = loops_[loop].columns[column].numbers;
    if (std::all_of(numbers.begin(), numbers.end(), [&](double each) { return each == numbers.front(); }))
        return constant(numbers.front());
    return add({Operation::element, Type::scalar, loop, {no_node, no_node, no_node}, static_cast<double>(column)});
}

NodeId Graph::sum(NodeId term) {
    NodeId total = term;
    for (std::size_t k = begun_.size(); k-- > 0;) {
        const std::uint8_t loop = begun_[k];
        const bool changes = ((around_[total] >> loop) & 1U) != 0;
        total = changes ? add({Operation::sum, nodes_[total].type, loop, {total, no_node, no_node}, 0.0})
                        : binary(Operation::multiply, constant(static_cast<double>(loops_[loop].rows())), total);
    }
    return total;
}

Type Graph::joined(NodeId a, NodeId b) const {
    return nodes_[a].type == Type::vector || nodes_[b].type == Type::vector ? Type::vector : Type::scalar;
}

NodeId Graph::constant(double number) {
    return add({Operation::constant, Type::scalar, 0, {no_node, no_node, no_node}, number + 0.0}); // −0 is 0
}

NodeId Graph::free_scale() {
    return add({Operation::constant, Type::scalar, 1, {no_node, no_node, no_node}, 1.0});
}

NodeId Graph::truth(bool value) {
    return add({Operation::truth, Type::mask, 0, {no_node, no_node, no_node}, value ? 1.0 : 0.0});
}

NodeId Graph::parameter(std::uint8_t index, Type type, bool never_negative_or_unit) {
    return add({Operation::parameter, type, index, {no_node, no_node, no_node}, never_negative_or_unit ? 1.0 : 0.0});
}

bool Graph::is_zero_vector(NodeId id) const {
    const Node& node = nodes_[id];
    return node.operation == Operation::pack && is_constant(node.arguments[0], 0.0) &&
           is_constant(node.arguments[1], 0.0) && is_constant(node.arguments[2], 0.0);
}

bool Graph::is_uniform(NodeId id) const {
    const Node& node = nodes_[id];
    return node.operation == Operation::pack && node.arguments[0] == node.arguments[1] &&
           node.arguments[0] == node.arguments[2];
}

bool Graph::is_never_negative(NodeId id) const {
    const Node& node = nodes_[id];
    switch (node.operation) {
    case Operation::constant:
        return node.number >= 0.0;
    case Operation::parameter:
        return node.number != 0.0;
    case Operation::abs:
    case Operation::sqrt:
    case Operation::exp2:
    case Operation::length:
        return true;
    case Operation::add:
    case Operation::multiply:
    case Operation::divide:
        return is_never_negative(node.arguments[0]) && is_never_negative(node.arguments[1]);
    default:
        return false;
    }
}

NodeId Graph::zero_like(NodeId a) {
    const NodeId zero = constant(0.0);
    if (nodes_[a].type != Type::vector) return zero;
    return add({Operation::pack, Type::vector, 0, {zero, zero, zero}, 0.0});
}

NodeId Graph::add_simplified(NodeId a, NodeId b) {
    if (is_zero_vector(a) || (is_constant(a, 0.0) && nodes_[b].type == Type::scalar)) return b;
    if (is_zero_vector(b) || (is_constant(b, 0.0) && nodes_[a].type == Type::scalar)) return a;
    if (is_negated(b)) return binary(Operation::subtract, a, nodes_[b].arguments[0]);
    if (is_negated(a)) return binary(Operation::subtract, b, nodes_[a].arguments[0]);
    if (a == b) return binary(Operation::multiply, constant(2.0), a);
    // a + (−2 x) is a − 2 x.
    for (const auto& [product, other] : {std::pair{b, a}, std::pair{a, b}}) {
        const Node node = nodes_[product];
        if (node.operation == Operation::multiply && is_constant(node.arguments[0]) &&
            nodes_[node.arguments[0]].number < 0.0)
            return binary(Operation::subtract, other, unary(Operation::negate, product));
    }
    return no_node;
}

NodeId Graph::subtract_simplified(NodeId a, NodeId b) {
    if (is_zero_vector(b) || (is_constant(b, 0.0) && nodes_[a].type == Type::scalar)) return a;
    if (is_constant(a, 0.0) && nodes_[b].type == Type::scalar) return unary(Operation::negate, b);
    if (is_negated(b)) return binary(Operation::add, a, nodes_[b].arguments[0]);
    if (a == b) return zero_like(a);
    // How math.hpp rounds to the nearest integer; compilers of shaders may cancel the sum.
    constexpr double rounds = 12582912.0; // 1.5·2²³
    const Node sum = nodes_[a];
    if (is_constant(b, rounds) && sum.operation == Operation::add && is_constant(sum.arguments[1], rounds))
        return unary(Operation::floor, binary(Operation::add, sum.arguments[0], constant(0.5)));
    return no_node;
}

NodeId Graph::multiply_simplified(NodeId a, NodeId b) {
    if (is_free_scale(a)) return is_constant(b) && is_power_of_two(nodes_[b].number) ? a : b;
    if (is_constant(b)) return binary(Operation::multiply, b, a); // the constant comes first
    if (is_constant(a, 0.0) || is_zero_vector(b)) return zero_like(b);
    if (is_zero_vector(a)) return a;
    if (is_constant(a, 1.0)) return b;
    if (is_constant(a, -1.0)) return unary(Operation::negate, b);
    if (is_negated(a) && is_negated(b))
        return binary(Operation::multiply, nodes_[a].arguments[0], nodes_[b].arguments[0]);
    if (is_negated(a) && !is_constant(b))
        return unary(Operation::negate, binary(Operation::multiply, nodes_[a].arguments[0], b));
    if (is_negated(b) && is_constant(a))
        return binary(Operation::multiply, constant(-nodes_[a].number), nodes_[b].arguments[0]);
    if (is_negated(b)) return unary(Operation::negate, binary(Operation::multiply, a, nodes_[b].arguments[0]));
    // (−2 x) y is −((2 x) y), for sums to subtract it.
    const Node first = nodes_[a];
    if (first.operation == Operation::multiply && is_constant(first.arguments[0]) &&
        nodes_[first.arguments[0]].number < 0.0)
        return unary(Operation::negate, binary(Operation::multiply, unary(Operation::negate, a), b));
    // 2 (4 x) is 8 x: exact with powers of two.
    const Node inner = nodes_[b];
    if (is_constant(a) && inner.operation == Operation::multiply && is_constant(inner.arguments[0]) &&
        (is_power_of_two(nodes_[a].number) || is_power_of_two(nodes_[inner.arguments[0]].number)))
        return binary(Operation::multiply, constant(nodes_[a].number * nodes_[inner.arguments[0]].number),
                      inner.arguments[1]);
    return no_node;
}

NodeId Graph::divide_simplified(NodeId a, NodeId b) {
    if (is_constant(b, 1.0)) return a;
    if (is_constant(a, 0.0)) return zero_like(b);
    if (is_constant(b) && is_power_of_two(nodes_[b].number))
        return binary(Operation::multiply, constant(1.0 / nodes_[b].number), a);
    if (is_negated(a)) return unary(Operation::negate, binary(Operation::divide, nodes_[a].arguments[0], b));
    return no_node;
}

NodeId Graph::limit_simplified(Operation operation, NodeId a, NodeId b) {
    if (a == b) return a;
    const Node inner = nodes_[a];
    if (inner.operation == operation && is_constant(inner.arguments[1]) && is_constant(b))
        return binary(operation, inner.arguments[0], binary(operation, inner.arguments[1], b));
    return no_node;
}

NodeId Graph::logical(Operation operation, NodeId first, NodeId second) {
    const NodeId a = known_truth(first);
    const NodeId b = known_truth(second);
    const bool ends = operation == Operation::either; // the value that decides alone
    if (is_truth(a, ends) || is_truth(b, ends)) return truth(ends);
    if (is_truth(a, !ends) || a == b) return b;
    if (is_truth(b, !ends)) return a;
    return add({operation, Type::mask, 0, {a, b, no_node}, 0.0});
}

NodeId Graph::unary(Operation operation, NodeId a) {
    const Node node = nodes_[a];
    if (operation == Operation::negate) {
        if (is_constant(a)) return constant(-node.number);
        if (node.operation == Operation::negate) return node.arguments[0];
        if (node.operation == Operation::subtract)
            return binary(Operation::subtract, node.arguments[1], node.arguments[0]);
        if (node.operation == Operation::multiply && is_constant(node.arguments[0]))
            return binary(Operation::multiply, constant(-nodes_[node.arguments[0]].number), node.arguments[1]);
        return add({operation, node.type, 0, {a, no_node, no_node}, 0.0});
    }
    if (operation == Operation::invert) {
        if (node.operation == Operation::truth) return truth(node.number == 0.0);
        if (node.operation == Operation::invert) return node.arguments[0];
        return add({operation, Type::mask, 0, {a, no_node, no_node}, 0.0});
    }
    if (operation == Operation::length) return add({operation, Type::scalar, 0, {a, no_node, no_node}, 0.0});
    if (operation == Operation::abs && is_never_negative(a)) return a;
    if (operation == Operation::abs && node.operation == Operation::negate)
        return unary(Operation::abs, node.arguments[0]);
    if (is_constant(a) &&
        (operation == Operation::abs || operation == Operation::sqrt || operation == Operation::floor))
        return constant(of_numbers(operation, node.number, node.number));
    return add({operation, node.type, 0, {a, no_node, no_node}, 0.0});
}

NodeId Graph::binary(Operation operation, NodeId a, NodeId b) {
    if (operation == Operation::both || operation == Operation::either) return logical(operation, a, b);
    const bool is_scale = is_free_scale(a) || is_free_scale(b);
    if (operation == Operation::multiply && is_free_scale(b)) return multiply_simplified(b, a);
    if (is_constant(a) && is_constant(b) && !is_scale) {
        const double x = nodes_[a].number;
        const double y = nodes_[b].number;
        if (is_comparison(operation)) return truth(of_numbers(operation, x, y) != 0.0);
        return constant(of_numbers(operation, x, y));
    }
    if (is_comparison(operation)) return add({operation, Type::mask, 0, {a, b, no_node}, 0.0});
    if (operation == Operation::dot && a == b && nodes_[a].operation == Operation::parameter && nodes_[a].number != 0.0)
        return constant(1.0);
    if (operation == Operation::dot) return add({operation, Type::scalar, 0, {a, b, no_node}, 0.0});
    NodeId simpler = no_node;
    switch (operation) {
    case Operation::add:
        simpler = add_simplified(a, b);
        break;
    case Operation::subtract:
        simpler = subtract_simplified(a, b);
        break;
    case Operation::multiply:
        simpler = multiply_simplified(a, b);
        break;
    case Operation::divide:
        simpler = divide_simplified(a, b);
        break;
    case Operation::min:
    case Operation::max:
        simpler = limit_simplified(operation, a, b);
        break;
    default:
        break;
    }
    if (simpler != no_node) return simpler;
    return add({operation, operation == Operation::cross ? Type::vector : joined(a, b), 0, {a, b, no_node}, 0.0});
}

NodeId Graph::select(NodeId mask, NodeId if_true, NodeId if_false) {
    const NodeId condition = known_truth(mask);
    if (if_true == if_false || is_truth(condition, true)) return if_true;
    if (is_truth(condition, false)) return if_false;
    if (nodes_[condition].operation == Operation::invert)
        return select(nodes_[condition].arguments[0], if_false, if_true);
    const Type type = nodes_[if_true].type == Type::mask ? Type::mask : joined(if_true, if_false);
    return add({Operation::select, type, 0, {condition, if_true, if_false}, 0.0});
}

NodeId Graph::component(NodeId vector, std::uint8_t index) {
    if (nodes_[vector].operation == Operation::pack) return nodes_[vector].arguments[index];
    if (is_negated(vector)) return unary(Operation::negate, component(nodes_[vector].arguments[0], index));
    // Of three equal numbers times a scalar: that product; of a choice between two such vectors: the choice.
    const Node node = nodes_[vector];
    if (node.operation == Operation::select && is_uniform(node.arguments[1]) && is_uniform(node.arguments[2]))
        return select(node.arguments[0], nodes_[node.arguments[1]].arguments[0],
                      nodes_[node.arguments[2]].arguments[0]);
    if (node.operation == Operation::multiply && is_uniform(node.arguments[0]) &&
        nodes_[node.arguments[1]].type == Type::scalar)
        return binary(Operation::multiply, nodes_[node.arguments[0]].arguments[0], node.arguments[1]);
    return add({Operation::component, Type::scalar, index, {vector, no_node, no_node}, 0.0});
}

NodeId Graph::packed(const std::array<NodeId, 3>& components) {
    if (components[0] == components[1] && components[0] == components[2]) return components[0];
    const Node first = nodes_[components[0]];
    if (first.operation == Operation::component) {
        for (std::uint8_t i = 0; i < 3; ++i) {
            const Node& each = nodes_[components[i]];
            if (each.operation != Operation::component || each.index != i || each.arguments[0] != first.arguments[0])
                return no_node;
        }
        return first.arguments[0];
    }
    const bool by_component = (first.operation >= Operation::add && first.operation <= Operation::log2) ||
                              first.operation == Operation::select;
    if (!by_component) return no_node;
    std::array<NodeId, 3> joint{no_node, no_node, no_node};
    for (std::size_t k = 0; k < first.argument_count(); ++k) {
        std::array<NodeId, 3> arguments{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Node& each = nodes_[components[i]];
            if (each.operation != first.operation) return no_node;
            arguments[i] = each.arguments[k];
        }
        joint[k] = packed(arguments);
        if (joint[k] == no_node) return no_node;
    }
    if (first.operation == Operation::select)
        return nodes_[joint[0]].type == Type::mask ? select(joint[0], joint[1], joint[2]) : no_node;
    return first.argument_count() == 1 ? unary(first.operation, joint[0]) : binary(first.operation, joint[0], joint[1]);
}

NodeId Graph::pack(NodeId x, NodeId y, NodeId z) {
    const NodeId joint = packed({x, y, z});
    if (joint != no_node && nodes_[joint].type == Type::vector) return joint;
    return add({Operation::pack, Type::vector, 0, {x, y, z}, 0.0});
}

NodeId Graph::call(std::uint8_t helper, Type result, const std::array<NodeId, most_arguments>& arguments) {
    return add({Operation::call, result, helper, arguments, 0.0});
}

} // namespace gonio::shader
