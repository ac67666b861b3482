#include <gonio/base/version.hpp>
#include <gonio/shader/helpers.hpp>
#include <gonio/shader/print.hpp>
#include <gonio/shader/schedule.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gonio::shader {

namespace {

// How a language writes what the languages write differently.
struct Words {
    ShaderLanguage language;
    std::array<std::string_view, 3> types; // by Type
    std::string_view after_number;
    std::string_view before_function;
    std::string_view before_table; // empty: tables are variables of the functions that read them
    std::string_view prelude;
};

constexpr std::array all_words{
    Words{ShaderLanguage::glsl_es300,
          {"float", "vec3", "bool"},
          "",
          "",
          "const",
          "// GLSL ES 3.00, for a shader that begins with #version 300 es.\n\nprecision highp float;\n"},
    Words{ShaderLanguage::glsl450, {"float", "vec3", "bool"}, "", "", "const", "// GLSL 4.50.\n"},
    Words{ShaderLanguage::hlsl,
          {"float", "float3", "bool"},
          "f",
          "",
          "static const",
          "// HLSL, shader model 5 and later.\n"},
    Words{ShaderLanguage::msl,
          {"float", "float3", "bool"},
          "f",
          "inline ",
          "static constant",
          "// Metal Shading Language.\n\n#include <metal_stdlib>\nusing namespace metal;\n"},
    Words{ShaderLanguage::wgsl, {"f32", "vec3<f32>", "bool"}, "", "", "const", "// WGSL.\n"},
    Words{ShaderLanguage::osl, {"float", "vector", "int"}, "", "", "", "// Open Shading Language.\n"},
};

// Types of the Open Shading Language that parameters are called elsewhere.
constexpr std::array reserved_in_osl{"normal", "point", "color", "output"};

std::string name_in(ShaderLanguage language, std::string_view name) {
    const bool is_reserved = language == ShaderLanguage::osl &&
                             std::find(reserved_in_osl.begin(), reserved_in_osl.end(), name) != reserved_in_osl.end();
    return std::string(name) + (is_reserved ? "_" : "");
}

constexpr std::size_t widest = 100;      // columns
constexpr std::size_t longest_text = 80; // of an expression

// How strongly an operator binds.
enum Binding : int { ternary, logical, comparison, sum, product, sign, primary };

struct Text {
    std::string text;
    Binding binding = primary;
};

Binding binding_of(Operation operation) {
    switch (operation) {
    case Operation::add:
    case Operation::subtract:
        return sum;
    case Operation::multiply:
    case Operation::divide:
        return product;
    case Operation::both:
    case Operation::either:
        return logical;
    default:
        return comparison;
    }
}

bool is_leaf(Operation operation) {
    return info(operation).form == Form::leaf || operation == Operation::component;
}

// Lines of a comment, wrapped.
std::string comment(std::string_view text, std::string_view first = "// ", std::string_view next = "// ") {
    std::string lines;
    std::string line(first);
    bool is_empty = true;
    while (!text.empty()) {
        const std::size_t space = text.find(' ');
        const std::string_view word = text.substr(0, space);
        text = space == std::string_view::npos ? std::string_view{} : text.substr(space + 1);
        if (!is_empty && line.size() + 1 + word.size() > widest) {
            lines += line + "\n";
            line = next;
            is_empty = true;
        }
        if (!is_empty) line += ' ';
        line += word;
        is_empty = false;
    }
    return lines + line + "\n";
}

std::string number_text(double value, const Words& words) {
    std::string text = fmt::format("{}", static_cast<float>(value)); // as few digits as read back as it
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    const std::size_t exponent = text.find("e-0"); // 1e-04 is 1e-4
    if (exponent != std::string::npos) text.erase(exponent + 2, 1);
    return text + std::string(words.after_number);
}

// The tables that loops read, in the order in which functions ask for them: equal ones once.
class Tables {
public:
    std::string name_of(const Column& column) {
        const auto known =
            std::find_if(all_.begin(), all_.end(), [&](const Table& each) { return each.numbers == column.numbers; });
        if (known != all_.end()) return known->name;
        const std::string stem = fmt::format("{}_{}", column.name, column.numbers.size());
        std::string name = stem;
        for (char letter = 'b';
             std::any_of(all_.begin(), all_.end(), [&](const Table& each) { return each.name == name; }); ++letter)
            name = stem + letter;
        all_.push_back({std::move(name), column.numbers});
        return all_.back().name;
    }
    std::string print(const Words& words) const {
        std::string text;
        const std::string_view type = words.types[static_cast<std::size_t>(Type::scalar)];
        for (const Table& table : all_) {
            const std::size_t size = table.numbers.size();
            const std::string indent = words.before_table.empty() ? "    " : "";
            std::string line = words.before_table.empty() ? indent : std::string(words.before_table) + " ";
            switch (words.language) {
            case ShaderLanguage::wgsl:
                line += fmt::format("{} = array<f32, {}>(", table.name, size);
                break;
            case ShaderLanguage::glsl_es300:
            case ShaderLanguage::glsl450:
                line += fmt::format("{0} {1}[{2}] = {0}[{2}](", type, table.name, size);
                break;
            case ShaderLanguage::hlsl:
            case ShaderLanguage::msl:
            case ShaderLanguage::osl:
                line += fmt::format("{} {}[{}] = {{", type, table.name, size);
                break;
            }
            text += listed(line, indent + "    ", table, line.back() == '{' ? "};" : ");", words);
        }
        return text;
    }

private:
    struct Table {
        std::string name;
        std::vector<double> numbers;
    };
    static std::string listed(std::string line, const std::string& indent, const Table& table, std::string_view end,
                              const Words& words) {
        std::string lines;
        const std::size_t size = table.numbers.size();
        for (std::size_t i = 0; i < size; ++i) {
            const std::string part = number_text(table.numbers[i], words) + std::string(i + 1 == size ? end : ",");
            if (line.size() + 1 + part.size() > widest) {
                lines += line + "\n";
                line = indent + part;
            } else {
                line += (i == 0 ? "" : " ") + part;
            }
        }
        return lines + line + "\n";
    }

    std::vector<Table> all_;
};

class FunctionPrinter {
public:
    FunctionPrinter(const Function& function, const Words& words, Tables& tables)
        : function_(function),
          words_(words),
          tables_(tables),
          order_(printing_order(function)),
          uses_(function.graph.nodes().size(), 0),
          texts_(uses_.size()),
          is_done_(uses_.size(), false),
          enters_loop_(uses_.size(), false) {
        for (const Parameter& parameter : function.parameters)
            taken_.insert(name_of(parameter));
        for (const NodeId id : order_) {
            const Node& node = function.graph[id];
            for (std::size_t k = 0; k < node.argument_count(); ++k) {
                const NodeId argument = node.arguments[k];
                // The Open Shading Language takes components of variables alone.
                uses_[argument] +=
                    node.operation == Operation::component && words.language == ShaderLanguage::osl ? 2U : 1U;
                if ((function.graph.loops_around(id) & ~function.graph.loops_around(argument)) != 0)
                    enters_loop_[argument] = true;
            }
        }
        for (const Stage& stage : function.stages) {
            if (stage.condition != no_node) ++uses_[stage.condition];
            ++uses_[stage.value];
        }
    }

    std::string print() {
        for (std::size_t i = 0; i < function_.stages.size(); ++i)
            print_stage(i);
        return fmt::format("{} {{\n{}{}}}\n", signature(),
                           words_.before_table.empty() ? tables_.print(words_) : std::string(), out_);
    }

private:
    std::string type(Type of) const { return std::string(words_.types[static_cast<std::size_t>(of)]); }
    bool is_wgsl() const { return words_.language == ShaderLanguage::wgsl; }
    std::string name_of(const Parameter& parameter) const { return name_in(words_.language, parameter.name); }

    std::string signature() const {
        std::string line =
            is_wgsl() ? fmt::format("fn {}(", function_.name)
                      : fmt::format("{}{} {}(", words_.before_function, type(function_.result), function_.name);
        const std::string indent(line.size(), ' ');
        const std::string end = is_wgsl() ? fmt::format(") -> {}", type(function_.result)) : ")";
        std::vector<Parameter> used;
        std::copy_if(function_.parameters.begin(), function_.parameters.end(), std::back_inserter(used),
                     [](const Parameter& each) { return each.is_used; });
        std::string lines;
        for (const Parameter& parameter : used) {
            const bool is_last = &parameter == &used.back();
            std::string part = is_wgsl() ? fmt::format("{}: {}", name_of(parameter), type(parameter.type))
                                         : fmt::format("{} {}", type(parameter.type), name_of(parameter));
            part += is_last ? end : ",";
            const bool is_first = line.size() == indent.size();
            if (!is_first && line.size() + 1 + part.size() + 2 > widest) {
                lines += line + "\n";
                line = indent + part;
            } else {
                line += (is_first ? "" : " ") + part;
            }
        }
        return lines + line;
    }

    void print_stage(std::size_t place) {
        const Stage& stage = function_.stages[place];
        const std::vector<bool> of_value = needed_by(function_.graph, {stage.value});
        if (stage.condition == no_node) {
            indent_ = "    ";
            print_nodes(of_value);
            out_ += return_line(stage.value);
            return;
        }
        std::vector<NodeId> roots;
        for (std::size_t i = place + 1; i < function_.stages.size(); ++i) {
            roots.push_back(function_.stages[i].condition);
            roots.push_back(function_.stages[i].value);
        }
        // What the value and later stages need is computed before the condition.
        std::vector<bool> before = needed_by(function_.graph, roots);
        const std::vector<bool> of_condition = needed_by(function_.graph, {stage.condition});
        for (std::size_t id = 0; id < before.size(); ++id)
            before[id] = (before[id] && of_value[id]) || of_condition[id];
        indent_ = "    ";
        print_nodes(before);
        out_ += comment(stage.comment, indent_ + "// ", indent_ + "// ");
        out_ += fmt::format("{}if ({}) {{\n", indent_, texts_[stage.condition].text);
        indent_ = "        ";
        print_nodes(of_value);
        out_ += return_line(stage.value);
        indent_ = "    ";
        out_ += indent_ + "}\n";
    }

    std::string return_line(NodeId value) const {
        const Text& text = texts_[value];
        const bool spreads = function_.result == Type::vector && function_.graph[value].type != Type::vector;
        return fmt::format("{}return {};\n", indent_, spreads ? vector_of(text.text) : text.text);
    }

    void print_nodes(const std::vector<bool>& which) { print_steps(schedule(function_, order_, which, is_done_)); }
    void print_steps(const std::vector<Step>& steps) {
        for (const Step& step : steps) {
            if (step.node == no_node) {
                print_loop(step);
                continue;
            }
            texts_[step.node] = shortened(step.node);
            if (needs_variable(step.node)) declare(step.node);
        }
    }

    void print_loop(const Step& step) {
        const std::string index = new_index();
        for (const NodeId sum : step.sums) {
            const auto outer = total_of_.find(sum);
            if (outer != total_of_.end()) {
                texts_[sum] = texts_[outer->second];
                continue;
            }
            const Type of = function_.graph[sum].type;
            texts_[sum] = {new_name(sum), primary};
            const std::string zero = of == Type::vector ? vector_of(number(0.0)) : number(0.0);
            out_ += fmt::format("{}{} {} = {};\n", indent_, is_wgsl() ? "var" : type(of), texts_[sum].text, zero);
        }
        out_ += is_wgsl() ? fmt::format("{}for (var {} = 0; ", indent_, index)
                          : fmt::format("{}for (int {} = 0; ", indent_, index);
        out_ += fmt::format("{0} < {1}; {2}) {{\n", index, function_.graph.loops()[step.loop].rows(),
                            is_wgsl() ? index + "++" : "++" + index);
        open_loops_.emplace_back(step.loop, index);
        indent_ += "    ";
        for (const NodeId sum : step.sums) {
            const NodeId term = function_.graph[sum].arguments[0];
            if (is_added_directly(term)) total_of_.insert_or_assign(term, sum);
        }
        print_steps(step.body);
        for (const NodeId sum : step.sums) {
            const NodeId term = function_.graph[sum].arguments[0];
            if (!is_added_directly(term))
                out_ += fmt::format("{}{} += {};\n", indent_, texts_[sum].text, texts_[term].text);
        }
        indent_.erase(indent_.size() - 4);
        open_loops_.pop_back();
        out_ += indent_ + "}\n";
    }
    // Another one for each loop: some compilers of HLSL let it live on after its loop.
    std::string new_index() {
        const std::string letter(1, static_cast<char>('i' + static_cast<int>(open_loops_.size())));
        std::string name = letter;
        for (int k = 1; !taken_.insert(name).second; ++k)
            name = fmt::format("{}{}", letter, k);
        return name;
    }
    // Whether an inner loop's sum is only a part of an outer one's, which it adds its terms to.
    bool is_added_directly(NodeId term) const {
        return function_.graph[term].operation == Operation::sum && uses_[term] == 1 && !function_.names.contains(term);
    }

    bool needs_variable(NodeId id) const {
        const Node& node = function_.graph[id];
        if (is_leaf(node.operation)) return false;
        if (function_.names.contains(id)) return true;
        if (is_word(texts_[id].text)) return false;
        if (node.operation == Operation::negate || node.operation == Operation::invert)
            if (is_word(texts_[node.arguments[0]].text)) return false;
        if (node.operation == Operation::pack && is_constant_pack(node)) return false;
        return uses_[id] > 1 || enters_loop_[id];
    }
    bool is_constant_pack(const Node& node) const {
        return std::all_of(node.arguments.begin(), node.arguments.end(),
                           [&](NodeId each) { return function_.graph.is_constant(each); });
    }
    static bool is_word(std::string_view text) { return text.find_first_of(" (") == std::string_view::npos; }

    void declare(NodeId id) {
        const Type of = function_.graph[id].type;
        const std::string name = new_name(id);
        const auto note = function_.notes.find(id);
        if (note != function_.notes.end()) out_ += comment(note->second, indent_ + "// ", indent_ + "// ");
        out_ += is_wgsl() ? fmt::format("{}let {} = {};\n", indent_, name, texts_[id].text)
                          : fmt::format("{}{} {} = {};\n", indent_, type(of), name, texts_[id].text);
        texts_[id] = {name, primary};
    }

    std::string new_name(NodeId id) {
        constexpr std::array<std::string_view, 3> letters{"t", "p", "c"};
        const auto known = function_.names.find(id);
        std::string stem = known != function_.names.end()
                               ? name_in(words_.language, known->second)
                               : std::string(letters[static_cast<std::size_t>(function_.graph[id].type)]);
        if (known != function_.names.end() && taken_.insert(stem).second) return stem;
        for (int i = 1;; ++i) {
            std::string name = fmt::format("{}{}", stem, i);
            if (taken_.insert(name).second) return name;
        }
    }

    // The text of a node; parts of it become variables if it is too long.
    Text shortened(NodeId id) {
        for (;;) {
            Text text = text_of(id);
            if (text.text.size() + indent_.size() <= longest_text) return text;
            NodeId longest = no_node;
            std::size_t length = 20;
            find_longest(id, longest, length);
            if (longest == no_node) return text;
            declare(longest);
        }
    }
    void find_longest(NodeId id, NodeId& longest, std::size_t& length) const {
        const Node& node = function_.graph[id];
        for (std::size_t k = 0; k < node.argument_count(); ++k) {
            const NodeId argument = node.arguments[k];
            if (k == 0 && clamps(node)) { // its text is not printed, but that of its argument is
                find_longest(argument, longest, length);
                continue;
            }
            const std::string& text = texts_[argument].text;
            if (text.size() <= length || is_leaf(function_.graph[argument].operation) || is_word(text)) continue;
            length = text.size();
            longest = argument;
        }
    }

    std::string number(double value) const { return number_text(value, words_); }
    std::string vector_of(const std::string& scalar) const {
        if (words_.language == ShaderLanguage::hlsl) // has no constructor of one number
            return is_word(scalar) ? "(float3)" + scalar : "(float3)(" + scalar + ")";
        return fmt::format("{}({})", type(Type::vector), scalar);
    }

    std::string bound(NodeId id, Binding least) const {
        const Text& text = texts_[id];
        return text.binding >= least ? text.text : "(" + text.text + ")";
    }
    // As an argument of a function that takes arguments of one type.
    std::string argument(NodeId id, Type of) const {
        const bool spreads = of == Type::vector && function_.graph[id].type == Type::scalar;
        return spreads ? vector_of(texts_[id].text) : texts_[id].text;
    }

    bool is_alone(NodeId id) const {
        return uses_[id] == 1 && !function_.names.contains(id) && !is_word(texts_[id].text);
    }

    // Whether it is min(max(x, low), high) or max(min(x, high), low), with numbers for low and high: clamp(x, low,
    // high).
    bool clamps(const Node& node) const {
        const bool is_min = node.operation == Operation::min;
        if (!is_min && node.operation != Operation::max) return false;
        const NodeId inner = node.arguments[0];
        return function_.graph[inner].operation == (is_min ? Operation::max : Operation::min) && uses_[inner] == 1 &&
               !function_.names.contains(inner) && !is_word(texts_[inner].text) &&
               function_.graph.is_constant(node.arguments[1]) &&
               function_.graph.is_constant(function_.graph[inner].arguments[1]);
    }
    std::string clamp_text(const Node& node) const {
        const Node& inner = function_.graph[node.arguments[0]];
        const bool is_min = node.operation == Operation::min;
        return fmt::format("clamp({}, {}, {})", argument(inner.arguments[0], node.type),
                           argument((is_min ? inner : node).arguments[1], node.type),
                           argument((is_min ? node : inner).arguments[1], node.type));
    }

    Text infix_text(const Node& node) const {
        const Binding own = binding_of(node.operation);
        const NodeId a = node.arguments[0];
        const NodeId b = node.arguments[1];
        std::string_view spelling = info(node.operation).spelling;
        if (own == logical || own == comparison) {
            // No language mixes && and || without brackets in a way that readers know.
            const auto side = [&](NodeId id) {
                const bool is_same = function_.graph[id].operation == node.operation;
                return bound(id, own == logical ? (is_same ? logical : comparison) : sum);
            };
            return {fmt::format("{} {} {}", side(a), spelling, side(b)), own};
        }
        if (own == sum && function_.graph.is_constant(b) && function_.graph[b].number < 0.0) {
            spelling = node.operation == Operation::add ? "-" : "+";
            return {fmt::format("{} {} {}", bound(a, own), spelling, number(-function_.graph[b].number)), own};
        }
        return {fmt::format("{} {} {}", bound(a, own), spelling, bound(b, static_cast<Binding>(own + 1))), own};
    }

    Text select_text(const Node& node) const {
        const std::string if_true = argument(node.arguments[1], node.type);
        const std::string if_false = argument(node.arguments[2], node.type);
        if (is_wgsl())
            return {fmt::format("select({}, {}, {})", if_false, if_true, texts_[node.arguments[0]].text), primary};
        const auto side = [&](std::size_t k, const std::string& text) {
            return texts_[node.arguments[k]].binding == ternary ? "(" + text + ")" : text;
        };
        return {fmt::format("{} ? {} : {}", bound(node.arguments[0], logical), side(1, if_true), side(2, if_false)),
                ternary};
    }

    Text text_of(NodeId id) const {
        const Node& node = function_.graph[id];
        std::string text;
        switch (node.operation) {
        case Operation::constant:
            return {number(node.number), node.number < 0.0 ? sign : primary};
        case Operation::truth:
            if (words_.language == ShaderLanguage::osl) return {node.number != 0.0 ? "1" : "0", primary};
            return {node.number != 0.0 ? "true" : "false", primary};
        case Operation::parameter:
            return {name_of(function_.parameters[node.index]), primary};
        case Operation::element: {
            const Column& column = function_.graph.loops()[node.index].columns[static_cast<std::size_t>(node.number)];
            const auto open = std::find_if(open_loops_.begin(), open_loops_.end(),
                                           [&](const auto& each) { return each.first == node.index; });
            return {fmt::format("{}[{}]", tables_.name_of(column), open->second), primary};
        }
        case Operation::component:
            return {fmt::format("{}.{}", bound(node.arguments[0], primary), "xyz"[node.index]), primary};
        case Operation::pack: {
            const std::array<NodeId, 3>& all = node.arguments;
            if (all[0] == all[1] && all[0] == all[2]) return {vector_of(texts_[all[0]].text), primary};
            return {vector_of(fmt::format("{}, {}, {}", texts_[all[0]].text, texts_[all[1]].text, texts_[all[2]].text)),
                    primary};
        }
        case Operation::negate:
            return {"-" + bound(node.arguments[0], primary), sign};
        case Operation::invert:
            return {"!" + bound(node.arguments[0], primary), sign};
        case Operation::select:
            return select_text(node);
        case Operation::call: {
            for (std::size_t k = 0; k < node.argument_count(); ++k)
                text += (k == 0 ? "" : ", ") + texts_[node.arguments[k]].text;
            return {fmt::format("{}({})", info(static_cast<Helper>(node.index)).name, text), primary};
        }
        default:
            break;
        }
        if (info(node.operation).form == Form::infix) return infix_text(node);
        if (clamps(node)) return {clamp_text(node), primary};
        const bool is_alike = node.operation == Operation::min || node.operation == Operation::max;
        for (std::size_t k = 0; k < node.argument_count(); ++k)
            text += (k == 0 ? "" : ", ") +
                    (is_alike ? argument(node.arguments[k], node.type) : texts_[node.arguments[k]].text);
        return {fmt::format("{}({})", info(node.operation).spelling, text), primary};
    }

    const Function& function_;
    const Words& words_;
    Tables& tables_;
    std::vector<NodeId> order_;
    std::vector<unsigned> uses_;
    std::vector<Text> texts_;
    std::vector<bool> is_done_;
    std::vector<bool> enters_loop_;                                // computed before a loop that needs it
    std::vector<std::pair<std::uint8_t, std::string>> open_loops_; // with their indices
    std::unordered_map<NodeId, NodeId> total_of_;                  // of an inner loop's sum: the outer one
    std::set<std::string, std::less<>> taken_;
    std::string out_, indent_;
};

// "2e-6".
std::string rounded_text(double error) {
    const int exponent = static_cast<int>(std::floor(std::log10(error) + 1e-9));
    if (exponent == 0) return fmt::format("{:.0f}", error);
    return fmt::format("{:.0f}e{}", error / std::pow(10.0, exponent), exponent);
}

// What a user needs to know to call it.
std::string description(const Formula& formula, const Function& function, ShaderLanguage language) {
    std::string text = comment(formula.title) + "//\n";
    text += comment(fmt::format("Returns {}.", formula.result));
    std::size_t width = 0;
    for (const Parameter& parameter : function.parameters)
        if (parameter.is_used) width = std::max(width, name_in(language, parameter.name).size());
    for (const Parameter& parameter : function.parameters)
        if (parameter.is_used)
            text += comment(parameter.meaning, fmt::format("//   {:<{}}  ", name_in(language, parameter.name), width),
                            fmt::format("//   {:<{}}  ", "", width));
    text += comment(fmt::format("Source: {}.", formula.source));
    std::string error = fmt::format("Error in float, against double in 10,000 random poses: at most {} of {}",
                                    rounded_text(formula.error.apart), formula.error_of);
    if (!formula.near.empty()) error += fmt::format("; {} {}", rounded_text(formula.error.near), formula.near);
    return text + comment(error + ".");
}

} // namespace

std::string printed(std::span<const Formula* const> formulas, ShaderLanguage language, ShaderBranches branches) {
    const Words& words = all_words[static_cast<std::size_t>(language)];
    std::vector<Function> functions;
    for (const Formula* formula : formulas) {
        functions.push_back(recorded(*formula));
        if (branches == ShaderBranches::select) {
            Function& function = functions.back();
            const Recording recording(function.graph);
            function.join_stages();
        }
    }
    std::string text = fmt::format("// Printed by gonio {}. Lengths from 1e-4 to 1e5 m; inputs are finite.\n{}",
                                   version, words.prelude);
    Tables tables;
    const auto print = [&](const Function& function) {
        if (words.before_table.empty()) tables = Tables();
        return FunctionPrinter(function, words, tables).print();
    };
    std::string bodies;
    for (const Helper helper : helpers_of(functions))
        bodies += "\n" + comment(fmt::format("{}.", info(helper).comment)) + print(function_of(helper));
    for (std::size_t i = 0; i < functions.size(); ++i)
        bodies += "\n" + description(*formulas[i], functions[i], language) + print(functions[i]);
    if (words.before_table.empty()) return text + bodies;
    const std::string constants = tables.print(words);
    if (!constants.empty()) text += "\n// Rules of points, for loops.\n" + constants;
    return text + bodies;
}

} // namespace gonio::shader
