#include <gonio/shader/formulas.hpp>

#include <vector>

namespace gonio::shader {

std::span<const Formula> formulas() {
    static const std::vector<Formula> all = [] {
        std::vector<Formula> lists;
        for (const auto list :
             {formulas_of_lights(), formulas_of_materials(), formulas_of_shading(), formulas_of_highlights()})
            lists.insert(lists.end(), list.begin(), list.end());
        return lists;
    }();
    return all;
}

Function recorded(const Formula& formula) {
    Function function;
    function.name = formula.function;
    const Recording recording(function.graph);
    formula.record(function);
    function.mark_unused_parameters();
    return function;
}

} // namespace gonio::shader
