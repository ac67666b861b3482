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
#include <map>
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

class GdtfReader {
public:
    GdtfReader(ArchiveXml& xml, const SceneReadOptions& options) : xml_(xml), options_(options) {}

    Result<FoundScene> read() {
        const pugi::xml_node fixture = xml_.root().child("FixtureType");
        if (!fixture) return scene_error("SCN0103", xml_.place(xml_.root()), "the document describes no FixtureType");
        scene_.generator = fixture.attribute("Manufacturer").value();
        geometries_ = fixture.child("Geometries");
        for (const pugi::xml_node geometry : geometries_.children())
            by_name_.try_emplace(geometry.attribute("Name").value(), geometry);
        const pugi::xml_node modes = fixture.child("DMXModes");
        Result<pugi::xml_node> mode = mode_of(modes);
        if (!mode) return pass_on(mode);
        read_zooms(*mode);
        const std::string_view top = mode->attribute("Geometry").value();
        bool has_any = false;
        for (const pugi::xml_node geometry : geometries_.children()) {
            if (!top.empty() && top != geometry.attribute("Name").value()) continue;
            has_any = true;
            if (Result<void> done = walk(geometry, glm::dmat4(1.0), {}, std::nullopt, 0); !done) return pass_on(done);
            break; // without a mode, the first
        }
        if (!has_any)
            return scene_error("SCN0103", xml_.place(*mode ? *mode : fixture),
                               fmt::format("there is no geometry '{}'", top.substr(0, 80)));
        return std::move(scene_);
    }

private:
    Result<pugi::xml_node> mode_of(pugi::xml_node modes) {
        std::vector<std::string_view> names;
        for (const pugi::xml_node mode : modes.children("DMXMode"))
            names.emplace_back(mode.attribute("Name").value());
        if (options_.variant.empty()) {
            if (names.size() > 1)
                warn(scene_, "SCN0201", xml_.place(modes.child("DMXMode")),
                     fmt::format("mode '{}' is taken, the first of {}", names.front().substr(0, 60), names.size()),
                     "--variant names another");
            return modes.child("DMXMode");
        }
        for (const pugi::xml_node mode : modes.children("DMXMode"))
            if (options_.variant == mode.attribute("Name").value()) return mode;
        return unknown_name("mode", options_.variant, names);
    }

    // The angles that the channels of a mode reach.
    void read_zooms(pugi::xml_node mode) {
        for (const pugi::xml_node channel : mode.child("DMXChannels").children("DMXChannel"))
            for (const pugi::xml_node logical : channel.children("LogicalChannel"))
                for (const pugi::xml_node function : logical.children("ChannelFunction")) {
                    const std::string_view attribute = function.attribute("Attribute").value();
                    const pugi::xml_attribute from = function.attribute("PhysicalFrom");
                    const pugi::xml_attribute to = function.attribute("PhysicalTo");
                    if (attribute != "Zoom" || !from || !to) continue;
                    const std::optional<double> a = parse_number(from.value());
                    const std::optional<double> b = parse_number(to.value());
                    if (a == 0.0 && b == 1.0) continue; // what GDTF has where nothing is stated
                    if (!a || !b || !(std::min(*a, *b) > 0.0) || !(std::max(*a, *b) < 180.0)) {
                        warn(scene_, "SCN0202", xml_.place(function),
                             fmt::format("a zoom from '{}' to '{}' is left out: angles are between 0° and 180°",
                                         std::string_view(from.value()).substr(0, 40),
                                         std::string_view(to.value()).substr(0, 40)));
                        continue;
                    }
                    const auto [at, is_new] = zooms_.try_emplace(channel.attribute("Geometry").value(),
                                                                 Zoom{std::min(*a, *b), std::max(*a, *b)});
                    at->second.least = std::min({at->second.least, *a, *b});
                    at->second.most = std::max({at->second.most, *a, *b});
                }
    }

    // "{1,0,0,0}{0,1,0,0}{0,0,1,0}{0,0,0,1}": rows, the place in the last column.
    Result<glm::dmat4> matrix_of(pugi::xml_node node) {
        glm::dmat4 matrix(1.0);
        const pugi::xml_attribute position = node.attribute("Position");
        if (!position) return matrix;
        std::string_view rest = position.value();
        for (int i = 0; i < 16; ++i) {
            rest.remove_prefix(std::min(rest.find_first_not_of("{}, \t\r\n"), rest.size()));
            const std::size_t end = std::min(rest.find_first_of("{}, \t\r\n"), rest.size());
            const std::optional<double> value = parse_number(rest.substr(0, end));
            if (!value || !(std::abs(*value) <= 1e100))
                return scene_error("SCN0105", xml_.place(node), "'Position' must have sixteen numbers");
            matrix[i % 4][i / 4] = *value;
            rest.remove_prefix(end);
        }
        return matrix;
    }

    // A geometry with what is below it, and what references stand for. NOLINTNEXTLINE(misc-no-recursion): scene-depth
    Result<void> walk(pugi::xml_node node, const glm::dmat4& above, const std::string& path, std::optional<Zoom> zoom,
                      std::size_t depth) {
        if (depth > limit("scene-depth").value)
            return scene_error(
                "SCN0108", xml_.place(node),
                fmt::format("geometries nested deeper than {}, or among themselves", to_text(limit("scene-depth"))));
        constexpr std::size_t most = 1000000;
        if (++walked_ > most)
            return scene_error("SCN0108", xml_.place(node),
                               fmt::format("more than {} geometries, references included", most));
        const Result<glm::dmat4> own = matrix_of(node);
        if (!own) return Unexpected(own.error());
        const glm::dmat4 world = above * *own;
        const std::string name = node.attribute("Name").value();
        constexpr std::size_t longest = 400;
        const std::string here = (path.empty() ? std::string() : path + "/") + name.substr(0, longest);
        if (here.size() > 100 * longest)
            return scene_error("SCN0108", xml_.place(node), "the names of nested geometries are too long");
        if (const auto of_this = zooms_.find(name); of_this != zooms_.end()) zoom = of_this->second;
        const std::string_view kind = node.name();
        if (kind == "Beam") add_beam(node, world, here, zoom);
        if (kind == "GeometryReference") {
            const std::string_view wanted = node.attribute("Geometry").value();
            const auto at = by_name_.find(wanted);
            const pugi::xml_node found = at == by_name_.end() ? pugi::xml_node() : at->second;
            if (!found)
                return scene_error("SCN0103", xml_.place(node),
                                   fmt::format("there is no geometry '{}'", wanted.substr(0, 80)));
            // What stands for the reference is placed by it, not by its own place.
            for (const pugi::xml_node child : found.children())
                if (Result<void> done = walk(child, world, here, zoom, depth + 1); !done) return done;
            if (std::string_view(found.name()) == "Beam") add_beam(found, world, here, zoom);
        }
        for (const pugi::xml_node child : node.children())
            if (child.attribute("Name"))
                if (Result<void> done = walk(child, world, here, zoom, depth + 1); !done) return done;
        if (scene_.lights.size() > limit("scene-lights").value)
            return scene_error("SCN0108", xml_.place(node),
                               fmt::format("more than {}", to_text(limit("scene-lights"))));
        return {};
    }

    // A number of a beam within its range; GDTF's own value where it states none or a wrong one.
    double number(FoundLight& light, pugi::xml_node node, const char* name, double otherwise, double most,
                  std::string_view unit) {
        const pugi::xml_attribute attribute = node.attribute(name);
        const std::optional<double> value = parse_number(attribute.value());
        if (value && *value >= 0.0 && *value <= most) return *value;
        remark(light, "SCN0201",
               attribute
                   ? fmt::format("{} is '{}': {} {} are assumed", name,
                                 std::string_view(attribute.value()).substr(0, 40), rounded(otherwise), unit)
                   : fmt::format("{} is not stated: {} {} are assumed, as in GDTF", name, rounded(otherwise), unit));
        return otherwise;
    }

    void add_beam(pugi::xml_node node, const glm::dmat4& world, const std::string& path, std::optional<Zoom> zoom) {
        FoundLight light;
        light.name = path.substr(path.rfind('/') + 1);
        light.place = path.size() > 400 ? "…" + path.substr(path.size() - 400) : path;
        light.location = xml_.place(node);
        std::string type = node.attribute("BeamType").as_string("Wash");
        light.kind = type.substr(0, 40);
        const double flux = number(light, node, "LuminousFlux", 10000.0, 1e9, "lm");
        const double kelvin = number(light, node, "ColorTemperature", 6000.0, 1e6, "K");
        double beam = number(light, node, "BeamAngle", 25.0, 180.0, "degrees");
        double field = number(light, node, "FieldAngle", 25.0, 180.0, "degrees");
        const double radius = number(light, node, "BeamRadius", 0.05, 1000.0, "m");
        light.stated_amount = flux;
        light.stated = fmt::format("{} lm, beam {}°, field {}°, {} K", rounded(flux), rounded(beam), rounded(field),
                                   rounded(kelvin));
        if (zoom) {
            light.stated += fmt::format(", zoom {}° to {}°", rounded(zoom->least), rounded(zoom->most));
            light.zoom = {degrees(zoom->least), degrees(zoom->most)};
        }
        light.color = blackbody_color(light, kelvin);
        light.temperature = Kelvin(kelvin);
        light.intensity = amount(flux, "lm");
        if (type == "None" || type == "Glow") {
            if (radius > 0.0) {
                light.shape = DiskShape{Meters(radius)};
                remark(light, "SCN0201",
                       "it has no beam: a disk of the beam's radius that emits in all directions before it is assumed");
            } else {
                only_list(light, "it has no beam and no size");
            }
        } else {
            take_zoom(light, zoom, beam, field);
            shape_beam(light, node, type, beam, field);
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
            remark(light, "SCN0201", fmt::format("it zooms to {}° at the most", rounded(wanted)));
        }
        field = beam > 0.0 ? std::min(field * wanted / beam, 180.0) : wanted;
        beam = wanted;
        remark(light, "SCN0201", "a zoom keeps the flux and scales both angles");
    }

    void shape_beam(FoundLight& light, pugi::xml_node node, const std::string& type, double beam, double field) {
        if (!(beam > 0.0) || !(field > 0.0) || !(field < 180.0) || !(beam < 180.0))
            return only_list(light, fmt::format("its angles are outside what a beam has: {}° and {}°", rounded(beam),
                                                rounded(field)));
        if (type == "Rectangle") {
            double ratio = parse_number(node.attribute("RectangleRatio").value()).value_or(1.7777);
            if (!(ratio > 1e-3 && ratio < 1e3)) ratio = 1.7777;
            const double half = 0.5 * beam * std::numbers::pi / 180.0;
            light.shape = FrustumShape{degrees(beam), Radians(2.0 * std::atan(std::tan(half) / ratio)), {}, {}};
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
        std::string maker = scene_.generator.substr(0, 60);
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
    pugi::xml_node geometries_;
    std::map<std::string_view, pugi::xml_node> by_name_; // geometries that are in no other
    std::map<std::string, Zoom, std::less<>> zooms_;     // by geometry
    std::map<std::pair<double, double>, std::size_t> profiles_;
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
