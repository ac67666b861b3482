// Calls what needs nothing, what needs the libraries behind the archive (threads, dl), and both modules; asks for the
// version while compiling.
#include <gonio/gonio.hpp>

#include <cstdio>

static_assert(GONIO_VERSION >= GONIO_VERSION_NUMBER(0, 1, 0));

int main() {
    const auto flux = gonio::parse_amount("2.5klm");
    if (!flux || flux->in_base_units() != 2500.0) return 1;

    const auto stage = gonio::make_stage("floor");
    gonio::RenderOptions options;
    options.width = options.height = 64;
    options.threads = 4;
    if (!stage || !gonio::render(*stage, {}, stage->camera, options)) return 2;

#ifdef MODULE_DIR
    gonio::media::set_module_folders({MODULE_DIR});
#endif
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
