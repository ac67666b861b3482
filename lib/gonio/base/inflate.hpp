// Unpacking DEFLATE (RFC 1951), and the checksum that goes with it.
//
// zlib is not linked: Debian's archive of it is not position-independent, and a shared object would be loaded at every
// start of the tool. Some 150 MB/s.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gonio {

// The bytes that `packed` unpacks to; nothing if it breaks the format, ends early, has bytes behind its end,
// unpacks to any other number of bytes than `size`, or has more empty blocks than size / 16 + 1000. Memory grows with
// the bytes that are there, never beyond `size`.
std::optional<std::string> inflate(std::string_view packed, std::size_t size);

// CRC-32 as in zip and gzip.
std::uint32_t crc32(std::string_view bytes);

} // namespace gonio
