// A glTF file's JSON and binary chunk.
#pragma once

#include <gonio/base/result.hpp>

#include <string>
#include <string_view>

namespace gonio::interchange_detail {

struct GltfDocument {
    std::string_view container; // of a GLB: the bytes that its header announces
    std::string_view json;      // views of the file's bytes
    std::string_view binary;    // of a GLB; empty without one
    bool is_binary = false;     // a GLB
};

// Fails (malformed) on a container that is broken or ends too early.
Result<GltfDocument> gltf_document(std::string_view bytes, const std::string& source);

} // namespace gonio::interchange_detail
