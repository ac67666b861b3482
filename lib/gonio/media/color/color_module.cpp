// gonio-color.so: the only file of gonio that includes OpenColorIO. Its contract is in detail/color_abi.hpp.
#include <gonio/media/detail/color_abi.hpp>
#include <gonio/media/detail/filmic.hpp>

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>

namespace OCIO = OCIO_NAMESPACE;

namespace gonio::media::abi {

struct ColorConfig {
    OCIO::ConstConfigRcPtr config;
};

struct ColorProcessor {
    OCIO::ConstCPUProcessorRcPtr processor;
};

} // namespace gonio::media::abi

namespace {

using namespace gonio::media::abi;
using gonio::media::detail::filmic_curve;
using gonio::media::detail::filmic_mix;

void say(char* message, const char* text) {
    std::snprintf(message, message_bytes, "%s", text);
    // Messages of several lines (YAML) are joined into one line.
    for (char* c = message; *c != '\0'; ++c)
        if (*c == '\n' || *c == '\r') *c = ' ';
}

// Runs `work` and turns its exceptions into a status; `refused` is the status for OpenColorIO's own exceptions.
template<class Work>
int guarded(char* message, Status refused, Work work) noexcept {
    try {
        work();
        return done;
    } catch (const OCIO::ExceptionMissingFile& error) {
        say(message, error.what());
        return io;
    } catch (const OCIO::Exception& error) {
        say(message, error.what());
        return refused;
    } catch (const std::bad_alloc&) {
        say(message, "out of memory");
        return out_of_memory;
    } catch (const std::exception& error) {
        say(message, error.what());
    } catch (...) {
        say(message, "unknown exception");
    }
    return internal;
}

OCIO::ConstTransformRcPtr builtin(const char* style, OCIO::TransformDirection direction) {
    const auto transform = OCIO::BuiltinTransform::Create();
    transform->setStyle(style);
    transform->setDirection(direction);
    return transform;
}

void add_space(OCIO::Config& config, const char* name, const char* alias, const char* description,
               const OCIO::ConstTransformRcPtr& to_reference) {
    const auto space = OCIO::ColorSpace::Create(OCIO::REFERENCE_SPACE_SCENE);
    space->setName(name);
    space->addAlias(alias);
    space->setDescription(description);
    space->setEncoding("scene-linear");
    if (to_reference) space->setTransform(to_reference, OCIO::COLORSPACE_DIR_TO_REFERENCE);
    config.addColorSpace(space);
}

void add_view_transform(OCIO::Config& config, const char* name, const char* style) {
    const auto view = OCIO::ViewTransform::Create(OCIO::REFERENCE_SPACE_SCENE);
    view->setName(name);
    view->setTransform(builtin(style, OCIO::TRANSFORM_DIR_FORWARD), OCIO::VIEWTRANSFORM_DIR_FROM_REFERENCE);
    config.addViewTransform(view);
}

constexpr std::array rec709_luminance{0.2126390058715103, 0.7151686787677559, 0.0721923153607337};

// filmic.hpp
OCIO::TransformRcPtr towards_luminance(OCIO::TransformDirection direction) {
    std::array<double, 16> matrix{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            matrix[4 * row + column] = filmic_mix * rec709_luminance[column] + (row == column ? 1.0 - filmic_mix : 0.0);
    matrix[15] = 1.0;
    const auto transform = OCIO::MatrixTransform::Create();
    transform->setMatrix(matrix.data());
    transform->setDirection(direction);
    return transform;
}

// A table of every half float; between two of them it is off by 1e-7 of the value.
OCIO::TransformRcPtr filmic_table() {
    constexpr unsigned long halves = 65536;
    const auto table = OCIO::Lut1DTransform::Create(halves, true);
    table->setInterpolation(OCIO::INTERP_LINEAR);
    for (unsigned long i = 0; i < halves; ++i) {
        const unsigned long exponent = i >> 10U & 31U;
        const double mantissa = static_cast<double>(i & 1023U) / 1024.0;
        double x =
            exponent == 0 ? std::ldexp(mantissa, -14) : std::ldexp(1.0 + mantissa, static_cast<int>(exponent) - 15);
        if (exponent == 31) x = 65504.0; // infinity and what is no number
        const auto y = static_cast<float>(filmic_curve(i >> 15U != 0 ? 0.0 : x));
        table->setValue(i, y, y, y);
    }
    return table;
}

void add_filmic(OCIO::Config& config, const OCIO::GroupTransform& from_rec709) {
    const auto group = OCIO::GroupTransform::Create();
    const auto to_rec709 = from_rec709.createEditableCopy();
    to_rec709->setDirection(OCIO::TRANSFORM_DIR_INVERSE);
    group->appendTransform(to_rec709);
    group->appendTransform(towards_luminance(OCIO::TRANSFORM_DIR_FORWARD));
    group->appendTransform(filmic_table());
    group->appendTransform(towards_luminance(OCIO::TRANSFORM_DIR_INVERSE));
    group->appendTransform(from_rec709.createEditableCopy());
    group->appendTransform(
        builtin("UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD", OCIO::TRANSFORM_DIR_FORWARD)->createEditableCopy());
    const auto view = OCIO::ViewTransform::Create(OCIO::REFERENCE_SPACE_SCENE);
    view->setName("filmic");
    view->setTransform(group, OCIO::VIEWTRANSFORM_DIR_FROM_REFERENCE);
    config.addViewTransform(view);
}

// OpenColorIO 2.1 ships no configuration, so this one is built here. The scene reference is ACES2065-1, the display
// reference CIE XYZ (D65), as the builtin transforms expect.
OCIO::ConstConfigRcPtr builtin_config() {
    const auto config = OCIO::Config::Create();
    config->setMajorVersion(2);
    config->setMinorVersion(1);

    add_space(*config, "ACES2065-1", "aces2065_1", "ACES AP0 primaries, scene-linear", nullptr);
    add_space(*config, "ACEScg", "acescg", "ACES AP1 primaries, scene-linear",
              builtin("ACEScg_to_ACES2065-1", OCIO::TRANSFORM_DIR_FORWARD));
    const auto from_rec709 = OCIO::GroupTransform::Create();
    from_rec709->appendTransform(
        builtin("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD", OCIO::TRANSFORM_DIR_INVERSE)->createEditableCopy());
    from_rec709->appendTransform(builtin("ACEScg_to_ACES2065-1", OCIO::TRANSFORM_DIR_FORWARD)->createEditableCopy());
    add_space(*config, "lin_rec709", "lin_srgb", "Rec.709 primaries, D65 white, scene-linear", from_rec709);

    const auto raw = OCIO::ColorSpace::Create(OCIO::REFERENCE_SPACE_SCENE);
    raw->setName("raw");
    raw->setDescription("numbers that are not a colour");
    raw->setIsData(true);
    config->addColorSpace(raw);

    const auto srgb = OCIO::ColorSpace::Create(OCIO::REFERENCE_SPACE_DISPLAY);
    srgb->setName("sRGB");
    srgb->setDescription("IEC 61966-2-1 display");
    srgb->setEncoding("sdr-video");
    srgb->setTransform(builtin("DISPLAY - CIE-XYZ-D65_to_sRGB", OCIO::TRANSFORM_DIR_FORWARD),
                       OCIO::COLORSPACE_DIR_FROM_REFERENCE);
    config->addColorSpace(srgb);

    add_view_transform(*config, "un-tone-mapped", "UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD");
    add_view_transform(*config, "aces-sdr-video", "ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0");
    add_filmic(*config, *from_rec709);
    config->setDefaultViewTransformName("un-tone-mapped");
    config->addDisplayView("sRGB", "Standard", "un-tone-mapped", "sRGB", "", "", "");
    config->addDisplayView("sRGB", "Filmic", "filmic", "sRGB", "", "", "");
    config->addDisplayView("sRGB", "ACES", "aces-sdr-video", "sRGB", "", "", "");
    config->addDisplayView("sRGB", "Raw", "raw", "");
    config->setActiveDisplays("sRGB");
    config->setActiveViews("Standard, Filmic, ACES, Raw");

    config->setRole(OCIO::ROLE_SCENE_LINEAR, "lin_rec709");
    config->setRole("aces_interchange", "ACES2065-1");
    config->setRole(OCIO::ROLE_DATA, "raw");
    config->setRole(OCIO::ROLE_DEFAULT, "raw");
    config->validate();
    return config;
}

int open_config(const char* path, ColorConfig** config, char* message) noexcept {
    return guarded(message, malformed, [&] {
        // The library must not print; everything that matters is returned as an exception.
        OCIO::SetLoggingLevel(OCIO::LOGGING_LEVEL_NONE);
        OCIO::SetLoggingFunction([](const char*) {});
        auto opened = std::make_unique<ColorConfig>();
        opened->config = path == nullptr || *path == '\0' ? builtin_config() : OCIO::Config::CreateFromFile(path);
        *config = opened.release();
    });
}

void close_config(ColorConfig* config) noexcept {
    delete config;
}

// OpenColorIO returns an empty text for an index beyond the end.
const char* or_null(const char* text) {
    return text == nullptr || *text == '\0' ? nullptr : text;
}

template<class Ask>
const char* asked(Ask ask) noexcept {
    try {
        return or_null(ask());
    } catch (...) {
        return nullptr;
    }
}

const char* display_at(const ColorConfig* config, std::size_t index) noexcept {
    return asked([&] { return config->config->getDisplay(static_cast<int>(index)); });
}

const char* view_at(const ColorConfig* config, const char* display, std::size_t index) noexcept {
    return asked([&] { return config->config->getView(display, static_cast<int>(index)); });
}

const char* space_at(const ColorConfig* config, std::size_t index) noexcept {
    return asked([&] { return config->config->getColorSpaceNameByIndex(static_cast<int>(index)); });
}

const char* default_display(const ColorConfig* config) noexcept {
    return asked([&] { return config->config->getDefaultDisplay(); });
}

const char* default_view(const ColorConfig* config, const char* display) noexcept {
    return asked([&] { return config->config->getDefaultView(display); });
}

const char* find_space(const ColorConfig* config, const char* name) noexcept {
    return asked([&]() -> const char* {
        const OCIO::ConstColorSpaceRcPtr space = config->config->getColorSpace(name);
        return space ? space->getName() : nullptr;
    });
}

std::int32_t space_kind(const ColorConfig* config, const char* name) noexcept {
    try {
        const OCIO::ConstColorSpaceRcPtr space = config->config->getColorSpace(name);
        if (!space) return space_unknown;
        if (space->isData()) return space_data;
        return space->getReferenceSpaceType() == OCIO::REFERENCE_SPACE_DISPLAY ? space_display : space_scene;
    } catch (...) {
        return space_unknown;
    }
}

// Multiplies `matrix` by the transform from the left; false if the transform is not a plain 3×3.
bool append(const OCIO::ConstTransformRcPtr& transform, std::array<double, 9>& matrix) {
    const auto step = OCIO_DYNAMIC_POINTER_CAST<const OCIO::MatrixTransform>(transform);
    if (!step || step->getDirection() != OCIO::TRANSFORM_DIR_FORWARD) return false;
    std::array<double, 16> m{};
    std::array<double, 4> offset{};
    step->getMatrix(m.data());
    step->getOffset(offset.data());
    std::array<double, 9> product{};
    for (std::size_t row = 0; row < 3; ++row) {
        if (offset[row] != 0.0 || m[4 * row + 3] != 0.0) return false;
        for (std::size_t column = 0; column < 3; ++column)
            for (std::size_t k = 0; k < 3; ++k)
                product[3 * row + column] += m[4 * row + k] * matrix[3 * k + column];
    }
    matrix = product;
    return true;
}

int space_matrix(const ColorConfig* config, const char* source, const char* target, double* matrix,
                 std::int32_t* is_matrix, char* message) noexcept {
    return guarded(message, unsupported, [&] {
        const OCIO::ConstProcessorRcPtr processor = config->config->getProcessor(source, target);
        const OCIO::GroupTransformRcPtr steps =
            processor->getOptimizedProcessor(OCIO::OPTIMIZATION_LOSSLESS)->createGroupTransform();
        std::array<double, 9> product{1, 0, 0, 0, 1, 0, 0, 0, 1};
        *is_matrix = 1;
        for (int i = 0; i < steps->getNumTransforms(); ++i)
            if (!append(steps->getTransform(i), product)) *is_matrix = 0;
        for (std::size_t i = 0; i < product.size(); ++i)
            matrix[i] = product[i];
    });
}

int display_processor(const ColorConfig* config, const char* source, const char* display, const char* view,
                      ColorProcessor** processor, char* message) noexcept {
    return guarded(message, unsupported, [&] {
        const auto transform = OCIO::DisplayViewTransform::Create();
        transform->setSrc(source);
        transform->setDisplay(display);
        transform->setView(view);
        auto made = std::make_unique<ColorProcessor>();
        made->processor = config->config->getProcessor(transform)->getDefaultCPUProcessor();
        *processor = made.release();
    });
}

int space_processor(const ColorConfig* config, const char* source, const char* target, ColorProcessor** processor,
                    char* message) noexcept {
    return guarded(message, unsupported, [&] {
        auto made = std::make_unique<ColorProcessor>();
        made->processor = config->config->getProcessor(source, target)->getDefaultCPUProcessor();
        *processor = made.release();
    });
}

int apply(const ColorProcessor* processor, float* pixels, std::size_t pixel_count, std::int32_t channels,
          char* message) noexcept {
    return guarded(message, unsupported, [&] {
        OCIO::PackedImageDesc description(pixels, static_cast<long>(pixel_count), 1, channels);
        processor->processor->apply(description);
    });
}

void close_processor(ColorProcessor* processor) noexcept {
    delete processor;
}

constexpr ColorModule table{color_version, open_config,       close_config,    display_at, view_at,
                            space_at,      default_display,   default_view,    find_space, space_kind,
                            space_matrix,  display_processor, space_processor, apply,      close_processor};

} // namespace

extern "C" __attribute__((visibility("default"))) const void* gonio_color_module();

const void* gonio_color_module() {
    return &table;
}
