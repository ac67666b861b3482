// A library of the name and with the entry of gonio-image.so whose table says that it is of another version.
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
