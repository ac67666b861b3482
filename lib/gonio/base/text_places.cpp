#include <gonio/base/text_places.hpp>

#include <algorithm>

namespace gonio {

Location TextPlaces::at(std::size_t offset) {
    constexpr std::size_t block_size = 16384;
    offset = std::min(offset, text_.size());
    Block here;
    const auto count = [&](std::size_t begin, std::size_t end) {
        const std::string_view part = text_.substr(0, end);
        for (std::size_t at = part.find('\n', begin); at < end; at = part.find('\n', at + 1)) {
            ++here.lines;
            here.line_begin = at + 1;
        }
    };
    if (blocks_.empty()) blocks_.emplace_back();
    while (blocks_.size() <= offset / block_size) {
        here = blocks_.back();
        count((blocks_.size() - 1) * block_size, blocks_.size() * block_size);
        blocks_.push_back(here);
    }
    const std::size_t block = offset / block_size;
    here = blocks_[block];
    count(block * block_size, offset);
    return {source_, here.lines + 1, static_cast<std::uint32_t>(offset - here.line_begin + 1)};
}

} // namespace gonio
