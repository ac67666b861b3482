// When the nodes of a function are computed: those that change in a loop inside it, others before it.
#pragma once

#include <gonio/shader/function.hpp>

#include <cstdint>
#include <vector>

namespace gonio::shader {

// A node that is computed, or a loop that is run for its sums.
struct Step {
    NodeId node = no_node;
    std::uint8_t loop = 0;    // if `node` is no_node
    std::vector<NodeId> sums; // of the loop
    std::vector<Step> body;   // what their terms need in each row
};

// The nodes of `order` (printing_order()) that are in `which` and not in `done`, which they are afterwards. Sums of one
// loop share it, unless one needs the other.
std::vector<Step> schedule(const Function& function, const std::vector<NodeId>& order, const std::vector<bool>& which,
                           std::vector<bool>& done);

// The nodes that any of `roots` needs, those included; no_node is skipped.
std::vector<bool> needed_by(const Graph& graph, const std::vector<NodeId>& roots);

} // namespace gonio::shader
