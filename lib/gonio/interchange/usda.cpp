// UsdLux. L = intensity · 2^exposure · colour · black body [nits]; `normalize` divides by the
// area in the stage's units, and makes the intensity of a distant light its lux. Sizes are scaled by the transformation
// and the stage's metersPerUnit. Light goes along −Z; the axis of a cylinder is X. A cone is a half angle in degrees
// within which the light falls smoothly over the angle. A sphere that is treated as a point is a point.
#include <gonio/base/limits.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/planckian.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/interchange/detail/reading.hpp>
#include <gonio/interchange/detail/usda.hpp>
#include <gonio/light/light_color.hpp>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio::interchange_detail {

namespace {

using std::numbers::pi;

constexpr std::uint32_t no_prim = 0xffffffff;

class UsdReader {
public:
    UsdReader(UsdStage stage, const std::string& source, const SceneReadOptions& options)
        : stage_(std::move(stage)), layer_(stage_.layer), options_(options), source_(source) {}

    Result<FoundScene> read() {
        scene_.generator = layer_.doc;
        scene_.meters_per_unit = options_.unit.value_or(Meters(layer_.meters_per_unit)).value;
        up_ = options_.up.value_or(layer_.up);
        worlds_.resize(layer_.prims.size());
        for (std::uint32_t i = 0; i < layer_.prims.size(); ++i) {
            const UsdPrim& prim = layer_.prims[i];
            const bool is_light = prim.type.ends_with("Light") || prim.type.ends_with("Light_1");
            if (!is_light && !has_schema(prim, "MeshLightAPI") && !has_schema(prim, "VolumeLightAPI")) continue;
            if (Result<void> read = read_light(i); !read) return pass_on(read);
            if (scene_.lights.size() > limit("scene-lights").value)
                return scene_error("SCN0108", place(prim), fmt::format("more than {}", to_text(limit("scene-lights"))));
        }
        scene_.diagnostics.insert(scene_.diagnostics.begin(), stage_.diagnostics.begin(), stage_.diagnostics.end());
        if (scene_.lights.empty()) return std::move(scene_);
        if (!layer_.states_unit && !options_.unit)
            warn(scene_, "SCN0201", {source_, 0, 0}, "metersPerUnit is not stated: centimetres are assumed, as in USD",
                 "--unit-scale says what it is");
        if (!layer_.states_up && !options_.up)
            warn(scene_, "SCN0201", {source_, 0, 0}, "upAxis is not stated: Y is assumed, as in USD",
                 "--up says what it is");
        if (moves_)
            warn(scene_, "SCN0201", {source_, 0, 0}, "transformations change over time: their first samples are taken",
                 "--time 12 takes what holds at that time code");
        return std::move(scene_);
    }

private:
    Location place(const UsdPrim& prim) { return stage_.place(prim.layer, prim.offset); }
    Location place(const UsdValue& value) { return stage_.place(value.layer, value.offset); }

    // The value of an attribute; `inputs:` is left out before 21.02.
    const UsdValue* value(FoundLight* light, const UsdPrim& prim, std::string_view name) {
        std::optional<UsdOpinion> found = prim.find(fmt::format("inputs:{}", name));
        if (!found) found = prim.find(name);
        if (!found) return nullptr;
        if (found->is_connected && light != nullptr)
            remark(*light, "SCN0201", fmt::format("'{}' is connected to another prim: its own value is taken", name));
        const UsdAttribute& said = *found->said;
        if (said.samples.empty() || (said.value.is_set && !options_.time))
            return said.value.is_set ? &said.value : nullptr;
        const UsdValue* const then = options_.time ? at_time(*found, *options_.time) : first_of(*found);
        if (light != nullptr && !options_.time && said.samples.size() > 1) changing_.emplace_back(name);
        return then->is_set ? then : nullptr;
    }

    // There is one at least.
    static const UsdValue* first_of(const UsdOpinion& of) {
        return of.times.scale < 0.0 ? &of.said->samples.back().value : &of.said->samples.front().value;
    }

    // Outside the samples' times, the nearest. There is one at least.
    const UsdValue* at_time(const UsdOpinion& of, double scene_time) {
        const UsdAttribute& attribute = *of.said;
        // A scale of 0 has all samples at once.
        const double time = (scene_time - of.times.offset) / of.times.scale;
        if (std::isnan(time) || of.times.scale == 0.0) return first_of(of);
        const auto after = std::lower_bound(attribute.samples.begin(), attribute.samples.end(), time,
                                            [](const UsdSample& sample, double t) { return sample.time < t; });
        if (after == attribute.samples.begin()) return &after->value;
        const auto before = std::prev(after);
        if (after == attribute.samples.end()) return &before->value;
        if (after->time == time) return &after->value;
        const std::vector<double>& low = before->value.numbers;
        const std::vector<double>& high = after->value.numbers;
        constexpr std::size_t most = 16; // a matrix; longer ones are not of lights
        if (attribute.between == UsdBetween::held || !after->value.is_set || low.size() != high.size() ||
            low.size() > most || low.empty())
            return &before->value;
        // By halves where the whole difference is beyond the largest number.
        const double half = std::isfinite(after->time - before->time) ? 1.0 : 0.5;
        const double share = (half * time - half * before->time) / (half * after->time - half * before->time);
        UsdValue& made = made_.emplace_back();
        made.is_set = before->value.is_set;
        made.offset = before->value.offset;
        made.layer = before->value.layer;
        if (attribute.between == UsdBetween::turned && low.size() == 4) {
            const auto turn = [](const std::vector<double>& v) {
                return glm::normalize(glm::dquat(v[0], v[1], v[2], v[3]));
            };
            const glm::dquat between = glm::slerp(turn(low), turn(high), share);
            made.numbers = {between.w, between.x, between.y, between.z};
        } else {
            for (std::size_t i = 0; i < low.size(); ++i)
                made.numbers.push_back((1.0 - share) * low[i] + share * high[i]);
        }
        return &made;
    }

    // Where no time is given.
    void say_what_changes(FoundLight& light) const {
        if (changing_.empty()) return;
        const std::string others = changing_.size() == 1   ? std::string()
                                   : changing_.size() == 2 ? fmt::format(" and '{}'", changing_[1])
                                                           : fmt::format(" and {} more", changing_.size() - 1);
        remark(light, "SCN0201",
               fmt::format("'{}'{} over time: the first {}", changing_.front(),
                           others + (changing_.size() == 1 ? " changes" : " change"),
                           changing_.size() == 1 ? "sample is taken" : "samples are taken"),
               "--time 12 takes what holds at that time code");
    }

    Result<double> number(FoundLight& light, const UsdPrim& prim, std::string_view name, double otherwise) {
        const UsdValue* const found = value(&light, prim, name);
        if (found == nullptr) return otherwise;
        if (found->numbers.size() != 1)
            return scene_error("SCN0105", place(*found), fmt::format("'{}' must be a number", name));
        return found->numbers.front();
    }

    std::string path_of(std::uint32_t at) const {
        std::string path;
        for (; at != no_prim; at = layer_.prims[at].parent) {
            constexpr std::size_t longest = 400;
            std::string_view name = layer_.prims[at].name;
            if (name.size() > longest) { // the end of it, of whole characters
                name.remove_prefix(name.size() - longest);
                while (!name.empty() && (static_cast<unsigned char>(name.front()) & 0xc0U) == 0x80U)
                    name.remove_prefix(1);
                return fmt::format("…{}{}", name, path);
            }
            path.insert(0, fmt::format("/{}", name));
            if (path.size() > longest) return "…" + path;
        }
        return path;
    }

    Result<glm::dmat4> op(const UsdPrim& prim, std::string_view name) {
        const std::optional<UsdOpinion> attribute = prim.find(name);
        const UsdValue* const found = attribute ? value(nullptr, prim, name) : nullptr;
        if (found == nullptr)
            return scene_error("SCN0103", place(prim),
                               fmt::format("xformOpOrder names '{}', which has no value", name.substr(0, 80)));
        moves_ = moves_ || (!options_.time && !attribute->said->value.is_set && attribute->said->samples.size() > 1);
        const std::vector<double>& v = found->numbers;
        std::string_view kind = name.substr(std::min(std::string_view("xformOp:").size(), name.size()));
        kind = kind.substr(0, kind.find(':'));
        const auto wrong = [&] {
            return scene_error("SCN0105", place(*found),
                               fmt::format("'{}' has {} numbers", name.substr(0, 80), v.size()));
        };
        glm::dmat4 one(1.0);
        if (kind == "transform") {
            if (v.size() != 16) return wrong();
            for (int i = 0; i < 16; ++i)
                one[i / 4][i % 4] = v[static_cast<std::size_t>(i)];
            return one;
        }
        if (kind == "translate" || kind == "scale") {
            if (v.size() != 3) return wrong();
            const glm::dvec3 by(v[0], v[1], v[2]);
            return kind == "translate" ? glm::translate(one, by) : glm::scale(one, by);
        }
        if (kind == "orient") {
            if (v.size() != 4) return wrong();
            const glm::dquat turn(v[0], v[1], v[2], v[3]);
            return glm::mat4_cast(glm::normalize(turn));
        }
        constexpr std::string_view rotate = "rotate";
        if (kind.starts_with(rotate)) {
            const std::string_view axes = kind.substr(rotate.size());
            if (axes.empty() || axes.size() > 3 || axes.find_first_not_of("XYZ") != std::string_view::npos ||
                v.size() != axes.size())
                return wrong();
            // The first axis is turned about first; angles stand in the order X, Y, Z.
            for (const char axis : axes) {
                const int at = axis - 'X';
                glm::dvec3 about(0.0);
                about[at] = 1.0;
                const double angle = axes.size() == 1 ? v[0] : v[static_cast<std::size_t>(at)];
                one = glm::rotate(glm::dmat4(1.0), angle * pi / 180.0, about) * one;
            }
            return one;
        }
        return scene_error("SCN0103", place(prim), fmt::format("there is no transformation '{}'", name.substr(0, 80)));
    }

    Result<glm::dmat4> local(const UsdPrim& prim, bool& resets) {
        glm::dmat4 own(1.0);
        resets = false;
        const std::optional<UsdOpinion> order = prim.find("xformOpOrder");
        if (!order) return own;
        constexpr std::size_t most = 1024;
        if (order->said->value.texts.size() > most)
            return scene_error("SCN0108", place(order->said->value),
                               fmt::format("more than {} transformations of a prim", most));
        for (std::string_view name : order->said->value.texts) {
            if (name == "!resetXformStack!") {
                resets = true;
                own = glm::dmat4(1.0);
                continue;
            }
            constexpr std::string_view invert = "!invert!";
            const bool is_inverse = name.starts_with(invert);
            if (is_inverse) name.remove_prefix(invert.size());
            Result<glm::dmat4> one = op(prim, name);
            if (!one) return one;
            own = own * (is_inverse ? glm::inverse(*one) : *one);
        }
        return own;
    }

    // World transformations of a prim and its parents are kept.
    Result<glm::dmat4> world_of(std::uint32_t at) {
        std::vector<std::uint32_t> above;
        glm::dmat4 world(1.0);
        for (; at != no_prim; at = layer_.prims[at].parent) {
            if (worlds_[at]) {
                world = *worlds_[at];
                break;
            }
            above.push_back(at);
        }
        for (std::size_t i = above.size(); i-- > 0;) { // from the root down
            bool resets = false;
            Result<glm::dmat4> own = local(layer_.prims[above[i]], resets);
            if (!own) return own;
            world = resets ? *own : world * *own;
            worlds_[above[i]] = world;
        }
        return world;
    }

    bool is_shown(std::uint32_t at) {
        for (; at != no_prim; at = layer_.prims[at].parent) {
            const UsdPrim& prim = layer_.prims[at];
            if (prim.specifier != UsdSpecifier::def || !prim.active.value_or(true)) return false;
            const UsdValue* const visibility = value(nullptr, prim, "visibility");
            if (visibility != nullptr && !visibility->texts.empty() && visibility->texts[0] == "invisible")
                return false;
        }
        return true;
    }

    Result<void> read_light(std::uint32_t at) {
        const UsdPrim& prim = layer_.prims[at];
        FoundLight light;
        light.name = prim.name;
        light.kind = prim.type.substr(0, 40);
        light.place = path_of(at);
        light.location = place(prim);
        Result<glm::dmat4> world = world_of(at);
        if (!world) return pass_on(world);
        changing_.clear();
        if (Result<void> done = read_amount(light, prim, *world); !done) return done;
        say_what_changes(light);
        if (light.shape && !is_shown(at)) {
            light.shape.reset();
            remark(light, "SCN0204", "it is inactive, invisible, a class or an override");
        }
        scene_.lights.push_back(std::move(light));
        return {};
    }

    static bool has_schema(const UsdPrim& prim, std::string_view name) {
        return std::find(prim.schemas.begin(), prim.schemas.end(), name) != prim.schemas.end();
    }

    // What the schemas of the proposal "physical lighting" say: a flux or an illuminance, which replaces intensity,
    // exposure and the luminance of the colour. Photometric ones win over radiometric ones.
    struct Physical {
        std::optional<double> amount; // lm or lx; nothing: no such schema, or only a remark
        std::optional<glm::dvec3> color;
        bool is_blackbody = false;
    };

    // Of watts: what the option says, else what the illuminant has.
    Result<double> efficacy_of(FoundLight& light, const UsdPrim& prim, const std::string& illuminant,
                               const std::optional<double>& of_custom) {
        if (options_.lumens_per_watt) return *options_.lumens_per_watt;
        if (of_custom) return *of_custom;
        if (illuminant == "blackbody") {
            Result<double> kelvin = number(light, prim, "colorTemperature", 6500.0);
            if (!kelvin) return kelvin;
            if (*kelvin >= 500.0 && *kelvin <= 1e6) {
                const double lumens = blackbody_efficacy(Kelvin(*kelvin)).total_lm_per_w;
                remark(light, "SCN0201",
                       fmt::format("watts of a black body of {} K: {} lm/W of all its radiation are assumed",
                                   rounded(*kelvin), rounded(lumens, 4)),
                       "--lm-per-watt says what they are");
                return lumens;
            }
        }
        const std::optional<Spectrum> white = find_illuminant("D65");
        const Result<SpectrumColor> color = color_of(*white, Band{380.0, 780.0});
        if (!color) return Unexpected(color.error());
        remark(
            light, "SCN0201",
            fmt::format("watts of light whose spectrum is not known: {} lm/W are assumed, as of D65 within 380–780 nm",
                        rounded(color->efficacy_lm_per_w, 4)),
            "--lm-per-watt says what they are");
        return color->efficacy_lm_per_w;
    }

    // The colour and the efficacy of a spectrum, or why it has none.
    struct Illuminant {
        std::optional<SpectrumColor> facts;
        glm::dvec3 color{1.0};
        bool is_clipped = false;
        std::string reason;
    };

    // Of pairs of nm and power.
    Illuminant illuminant_of(const UsdValue* pairs) const {
        Illuminant found;
        constexpr std::size_t most = 20000; // numbers: 10,000 wavelengths
        if (pairs == nullptr || pairs->numbers.empty())
            found.reason = "it has no 'physical:customIlluminant'";
        else if (pairs->numbers.size() % 2 != 0)
            found.reason = "its numbers are not pairs of a wavelength and a power";
        else if (pairs->numbers.size() > most)
            found.reason = "it has more than 10,000 wavelengths";
        if (!found.reason.empty()) return found;
        std::string text;
        for (std::size_t i = 0; i < pairs->numbers.size(); i += 2)
            text += fmt::format("{},{}\n", shortest(pairs->numbers[i]), shortest(pairs->numbers[i + 1]));
        const Result<Spectrum> spectrum = parse_spectrum_csv(text, source_);
        if (!spectrum) {
            const Diagnostics& said = spectrum.error().diagnostics;
            found.reason = said.empty() ? "it is no spectrum" : said.back().message;
            return found;
        }
        Diagnostics clipped;
        const Result<glm::dvec3> color = light_color_of(*spectrum, &clipped);
        const Result<SpectrumColor> facts = color_of(*spectrum);
        if (!color || !facts) {
            found.reason = "it has no colour";
            return found;
        }
        found.facts = *facts;
        found.color = *color;
        found.is_clipped = !clipped.empty();
        return found;
    }

    // Nothing with a remark where they are no spectrum. Many lights may inherit one.
    std::optional<SpectrumColor> custom_of(FoundLight& light, const UsdPrim& prim, Physical& physical) {
        const UsdValue* const pairs = value(&light, prim, "physical:customIlluminant");
        const auto [known, is_new] = illuminants_.try_emplace(pairs);
        if (is_new) known->second = illuminant_of(pairs);
        const Illuminant& found = known->second;
        if (!found.facts) {
            remark(light, "SCN0202", fmt::format("its custom illuminant is left out: {}", found.reason));
            return std::nullopt;
        }
        physical.color = found.color;
        if (found.is_clipped)
            remark(light, "SCN0202", "the colour of its spectrum lies outside Rec.709: clipped to it");
        return found.facts;
    }

    Result<Physical> physical_of(FoundLight& light, const UsdPrim& prim) {
        const bool is_distant = light.kind == "DistantLight";
        const bool is_dome = light.kind.starts_with("DomeLight");
        const std::string_view where = is_distant ? "Distant" : is_dome ? "Dome" : "Area";
        const bool is_photometric = has_schema(prim, fmt::format("Photometric{}LightAPI", where));
        Physical physical;
        if (!is_photometric && !has_schema(prim, fmt::format("Radiometric{}LightAPI", where))) return physical;
        const UsdValue* const said = value(&light, prim, "physical:illuminant");
        const std::string illuminant = said != nullptr && !said->texts.empty() ? said->texts.front() : "white";
        std::optional<double> of_custom;
        if (illuminant == "custom") {
            if (const std::optional<SpectrumColor> facts = custom_of(light, prim, physical))
                of_custom = facts->efficacy_lm_per_w;
        } else if (illuminant != "white" && illuminant != "blackbody") {
            remark(light, "SCN0202",
                   fmt::format("there is no illuminant '{}': white is assumed", cut_text(illuminant, 40)));
        }
        physical.is_blackbody = illuminant == "blackbody";
        const bool is_of_area = where == "Area";
        const std::string name = is_photometric ? (is_of_area ? "photometric:power" : "photometric:illuminance")
                                                : (is_of_area ? "radiometric:power" : "radiometric:irradiance");
        const double otherwise = is_photometric ? (is_of_area ? 1600.0 : 10000.0) : (is_of_area ? 2.34 : 14.64);
        Result<double> stated = number(light, prim, name, otherwise);
        if (!stated) return pass_on(stated);
        light.stated = fmt::format("{} {}", name, rounded(*stated));
        if (illuminant != "white") light.stated += fmt::format(", {}", cut_text(illuminant, 40));
        light.stated_amount = *stated;
        if (is_photometric) {
            physical.amount = *stated;
            return physical;
        }
        Result<double> efficacy = efficacy_of(light, prim, illuminant, of_custom);
        if (!efficacy) return pass_on(efficacy);
        physical.amount = *stated * *efficacy;
        return physical;
    }

    Result<void> read_amount(FoundLight& light, const UsdPrim& prim, const glm::dmat4& world) {
        const bool is_distant = light.kind == "DistantLight";
        Result<double> intensity = number(light, prim, "intensity", is_distant ? 50000.0 : 1.0);
        if (!intensity) return pass_on(intensity);
        Result<double> exposure = number(light, prim, "exposure", 0.0);
        if (!exposure) return pass_on(exposure);
        Result<double> normalize = number(light, prim, "normalize", 0.0);
        if (!normalize) return pass_on(normalize);
        light.stated_amount = *intensity * std::exp2(*exposure);
        light.stated = fmt::format("intensity {}", rounded(*intensity));
        if (*exposure != 0.0) light.stated += fmt::format(", exposure {}", rounded(*exposure));
        if (*normalize != 0.0) light.stated += ", normalize";
        glm::dvec3 rgb(1.0);
        if (const UsdValue* const color = value(&light, prim, "color")) {
            if (color->numbers.size() != 3)
                return scene_error("SCN0105", place(*color), "'color' must have three numbers");
            rgb = {color->numbers[0], color->numbers[1], color->numbers[2]};
            if (rgb != glm::dvec3(1.0)) light.stated += fmt::format(", color {}", numbers_text(rgb));
        }
        Result<double> has_kelvin = number(light, prim, "enableColorTemperature", 0.0);
        if (!has_kelvin) return pass_on(has_kelvin);
        const bool is_tinted = rgb.x != rgb.y || rgb.y != rgb.z;
        Result<Physical> physical = physical_of(light, prim);
        if (!physical) return pass_on(physical);
        if (*has_kelvin != 0.0 || physical->is_blackbody) {
            Result<double> kelvin = number(light, prim, "colorTemperature", 6500.0);
            if (!kelvin) return pass_on(kelvin);
            light.stated += fmt::format(", {} K", rounded(*kelvin));
            rgb *= blackbody_color(light, *kelvin);
            light.temperature = Kelvin(*kelvin);
        }
        if (physical->color) rgb *= *physical->color;
        const double of_color = take_color(light, rgb);
        // With a flux or an illuminance of its own the intensity cancels.
        const double nits = physical->amount ? 1.0 : light.stated_amount * of_color;
        light.stated_color_max = 1.0;
        light.is_tinted = is_tinted;
        const bool is_normalized = *normalize != 0.0 && !physical->amount;
        Result<void> read = is_distant ? distant(light, prim, world, nits, is_normalized)
                                       : area(light, prim, world, nits, is_normalized);
        if (!read || !physical->amount || !light.shape) return read;
        // The flux of what is left of the light by its cone or profile.
        light.profile_scale = 1.0;
        light.intensity = amount(*physical->amount, is_distant ? "lx" : "lm");
        return {};
    }

    Result<void> distant(FoundLight& light, const UsdPrim& prim, const glm::dmat4& world, double nits,
                         bool normalized) {
        Result<double> angle = number(light, prim, "angle", 0.53);
        if (!angle) return pass_on(angle);
        if (!(*angle >= 0.0 && *angle <= 180.0)) {
            only_list(light, fmt::format("its angle of {}° is outside what a rig holds", rounded(*angle)));
            return {};
        }
        light.shape = SunShape{degrees(*angle > 0.0 ? *angle : 0.53)};
        // Without a size the divisor of the area is 1.
        light.intensity = amount(nits, normalized || *angle == 0.0 ? "lx" : "nt");
        if (*angle == 0.0) remark(light, "SCN0201", "its angle is 0: a diameter of 0.53° is assumed");
        place_light(light, world, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, up_, scene_.meters_per_unit);
        return {};
    }

    struct Shaping {
        bool is_there = false;
        double angle = 90.0;
        double softness = 0.0;
        double focus = 0.0;
        std::string file; // relative to the scene's folder, or in the archive
        int archive = -1;
        bool normalized = false;
    };

    static bool is_of_shaping(const UsdAttribute& one) { return one.name.find("shaping:") != std::string::npos; }

    Result<Shaping> shaping_of(FoundLight& light, const UsdPrim& prim) {
        Shaping shaping;
        shaping.is_there = has_schema(prim, "ShapingAPI") ||
                           std::any_of(prim.attributes.begin(), prim.attributes.end(), is_of_shaping) ||
                           std::any_of(prim.opinions.begin(), prim.opinions.end(),
                                       [](const UsdOpinion& one) { return is_of_shaping(*one.said); });
        if (!shaping.is_there) return shaping;
        for (const auto& [name, into] :
             {std::pair{"shaping:cone:angle", &shaping.angle}, std::pair{"shaping:cone:softness", &shaping.softness},
              std::pair{"shaping:focus", &shaping.focus}}) {
            Result<double> read = number(light, prim, name, *into);
            if (!read) return pass_on(read);
            *into = *read;
        }
        if (const UsdValue* const file = value(&light, prim, "shaping:ies:file");
            file != nullptr && !file->texts.empty() && !file->texts.front().empty()) {
            // Prims that are composed of the same one all name its file.
            constexpr std::size_t most_bytes = std::size_t{256} << 20U;
            name_bytes_ += file->texts.front().size();
            if (name_bytes_ > most_bytes)
                return scene_error("SCN0108", place(*file), "the names of profiles are longer than 256 MiB");
            const UsdSource& from = stage_.sources[file->layer];
            shaping.archive = from.archive;
            // As written where it is beside the scene.
            const bool is_beside = from.archive < 0 && from.name.find('/') == std::string::npos;
            shaping.file = is_beside ? file->texts.front() : usd_file_name(from, file->texts.front());
        }
        Result<double> normalized = number(light, prim, "shaping:ies:normalize", 0.0);
        if (!normalized) return pass_on(normalized);
        shaping.normalized = *normalized != 0.0;
        Result<double> scale = number(light, prim, "shaping:ies:angleScale", 0.0);
        if (!scale) return pass_on(scale);
        if (*scale != 0.0 && !shaping.file.empty())
            remark(light, "SCN0202", "angleScale is left out: renderers disagree about it");
        return shaping;
    }

    Result<void> area(FoundLight& light, const UsdPrim& prim, const glm::dmat4& world, double nits, bool normalized) {
        const double unit = scene_.meters_per_unit;
        const glm::dvec3 scale = axis_lengths(world);
        const bool is_uniform = nearly(scale.x, scale.y) && nearly(scale.x, scale.z);
        Result<double> radius = number(light, prim, "radius", 0.5);
        if (!radius) return pass_on(radius);
        Result<double> width = number(light, prim, "width", 1.0);
        if (!width) return pass_on(width);
        Result<double> height = number(light, prim, "height", 1.0);
        if (!height) return pass_on(height);
        Result<double> length = number(light, prim, "length", 1.0);
        if (!length) return pass_on(length);
        Result<Shaping> shaping = shaping_of(light, prim);
        if (!shaping) return pass_on(shaping);
        double stage_area = 0.0; // in the stage's units, with the transformation
        double projected = 0.0;  // [m²]
        const bool is_sphere = light.kind == "SphereLight";
        if (is_sphere) {
            const double r = *radius * scale.x;
            stage_area = 4.0 * pi * r * r;
            projected = pi * r * r * unit * unit;
            light.shape = SphereShape{Meters(r * unit)};
        } else if (light.kind == "DiskLight" || light.kind == "RectLight") {
            const bool is_disk = light.kind == "DiskLight";
            const glm::dmat4 sized = is_disk ? glm::scale(world, {*radius, *radius, 1.0})
                                             : glm::scale(world, {0.5 * *width, 0.5 * *height, 1.0});
            const glm::dvec3 lengths = axis_lengths(sized);
            stage_area = (is_disk ? pi : 4.0) * lengths.x * lengths.y;
            take_flat(light, sized, is_disk, -1.0, false, up_, unit);
        } else if (light.kind == "CylinderLight") {
            const double r = *radius * scale.y;
            const double l = *length * scale.x;
            stage_area = 2.0 * pi * r * l;
            light.shape = CylinderShape{Meters(r * unit), Meters(l * unit)};
        } else {
            only_list(light, light.kind.starts_with("DomeLight")
                                 ? std::string("light from all around is the sky of a rig")
                             : light.kind == "Mesh" || light.kind == "GeometryLight"
                                 ? std::string("a mesh that emits")
                                 : fmt::format("gonio does not read a {}", light.kind));
            return {};
        }
        if (!light.shape) return {};
        if (!(stage_area > 0.0) || !std::isfinite(stage_area)) {
            only_list(light, "its size is not above 0");
            return {};
        }
        if ((is_sphere && !is_uniform) || (light.kind == "CylinderLight" && !nearly(scale.y, scale.z))) {
            only_list(light, "its transformation stretches it to a shape that a rig does not hold");
            return {};
        }
        if (normalized) {
            nits /= stage_area;
            if (unit != 1.0)
                remark(light, "SCN0201", "normalize divides by the area in the stage's units, as in USD's own code");
        }
        light.intensity = amount(nits, "nt");
        if (is_sphere || light.kind == "CylinderLight")
            place_light(light, world, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, up_, unit);
        if (!light.shape) return {};
        if (const UsdValue* const texture = value(&light, prim, "texture:file");
            texture != nullptr && !texture->texts.empty() && !texture->texts.front().empty()) {
            only_list(light, "its luminances are a picture, which gonio does not read back");
            return {};
        }
        Result<double> as_point = number(light, prim, "treatAsPoint", 0.0);
        if (!as_point) return pass_on(as_point);
        if (is_sphere && (*as_point != 0.0 || shaping->is_there))
            return punctual(light, *shaping, nits * projected, *as_point != 0.0);
        if (shaping->is_there) shape_area(light, *shaping);
        return {};
    }

    // Of the scene's profiles, if it is in the archive and can be unpacked.
    std::optional<std::size_t> profile_of(const Shaping& shaping) {
        const auto [at, is_new] = profiles_.try_emplace({shaping.archive, shaping.file});
        if (!is_new) return at->second;
        const Archive& archive = stage_.archives[static_cast<std::size_t>(shaping.archive)];
        const ArchiveEntry* const entry = archive.find(shaping.file);
        if (entry == nullptr || entry->size > limit("profile-bytes").value) return std::nullopt;
        Result<std::string> bytes = archive.read(*entry);
        if (!bytes) return std::nullopt;
        FoundProfile found;
        found.name = plain_name(without_extension(file_name(entry->name)));
        found.bytes = std::move(*bytes);
        at->second = scene_.profiles.size();
        scene_.profiles.push_back(std::move(found));
        return at->second;
    }

    // A sphere as a point, a spot or a profile.
    Result<void> punctual(FoundLight& light, const Shaping& shaping, double candela, bool as_point) {
        light.intensity = amount(candela, "cd");
        const SphereShape sphere = std::get<SphereShape>(*light.shape);
        light.shape = PointShape{};
        if (!shaping.is_there) return {};
        const std::string lost = "a sphere that is shaped: a rig's light is a point of the same intensity";
        if (!shaping.file.empty()) {
            ProfileShape profile;
            profile.file = shaping.file;
            if (shaping.archive >= 0) {
                light.profile = profile_of(shaping);
                if (!light.profile) {
                    light.shape.reset();
                    remark(light, "SCN0107", fmt::format("the profile '{}' is not in the archive", shaping.file));
                    return {};
                }
            }
            light.shape = profile;
            if (!as_point) remark(light, "SCN0202", lost);
            if (shaping.focus != 0.0 || shaping.angle < 90.0)
                remark(light, "SCN0202", "a cone and a focus beside a profile are left out");
            light.profile_scale = candela;
            if (nearly(candela, 1.0)) light.profile_scale = 1.0;
            light.intensity.reset();
            if (shaping.normalized) { // the profile over its mean intensity
                light.profile_scale = 1.0;
                light.intensity = amount(4.0 * pi * candela, "lm");
                remark(light, "SCN0201",
                       "ies:normalize: the mean intensity over the whole sphere becomes 1, as in USD's own code");
            }
            return {};
        }
        light.stated_outer = shaping.angle;
        if (shaping.focus != 0.0) {
            only_list(light, "it has a focus, a power of the cosine, which a rig does not have");
            return {};
        }
        if (shaping.angle >= 180.0) {
            if (!as_point)
                light.shape = sphere,
                light.intensity = amount(candela / (pi * sphere.radius.value * sphere.radius.value), "nt");
            return {};
        }
        if (!(shaping.angle > 0.0 && shaping.angle <= 90.0) || !(shaping.softness >= 0.0 && shaping.softness <= 1.0)) {
            only_list(light, fmt::format("its cone is outside what a rig holds: {}°, softness {}",
                                         rounded(shaping.angle), rounded(shaping.softness)));
            return {};
        }
        const Radians outer = degrees(shaping.angle);
        light.shape = SpotShape{outer, outer * (1.0 - shaping.softness), Falloff::smoothstep_angle, {}, {}};
        if (!as_point) remark(light, "SCN0202", lost);
        return {};
    }

    static void shape_area(FoundLight& light, const Shaping& shaping) {
        if (!shaping.file.empty())
            return only_list(
                light, "a profile on an area light: UsdLux leaves open whether it is an intensity or a luminance");
        if (shaping.focus != 0.0) return only_list(light, "an area light with a focus");
        const bool cuts = shaping.angle < (light.kind == "CylinderLight" ? 180.0 : 90.0);
        if (cuts) only_list(light, fmt::format("an area light with a cone of {}°", rounded(shaping.angle)));
    }

    UsdStage stage_;
    const UsdLayer& layer_;
    const SceneReadOptions& options_;
    const std::string& source_;
    std::map<const UsdValue*, Illuminant> illuminants_; // by their pairs
    FoundScene scene_;
    std::vector<std::optional<glm::dmat4>> worlds_;                              // by prim
    std::deque<UsdValue> made_;                                                  // between samples
    std::vector<std::string> changing_;                                          // attributes of the light that is read
    std::map<std::pair<int, std::string>, std::optional<std::size_t>> profiles_; // in archives
    std::size_t name_bytes_ = 0;                                                 // of profiles
    char up_ = 'y';
    bool moves_ = false; // a transformation above a light changes over time
};

} // namespace

bool is_usda(std::string_view bytes) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
    return bytes.starts_with("#usda");
}

bool is_usd_name(std::string_view name) {
    return ends_with_any_case(name, ".usda") || ends_with_any_case(name, ".usd") || ends_with_any_case(name, ".usdc");
}

bool is_usd(std::string_view bytes) {
    if (!is_archive(bytes)) return is_usda(bytes);
    const Result<Archive> archive = Archive::open(bytes, "");
    if (!archive || archive->entries().empty()) return false;
    return is_usd_name(archive->entries().front().name);
}

Result<FoundScene> read_usd(std::string_view bytes, const std::string& source, const SceneReadOptions& options) {
    Result<UsdStage> stage = compose_usd(bytes, source, options);
    if (!stage) return pass_on(stage);
    return UsdReader(std::move(*stage), source, options).read();
}

} // namespace gonio::interchange_detail
