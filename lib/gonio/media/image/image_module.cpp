// gonio-image.so: the only file of gonio that includes OpenImageIO. Its contract is in detail/image_abi.hpp.
#include <gonio/media/detail/image_abi.hpp>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <system_error>
#include <vector>

namespace {

using namespace gonio::media::abi;

void say(char* message, const std::string& text) {
    // OpenImageIO's errors may span lines and end in a newline; this keeps one sentence.
    std::string line = text.substr(0, text.find('\n'));
    while (!line.empty() && (line.back() == ' ' || line.back() == '.'))
        line.pop_back();
    std::snprintf(message, message_bytes, "%s", line.empty() ? "OpenImageIO gave no reason" : line.c_str());
}

// OpenImageIO prints an error that was not fetched to stderr when its owner is destroyed, and the global one when the
// process ends.
template<class Owner>
std::string take_error(Owner& owner) {
    std::string text = owner.has_error() ? owner.geterror() : std::string();
    const std::string global = OIIO::has_error() ? OIIO::geterror() : std::string();
    return text.empty() ? global : text;
}

// Runs `work` and turns its exceptions into a status.
template<class Work>
int guarded(char* message, Work work) noexcept {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        std::snprintf(message, message_bytes, "out of memory");
        return out_of_memory;
    } catch (const std::system_error& error) { // from std::thread: OpenImageIO starts threads on first use
        std::snprintf(message, message_bytes, "%s", error.what());
        if (error.code() == std::errc::resource_unavailable_try_again) {
            std::snprintf(message, message_bytes, "no thread can be started");
            return no_threads;
        }
    } catch (const std::exception& error) {
        std::snprintf(message, message_bytes, "%s", error.what());
    } catch (...) {
        std::snprintf(message, message_bytes, "unknown exception");
    }
    return internal;
}

// Once per process: encoding runs only on the caller's thread, so that no thread pool has to be joined at exit.
void set_up() {
    static const bool ready = [] {
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", -1);
        OIIO::attribute("log_times", 0);
        return true;
    }();
    static_cast<void>(ready);
}

OIIO::TypeDesc type_of(std::int32_t pixel) {
    switch (pixel) {
    case pixel_uint8:
        return OIIO::TypeDesc::UINT8;
    case pixel_uint16:
        return OIIO::TypeDesc::UINT16;
    case pixel_half:
        return OIIO::TypeDesc::HALF;
    default:
        return OIIO::TypeDesc::FLOAT;
    }
}

std::int32_t kind_of(const OIIO::TypeDesc& type) {
    switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
        return pixel_uint8;
    case OIIO::TypeDesc::UINT16:
        return pixel_uint16;
    case OIIO::TypeDesc::HALF:
        return pixel_half;
    default:
        return pixel_float;
    }
}

void set_attribute(OIIO::ImageSpec& spec, const Attribute& attribute) {
    const auto array = attribute.count == 1 ? 0 : static_cast<int>(attribute.count);
    if (attribute.kind == attribute_text)
        spec.attribute(attribute.name, attribute.text);
    else if (attribute.count == 0)
        return;
    else if (attribute.kind == attribute_floats)
        spec.attribute(attribute.name, OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, array), attribute.floats);
    else
        spec.attribute(attribute.name, OIIO::TypeDesc(OIIO::TypeDesc::INT, array), attribute.ints);
}

int encode(const EncodeRequest* request, EncodeReply* reply) noexcept {
    return guarded(reply->message, [&]() -> int {
        set_up();
        auto bytes = std::make_unique<std::vector<unsigned char>>();
        OIIO::Filesystem::IOVecOutput memory(*bytes);
        const auto output = OIIO::ImageOutput::create(request->format);
        if (!output || !output->supports("ioproxy")) {
            const std::string reason = OIIO::geterror();
            say(reply->message, reason.empty() ? "this OpenImageIO cannot write the format to memory" : reason);
            return unsupported;
        }
        OIIO::ImageSpec spec(request->width, request->height, request->channels, type_of(request->pixel));
        spec.channelnames.assign(request->channel_names, request->channel_names + request->channels);
        const auto alpha = std::find(spec.channelnames.begin(), spec.channelnames.end(), "A");
        spec.alpha_channel =
            alpha == spec.channelnames.end() ? -1 : static_cast<int>(alpha - spec.channelnames.begin());
        for (std::size_t i = 0; i < request->attribute_count; ++i)
            set_attribute(spec, request->attributes[i]);
        spec.attribute("oiio:UnassociatedAlpha", 1); // PNG: store colour unchanged, never divided by alpha

        output->set_ioproxy(&memory);
        const bool written =
            output->open("memory", spec) && output->write_image(OIIO::TypeDesc::FLOAT, request->pixels);
        const bool closed = output->close();
        const std::string error = take_error(*output);
        if (!written || !closed) {
            say(reply->message, error);
            return unsupported;
        }
        reply->bytes = bytes->data();
        reply->size = bytes->size();
        reply->owner = bytes.release();
        return done;
    });
}

void release_encoded(void* owner) noexcept {
    delete static_cast<std::vector<unsigned char>*>(owner);
}

struct Decoded {
    OIIO::ImageSpec spec; // owns the data of the attributes
    std::vector<float> pixels;
    std::vector<const char*> channel_names;
    std::vector<Attribute> attributes;
};

void list_attributes(Decoded& decoded) {
    for (const OIIO::ParamValue& value : decoded.spec.extra_attribs) {
        const OIIO::TypeDesc type = value.type();
        Attribute attribute{value.name().c_str(), attribute_text, type.basevalues(), nullptr, nullptr, nullptr};
        if (type == OIIO::TypeString) {
            attribute.text = value.get_ustring().c_str();
        } else if (type.basetype == OIIO::TypeDesc::FLOAT) {
            attribute.kind = attribute_floats;
            attribute.floats = static_cast<const float*>(value.data());
        } else if (type.basetype == OIIO::TypeDesc::INT) {
            attribute.kind = attribute_ints;
            attribute.ints = static_cast<const std::int32_t*>(value.data());
        } else {
            continue;
        }
        decoded.attributes.push_back(attribute);
    }
}

int decode(const DecodeRequest* request, DecodeReply* reply) noexcept {
    return guarded(reply->message, [&]() -> int {
        set_up();
        const auto input = OIIO::ImageInput::create(request->format);
        if (!input || !input->supports("ioproxy")) {
            const std::string reason = OIIO::geterror();
            say(reply->message, reason.empty() ? "this OpenImageIO cannot read the format from memory" : reason);
            return unsupported;
        }
        OIIO::Filesystem::IOMemReader memory(const_cast<unsigned char*>(request->bytes), request->size);
        input->set_ioproxy(&memory);
        OIIO::ImageSpec hints;
        hints.attribute("oiio:UnassociatedAlpha", 1);
        auto decoded = std::make_unique<Decoded>();
        if (!input->open("memory", decoded->spec, hints)) {
            say(reply->message, take_error(*input));
            return malformed;
        }
        const OIIO::ImageSpec& spec = decoded->spec;
        const std::size_t values = static_cast<std::size_t>(std::max(spec.width, 0)) *
                                   static_cast<std::size_t>(std::max(spec.height, 0)) *
                                   static_cast<std::size_t>(std::max(spec.nchannels, 0));
        // Also of a picture that is refused: picture_dimensions() asks for no values at all.
        reply->width = spec.width;
        reply->height = spec.height;
        reply->channels = spec.nchannels;
        // Width and height are below 2^31 each, channels far below; the product may wrap, so it is also compared in
        // double.
        const auto pixels = static_cast<double>(spec.width) * spec.height * spec.nchannels;
        if (values == 0 || pixels > static_cast<double>(request->max_values) || spec.depth > 1) {
            input->close();
            take_error(*input);
            say(reply->message, "the picture is empty or too large");
            return malformed;
        }
        decoded->pixels.resize(values);
        const bool read = input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, decoded->pixels.data());
        input->close();
        const std::string error = take_error(*input);
        if (!read || !error.empty()) { // truncated data may be read "successfully" with an error set
            say(reply->message, error);
            return malformed;
        }
        for (const std::string& name : spec.channelnames)
            decoded->channel_names.push_back(name.c_str());
        list_attributes(*decoded);
        reply->pixel = kind_of(spec.format);
        reply->pixels = decoded->pixels.data();
        reply->channel_names = decoded->channel_names.data();
        reply->attributes = decoded->attributes.data();
        reply->attribute_count = decoded->attributes.size();
        reply->owner = decoded.release();
        return done;
    });
}

void release_decoded(void* owner) noexcept {
    delete static_cast<Decoded*>(owner);
}

constexpr ImageModule table{image_version, encode, release_encoded, decode, release_decoded};

} // namespace

extern "C" __attribute__((visibility("default"))) const void* gonio_image_module();

const void* gonio_image_module() {
    return &table;
}
