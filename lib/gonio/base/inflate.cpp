#include <gonio/base/inflate.hpp>

#include <array>
#include <span>

namespace gonio {

namespace {

constexpr std::size_t longest_code = 15; // bits

// Bits from the lowest of each byte on. Behind the end are zeros, which is_past_end() tells.
class Bits {
public:
    explicit Bits(std::string_view bytes) : bytes_(bytes) {}

    // At most 16.
    std::uint32_t peek(std::size_t count) {
        while (count_ < count) {
            const std::uint32_t byte = at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_]) : 0U;
            held_ |= byte << count_;
            count_ += 8;
            ++at_;
        }
        return held_ & ((1U << count) - 1U);
    }
    void skip(std::size_t count) {
        held_ >>= count;
        count_ -= count;
    }
    std::uint32_t take(std::size_t count) {
        const std::uint32_t bits = peek(count);
        skip(count);
        return bits;
    }
    bool is_past_end() const { return at_ - count_ / 8 > bytes_.size(); }
    bool is_at_end() const { return at_ - count_ / 8 == bytes_.size(); }

    // The bytes behind the bits that were taken; fewer at the end.
    std::string_view take_bytes(std::size_t count) {
        at_ -= count_ / 8;
        held_ = 0;
        count_ = 0;
        if (at_ > bytes_.size()) return {};
        const std::string_view bytes = bytes_.substr(at_, count);
        at_ += bytes.size();
        return bytes;
    }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
    std::uint32_t held_ = 0;
    std::size_t count_ = 0;
};

// A canonical Huffman code: symbols in the order of their codes. Codes of up to nine bits are looked up.
class Code {
public:
    // Fails on lengths of more codes than there are. Of fewer, DEFLATE has one code of one bit, and distances none.
    bool build(std::span<const std::uint8_t> lengths) {
        counts_ = {};
        short_ = {};
        for (const std::uint8_t length : lengths)
            ++counts_[length];
        counts_[0] = 0;
        int left = 1;
        std::array<std::uint16_t, longest_code + 2> first{}; // index of the first symbol of a length
        for (std::size_t length = 1; length <= longest_code; ++length) {
            left = 2 * left - counts_[length];
            if (left < 0) return false;
            first[length + 1] = static_cast<std::uint16_t>(first[length] + counts_[length]);
        }
        const std::size_t codes = first[longest_code + 1];
        if (left > 0 && codes > 1) return false;
        std::array<std::uint32_t, longest_code + 1> next{};
        std::uint32_t code = 0;
        for (std::size_t length = 1; length <= longest_code; ++length) {
            next[length] = code;
            code = (code + counts_[length]) << 1U;
        }
        for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
            const std::size_t length = lengths[symbol];
            if (length == 0) continue;
            symbols_[first[length]++] = static_cast<std::uint16_t>(symbol);
            const std::uint32_t is = next[length]++;
            if (length > short_bits) continue;
            std::size_t reversed = 0; // codes are stored from their highest bit on
            for (std::size_t bit = 0; bit < length; ++bit)
                reversed |= (is >> bit & 1U) << (length - 1 - bit);
            for (std::size_t i = reversed; i < short_.size(); i += std::size_t{1} << length)
                short_[i] = static_cast<std::uint16_t>(symbol << 4U | length);
        }
        return true;
    }

    // The next symbol; nothing for bits that are no code.
    std::optional<std::uint32_t> take(Bits& bits) const {
        const std::uint32_t ahead = bits.peek(longest_code);
        if (const std::uint16_t known = short_[ahead & (short_.size() - 1)]; known != 0) {
            bits.skip(known & 15U);
            return known >> 4U;
        }
        std::uint32_t code = 0;
        std::uint32_t first = 0;
        std::uint32_t index = 0;
        for (std::size_t length = 1; length <= longest_code; ++length) {
            code = code << 1U | (ahead >> (length - 1) & 1U);
            const std::uint32_t count = counts_[length];
            if (code < first + count) {
                bits.skip(length);
                return symbols_[index + (code - first)];
            }
            index += count;
            first = (first + count) << 1U;
        }
        return std::nullopt;
    }

private:
    static constexpr std::size_t short_bits = 9;

    std::array<std::uint16_t, longest_code + 1> counts_{};
    std::array<std::uint16_t, 288> symbols_{};
    std::array<std::uint16_t, std::size_t{1} << short_bits> short_{}; // symbol and length
};

// A value that begins at `base`, and as many bits as are added to it.
struct Extra {
    std::uint16_t base = 0;
    std::uint8_t bits = 0;
};

constexpr std::array<Extra, 29> lengths_of{{{3, 0},   {4, 0},   {5, 0},   {6, 0},   {7, 0},  {8, 0},  {9, 0},  {10, 0},
                                            {11, 1},  {13, 1},  {15, 1},  {17, 1},  {19, 2}, {23, 2}, {27, 2}, {31, 2},
                                            {35, 3},  {43, 3},  {51, 3},  {59, 3},  {67, 4}, {83, 4}, {99, 4}, {115, 4},
                                            {131, 5}, {163, 5}, {195, 5}, {227, 5}, {258, 0}}};
constexpr std::array<Extra, 30> distances_of{
    {{1, 0},     {2, 0},     {3, 0},     {4, 0},      {5, 1},      {7, 1},     {9, 2},     {13, 2},
     {17, 3},    {25, 3},    {33, 4},    {49, 4},     {65, 5},     {97, 5},    {129, 6},   {193, 6},
     {257, 7},   {385, 7},   {513, 8},   {769, 8},    {1025, 9},   {1537, 9},  {2049, 10}, {3073, 10},
     {4097, 11}, {6145, 11}, {8193, 12}, {12289, 12}, {16385, 13}, {24577, 13}}};

class Inflater {
public:
    Inflater(std::string_view packed, std::size_t size) : bits_(packed), size_(size) {}

    std::optional<std::string> run() {
        for (bool is_last = false; !is_last;) {
            is_last = bits_.take(1) != 0;
            const std::uint32_t kind = bits_.take(2);
            const std::size_t before = out_.size();
            if (kind == 0 ? !stored() : kind == 1 ? !symbols(fixed()) : kind != 2 || !dynamic()) return std::nullopt;
            // Of ten bits each, blocks that hold nothing would cost far more time than their bytes should.
            if (out_.size() == before && ++empty_ > most_empty + size_ / 16) return std::nullopt;
            if (bits_.is_past_end()) return std::nullopt;
        }
        if (!bits_.is_at_end() || out_.size() != size_) return std::nullopt;
        return std::move(out_);
    }

private:
    struct Codes {
        Code literals;
        Code distances;
    };
    static constexpr std::size_t most_empty = 1000; // blocks; programs write a few when they flush

    bool stored() {
        const std::string_view head = bits_.take_bytes(4);
        if (head.size() != 4) return false;
        const auto number = [&](std::size_t at) {
            return static_cast<unsigned char>(head[at]) |
                   static_cast<unsigned>(static_cast<unsigned char>(head[at + 1])) << 8U;
        };
        const std::size_t count = number(0);
        if ((count ^ number(2)) != 0xffff || count > size_ - out_.size()) return false;
        const std::string_view bytes = bits_.take_bytes(count);
        out_ += bytes;
        return bytes.size() == count;
    }

    // Those of the format itself, built once.
    static const Codes& fixed() {
        static const Codes codes = [] {
            std::array<std::uint8_t, 288> lengths{};
            for (std::size_t i = 0; i < lengths.size(); ++i)
                lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
            std::array<std::uint8_t, 32> distances{};
            distances.fill(5);
            Codes made;
            made.literals.build(lengths);
            made.distances.build(distances);
            return made;
        }();
        return codes;
    }

    bool dynamic() {
        const std::size_t literals = bits_.take(5) + 257;
        const std::size_t distances = bits_.take(5) + 1;
        const std::size_t codes = bits_.take(4) + 4;
        if (literals > 286 || distances > 30) return false;
        constexpr std::array<std::uint8_t, 19> order{16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
        std::array<std::uint8_t, 19> of_lengths{};
        for (std::size_t i = 0; i < codes; ++i)
            of_lengths[order[i]] = static_cast<std::uint8_t>(bits_.take(3));
        Code& code = codes_.literals; // until the lengths are read
        if (!code.build(of_lengths)) return false;
        std::array<std::uint8_t, 286 + 30> lengths{};
        for (std::size_t at = 0; at < literals + distances;) {
            const std::optional<std::uint32_t> symbol = code.take(bits_);
            if (!symbol || bits_.is_past_end()) return false;
            if (*symbol < 16) {
                lengths[at++] = static_cast<std::uint8_t>(*symbol);
                continue;
            }
            if (*symbol == 16 && at == 0) return false;
            const std::uint8_t repeated = *symbol == 16 ? lengths[at - 1] : std::uint8_t{0};
            std::size_t times = *symbol == 16   ? 3 + bits_.take(2)
                                : *symbol == 17 ? 3 + bits_.take(3)
                                                : 11 + bits_.take(7);
            if (times > literals + distances - at) return false;
            for (; times > 0; --times)
                lengths[at++] = repeated;
        }
        constexpr std::size_t end_of_block = 256;
        const std::span<const std::uint8_t> all(lengths);
        return lengths[end_of_block] != 0 && codes_.literals.build(all.first(literals)) &&
               codes_.distances.build(all.subspan(literals, distances)) && symbols(codes_);
    }

    // Bytes and repetitions, to the end of the block.
    bool symbols(const Codes& codes) {
        while (true) {
            const std::optional<std::uint32_t> symbol = codes.literals.take(bits_);
            if (!symbol || bits_.is_past_end()) return false;
            if (*symbol == 256) return true;
            if (*symbol < 256) {
                if (out_.size() == size_) return false;
                out_ += static_cast<char>(*symbol);
                continue;
            }
            if (*symbol - 257 >= lengths_of.size()) return false;
            const Extra by = lengths_of[*symbol - 257];
            const std::size_t length = by.base + bits_.take(by.bits);
            const std::optional<std::uint32_t> back = codes.distances.take(bits_);
            if (!back || *back >= distances_of.size()) return false;
            const Extra from = distances_of[*back];
            const std::size_t distance = from.base + bits_.take(from.bits);
            if (distance > out_.size() || length > size_ - out_.size()) return false;
            if (distance >= length) {
                out_.append(out_, out_.size() - distance, length);
            } else { // what is written is read again
                for (std::size_t i = 0; i < length; ++i)
                    out_ += out_[out_.size() - distance];
            }
        }
    }

    Bits bits_;
    std::size_t size_;
    std::string out_;
    Codes codes_; // of a block that brings its own
    std::size_t empty_ = 0;
};

constexpr std::array<std::uint32_t, 256> make_crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit)
            value = (value & 1U) != 0 ? value >> 1U ^ 0xedb88320U : value >> 1U;
        table[i] = value;
    }
    return table;
}
constexpr std::array<std::uint32_t, 256> crc_table = make_crc_table();

} // namespace

std::optional<std::string> inflate(std::string_view packed, std::size_t size) {
    return Inflater(packed, size).run();
}

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t value = 0xffffffffU;
    for (const char c : bytes)
        value = crc_table[(value ^ static_cast<unsigned char>(c)) & 255U] ^ value >> 8U;
    return value ^ 0xffffffffU;
}

} // namespace gonio
