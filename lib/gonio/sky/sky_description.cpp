#include <gonio/base/amount_range.hpp>
#include <gonio/base/file_scope.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/sky/sky_description.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace gonio {

namespace {

struct MeasureKey {
    std::string_view key;
    SkyMeasure measure;
    Dimension dimension;
    std::string_view example;
};
constexpr std::array measure_keys{
    MeasureKey{"horizontal", SkyMeasure::horizontal, Dimension::illuminance, "20klx"},
    MeasureKey{"zenith", SkyMeasure::zenith, Dimension::luminance, "3000nt"},
    MeasureKey{"mean", SkyMeasure::mean, Dimension::luminance, "3000nt"},
};
static_assert(in_enum_order(measure_keys, &MeasureKey::measure, SkyMeasure::mean));

// What reading one text needs besides the text.
struct Reading {
    const KindText& text;
    Diagnostics* diagnostics;
    FileScope* files;

    const std::string* value(std::string_view key) const { return text.value(key); }

    const KindText::Entry* entry(std::string_view key) const {
        for (const KindText::Entry& candidate : text.entries)
            if (candidate.key == key) return &candidate;
        return nullptr;
    }

    Result<std::string> needed(std::string_view key, std::string_view what, std::string_view example) const {
        if (const std::string* const found = value(key)) return *found;
        return fail("USE0104", fmt::format("'{}' needs {}={}", text.kind, key, what),
                    fmt::format("for example {}={}", key, example));
    }
};

Result<SkyKind> read_uniform(const Reading& /*reading*/) {
    return SkyKind(UniformSkyKind{});
}

Result<SkyKind> read_cie(const Reading& reading) {
    const std::vector<KindText::Entry>& entries = reading.text.entries;
    // The type comes first and has no key: "cie:12".
    if (entries.empty() || entries.front().value)
        return fail("USE0104", "'cie' needs the number of a sky",
                    "write cie:12 for the standard clear sky, cie:1 for the standard overcast one; 'gonio list "
                    "cie-skies' shows all");
    Result<const CieSkyType*> type = find_cie_sky(entries.front().key);
    if (!type) return pass_on(type);
    CieSkyKind sky{*type, {0.0, 90.0}};
    const std::string* const sun = reading.value("sun");
    if (sun == nullptr && sky.type->needs_sun())
        return fail("USE0104", fmt::format("the CIE sky {} needs the direction of its sun", sky.type->name),
                    "add sun=AZIMUTH/ELEVATION, for example sun=180/40 for a sun 40 degrees high in the south");
    if (sun != nullptr) {
        Result<SkyAngles> at = parse_sky_angles(*sun, "the sun");
        if (!at) return pass_on(at);
        if (!(at->elevation_deg >= 0.0))
            return fail("USE0106",
                        fmt::format("the sun must not be below the horizon: its elevation is {} degrees",
                                    shortest(at->elevation_deg)),
                        "the azimuth comes first, counted from north over east: 180/40 is in the south");
        sky.sun = *at;
    }
    return SkyKind(sky);
}

Result<SkyKind> read_daylight(const Reading& reading) {
    DaylightSkyKind sky;
    Result<std::string> place = reading.needed("place", "LATITUDE/LONGITUDE", "52.52/13.405");
    if (!place) return pass_on(place);
    Result<Place> at = parse_place(*place);
    if (!at) return pass_on(at);
    sky.place = *at;
    Result<std::string> time = reading.needed("time", "TIME", "2024-06-21T12:00+02:00");
    if (!time) return pass_on(time);
    Result<Instant> when = parse_time(*time);
    if (!when) return pass_on(when);
    sky.time = *when;
    if (const std::string* const weather = reading.value("weather")) {
        Result<Weather> known = parse_weather(*weather);
        if (!known) return pass_on(known);
        sky.weather = *known;
    }
    if (const KindText::Entry* const refraction = reading.entry("refraction")) {
        if (refraction->value)
            return fail("USE0107", "'refraction' of 'daylight' takes no value", "write refraction alone");
        sky.refraction = true;
    }
    if (const std::string* const color = reading.value("sun-color")) {
        Result<glm::dvec3> rgb = parse_light_color(*color, reading.diagnostics, reading.files);
        if (!rgb) return pass_on(rgb);
        sky.sun_color = *rgb;
    }
    return SkyKind(sky);
}

Result<SkyKind> read_image(const Reading& reading) {
    ImageSkyKind sky;
    // Put first by image_text().
    if (reading.text.entries.empty() || reading.text.entries.front().key.empty())
        return fail("USE0104", "'image' needs a file", "write image:room.exr");
    sky.file = reading.text.entries.front().key;
    if (reading.files != nullptr) {
        if (sky.file == "-")
            return fail("USE0107", "the sky of a rig cannot be read from standard input", "name a file beside the rig");
        Result<std::string> path = reading.files->path_of(sky.file);
        if (!path) return pass_on(path);
        sky.file = *path;
    }
    if (const std::string* const layout = reading.value("layout")) {
        Result<EnvironmentLayout> known = parse_environment_layout(*layout);
        if (!known) return pass_on(known);
        sky.layout = *known;
    }
    if (const std::string* const space = reading.value("space")) sky.space = *space;
    if (const std::string* const bad = reading.value("bad-pixels")) {
        constexpr std::array choices{Named{"error", BadPixels::error}, Named{"black", BadPixels::black}};
        Result<BadPixels> known = find_value("choice", *bad, choices);
        if (!known) return pass_on(known);
        sky.bad_pixels = *known;
    }
    return SkyKind(sky);
}

// The name of the file is the first entry, whole.
Result<KindText> image_text(std::string_view text) {
    constexpr std::string_view prefix = "image:";
    const std::string_view rest = text.substr(prefix.size());
    const std::string_view file = file_before_keys(rest);
    Result<KindText> words = parse_kind_text(
        file.size() < rest.size() ? fmt::format("{}{}", prefix, rest.substr(file.size() + 1)) : std::string("image"));
    if (!words) return words;
    words->entries.insert(words->entries.begin(), {std::string(file), std::nullopt});
    return words;
}

constexpr std::array<std::string_view, 4> uniform_keys{"horizontal", "zenith", "mean", "color"};
constexpr std::array<std::string_view, 7> cie_keys{"sun", "horizontal", "zenith", "mean", "color", "rotate", "ground"};
constexpr std::array<std::string_view, 8> daylight_keys{"place", "time",   "weather", "refraction",
                                                        "color", "rotate", "ground",  "sun-color"};

constexpr std::array<std::string_view, 7> image_keys{"layout", "space", "bad-pixels", "horizontal",
                                                     "zenith", "mean",  "rotate"};

struct KindRow {
    SkyKindInfo info;
    std::span<const std::string_view> keys;
    bool takes_bare;   // the first entry is a name and not a key
    bool needs_amount; // else the kind has its own
    Result<SkyKind> (*read)(const Reading& reading);
    std::string_view name = info.name; // of find_named
};

constexpr std::array rows{
    KindRow{{"uniform", "uniform:horizontal=LUX|mean=NITS[,color=COLOR]",
             "the same luminance from every direction, also from below; short: 500lx, 150nt"},
            uniform_keys,
            false,
            true,
            read_uniform},
    KindRow{{"cie",
             "cie:TYPE[,sun=AZIMUTH/ELEVATION],horizontal=LUX|zenith=NITS|mean=NITS[,color=COLOR][,rotate=ANGLE]"
             "[,ground=ALBEDO]",
             "a general sky of the CIE, 1 to 15 or overcast, without the sun itself"},
            cie_keys,
            true,
            true,
            read_cie},
    KindRow{{"daylight",
             "daylight:place=LATITUDE/LONGITUDE,time=TIME[,weather=clear|partly|overcast][,refraction][,color=COLOR]"
             "[,sun-color=COLOR][,rotate=ANGLE][,ground=ALBEDO]",
             "sky and sun of a place and time, with the illuminances of the IES daylight availability model"},
            daylight_keys,
            false,
            false,
            read_daylight},
    KindRow{{"image",
             "image:FILE[,horizontal=LUX|zenith=NITS|mean=NITS][,rotate=ANGLE][,layout=LAYOUT][,space=SPACE]"
             "[,bad-pixels=black]",
             "a picture of the light from all around: EXR or HDR, in cd/m2 unless an amount is given"},
            image_keys,
            true,
            false,
            read_image},
};
static_assert(rows.size() == std::variant_size_v<SkyKind>); // in its order

constexpr auto infos = [] {
    std::array<SkyKindInfo, rows.size()> all;
    for (std::size_t i = 0; i < rows.size(); ++i)
        all[i] = rows[i].info;
    return all;
}();

Result<Nits> uniform_of(const Amount& amount, std::string_view text) {
    const bool is_lux = amount.unit->dimension == Dimension::illuminance;
    if (!is_lux && amount.unit->dimension != Dimension::luminance)
        return fail(
            "USE0105", fmt::format("a sky takes lux or nits, not '{}'", text),
            "give the illuminance of an open plane, for example 500lx, or the luminance of the sky, for example 150nt");
    if (!(amount.number >= 0.0)) return fail("USE0106", fmt::format("a sky cannot be negative: '{}'", text));
    const Nits sky{amount.in_base_units() * (is_lux ? std::numbers::inv_pi : 1.0)};
    if (!in_amount_range(sky.value))
        return fail("USE0106", fmt::format("a sky of '{}' is above {} cd/m2", text, greatest_amount));
    return sky;
}

Result<std::optional<SkyAmount>> read_amount(const Reading& reading) {
    std::optional<SkyAmount> amount;
    for (const MeasureKey& key : measure_keys) {
        const KindText::Entry* const entry = reading.entry(key.key);
        if (entry == nullptr) continue;
        if (!entry->value)
            return fail("USE0104", fmt::format("'{}' of '{}' needs an amount", key.key, reading.text.kind),
                        fmt::format("for example {}={}", key.key, key.example));
        if (amount)
            return fail("USE0107", fmt::format("'{}' has two amounts", reading.text.kind),
                        fmt::format("leave one of {} and {} out",
                                    measure_keys.at(static_cast<std::size_t>(amount->measure)).key, key.key));
        Result<double> value =
            parse_amount(*entry->value, key.dimension, fmt::format("{} of '{}'", key.key, reading.text.kind));
        if (!value) return pass_on(value);
        if (!(*value >= 0.0) || !in_amount_range(*value))
            return fail("USE0106", fmt::format("{} of '{}' must lie between 0 and {}, not {}", key.key,
                                               reading.text.kind, greatest_amount, *entry->value));
        amount = SkyAmount{key.measure, *value};
    }
    return amount;
}

// "cie:12,20klx" does not say what the amount is measured on.
Result<void> no_bare_amount(const KindText& text) {
    for (const KindText::Entry& entry : text.entries) {
        if (entry.value || entry.key.find_first_of("0123456789.") != 0) continue;
        const Result<Amount> amount = parse_amount(entry.key);
        if (!amount) continue;
        for (const MeasureKey& key : measure_keys)
            if (amount->unit->dimension == key.dimension)
                return fail(
                    "USE0104", fmt::format("'{}' of '{}' does not say what it is measured on", entry.key, text.kind),
                    key.measure == SkyMeasure::horizontal ? fmt::format("write horizontal={}", entry.key)
                                                          : fmt::format("write zenith={0} or mean={0}", entry.key));
    }
    return {};
}

Result<void> read_common(const Reading& reading, SkyDescription& sky) {
    if (const std::string* const color = reading.value("color")) {
        Result<glm::dvec3> rgb = parse_light_color(*color, reading.diagnostics, reading.files);
        if (!rgb) return pass_on(rgb);
        sky.color = *rgb;
    }
    if (const std::string* const rotate = reading.value("rotate")) {
        Result<double> angle =
            parse_amount(*rotate, Dimension::angle, fmt::format("rotate of '{}'", reading.text.kind));
        if (!angle) return pass_on(angle);
        sky.rotation = Radians(*angle);
    }
    if (const std::string* const ground = reading.value("ground")) {
        const std::optional<double> albedo = parse_number(*ground);
        if (!albedo || !(*albedo >= 0.0 && *albedo <= 1.0))
            return fail("USE0106",
                        fmt::format("ground of '{}' is an albedo from 0 to 1, not '{}'", reading.text.kind, *ground),
                        "for example ground=0.2");
        sky.ground = *albedo;
    }
    return {};
}

// Keys other than flags and the leading name need values.
Result<void> have_values(const Reading& reading, const KindRow& row) {
    for (std::size_t i = row.takes_bare ? 1 : 0; i < reading.text.entries.size(); ++i) {
        const KindText::Entry& entry = reading.text.entries[i];
        if (!entry.value && entry.key != "refraction")
            return fail("USE0104", fmt::format("'{}' of '{}' needs a value", entry.key, reading.text.kind),
                        fmt::format("the form is {}", row.info.grammar));
    }
    return {};
}

Result<void> read_keys(const Reading& reading, const KindRow& row, SkyDescription& sky) {
    KindText named = reading.text;
    if (row.takes_bare && !named.entries.empty() && !named.entries.front().value)
        named.entries.erase(named.entries.begin());
    if (Result<void> clear = no_bare_amount(named); !clear) return clear;
    if (Result<void> known = only_keys(named, row.keys); !known) return known;
    Result<SkyKind> kind = row.read(reading);
    if (!kind) return pass_on(kind);
    sky.kind = *kind;
    if (Result<void> values = have_values(reading, row); !values) return values;
    Result<std::optional<SkyAmount>> amount = read_amount(reading);
    if (!amount) return pass_on(amount);
    if (!*amount && row.needs_amount)
        return fail("USE0104", fmt::format("'{}' needs an amount", reading.text.kind),
                    "add horizontal=20klx, the illuminance of an open plane, or a luminance: mean=3000nt");
    sky.amount = *amount;
    return read_common(reading, sky);
}

} // namespace

std::span<const SkyKindInfo> sky_kinds() {
    return infos;
}

std::string_view name_of(const SkyKind& kind) {
    return infos.at(kind.index()).name;
}

std::string_view file_before_keys(std::string_view text) {
    for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',', comma + 1)) {
        const std::string_view after = text.substr(comma + 1);
        const std::size_t word = after.find_first_not_of("abcdefghijklmnopqrstuvwxyz-");
        if (word != std::string_view::npos && word > 0 && after[word] == '=') return text.substr(0, comma);
    }
    return text;
}

Result<Nits> parse_uniform_sky(std::string_view text) {
    Result<Amount> amount = parse_amount(text);
    if (!amount) return pass_on(amount);
    return uniform_of(*amount, text);
}

Result<SkyDescription> parse_sky_description(std::string_view text, Diagnostics* diagnostics, FileScope* files) {
    SkyDescription sky;
    if (!text.empty() && std::string_view("0123456789.+-").find(text.front()) != std::string_view::npos) {
        Result<Nits> uniform = parse_uniform_sky(text);
        if (!uniform) return pass_on(uniform);
        sky.kind = UniformSkyKind{};
        sky.amount = SkyAmount{SkyMeasure::mean, uniform->value};
        return sky;
    }
    Result<KindText> words = text.starts_with("image:") ? image_text(text) : parse_kind_text(text);
    if (!words) return pass_on(words);
    Result<const KindRow*> row = find_named("sky", words->kind, rows);
    if (!row) return pass_on(row);
    const Reading reading{*words, diagnostics, files};
    if (Result<void> read = read_keys(reading, **row, sky); !read) return pass_on(read);
    return sky;
}

} // namespace gonio
