// The diagnostic codes of the web room: what `gonio explain CODE` says and what resolve_web may emit. A code is stable.
#pragma once

#include <string_view>

namespace gonio {

struct WebCode {
    std::string_view code;
    std::string_view title;
    std::string_view explanation;
};

// All are warnings.
inline constexpr WebCode web_codes[] = {
    {"WEB0101", "the last C-plane is missing",
     "A table without symmetry should list its first plane again at 360°. This one ends one step before; the gap is "
     "closed with the first plane."},
    {"WEB0102", "C-planes do not cover the circle",
     "The planes end further than one step before the first one comes round again, and their range is none that means "
     "a symmetry. Outside them the light is taken as dark."},
    {"WEB0103", "a single C-plane that is not at 0°",
     "One plane means the same light for every C, wherever it was measured."},
    {"WEB0104", "a factor where the standard has none",
     "LM-63-1986 and -1991 have a ballast-lamp factor as the twelfth number; LM-63-1995 and -2002 reserve it as 1. It "
     "is not applied."},
    {"WEB0105", "negative intensities",
     "Stray light that is subtracted from a measurement can leave values below 0. They count in flux and samples as "
     "they are; textures and pictures hold 0 for them."},
    {"WEB0106", "no light", "Every intensity of the table is 0."},
};

} // namespace gonio
