// Lines and columns of offsets in a text, in any order: some microseconds each, however long the text and its lines
// are.
#pragma once

#include <gonio/base/diagnostics.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio {

class TextPlaces {
public:
    TextPlaces() = default;
    // `text` must outlive this; `source` is the file of the places.
    TextPlaces(std::string_view text, std::string source) : text_(text), source_(std::move(source)) {}

    Location at(std::size_t offset);

private:
    struct Block {
        std::uint32_t lines = 0;    // line ends before it
        std::size_t line_begin = 0; // of the line at its first byte
    };

    std::string_view text_;
    std::string source_;
    std::vector<Block> blocks_; // made when they are needed
};

} // namespace gonio
