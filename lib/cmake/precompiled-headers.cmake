# What most files of the library, the tool and the tests include, parsed once for each; a target adds its own to them. A
# file still includes what it uses: clang-tidy reads it without these.
set(gonio_precompiled_headers
    <algorithm> <array> <charconv> <cmath> <cstdint> <functional> <limits> <memory> <numbers> <optional> <span> <string>
    <string_view> <utility> <variant> <vector> <fmt/format.h> <glm/geometric.hpp> <glm/vec2.hpp> <glm/vec3.hpp>
    <tl/expected.hpp> <gonio/base/result.hpp>)
if(EMSCRIPTEN)
    list(APPEND gonio_precompiled_headers "${CMAKE_CURRENT_LIST_DIR}/../wasm/short_format.hpp")
endif()
