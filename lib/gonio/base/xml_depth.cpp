#include <gonio/base/limits.hpp>
#include <gonio/base/xml_depth.hpp>

namespace gonio {

pugi::xml_node first_too_deep(const pugi::xml_document& document) {
    constexpr int deepest = static_cast<int>(limit("xml-depth").value);
    int depth = 0;
    for (pugi::xml_node node = document.first_child(); node;) {
        if (depth > deepest) return node;
        if (node.first_child()) {
            node = node.first_child();
            ++depth;
            continue;
        }
        while (node && !node.next_sibling()) {
            node = node.parent();
            --depth;
        }
        if (node) node = node.next_sibling();
    }
    return {};
}

} // namespace gonio
