#include <gonio/media/detail/png_container.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace gonio::media::detail {

namespace {

// CRC-32 of ISO 3309, as in PNG's annex D.
constexpr std::array<std::uint32_t, 256> crc_table = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
        std::uint32_t c = n;
        for (int bit = 0; bit < 8; ++bit)
            c = (c & 1U) != 0U ? 0xedb88320U ^ (c >> 1U) : c >> 1U;
        table[n] = c;
    }
    return table;
}();

std::uint32_t crc(std::string_view bytes) {
    std::uint32_t c = 0xffffffffU;
    for (const char byte : bytes)
        c = crc_table[(c ^ static_cast<unsigned char>(byte)) & 0xffU] ^ (c >> 8U);
    return ~c;
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char byte : bytes.substr(0, 4))
        value = value << 8U | static_cast<unsigned char>(byte);
    return value;
}

} // namespace

bool is_whole_png(std::string_view bytes) {
    constexpr std::size_t signature = 8;
    constexpr std::size_t around = 12; // length, type and checksum of a chunk
    if (bytes.size() < signature) return false;
    bytes.remove_prefix(signature);
    while (bytes.size() >= around) {
        const std::size_t length = big_endian(bytes);
        if (length > bytes.size() - around) return false;
        const std::string_view body = bytes.substr(4, 4 + length); // the checksum covers the type
        if (crc(body) != big_endian(bytes.substr(8 + length))) return false;
        if (body.starts_with("IEND")) return true;
        bytes.remove_prefix(around + length);
    }
    return false;
}

} // namespace gonio::media::detail
