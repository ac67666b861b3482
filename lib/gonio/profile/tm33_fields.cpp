#include <gonio/base/text.hpp>
#include <gonio/profile/detail/tm33_fields.hpp>
#include <gonio/profile/scanner.hpp>

#include <algorithm>
#include <utility>

namespace gonio {

const char* edition(const Tm33File& file) {
    return file.root == "IESTM33-22" ? "TM-33-23" : "TM-33-18";
}

namespace profile_detail {

namespace {

constexpr std::array<std::pair<Tm33Symmetry, const char*>, 6> symmetries{{{Tm33Symmetry::none, "Symm_None"},
                                                                          {Tm33Symmetry::bilateral_0, "Symm_Bi_0"},
                                                                          {Tm33Symmetry::bilateral_90, "Symm_Bi_90"},
                                                                          {Tm33Symmetry::quadrant, "Symm_Quad"},
                                                                          {Tm33Symmetry::full, "Symm_Full"},
                                                                          {Tm33Symmetry::arbitrary, "Symm_Arbitrary"}}};

// The text without blanks and in capitals.
std::string canonical(std::string_view text) {
    std::string result;
    for (const char c : text)
        if (!is_blank(c) && c != '\n' && c != '\r') result += to_upper(c);
    return result;
}

bool has_points(pugi::xml_node node) {
    for (const pugi::xml_node child : node.children())
        if (is_intensity_point(child)) return true;
    return false;
}

} // namespace

std::string_view local_name(const char* name) {
    const std::string_view text = name;
    const std::size_t colon = text.rfind(':');
    return colon == std::string_view::npos ? text : text.substr(colon + 1);
}

pugi::xml_node child_named(pugi::xml_node parent, std::string_view name) {
    for (const pugi::xml_node child : parent.children())
        if (child.type() == pugi::node_element && local_name(child.name()) == name) return child;
    return {};
}

pugi::xml_node element_at(pugi::xml_node parent, std::string_view path) {
    while (parent) {
        const std::size_t slash = path.find('/');
        parent = child_named(parent, path.substr(0, slash));
        if (slash == std::string_view::npos) break;
        path.remove_prefix(slash + 1);
    }
    return parent;
}

pugi::xml_node first_of(pugi::xml_node parent, std::span<const std::string_view> paths) {
    for (const std::string_view path : paths) {
        if (path.empty()) continue;
        if (const pugi::xml_node found = element_at(parent, path)) return found;
    }
    return {};
}

pugi::xml_node intensity_element(pugi::xml_node emitter) {
    if (const pugi::xml_node node = element_at(emitter, "LuminousData/LuminousIntensity")) return node;
    for (const std::string_view name : {"LuminousData", "IntensityDistribution"})
        for (const pugi::xml_node node : emitter.children()) {
            if (node.type() != pugi::node_element || local_name(node.name()) != name || !has_points(node)) continue;
            const pugi::xml_node metric = child_named(node, "Metric");
            if (!metric || canonical(metric.child_value()) == "LUMINOUS") return node;
        }
    return {};
}

bool is_intensity_point(pugi::xml_node node) {
    const std::string_view name = local_name(node.name());
    return name == "IntData" || name == "IntensityData";
}

pugi::xml_attribute horizontal_of(pugi::xml_node point) {
    for (const char* const name : {"h", "horz", "horizontal"})
        if (const pugi::xml_attribute found = point.attribute(name)) return found;
    return {};
}

pugi::xml_attribute vertical_of(pugi::xml_node point) {
    for (const char* const name : {"v", "vert", "vertical"})
        if (const pugi::xml_attribute found = point.attribute(name)) return found;
    return {};
}

std::vector<pugi::xml_node> spectrum_elements(pugi::xml_node emitter) {
    std::vector<pugi::xml_node> found;
    for (const pugi::xml_node child : emitter.children()) {
        const std::string_view name = local_name(child.name());
        if (name == "SpectralDistribution") found.push_back(child);
        if (name != "SpectralData") continue;
        for (const pugi::xml_node spectrum : child.children())
            if (local_name(spectrum.name()) == "EmitterSpectral") found.push_back(spectrum);
    }
    return found;
}

bool is_spectrum_point(pugi::xml_node node) {
    const std::string_view name = local_name(node.name());
    return (name == "PwrData" || name == "SpectralData") && node.attribute("w");
}

std::optional<Tm33Symmetry> symmetry_named(std::string_view text) {
    const std::string word = canonical(text);
    for (const auto& [symmetry, name] : symmetries)
        if (word == canonical(name)) return symmetry;
    return std::nullopt;
}

const char* name_of(Tm33Symmetry symmetry) {
    for (const auto& [known, name] : symmetries)
        if (known == symmetry) return name;
    return "Symm_None";
}

std::optional<bool> truth_of(std::string_view text) {
    const std::string word = canonical(text);
    if (word == "TRUE" || word == "1") return true;
    if (word == "FALSE" || word == "0") return false;
    return std::nullopt;
}

std::optional<double> plain_number(std::string_view text) {
    const auto is_space = [](char c) { return is_blank(c) || c == '\n' || c == '\r'; };
    while (!text.empty() && is_space(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_space(text.back()))
        text.remove_suffix(1);
    double value = 0.0;
    bool plain = true;
    if (scan_number(text, value, plain) != Token::number) return std::nullopt;
    return value;
}

} // namespace profile_detail

} // namespace gonio
