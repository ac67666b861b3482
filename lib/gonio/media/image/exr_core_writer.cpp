#include <gonio/media/image/exr_core_writer.hpp>
#include <gonio/media/image/exr_names.hpp>
#include <gonio/media/image/exr_zip.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <new>
#include <openexr.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace gonio::media::detail {

namespace {

struct Compression {
    std::string_view name;
    exr_compression_t kind;
};

constexpr std::array compressions{Compression{"zip", EXR_COMPRESSION_ZIP}, Compression{"none", EXR_COMPRESSION_NONE},
                                  Compression{"zips", EXR_COMPRESSION_ZIPS}, Compression{"rle", EXR_COMPRESSION_RLE},
                                  Compression{"piz", EXR_COMPRESSION_PIZ}};

// The file in memory, and the last words of the library, which several threads may hear.
struct Target {
    std::vector<unsigned char> bytes;
    std::string message;
    std::mutex message_mutex;
};

Target& target_of(exr_const_context_t context) {
    void* data = nullptr;
    exr_get_user_data(context, &data);
    return *static_cast<Target*>(data);
}

void keep_message(exr_const_context_t context, exr_result_t /*code*/, const char* text) noexcept {
    try {
        Target& target = target_of(context);
        const std::scoped_lock lock(target.message_mutex);
        target.message = text;
    } catch (...) { // the code says it without words
    }
}

std::int64_t write_at(exr_const_context_t /*context*/, void* data, const void* from, std::uint64_t size,
                      std::uint64_t at, exr_stream_error_func_ptr_t /*report*/) noexcept {
    try {
        std::vector<unsigned char>& bytes = static_cast<Target*>(data)->bytes;
        if (bytes.size() < at + size) bytes.resize(at + size);
        std::memcpy(bytes.data() + at, from, size);
        return static_cast<std::int64_t>(size);
    } catch (...) {
        return -1;
    }
}

class Writer {
public:
    explicit Writer(const abi::EncodeRequest& request) : request_(request) {
        exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
        start.error_handler_fn = keep_message;
        start.write_fn = write_at;
        start.user_data = &target_;
        check(exr_start_write(&context_, "memory", EXR_WRITE_FILE_DIRECTLY, &start));
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() {
        if (context_ != nullptr) exr_finish(&context_);
    }

    std::vector<unsigned char> bytes() {
        write_head();
        write_chunks();
        check(exr_finish(&context_)); // writes the table of the chunks
        context_ = nullptr;
        return std::move(target_.bytes);
    }

private:
    void check(exr_result_t result) const {
        if (result == EXR_ERR_SUCCESS) return;
        if (result == EXR_ERR_OUT_OF_MEMORY) throw std::bad_alloc();
        throw std::runtime_error(target_.message.empty() ? exr_get_default_error_message(result) : target_.message);
    }

    exr_compression_t compression() const {
        std::string_view name = "zip";
        for (std::size_t i = 0; i < request_.attribute_count; ++i)
            if (std::string_view(request_.attributes[i].name) == "compression") name = request_.attributes[i].text;
        for (const Compression& known : compressions)
            if (known.name == name) return known.kind;
        throw std::runtime_error("no compression '" + std::string(name) + "'");
    }

    void write_head() {
        int part = 0;
        check(exr_set_longname_support(context_, 1));
        check(exr_add_part(context_, nullptr, EXR_STORAGE_SCANLINE, &part));
        check(exr_initialize_required_attr_simple(context_, part, request_.width, request_.height, compression()));
        for (std::int32_t channel = 0; channel < request_.channels; ++channel)
            check(exr_add_channel(context_, part, request_.channel_names[channel],
                                  request_.pixel == abi::pixel_half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT,
                                  EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1));
        for (std::size_t i = 0; i < request_.attribute_count; ++i)
            set_attribute(part, request_.attributes[i]);
        check(exr_write_header(context_));
    }

    void set_attribute(int part, const abi::Attribute& attribute) {
        if (std::string_view(attribute.name) == "compression") return;
        const std::string name(exr_name(attribute.name));
        if (attribute.kind == abi::attribute_text) {
            check(exr_attr_set_string(context_, part, name.c_str(), attribute.text));
        } else if (attribute.kind == abi::attribute_floats) {
            if (attribute.count == 1)
                check(exr_attr_set_float(context_, part, name.c_str(), attribute.floats[0]));
            else if (attribute.count > 1)
                check(exr_attr_set_float_vector(context_, part, name.c_str(),
                                                static_cast<std::int32_t>(attribute.count), attribute.floats));
        } else if (attribute.count == 1) {
            check(exr_attr_set_int(context_, part, name.c_str(), attribute.ints[0]));
        } else if (attribute.count == 2) {
            exr_attr_v2i_t pair{};
            pair.x = attribute.ints[0];
            pair.y = attribute.ints[1];
            check(exr_attr_set_v2i(context_, part, name.c_str(), &pair));
        } else if (attribute.count == 3) {
            exr_attr_v3i_t triple{};
            triple.x = attribute.ints[0];
            triple.y = attribute.ints[1];
            triple.z = attribute.ints[2];
            check(exr_attr_set_v3i(context_, part, name.c_str(), &triple));
        }
    }

    // The first value of the channel with that name: a chunk has channels in the order of their names. Null if there is
    // none.
    const float* channel_named(std::string_view name) const noexcept {
        for (std::int32_t channel = 0; channel < request_.channels; ++channel)
            if (name == request_.channel_names[channel]) return request_.pixels + channel;
        return nullptr;
    }

    // What a chunk becomes, on any thread.
    struct Chunk {
        std::vector<std::uint8_t> bytes;
        exr_result_t result = EXR_ERR_SUCCESS;
    };

    // Compressed by several threads, some chunks at a time, and then written in their order.
    void write_chunks() {
        constexpr std::size_t at_once = 256;
        check(exr_get_scanlines_per_chunk(context_, 0, &lines_));
        const exr_compression_t kind = compression();
        is_zip_ = kind == EXR_COMPRESSION_ZIP || kind == EXR_COMPRESSION_ZIPS;
        const auto lines = static_cast<std::size_t>(lines_);
        const std::size_t count = (static_cast<std::size_t>(request_.height) + lines - 1) / lines;
        for (first_ = 0; first_ < count; first_ += at_once) {
            chunks_.assign(std::min(at_once, count - first_), Chunk());
            check(exr_write_scanline_chunk_info(context_, 0, line_of(0), &first_info_)); // of the next one alone
            const auto compress = [](void* writer, std::size_t i) noexcept {
                static_cast<Writer*>(writer)->compress(i);
            };
            if (!request_.parallel.run(request_.parallel.loop, chunks_.size(), compress, this))
                throw std::runtime_error("stopped");
            reserve();
            for (std::size_t i = 0; i < chunks_.size(); ++i) {
                check(chunks_[i].result);
                check(exr_write_scanline_chunk(context_, 0, line_of(i), chunks_[i].bytes.data(),
                                               chunks_[i].bytes.size()));
            }
        }
    }

    // What grows by the chunk is copied each time.
    void reserve() {
        constexpr std::size_t of_chunk = 64; // more than its place and size take
        std::size_t size = target_.bytes.size();
        for (const Chunk& chunk : chunks_)
            size += chunk.bytes.size() + of_chunk;
        if (size > target_.bytes.capacity()) target_.bytes.reserve(std::max(size, 2 * target_.bytes.capacity()));
    }

    std::int32_t line_of(std::size_t chunk) const { return static_cast<std::int32_t>(first_ + chunk) * lines_; }

    void compress(std::size_t i) noexcept {
        exr_encode_pipeline_t encoder{};
        chunks_[i].result = compress(i, encoder);
        exr_encoding_destroy(context_, &encoder);
    }

    exr_result_t compress(std::size_t i, exr_encode_pipeline_t& encoder) noexcept {
        const std::int32_t y = line_of(i);
        const auto channels = static_cast<std::size_t>(request_.channels);
        const std::size_t row = channels * static_cast<std::size_t>(request_.width);
        exr_chunk_info_t chunk = first_info_;
        chunk.idx += static_cast<std::int32_t>(i);
        chunk.start_y = y;
        chunk.height = std::min(lines_, request_.height - y);
        chunk.unpacked_size = chunk.unpacked_size / static_cast<std::uint64_t>(first_info_.height) *
                              static_cast<std::uint64_t>(chunk.height);
        if (const exr_result_t failed = exr_encoding_initialize(context_, 0, &chunk, &encoder)) return failed;
        for (std::int16_t c = 0; c < encoder.channel_count; ++c) {
            exr_coding_channel_info_t& channel = encoder.channels[c];
            channel.user_bytes_per_element = sizeof(float);
            channel.user_data_type = EXR_PIXEL_FLOAT;
            channel.user_pixel_stride = static_cast<std::int32_t>(channels * sizeof(float));
            channel.user_line_stride = static_cast<std::int32_t>(row * sizeof(float));
            const float* const first = channel_named(channel.channel_name);
            if (first == nullptr) return EXR_ERR_INVALID_ARGUMENT;
            channel.encode_from_ptr = reinterpret_cast<const std::uint8_t*>(first + static_cast<std::size_t>(y) * row);
        }
        if (const exr_result_t failed = exr_encoding_choose_default_routines(context_, 0, &encoder)) return failed;
        if (is_zip_) {
            encoder.compress_fn = nullptr; // zlib's, which takes most of the time of a picture
            encoder.write_fn = zip_chunk;
        } else {
            encoder.write_fn = keep_chunk;
        }
        encoder.encoding_user_data = &chunks_[i];
        encoder.yield_until_ready_fn = nullptr; // it insists on the order of the file
        return exr_encoding_run(context_, 0, &encoder);
    }

    static exr_result_t zip_chunk(exr_encode_pipeline_t* encoder) noexcept {
        try {
            static_cast<Chunk*>(encoder->encoding_user_data)->bytes =
                exr_zip({static_cast<const std::uint8_t*>(encoder->packed_buffer), encoder->packed_bytes});
            return EXR_ERR_SUCCESS;
        } catch (...) {
            return EXR_ERR_OUT_OF_MEMORY;
        }
    }
    static exr_result_t keep_chunk(exr_encode_pipeline_t* encoder) noexcept {
        try {
            // Readers take a chunk that is as long as its pixels for one that is not compressed.
            const bool is_smaller = encoder->compressed_bytes < encoder->packed_bytes;
            const auto* const bytes =
                static_cast<const std::uint8_t*>(is_smaller ? encoder->compressed_buffer : encoder->packed_buffer);
            const std::size_t size = is_smaller ? encoder->compressed_bytes : encoder->packed_bytes;
            static_cast<Chunk*>(encoder->encoding_user_data)->bytes.assign(bytes, bytes + size);
            return EXR_ERR_SUCCESS;
        } catch (...) {
            return EXR_ERR_OUT_OF_MEMORY;
        }
    }

    const abi::EncodeRequest& request_;
    Target target_;
    exr_context_t context_ = nullptr;
    std::int32_t lines_ = 1; // of a chunk
    bool is_zip_ = false;
    std::vector<Chunk> chunks_;
    std::size_t first_ = 0; // the number of the first of them in the file
    exr_chunk_info_t first_info_{};
};

} // namespace

std::vector<unsigned char> exr_core_bytes(const abi::EncodeRequest& request) {
    return Writer(request).bytes();
}

} // namespace gonio::media::detail
