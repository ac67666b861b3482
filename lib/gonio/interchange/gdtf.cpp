// GDTF: the beams of a stage fixture as lights. A beam states lumens and two full angles, at which the intensity is
// half and a tenth of its peak, but no photometry. Its distribution is an estimate: I(γ) = I₀ 2^−(γ/½beam)ⁿ through
// both angles; a beam with equal angles has a hard edge. A zoom keeps the flux and scales both angles. Metres, Z up, as
// the fixture stands on the floor; light goes along −Z of the beam.
#include <gonio/base/archive_xml.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/interchange/detail/reading.hpp>
#include <gonio/profile/write.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

namespace gonio::interchange_detail {

namespace {

constexpr std::string_view description = "description.xml";

// Zoom of what is below a geometry [°].
struct Zoom {
    double least = 0.0;
    double most = 0.0;
};

// A beam with what it states, the same wherever a reference puts it.
struct Beam {
    FoundLight light; // without name, place and shape
    std::string type;
    double flux = 0.0;
    double beam = 0.0; // [°], full angles
    double field = 0.0;
    double radius = 0.0;
    double ratio = 1.7777; // of a rectangular section
};

// A geometry, read once however many references name it.
struct Geometry {
    pugi::xml_node node;
    std::string name;                 // short
    std::optional<glm::dmat4> matrix; // nothing: wrong
    std::optional<Zoom> zoom;         // of its own name
    std::unique_ptr<const Beam> beam;
    std::optional<std::string_view> target; // name of what a reference stands for
    const Geometry* found = nullptr;        // that geometry, once it is looked for
    std::vector<std::size_t> children;      // with names
};

class GdtfReader {
public:
    GdtfReader(ArchiveXml& xml, const SceneReadOptions& options) : xml_(xml), options_(options) {}

    Result<FoundScene> read() {
        if (const pugi::xml_node wide = first_with_many_attributes())
            return scene_error("SCN0108", xml_.place(wide),
                               fmt::format("an element with more than {} attributes", most_attributes));
        const pugi::xml_node fixture = xml_.root().child("FixtureType");
        if (!fixture) return scene_error("SCN0103", xml_.place(xml_.root()), "the document describes no FixtureType");
        scene_.generator = cut_text(fixture.attribute("Manufacturer").value(), longest_name);
        const pugi::xml_node geometries = fixture.child("Geometries");
        for (const pugi::xml_node geometry : geometries.children())
            by_name_.try_emplace(geometry.attribute("Name").value(), Named{geometry, std::nullopt});
        const pugi::xml_node modes = fixture.child("DMXModes");
        Result<pugi::xml_node> mode = mode_of(modes);
        if (!mode) return pass_on(mode);
        read_zooms(*mode);
        const std::string_view wanted = mode->attribute("Geometry").value();
        const pugi::xml_node first = geometries.first_child(); // without a mode
        const std::string_view top = wanted.empty() && first ? first.attribute("Name").value() : wanted;
        Geometry* const geometry = found(top);
        if (geometry == nullptr)
            return scene_error("SCN0103", xml_.place(*mode ? *mode : fixture),
                               fmt::format("there is no geometry '{}'", shown_text(top)));
        if (Result<void> done = walk(*geometry, glm::dmat4(1.0), std::nullopt); !done) return pass_on(done);
        return std::move(scene_);
    }

private:
    static constexpr std::size_t most_attributes = 100; // of an element; those of GDTF have some 20 at most
    static constexpr std::size_t longest_name = 400;    // bytes

    struct Named {
        pugi::xml_node node;
        std::optional<std::size_t> index; // of geometries_, once it is read
    };

    pugi::xml_node first_with_many_attributes() const {
        const pugi::xml_node root = xml_.root();
        for (pugi::xml_node at = root; at;) {
            std::size_t count = 0;
            for (pugi::xml_attribute one = at.first_attribute(); one && count <= most_attributes;
                 one = one.next_attribute())
                ++count;
            if (count > most_attributes) return at;
            pugi::xml_node next = at.first_child();
            while (!next && at != root) {
                next = at.next_sibling();
                if (!next) at = at.parent();
            }
            if (at == root && !next) break;
            at = next;
        }
        return {};
    }

    // A geometry that is in no other; null if there is none.
    Geometry* found(std::string_view name) {
        const auto at = by_name_.find(name);
        if (at == by_name_.end()) return nullptr;
        if (!at->second.index) at->second.index = geometry_of(at->second.node);
        return &geometries_[*at->second.index];
    }

    // With what is in it: no deeper than the limit xml-depth. NOLINTNEXTLINE(misc-no-recursion)
    std::size_t geometry_of(pugi::xml_node node) {
        Geometry made;
        made.node = node;
        const std::string_view name = node.attribute("Name").value();
        made.name = cut_text(name, longest_name);
        made.matrix = matrix_of(node);
        if (const auto zoom = zooms_.find(name); zoom != zooms_.end()) made.zoom = zoom->second;
        const std::string_view kind = node.name();
        if (kind == "Beam") made.beam = std::make_unique<const Beam>(beam_of(node));
        if (kind == "GeometryReference") made.target = node.attribute("Geometry").value();
        for (const pugi::xml_node child : node.children())
            if (child.attribute("Name")) made.children.push_back(geometry_of(child));
        geometries_.push_back(std::move(made));
        return geometries_.size() - 1;
    }

    Result<pugi::xml_node> mode_of(pugi::xml_node modes) {
        std::vector<std::string_view> names;
        for (const pugi::xml_node mode : modes.children("DMXMode"))
            names.emplace_back(mode.attribute("Name").value());
        if (options_.variant.empty()) {
            if (names.size() > 1)
                warn(scene_, "SCN0201", xml_.place(modes.child("DMXMode")),
                     fmt::format("mode '{}' is taken, the first of {}", shown_text(names.front(), 60), names.size()),
                     "--variant names another");
            return modes.child("DMXMode");
        }
        for (const pugi::xml_node mode : modes.children("DMXMode"))
            if (options_.variant == mode.attribute("Name").value()) return mode;
        return unknown_name("mode", options_.variant, names);
    }

    // The angles that the channels of a mode reach.
    void read_zooms(pugi::xml_node mode) {
        for (const pugi::xml_node channel : mode.child("DMXChannels").children("DMXChannel")) {
            const std::string_view geometry = channel.attribute("Geometry").value();
            for (const pugi::xml_node logical : channel.children("LogicalChannel"))
                for (const pugi::xml_node function : logical.children("ChannelFunction"))
                    read_zoom(function, geometry);
        }
        if (wrong_zooms_ > most_wrong_zooms)
            scene_.diagnostics.back().message += fmt::format(" (and {} more)", wrong_zooms_ - most_wrong_zooms);
    }

    void read_zoom(pugi::xml_node function, std::string_view geometry) {
        if (std::string_view(function.attribute("Attribute").value()) != "Zoom") return;
        const pugi::xml_attribute from = function.attribute("PhysicalFrom");
        const pugi::xml_attribute to = function.attribute("PhysicalTo");
        if (!from || !to) return;
        const std::optional<double> a = parse_number(from.value());
        const std::optional<double> b = parse_number(to.value());
        if (a == 0.0 && b == 1.0) return; // what GDTF has where nothing is stated
        if (!a || !b || !(std::min(*a, *b) > 0.0) || !(std::max(*a, *b) < 180.0)) {
            if (++wrong_zooms_ <= most_wrong_zooms)
                warn(scene_, "SCN0202", xml_.place(function),
                     fmt::format("a zoom from '{}' to '{}' is left out: angles are between 0° and 180°",
                                 shown_text(from.value(), 40), shown_text(to.value(), 40)));
            return;
        }
        const auto [at, is_new] = zooms_.try_emplace(geometry, Zoom{std::min(*a, *b), std::max(*a, *b)});
        at->second.least = std::min({at->second.least, *a, *b});
        at->second.most = std::max({at->second.most, *a, *b});
    }

    // "{1,0,0,0}{0,1,0,0}{0,0,1,0}{0,0,0,1}": rows, the place in the last column. Nothing for any other text.
    static std::optional<glm::dmat4> matrix_of(pugi::xml_node node) {
        glm::dmat4 matrix(1.0);
        const pugi::xml_attribute position = node.attribute("Position");
        if (!position) return matrix;
        std::string_view rest = position.value();
        for (int i = 0; i < 16; ++i) {
            rest.remove_prefix(std::min(rest.find_first_not_of("{}, \t\r\n"), rest.size()));
            const std::size_t end = std::min(rest.find_first_of("{}, \t\r\n"), rest.size());
            const std::optional<double> value = parse_number(rest.substr(0, end));
            if (!value || !(std::abs(*value) <= 1e100)) return std::nullopt;
            matrix[i % 4][i / 4] = *value;
            rest.remove_prefix(end);
        }
        return matrix;
    }

    // A geometry with what is below it, and what references stand for. NOLINTNEXTLINE(misc-no-recursion): scene-depth
    Result<void> walk(Geometry& geometry, const glm::dmat4& above, std::optional<Zoom> zoom) {
        if (path_.size() > limit("scene-depth").value)
            return scene_error(
                "SCN0108", xml_.place(geometry.node),
                fmt::format("geometries nested deeper than {}, or among themselves", to_text(limit("scene-depth"))));
        constexpr std::size_t most = 1000000;
        if (++walked_ > most)
            return scene_error("SCN0108", xml_.place(geometry.node),
                               fmt::format("more than {} geometries, references included", most));
        if (!geometry.matrix)
            return scene_error("SCN0105", xml_.place(geometry.node), "'Position' must have sixteen numbers");
        const glm::dmat4 world = above * *geometry.matrix;
        path_.push_back(&geometry.name);
        if (geometry.zoom) zoom = geometry.zoom;
        if (geometry.beam) add_beam(*geometry.beam, world, zoom);
        if (geometry.target) {
            if (geometry.found == nullptr) geometry.found = found(*geometry.target);
            const Geometry* const target = geometry.found;
            if (target == nullptr)
                return scene_error("SCN0103", xml_.place(geometry.node),
                                   fmt::format("there is no geometry '{}'", shown_text(*geometry.target)));
            // Channels name the reference, or what stands for it. The reference places it, not its own place.
            const std::optional<Zoom> inside = target->zoom ? target->zoom : zoom;
            for (const std::size_t child : target->children)
                if (Result<void> done = walk(geometries_[child], world, inside); !done) return done;
            if (target->beam) add_beam(*target->beam, world, inside);
        }
        for (const std::size_t child : geometry.children)
            if (Result<void> done = walk(geometries_[child], world, zoom); !done) return done;
        path_.pop_back();
        if (scene_.lights.size() > limit("scene-lights").value)
            return scene_error("SCN0108", xml_.place(geometry.node),
                               fmt::format("more than {}", to_text(limit("scene-lights"))));
        constexpr std::size_t most_profiles = 1000;
        if (scene_.profiles.size() > most_profiles)
            return scene_error("SCN0108", xml_.place(geometry.node),
                               fmt::format("more than {} beams of different angles", most_profiles));
        return {};
    }

    // The names from the outermost geometry on; of a long path its end.
    std::string path() const {
        std::string text;
        for (std::size_t i = path_.size(); i > 0; --i) {
            text.insert(0, (i > 1 ? "/" : "") + *path_[i - 1]);
            if (text.size() <= longest_name) continue;
            std::size_t begin = text.size() - longest_name;
            while (begin < text.size() && (static_cast<unsigned char>(text[begin]) & 0xc0U) == 0x80U)
                ++begin;
            return "…" + text.substr(begin);
        }
        return text;
    }

    // A number of a beam within its range; GDTF's own value where it states none or a wrong one.
    double number(FoundLight& light, pugi::xml_node node, const char* name, double otherwise, double most,
                  std::string_view unit) {
        const pugi::xml_attribute attribute = node.attribute(name);
        const std::optional<double> value = parse_number(attribute.value());
        if (value && *value >= 0.0 && *value <= most) return *value;
        remark(light, "SCN0201",
               attribute
                   ? fmt::format("{} is '{}': {} {} are assumed", name, shown_text(attribute.value(), 40),
                                 rounded(otherwise), unit)
                   : fmt::format("{} is not stated: {} {} are assumed, as in GDTF", name, rounded(otherwise), unit));
        return otherwise;
    }

    Beam beam_of(pugi::xml_node node) {
        Beam made;
        FoundLight& light = made.light;
        light.location = xml_.place(node);
        made.type = cut_text(node.attribute("BeamType").as_string("Wash"), 40);
        light.kind = made.type;
        made.flux = number(light, node, "LuminousFlux", 10000.0, 1e9, "lm");
        const double kelvin = number(light, node, "ColorTemperature", 6000.0, 1e6, "K");
        made.beam = number(light, node, "BeamAngle", 25.0, 180.0, "degrees");
        made.field = number(light, node, "FieldAngle", 25.0, 180.0, "degrees");
        made.radius = number(light, node, "BeamRadius", 0.05, 1000.0, "m");
        const double ratio = parse_number(node.attribute("RectangleRatio").value()).value_or(made.ratio);
        if (ratio > 1e-3 && ratio < 1e3) made.ratio = ratio;
        light.stated_amount = made.flux;
        light.stated = fmt::format("{} lm, beam {}°, field {}°, {} K", rounded(made.flux), rounded(made.beam),
                                   rounded(made.field), rounded(kelvin));
        light.color = blackbody_color(light, kelvin);
        light.temperature = Kelvin(kelvin);
        light.intensity = amount(made.flux, "lm");
        return made;
    }

    void add_beam(const Beam& of, const glm::dmat4& world, std::optional<Zoom> zoom) {
        FoundLight light = of.light;
        light.name = *path_.back();
        light.place = path();
        if (zoom) {
            light.stated += fmt::format(", zoom {}° to {}°", rounded(zoom->least), rounded(zoom->most));
            light.zoom = {degrees(zoom->least), degrees(zoom->most)};
        }
        if (of.type == "None" || of.type == "Glow") {
            if (of.radius > 0.0) {
                light.shape = DiskShape{Meters(of.radius)};
                remark(light, "SCN0201",
                       "it has no beam: a disk of the beam's radius that emits in all directions before it is assumed");
            } else {
                only_list(light, "it has no beam and no size");
            }
        } else {
            double beam = of.beam;
            double field = of.field;
            take_zoom(light, zoom, beam, field);
            shape_beam(light, of, beam, field);
        }
        if (light.shape) place_light(light, world, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, 'z', 1.0);
        scene_.lights.push_back(std::move(light));
    }

    void take_zoom(FoundLight& light, const std::optional<Zoom>& zoom, double& beam, double& field) const {
        if (!zoom) {
            if (options_.zoom) remark(light, "SCN0201", "it has no zoom: its own angles are taken");
            return;
        }
        if (!options_.zoom) {
            remark(light, "SCN0201",
                   fmt::format("it zooms from {}° to {}°: the beam angle that it states is taken", rounded(zoom->least),
                               rounded(zoom->most)),
                   "--zoom 10deg chooses another");
            return;
        }
        double wanted = to_degrees(*options_.zoom);
        if (wanted < zoom->least || wanted > zoom->most) {
            wanted = std::clamp(wanted, zoom->least, zoom->most);
            remark(light, "SCN0201",
                   fmt::format("it zooms from {}° to {}°: {}° is taken", rounded(zoom->least), rounded(zoom->most),
                               rounded(wanted)));
        }
        field = beam > 0.0 ? field * wanted / beam : wanted;
        beam = wanted;
        constexpr double widest = 179.0; // light goes forward
        if (field > std::max(widest, beam)) {
            remark(light, "SCN0201",
                   fmt::format("the zoom would open its field angle to {}°: {}° is taken", rounded(field),
                               rounded(std::max(widest, beam))));
            field = std::max(widest, beam);
        }
        remark(light, "SCN0201", "a zoom keeps the flux and scales both angles");
    }

    void shape_beam(FoundLight& light, const Beam& of, double beam, double field) {
        if (!(beam > 0.0) || !(field > 0.0) || !(field < 180.0) || !(beam < 180.0))
            return only_list(light, fmt::format("its angles are outside what a beam has: {}° and {}°", rounded(beam),
                                                rounded(field)));
        if (of.type == "Rectangle") {
            const double half = 0.5 * beam * std::numbers::pi / 180.0;
            light.shape = FrustumShape{degrees(beam), Radians(2.0 * std::atan(std::tan(half) / of.ratio)), {}, {}};
            remark(light, "SCN0201",
                   "a beam with a rectangular section: its beam angle is taken as the wide one, with hard edges");
            return;
        }
        if (field <= beam * 1.001) {
            light.shape = SpotShape{degrees(0.5 * beam), degrees(0.5 * beam), Falloff::hard, {}, {}};
            remark(light, "SCN0201", "its beam and field angles are equal: a cone with a hard edge is assumed");
            return;
        }
        light.profile = profile_of(beam, field);
        ProfileShape shape;
        shape.file = scene_.profiles[*light.profile].name;
        light.shape = shape;
        remark(light, "SCN0201",
               "GDTF has no photometry: its distribution is an estimate through the beam and the field angle");
    }

    // One for every pair of angles.
    std::size_t profile_of(double beam, double field) {
        const auto [at, is_new] = profiles_.try_emplace({beam, field}, scene_.profiles.size());
        if (!is_new) return at->second;
        // 2^−xⁿ is a tenth where xⁿ is log₂ 10.
        const double power = std::log(std::log2(10.0)) / std::log(field / beam);
        IesFile file;
        std::string maker(cut_text(scene_.generator, 60));
        for (char& c : maker)
            if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
        file.keywords = {{"TEST", "estimated by gonio from the angles of a GDTF beam"},
                         {"TESTLAB", "none"},
                         {"ISSUEDATE", "none"},
                         {"MANUFAC", maker.empty() ? "none" : maker},
                         {"_BEAM", fmt::format("{} deg beam, {} deg field", rounded(beam), rounded(field))}};
        const double half = 0.5 * beam;
        const double dark = half * std::pow(-std::log2(1e-5), 1.0 / power);
        const double last = std::min(dark, 90.0);
        constexpr int steps = 240;
        for (int i = 0; i <= steps; ++i) {
            const double gamma = last * i / steps;
            file.vertical_deg.push_back(gamma);
            file.candela.push_back(gamma >= 90.0 || gamma >= dark ? 0.0
                                                                  : 1000.0 * std::exp2(-std::pow(gamma / half, power)));
        }
        if (last < 90.0) {
            file.vertical_deg.push_back(90.0);
            file.candela.push_back(0.0);
        }
        file.horizontal_deg = {0.0};
        scene_.profiles.push_back({fmt::format("beam_{}_{}", std::lround(beam), std::lround(field)), write_ies(file)});
        return at->second;
    }

    ArchiveXml& xml_;
    const SceneReadOptions& options_;
    FoundScene scene_;
    std::map<std::string_view, Named> by_name_; // geometries that are in no other
    std::deque<Geometry> geometries_;           // those that are read, each behind what is in it; they stay in place
    std::map<std::string_view, Zoom> zooms_;    // by geometry
    std::size_t wrong_zooms_ = 0;
    static constexpr std::size_t most_wrong_zooms = 8; // that are said
    std::map<std::pair<double, double>, std::size_t> profiles_;
    std::vector<const std::string*> path_; // names
    std::size_t walked_ = 0;
};

} // namespace

bool is_gdtf(std::string_view bytes) {
    if (!is_archive(bytes)) return false;
    const Result<Archive> archive = Archive::open(bytes, "");
    return archive && archive->find(description) != nullptr;
}

Result<FoundScene> read_gdtf(std::string_view bytes, const std::string& source, const SceneReadOptions& options) {
    Result<Archive> archive = Archive::open(bytes, source);
    if (!archive) return pass_on(archive);
    Result<std::unique_ptr<ArchiveXml>> xml = ArchiveXml::read(*archive, description, "GDTF");
    if (!xml) return pass_on(xml);
    return GdtfReader(**xml, options).read();
}

} // namespace gonio::interchange_detail
