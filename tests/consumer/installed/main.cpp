// Calls what needs nothing, what needs the libraries behind the archive (libmd, threads, dl), and both modules.
#include <gonio/base/parallel.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/media/display.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/media/module.hpp>

#include <atomic>
#include <cstdio>

int main() {
    const auto flux = gonio::parse_amount("2.5klm");
    if (!flux || flux->in_base_units() != 2500.0) return 1;

    std::atomic<int> calls{0};
    gonio::parallel_for(100, 4, [&](std::size_t) { ++calls; });
    if (calls != 100) return 2;

    gonio::media::set_module_folders({MODULE_DIR});
    gonio::Image image(4, 4, 3);
    const auto shown = gonio::media::apply_display(image);
    if (!shown) {
        std::puts(to_text(shown.error().diagnostics.back()).c_str());
        return 3;
    }
    const auto bytes = gonio::media::encode_image(image, *gonio::media::find_image_format("png"));
    if (!bytes) {
        std::puts(to_text(bytes.error().diagnostics.back()).c_str());
        return 4;
    }
    return 0;
}
