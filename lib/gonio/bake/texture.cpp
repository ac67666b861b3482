#include <gonio/bake/texture.hpp>
#include <gonio/base/kind_text.hpp>

#include <array>
#include <cstddef>

namespace gonio {

namespace {

constexpr std::array<std::string_view, 4> names{"none", "peak", "mean", "flux"};

} // namespace

std::span<const std::string_view> normalization_names() {
    return names;
}

const char* to_text(Normalization normalization) {
    return names[static_cast<std::size_t>(normalization)].data();
}

Result<Normalization> parse_normalization(std::string_view text) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == text) return static_cast<Normalization>(i);
    return unknown_name("normalization", text, names);
}

} // namespace gonio
