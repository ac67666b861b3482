// libFuzzer: any words of a command line are refused with one reason or have a sound meaning, the same each time, and
// the same after writing and reading it again. The first byte selects the reader. Files that words name are not opened:
// their readers have their own fuzz targets.
#include <gonio/bake/layout.hpp>
#include <gonio/bake/texture.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/light/efficacy.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/light/photometric_value.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/scene/parameter.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/web/author.hpp>

#include "../../cli/arguments.hpp"
#include "../../cli/command.hpp"
#include "../../cli/options/values.hpp"
#include "../../cli/preview/sweep_axis.hpp"
#include "check.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace gonio;
using namespace gonio::fuzz;

constexpr auto alike = [](const auto&, const auto&) { return true; };

// Texts that contain a spectrum and its file are skipped.
bool names_spectrum(std::string_view text) {
    return text.find("spectrum:") != std::string_view::npos;
}

bool positive(double value) {
    return value > 0.0 && std::isfinite(value);
}

bool share(double value) {
    return value >= 0.0 && value <= 1.0;
}
bool share(const glm::dvec3& color) {
    return share(color.x) && share(color.y) && share(color.z);
}

struct SoundShape {
    void operator()(const PointShape&) const {}
    void operator()(const SpotShape& spot) const {
        require(spot.inner.value >= 0.0 && spot.inner.value <= spot.outer.value);
        require(spot.outer.value <= std::numbers::pi / 2.0);
    }
    void operator()(const FrustumShape& frustum) const {
        for (const double angle : {frustum.horizontal.value, frustum.vertical.value})
            require(angle > 0.0 && angle < std::numbers::pi);
    }
    void operator()(const ProfileShape& measured) const { require(!measured.file.empty() && !measured.web); }
    void operator()(const SphereShape& sphere) const { require(positive(sphere.radius.value)); }
    void operator()(const DiskShape& disk) const { require(positive(disk.radius.value)); }
    void operator()(const EllipseShape& ellipse) const {
        require(positive(ellipse.width.value) && positive(ellipse.height.value));
    }
    void operator()(const RectShape& rect) const { require(positive(rect.width.value) && positive(rect.height.value)); }
    void operator()(const TubeShape& tube) const {
        require(positive(tube.radius.value) && positive(tube.length.value));
    }
    void operator()(const CylinderShape& cylinder) const {
        require(positive(cylinder.radius.value) && positive(cylinder.length.value));
    }
    void operator()(const SunShape& sun) const {
        require(sun.diameter.value > 0.0 && sun.diameter.value <= std::numbers::pi);
    }
};

void shape(std::string_view text) {
    const auto same = [](const Shape& a, const Shape& b) { return a.index() == b.index(); };
    const Result<Shape> read = read_twice([&] { return parse_shape(text); }, same);
    if (!read) return;
    std::visit(SoundShape{}, *read);
    require(text.starts_with(kind_of(*read)));
}

// Each key holds a number or a colour in [0, 1].
void require_sound(const Material& read) {
    std::visit([]<class M>(const M& m) { for_each_key<M>([&](const auto& key) { require(share(m.*key.member)); }); },
               base_of(read));
    if (const auto* coated = std::get_if<CoatedMaterial>(&read))
        require(share(coated->coat.amount) && share(coated->coat.smoothness));
}

// "KIND:key=value" and, after a blank, a parameter to set: "roughness=0.3".
void material(std::string_view text) {
    const std::size_t blank = text.find(' ');
    const auto same = [](const Material& a, const Material& b) { return a.index() == b.index(); };
    Result<Material> read = read_twice([&] { return parse_material(text.substr(0, blank)); }, same);
    if (!read) return;
    require_sound(*read);
    if (blank == std::string_view::npos) return;
    const std::string_view setting = text.substr(blank + 1);
    const std::size_t equals = setting.find('=');
    if (equals == std::string_view::npos) return;
    const Result<bool> set = set_parameter(*read, setting.substr(0, equals), setting.substr(equals + 1));
    if (!set) require_reason(set.error());
    require_sound(*read);
}

void color(std::string_view text) {
    if (names_spectrum(text)) return;
    Diagnostics diagnostics;
    const auto same = [](const glm::dvec3& a, const glm::dvec3& b) { return a == b; };
    const Result<glm::dvec3> read = read_twice([&] { return parse_light_color(text, &diagnostics); }, same);
    for (const Diagnostic& said : diagnostics)
        require(said.severity != Severity::error && !said.message.empty());
    if (!read) return;
    // Luminance 1, and no negative channel.
    require(read->x >= 0.0 && read->y >= 0.0 && read->z >= 0.0);
    require(std::abs(glm::dot(*read, rec709_luminance) - 1.0) < 1e-9);
}

void photometric_value(std::string_view text) {
    if (names_spectrum(text)) return;
    const auto same = [](const PhotometricValue& a, const PhotometricValue& b) {
        return a.number == b.number && a.unit.unit == b.unit.unit;
    };
    const Result<PhotometricValue> read = read_twice([&] { return parse_photometric_value(text); }, same);
    if (read) {
        require(std::isfinite(read->number) && read->unit.unit != nullptr);
        require(!read->unit.distance || positive(read->unit.distance->value));
        require(!read->unit.efficacy_lm_per_w ||
                (*read->unit.efficacy_lm_per_w > 0.0 && *read->unit.efficacy_lm_per_w <= 683.002));
    }
    static_cast<void>(read_twice([&] { return parse_photometric_unit(text); }, alike));
    static_cast<void>(read_twice([&] { return parse_efficacy(text); }, alike));
}

void amount(std::string_view text) {
    const auto same = [](const Amount& a, const Amount& b) { return a.number == b.number && a.unit == b.unit; };
    const Result<Amount> read = read_twice([&] { return parse_amount(text); }, same);
    if (read) {
        const Result<Amount> again = parse_amount(shortest(read->number) + std::string(read->unit->symbol));
        require(again.has_value() && same(*read, *again));
    }
    for (const Dimension dimension : {Dimension::length, Dimension::angle, Dimension::temperature}) {
        const Result<double> base = parse_amount(text, dimension, "the value");
        if (base)
            require(std::isfinite(*base) && *base == read->in_base_units());
        else
            require_reason(base.error());
    }
    if (const std::optional<double> number = parse_number(text))
        require(std::isfinite(*number) && parse_number(shortest(*number)) == number);
    const Result<Nits> sky = parse_uniform_sky(text);
    if (sky)
        require(sky->value >= 0.0 && std::isfinite(sky->value));
    else
        require_reason(sky.error());
}

void temperature(std::string_view text) {
    const auto same = [](Cct a, Cct b) { return a.temperature.value == b.temperature.value && a.duv == b.duv; };
    if (const Result<Cct> read = read_twice([&] { return parse_cct(text); }, same)) {
        require(std::isfinite(read->temperature.value) && std::isfinite(read->duv));
        for (const Locus locus : {Locus::planckian, Locus::daylight, Locus::blend}) {
            const Result<Uv> at = uv_of(*read, locus);
            if (!at)
                require_reason(at.error());
            else
                require(std::isfinite(at->u) && std::isfinite(at->v));
        }
    }
    static_cast<void>(read_twice([&] { return parse_tint(text); }, std::equal_to<>()));
    static_cast<void>(read_twice([&] { return parse_locus(text); }, std::equal_to<>()));
    const Result<Band> band = read_twice([&] { return parse_band(text); }, alike);
    if (band) require(band->first_nm < band->last_nm);
}

void kind_text(std::string_view text) {
    const auto same = [](const KindText& a, const KindText& b) {
        return a.kind == b.kind && std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(), b.entries.end(),
                                              [](const KindText::Entry& x, const KindText::Entry& y) {
                                                  return x.key == y.key && x.value == y.value;
                                              });
    };
    const Result<KindText> read = read_twice([&] { return parse_kind_text(text); }, same);
    if (!read) return;
    require(!read->kind.empty());
    std::string written = read->kind + ":";
    for (const KindText::Entry& entry : read->entries) {
        require(!entry.key.empty());
        written += entry.key;
        if (entry.value) written += "=" + *entry.value;
        written += ",";
    }
    written.pop_back();
    const Result<KindText> again = parse_kind_text(written);
    require(again.has_value() && same(*read, *again));
}

void authored_shape(std::string_view text) {
    const Result<AuthoredShape> read = read_twice([&] { return parse_authored(text); }, alike);
    if (!read) return;
    require(read->gamma_end_deg == 90.0 || read->gamma_end_deg == 180.0);
    AuthorOptions options;
    options.horizontal_step_deg = 45.0;
    options.vertical_step_deg = 15.0;
    const Result<Web> web = authored(*read, options);
    if (!web)
        require_reason(web.error());
    else
        require(positive(web->candela(0.0, 0.0)) || web->candela(0.0, 0.0) == 0.0);
}

void option_value(std::string_view text) {
    const auto same_size = [](cli::PixelSize a, cli::PixelSize b) {
        return a.width == b.width && a.height == b.height;
    };
    if (const Result<cli::PixelSize> size = read_twice([&] { return cli::parse_size(text); }, same_size))
        require(size->width >= 0 && size->height >= 0);
    const Result<glm::dvec3> vector = read_twice([&] { return cli::parse_vector(text, "--at"); }, std::equal_to<>());
    if (vector) {
        const std::string written = shortest(vector->x) + "," + shortest(vector->y) + "," + shortest(vector->z);
        const Result<glm::dvec3> again = cli::parse_vector(written, "--at");
        require(again.has_value() && *again == *vector);
    }
    const auto count = read_twice([&] { return cli::whole_number(text, "--samples"); }, std::equal_to<>());
    if (count) require(cli::whole_number(std::to_string(*count), "--samples") == *count);
    static_cast<void>(read_twice([&] { return parse_layout(text); }, std::equal_to<>()));
    static_cast<void>(read_twice([&] { return parse_normalization(text); }, std::equal_to<>()));
    const auto same_axis = [](const cli::SweepAxis& a, const cli::SweepAxis& b) { return a.values == b.values; };
    const auto axis = read_twice([&] { return cli::parse_sweep_axis(text); }, same_axis);
    if (!axis) return;
    require(!axis->key.empty() && !axis->values.empty() && axis->values.size() <= cli::most_sweep_values);
    for (std::size_t i = 0; i < axis->values.size(); ++i)
        require(!axis->label(i).empty());
}

// A sky, a time and a place: a sky that is understood has luminances.
void sky(std::string_view text) {
    if (names_spectrum(text)) return;
    static_cast<void>(read_twice([&] { return parse_place(text); }, alike));
    const auto same_time = [](Instant a, Instant b) { return a.days_since_j2000 == b.days_since_j2000; };
    if (const Result<Instant> time = read_twice([&] { return parse_time(text); }, same_time)) {
        require(time->day_of_year() >= 1 && time->day_of_year() <= 366);
        const SkyAngles sun = apparent_solar_position({52.0, 13.0}, *time);
        require(sun.azimuth_deg >= 0.0 && sun.azimuth_deg < 360.0 && std::abs(sun.elevation_deg) <= 91.0);
    }
    const auto same_sky = [](const SkyDescription& a, const SkyDescription& b) {
        return a.kind.index() == b.kind.index() && a.color == b.color && a.ground == b.ground;
    };
    const Result<SkyDescription> read = read_twice([&] { return parse_sky_description(text); }, same_sky);
    if (!read) return;
    require(share(read->ground));
    if (const auto* const image = std::get_if<ImageSkyKind>(&read->kind)) {
        require(!image->file.empty());
        return; // its file has not been read
    }
    const Result<Sky> resolved = resolve_sky(*read);
    if (!resolved) {
        require_reason(resolved.error());
        return;
    }
    for (const glm::dvec3& direction :
         {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0), glm::normalize(glm::dvec3(1, 2, 3))}) {
        const glm::dvec3 light = resolved->radiance(direction);
        require(light.x >= 0.0 && light.y >= 0.0 && light.z >= 0.0 && std::isfinite(light.x + light.y + light.z));
    }
    if (resolved->sun())
        require(std::isfinite(resolved->sun()->illuminance.value) && resolved->sun()->direction.z > 0.0);
}

// The next byte selects the command; the lines are the words after it.
void arguments(std::string_view text) {
    if (text.empty()) return;
    const std::span<const cli::Command* const> commands = cli::commands();
    const cli::Command& command = *commands[take_choice(text, commands.size())];
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (c == '\0') return; // words end there
        if (c == '\n')
            words.emplace_back();
        else
            words.back() += c;
    }
    std::vector<std::string> options;
    for (const cli::OptionGroup& group : command.groups)
        for (const cli::Option& option : group.options)
            options.emplace_back(cli::spellings(option).back());
    const auto parse = [&command](std::vector<std::string>& given) {
        std::vector<char*> pointers;
        for (std::string& word : given)
            pointers.push_back(word.data());
        return cli::Arguments::parse(command, pointers);
    };
    const auto same = [&options](const cli::Arguments& a, const cli::Arguments& b) {
        return a.positional() == b.positional() &&
               std::all_of(options.begin(), options.end(), [&](const std::string& option) {
                   return a.has(option) == b.has(option) && a.values(option) == b.values(option);
               });
    };
    // Nothing more is compared: CLI11 may split a cluster of short options ("-q1v" is "-q" and "-1v") in any way.
    (void)read_twice([&] { return parse(words); }, same);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text = as_text(data, size);
    if (text.empty()) return 0;
    constexpr std::array readers{shape,     material,       color,        photometric_value, amount, temperature,
                                 kind_text, authored_shape, option_value, arguments,         sky};
    readers[take_choice(text, readers.size())](text);
    return 0;
}
