#include "look_options.hpp"

#include <gonio/base/named.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/preview/exposure.hpp>

#include "../options/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gonio::cli {

namespace {

Dimension dimension_of(PictureQuantity quantity) {
    return quantity == PictureQuantity::illuminance ? Dimension::illuminance : Dimension::luminance;
}

Result<PictureQuantity> parse_quantity(const std::string& text) {
    constexpr std::array quantities{Named{"illuminance", PictureQuantity::illuminance},
                                    Named{"luminance", PictureQuantity::luminance}};
    return find_value("quantity", text, quantities);
}

// The unit determines the quantity if none is named.
Result<void> read_quantity(const Arguments& arguments, LookRequest& request) {
    if (request.look == Look::luminance) request.quantity = PictureQuantity::luminance;
    const auto named = arguments.value("--quantity");
    if (named) {
        Result<PictureQuantity> quantity = parse_quantity(*named);
        if (!quantity) return pass_on(quantity);
        if (request.look == Look::luminance && *quantity != PictureQuantity::luminance)
            return fail("USE0107", "the display mode luminance shows only luminance", "use --look falsecolour for lux");
        request.quantity = *quantity;
    }
    const auto text = arguments.value("--unit");
    if (!text) {
        request.unit = find_unit(request.quantity == PictureQuantity::illuminance ? "lx" : "nt");
        return {};
    }
    const Unit* const unit = find_unit(*text);
    const bool of_lux = unit != nullptr && unit->dimension == Dimension::illuminance;
    const bool of_nits = unit != nullptr && unit->dimension == Dimension::luminance;
    if (!of_lux && !of_nits)
        return fail("USE0105", fmt::format("'{}' is not a unit of illuminance or luminance", *text),
                    "use lx or fc for illuminance, nt, cd/m2 or fL for luminance");
    if (!named && request.look != Look::luminance)
        request.quantity = of_lux ? PictureQuantity::illuminance : PictureQuantity::luminance;
    if (unit->dimension != dimension_of(request.quantity))
        return fail("USE0107", fmt::format("{} is not measured in {}", to_text(request.quantity), *text),
                    of_lux ? "use nt, cd/m2 or fL" : "use lx or fc");
    request.unit = unit;
    return {};
}

// "log", "linear", "LOW:HIGH", "log:LOW:HIGH", "linear:LOW:HIGH".
Result<void> read_scale(std::string_view text, LookRequest& request) {
    const auto wrong = [&](const std::string& message) {
        return fail("USE0105", message,
                    request.quantity == PictureQuantity::illuminance
                        ? "write log, linear, LOW:HIGH or linear:LOW:HIGH, for example 0.1lx:1000lx"
                        : "write log, linear, LOW:HIGH or linear:LOW:HIGH, for example 0.1nt:1000nt");
    };
    const std::string_view whole = text;
    for (const auto& [name, logarithmic] : {std::pair{"log", true}, std::pair{"linear", false}}) {
        const std::string_view word = name;
        if (!text.starts_with(word) || (text.size() > word.size() && text[word.size()] != ':')) continue;
        request.logarithmic = logarithmic;
        if (text.size() == word.size()) return {};
        text.remove_prefix(word.size() + 1);
        break;
    }
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos || text.find(':', colon + 1) != std::string_view::npos)
        return wrong(fmt::format("'{}' is not a scale", whole));
    ValueScale scale;
    for (auto [end, part] :
         {std::pair{&scale.low, text.substr(0, colon)}, std::pair{&scale.high, text.substr(colon + 1)}}) {
        Result<double> value = parse_amount(part, dimension_of(request.quantity), "each end of --scale");
        if (!value) return pass_on(value);
        *end = *value;
    }
    if (!(scale.low < scale.high) || scale.low < 0.0)
        return wrong(fmt::format("the scale '{}' must rise from 0 or more", whole));
    scale.logarithmic = request.logarithmic;
    if (scale.logarithmic && !(scale.low > 0.0))
        return wrong(fmt::format("the scale '{}' begins at 0, which a logarithmic scale cannot show", whole));
    request.scale = scale;
    return {};
}

Result<void> read_levels(std::string_view text, LookRequest& request) {
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view part = text.substr(begin, end - begin);
        begin = end + 1;
        Result<double> level = parse_amount(part, dimension_of(request.quantity), "each of --levels");
        if (!level) return pass_on(level);
        if (!(*level > 0.0) || (!request.levels.empty() && *level <= request.levels.back()))
            return fail("USE0106", fmt::format("the levels '{}' must rise from above 0", text),
                        "write them in ascending order, for example --levels 1lx,5lx,10lx");
        request.levels.push_back(*level);
    }
    return {};
}

// An option that the display mode would ignore is an error.
Result<void> only_useful(const Arguments& arguments, Look look) {
    struct Use {
        std::string_view option;
        std::array<bool, 4> by_look; // beauty, falsecolour, isolux, luminance
    };
    constexpr std::array uses{
        Use{"--quantity", {false, true, true, true}}, Use{"--unit", {false, true, true, true}},
        Use{"--scale", {false, true, false, false}},  Use{"--palette", {false, true, true, false}},
        Use{"--levels", {false, false, true, false}}, Use{"--no-legend", {false, true, true, true}},
        Use{"--exposure", {true, false, true, true}}, Use{"--tone-map", {true, false, true, true}}};
    for (const Use& use : uses) {
        if (!arguments.has(use.option) || use.by_look[static_cast<std::size_t>(look)]) continue;
        std::string names;
        for (const LookName& known : looks())
            if (use.by_look[static_cast<std::size_t>(known.look)])
                names += fmt::format("{}{}", names.empty() ? "" : " or ", known.name);
        return fail("USE0107", fmt::format("the display mode {} does not take {}", to_text(look), use.option),
                    fmt::format("add --look {}", names));
    }
    return {};
}

Result<void> fits_format(const LookRequest& request, const media::ImageFormat& format) {
    if (request.look == Look::beauty || !has_pixel(format, media::Pixel::float32)) return {};
    if (request.look == Look::isolux)
        return fail("USE0107", fmt::format("{} holds values, not lines", format.title),
                    "write .png, or write the values with --look falsecolour");
    if (!format.channels.empty() &&
        std::find(format.channels.begin(), format.channels.end(), 1) == format.channels.end())
        return fail("USE0107",
                    fmt::format("{} cannot hold the single channel of {}", format.title, to_text(request.quantity)),
                    "write .exr for the values, .png for the picture");
    return {};
}

} // namespace

Result<LookRequest> read_look(const Arguments& arguments, const media::ImageFormat& format) {
    LookRequest request;
    Result<Look> look = parse_look(arguments.value("--look").value_or("beauty"));
    if (!look) return pass_on(look);
    request.look = *look;
    Result<void> fine = only_useful(arguments, *look);
    if (fine) fine = fits_format(request, format);
    if (fine) fine = read_quantity(arguments, request);
    const auto scale = arguments.value("--scale");
    if (fine && scale) fine = read_scale(*scale, request);
    const auto levels = arguments.value("--levels");
    if (fine && levels) fine = read_levels(*levels, request);
    if (!fine) return pass_on(fine);
    Result<const Palette*> palette = find_palette(arguments.value("--palette").value_or("viridis"));
    if (!palette) return pass_on(palette);
    request.palette = *palette;
    request.legend = !arguments.has("--no-legend");
    return request;
}

Ev100 ExposureRequest::of(const Rendering& rendering, unsigned threads) const {
    return mode == ExposureMode::automatic
               ? auto_exposure(rendering.luminance_nt, rendering.shows_light, rendering.shows_subject, threads)
               : ev;
}

Result<void> read_exposure_value(const std::string& text, ExposureRequest& request) {
    constexpr std::string_view card = "lux:";
    if (text.starts_with(card)) {
        Result<double> lux = parse_amount(std::string_view(text).substr(card.size()), Dimension::illuminance,
                                          "what follows lux: in --exposure");
        if (!lux) return pass_on(lux);
        if (!(*lux > 0.0)) return fail("USE0104", fmt::format("--exposure {} needs an illuminance above 0", text));
        request.mode = ExposureMode::card;
        request.ev = exposure_of_card(Lux(*lux));
    } else if (text == "auto") {
        request.mode = ExposureMode::automatic;
    } else {
        if (const Result<Amount> amount = parse_amount(text);
            amount && amount->unit->dimension == Dimension::illuminance)
            return fail("USE0105", fmt::format("write an exposure in lux as lux:{}", text),
                        "a matte 18 % card under that illuminance is then middle grey");
        const std::optional<double> bare = parse_number(text); // "6" is "6ev"
        Result<double> ev = bare ? Result<double>(*bare) : parse_amount(text, Dimension::luminance_ev, "--exposure");
        if (!ev) return pass_on(ev);
        request.mode = ExposureMode::ev;
        request.ev = Ev100(*ev);
    }
    constexpr double most = 100.0; // white is 1.5e30 cd/m² then; a picture holds less
    if (!(std::abs(request.ev.value) <= most))
        return fail("USE0106", fmt::format("--exposure {} is out of range", text),
                    fmt::format("it must lie between -{0}ev and {0}ev", most));
    return {};
}

namespace {

Result<void> read_white_balance(const Arguments& arguments, bool floats, ExposureRequest& request) {
    const auto text = arguments.value("--white-balance");
    if (!text || *text == "off") return {};
    if (floats)
        return fail("USE0107", "--white-balance is for a display; an .exr keeps the colours of the light",
                    "write .png");
    if (arguments.value("--look").value_or("beauty") != "beauty")
        return fail("USE0107", "--white-balance needs the display mode beauty");
    request.auto_white = *text == "auto";
    if (request.auto_white) return {};
    Result<Cct> cct = parse_cct(*text);
    if (!cct) return pass_on(cct);
    Result<Uv> white = uv_of(*cct);
    if (!white) return pass_on(white);
    request.white = to_xy(*white);
    return {};
}

// "age=60,pigment=1".
Result<Eye> read_eye(std::string_view text) {
    struct Part {
        std::string_view key;
        double Eye::*value;
        double most;
    };
    constexpr std::array parts{Part{"age", &Eye::age_years, 100.0}, Part{"pigment", &Eye::pigment, 1.2}};
    Eye eye;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        begin = end + 1;
        const std::size_t equals = std::min(word.find('='), word.size());
        const auto part = std::find_if(parts.begin(), parts.end(),
                                       [&](const Part& known) { return known.key == word.substr(0, equals); });
        if (part == parts.end() || equals == word.size())
            return fail("USE0105", fmt::format("--eye takes age and pigment, not '{}'", word),
                        "for example --eye age=60,pigment=1");
        const std::optional<double> value = parse_number(word.substr(equals + 1));
        if (!value)
            return fail("USE0105", fmt::format("--eye '{}' needs a number", word),
                        "for example --eye age=60,pigment=1");
        if (!(*value >= 0.0 && *value <= part->most))
            return fail("USE0106", fmt::format("--eye '{}' is out of range", word),
                        fmt::format("{} lies between 0 and {}", part->key, part->most));
        eye.*(part->value) = *value;
    }
    return eye;
}

Result<void> read_glare(const Arguments& arguments, bool floats, ExposureRequest& request) {
    const auto text = arguments.value("--eye");
    if (!arguments.has("--glare")) {
        if (text) return fail("USE0107", "--eye is for --glare, which is not given", "add --glare");
        return {};
    }
    if (floats) return fail("USE0107", "--glare is for a display; an .exr keeps the light of the scene", "write .png");
    if (arguments.value("--look").value_or("beauty") != "beauty")
        return fail("USE0107", "--glare needs the display mode beauty",
                    "leave --look out: the other modes show values");
    request.glare = Eye();
    if (!text) return {};
    Result<Eye> eye = read_eye(*text);
    if (!eye) return pass_on(eye);
    request.glare = *eye;
    return {};
}

} // namespace

Result<ExposureRequest> read_exposure(const Arguments& arguments, const media::ImageFormat& format) {
    ExposureRequest request;
    if (Result<void> read = read_exposure_value(arguments.value("--exposure").value_or("auto"), request); !read)
        return pass_on(read);
    Result<ToneMap> map = parse_tone_map(arguments.value("--tone-map").value_or("none"));
    if (!map) return pass_on(map);
    request.tone_map = *map;
    const bool floats = has_pixel(format, media::Pixel::float32);
    if (Result<void> read = read_white_balance(arguments, floats, request); !read) return pass_on(read);
    if (Result<void> read = read_glare(arguments, floats, request); !read) return pass_on(read);
    if (*map == ToneMap::ue3_inverse && arguments.value("--look").value_or("beauty") != "beauty")
        return fail("USE0107", "ue3-inverse needs the display mode beauty");
    if (*map == ToneMap::ue3 && floats)
        return fail("USE0107", fmt::format("{} holds linear light, but ue3 is for a display", format.title),
                    "write .png, or use ue3-inverse");
    if (*map == ToneMap::ue3_inverse && !floats)
        return fail("USE0107", fmt::format("{} cannot hold values up to 8, which ue3-inverse gives", format.title),
                    "write .exr");
    for (const std::string_view option : {"--view", "--display", "--ocio"})
        if (*map != ToneMap::none && arguments.has(option))
            return fail("USE0107", fmt::format("--tone-map {} replaces {}", to_text(*map), option),
                        "leave one of them out");
    return request;
}

std::string_view to_text(ExposureMode mode) {
    constexpr std::array<std::string_view, 3> names{"auto", "ev", "lux"};
    return names[static_cast<std::size_t>(mode)];
}

} // namespace gonio::cli
