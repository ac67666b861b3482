// Archives in tests.
#pragma once

#include <gonio/base/archive.hpp>
#include <gonio/base/inflate.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace gonio::test {

// The code of a failure; "read" if there is none.
template<class T>
std::string code_of(const Result<T>& result) {
    return result ? std::string("read") : result.error().diagnostics.back().code;
}

inline std::string put16(std::uint32_t number) {
    return {static_cast<char>(number & 255U), static_cast<char>(number >> 8U & 255U)};
}

inline std::string put32(std::uint32_t number) {
    return put16(number & 0xffffU) + put16(number >> 16U);
}

// An archive of one file that is deflated to `packed`.
inline std::string deflated(const std::string& name, const std::string& packed, std::string_view bytes) {
    std::string archive = write_archive(std::array{ArchiveFile{name, packed}});
    for (const std::size_t head : {std::size_t{4}, archive.find("PK\x01\x02") + 6}) {
        archive.replace(head + 4, 2, put16(8));
        archive.replace(head + 10, 4, put32(crc32(bytes)));
        archive.replace(head + 18, 4, put32(static_cast<std::uint32_t>(bytes.size())));
    }
    return archive;
}

} // namespace gonio::test
