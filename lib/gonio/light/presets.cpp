#include <gonio/base/named.hpp>
#include <gonio/light/presets.hpp>

#include <array>

namespace gonio {

namespace {

constexpr std::string_view replacement_lamps = "Regulation (EU) No 874/2012, equivalence of lamps";
constexpr std::string_view rated_tubes = "IEC 60081, rated flux";
constexpr std::string_view handbook = "IES Lighting Handbook, luminances of common sources";

constexpr std::array presets{
    LightPreset{"candle", "1cd", "sphere:r=1cm", "a candle's flame", "the old unit of intensity: about 1 cd"},
    LightPreset{"incandescent-40", "470lm", "sphere:r=3cm", "40 W tungsten lamp, frosted", replacement_lamps},
    LightPreset{"incandescent-60", "806lm", "sphere:r=3cm", "60 W tungsten lamp, frosted, or the LED that replaces it",
                replacement_lamps},
    LightPreset{"incandescent-100", "1521lm", "sphere:r=3cm", "100 W tungsten lamp, frosted", replacement_lamps},
    LightPreset{"fluorescent-tube", "3350lm", "tube:r=1.3cm,l=1.2m", "T8 tube of 36 W", rated_tubes},
    LightPreset{"tube-t8-18", "1350lm", "tube:r=1.3cm,l=59cm", "T8 tube of 18 W, 60 cm", rated_tubes},
    LightPreset{"tube-t8-36", "3350lm", "tube:r=1.3cm,l=1.2m", "T8 tube of 36 W, 120 cm", rated_tubes},
    LightPreset{"tube-t8-58", "5200lm", "tube:r=1.3cm,l=1.5m", "T8 tube of 58 W, 150 cm", rated_tubes},
    LightPreset{"tube-t5-14", "1200lm", "tube:r=8mm,l=54.9cm", "T5 tube of 14 W, 55 cm", rated_tubes},
    LightPreset{"tube-t5-28", "2600lm", "tube:r=8mm,l=114.9cm", "T5 tube of 28 W, 115 cm", rated_tubes},
    LightPreset{"tube-t5-35", "3300lm", "tube:r=8mm,l=144.9cm", "T5 tube of 35 W, 145 cm", rated_tubes},
    LightPreset{"tube-t5-54", "4450lm", "tube:r=8mm,l=114.9cm", "T5 tube of 54 W, high output, 115 cm", rated_tubes},
    LightPreset{"led-panel", "3600lm", "rect:w=60cm,h=60cm", "an office's ceiling panel of 60 by 60 cm, 36 W",
                "100 lm/W, as such panels are sold"},
    LightPreset{"softbox", "5000lm", "rect:w=60cm,h=90cm", "a photographer's softbox with an LED lamp of 50 W",
                "100 lm/W, as such lamps are sold"},
    LightPreset{"tv", "300nt", "rect:w=121.8cm,h=68.5cm", "a 55 inch television, white",
                "the usual setting of a living room"},
    LightPreset{"phone", "500nt", "rect:w=6.5cm,h=14cm", "a phone's display of 6.1 inches, white, indoors",
                "full brightness without sunlight mode"},
    LightPreset{"headlamp-h7", "1500lm", "point", "a car's H7 lamp, bare", "UN Regulation No. 37"},
    LightPreset{"monitor", "250nt", "rect:w=53cm,h=30cm", "a 24 inch office display, white",
                "ISO 9241-307, usual office setting"},
    LightPreset{"reference-display", "80nt", "rect:w=53cm,h=30cm", "the display that sRGB was made for",
                "IEC 61966-2-1"},
    LightPreset{"overcast-sky", "2000nt", "sun:angle=180deg", "the whole sky, overcast", handbook},
    LightPreset{"clear-sky", "8000nt", "sun:angle=180deg", "the whole sky, clear, without the sun", handbook},
    LightPreset{"full-sun", "100klx", "sun:angle=0.53deg", "the sun at noon, without the sky",
                "IES Lighting Handbook, daylight"},
    LightPreset{"full-moon", "0.25lx", "sun:angle=0.52deg", "the full moon, high in a clear sky",
                "Krisciunas and Schaefer, 1991, magnitude -12.7"},
};

} // namespace

std::span<const LightPreset> light_presets() {
    return presets;
}

Result<const LightPreset*> find_preset(std::string_view name) {
    return find_named("preset", name, presets);
}

} // namespace gonio
