// How the core opens a module; module.cpp is the only file that calls dlopen.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/media/detail/color_abi.hpp>
#include <gonio/media/detail/image_abi.hpp>
#include <gonio/media/detail/pdf_abi.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace gonio::media::detail {

struct ModuleName {
    const char* file;      // "gonio-image.so"
    const char* entry;     // its one exported function
    std::uint32_t version; // of the table that the function must return
    const char* library;   // the library that it is made of, for messages
    const char* package;   // the Debian package of that library
    unsigned threads = 0;  // started when the library is loaded; if they cannot be started, the process ends
};

inline constexpr ModuleName image_module_name{"gonio-image.so", "gonio_image_module", abi::image_version,
                                              "OpenImageIO",    "libopenimageio2.4",  4};
inline constexpr ModuleName writers_module_name{"gonio-writers.so", "gonio_writers_module", abi::image_version,
                                                "libpng, libdeflate and OpenEXRCore",
                                                "libpng16-16, libdeflate0 and libopenexr-3-1-30"};
inline constexpr ModuleName color_module_name{"gonio-color.so", "gonio_color_module", abi::color_version, "OpenColorIO",
                                              "libopencolorio2.1"};
inline constexpr ModuleName pdf_module_name{"gonio-pdf.so", "gonio_pdf_module", abi::pdf_version, "cairo", "libcairo2"};

// The module's table, from the first of the folders that contains the file. Fails (unsupported) when no folder does,
// when the module cannot be loaded, or when its table is of another version; (io) when the library's threads cannot be
// started.
Result<const void*> open_module(const ModuleName& name, const std::vector<std::string>& folders);

// Opened on the first call, from module_folders(); later calls cost a lock. A failure is not cached.
Result<const abi::ImageModule*> image_module();
// PNG and OpenEXR alone, and only to write them: it opens in milliseconds.
Result<const abi::ImageModule*> writers_module();
Result<const abi::ColorModule*> color_module();
Result<const abi::PdfModule*> pdf_module();

// Why a module's function failed, by its abi::Status.
Cause cause_of(int status);

} // namespace gonio::media::detail
