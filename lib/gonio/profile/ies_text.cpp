// Names for values that LM-63 writes as numbers.
#include <gonio/profile/profile.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace gonio {

const char* to_text(IesVersion version) {
    switch (version) {
    case IesVersion::lm63_1986:
        return "LM-63-1986";
    case IesVersion::lm63_1991:
        return "LM-63-1991";
    case IesVersion::lm63_1995:
        return "LM-63-1995";
    case IesVersion::lm63_2002:
        return "LM-63-2002";
    case IesVersion::lm63_2019:
        break;
    }
    return "LM-63-2019";
}

const char* file_generation_type(const IesFile& file) {
    static constexpr std::array<std::pair<double, const char*>, 10> types{{
        {1.00001, "undefined, or an older file"},
        {1.00010, "computer simulation"},
        {1.00000, "test at an unaccredited laboratory"},
        {1.00100, "test at an unaccredited laboratory, lumens scaled"},
        {1.01000, "test at an unaccredited laboratory, angles interpolated"},
        {1.01100, "test at an unaccredited laboratory, angles interpolated and lumens scaled"},
        {1.10000, "test at an accredited laboratory"},
        {1.10100, "test at an accredited laboratory, lumens scaled"},
        {1.11000, "test at an accredited laboratory, angles interpolated"},
        {1.11100, "test at an accredited laboratory, angles interpolated and lumens scaled"},
    }};
    if (file.version != IesVersion::lm63_2019) return nullptr;
    constexpr double rounding = 1e-7;
    for (const auto& [number, text] : types)
        if (std::abs(file.field_12 - number) < rounding) return text;
    return nullptr;
}

} // namespace gonio
