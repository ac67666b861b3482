// libFuzzer: for any bytes, archives and what is in them do not crash the readers, and fail with one reason or read the
// same twice. The first byte chooses what the rest is: an archive, deflated bytes, product.xml, description.xml.
#include <gonio/base/archive.hpp>
#include <gonio/base/inflate.hpp>
#include <gonio/interchange/scene_format.hpp>
#include <gonio/profile/gldf.hpp>

#include "check.hpp"

#include <array>
#include <string>
#include <string_view>

namespace {

using namespace gonio;

void read_archive(std::string_view bytes) {
    const Result<Archive> archive = Archive::open(bytes, "fuzz");
    if (!archive) {
        fuzz::require(!archive.error().diagnostics.empty());
        return;
    }
    for (const ArchiveEntry& entry : archive->entries()) {
        fuzz::require(archive->find(entry.name) == &entry);
        const Result<std::string> read = archive->read(entry);
        if (read) fuzz::require(read->size() == entry.size);
    }
}

// As GLDF or GDTF, by the name of its XML.
void read_luminaire(const std::string& bytes) {
    SceneReadOptions options;
    const auto scene =
        fuzz::read_twice([&] { return read_scene_lights(bytes, "fuzz", options); },
                         [](const FoundScene& a, const FoundScene& b) {
                             return a.lights.size() == b.lights.size() && a.profiles.size() == b.profiles.size();
                         });
    if (scene) {
        FoundScene loaded = *scene;
        load_scene_profiles(loaded, options);
    }
    const Result<Archive> opened = Archive::open(bytes, "fuzz");
    const Result<GldfProfile> profile =
        opened ? gldf_profile(*opened) : Result<GldfProfile>(Unexpected(opened.error()));
    if (profile) fuzz::require(!profile->name.empty());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text = fuzz::as_text(data, size);
    if (text.empty()) return 0;
    constexpr std::string_view lamp = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n100 50\n";
    switch (fuzz::take_choice(text, 4)) {
    case 0:
        read_archive(text);
        read_luminaire(std::string(text));
        break;
    case 1:
        inflate(text, 1000);
        break;
    default: {
        const bool is_product = data[0] == 'c';
        read_luminaire(write_archive(std::array<ArchiveFile, 2>{
            {{is_product ? "product.xml" : "description.xml", std::string(text)}, {"ldc/a.ies", std::string(lamp)}}}));
    }
    }
    return 0;
}
