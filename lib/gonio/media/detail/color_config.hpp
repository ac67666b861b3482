// A configuration of OpenColorIO and its processors, owned by objects that close them. Private to media.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/media/detail/color_abi.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::media::detail {

// The role through which scene-linear colours enter any configuration: ACES2065-1.
inline constexpr const char* interchange = "aces_interchange";

// A configuration and a processor, closed when they go out of scope.
class Config {
public:
    // `path` empty: the built-in configuration. Fails (io, malformed) on a file that is not a configuration.
    static Result<Config> open(const std::string& path);

    Config(Config&& other) noexcept : module_(other.module_), config_(other.config_) { other.config_ = nullptr; }
    Config(const Config&) = delete;
    Config& operator=(const Config&) = delete;
    Config& operator=(Config&&) = delete;
    ~Config() {
        if (config_ != nullptr) module_->close_config(config_);
    }

    [[nodiscard]] const abi::ColorModule& module() const { return *module_; }
    [[nodiscard]] const abi::ColorConfig* get() const { return config_; }

    [[nodiscard]] std::vector<std::string> displays() const {
        return list([&](std::size_t i) { return module_->display_at(config_, i); });
    }
    [[nodiscard]] std::vector<std::string> views(const std::string& display) const {
        return list([&](std::size_t i) { return module_->view_at(config_, display.c_str(), i); });
    }
    [[nodiscard]] std::vector<std::string> spaces() const {
        return list([&](std::size_t i) { return module_->space_at(config_, i); });
    }
    [[nodiscard]] std::string default_display() const { return text(module_->default_display(config_)); }
    [[nodiscard]] std::string default_view(const std::string& display) const {
        return text(module_->default_view(config_, display.c_str()));
    }
    [[nodiscard]] bool has_space(std::string_view name) const {
        return module_->find_space(config_, std::string(name).c_str()) != nullptr;
    }

private:
    Config(const abi::ColorModule* module, abi::ColorConfig* config) : module_(module), config_(config) {}

    template<class At>
    static std::vector<std::string> list(At at) {
        std::vector<std::string> names;
        for (const char* name = at(0); name != nullptr; name = at(names.size()))
            names.emplace_back(name);
        return names;
    }
    static std::string text(const char* name) { return name != nullptr ? name : ""; }

    const abi::ColorModule* module_;
    abi::ColorConfig* config_;
};

class Processor {
public:
    Processor(const abi::ColorModule& module, abi::ColorProcessor* processor)
        : module_(module), processor_(processor) {}
    Processor(const Processor&) = delete;
    Processor& operator=(const Processor&) = delete;
    ~Processor() { module_.close_processor(processor_); }

    Result<void> apply(float* pixels, std::size_t count, int channels) const;

private:
    const abi::ColorModule& module_;
    abi::ColorProcessor* processor_;
};

// The error (usage) for an unknown name, with the nearest known name and all of them.
Unexpected unknown(std::string_view what, std::string_view name, const std::vector<std::string>& known);

// A Processor must own the result. Fails (usage) on unknown names, (unsupported) if OpenColorIO has no transform.
Result<abi::ColorProcessor*> space_processor(const Config& config, const std::string& from, const std::string& to);

} // namespace gonio::media::detail
