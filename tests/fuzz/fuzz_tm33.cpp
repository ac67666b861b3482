// libFuzzer: for any bytes, the TM-33 reader does not crash or recurse without bound; strict reading accepts nothing
// that tolerant reading refuses; and the result is the same after writing and reading it again.
#include <gonio/profile/read.hpp>
#include <gonio/profile/tm33_light.hpp>
#include <gonio/profile/write.hpp>

#include "../unit/profile/equal.hpp"

#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace gonio;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as text
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Result<Profile> read = read_profile(bytes, "fuzz", {ProfileFormat::tm33, false});
    const Result<Profile> strict = read_profile(bytes, "fuzz", {ProfileFormat::tm33, true});
    if (strict && (!read || !test::equal(read->file, strict->file))) std::abort();
    if (!read) {
        const Diagnostics& diagnostics = read.error().diagnostics;
        if (diagnostics.empty() || diagnostics.back().severity != Severity::error) std::abort();
        return 0;
    }
    const Tm33File& file = std::get<Tm33File>(read->file);
    static_cast<void>(lm63_of(file));
    const std::string written = write_tm33(file);
    const Result<Profile> again = read_profile(written, "fuzz", {ProfileFormat::tm33, false});
    if (!again) std::abort();
    // Writing corrects counts and keeps everything else; from then on everything is kept.
    const Tm33File& second = std::get<Tm33File>(again->file);
    if (second.emitters != file.emitters || second.header != file.header || second.goniometer != file.goniometer)
        std::abort();
    const Result<Profile> third = read_profile(write_tm33(second), "fuzz", {ProfileFormat::tm33, false});
    if (!third || !test::equal(third->file, again->file)) std::abort();
    static_cast<void>(read_profile(bytes, "fuzz.xml")); // recognises the format
    return 0;
}
