// A function of a shader: its parameters, what it computes, and in which order results are known.
#pragma once

#include <gonio/shader/recorded.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace gonio::shader {

using Vector = shading::vec3<Recorded>;

struct Parameter {
    std::string_view name;
    Type type;
    std::string_view meaning; // with its unit and domain
    bool is_used = true;      // else it is not printed; inputs have it all the same
};

// Where `condition` holds, the result is `value`; the last stage has no condition.
struct Stage {
    NodeId condition;
    NodeId value;
    std::string_view comment; // what the condition means
};

struct Function {
    std::string name;
    Type result = Type::scalar;
    std::vector<Parameter> parameters;
    Graph graph;
    std::vector<Stage> stages;
    std::unordered_map<NodeId, std::string> names; // of nodes that a reader knows by name; looked up only
    std::unordered_map<NodeId, std::string_view> notes;

    // The parameters, in their order, while the function is recorded.
    Recorded scalar(std::string_view parameter, std::string_view meaning = {});
    Recorded size(std::string_view parameter, std::string_view meaning = {}); // never negative
    Vector vector(std::string_view parameter, std::string_view meaning = {});
    Vector unit(std::string_view parameter, std::string_view meaning = {}); // of length 1

    // Gives nodes their names, if they are neither a parameter nor a constant. A note is a comment before its line.
    void label(std::string_view as, Recorded value, std::string_view note = {});
    void label(std::string_view as, Vector value, std::string_view note = {});
    void label(std::string_view as, RecordedMask value, std::string_view note = {});

    // What is recorded from here to returns() may rely on the condition not holding.
    void early(RecordedMask condition, Recorded value, std::string_view comment);
    void returns(Recorded value);
    void returns(Vector value);

    // The stages as one expression of selects.
    void join_stages();
    // Finds parameters that the result does not depend on.
    void mark_unused_parameters();

private:
    void label_node(std::string_view as, NodeId node, std::string_view note);
};

// The nodes that the result needs, each after those that it needs, in an order that the expressions alone decide:
// compilers record the two sides of an operator in different orders.
std::vector<NodeId> printing_order(const Function& function);
// How many operations a call runs that does not return early, with those of the helpers it calls: no constant,
// parameter, component or pack of three scalars counts, and the body of a loop once for each row.
std::size_t operation_count(const Function& function);

} // namespace gonio::shader
