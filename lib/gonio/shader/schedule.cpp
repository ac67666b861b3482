#include <gonio/shader/schedule.hpp>

#include <algorithm>

namespace gonio::shader {

namespace {

class Scheduler {
public:
    Scheduler(const Graph& graph, const std::vector<NodeId>& order) : graph_(graph), order_(order) {}

    // Inside the loops of `open`.
    std::vector<Step> steps(const std::vector<bool>& which, std::vector<bool>& done, LoopSet open) const {
        std::vector<Step> all;
        for (const NodeId id : order_) {
            if (!which[id] || done[id] || (graph_.loops_around(id) & ~open) != 0) continue;
            if (graph_[id].operation == Operation::sum) {
                add_loop(all, id, which, done, open);
                continue;
            }
            all.push_back({id, 0, {}, {}});
            done[id] = true;
        }
        return all;
    }

private:
    bool is_open_sum(NodeId id, std::uint8_t loop, const std::vector<bool>& done, LoopSet open) const {
        const Node& node = graph_[id];
        return node.operation == Operation::sum && node.index == loop && !done[id] &&
               (graph_.loops_around(id) & ~open) == 0;
    }

    void add_loop(std::vector<Step>& all, NodeId first, const std::vector<bool>& which, std::vector<bool>& done,
                  LoopSet open) const {
        Step step;
        step.loop = graph_[first].index;
        std::vector<NodeId> terms;
        for (const NodeId id : order_) {
            if (!which[id] || !is_open_sum(id, step.loop, done, open)) continue;
            const std::vector<bool> needed = needed_by(graph_, {graph_[id].arguments[0]});
            if (std::any_of(order_.begin(), order_.end(),
                            [&](NodeId each) { return needed[each] && is_open_sum(each, step.loop, done, open); }))
                continue;
            step.sums.push_back(id);
            terms.push_back(graph_[id].arguments[0]);
        }
        const std::vector<bool> needed = needed_by(graph_, terms);
        std::vector<Step> before = steps(needed, done, open);
        all.insert(all.end(), std::make_move_iterator(before.begin()), std::make_move_iterator(before.end()));
        std::vector<bool> done_inside = done;
        step.body = steps(needed, done_inside, open | (LoopSet{1} << step.loop));
        for (const NodeId id : step.sums)
            done[id] = true;
        all.push_back(std::move(step));
    }

    const Graph& graph_;
    const std::vector<NodeId>& order_;
};

} // namespace

std::vector<Step> schedule(const Function& function, const std::vector<NodeId>& order, const std::vector<bool>& which,
                           std::vector<bool>& done) {
    return Scheduler(function.graph, order).steps(which, done, 0);
}

std::vector<bool> needed_by(const Graph& graph, const std::vector<NodeId>& roots) {
    std::vector<bool> needed(graph.nodes().size(), false);
    for (const NodeId root : roots)
        if (root != no_node) needed[root] = true;
    for (std::size_t id = needed.size(); id-- > 0;) {
        if (!needed[id]) continue;
        const Node& node = graph.nodes()[id];
        for (std::size_t k = 0; k < node.argument_count(); ++k)
            needed[node.arguments[k]] = true;
    }
    return needed;
}

} // namespace gonio::shader
