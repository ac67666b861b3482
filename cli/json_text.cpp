#include "json_text.hpp"

namespace gonio::cli {

std::string dump(const Json& json, int indent) {
    return json.dump(indent) + "\n";
}

} // namespace gonio::cli
