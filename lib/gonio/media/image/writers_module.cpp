// gonio-writers.so: PNG and OpenEXR by the libraries of these formats, which take a few milliseconds to load where
// OpenImageIO takes a quarter of a second. It only writes. Its contract is in detail/image_abi.hpp.
#include <gonio/media/detail/image_abi.hpp>
#include <gonio/media/image/exr_core_writer.hpp>
#include <gonio/media/image/png_writer.hpp>

#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

namespace {

using namespace gonio::media;

int encode(const abi::EncodeRequest* request, abi::EncodeReply* reply) noexcept {
    const auto say = [reply](const char* text) { std::snprintf(reply->message, abi::message_bytes, "%s", text); };
    try {
        const std::string_view format = request->format;
        if (format != "png" && format != "openexr") {
            say("this module writes PNG and OpenEXR");
            return abi::unsupported;
        }
        auto bytes = std::make_unique<std::vector<unsigned char>>(format == "png" ? detail::png_bytes(*request)
                                                                                  : detail::exr_core_bytes(*request));
        reply->bytes = bytes->data();
        reply->size = bytes->size();
        reply->owner = bytes.release();
        return abi::done;
    } catch (const std::bad_alloc&) {
        say("out of memory");
        return abi::out_of_memory;
    } catch (const std::exception& error) {
        say(error.what());
        return abi::unsupported;
    } catch (...) {
        say("unknown exception");
        return abi::internal;
    }
}

void release_encoded(void* owner) noexcept {
    delete static_cast<std::vector<unsigned char>*>(owner);
}

int decode(const abi::DecodeRequest* /*request*/, abi::DecodeReply* reply) noexcept {
    std::snprintf(reply->message, abi::message_bytes, "this module does not read");
    return abi::unsupported;
}

void release_decoded(void* /*owner*/) noexcept {}

constexpr abi::ImageModule table{abi::image_version, encode, release_encoded, decode, release_decoded};

} // namespace

extern "C" __attribute__((visibility("default"))) const void* gonio_writers_module();

const void* gonio_writers_module() {
    return &table;
}
