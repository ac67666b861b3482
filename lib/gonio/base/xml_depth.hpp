// How deeply the elements of an XML document are nested: code that follows them by recursion needs a limit. Internal.
#pragma once

#include <pugixml.hpp>

namespace gonio {

// The first node that is deeper than the limit xml-depth; empty if none is. Found without recursion.
pugi::xml_node first_too_deep(const pugi::xml_document& document);

} // namespace gonio
