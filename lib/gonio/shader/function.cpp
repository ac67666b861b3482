#include <gonio/shader/function.hpp>
#include <gonio/shader/helpers.hpp>
#include <gonio/shader/schedule.hpp>

#include <algorithm>

namespace gonio::shader {

namespace {

template<class Add>
auto next_parameter(Function& function, std::string_view name, Type type, std::string_view meaning, const Add& add) {
    const auto index = static_cast<std::uint8_t>(function.parameters.size());
    function.parameters.push_back({name, type, meaning, true});
    return add(index);
}

} // namespace

Recorded Function::scalar(std::string_view parameter, std::string_view meaning) {
    return next_parameter(*this, parameter, Type::scalar, meaning, [&](std::uint8_t index) {
        return Recorded::of(graph.parameter(index, Type::scalar, false));
    });
}

Recorded Function::size(std::string_view parameter, std::string_view meaning) {
    return next_parameter(*this, parameter, Type::scalar, meaning,
                          [&](std::uint8_t index) { return Recorded::of(graph.parameter(index, Type::scalar, true)); });
}

Vector Function::vector(std::string_view parameter, std::string_view meaning) {
    return next_parameter(*this, parameter, Type::vector, meaning,
                          [&](std::uint8_t index) { return Vector::of(graph.parameter(index, Type::vector, false)); });
}

Vector Function::unit(std::string_view parameter, std::string_view meaning) {
    return next_parameter(*this, parameter, Type::vector, meaning,
                          [&](std::uint8_t index) { return Vector::of(graph.parameter(index, Type::vector, true)); });
}

void Function::label_node(std::string_view as, NodeId node, std::string_view note) {
    const Operation operation = graph[node].operation;
    if (operation == Operation::parameter || operation == Operation::constant || operation == Operation::component ||
        operation == Operation::truth)
        return;
    names.try_emplace(node, as);
    if (!note.empty()) notes.try_emplace(node, note);
}

void Function::label(std::string_view as, Recorded value, std::string_view note) {
    label_node(as, value.node, note);
}
void Function::label(std::string_view as, Vector value, std::string_view note) {
    label_node(as, value.node(), note);
}
void Function::label(std::string_view as, RecordedMask value, std::string_view note) {
    label_node(as, value.node, note);
}

void Function::early(RecordedMask condition, Recorded value, std::string_view comment) {
    stages.push_back({condition.node, value.node, comment});
    graph.assume(condition.node, false);
}
void Function::returns(Recorded value) {
    result = Type::scalar;
    stages.push_back({no_node, value.node, {}});
    graph.forget_assumptions();
}
void Function::returns(Vector value) {
    result = Type::vector;
    stages.push_back({no_node, value.node(), {}});
    graph.forget_assumptions();
}

void Function::join_stages() {
    NodeId value = stages.back().value;
    for (std::size_t i = stages.size() - 1; i > 0; --i)
        value = graph.select(stages[i - 1].condition, stages[i - 1].value, value);
    stages = {{no_node, value, {}}};
}

void Function::mark_unused_parameters() {
    for (Parameter& parameter : parameters)
        parameter.is_used = false;
    for (const NodeId id : printing_order(*this))
        if (graph[id].operation == Operation::parameter) parameters[graph[id].index].is_used = true;
}

std::vector<NodeId> printing_order(const Function& function) {
    std::vector<NodeId> order;
    std::vector<bool> is_seen(function.graph.nodes().size(), false);
    struct Open {
        NodeId node;
        std::size_t next; // of its arguments
    };
    std::vector<Open> open;
    const auto enter = [&](NodeId node) {
        if (node == no_node || is_seen[node]) return;
        is_seen[node] = true;
        open.push_back({node, 0});
    };
    const auto walk = [&](NodeId root) {
        enter(root);
        while (!open.empty()) {
            Open& last = open.back();
            const Node& node = function.graph[last.node];
            if (last.next < node.argument_count()) {
                enter(node.arguments[last.next++]);
                continue;
            }
            order.push_back(last.node);
            open.pop_back();
        }
    };
    for (const Stage& stage : function.stages) {
        walk(stage.condition);
        walk(stage.value);
    }
    return order;
}

std::size_t operation_count(const Function& function) {
    const Graph& graph = function.graph;
    std::vector<NodeId> roots{function.stages.back().value};
    for (const Stage& stage : function.stages)
        roots.push_back(stage.condition);
    const std::vector<bool> needed = needed_by(graph, roots);
    std::size_t count = 0;
    for (NodeId id = 0; id < needed.size(); ++id) {
        const Node& node = graph[id];
        if (!needed[id] || node.operation <= Operation::pack) continue;
        // The terms of a sum are added in its loop.
        const LoopSet around = graph.loops_around(node.operation == Operation::sum ? node.arguments[0] : id);
        std::size_t times = 1;
        for (std::size_t loop = 0; loop < graph.loops().size(); ++loop)
            if (((around >> loop) & 1U) != 0) times *= graph.loops()[loop].rows();
        const bool is_call = node.operation == Operation::call;
        count += times * (is_call ? operation_count(function_of(static_cast<Helper>(node.index))) : 1);
    }
    return count;
}

} // namespace gonio::shader
