#include <gonio/media/image/exr_core_writer.hpp>
#include <gonio/media/image/exr_names.hpp>

#include <algorithm>
#include <array>
#include <cstring>
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

// The file in memory, and the last words of the library.
struct Target {
    std::vector<unsigned char> bytes;
    std::string message;
};

Target& target_of(exr_const_context_t context) {
    void* data = nullptr;
    exr_get_user_data(context, &data);
    return *static_cast<Target*>(data);
}

void keep_message(exr_const_context_t context, exr_result_t /*code*/, const char* text) noexcept {
    try {
        target_of(context).message = text;
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

    // The channel of the request with that name: a chunk has them in the order of their names.
    std::size_t channel_named(std::string_view name) const {
        for (std::int32_t channel = 0; channel < request_.channels; ++channel)
            if (name == request_.channel_names[channel]) return static_cast<std::size_t>(channel);
        throw std::runtime_error("a channel has got lost");
    }

    void write_chunks() {
        std::int32_t lines = 1;
        check(exr_get_scanlines_per_chunk(context_, 0, &lines));
        const auto channels = static_cast<std::size_t>(request_.channels);
        const std::size_t row = channels * static_cast<std::size_t>(request_.width);
        exr_encode_pipeline_t encoder{};
        const auto encode = [&](std::int32_t y) {
            exr_chunk_info_t chunk;
            check(exr_write_scanline_chunk_info(context_, 0, y, &chunk));
            if (y == 0)
                check(exr_encoding_initialize(context_, 0, &chunk, &encoder));
            else
                check(exr_encoding_update(context_, 0, &chunk, &encoder));
            for (std::int16_t i = 0; i < encoder.channel_count; ++i) {
                exr_coding_channel_info_t& channel = encoder.channels[i];
                channel.user_bytes_per_element = sizeof(float);
                channel.user_data_type = EXR_PIXEL_FLOAT;
                channel.user_pixel_stride = static_cast<std::int32_t>(channels * sizeof(float));
                channel.user_line_stride = static_cast<std::int32_t>(row * sizeof(float));
                channel.encode_from_ptr = reinterpret_cast<const std::uint8_t*>(
                    request_.pixels + static_cast<std::size_t>(y) * row + channel_named(channel.channel_name));
            }
            if (y == 0) check(exr_encoding_choose_default_routines(context_, 0, &encoder));
            check(exr_encoding_run(context_, 0, &encoder));
        };
        try {
            for (std::int32_t y = 0; y < request_.height; y += lines)
                encode(y);
        } catch (...) {
            exr_encoding_destroy(context_, &encoder);
            throw;
        }
        exr_encoding_destroy(context_, &encoder);
    }

    const abi::EncodeRequest& request_;
    Target target_;
    exr_context_t context_ = nullptr;
};

} // namespace

std::vector<unsigned char> exr_core_bytes(const abi::EncodeRequest& request) {
    return Writer(request).bytes();
}

} // namespace gonio::media::detail
