// TM-33: the document as it was read, updated with the values of the fields.
#include <gonio/base/text.hpp>
#include <gonio/profile/detail/tm33_fields.hpp>
#include <gonio/profile/detail/tm33_table.hpp>
#include <gonio/profile/number_text.hpp>
#include <gonio/profile/parse.hpp>
#include <gonio/profile/text_encoding.hpp>
#include <gonio/profile/write.hpp>

#include <algorithm>
#include <span>

namespace gonio {

namespace {

using namespace profile_detail;

// The schema's order of the elements that gonio may have to create, parents before others of the same name.
constexpr std::array root_order{std::string_view("Version"),   std::string_view("Header"),
                                std::string_view("Luminaire"), std::string_view("Equipment"),
                                std::string_view("Emitter"),   std::string_view("CustomData")};
constexpr std::array luminaire_order{std::string_view("Dimensions"), std::string_view("Shape"),
                                     std::string_view("NumEmitter")};
constexpr std::array dimensions_order{std::string_view("Length"), std::string_view("Width"),
                                      std::string_view("Height")};
constexpr std::array emitter_order{std::string_view("ID"),
                                   std::string_view("Quantity"),
                                   std::string_view("Description"),
                                   std::string_view("CatalogNumber"),
                                   std::string_view("RatedLumens"),
                                   std::string_view("InputWattage"),
                                   std::string_view("PowerFactor"),
                                   std::string_view("BallastFactor"),
                                   std::string_view("TiltAngles"),
                                   std::string_view("ColorTemperature"),
                                   std::string_view("ColorRendering"),
                                   std::string_view("Duv"),
                                   std::string_view("SPRatio"),
                                   std::string_view("DataGeneration"),
                                   std::string_view("LuminousData"),
                                   std::string_view("RadiantData"),
                                   std::string_view("PhotonData"),
                                   std::string_view("SpectralData"),
                                   std::string_view("AngularColor"),
                                   std::string_view("IllumData"),
                                   std::string_view("IrradData"),
                                   std::string_view("PFDData"),
                                   std::string_view("SpecIrradData"),
                                   std::string_view("Channels"),
                                   std::string_view("EmissionAreas"),
                                   std::string_view("EmitterCenter"),
                                   std::string_view("Regulatory")};
constexpr std::array color_temperature_order{std::string_view("FixedCCT"), std::string_view("MinCCT"),
                                             std::string_view("MaxCCT")};
constexpr std::array color_rendering_order{std::string_view("CIE_CRI"), std::string_view("IES_TM30")};
constexpr std::array luminous_order{std::string_view("LuminousIntensity"), std::string_view("LuminousFlux")};
constexpr std::array intensity_order{std::string_view("AbsolutePhotometry"),
                                     std::string_view("Symm"),
                                     std::string_view("Multiplier"),
                                     std::string_view("NumberMeasured"),
                                     std::string_view("NumberHorz"),
                                     std::string_view("NumberVert"),
                                     std::string_view("IntData"),
                                     std::string_view("IntensityData")};
constexpr std::array spectrum_order{std::string_view("EmitterName"), std::string_view("NumberWavelength"),
                                    std::string_view("Multiplier"),  std::string_view("Normalized"),
                                    std::string_view("Timestamp"),   std::string_view("PwrData"),
                                    std::string_view("Quantum")};
constexpr std::array areas_order{std::string_view("TopFace"), std::string_view("BottomFace")};

std::span<const std::string_view> order_within(std::string_view parent) {
    if (parent == "Luminaire") return luminaire_order;
    if (parent == "Dimensions") return dimensions_order;
    if (parent == "Emitter") return emitter_order;
    if (parent == "ColorTemperature") return color_temperature_order;
    if (parent == "ColorRendering") return color_rendering_order;
    if (parent == "LuminousData") return luminous_order;
    if (parent == "LuminousIntensity" || parent == "IntensityDistribution") return intensity_order;
    if (parent == "EmitterSpectral") return spectrum_order;
    if (parent == "EmissionAreas") return areas_order;
    if (is_tm33_root(parent)) return root_order;
    return {};
}

std::size_t rank(std::span<const std::string_view> order, std::string_view name) {
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), name) - order.begin());
}

// A new element at the schema's place among its parent's children: before the first one that the schema places after
// it.
pugi::xml_node make_child(pugi::xml_node parent, std::string_view name) {
    const std::span<const std::string_view> order = order_within(local_name(parent.name()));
    const std::size_t own = rank(order, name);
    const std::string_view parent_name = parent.name();
    const std::size_t colon = parent_name.rfind(':');
    const std::string full =
        std::string(colon == std::string_view::npos ? std::string_view() : parent_name.substr(0, colon + 1)) +
        std::string(name);
    pugi::xml_node made;
    for (const pugi::xml_node child : parent.children()) {
        if (child.type() != pugi::node_element) continue;
        const std::size_t other = rank(order, local_name(child.name()));
        if (other <= own || other == order.size()) continue;
        made = parent.insert_child_before(pugi::node_element, child);
        break;
    }
    if (!made) made = parent.append_child(pugi::node_element);
    made.set_name(full.c_str());
    return made;
}

pugi::xml_node child_or_made(pugi::xml_node parent, std::string_view name) {
    const pugi::xml_node found = child_named(parent, name);
    return found ? found : make_child(parent, name);
}

pugi::xml_node path_or_made(pugi::xml_node parent, std::string_view path) {
    for (;;) {
        const std::size_t slash = path.find('/');
        parent = child_or_made(parent, path.substr(0, slash));
        if (slash == std::string_view::npos) return parent;
        path.remove_prefix(slash + 1);
    }
}

std::string number_text(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

// Replaces the text of an element; its attributes stay.
void set_text(pugi::xml_node element, const std::string& text) {
    element.remove_children();
    element.append_child(pugi::node_pcdata).set_value(text.c_str());
}

void put_number(pugi::xml_node owner, std::span<const std::string_view> paths, const std::optional<double>& value) {
    pugi::xml_node element = first_of(owner, paths);
    const std::optional<double> written = element ? plain_number(element.child_value()) : std::nullopt;
    if (written == value) return; // also if text that is not a number was ignored
    if (!value) {
        element.parent().remove_child(element);
        return;
    }
    if (!element) element = path_or_made(owner, paths.front());
    set_text(element, number_text(*value));
}

void put_text(pugi::xml_node owner, std::span<const std::string_view> paths, const std::string& text) {
    pugi::xml_node element = first_of(owner, paths);
    if (element ? trimmed(element.child_value()) == text : text.empty()) return;
    if (!element) element = path_or_made(owner, paths.front());
    set_text(element, to_utf8(text));
}

void put_truth(pugi::xml_node owner, std::string_view name, const std::optional<bool>& value) {
    pugi::xml_node element = child_named(owner, name);
    const std::optional<bool> written = element ? truth_of(element.child_value()) : std::nullopt;
    if (written == value) return;
    if (!value) {
        owner.remove_child(element);
        return;
    }
    if (!element) element = make_child(owner, name);
    set_text(element, *value ? "true" : "false");
}

bool has_elements(pugi::xml_node node) {
    for (const pugi::xml_node child : node.children())
        if (child.type() == pugi::node_element) return true;
    return false;
}

void put_header(pugi::xml_node root, const std::vector<Tm33Text>& header) {
    pugi::xml_node element = child_named(root, "Header");
    std::vector<pugi::xml_node> leaves;
    std::vector<Tm33Text> written;
    for (const pugi::xml_node child : element.children()) {
        if (child.type() != pugi::node_element || has_elements(child)) continue;
        leaves.push_back(child);
        written.push_back({std::string(local_name(child.name())), std::string(trimmed(child.child_value()))});
    }
    if (written == header) return;
    if (!element) element = make_child(root, "Header");
    for (std::size_t i = 0; i < header.size(); ++i) {
        // An element with the same text at the same place keeps its attributes.
        if (i < written.size() && written[i] == header[i]) continue;
        if (i < written.size() && written[i].name == header[i].name) {
            set_text(leaves[i], to_utf8(header[i].text));
            continue;
        }
        for (std::size_t k = i; k < leaves.size(); ++k)
            element.remove_child(leaves[k]);
        leaves.resize(std::min(i, leaves.size()));
        written.resize(leaves.size());
        const pugi::xml_node made = element.append_child(header[i].name.c_str());
        set_text(made, to_utf8(header[i].text));
    }
    for (std::size_t k = header.size(); k < leaves.size(); ++k)
        element.remove_child(leaves[k]);
}

void put_tilt(pugi::xml_node emitter, const IesTilt& tilt) {
    pugi::xml_node element = child_named(emitter, "TiltAngles");
    IesTilt written;
    for (const pugi::xml_node child : element.children()) {
        if (local_name(child.name()) != "Tilt") continue;
        const std::optional<double> angle = plain_number(child.attribute("angle").value());
        const std::optional<double> factor = plain_number(child.child_value());
        if (!angle || !factor || (!written.angles_deg.empty() && *angle <= written.angles_deg.back())) continue;
        written.angles_deg.push_back(*angle);
        written.factors.push_back(*factor);
    }
    if (written.angles_deg == tilt.angles_deg && written.factors == tilt.factors) return;
    if (element) emitter.remove_child(element);
    if (tilt.angles_deg.empty()) return;
    element = make_child(emitter, "TiltAngles");
    set_text(make_child(element, "NumberAngles"), number_text(static_cast<double>(tilt.angles_deg.size())));
    for (std::size_t i = 0; i < tilt.angles_deg.size(); ++i) {
        pugi::xml_node made = make_child(element, "Tilt");
        made.append_attribute("angle").set_value(number_text(tilt.angles_deg[i]).c_str());
        set_text(made, number_text(tilt.factors[i]));
    }
}

void put_areas(pugi::xml_node emitter, const std::vector<Tm33Area>& areas) {
    std::vector<Tm33Area> written;
    for (const pugi::xml_node area : element_at(emitter, "EmissionAreas/BottomFace").children())
        if (local_name(area.name()) == "BottomArea") {
            const auto number = [&](const char* name) {
                return plain_number(child_named(area, name).child_value()).value_or(0.0);
            };
            written.push_back({number("Length"), number("Width"),
                               truth_of(child_named(area, "Circular").child_value()).value_or(false)});
        }
    if (written == areas) return;
    if (pugi::xml_node old = element_at(emitter, "EmissionAreas/BottomFace")) old.parent().remove_child(old);
    if (areas.empty()) return;
    const pugi::xml_node face = path_or_made(emitter, "EmissionAreas/BottomFace");
    set_text(make_child(face, "NumberBottom"), number_text(static_cast<double>(areas.size())));
    for (const Tm33Area& area : areas) {
        const pugi::xml_node made = make_child(face, "BottomArea");
        set_text(make_child(made, "Length"), number_text(area.length_m));
        set_text(make_child(made, "Width"), number_text(area.width_m));
        set_text(make_child(made, "LengthOffset"), "0");
        set_text(make_child(made, "WidthOffset"), "0");
        if (area.circular) set_text(make_child(made, "Circular"), "true");
    }
}

// The element that marks the place of the table's points, with other marks removed; created if there is none.
pugi::xml_node mark_of(pugi::xml_node parent, bool (*is_point)(pugi::xml_node), std::string_view name) {
    pugi::xml_node mark;
    for (pugi::xml_node node = parent.first_child(); node;) {
        const pugi::xml_node next = node.next_sibling();
        if (is_point(node) || local_name(node.name()) == name) {
            if (mark)
                parent.remove_child(node);
            else
                mark = node;
        }
        node = next;
    }
    return mark ? mark : make_child(parent, name);
}

void put_intensity(pugi::xml_node emitter, const Tm33Intensity& intensity) {
    pugi::xml_node element = intensity_element(emitter);
    if (!element) element = path_or_made(emitter, "LuminousData/LuminousIntensity");
    put_truth(element, "AbsolutePhotometry", intensity.absolute);
    put_text(element, Paths{"PhotometryType"}, intensity.photometry_type);
    const Paths symmetry_paths{"Symm", "SymmType"};
    const pugi::xml_node symmetry = first_of(element, symmetry_paths);
    if (intensity.symmetry && (!symmetry || symmetry_named(symmetry.child_value()) != intensity.symmetry))
        set_text(symmetry ? symmetry : make_child(element, "Symm"), name_of(*intensity.symmetry));
    put_number(element, Paths{"Multiplier"}, intensity.multiplier);
    const PointTable old = read_points(element);
    if (old.problem == PointTable::Problem::none && old.values == intensity.candela &&
        old.horizontal_deg == intensity.horizontal_deg && old.vertical_deg == intensity.vertical_deg)
        return; // points with more than their numbers stayed in the document

    // Counts are created with a new table, and corrected in a table that has them.
    const bool new_table = !child_named(element, "IntData") && !child_named(element, "IntensityData");
    for (const auto& [name, count] : {std::pair{"NumberMeasured", intensity.candela.size()},
                                      std::pair{"NumberHorz", intensity.horizontal_deg.size()},
                                      std::pair{"NumberVert", intensity.vertical_deg.size()}})
        if (new_table || child_named(element, name)) put_number(element, Paths{name}, static_cast<double>(count));
    pugi::xml_node mark = mark_of(element, is_intensity_point, "IntData");
    const std::string name = mark.name();
    const bool short_names = local_name(name.c_str()) == "IntData";
    const std::size_t rows = intensity.vertical_deg.size();
    for (std::size_t p = 0; p < intensity.horizontal_deg.size(); ++p)
        for (std::size_t g = 0; g < rows; ++g) {
            pugi::xml_node point = element.insert_child_before(name.c_str(), mark);
            point.append_attribute(short_names ? "h" : "horz")
                .set_value(number_text(intensity.horizontal_deg[p]).c_str());
            point.append_attribute(short_names ? "v" : "vert")
                .set_value(number_text(intensity.vertical_deg[g]).c_str());
            point.append_child(pugi::node_pcdata).set_value(number_text(intensity.candela[p * rows + g]).c_str());
        }
    element.remove_child(mark);
}

std::string list_text(const std::vector<double>& numbers) {
    std::string text;
    NumberText shortest;
    for (const double number : numbers) {
        if (!text.empty()) text += ' ';
        shortest.append(text, number);
    }
    return text;
}

void put_spectrum(pugi::xml_node element, const Tm33Spectrum& spectrum) {
    put_text(element, Paths{"EmitterName"}, spectrum.emitter_name);
    put_number(element, Paths{"Multiplier"}, spectrum.multiplier);
    put_truth(element, "Normalized", spectrum.normalized);
    const pugi::xml_node wavelengths = child_named(element, "Wavelengths");
    const pugi::xml_node values = child_named(element, "Values");
    if (wavelengths && values) {
        set_text(wavelengths, list_text(spectrum.wavelengths_nm));
        set_text(values, list_text(spectrum.power));
        return;
    }
    std::vector<double> old_nm;
    std::vector<double> old_power;
    for (const pugi::xml_node point : element.children())
        if (is_spectrum_point(point)) {
            old_nm.push_back(plain_number(point.attribute("w").value()).value_or(0.0));
            old_power.push_back(plain_number(point.child_value()).value_or(0.0));
        }
    if (old_nm == spectrum.wavelengths_nm && old_power == spectrum.power) return;
    const bool list_of_points = local_name(element.name()) == "SpectralDistribution";
    const std::string_view point_name = list_of_points ? "SpectralData" : "PwrData";
    if (!child_named(element, point_name) || child_named(element, "NumberWavelength"))
        put_number(element, Paths{"NumberWavelength"}, static_cast<double>(spectrum.power.size()));
    pugi::xml_node mark = mark_of(element, is_spectrum_point, point_name);
    const std::string name = mark.name();
    for (std::size_t i = 0; i < spectrum.power.size(); ++i) {
        pugi::xml_node point = element.insert_child_before(name.c_str(), mark);
        point.append_attribute("w").set_value(number_text(spectrum.wavelengths_nm[i]).c_str());
        point.append_child(pugi::node_pcdata).set_value(number_text(spectrum.power[i]).c_str());
    }
    element.remove_child(mark);
}

void put_emitter(pugi::xml_node element, const Tm33Emitter& emitter) {
    for (const auto& [paths, member] : emitter_numbers)
        put_number(element, paths, emitter.*member);
    for (const auto& [paths, member] : emitter_texts)
        put_text(element, paths, emitter.*member);
    put_tilt(element, emitter.tilt);
    put_areas(element, emitter.bottom_areas);
    if (emitter.intensity) {
        put_intensity(element, *emitter.intensity);
    } else if (pugi::xml_node old = intensity_element(element)) {
        const bool had_points = child_named(old, "IntData") || child_named(old, "IntensityData");
        if (had_points) old.parent().remove_child(old);
    }
    std::vector<pugi::xml_node> spectra = spectrum_elements(element);
    for (std::size_t i = 0; i < emitter.spectra.size(); ++i) {
        if (i == spectra.size())
            spectra.push_back(make_child(child_or_made(element, "SpectralData"), "EmitterSpectral"));
        put_spectrum(spectra[i], emitter.spectra[i]);
    }
    for (std::size_t i = emitter.spectra.size(); i < spectra.size(); ++i)
        spectra[i].parent().remove_child(spectra[i]);
}

struct StringWriter final : pugi::xml_writer {
    std::string text;
    void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

} // namespace

std::string write_tm33(const Tm33File& file) {
    pugi::xml_document document;
    constexpr unsigned how = pugi::parse_default | pugi::parse_comments | pugi::parse_pi | pugi::parse_ws_pcdata_single;
    if (!file.document.empty())
        document.load_buffer(file.document.data(), file.document.size(), how, pugi::encoding_utf8);
    pugi::xml_node root = document.document_element();
    if (!root) root = document.append_child(file.root.c_str());
    if (local_name(root.name()) != file.root) root.set_name(file.root.c_str());
    if (root.attribute("version") && !child_named(root, "Version"))
        root.attribute("version").set_value(file.version.c_str());
    else
        put_text(root, Paths{"Version"}, file.version);
    put_header(root, file.header);
    for (const auto& [paths, member] : luminaire_numbers)
        put_number(root, paths, file.*member);
    put_text(root, goniometer_paths, file.goniometer);
    std::vector<pugi::xml_node> emitters;
    for (const pugi::xml_node child : root.children())
        if (child.type() == pugi::node_element && local_name(child.name()) == "Emitter") emitters.push_back(child);
    for (std::size_t i = 0; i < file.emitters.size(); ++i) {
        if (i == emitters.size()) emitters.push_back(make_child(root, "Emitter"));
        put_emitter(emitters[i], file.emitters[i]);
    }
    for (std::size_t i = file.emitters.size(); i < emitters.size(); ++i)
        root.remove_child(emitters[i]);

    pugi::xml_node declaration = document.prepend_child(pugi::node_declaration);
    declaration.append_attribute("version").set_value("1.0");
    declaration.append_attribute("encoding").set_value("UTF-8");
    StringWriter writer;
    document.save(writer, "  ", pugi::format_indent, pugi::encoding_utf8);
    return std::move(writer.text);
}

} // namespace gonio
