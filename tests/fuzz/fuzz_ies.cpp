// libFuzzer: for any bytes, the LM-63 reader does not crash and allocates no memory for numbers that are only
// announced; strict reading accepts nothing that tolerant reading refuses; and the result is the same after writing and
// reading it again.
#include <gonio/profile/read.hpp>
#include <gonio/profile/write.hpp>

#include "../unit/profile/same_reading.hpp"

#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace gonio;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as text
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Result<Profile> read = read_profile(bytes, "fuzz", {ProfileFormat::ies, false});
    for (const bool strictly : {false, true})
        if (!test::difference_of_readings(bytes, "fuzz", {ProfileFormat::ies, strictly}).empty()) std::abort();
    const Result<Profile> strict = read_profile(bytes, "fuzz", {ProfileFormat::ies, true});
    if (strict && (!read || !test::equal(read->file, strict->file))) std::abort();
    if (!read) {
        const Diagnostics& diagnostics = read.error().diagnostics;
        if (diagnostics.empty() || diagnostics.back().severity != Severity::error) std::abort();
        return 0;
    }
    const std::string written = write_ies(std::get<IesFile>(read->file));
    const Result<Profile> again = read_profile(written, "fuzz", {ProfileFormat::ies, false});
    if (!again || !test::equal(read->file, again->file)) std::abort();
    static_cast<void>(read_profile(bytes, "fuzz.ies")); // recognises the format
    return 0;
}
