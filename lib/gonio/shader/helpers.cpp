#include <gonio/shader/helpers.hpp>
// After the recording scalar.
#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/irradiance_named.hpp>

#include <array>
#include <functional>

namespace gonio::shader {

namespace {

struct Body {
    HelperInfo info;
    void (*record)(Function&);
};

constexpr std::array bodies{
    Body{{Helper::atan_series, "atan_series", Type::scalar, "(atan(x) - x)/x^3 for square = x^2 in [0, 1]"},
         [](Function& f) { f.returns(simd::detail::atan_excess_series<Recorded>(f.size("square"))); }},
    Body{{Helper::atanh_ratio, "atanh_ratio", Type::scalar, "atanh(x)/x for square = x^2 in [0, 1/4]"},
         [](Function& f) { f.returns(simd::atanh_ratio<Recorded>(f.size("square"))); }},
    Body{{Helper::arc_tangent, "arc_tangent", Type::scalar, "atan(x) to 3 ulp"},
         [](Function& f) { f.returns(simd::atan<Recorded>(f.scalar("x"))); }},
    Body{{Helper::arc_tangent2, "arc_tangent2", Type::scalar, "The angle of (x, y) in [-pi, pi] to 4 ulp"},
         [](Function& f) {
             const Recorded y = f.scalar("y");
             f.returns(simd::atan2<Recorded>(y, f.scalar("x")));
         }},
    Body{{Helper::angle_above, "angle_above", Type::scalar, "The angle of (x, y) in [0, pi] to 4 ulp, for y >= 0"},
         [](Function& f) {
             const Recorded y = f.size("y");
             f.returns(simd::atan2_above<Recorded>(y, f.scalar("x")));
         }},
    Body{{Helper::arc_cosine, "arc_cosine", Type::scalar, "acos(x) to 3 ulp; |x| above 1 counts as 1"},
         [](Function& f) { f.returns(simd::acos<Recorded>(f.scalar("x"))); }},
    Body{{Helper::sine, "sine", Type::scalar, "sin(x) for |x| up to 8192, to 1.2e-7 and, up to pi/4, 3 ulp"},
         [](Function& f) { f.returns(simd::sin<Recorded>(f.scalar("x"))); }},
    Body{{Helper::cosine, "cosine", Type::scalar, "cos(x) for |x| up to 8192, to 1.2e-7 and, up to pi/4, 2 ulp"},
         [](Function& f) { f.returns(simd::cos<Recorded>(f.scalar("x"))); }},
    Body{{Helper::reciprocal_or_zero, "reciprocal_or_zero", Type::scalar, "1/x, and 0 where x is 0"},
         [](Function& f) { f.returns(shading::reciprocal_or_zero<Recorded>(f.scalar("x"))); }},
    Body{{Helper::normalize_or_zero, "normalize_or_zero", Type::vector, "a/|a|, and 0 where a is 0"},
         [](Function& f) { f.returns(shading::normalized<Recorded>(f.vector("a"))); }},
    Body{{Helper::schlick_weight, "schlick_weight", Type::scalar, "(1 - x)^5 for x in [0, 1]"},
         [](Function& f) { f.returns(shading::schlick_weight<Recorded>(f.scalar("x"))); }},
    Body{{Helper::solid_angle, "solid_angle", Type::scalar,
          "Signed solid angle [sr] of the triangle of three unit vectors (van Oosterom and Strackee 1983)"},
         [](Function& f) {
             const Vector a = f.vector("a");
             const Vector b = f.vector("b");
             f.returns(shading::detail::solid_angle<Recorded>(a, b, f.vector("c")));
         }},
    Body{{Helper::frostbite_cap, "frostbite_cap", Type::scalar,
          "E/L [sr] of a cap from the cosine of its centre and the squared sine of its radius (listing 7)"},
         [](Function& f) {
             const Recorded cosine = f.scalar("cosine");
             f.returns(shading::detail::frostbite_cap<Recorded>(cosine, f.size("square_sine")));
         }},
    Body{{Helper::window_squared, "window_squared", Type::scalar, "(1 - (d/r)^4)^2, and 0 beyond r; 1/r = 0: 1"},
         [](Function& f) {
             const Recorded distance = f.size("distance");
             f.returns(shading::window_squared<Recorded>(distance, f.size("inverse_range")));
         }},
    Body{{Helper::horizon_arc, "horizon_arc", Type::scalar,
          "Half the angle from p to p + offset about the normal, both on the horizon, in [0, pi/2]"},
         [](Function& f) {
             const Vector p = f.vector("p");
             const Vector step = f.vector("offset");
             f.returns(shading::horizon_arc<Recorded>(p, step, f.vector("normal")));
         }},
};

constexpr bool are_in_order() {
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].info.helper != static_cast<Helper>(i)) return false;
    return bodies.size() == helper_count;
}
static_assert(are_in_order());

std::array<Function, bodies.size()> recorded_bodies() {
    std::array<Function, bodies.size()> functions;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        functions[i].name = bodies[i].info.name;
        const Recording recording(functions[i].graph);
        bodies[i].record(functions[i]);
    }
    return functions;
}

void add_helpers(const Function& function, std::vector<Helper>& found) {
    for (const NodeId id : printing_order(function)) {
        const Node& node = function.graph[id];
        if (node.operation != Operation::call) continue;
        const auto helper = static_cast<Helper>(node.index);
        if (std::find(found.begin(), found.end(), helper) != found.end()) continue;
        add_helpers(function_of(helper), found);
        found.push_back(helper);
    }
}

thread_local Graph* open_graph = nullptr;

std::array<NodeId, most_arguments> ids(std::initializer_list<NodeId> arguments) {
    std::array<NodeId, most_arguments> all{no_node, no_node, no_node};
    std::copy(arguments.begin(), arguments.end(), all.begin());
    return all;
}

NodeId call_node(Helper helper, std::initializer_list<NodeId> arguments) {
    return Recording::graph().call(static_cast<std::uint8_t>(helper), info(helper).result, ids(arguments));
}

} // namespace

Recording::Recording(Graph& graph) : before_(open_graph) {
    open_graph = &graph;
}
Recording::~Recording() {
    open_graph = before_;
}
Graph& Recording::graph() {
    return *open_graph;
}

Recorded call(Helper helper, Recorded a, Recorded b, Recorded c) {
    return Recorded::of(call_node(helper, {a.node, b.node, c.node}));
}

const HelperInfo& info(Helper helper) {
    return bodies[static_cast<std::size_t>(helper)].info;
}

const Function& function_of(Helper helper) {
    static const std::array<Function, bodies.size()> functions = recorded_bodies();
    return functions[static_cast<std::size_t>(helper)];
}

std::vector<Helper> helpers_of(std::span<const Function> functions) {
    std::vector<Helper> found;
    for (const Function& function : functions)
        add_helpers(function, found);
    return found;
}

Recorded reciprocal_or_zero(Recorded x) {
    return call(Helper::reciprocal_or_zero, x);
}

} // namespace gonio::shader

namespace gonio::simd {

using shader::Helper;
using shader::Recorded;

namespace {

Recorded call_unless_constant(Helper helper, float (*of)(float), Recorded x) {
    const shader::Graph& graph = shader::Recording::graph();
    if (graph.is_constant(x.node)) return Recorded(of(static_cast<float>(graph[x.node].number)));
    return call(helper, x);
}

} // namespace

Recorded sin(Recorded x) {
    return call_unless_constant(
        Helper::sine, [](float number) { return sin(number); }, x);
}
Recorded cos(Recorded x) {
    return call_unless_constant(
        Helper::cosine, [](float number) { return cos(number); }, x);
}

} // namespace gonio::simd

namespace gonio::shading {

using shader::Helper;
using shader::Recorded;

RecordedVector normalized(RecordedVector a) {
    return RecordedVector::of(shader::call_node(Helper::normalize_or_zero, {a.node()}));
}
Recorded schlick_weight(Recorded x) {
    return call(Helper::schlick_weight, x);
}
Recorded window_squared(Recorded distance, Recorded inverse_range) {
    return call(Helper::window_squared, distance, inverse_range);
}
Recorded horizon_arc(RecordedVector p, RecordedVector step, RecordedVector normal) {
    return Recorded::of(shader::call_node(Helper::horizon_arc, {p.node(), step.node(), normal.node()}));
}

namespace detail {

Recorded solid_angle(RecordedVector a, RecordedVector b, RecordedVector c) {
    return Recorded::of(shader::call_node(Helper::solid_angle, {a.node(), b.node(), c.node()}));
}
Recorded frostbite_cap(Recorded cosine, Recorded square_sine) {
    return call(Helper::frostbite_cap, cosine, square_sine);
}

} // namespace detail

} // namespace gonio::shading
