// One expression graph: what a formula computes, as nodes that are shared where they are equal.
//
// A node's arguments come before it, so the order of the nodes is an order of evaluation. Equal expressions are one
// node, constants are folded, and identities are simplified only where the result stays the same for finite numbers; of
// a zero the sign may change, which no formula reads. Nothing fails.
//
// A loop runs over the rows of a table of constants. What depends on its row is computed in the loop, and leaves it as
// a sum over all rows. Loops over the same table at the same depth are the same, so that sums of them can share one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace gonio::shader {

enum class Type : std::uint8_t { scalar, vector, mask };

// What a node computes. Operations on scalars also take vectors, component by component, and a scalar then counts for
// each component.
enum class Operation : std::uint8_t {
    constant,  // of the node's number
    truth,     // a constant mask: number is 0 or 1
    parameter, // of the node's index
    element,   // a number of the row of the loop that is the node's index: number is the column
    component, // of a vector, at the node's index
    pack,      // a vector of three scalars
    add,
    subtract,
    multiply,
    divide,
    negate,
    abs,
    sqrt,
    min,
    max,
    floor,
    exp2,
    log2,
    dot,
    cross,
    length,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    both,
    either,
    invert, // of a mask
    select, // mask, if true, if false
    sum,    // of its argument over the rows of the loop that is the node's index
    call    // the helper of the node's index
};

// How an operation is written: between its arguments, as a function, or in its own way.
enum class Form : std::uint8_t { leaf, infix, function, other };

struct OperationInfo {
    Operation operation;
    Form form;
    std::uint8_t arguments;
    std::string_view spelling; // the same in all languages
};

const OperationInfo& info(Operation operation);

using NodeId = std::uint32_t;
inline constexpr NodeId no_node = 0xFFFFFFFFU;

struct Node {
    Operation operation;
    Type type;
    std::uint8_t index = 0;
    std::array<NodeId, 3> arguments{no_node, no_node, no_node};
    double number = 0.0; // of a parameter: 1 if it is never negative, or a unit vector

    bool operator==(const Node&) const = default;
    std::size_t argument_count() const;
};

// The largest number of arguments of a helper.
inline constexpr std::size_t most_arguments = 3;

// A set of loops, by bits.
using LoopSet = std::uint32_t;

// A column of a table.
struct Column {
    std::string_view name;
    std::vector<double> numbers;
    bool operator==(const Column&) const = default;
};

// A loop over the rows of a table.
struct Loop {
    std::vector<Column> columns;
    unsigned depth; // how many loops over the same table are around it

    std::size_t rows() const { return columns.front().numbers.size(); }
    bool operator==(const Loop&) const = default;
};

class Graph {
public:
    const std::vector<Node>& nodes() const { return nodes_; }
    const Node& operator[](NodeId id) const { return nodes_[id]; }

    NodeId constant(double number);
    // Any power of two: 1, and a power of two times it is it again.
    NodeId free_scale();
    NodeId truth(bool value);
    NodeId parameter(std::uint8_t index, Type type, bool never_negative_or_unit);
    NodeId unary(Operation operation, NodeId a);
    NodeId binary(Operation operation, NodeId a, NodeId b);
    NodeId select(NodeId condition, NodeId if_true, NodeId if_false);
    NodeId component(NodeId vector, std::uint8_t index);
    // A vector of three scalars; where they are one operation on the components of vectors, that operation on vectors.
    NodeId pack(NodeId x, NodeId y, NodeId z);
    NodeId call(std::uint8_t helper, Type result, const std::array<NodeId, most_arguments>& arguments);

    // Until its end, elements of the loop can be read, and sums are over its rows too.
    std::uint8_t begin_loop(std::vector<Column> columns);
    void end_loop();
    NodeId element(std::uint8_t loop, std::size_t column);
    // Over the rows of all loops that have begun, so a total begins before the outermost of them.
    NodeId sum(NodeId term);
    const std::vector<Loop>& loops() const { return loops_; }
    // The loops in which a node has to be computed.
    LoopSet loops_around(NodeId id) const { return around_[id]; }

    // From here on, a mask is known: what is recorded with it is simplified.
    void assume(NodeId mask, bool value);
    // From here on, no mask is.
    void forget_assumptions() { assumed_.clear(); }

    bool is_constant(NodeId id) const { return nodes_[id].operation == Operation::constant; }
    bool is_constant(NodeId id, double number) const { return is_constant(id) && nodes_[id].number == number; }
    bool is_at_least(NodeId id, double number) const { return is_constant(id) && nodes_[id].number >= number; }
    bool is_truth(NodeId id, bool value) const {
        return nodes_[id].operation == Operation::truth && (nodes_[id].number != 0.0) == value;
    }

private:
    NodeId add(const Node& node);
    NodeId known_truth(NodeId mask); // a constant if the mask is assumed
    NodeId add_simplified(NodeId a, NodeId b);
    NodeId subtract_simplified(NodeId a, NodeId b);
    NodeId multiply_simplified(NodeId a, NodeId b);
    NodeId divide_simplified(NodeId a, NodeId b);
    NodeId limit_simplified(Operation operation, NodeId a, NodeId b);
    NodeId logical(Operation operation, NodeId a, NodeId b);
    NodeId packed(const std::array<NodeId, 3>& components); // no_node if they are not one operation
    Type joined(NodeId a, NodeId b) const;
    NodeId zero_like(NodeId a);
    bool is_zero_vector(NodeId id) const;
    bool is_uniform(NodeId id) const; // a vector of three equal numbers
    bool is_free_scale(NodeId id) const { return is_constant(id) && nodes_[id].index != 0; }
    bool is_never_negative(NodeId id) const;
    bool is_negated(NodeId id) const { return nodes_[id].operation == Operation::negate; }

    struct Hash {
        std::size_t operator()(const Node& node) const;
    };
    std::vector<Node> nodes_;
    std::vector<LoopSet> around_;                  // of each node
    std::unordered_map<Node, NodeId, Hash> known_; // looked up only, never walked
    std::unordered_map<NodeId, bool> assumed_;     // looked up only
    std::vector<Loop> loops_;
    std::vector<std::uint8_t> begun_; // the outermost first
};

} // namespace gonio::shader
