// The media modules where there is no dlopen: linked into the program. In place of module.cpp, whose folders nobody
// needs.
#include <gonio/media/detail/open_module.hpp>
#include <gonio/media/module.hpp>

extern "C" const void* gonio_image_module();
extern "C" const void* gonio_color_module();

namespace gonio::media {

void set_module_folders(std::vector<std::string> /*folders*/) {}

std::vector<std::string> module_folders() {
    return {};
}

std::vector<std::string> opened_modules() {
    return {};
}

namespace detail {

Result<const abi::ImageModule*> image_module() {
    return static_cast<const abi::ImageModule*>(gonio_image_module());
}

Result<const abi::ImageModule*> writers_module() {
    return image_module();
}

Result<const abi::ColorModule*> color_module() {
    return static_cast<const abi::ColorModule*>(gonio_color_module());
}

Result<const abi::PdfModule*> pdf_module() {
    return fail("UNS0102", "there is no module for PDF in WebAssembly", "write .svg or .html, which browsers print");
}

} // namespace detail

} // namespace gonio::media
