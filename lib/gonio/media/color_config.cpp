#include <gonio/base/file.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/media/detail/color_config.hpp>
#include <gonio/media/detail/open_module.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace gonio::media::detail {

Result<Config> Config::open(const std::string& path) {
    Result<const abi::ColorModule*> module = color_module();
    if (!module) return pass_on(module);
    if (!path.empty()) { // OpenColorIO does not distinguish a missing file from a broken one
        Result<std::string> readable = read_file(path);
        if (!readable) return pass_on(readable);
    }
    std::array<char, abi::message_bytes> message{};
    abi::ColorConfig* config = nullptr;
    if (const int status = (*module)->open_config(path.c_str(), &config, message.data()); status != 0)
        return fail(cause_of(status), fmt::format("cannot read the colour configuration: {}", message.data()), {},
                    path);
    return Config(*module, config);
}

Result<void> Processor::apply(float* pixels, std::size_t count, int channels) const {
    std::array<char, abi::message_bytes> message{};
    if (const int status = module_.apply(processor_, pixels, count, channels, message.data()); status != 0)
        return fail(cause_of(status), fmt::format("the colour transform failed: {}", message.data()));
    return {};
}

Unexpected unknown(std::string_view what, std::string_view name, const std::vector<std::string>& known) {
    const std::vector<std::string_view> candidates(known.begin(), known.end());
    const std::string_view near = nearest(name, candidates);
    return fail("USE0103", fmt::format("unknown {} '{}'", what, name),
                fmt::format("{}there are: {}", near.empty() ? "" : fmt::format("did you mean '{}'? ", near),
                            fmt::join(known, ", ")));
}

Result<abi::ColorProcessor*> space_processor(const Config& config, const std::string& from, const std::string& to) {
    for (const std::string& name : {from, to})
        if (!config.has_space(name)) return unknown("colour space", name, config.spaces());
    std::array<char, abi::message_bytes> message{};
    abi::ColorProcessor* processor = nullptr;
    if (const int status =
            config.module().space_processor(config.get(), from.c_str(), to.c_str(), &processor, message.data());
        status != 0)
        return fail(cause_of(status), fmt::format("no transform from '{}' to '{}': {}", from, to, message.data()));
    return processor;
}

} // namespace gonio::media::detail
