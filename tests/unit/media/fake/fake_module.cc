// A library with the name and the entry point of gonio-image.so, but with another version in its table.
#include <cstdint>

namespace {
struct Table {
    std::uint32_t version;
};
constexpr Table table{4711};
} // namespace

extern "C" __attribute__((visibility("default"))) const void* gonio_image_module();

const void* gonio_image_module() {
    return &table;
}
